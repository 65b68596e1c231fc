/* work_search.c -- what work_tree.h is for: edges in a triangle, and how far
 * the next vertex on one side of an edge is. See work_private.h.
 *
 * Layer: kernel. What is left out is certainly apart; who asks decides exactly.
 */
#include "engine/list.h"
#include "work_private.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- edges -------------------------------------------------------------- */

/* As much wider as its ends may be rounded. */
static sg_work_box
box_of_edge(const sg_work *work, int32_t e)
{
  const double *p = work->vertex[work->edge[e].edge.start].at;
  const double *q = work->vertex[work->edge[e].edge.end].at;
  sg_work_box box = {{0}, {0}, {0}, {0}};

  for (int k = 0; k < 2; k++) {
    box.low[k] = nextafter(fmin(p[k], q[k]), -INFINITY);
    box.high[k] = nextafter(fmax(p[k], q[k]), INFINITY);
  }
  return box;
}

/* Adds a tree of living edges. False: no memory. */
static bool
plant(sg_work *work, int32_t *number, size_t n)
{
  sg_work_forest *f = &work->forest;
  sg_work_box *box = malloc((n + 1) * sizeof *box);

  for (size_t i = 0; box && i < n; i++) {
    box[i] = box_of_edge(work, number[i]);
  }
  if (!box || !sg_work_tree_open(&f->tree[f->trees], number, box, n)) {
    f->tree[f->trees] = (sg_work_tree){0};
    free(number);
    free(box);
    return false;
  }
  f->trees++;
  f->held += n;
  return true;
}

/* What came last, and the trees after `trees` ones, become one. False: no
 * memory. */
static bool
replant(sg_work *work, int trees)
{
  sg_work_forest *f = &work->forest;
  size_t room = (size_t)f->n, n = 0;

  for (int i = trees; i < f->trees; i++) {
    room += f->tree[i].n;
  }
  int32_t *number = malloc((room + 1) * sizeof *number);

  if (!number) {
    return false;
  }
  while (f->trees > trees) {
    sg_work_tree *last = &f->tree[--f->trees];

    for (size_t i = 0; i < last->n; i++) {
      number[n] = last->number[i];
      n += work->edge[last->number[i]].living;
    }
    f->held -= last->n;
    sg_work_tree_close(last);
  }
  for (int i = 0; i < f->n; i++) {
    number[n] = f->fresh[i];
    n += work->edge[f->fresh[i]].living;
  }
  f->n = 0;
  return plant(work, number, n);
}

/* From which tree on they are to be one with what came last. */
static int
first_small(const sg_work_forest *f)
{
  size_t n = (size_t)f->n;
  int first = f->trees;

  while (first > 0 && f->tree[first - 1].n <= 2 * n) {
    n += f->tree[--first].n;
  }
  return first;
}

/* Puts in the edges that came since; all anew where most are gone. False: no
 * memory. */
static bool
catch_up(sg_work *work)
{
  sg_work_forest *f = &work->forest;

  if (!f->open) {
    int32_t *number = malloc((work->living + 1) * sizeof *number);
    size_t n = 0;

    for (int32_t e = work->oldest; number && e; e = work->edge[e].younger) {
      number[n++] = e;
    }
    *f = (sg_work_forest){.open = true, .upto = work->edges};
    return number && plant(work, number, n);
  }
  while (f->upto < work->edges) {
    f->fresh[f->n++] = ++f->upto;
    if (f->n == SG_WORK_FRESH && !replant(work, first_small(f))) {
      return false;
    }
  }
  return f->held <= 2 * work->living + SG_WORK_FEW || replant(work, 0);
}

void
sg_work_forest_clear(sg_work_forest *forest)
{
  while (forest->trees > 0) {
    sg_work_tree_close(&forest->tree[--forest->trees]);
  }
  *forest = (sg_work_forest){0};
}

/* ---- in a triangle ------------------------------------------------------ */

typedef struct searching {
  const sg_work *work;
  double at[3][2];
  double low[2], high[2];
  sg_work_in_way *in_way;
  void *data;
} searching;

/* Whether a box is plainly on the right of side a-b: far more than anything is
 * rounded. */
static bool
is_right_of(const double a[2], const double b[2], const sg_work_box *box)
{
  double x = b[0] - a[0], y = b[1] - a[1];
  double cx = y > 0 ? box->low[0] : box->high[0];
  double cy = x > 0 ? box->high[1] : box->low[1];
  double slack =
      0x1p-46 * ((fabs(a[0]) + fabs(b[0])) * (fabs(cy) + fabs(a[1])) +
                 (fabs(a[1]) + fabs(b[1])) * (fabs(cx) + fabs(a[0])));

  return x * (cy - a[1]) - y * (cx - a[0]) < -slack;
}

static bool
is_apart(const void *data, const sg_work_box *box)
{
  const searching *s = data;

  for (int k = 0; k < 2; k++) {
    if (box->high[k] < s->low[k] || box->low[k] > s->high[k]) {
      return true;
    }
  }
  for (int i = 0; i < 3; i++) {
    if (is_right_of(s->at[i], s->at[(i + 1) % 3], box)) {
      return true;
    }
  }
  return false;
}

static bool
is_in_way(void *data, int32_t e)
{
  const searching *s = data;

  return s->work->edge[e].living && s->in_way(s->data, e);
}

bool
sg_work_forest_find(sg_work *work, const int32_t corner[3],
                    sg_work_in_way *in_way, void *data, int32_t *found)
{
  const sg_work_forest *f = &work->forest;
  searching s = {.work = work, .in_way = in_way, .data = data};

  *found = 0;
  if (!catch_up(work)) {
    return false;
  }
  for (int k = 0; k < 2; k++) {
    for (int i = 0; i < 3; i++) {
      s.at[i][k] = work->vertex[corner[i]].at[k];
    }
    s.low[k] = fmin(fmin(s.at[0][k], s.at[1][k]), s.at[2][k]);
    s.high[k] = fmax(fmax(s.at[0][k], s.at[1][k]), s.at[2][k]);
  }
  for (int i = 0; i < f->n && !*found; i++) {
    *found = is_in_way(&s, f->fresh[i]) ? f->fresh[i] : 0;
  }
  for (int i = f->trees - 1; i >= 0 && !*found; i--) {
    *found = sg_work_tree_go(
        &(sg_work_tree_walk){&f->tree[i], is_apart, is_in_way, &s, 0});
  }
  return true;
}

/* ---- rings -------------------------------------------------------------- */

/* All vertices of the grid of ends, if none is rounded. False: no memory. */
static bool
plant_ends(sg_work *work)
{
  size_t n = 0;
  int32_t *number = malloc(((size_t)work->vertices + 1) * sizeof *number);
  sg_work_box *box = malloc(((size_t)work->vertices + 1) * sizeof *box);

  if (!number || !box) {
    free(number);
    free(box);
    return false;
  }
  work->rounded = false;
  for (int32_t v = 0; v < work->vertices; v++) {
    const double *at = work->vertex[v].at;

    if (sg_work_has_edges(work, v)) {
      box[n] = (sg_work_box){{at[0], at[1]}, {at[0], at[1]}, {0}, {0}};
      sg_work_grid_cell(&work->ends, at, box[n].first);
      memcpy(box[n].last, box[n].first, sizeof box[n].last);
      number[n++] = v;
      work->rounded = work->rounded || work->vertex[v].point.exactly;
    }
  }
  work->planted = sg_work_tree_open(&work->places, number, box, n);
  if (!work->planted) {
    sg_work_tree_close(&work->places);
  }
  return work->planted;
}

typedef struct ring_search {
  const sg_work *work;
  int32_t v1, v2, centre[2];
  int32_t from, best;
} ring_search;

static int32_t
farther(int32_t a, int32_t b)
{
  return a > b ? a : b;
}

/* No vertex there is left of v1-v2, exactly; or none is in the rings asked
 * for. */
static bool
is_no_ring(const void *data, const sg_work_box *box)
{
  const ring_search *s = data;
  const double *p = s->work->vertex[s->v1].at, *q = s->work->vertex[s->v2].at;
  int32_t nearest = 0, farthest = 0;

  for (int k = 0; k < 2; k++) {
    nearest = farther(nearest, farther(box->first[k] - s->centre[k],
                                       s->centre[k] - box->last[k]));
    farthest = farther(farthest, farther(s->centre[k] - box->first[k],
                                         box->last[k] - s->centre[k]));
  }
  if (nearest >= s->best || farthest < s->from) {
    return true;
  }
  const double corner[2] = {q[1] > p[1] ? box->low[0] : box->high[0],
                            q[0] > p[0] ? box->high[1] : box->low[1]};

  return sg_orient2d(p, q, corner) <= 0;
}

static bool
note_ring(void *data, int32_t v)
{
  ring_search *s = data;
  int32_t cell[2];

  if (sg_work_has_edges(s->work, v) && v != s->v1 && v != s->v2) {
    sg_work_grid_cell(&s->work->ends, s->work->vertex[v].at, cell);
    int32_t x = abs(cell[0] - s->centre[0]), y = abs(cell[1] - s->centre[1]);
    int32_t ring = farther(x, y);

    s->best = ring >= s->from && ring < s->best ? ring : s->best;
  }
  return false;
}

bool
sg_work_next_ring(sg_work *work, int32_t v1, int32_t v2,
                  const int32_t centre[2], int32_t *ring)
{
  if (!work->planted && !plant_ends(work)) {
    return false;
  }
  ring_search s = {work, v1, v2, {centre[0], centre[1]}, *ring, INT32_MAX};

  if (!work->rounded) {
    sg_work_tree_go(&(sg_work_tree_walk){&work->places, is_no_ring, note_ring,
                                         &s, SG_WORK_NONE});
    *ring = s.best;
  }
  return true;
}

void
sg_work_places_clear(sg_work *work)
{
  sg_work_tree_close(&work->places);
  work->planted = false;
}
