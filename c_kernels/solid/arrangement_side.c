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
#include "join/bvh_join.h"
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

/* The components by leaf. Null: no memory. */
static uint32_t *
sort_parts(const sg_arrangement *a)
{
  size_t *first = calloc(a->leaves.n + 1, sizeof *first);
  uint32_t *order = malloc((a->parts + 1) * sizeof *order);

  for (size_t i = 0; first && i < a->parts; i++) {
    first[a->part[i].leaf + 1]++;
  }
  for (size_t i = 1; first && i < a->leaves.n; i++) {
    first[i] += first[i - 1];
  }
  for (uint32_t i = 0; first && order && i < a->parts; i++) {
    order[first[a->part[i].leaf]++] = i;
  }
  if (!first) {
    free(order);
    order = NULL;
  }
  free(first);
  return order;
}

/* Where the point of a component is. */
static sg_box
point_box(const sg_part *part)
{
  sg_box box;

  for (int k = 0; k < 3; k++) {
    box.lo[k] = nextafter(part->at.p[k], -INFINITY);
    box.hi[k] = nextafter(part->at.p[k], INFINITY);
  }
  return box;
}

/* A tree of the points of components, empty ones of those that are not asked.
 * Null: no memory, or stopped. */
static sg_bvh *
tree_of_points(const sg_arrangement *a, const uint32_t *order,
               const sg_cancel *cancel)
{
  sg_box *box = malloc((a->parts + 1) * sizeof *box);

  for (size_t i = 0; box && i < a->parts; i++) {
    const sg_part *part = &a->part[order[i]];

    box[i] = part->unknown || part->sides > 0 ? sg_box_none() : point_box(part);
  }
  sg_bvh *tree = box ? sg_bvh_open(box, a->parts, cancel) : NULL;

  free(box);
  return tree;
}

/* The same of the boxes of leaves. */
static sg_bvh *
tree_of_leaves(const sg_arrangement *a, const sg_cancel *cancel)
{
  sg_box *box = malloc((a->leaves.n + 1) * sizeof *box);

  for (size_t i = 0; box && i < a->leaves.n; i++) {
    box[i] = a->leaf[i].tree->box;
  }
  sg_bvh *tree = box ? sg_bvh_open(box, a->leaves.n, cancel) : NULL;

  free(box);
  return tree;
}

SG_ORDER(compare_hits, sg_bvh_hit, SG_BY(a) SG_BY(b));

/* Leaves (a) and places in order[] of the components (b) whose points are in
 * their boxes, ascending. False: no memory, or stopped. */
static bool
find_points(const sg_arrangement *a, const uint32_t *order, sg_bvh_hits *out,
            const sg_cancel *cancel)
{
  sg_bvh *points = tree_of_points(a, order, cancel);
  sg_bvh *leaves = tree_of_leaves(a, cancel);
  const sg_bvh_pair pair = {leaves, points};
  size_t n = 0;
  bool good = points && leaves && sg_bvh_join(&pair, 1, 0, NULL, cancel, out);

  for (size_t i = 0; good && i < out->n; i++) {
    uint32_t leaf = leaves->item[out->hit[i].a];
    uint32_t at = points->item[out->hit[i].b];
    sg_box box = point_box(&a->part[order[at]]);

    if (sg_box_overlap(&box, &a->leaf[leaf].tree->box, 0)) {
      out->hit[n++] = (sg_bvh_hit){0, leaf, at};
    }
  }
  out->n = n;
  if (n > 0) {
    qsort(out->hit, n, sizeof *out->hit, compare_hits);
  }
  sg_bvh_close(points);
  sg_bvh_close(leaves);
  return good;
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

static bool
ask_all(sg_arrangement *a, founds *f, const sg_cancel *cancel)
{
  uint32_t *order = sort_parts(a);
  sg_bvh_hits hits = {0};
  asked r = {.a = a, .part = malloc((a->parts + 1) * sizeof *r.part)};
  bool good = order && r.part && find_points(a, order, &hits, cancel);

  for (size_t i = 0; i < hits.n && good;) {
    r.leaf = hits.hit[i].a;
    for (r.n = 0; i < hits.n && hits.hit[i].a == r.leaf; i++) {
      r.part[r.n++] = order[hits.hit[i].b];
    }
    good = sides_of_leaf(&r, f, cancel);
  }
  free(hits.hit);
  free(order);
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
