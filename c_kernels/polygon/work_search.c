/* work_search.c -- what work_tree.h is for: edges in a triangle. See
 * work_private.h.
 *
 * Layer: kernel. What is left out is certainly apart; who asks decides exactly.
 */
#include "engine/list.h"
#include "work_private.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  HUB = 32, /* so many edges hang on a vertex */
  FAN = 8   /* so few are no fan */
};

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

static sg_work_grid_segment
segment_of_edge(const sg_work *work, int32_t e)
{
  const double *p = work->vertex[work->edge[e].edge.start].at;
  const double *q = work->vertex[work->edge[e].edge.end].at;

  return (sg_work_grid_segment){{p[0], p[1]}, {q[0], q[1]}};
}

bool
sg_work_is_hub(const sg_work *work, int32_t v)
{
  int n = 0;

  for (int32_t e = work->vertex[v].first_out; e && n < HUB;
       e = work->edge[e].out_younger) {
    n++;
  }
  for (int32_t e = work->vertex[v].first_in; e && n < HUB;
       e = work->edge[e].in_younger) {
    n++;
  }
  return n >= HUB;
}

/* An edge of a hub, and in which half turn round it; or of none. */
typedef struct spoke {
  int32_t hub, half, edge;
} spoke;

static int32_t
far_end(const sg_work *work, int32_t hub, int32_t e)
{
  const sg_work_edge *edge = &work->edge[e].edge;

  return edge->start == hub ? edge->end : edge->start;
}

static spoke
spoke_of(const sg_work *work, int32_t e)
{
  const sg_work_edge *edge = &work->edge[e].edge;
  spoke out = {SG_WORK_NONE, 0, e};

  if (sg_work_is_hub(work, edge->start)) {
    out.hub = edge->start;
  } else if (sg_work_is_hub(work, edge->end)) {
    out.hub = edge->end;
  }
  if (out.hub != SG_WORK_NONE) {
    out.half = sg_work_place(work, out.hub, far_end(work, out.hub, e));
  }
  return out;
}

/* Round each hub, in each half counter-clockwise. */
static int
by_angle(const void *x, const void *y, void *work)
{
  const spoke *a = x, *b = y;

  if (a->hub != b->hub) {
    return a->hub < b->hub ? -1 : 1;
  }
  if (a->half != b->half) {
    return a->half < b->half ? -1 : 1;
  }
  int turn = a->hub == SG_WORK_NONE
                 ? 0
                 : sg_work_turn(work, a->hub, far_end(work, a->hub, a->edge),
                                far_end(work, a->hub, b->edge));

  return turn ? -turn : (a->edge > b->edge) - (a->edge < b->edge);
}

/* A tree of n spokes of one half turn, in this order. False: no memory. */
static bool
open_fan(const sg_work *work, const spoke *of, size_t n, sg_work_fan *out)
{
  int32_t *number = malloc(n * sizeof *number);
  sg_work_box *box = malloc(n * sizeof *box);

  *out = (sg_work_fan){.hub = of->hub};
  if (!number || !box) {
    free(number);
    free(box);
    return false;
  }
  for (size_t i = 0; i < n; i++) {
    number[i] = of[i].edge;
    box[i] = box_of_edge(work, of[i].edge);
  }
  return sg_work_tree_open(&out->tree, number, box, NULL, n, true);
}

static sg_work_box
box_of_fan(const sg_work_fan *fan)
{
  sg_work_box all = fan->tree.box[0];

  for (size_t i = 1; i < fan->tree.n; i++) {
    sg_work_box_join(&all, &fan->tree.box[i]);
  }
  return all;
}

static void
clear_plant(sg_work_plant *plant)
{
  for (size_t i = 0; i < plant->fans; i++) {
    sg_work_tree_close(&plant->fan[i].tree);
  }
  free(plant->fan);
  sg_work_tree_close(&plant->tree);
  *plant = (sg_work_plant){0};
}

/* The spokes, in order, as a tree of fans and of single edges. */
static bool
plant_spokes(const sg_work *work, const spoke *of, size_t n, sg_work_plant *out)
{
  int32_t *number = malloc((n + 1) * sizeof *number);
  sg_work_box *box = malloc((n + 1) * sizeof *box);
  sg_work_grid_segment *segment = calloc(n + 1, sizeof *segment);
  size_t items = 0;
  bool good = number && box && segment;

  out->edges = n;
  out->fan = malloc((n / FAN + 1) * sizeof *out->fan);
  good = good && out->fan;
  for (size_t i = 0, end; good && i < n; i = end) {
    for (end = i + 1; end < n && of[i].hub != SG_WORK_NONE &&
                      of[end].hub == of[i].hub && of[end].half == of[i].half;
         end++) {
    }
    if (end - i >= FAN) {
      good = open_fan(work, of + i, end - i, &out->fan[out->fans++]);
      number[items] = ~(int32_t)(out->fans - 1);
      if (good) {
        box[items++] = box_of_fan(&out->fan[out->fans - 1]);
      }
      continue;
    }
    for (size_t k = i; k < end; k++) {
      number[items] = of[k].edge;
      segment[items] = segment_of_edge(work, of[k].edge);
      box[items++] = box_of_edge(work, of[k].edge);
    }
  }
  if (!good) {
    free(number);
    free(box);
    free(segment);
    return false;
  }
  return sg_work_tree_open(&out->tree, number, box, segment, items, false);
}

/* Adds a tree of living edges. False: no memory. */
static bool
plant(sg_work *work, int32_t *number, size_t n)
{
  sg_work_forest *f = work->forest;
  sg_work_plant *fresh = &f->tree[f->trees];
  spoke *of = malloc((n + 1) * sizeof *of);
  bool any = false;

  *fresh = (sg_work_plant){0};
  for (size_t i = 0; of && i < n; i++) {
    of[i] = spoke_of(work, number[i]);
    any = any || of[i].hub != SG_WORK_NONE;
  }
  if (of && any) {
    qsort_r(of, n, sizeof *of, by_angle, work);
  }
  bool good = of && plant_spokes(work, of, n, fresh);

  free(of);
  free(number);
  if (!good) {
    clear_plant(fresh);
    return false;
  }
  f->trees++;
  f->held += n;
  return true;
}

/* A living edge between the ends of e, this way or the other; 0: there is none.
 * Of edges with the same two ends a tree needs one, which may be gone. */
static int32_t
living_of(const sg_work *work, int32_t e)
{
  const sg_work_edge *edge = &work->edge[e].edge;

  if (work->edge[e].living) {
    return e;
  }
  int32_t same = sg_work_pair(work, edge->start, edge->end);

  return same ? same : sg_work_pair(work, edge->end, edge->start);
}

/* Is e the first one between its ends? */
static bool
is_first(const sg_work *work, int32_t e)
{
  const sg_work_edge *edge = &work->edge[e].edge;
  int32_t same = sg_work_pair(work, edge->start, edge->end);
  int32_t other = sg_work_pair(work, edge->end, edge->start);

  return (!same || same >= e) && (!other || other > e);
}

/* Appends those of a tree that are there. */
static size_t
take_living(const sg_work *work, const sg_work_tree *tree, int32_t *out,
            size_t n)
{
  for (size_t i = 0; i < tree->n; i++) {
    if (tree->number[i] > 0 && living_of(work, tree->number[i])) {
      out[n++] = tree->number[i];
    }
  }
  return n;
}

/* What came last, and the trees after `trees` ones, become one. False: no
 * memory. */
static bool
replant(sg_work *work, int trees)
{
  sg_work_forest *f = work->forest;
  size_t room = (size_t)f->n, n = 0;

  for (int i = trees; i < f->trees; i++) {
    room += f->tree[i].edges;
  }
  int32_t *number = malloc((room + 1) * sizeof *number);

  if (!number) {
    return false;
  }
  while (f->trees > trees) {
    sg_work_plant *last = &f->tree[--f->trees];

    n = take_living(work, &last->tree, number, n);
    for (size_t i = 0; i < last->fans; i++) {
      n = take_living(work, &last->fan[i].tree, number, n);
    }
    f->held -= last->edges;
    clear_plant(last);
  }
  for (int i = 0; i < f->n; i++) {
    number[n] = f->fresh[i];
    n += living_of(work, f->fresh[i]) != 0;
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

  while (first > 0 && f->tree[first - 1].edges <= 2 * n) {
    n += f->tree[--first].edges;
  }
  return first;
}

/* A forest of one tree. False: no memory. */
static bool
open_forest(sg_work *work)
{
  int32_t *number = malloc((work->living + 1) * sizeof *number);
  size_t n = 0;

  work->forest = calloc(1, sizeof *work->forest);
  if (!number || !work->forest) {
    free(number);
    return false;
  }
  for (int32_t e = work->oldest; e; e = work->edge[e].younger) {
    number[n] = e;
    n += is_first(work, e);
  }
  sg_work_grid_close(&work->grid); /* a new edge may be in many cells */
  work->forest->upto = work->edges;
  return plant(work, number, n);
}

/* Puts in the edges that came since; all anew where most are gone. False: no
 * memory. */
static bool
catch_up(sg_work *work)
{
  sg_work_forest *f = work->forest;

  if (!f) {
    return open_forest(work);
  }
  while (f->upto < work->edges) {
    f->fresh[f->n] = ++f->upto;
    f->n += is_first(work, f->upto);
    if (f->n == SG_WORK_FRESH && !replant(work, first_small(f))) {
      return false;
    }
  }
  return f->held <= 2 * work->living + SG_WORK_FEW || replant(work, 0);
}

void
sg_work_forest_close(sg_work *work)
{
  sg_work_forest *f = work->forest;

  while (f && f->trees > 0) {
    clear_plant(&f->tree[--f->trees]);
  }
  free(f);
  work->forest = NULL;
}

/* ---- in a triangle ------------------------------------------------------ */

typedef struct searching {
  const sg_work *work;
  const int32_t *corner;
  sg_work_corners at;
  const sg_work_plant *plant; /* the one that is asked */
  int32_t hub;                /* of the fan that is asked */
  sg_work_in_way *in_way;
  void *data;
  int32_t found;
} searching;

static bool
is_apart(const void *data, const sg_work_box *box)
{
  const searching *s = data;

  return !sg_work_step(s->work, 1) || sg_work_box_apart(&s->at, box);
}

static bool
is_slab_apart(const void *data, const sg_work_slab *slab)
{
  const searching *s = data;

  return sg_work_slab_apart(&s->at, slab);
}

/* Whether all corners but the hub lie to the right of all spokes from the first
 * to the last, or all to the left: then none of these has more in common with
 * the triangle than the hub. Exact. */
static bool
is_beside(const void *data, int32_t first, int32_t last)
{
  const searching *s = data;
  int32_t low = far_end(s->work, s->hub, first);
  int32_t high = far_end(s->work, s->hub, last);
  bool right = true, left = true;

  for (int i = 0; i < 3 && (right || left); i++) {
    int32_t v = s->corner[i];

    if (v != s->hub) {
      right = right && sg_work_turn(s->work, s->hub, low, v) < 0;
      left = left && sg_work_turn(s->work, s->hub, high, v) > 0;
    }
  }
  return right || left;
}

static bool
is_in_way(void *data, int32_t e)
{
  const searching *s = data;
  int32_t living = living_of(s->work, e);

  return living && s->in_way(s->data, living);
}

/* An edge in the way of what a tree has: an edge or a fan; 0: none. */
static int32_t
find_in(searching *s, int32_t number)
{
  if (number > 0) {
    return is_in_way(s, number) ? number : 0;
  }
  const sg_work_fan *fan = &s->plant->fan[~number];

  s->hub = fan->hub;
  return sg_work_tree_go(&(sg_work_tree_walk){.tree = &fan->tree,
                                              .skips = is_apart,
                                              .passes = is_beside,
                                              .ends = is_in_way,
                                              .data = s});
}

static bool
has_in_way(void *data, int32_t number)
{
  searching *s = data;

  s->found = find_in(s, number);
  return s->found != 0;
}

sg_work_corners
sg_work_corners_of(const sg_work *work, const int32_t corner[3])
{
  sg_work_corners out;

  for (int k = 0; k < 2; k++) {
    for (int i = 0; i < 3; i++) {
      out.at[i][k] = work->vertex[corner[i]].at[k];
    }
    out.low[k] = fmin(fmin(out.at[0][k], out.at[1][k]), out.at[2][k]);
    out.high[k] = fmax(fmax(out.at[0][k], out.at[1][k]), out.at[2][k]);
  }
  return out;
}

bool
sg_work_forest_find(sg_work *work, const int32_t corner[3],
                    sg_work_in_way *in_way, void *data, int32_t *found)
{
  const sg_work_forest *f;
  searching s = {
      .work = work, .corner = corner, .in_way = in_way, .data = data};

  *found = 0;
  if (!catch_up(work)) {
    return false;
  }
  f = work->forest;
  s.at = sg_work_corners_of(work, corner);
  for (int i = 0; i < f->n && !*found; i++) {
    *found = is_in_way(&s, f->fresh[i]) ? f->fresh[i] : 0;
  }
  for (int i = f->trees - 1; i >= 0 && !*found; i--) {
    s.plant = &f->tree[i];
    sg_work_tree_go(&(sg_work_tree_walk){.tree = &s.plant->tree,
                                         .skips = is_apart,
                                         .skips_slab = is_slab_apart,
                                         .ends = has_in_way,
                                         .data = &s});
    *found = s.found;
  }
  *found = *found ? living_of(work, *found) : 0;
  return true;
}
