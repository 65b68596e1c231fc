/* arrangement_side.c -- on which side of the leaves components are: see
 * arrangement.h.
 *
 * Layer: kernel. A walk (join/tour.h) over the points of components counts how
 * often a leaf goes round each. A triangle that has the point lies as the
 * component does; the walk's own shift says on which side of it the walk is,
 * and the triangle makes the difference to the other.
 */
#include "arrangement_private.h"

#include "engine/list.h"
#include "engine/search.h"
#include "join/tour.h"

#include <math.h>
#include <stdlib.h>

enum { TRIES = 64 };

/* The points that are asked of one leaf. */
typedef struct asked {
  sg_arrangement *a;
  uint32_t leaf;
  uint32_t *part; /* [n] */
  int *turns;     /* [n]: how often it goes round the shifted point */
  int *across;    /* [n]: how many more below than above */
  size_t n;
  int here; /* how often it goes round where the walk is */
} asked;

/* ---- which points ---- */

SG_ORDER(compare_pairs, uint32_t, SG_BY_AT(0) SG_BY_AT(1));

/* (leaf, leaf whose components may be near it), sorted; each with itself. */
static uint32_t (*near_leaves(const sg_arrangement *a, size_t *n))[2]
{
  const sg_leaves *leaves = &a->leaves;
  uint32_t(*near)[2] =
      malloc((2 * leaves->pairs + leaves->n + 1) * sizeof *near);

  *n = 0;
  for (uint32_t i = 0; near && i < leaves->n; i++) {
    near[*n][0] = near[*n][1] = i;
    ++*n;
  }
  for (size_t i = 0; near && i < leaves->pairs; i++) {
    uint32_t x = sg_arrangement_leaf(a, leaves->near[i][0]);
    uint32_t y = sg_arrangement_leaf(a, leaves->near[i][1]);

    if (x != SG_NO_KEY && y != SG_NO_KEY && x != y) {
      near[*n][0] = near[*n + 1][1] = x;
      near[*n][1] = near[*n + 1][0] = y;
      *n += 2;
    }
  }
  if (near) {
    qsort(near, *n, sizeof *near, compare_pairs);
  }
  return near;
}

/* The components by leaf: first[leaf] .. first[leaf + 1] - 1 of order[]. */
static bool
sort_parts(const sg_arrangement *a, size_t **first, uint32_t **order)
{
  *first = calloc(a->leaves.n + 2, sizeof **first);
  *order = malloc((a->parts + 1) * sizeof **order);
  if (!*first || !*order) {
    return false;
  }
  for (size_t i = 0; i < a->parts; i++) {
    (*first)[a->part[i].leaf + 2]++;
  }
  for (size_t i = 2; i < a->leaves.n + 2; i++) {
    (*first)[i] += (*first)[i - 1];
  }
  for (uint32_t i = 0; i < a->parts; i++) {
    (*order)[(*first)[a->part[i].leaf + 1]++] = i;
  }
  return true;
}

static bool
may_be_round(const sg_box *box, const sg_point *at)
{
  for (int k = 0; k < 3; k++) {
    if (nextafter(at->p[k], INFINITY) < box->lo[k] ||
        nextafter(at->p[k], -INFINITY) > box->hi[k]) {
      return false;
    }
  }
  return true;
}

/* ---- one point ---- */

/* The axis along which a triangle with these signs of its normal is seen. */
static int
seen_along(const int normal[3])
{
  return normal[2] != 0 ? 2 : normal[1] != 0 ? 1 : 0;
}

static bool
is_within(const sg_point corner[3], const sg_point *p, int axis, int turn)
{
  return sg_point_turn(axis, &corner[0], &corner[1], p) == turn &&
         sg_point_turn(axis, &corner[1], &corner[2], p) == turn &&
         sg_point_turn(axis, &corner[2], &corner[0], p) == turn;
}

/* On which side of its component's plane the walk is: 1 above. */
static int
begins(const int normal[3])
{
  return normal[1] != 0 ? normal[1] : normal[2] != 0 ? normal[2] : -normal[0];
}

/* Whether pieces of the leaf are there for those of another, where both lie on
 * each other. */
static bool
is_before(const asked *r, const sg_part *part)
{
  const sg_arranged *leaf = r->a->leaf;

  return r->leaf < part->leaf &&
         (!leaf[r->leaf].surface || leaf[part->leaf].surface);
}

SG_ORDER(compare_weights, sg_weight, SG_BY(s) SG_BY(p));

/* How often the triangle of a row counts. */
static int
weight_of(const asked *r, uint32_t row)
{
  const sg_leaves *leaves = &r->a->leaves;

  if (leaves->weights == 0) {
    return 1;
  }
  sg_weight key = {r->a->leaf[r->leaf].s, sg_arranged_polygon(r->a, row), 0};
  const sg_weight *known = bsearch(&key, leaves->weight, leaves->weights,
                                   sizeof key, compare_weights);

  return known ? known->weight : 1;
}

static void
read_corners(const void *data, uint32_t row, double out[3][3])
{
  const asked *r = data;
  const sg_arrangement *a = r->a;
  int32_t v[3];

  sg_arranged_corners(a, row, v);
  for (int k = 0; k < 3; k++) {
    out[k][0] = out[k][1] = out[k][2] = 0;
    sg_leaf_vertex_at(a->leaf[r->leaf].tree, a->leaves.views, v[k], out[k]);
  }
}

/* A triangle that has the point. */
static void
lies_on(void *data, size_t i, uint32_t row)
{
  asked *r = data;
  sg_part *part = &r->a->part[r->part[i]];
  sg_point corner[3];
  double place[3][3];

  read_corners(r, row, place);
  for (int k = 0; k < 3; k++) {
    sg_point_set(&corner[k], place[k]);
  }
  int axis = seen_along(part->normal);
  int turn = sg_point_turn(axis, &corner[0], &corner[1], &corner[2]);
  int same = turn * part->normal[axis] * weight_of(r, row);

  if (turn == 0 || !is_within(corner, &part->at, axis, turn)) {
    part->again = true;
    return;
  }
  r->across[i] += same;
  if (r->leaf == part->leaf ? sg_arranged_polygon(r->a, row) < part->p
                            : is_before(r, part)) {
    part->second = true;
  }
}

static void
pass(void *data, uint32_t row, int turns)
{
  asked *r = data;

  r->here += turns * weight_of(r, row);
}

static void
arrive(void *data, size_t i)
{
  asked *r = data;

  r->turns[i] = r->here;
}

static bool
walk(asked *r, const sg_cancel *cancel)
{
  const sg_point **at = malloc((r->n + 1) * sizeof *at);
  sg_tour way = {.tree = r->a->leaf[r->leaf].tree->boxes,
                 .data = r,
                 .corners = read_corners,
                 .pass = pass,
                 .on = lies_on,
                 .arrive = arrive};
  bool good = at != NULL;

  for (size_t i = 0; good && i < r->n; i++) {
    at[i] = &r->a->part[r->part[i]].at;
  }
  r->here = 0;
  good = good && sg_tour_over(&way, at, r->n, cancel);
  free(at);
  return good;
}

/* ---- sides ---- */

static bool
new_side(sg_arrangement *a, uint32_t part, const sg_side *side)
{
  if (!sg_list_grow(&a->side, a->sides, &a->side_room, sizeof *a->side)) {
    return false;
  }
  a->side[a->sides++] = *side;
  a->part[part].sides++;
  return true;
}

/* Sides are collected leaf by leaf: with their components, to be sorted. */
typedef struct found {
  uint32_t part;
  sg_side side;
} found;

typedef struct founds {
  found *item;
  size_t n, room;
} founds;

static bool
find(founds *f, const found *one)
{
  if (!sg_list_grow(&f->item, f->n, &f->room, sizeof *f->item)) {
    return false;
  }
  f->item[f->n++] = *one;
  return true;
}

static bool
keep_sides(const asked *r, founds *f)
{
  for (size_t i = 0; i < r->n; i++) {
    const sg_part *part = &r->a->part[r->part[i]];
    bool above = begins(part->normal) > 0;
    const sg_arranged *leaf = &r->a->leaf[r->leaf];
    sg_side side = {leaf->s, r->turns[i], r->turns[i]};

    if (leaf->surface) {
      side.below = side.above = 0;
    } else if (above) {
      side.below += r->across[i];
    } else {
      side.above -= r->across[i];
    }
    if ((side.below != 0 || side.above != 0 || r->leaf == part->leaf) &&
        !find(f, &(found){r->part[i], side})) {
      return false;
    }
  }
  return true;
}

static bool
sides_of_leaf(asked *r, founds *f, const sg_cancel *cancel)
{
  bool good;

  if (r->n == 0 || r->a->leaf[r->leaf].tree->boxes->n == 0) {
    return true;
  }
  r->turns = calloc(r->n, sizeof *r->turns);
  r->across = calloc(r->n, sizeof *r->across);
  good = r->turns && r->across && walk(r, cancel) && keep_sides(r, f);
  free(r->turns);
  free(r->across);
  return good;
}

/* The components to be asked for a leaf. */
static void
choose_points(asked *r, const uint32_t (*near)[2], size_t n,
              const size_t *first, const uint32_t *order)
{
  r->n = 0;
  for (size_t i = 0; i < n; i++) {
    uint32_t leaf = near[i][1];

    if (i > 0 && near[i - 1][1] == leaf) {
      continue;
    }
    for (size_t k = first[leaf]; k < first[leaf + 1]; k++) {
      sg_part *part = &r->a->part[order[k]];

      if (!part->unknown && part->sides == 0 &&
          may_be_round(&r->a->leaf[r->leaf].tree->box, &part->at)) {
        r->part[r->n++] = order[k];
      }
    }
  }
}

static bool
ask_all(sg_arrangement *a, founds *f, const sg_cancel *cancel)
{
  size_t *first = NULL, n = 0;
  uint32_t *order = NULL, (*near)[2] = near_leaves(a, &n);
  asked r = {.a = a, .part = malloc((a->parts + 1) * sizeof *r.part)};
  bool good = near && r.part && sort_parts(a, &first, &order);

  for (size_t i = 0, end; i < n && good; i = end) {
    for (end = i; end < n && near[end][0] == near[i][0]; end++) {
    }
    r.leaf = near[i][0];
    choose_points(&r, (const uint32_t(*)[2])near + i, end - i, first, order);
    good = sides_of_leaf(&r, f, cancel);
  }
  free(near);
  free(order);
  free(first);
  free(r.part);
  return good;
}

SG_ORDER(compare_found, found, SG_BY(part) SG_BY(side.s));

/* The sides of components whose points are good. */
static bool
take_sides(sg_arrangement *a, founds *f)
{
  if (f->n > 0) {
    qsort(f->item, f->n, sizeof *f->item, compare_found);
  }
  for (size_t i = 0; i < f->n; i++) {
    sg_part *part = &a->part[f->item[i].part];

    if (part->again) {
      continue;
    }
    if (part->sides == 0) {
      part->side = a->sides;
    }
    if (!new_side(a, f->item[i].part, &f->item[i].side)) {
      return false;
    }
  }
  return true;
}

/* Components whose point was on a border get another one. How many, or -1: no
 * memory, or stopped. */
static int64_t
move_points(sg_arrangement *a, const sg_cancel *cancel)
{
  int64_t n = 0;

  for (size_t i = 0; i < a->parts; i++) {
    sg_part *part = &a->part[i];

    if (part->again) {
      part->again = part->second = false;
      if ((i % 64 == 63 && sg_cancelled(cancel)) ||
          !sg_arrangement_point(a, part)) {
        return -1;
      }
      n += !part->unknown;
    }
  }
  return n;
}

/* The sides of all components (arrangement_side.c). */
static bool
find_all_sides(sg_arrangement *a, const sg_cancel *cancel)
{
  int64_t left = 1;

  for (int i = 0; i < TRIES && left > 0; i++) {
    founds f = {0};
    bool good = ask_all(a, &f, cancel) && take_sides(a, &f);

    free(f.item);
    left = good ? move_points(a, cancel) : -1;
  }
  for (size_t i = 0; i < a->parts; i++) { /* no point was good */
    a->part[i].unknown = a->part[i].unknown || a->part[i].sides == 0;
  }
  return left >= 0;
}

/* ---- what was found ---- */

bool
sg_arrangement_seal(sg_arrangement *a, sg_pool *pool, const sg_cancel *cancel)
{
  return sg_arrangement_find_auxiliary(a, pool, cancel) &&
         sg_arrangement_flood(a, pool, cancel) &&
         sg_arrangement_find_made(a, pool, cancel) &&
         sg_arrangement_find_parts(a, pool, cancel) &&
         find_all_sides(a, cancel);
}

size_t
sg_arrangement_components(const sg_arrangement *a, int32_t s)
{
  uint32_t leaf = sg_arrangement_leaf(a, s);

  return leaf == SG_NO_KEY ? 0 : a->leaf[leaf].parts;
}

sg_component
sg_arrangement_component(const sg_arrangement *a, int32_t s, size_t c)
{
  const sg_arranged *leaf = &a->leaf[sg_arrangement_leaf(a, s)];
  const sg_part *part = &a->part[leaf->first_part + c];

  return (sg_component){.s = s,
                        .p = part->p,
                        .at = &part->at,
                        .side = a->side + part->side,
                        .sides = part->sides,
                        .second = part->second,
                        .unknown = part->unknown};
}
