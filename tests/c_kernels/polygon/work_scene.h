/* work_scene.h -- random relations on small grids of integers, and what is
 * true of them by plain integer arithmetic.
 */
#ifndef SG_TEST_WORK_SCENE_H
#define SG_TEST_WORK_SCENE_H

#include "polygon/triangulate.h"
#include "tests/check.h"

#include <stdlib.h>
#include <string.h>

static uint64_t seed = 88;

static inline int
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

static inline long
turn(place a, place b, place c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

static inline bool
same(place a, place b)
{
  return a.x == b.x && a.y == b.y;
}

/* Where p lies in a-b, scaled by the squared length; inside if 0 < it < l. */
static inline bool
strictly_inside(place a, place b, place p)
{
  long l = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
  long t = (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y);

  return turn(a, b, p) == 0 && t > 0 && t < l;
}

/* Does segment x-y meet the closed triangle in more than its corners? By
 * clipping: t = low..high of x + t (y - x), as fractions. */
static inline bool
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
static inline void
to_space(int axis, bool flip, place at, double out[3])
{
  out[axis] = (double)pick(3);
  out[(axis + 1) % 3] = (double)(flip ? at.y : at.x);
  out[(axis + 2) % 3] = (double)(flip ? at.x : at.y);
}

static inline void
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
static inline void
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

/* Is v3 a third vertex of v1 -> v2, by definition? */
static inline bool
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

static inline bool
has_edge(const scene *s, int32_t v)
{
  return sg_work_leaving(s->work, v, 0) || sg_work_entering(s->work, v, 0);
}

/* How often the candidates of v1 -> v2 are not those of the definition, in the
 * paper's order; adds to *many how many there were. */
static inline unsigned
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

/* A polygon of `n` corners: random order sorted round the middle, so that it
 * is star-shaped but as ragged as can be. Wrong: with its holes turned the
 * other way. */
static inline long
open_star(scene *s, int n, int holes, bool wrong)
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
    bool turned = wrong && i >= n;
    sg_work_add(s->work, turned ? j : i, turned ? i : j, 1, i + 1);
    doubled += s->at[i].x * s->at[j].y - s->at[i].y * s->at[j].x;
  }
  return doubled;
}

#endif
