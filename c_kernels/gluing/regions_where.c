/* regions_where.c -- parts that hang together by edges, in each other
 * (regions_walk.h).
 *
 * Each part lies in one zone of any other. A walk over a point of each (in the
 * middle of a triangle or a wire, so that it is on no other part where two
 * zones meet; or, as the walk is shifted by less than anything, just inside a
 * part that lies on others all over) passes triangles, and knows of each part
 * in which of its zones it is: what it leaves counts one less, what it enters
 * one more. Those parts of which it is not in the outer zone go round it, in
 * each other; so the n-th of them is the one that n others go round, and the
 * sum of what counts at that depth is the zone.
 */
#include "regions_walk.h"

#include "rows/disjoint.h"

#include <stdlib.h>
#include <string.h>

/* ---- parts ---- */

static void
middle_of(const sg_dense *d, const int32_t *v, int n, sg_point *out)
{
  mpq_t q[3], x;

  mpq_init(x);
  for (int k = 0; k < 3; k++) {
    mpq_init(q[k]);
    for (int i = 0; i < n; i++) {
      mpq_set_d(x, d->at[v[i]][k]);
      mpq_add(q[k], q[k], x);
    }
    mpq_set_ui(x, 1, (unsigned)n);
    mpq_mul(q[k], q[k], x);
  }
  if (!sg_point_set_q(out, q[0], q[1], q[2])) {
    sg_point_set(out, d->at[v[0]]);
  }
  for (int k = 0; k < 3; k++) {
    mpq_clear(q[k]);
  }
  mpq_clear(x);
}

static void
add_part(sg_walk *w, uint32_t element, uint32_t piece, uint32_t number)
{
  w->part[w->parts++] =
      (sg_walk_part){.element = element, .piece = piece, .number = number};
}

void
sg_walk_middle_of(const sg_regions_maker *m, uint32_t t, sg_point *out)
{
  middle_of(m->d, m->d->corner[t], 3, out);
}

static void
choose_point(const sg_regions_maker *m, sg_walk_part *one)
{
  const sg_dense *d = m->d;

  if (one->piece != SG_NOWHERE) {
    uint32_t first = m->triangle_begin[one->piece];
    sg_walk_middle_of(m, m->triangle[first], &one->at);
  } else if (one->element < sg_element_of_lone(m, 0)) {
    uint32_t e = m->wire_edge[one->number];
    middle_of(d, (int32_t[2]){d->from[e], d->to[e]}, 2, &one->at);
  } else {
    sg_point_set(&one->at, d->at[m->lone_at[one->number]]);
  }
}

/* Wires that hang together where no face is lie in one zone. */
static bool
join_wires(sg_regions_maker *m)
{
  uint32_t *at = malloc((m->d->vertices + 1) * sizeof *at);
  bool *faced = calloc(m->d->vertices + 1, sizeof *faced);

  for (uint32_t k = 0; at && faced && k < m->corners; k++) {
    faced[sg_corner_vertex(m, k)] |=
        k >= m->entries || m->is_face[m->polygon[k]];
  }
  for (size_t v = 0; at && v < m->d->vertices; v++) {
    at[v] = SG_NOWHERE;
  }
  for (uint32_t i = 0; at && faced && i < m->wires; i++) {
    for (int k = 0; k < 2; k++) {
      uint32_t v = k ? m->high[m->wire[i]] : m->low[m->wire[i]];
      if (faced[v]) {
        continue;
      }
      at[v] = at[v] == SG_NOWHERE ? i : at[v];
      sg_disjoint_join(m->zone, sg_element_of_wire(m, i),
                       sg_element_of_wire(m, at[v]));
    }
  }
  bool good = at && faced;
  free(at);
  free(faced);
  return good || sg_regions_no_memory(m);
}

static bool
list_parts(sg_walk *w)
{
  sg_regions_maker *m = w->m;
  size_t n = m->d->polygons + m->wires + m->lone + 1;

  if (!join_wires(m) || !(w->part = malloc(n * sizeof *w->part))) {
    return sg_regions_no_memory(m);
  }
  for (uint32_t p = 0; p < m->d->polygons; p++) {
    if (m->is_face[p] && m->piece[p] == p) {
      add_part(w, m->outer[p], p, p);
    }
  }
  for (uint32_t i = 0; i < m->wires; i++) {
    uint32_t element = sg_element_of_wire(m, i);
    if (m->zone[element] == element) {
      add_part(w, element, SG_NOWHERE, i);
    }
  }
  for (uint32_t i = 0; i < m->lone; i++) {
    add_part(w, sg_element_of_lone(m, i), SG_NOWHERE, i);
  }
  for (size_t i = 0; i < w->parts; i++) {
    choose_point(w->m, &w->part[i]);
  }
  return true;
}

/* ---- the tree ---- */

void
sg_walk_corners(const void *data, uint32_t item, double out[3][3])
{
  const sg_walk *w = data;
  const sg_dense *d = w->m->d;

  for (int k = 0; k < 3; k++) {
    memcpy(out[k], d->at[d->corner[w->item[item]][k]], sizeof out[k]);
  }
}

/* Of the pieces that have several zones. */
static sg_bvh *
plant(sg_walk *w)
{
  sg_regions_maker *m = w->m;
  const sg_dense *d = m->d;
  sg_box *box = malloc((d->triangles + 1) * sizeof *box);

  w->item = malloc((d->triangles + 1) * sizeof *w->item);
  w->all = sg_box_none();
  for (uint32_t t = 0; box && w->item && t < d->triangles; t++) {
    uint32_t p = (uint32_t)d->polygon_of[t];
    double at[3][3];

    if (!m->is_face[p] || m->classes[sg_disjoint_root(m->piece, p)] < 2) {
      continue;
    }
    w->item[w->items] = t;
    sg_walk_corners(w, (uint32_t)w->items, at);
    box[w->items] = sg_box_none();
    for (int k = 0; k < 3; k++) {
      sg_box_add(&box[w->items], at[k]);
      sg_box_add(&w->all, at[k]);
    }
    w->items++;
  }
  sg_bvh *tree = box && w->item ? sg_bvh_open(box, w->items, m->cancel) : NULL;
  free(box);
  return tree;
}

/* ---- on the way ---- */

static void
step(sg_walk *w, uint32_t zone, int by)
{
  uint32_t piece = sg_disjoint_root(w->m->piece, zone / 2);

  if (zone == w->m->outer[piece]) {
    w->count[zone] += by;
    w->away -= by;
    w->around -= by * ((int64_t)zone + 1);
  } else if (w->sum) {
    w->sum[w->depth[piece]] += by * ((int64_t)zone + 1);
  }
}

void
sg_walk_pass(void *data, uint32_t item, int turns)
{
  sg_walk *w = data;
  uint32_t p = (uint32_t)w->m->d->polygon_of[w->item[item]];
  uint32_t below = sg_disjoint_root(w->m->zone, 2 * p);
  uint32_t above = sg_disjoint_root(w->m->zone, 2 * p + 1);

  if (below != above) {
    step(w, below, turns);
    step(w, above, -turns);
  }
}

bool
sg_walk_is_between(const sg_walk *w, uint32_t item, const sg_walk_part *one)
{
  const sg_regions_maker *m = w->m;
  uint32_t p = (uint32_t)m->d->polygon_of[w->item[item]];

  return sg_disjoint_root(m->piece, p) != one->piece &&
         sg_disjoint_root(m->zone, 2 * p) !=
             sg_disjoint_root(m->zone, 2 * p + 1);
}

static void
lies_on(void *data, size_t i, uint32_t item)
{
  sg_walk *w = data;
  sg_walk_part *one = &w->part[w->stop[i]];

  if (!one->inside && sg_walk_is_between(w, item, one)) {
    *(w->nearly ? &one->nearly : &one->on) = true;
  }
}

int64_t
sg_walk_own_away(const sg_walk *w, const sg_walk_part *one)
{
  return one->piece == SG_NOWHERE ? 0 : -w->count[one->element];
}

static void
arrive(void *data, size_t i)
{
  sg_walk *w = data;
  sg_walk_part *one = &w->part[w->stop[i]];

  if (!w->sum) {
    int64_t depth = w->away - sg_walk_own_away(w, one);
    one->depth = depth > 0 ? (uint32_t)depth : 0;
  } else if (one->depth > 0) {
    int64_t zone = w->sum[one->depth - 1] - 1;
    bool known = zone >= 0 && zone < (int64_t)(2 * w->m->d->polygons) &&
                 w->m->zone[zone] == zone;
    w->parent[w->stop[i]] = known ? (uint32_t)zone : SG_NOWHERE;
    one->on = one->on || !known;
  }
}

void
sg_walk_stop(sg_walk *w, uint32_t number, const sg_point *at)
{
  sg_box here = sg_box_none();

  sg_box_add(&here, at->p);
  if (sg_box_overlap(&here, &w->all, 0)) {
    w->stop[w->stops] = number;
    w->at[w->stops++] = at;
  }
}

bool
sg_walk_over(sg_walk *w, const sg_tour *way)
{
  w->away = w->around = 0;
  memset(w->count, 0, 2 * w->m->d->polygons * sizeof *w->count);
  return w->stops == 0 || sg_tour_over(way, w->at, w->stops, w->m->cancel) ||
         (sg_regions_asked(w->m) && sg_regions_no_memory(w->m));
}

/* Goes to all parts, or to those that have another point. */
static bool
go(sg_walk *w, const sg_bvh *tree, bool again)
{
  const sg_tour way = {tree, w, sg_walk_corners, sg_walk_pass, lies_on, arrive};

  w->stops = 0;
  for (uint32_t i = 0; i < w->parts; i++) {
    sg_walk_part *one = &w->part[i];

    if (again && !one->moved) {
      continue;
    }
    one->on = one->on && w->sum;
    sg_walk_stop(w, i, &one->at);
  }
  return sg_walk_over(w, &way) && (again || w->sum || sg_walk_nearly(w, &way));
}

static bool
any_on(const sg_walk *w)
{
  bool any = false;

  for (size_t i = 0; i < w->parts; i++) {
    any = any || w->part[i].on || w->part[i].nearly;
  }
  return any;
}

static bool
visit(sg_walk *w, const sg_bvh *tree)
{
  sg_regions_maker *m = w->m;
  bool good =
      go(w, tree, false) &&
      (!any_on(w) || (sg_walk_move_points(w, tree) && go(w, tree, true)));

  uint32_t deepest = 0;
  for (size_t i = 0; good && i < w->parts; i++) {
    const sg_walk_part *one = &w->part[i];
    deepest = one->depth > deepest ? one->depth : deepest;
    if (one->piece != SG_NOWHERE) {
      w->depth[one->piece] = one->depth;
    }
  }
  if (good && deepest > 0) {
    w->sum = calloc((size_t)deepest + 1, sizeof *w->sum);
    good = w->sum ? go(w, tree, false) : sg_regions_no_memory(m);
  }
  for (size_t i = 0; i < w->parts; i++) {
    m->out->doubtful += w->part[i].on;
  }
  return good;
}

/* ---- together ---- */

static bool
make_room(sg_walk *w)
{
  size_t n = w->parts + 1, p = w->m->d->polygons + 1;

  w->stop = malloc(n * sizeof *w->stop);
  w->at = malloc(n * sizeof *w->at);
  w->parent = malloc(n * sizeof *w->parent);
  w->count = calloc(2 * p, sizeof *w->count);
  w->depth = calloc(p, sizeof *w->depth);
  for (size_t i = 0; w->parent && i < w->parts; i++) {
    w->parent[i] = SG_NOWHERE;
  }
  return (w->stop && w->at && w->parent && w->count && w->depth) ||
         sg_regions_no_memory(w->m);
}

static uint32_t
join_parts(sg_walk *w)
{
  sg_regions_maker *m = w->m;
  uint32_t outside = SG_NOWHERE;

  for (size_t i = 0; i < w->parts; i++) {
    uint32_t to = w->parent[i];

    if (to == SG_NOWHERE) {
      outside = outside == SG_NOWHERE ? w->part[i].element : outside;
      to = outside;
    }
    sg_disjoint_join(m->zone, w->part[i].element, to);
  }
  return outside;
}

static void
clear(sg_walk *w)
{
  for (size_t i = 0; i < w->parts; i++) {
    sg_point_clear(&w->part[i].at);
  }
  sg_walk_clear_middles(w);
  free(w->part);
  free(w->stop);
  free(w->at);
  free(w->parent);
  free(w->count);
  free(w->depth);
  free(w->sum);
  free(w->item);
}

bool
sg_regions_locate(sg_regions_maker *m, uint32_t *outside)
{
  sg_walk w = {.m = m};
  sg_bvh *tree = NULL;
  bool good = list_parts(&w) && make_room(&w);

  if (good && w.parts > 1) {
    tree = plant(&w);
    good = tree ? w.items == 0 || visit(&w, tree)
                : sg_regions_asked(m) && sg_regions_no_memory(m);
  }
  if (good) {
    *outside = join_parts(&w);
  }
  sg_bvh_close(tree);
  clear(&w);
  return good;
}
