/* work_simple_test.c -- what is simple and orderly, and that the candidates of
 * such relations are still those of the definition.
 */
#include "polygon/work_private.h"
#include "work_scene.h"

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

/* Do the segments between s's vertices cross in one point inside both? */
static bool
cross(const scene *s, int a, int b, int c, int d)
{
  const place *p = s->at;

  return turn(p[a], p[b], p[c]) * turn(p[a], p[b], p[d]) < 0 &&
         turn(p[c], p[d], p[a]) * turn(p[c], p[d], p[b]) < 0;
}

/* Reverses a part of the tour for a crossing; false: there is none. */
static bool
untangled_once(const scene *s, int *tour)
{
  for (int i = 0; i < s->n; i++) {
    for (int j = i + 2; j < s->n; j++) {
      if (cross(s, tour[i], tour[i + 1], tour[j], tour[(j + 1) % s->n])) {
        for (int a = i + 1, b = j; a < b; a++, b--) {
          int kept = tour[a];
          tour[a] = tour[b];
          tour[b] = kept;
        }
        return true;
      }
    }
  }
  return false;
}

/* A polygon as winding as can be, through n random vertices. */
static void
open_winding(scene *s, int n)
{
  int tour[MOST];
  long doubled = 0;

  open_scene(s, n, 1000, 0);
  for (int i = 0; i < n; i++) {
    tour[i] = i;
  }
  for (int times = 0; times < 20000 && untangled_once(s, tour); times++) {
  }
  for (int i = 0; i < n; i++) {
    place a = s->at[tour[i]], b = s->at[tour[(i + 1) % n]];
    doubled += a.x * b.y - a.y * b.x;
  }
  for (int i = 0; i < n; i++) {
    int a = tour[i], b = tour[(i + 1) % n];
    sg_work_add(s->work, doubled > 0 ? a : b, doubled > 0 ? b : a, 1, i + 1);
  }
}

/* The candidates while triangles are taken off, one by one. */
static void
test_taking(void)
{
  unsigned bad = 0, many = 0, simple = 0, all = 0;

  for (int round = 0; round < 40; round++) {
    scene s;
    int32_t e;
    if (round % 2) {
      open_star(&s, 8 * (8 + pick(4)), pick(3), false);
    } else {
      open_winding(&s, 60 + pick(40));
    }
    sg_work_is_simple(s.work);
    s.work->looked =
        round % 4 < 2 ? 0 : SIZE_MAX / 2; /* then trees are asked */
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
      simple += sg_work_edges(s.work) > SG_WORK_FEW &&
                s.work->simple == SG_SIMPLE && s.work->orderly;
    }
    sg_work_close(s.work);
  }
  CHECK("candidates while triangles are taken off", bad == 0);
  CHECK("it stays known to be simple", all > 100 && simple == all);
}

/* A hole that is no hole is in the way too. */
static void
test_disorder(void)
{
  unsigned bad = 0, many = 0, orderly = 0;

  for (int round = 0; round < 40; round++) {
    scene s;
    open_star(&s, 8 * (8 + pick(4)), 1 + pick(2), true);
    for (int32_t e = 0; (e = sg_work_next(s.work, e)) != 0;) {
      const sg_work_edge *edge = sg_work_get(s.work, e);
      bad += wrong_candidates(&s, edge->start, edge->end, &many);
    }
    orderly += !sg_work_is_simple(s.work) || s.work->orderly;
    sg_work_close(s.work);
  }
  CHECK("candidates round a hole that is turned wrong", bad == 0);
  CHECK("it is simple and not orderly", orderly == 0);
}

/* A side of a triangle in whose way nothing was, which is added after another
 * edge came in its way. */
static void
test_no_longer_free(void)
{
  const double up[3] = {0, 0, 1};
  const double at[6][3] = {{0, 0, 0},  {10, 0, 0}, {5, 10, 0},
                           {5, 20, 0}, {8, 1, 0},  {12, 8, 0}};
  sg_work *work = sg_work_open(up);
  sg_candidates walk;

  for (int32_t v = 0; v < 6; v++) {
    sg_point point;
    sg_point_set(&point, at[v]);
    sg_work_vertex(work, v + 1, &point);
  }
  sg_work_add(work, 0, 1, 1, 1);
  sg_work_add(work, 2, 3, 1, 1);
  sg_candidates_open(&walk, work, 0, 1);
  CHECK("nothing is in its way", sg_candidates_next(&walk) == 2);
  sg_candidates_close(&walk);
  sg_work_add(work, 4, 5, 1, 1);
  CHECK("nothing crosses", sg_work_is_simple(work));
  sg_work_add(work, 1, 2, 1, 1);
  CHECK("its side crosses what came between", !sg_work_is_simple(work));
  sg_work_close(work);
}

int
main(void)
{
  test_no_longer_free();
  test_simple(70, 30, 12, 1500);
  test_simple(150, 40, 9, 1500);
  test_simple(90, 12, 5, 600);
  test_taking();
  test_disorder();
  return check_report();
}
