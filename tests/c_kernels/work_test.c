/* work_test.c -- the scratch relation against plain integer arithmetic on
 * small grids, where everything touches everything.
 */
#include "../../c_kernels/triangulate.h"
#include "../../c_kernels/work_private.h"
#include "../check.h"

#include <stdlib.h>
#include <string.h>

static uint64_t seed = 88;

static int
pick(int n)
{
  seed ^= seed << 13;
  seed ^= seed >> 7;
  seed ^= seed << 17;
  return (int)((seed * 0x2545F4914F6CDD1Du >> 33) % (uint64_t)n);
}

/* ---- the reference, in integers ----------------------------------------- */

typedef struct place {
  long x, y;
} place;

static long
turn(place a, place b, place c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

static bool
same(place a, place b)
{
  return a.x == b.x && a.y == b.y;
}

/* Where p lies in a-b, scaled by the squared length; inside if 0 < it < l. */
static bool
strictly_inside(place a, place b, place p)
{
  long l = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
  long t = (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y);

  return turn(a, b, p) == 0 && t > 0 && t < l;
}

/* Does segment x-y meet the closed triangle in more than its corners? By
 * clipping: t = low..high of x + t (y - x), as fractions. */
static bool
meets_beyond_corners(place x, place y, const place corner[3])
{
  long low_n = 0, low_d = 1, high_n = 1, high_d = 1;

  for (int i = 0; i < 3; i++) {
    long at_x = turn(corner[i], corner[(i + 1) % 3], x);
    long at_y = turn(corner[i], corner[(i + 1) % 3], y);
    if (at_x < 0 && at_y < 0) {
      return false;
    }
    if (at_x < 0) { /* t >= at_x / (at_x - at_y) */
      long n = -at_x, d = at_y - at_x;
      if (n * low_d > low_n * d) {
        low_n = n, low_d = d;
      }
    } else if (at_y < 0) {
      long n = at_x, d = at_x - at_y;
      if (n * high_d < high_n * d) {
        high_n = n, high_d = d;
      }
    }
  }
  if (low_n * high_d > high_n * low_d) {
    return false;
  }
  if (low_n * high_d < high_n * low_d) {
    return true;
  }
  for (int i = 0; i < 3; i++) { /* one point: a corner? */
    if (corner[i].x * low_d == x.x * low_d + low_n * (y.x - x.x) &&
        corner[i].y * low_d == x.y * low_d + low_n * (y.y - x.y)) {
      return false;
    }
  }
  return true;
}

/* ---- a random work ------------------------------------------------------ */

enum { MOST = 200 };

typedef struct scene {
  sg_work *work;
  place at[MOST];
  int n;
} scene;

/* The picture's (x, y) put into space as seen along +-axis; `lift` bends it
 * out of the plane, which must not matter. */
static void
to_space(int axis, bool flip, place at, double out[3])
{
  out[axis] = (double)pick(3);
  out[(axis + 1) % 3] = (double)(flip ? at.y : at.x);
  out[(axis + 2) % 3] = (double)(flip ? at.x : at.y);
}

static void
open_scene(scene *s, int vertices, int grid, int edges)
{
  int axis = pick(3);
  bool flip = pick(2);
  double normal[3] = {0.25, 0.25, 0.25}, p[3];

  normal[axis] = flip ? -2 : 2;
  s->work = sg_work_open(normal);
  s->n = vertices;
  for (int i = 0; i < vertices; i++) {
    sg_point point;
    bool fresh;
    do { /* no two in one place */
      s->at[i] = (place){pick(grid), pick(grid)};
      fresh = true;
      for (int j = 0; j < i; j++) {
        fresh = fresh && !same(s->at[i], s->at[j]);
      }
    } while (!fresh);
    to_space(axis, flip, s->at[i], p);
    sg_point_set(&point, p);
    sg_work_vertex(s->work, 100 + i, &point);
  }
  for (int i = 0; i < edges; i++) {
    int a = pick(vertices), b = pick(vertices);
    if (a != b) {
      sg_work_add(s->work, a, b, 1, i + 1);
    }
  }
}

/* ---- the tests ---------------------------------------------------------- */

static void
test_lists(void)
{
  scene s;
  int32_t e[4];

  open_scene(&s, 4, 9, 0);
  CHECK("an id is found", sg_work_find(s.work, 102) == 2);
  CHECK("an id is not found", sg_work_find(s.work, 99) == SG_WORK_NONE);
  CHECK("a handle has its id", sg_work_id(s.work, 3) == 103);
  for (int i = 0; i < 4; i++) {
    e[i] = sg_work_add(s.work, i, (i + 1) % 4, 1, 7);
  }
  CHECK("oldest first", sg_work_next(s.work, 0) == e[0]);
  CHECK("then the next", sg_work_next(s.work, e[0]) == e[1]);
  CHECK("a pair", sg_work_pair(s.work, 2, 3) == e[2]);
  CHECK("no pair", sg_work_pair(s.work, 3, 2) == 0);
  CHECK("in balance", sg_work_unbalanced(s.work) == SG_WORK_NONE);
  int32_t piece = sg_work_split(s.work, e[1], 3);
  CHECK("pieces keep the label", sg_work_get(s.work, piece)->label == 7);
  CHECK("the second piece", sg_work_get(s.work, piece + 1)->start == 3);
  CHECK("the old edge is gone", sg_work_get(s.work, e[1]) == NULL);
  CHECK("five edges", sg_work_edges(s.work) == 5);
  sg_work_delete(s.work, e[0]);
  CHECK("out of balance", sg_work_unbalanced(s.work) != SG_WORK_NONE);
  CHECK("valid", sg_work_is_valid(s.work));
  sg_work_close(s.work);
}

static void
test_hash(void)
{
  scene s;
  bool found = true;
  sg_point p;

  open_scene(&s, 0, 1, 0);
  sg_point_set(&p, (const double[3]){0, 0, 0});
  for (int32_t i = 0; i < 5000; i++) {
    sg_work_vertex(s.work, i * 4096 + 1, &p);
  }
  for (int32_t i = 0; i < 5000; i++) {
    found = found && sg_work_find(s.work, i * 4096 + 1) == i;
  }
  CHECK("ids far apart", found);
  sg_work_close(s.work);
}

static void
expected_meeting(const scene *s, int v1, int v2, const sg_work_edge *edge,
                 bool *meets, sg_meeting *out)
{
  place a = s->at[v1], b = s->at[v2], c = s->at[edge->start],
        d = s->at[edge->end];
  long ca = turn(c, d, a), cb = turn(c, d, b), ac = turn(a, b, c),
       ad = turn(a, b, d);

  *out = (sg_meeting){.how = SG_TOUCHES};
  if (((ca > 0 && cb < 0) || (ca < 0 && cb > 0)) &&
      ((ac > 0 && ad < 0) || (ac < 0 && ad > 0))) {
    out->how = SG_CROSSES;
    *meets = true;
    return;
  }
  out->inside = (strictly_inside(c, d, a) ? SG_V1_INSIDE : 0u) |
                (strictly_inside(c, d, b) ? SG_V2_INSIDE : 0u) |
                (strictly_inside(a, b, c) ? SG_START_INSIDE : 0u) |
                (strictly_inside(a, b, d) ? SG_END_INSIDE : 0u);
  *meets = out->inside != 0;
  if (ac == 0 && ad == 0) {
    bool in1 = out->inside & SG_V1_INSIDE || same(a, c) || same(a, d);
    bool in2 = out->inside & SG_V2_INSIDE || same(b, c) || same(b, d);
    out->how = in1 && in2 ? SG_CONTAINED : SG_OVERLAPS;
    *meets = *meets || (in1 && in2);
  }
}

static void
test_meeting(int vertices, int grid, int edges, int rounds)
{
  unsigned bad = 0, met = 0;

  for (int round = 0; round < rounds; round++) {
    scene s;
    sg_meetings out = {0};
    open_scene(&s, vertices, grid, edges);
    for (int k = 0; k < 20; k++) {
      int v1 = pick(vertices), v2 = pick(vertices);
      size_t i = 0;
      if (v1 == v2) {
        continue;
      }
      sg_work_meeting(s.work, v1, v2, &out);
      for (int32_t e = 0; (e = sg_work_next(s.work, e)) != 0;) {
        bool meets;
        sg_meeting want;
        expected_meeting(&s, v1, v2, sg_work_get(s.work, e), &meets, &want);
        if (meets) {
          bad += i >= out.n || out.item[i].edge != e ||
                 out.item[i].how != want.how ||
                 out.item[i].inside != want.inside;
          i++;
          met++;
        }
      }
      bad += i != out.n;
      if (k % 5 == 4 && sg_work_edges(s.work)) { /* and after changes */
        sg_work_delete(s.work, sg_work_next(s.work, 0));
        sg_work_add(s.work, v1, v2, 1, 0);
      }
    }
    bad += !sg_work_is_valid(s.work);
    sg_meetings_clear(&out);
    sg_work_close(s.work);
  }
  CHECK("meetings are those of integer arithmetic", bad == 0);
  CHECK("there were meetings", met > 100);
}

/* Is v3 a third vertex of v1 -> v2, by definition? */
static bool
expected_candidate(const scene *s, int v1, int v2, int v3)
{
  place corner[3] = {s->at[v1], s->at[v2], s->at[v3]};

  if (v3 == v1 || v3 == v2 || turn(corner[0], corner[1], corner[2]) <= 0) {
    return false;
  }
  for (int32_t e = 0; (e = sg_work_next(s->work, e)) != 0;) {
    const sg_work_edge *edge = sg_work_get(s->work, e);
    bool start = edge->start == v1 || edge->start == v2 || edge->start == v3;
    bool end = edge->end == v1 || edge->end == v2 || edge->end == v3;
    if (start && end) {
      continue; /* along a side */
    }
    if (meets_beyond_corners(s->at[edge->start], s->at[edge->end], corner)) {
      return false;
    }
    for (int i = 0; i < 3; i++) { /* unresolved: a corner inside the edge */
      if (strictly_inside(s->at[edge->start], s->at[edge->end], corner[i])) {
        return false;
      }
    }
  }
  return true;
}

static bool
has_edge(const scene *s, int32_t v)
{
  return sg_work_leaving(s->work, v, 0) || sg_work_entering(s->work, v, 0);
}

/* How often the candidates of v1 -> v2 are not those of the definition, in the
 * paper's order; adds to *many how many there were. */
static unsigned
wrong_candidates(const scene *s, int v1, int v2, unsigned *many)
{
  int v3, order = 0, before = 0;
  bool seen[MOST] = {false};
  unsigned bad = 0;
  sg_candidates walk;

  sg_candidates_open(&walk, s->work, v1, v2);
  while ((v3 = sg_candidates_next(&walk)) >= 0) {
    int class = sg_work_pair(s->work, v2, v3)   ? 0
                : sg_work_pair(s->work, v3, v1) ? 1
                                                : 2;
    bad += seen[v3];
    order += class < before;
    before = class;
    seen[v3] = true;
    ++*many;
  }
  sg_candidates_close(&walk);
  for (int v = 0; v < s->n; v++) {
    bad += seen[v] != (has_edge(s, v) && expected_candidate(s, v1, v2, v));
  }
  return bad + (order != 0);
}

static void
test_candidates(int vertices, int grid, int edges, int rounds)
{
  unsigned bad = 0, many = 0;

  for (int round = 0; round < rounds; round++) {
    scene s;
    open_scene(&s, vertices, grid, edges);
    for (int k = 0; k < 10; k++) {
      const sg_work_edge *edge =
          sg_work_get(s.work, 1 + pick((int)sg_work_edges(s.work)));
      bad += wrong_candidates(&s, edge->start, edge->end, &many);
    }
    sg_work_close(s.work);
  }
  CHECK("candidates are those of the definition", bad == 0);
  CHECK("there were candidates", many > 20);
}

/* ---- simple relations ---------------------------------------------------- */

/* Does v1 -> v2 meet an edge other than in a shared end or as its opposite? */
static bool
in_the_way(const scene *s, int v1, int v2)
{
  for (int32_t e = 0; (e = sg_work_next(s->work, e)) != 0;) {
    const sg_work_edge *edge = sg_work_get(s->work, e);
    sg_meeting want;
    bool meets;
    expected_meeting(s, v1, v2, edge, &meets, &want);
    if (meets && !(edge->start == v2 && edge->end == v1)) {
      return true;
    }
  }
  return false;
}

static bool
near_each_other(const scene *s, int a, int b, int near)
{
  return labs(s->at[a].x - s->at[b].x) <= near &&
         labs(s->at[a].y - s->at[b].y) <= near;
}

/* Tries to add `tries` edges between vertices near each other, leaving out
 * those that would meet others. */
static void
open_simple(scene *s, int vertices, int grid, int near, int tries)
{
  open_scene(s, vertices, grid, 0);
  for (int i = 0; i < tries; i++) {
    int a = pick(vertices), b = pick(vertices);
    if (a != b && near_each_other(s, a, b, near) && !in_the_way(s, a, b)) {
      sg_work_add(s->work, a, b, 1, 1);
      if (pick(3) == 0 && !in_the_way(s, b, a)) {
        sg_work_add(s->work, b, a, 1, 1);
      }
    }
  }
}

static void
test_simple(int vertices, int grid, int near, int tries)
{
  unsigned bad = 0, bad_now = 0, bad_candidates = 0, many = 0, met = 0, few = 0;

  for (int round = 0; round < 150; round++) {
    scene s;
    open_simple(&s, vertices, grid, near, tries);
    few += sg_work_edges(s.work) <= SG_WORK_FEW;
    bad += !sg_work_is_simple(s.work);
    for (int k = 0; k < 5; k++) {
      const sg_work_edge *edge =
          sg_work_get(s.work, 1 + pick((int)sg_work_edges(s.work)));
      bad_candidates += wrong_candidates(&s, edge->start, edge->end, &many);
    }
    int a, b;
    do {
      a = pick(vertices), b = pick(vertices);
    } while (a == b || !near_each_other(&s, a, b, near));
    bool meets = in_the_way(&s, a, b);
    sg_work_add(s.work, a, b, 1, 1);
    met += meets;
    bad_now += sg_work_is_simple(s.work) == meets;
    bad_candidates += wrong_candidates(&s, a, b, &many);
    sg_work_close(s.work);
  }
  CHECK("what is simple is known to be", bad == 0);
  CHECK("an edge more is noticed", bad_now == 0);
  CHECK("it was in the way, or was not", met > 3 && met < 147);
  CHECK("candidates are those of the definition", bad_candidates == 0);
  CHECK("there were many edges", few < 75 && many > 100);
}

/* A polygon of `n` corners: random order sorted round the middle, so that it
 * is star-shaped but as ragged as can be. */
static long
open_star(scene *s, int n, int holes)
{
  static const place ring[8] = {{5, 0},  {4, 3},   {0, 5},  {-3, 4},
                                {-5, 0}, {-4, -3}, {0, -5}, {3, -4}};
  double normal[3] = {0, 0, 1}, p[3] = {0};
  long doubled = 0;
  sg_point point;

  s->work = sg_work_open(normal);
  s->n = 0;
  for (int i = 0; i < n; i++) {
    long r = 10 + pick(30);
    s->at[s->n++] = (place){
        ring[i * 8 / n].x * r * n +
            (i % (n / 8 ? n / 8 : 1)) *
                (ring[(i * 8 / n + 1) % 8].x - ring[i * 8 / n].x) * r * 8,
        ring[i * 8 / n].y * r * n +
            (i % (n / 8 ? n / 8 : 1)) *
                (ring[(i * 8 / n + 1) % 8].y - ring[i * 8 / n].y) * r * 8};
  }
  for (int h = 0; h < holes; h++) { /* small squares round the middle */
    long x = 9 * (h % 2) + 1, y = 9 * (h / 2 % 2) + 1;
    place hole[4] = {{x, y}, {x, y + 5}, {x + 5, y + 5}, {x + 5, y}};
    memcpy(&s->at[s->n], hole, sizeof hole);
    s->n += 4;
  }
  for (int i = 0; i < s->n; i++) {
    p[0] = (double)s->at[i].x;
    p[1] = (double)s->at[i].y;
    sg_point_set(&point, p);
    sg_work_vertex(s->work, i + 1, &point);
  }
  for (int i = 0; i < s->n; i++) {
    int first = i < n ? 0 : i - (i - n) % 4, size = i < n ? n : 4;
    int j = first + (i - first + 1) % size;
    sg_work_add(s->work, i, j, 1, i + 1);
    doubled += s->at[i].x * s->at[j].y - s->at[i].y * s->at[j].x;
  }
  return doubled;
}

static void
test_triangulate(void)
{
  unsigned bad = 0;

  for (int round = 0; round < 400; round++) {
    scene s;
    sg_triangles out = {0};
    int32_t edge;
    int n = 8 * (1 + pick(6)), holes = pick(3);
    long doubled = open_star(&s, n, holes), sum = 0;
    sg_outcome outcome = sg_work_triangulate(s.work, &out, &edge, NULL);
    bad += outcome != SG_DONE || out.n != (size_t)(s.n + 2 * holes - 2);
    for (size_t i = 0; i < out.n; i++) {
      long area = turn(s.at[out.item[i].v[0]], s.at[out.item[i].v[1]],
                       s.at[out.item[i].v[2]]);
      bad += area <= 0;
      sum += area;
    }
    bad += sum != doubled;
    free(out.item);
    sg_work_close(s.work);
  }
  CHECK("stars with holes: areas and counts", bad == 0);
}

/* The candidates while triangles are taken off, one by one. */
static void
test_taking(void)
{
  unsigned bad = 0, many = 0, simple = 0, all = 0;

  for (int round = 0; round < 40; round++) {
    scene s;
    int32_t e;
    open_star(&s, 8 * (8 + pick(4)), pick(3));
    while ((e = sg_work_next(s.work, 0)) != 0) {
      const sg_work_edge edge = *sg_work_get(s.work, e);
      bad += wrong_candidates(&s, edge.start, edge.end, &many);
      sg_candidates walk;
      sg_candidates_open(&walk, s.work, edge.start, edge.end);
      int32_t v3 = sg_candidates_next(&walk);
      sg_candidates_close(&walk);
      if (v3 < 0 || sg_work_take(s.work, e, v3) != 1) {
        bad++;
        break;
      }
      all += sg_work_edges(s.work) > SG_WORK_FEW;
      simple +=
          sg_work_edges(s.work) > SG_WORK_FEW && s.work->simple == SG_SIMPLE;
    }
    sg_work_close(s.work);
  }
  CHECK("candidates while triangles are taken off", bad == 0);
  CHECK("it stays known to be simple", all > 100 && simple == all);
}

int
main(void)
{
  test_lists();
  test_hash();
  test_meeting(12, 5, 15, 300);
  test_meeting(60, 9, 150, 60);
  test_meeting(150, 40, 100, 60);
  test_candidates(9, 4, 6, 300);
  test_candidates(40, 12, 12, 200);
  test_candidates(120, 60, 60, 100);
  test_simple(70, 30, 12, 1500);
  test_simple(150, 40, 9, 1500);
  test_simple(90, 12, 5, 600);
  test_triangulate();
  test_taking();
  return check_report();
}
