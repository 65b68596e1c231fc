/* work_pair_test.c -- edges by their two ends where edges are many, windings
 * beside them, and how often edges are looked at: n log n times, or the guard
 * says that it is too much.
 *
 * covers: work_crossing
 */
#include "polygon/work_private.h"
#include "work_scene.h"

#include <math.h>

/* The oldest edge from a to b, by going through all. */
static int32_t
oldest_between(const sg_work *work, int32_t a, int32_t b)
{
  for (int32_t e = 0; (e = sg_work_next(work, e)) != 0;) {
    const sg_work_edge *edge = sg_work_get(work, e);
    if (edge->start == a && edge->end == b) {
      return e;
    }
  }
  return 0;
}

static void
test_pairs(void)
{
  enum { VERTICES = 7 };
  unsigned wrong = 0, found = 0;

  for (int round = 0; round < 40; round++) {
    scene s;

    open_scene(&s, VERTICES, 9, 200);
    CHECK("many edges have a table",
          sg_work_pairs_ready(s.work) && s.work->pairs.open);
    for (int i = 0; i < 300; i++) {
      int32_t e = 1 + pick((int)sg_work_newest(s.work));
      int a = pick(VERTICES), b = pick(VERTICES);
      if (sg_work_get(s.work, e)) {
        sg_work_delete(s.work, e);
      }
      if (a != b && pick(2)) {
        sg_work_add(s.work, a, b, 1, 1);
      }
      int32_t is = sg_work_pair(s.work, a, b);
      wrong += is != oldest_between(s.work, a, b);
      found += is != 0;
    }
    sg_work_close(s.work);
  }
  CHECK("pairs are the oldest", wrong == 0 && found > 1000);
}

/* A closed walk over a grid, so that edges meet in ends only, but may be there
 * many times. */
static void
open_walk(scene *s, int side, int steps)
{
  double normal[3] = {0, 0, pick(2) ? 1 : -1}, p[3] = {0};
  int at = 0;

  s->work = sg_work_open(normal);
  s->n = side * side;
  for (int i = 0; i < s->n; i++) {
    sg_point point;
    s->at[i] = (place){i % side, i / side};
    p[0] = (double)s->at[i].x;
    p[1] = (double)s->at[i].y;
    sg_point_set(&point, p);
    sg_work_vertex(s->work, 100 + i, &point);
  }
  for (int i = 0; i < steps || at != 0; i++) {
    int x = at % side, y = at / side, to = at;
    if (i >= steps) {
      to = x > 0 ? at - 1 : at - side;
    } else if (pick(2)) {
      x += pick(2) ? 1 : -1;
      to = x >= 0 && x < side ? y * side + x : at;
    } else {
      y += pick(2) ? 1 : -1;
      to = y >= 0 && y < side ? y * side + x : at;
    }
    if (to != at) {
      sg_work_add(s->work, at, to, 1, 1);
    }
    at = to;
  }
}

/* How often the edges go round (x + 1/2, y + 1/2) of the grid, in places. */
static int
round_cell(const scene *s, long x, long y)
{
  int around = 0;

  for (int32_t e = 0; (e = sg_work_next(s->work, e)) != 0;) {
    const sg_work_edge *edge = sg_work_get(s->work, e);
    place a = s->at[edge->start], b = s->at[edge->end];
    if (a.x == b.x && a.x > x && (a.y < b.y ? a.y : b.y) == y) {
      around += b.y > a.y ? 1 : -1;
    }
  }
  return around;
}

static void
test_windings(void)
{
  unsigned wrong = 0, asked = 0;

  for (int round = 0; round < 200; round++) {
    enum { SIDE = 6 };
    scene s;
    int32_t around[2000], vertex[MOST];

    open_walk(&s, SIDE, 80 + pick(300));
    for (int i = 0; i < 2000; i++) {
      around[i] = INT32_MIN;
    }
    int32_t n = sg_work_by_place(s.work, vertex);
    CHECK("windings", sg_work_pairs_ready(s.work) && s.work->pairs.open &&
                          sg_work_windings(s.work, vertex, n, around));
    for (int32_t e = 0; (e = sg_work_next(s.work, e)) != 0;) {
      const sg_work_edge *edge = sg_work_get(s.work, e);
      int32_t other = sg_work_pair(s.work, edge->end, edge->start);
      place a = s.at[edge->start], b = s.at[edge->end];
      if (around[e] == INT32_MIN || !other ||
          s.work->edge[e].pair_younger != e ||
          s.work->edge[other].pair_younger != other) {
        continue;
      }
      int want = round_cell(&s, (a.x < b.x ? a.x : b.x) - (a.x == b.x),
                            a.y < b.y ? a.y : b.y);
      wrong += around[e] != (s.work->flip < 0 ? -want : want);
      asked++;
    }
    sg_work_close(s.work);
  }
  CHECK("windings are those of rays", wrong == 0 && asked > 500);
}

/* What is crossed was found: by a comparison of all. */
static void
test_crossed(void)
{
  unsigned wrong = 0, crossed = 0, not = 0;

  for (int round = 0; round < 200; round++) {
    scene s;
    bool want = false;

    if (pick(2)) {
      open_walk(&s, 8, 60 + pick(40));
      sg_work_add(s.work, pick(64), pick(64), 1, 1);
    } else {
      open_scene(&s, 30, 20, 60);
    }
    CHECK("resolved", sg_work_resolve(s.work, 0));
    for (int32_t e = 0; (e = sg_work_next(s.work, e)) != 0;) {
      for (int32_t f = e; (f = sg_work_next(s.work, f)) != 0;) {
        want = want || sg_work_crosses(s.work, e, f);
      }
    }
    if (sg_work_edges(s.work) > SG_WORK_FEW) {
      wrong += want != (sg_work_crossed(s.work) != 0);
      crossed += want;
      not += !want;
    }
    sg_work_close(s.work);
  }
  CHECK("what crosses is noted", wrong == 0 && crossed > 20 && not > 20);
}

/* Two squares of many corners, one across the other by `by`: rounding explains
 * a little. */
static void
test_by_far(void)
{
  enum { N = 40 };
  static const double by[2] = {1e-9, 0.25};

  for (int i = 0; i < 2; i++) {
    sg_work *work = sg_work_open((double[3]){0, 0, 1});
    for (int k = 0; k < 2 * N; k++) {
      int at = k % N, side = at / (N / 4);
      double along = at % (N / 4) / (N / 4.0) + 0.01 * (k / N);
      double x[4] = {along, 1, 1 - along, 0}, y[4] = {0, along, 1, 1 - along};
      sg_point point;
      sg_point_set(&point, (double[3]){x[side] + (k < N ? 0 : 1 - by[i]),
                                       y[side] + (k < N ? 0 : 0.003), 0});
      sg_work_vertex(work, k + 1, &point);
    }
    for (int k = 0; k < 2 * N; k++) {
      sg_work_add(work, k, k / N * N + (k + 1) % N, 1, 1);
    }
    CHECK("crosses", sg_work_resolve(work, 0) && sg_work_crossed(work) != 0);
    CHECK("by how much", sg_work_crossed_by_far(work, 1e-6) == (i == 1));
    sg_work_close(work);
  }
}

/* ---- shapes of n corners ---- */

typedef enum shape { FLOWER, SPIKES, RAGGED, STRIP, TWO_ENDS, TIMES } shape;

static int32_t
enter(sg_work *work, double x, double y)
{
  sg_point point;

  sg_point_set(&point, (double[3]){x, y, 0});
  return sg_work_vertex(work, sg_work_vertices(work) + 1, &point);
}

/* A corner more of the ring: an edge to it from the last one. */
static void
go_to(sg_work *work, int32_t *last, int32_t to)
{
  if (*last >= 0) {
    sg_work_add(work, *last, to, 1, 1);
  }
  *last = to;
}

/* Petals round one vertex; spikes without a width on a base; a ragged star; a
 * strip; edges on one line that all overlap; a square that is gone round many
 * times. */
static void
make(sg_work *work, shape of, int n)
{
  int32_t first = enter(work, 0, 0), last = SG_WORK_NONE;

  go_to(work, &last, first);
  for (int i = 0; i < n / 3 && of == FLOWER; i++) {
    double a = 6.283185307179586 * i / (n / 3), b = a + 6 / (double)n;
    go_to(work, &last, enter(work, cos(a), sin(a)));
    go_to(work, &last, enter(work, cos(b), sin(b)));
    go_to(work, &last, first);
  }
  for (int i = n / 3; i >= 0 && of == SPIKES; i--) {
    int32_t foot = enter(work, i, 1), top = enter(work, i, 2);
    if (i == n / 3) {
      go_to(work, &last, enter(work, i, 0));
    }
    go_to(work, &last, foot);
    go_to(work, &last, top);
    go_to(work, &last, foot);
  }
  for (int i = 0; i < n && of == RAGGED; i++) {
    double a = 6.283185307179586 * ((i + 0.5) / n - 0.5);
    double r = 0.2 + fmod(i * 0.6180339887, 1);
    go_to(work, &last, enter(work, 3 + r * cos(a), r * sin(a)));
  }
  for (int i = 1; i < n && of == STRIP; i++) {
    go_to(work, &last,
          i < n / 2 ? enter(work, i, 0) : enter(work, n - 1 - i, 10));
  }
  for (int i = 1; i < n / 2 && of == TWO_ENDS; i++) {
    go_to(work, &last, enter(work, n - i, 0));
    go_to(work, &last, enter(work, i, 0));
  }
  if (of == TIMES) {
    int32_t corner[4] = {first, enter(work, 1, 0), enter(work, 1, 1),
                         enter(work, 0, 1)};
    for (int i = 1; i < n; i++) {
      go_to(work, &last, corner[i % 4]);
    }
  } else if (of == TWO_ENDS) {
    go_to(work, &last, enter(work, 0, 3));
  }
  if (last != first) {
    go_to(work, &last, first);
  }
}

static sg_outcome
divide(shape of, int n, size_t most, size_t *steps)
{
  sg_work *work = sg_work_open((double[3]){0, 0, 1});
  sg_work_guard guard = {.most = most};
  sg_triangles found = {0};
  int32_t stuck;
  sg_outcome end = SG_NO_SPACE;

  make(work, of, n);
  sg_work_guard_by(work, &guard);
  if (!sg_work_resolve(work, 0) || guard.end != SG_GOES_ON) {
    end = sg_work_outcome(work);
  } else {
    end = sg_work_triangulate(work, &found, &stuck, NULL);
  }
  *steps = guard.steps;
  free(found.item);
  sg_work_close(work);
  return end;
}

static bool
stop(void *data)
{
  return ++*(int *)data > 1;
}

static void
test_steps(void)
{
  enum { FEW_CORNERS = 3000, MANY = 24000 };
  static const shape quick[] = {FLOWER, SPIKES, RAGGED, STRIP};
  size_t few, many;

  for (int i = 0; i < 4; i++) {
    CHECK("few", divide(quick[i], FEW_CORNERS, SIZE_MAX, &few) == SG_DONE);
    CHECK("many", divide(quick[i], MANY, SIZE_MAX, &many) == SG_DONE);
    CHECK("no more than n log n", many < 16 * few);
  }
  CHECK("overlaps are too much",
        divide(TWO_ENDS, MANY, 1000000, &many) == SG_TOO_MUCH);
  CHECK("at once", many < 1100000);
  CHECK("so is a ring that is gone round",
        divide(TIMES, MANY, 1000000, &many) == SG_TOO_MUCH);

  sg_work *work = sg_work_open((double[3]){0, 0, 1});
  int asked = 0;
  sg_cancel cancel = {stop, &asked};
  sg_work_guard guard = {.cancel = &cancel, .most = SIZE_MAX};
  make(work, TWO_ENDS, MANY);
  sg_work_guard_by(work, &guard);
  sg_work_resolve(work, 0);
  CHECK("a stop is heard", sg_work_outcome(work) == SG_STOPPED);
  CHECK("soon", guard.steps < 200000);
  sg_work_close(work);
}

/* A sort asks, too; and what has no guard of its own has one as long as it is
 * resolved. */
static void
test_asking(void)
{
  static const shape shapes[] = {SPIKES, RAGGED, TWO_ENDS};

  for (int i = 0; i < 3; i++) {
    sg_work *work = sg_work_open((double[3]){0, 0, 1});
    int asked = 1;
    sg_cancel cancel = {stop, &asked};

    make(work, shapes[i], 3000);
    CHECK("stopped", sg_work_resolve_asking(work, 0, &cancel) == SG_STOPPED);
    CHECK("by the sort", asked == 2);
    CHECK("no guard is left", !sg_work_is_guarded(work));
    sg_work_close(work);
    work = sg_work_open((double[3]){0, 0, 1});
    make(work, shapes[i], 30);
    CHECK("resolved", sg_work_resolve_asking(work, 0, NULL) == SG_DONE);
    sg_work_close(work);
  }
}

int
main(void)
{
  test_pairs();
  test_windings();
  test_crossed();
  test_by_far();
  test_steps();
  test_asking();
  return check_report();
}
