/* work_test.c -- the scratch relation against plain integer arithmetic on
 * small grids, where everything touches everything.
 *
 * covers: work_grid
 */
#include "polygon/work_private.h"
#include "work_scene.h"

#include "work_valid.h"
#include <math.h>

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
  CHECK("valid", work_is_valid(s.work));
  sg_work_close(s.work);
}

/* The first vertex that more edges leave than come to, or fewer. */
static void
test_balance(void)
{
  enum { VERTICES = 6, ROUNDS = 300 };
  unsigned wrong = 0, found = 0;

  for (int round = 0; round < ROUNDS; round++) {
    int more[VERTICES] = {0}, edges = 1 + pick(9);
    int32_t first = SG_WORK_NONE;
    scene s;

    open_scene(&s, VERTICES, 9, 0);
    for (int i = 0; i < edges; i++) {
      int a = pick(VERTICES), b = (a + 1 + pick(VERTICES - 1)) % VERTICES;
      bool back = pick(3) > 0;
      sg_work_add(s.work, a, b, 1, 0);
      more[a]++, more[b]--;
      if (back) {
        sg_work_add(s.work, b, a, 1, 0);
        more[a]--, more[b]++;
      }
    }
    for (int v = VERTICES - 1; v >= 0; v--) {
      first = more[v] != 0 ? v : first;
    }
    wrong += sg_work_unbalanced(s.work) != first;
    found += first != SG_WORK_NONE;
    sg_work_close(s.work);
  }
  CHECK("the first vertex out of balance", wrong == 0);
  CHECK("some have one, some none", found > 50 && found < ROUNDS - 10);
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

/* Whether what is said of the edges that do not end in a vertex is not so. */
static bool
meeting_but(const scene *s, int32_t v1, int32_t v2, int32_t but,
            const sg_meetings *all)
{
  int want = 0;

  for (size_t i = 0; i < all->n; i++) {
    const sg_work_edge *edge = sg_work_get(s->work, all->item[i].edge);
    want |= edge->start != but && edge->end != but;
  }
  return sg_work_meeting_but(s->work, v1, v2, but) != want;
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
      bad += meeting_but(&s, v1, v2, pick(vertices), &out);
      if (k % 5 == 4 && sg_work_edges(s.work)) { /* and after changes */
        sg_work_delete(s.work, sg_work_next(s.work, 0));
        sg_work_add(s.work, v1, v2, 1, 0);
      }
    }
    bad += !work_is_valid(s.work);
    sg_meetings_clear(&out);
    sg_work_close(s.work);
  }
  CHECK("meetings are those of integer arithmetic", bad == 0);
  CHECK("there were meetings", met > 100);
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

/* Edges from anywhere to anywhere, also to where they begin, some twice. */
static void
test_any_edges(void)
{
  unsigned bad = 0;

  for (int round = 0; round < 2000; round++) {
    scene s;
    int vertices = 3 + pick(9);

    open_scene(&s, vertices, 4, 0);
    for (int i = 0; i < 14; i++) {
      int v = pick(vertices), w = pick(vertices);
      int32_t e = sg_work_add(s.work, v, w, 1, 0);
      bad += v == w ? e != SG_WORK_NONE : e <= 0;
    }
    bad += !work_is_valid(s.work);
    bad += !sg_work_resolve(s.work, pick(2)) || !work_is_valid(s.work);
    sg_work_close(s.work);
  }
  CHECK("any edges: the lists stay right", bad == 0);
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
    long doubled = open_star(&s, n, holes, false), sum = 0;
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

/* ---- points that are known to be in line ---- */

/* A point of the line 0-1 of the corners, which has no doubles. */
static void
third_point(sg_point *out, const sg_point corner[3])
{
  sg_point plane[3];
  double x = 0.1 + 0.01 * pick(50);

  sg_point_set(&plane[0], (const double[3]){x, -5, 0});
  sg_point_set(&plane[1], (const double[3]){x + 0.1, 5, 0});
  sg_point_set(&plane[2], (const double[3]){x, -5, 7});
  sg_point_lpi(out, &corner[0], &corner[1], &plane[0], &plane[1], &plane[2]);
}

/* A triangle, two points inside its first side (3, 4) and one beside it (5). */
static sg_work *
open_side(const sg_point point[6], bool note)
{
  sg_work *work = sg_work_open((const double[3]){0, 0, 1});

  for (int i = 0; i < 6; i++) {
    sg_work_vertex(work, 1 + i, &point[i]);
  }
  for (int i = 3; i < 5 && note; i++) {
    sg_work_note_along(work, i, 1, 0);
  }
  return work;
}

/* Every turn is what it is without the word of the caller. */
static void
test_along(void)
{
  unsigned bad = 0, lines = 0;

  for (int round = 0; round < 200; round++) {
    sg_point point[6];

    sg_point_set(&point[0], (const double[3]){0, 0.1 * pick(9), 0});
    sg_point_set(&point[1], (const double[3]){1, 0.1 * pick(9), 0});
    sg_point_set(&point[2], (const double[3]){0.3, 3, 0});
    third_point(&point[3], point);
    third_point(&point[4], point);
    third_point(&point[5], point + 1);
    sg_work *with = open_side(point, true), *without = open_side(point, false);
    for (int k = 0; k < 6 * 6 * 6; k++) {
      int a = k % 6, b = k / 6 % 6, c = k / 36;
      int turns = sg_work_turn(without, a, b, c);

      bad += sg_work_turn(with, a, b, c) != turns;
      lines += turns == 0 && a != b && b != c && c != a;
    }
    for (int i = 0; i < 6; i++) {
      sg_point_clear(&point[i]);
    }
    sg_work_close(with);
    sg_work_close(without);
  }
  CHECK("turns of points along an edge", bad == 0);
  CHECK("points were in line", lines >= 200 * 24);
}

/* How far p is from the line a-b. */
static double
off_line(place a, place b, place p)
{
  return fabs((double)turn(a, b, p)) /
         hypot((double)(b.x - a.x), (double)(b.y - a.y));
}

/* Whether two edges that cross do so farther than this from the lines of their
 * ends, and from all vertices. */
static bool
cross_by_far(const place at[6], double far)
{
  double p = off_line(at[2], at[3], at[0]), q = off_line(at[2], at[3], at[1]);
  double x = (double)at[0].x + p / (p + q) * (double)(at[1].x - at[0].x);
  double y = (double)at[0].y + p / (p + q) * (double)(at[1].y - at[0].y);
  bool is = p > far && q > far && off_line(at[0], at[1], at[2]) > far &&
            off_line(at[0], at[1], at[3]) > far;

  for (int v = 0; v < 6; v++) {
    is = is && hypot((double)at[v].x - x, (double)at[v].y - y) > far;
  }
  return is;
}

/* So many that it is worth to look which cross. */
static void
add_far_edges(sg_work *work)
{
  for (int32_t i = 0; i <= SG_WORK_FEW; i++) {
    int32_t v[2];

    for (int k = 0; k < 2; k++) {
      sg_point point;
      sg_point_set(&point, (double[3]){900 + k, 7 * i, 0});
      v[k] = sg_work_vertex(work, 100 + 2 * i + k, &point);
    }
    sg_work_add(work, v[0], v[1], 1, 0);
  }
}

/* Two edges that cross, and a third one near them that meets neither. */
static void
test_crossed_by_far(void)
{
  static const double up[3] = {0, 0, 1};
  int near = 0, far = 0, wrong = 0;

  for (int round = 0; round < 20000; round++) {
    sg_work *work = sg_work_open(up);
    place at[6];
    double reach = (1 + pick(64)) / 64.0 / 8; /* times 64: to 8 */

    for (int v = 0; v < 6; v++) {
      at[v] = (place){pick(40), pick(40)};
      sg_point point;
      sg_point_set(&point, (double[3]){(double)at[v].x, (double)at[v].y, 0});
      sg_work_vertex(work, v + 1, &point);
    }
    for (int e = 0; e < 3; e++) {
      sg_work_add(work, 2 * e, 2 * e + 1, 1, e + 1);
    }
    add_far_edges(work);
    bool cross = turn(at[0], at[1], at[2]) * turn(at[0], at[1], at[3]) < 0 &&
                 turn(at[2], at[3], at[0]) * turn(at[2], at[3], at[1]) < 0;
    for (int e = 0; e < 4 && cross; e += 2) { /* the third one meets none */
      cross = turn(at[e], at[e + 1], at[4]) * turn(at[e], at[e + 1], at[5]) > 0;
    }
    if (cross && sg_work_resolve(work, 0) && sg_work_crossed(work)) {
      bool is = cross_by_far(at, 64 * reach);

      if (is == cross_by_far(at, 64 * reach * (1 + 1e-9)) &&
          is == cross_by_far(at, 64 * reach * (1 - 1e-9))) {
        wrong += sg_work_crossed_by_far(work, reach) != is;
        near += !is;
        far += is;
      }
    }
    sg_work_close(work);
  }
  CHECK("edges cross by far, or not", wrong == 0 && near > 300 && far > 300);
}

int
main(void)
{
  test_lists();
  test_balance();
  test_hash();
  test_meeting(12, 5, 15, 300);
  test_meeting(60, 9, 150, 60);
  test_meeting(150, 40, 100, 60);
  test_candidates(9, 4, 6, 300);
  test_candidates(40, 12, 12, 200);
  test_candidates(120, 60, 60, 100);
  test_any_edges();
  test_triangulate();
  test_along();
  test_crossed_by_far();
  return check_report();
}
