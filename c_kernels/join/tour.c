/* tour.c -- a walk over points: see tour.h.
 *
 * The points are in a tree of boxes, and the walk visits its nodes from the
 * top down. What is near a node is looked for in what is near the one above it:
 * triangles, and nodes of the tree of triangles that are smaller than it.
 */
#include "tour.h"

#include "engine/list.h"
#include "winding.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

enum { ASKED = 1 << 12 };

/* A node of the tree of triangles; of level 0: a triangle. */
typedef struct node {
  sg_box32 box;
  unsigned level;
  uint32_t at;
  int turns; /* of a triangle: what the last step passed of it */
} node;

typedef struct walker {
  const sg_tour *walk;
  const sg_point *const *at;
  const sg_bvh *points;
  const sg_cancel *cancel;
  sg_bvh_frame frame; /* of the triangles */
  double here[3];
  unsigned steps;
  bool failed; /* no memory, or stopped */
  node *near;  /* [n]: lists, each over that of the node above */
  size_t n, room;
} walker;

/* A part of walker.near. */
typedef struct list {
  size_t begin, end;
} list;

/* ---- exact signs ---- */

/* The turn a, b, p seen along an axis, p shifted: never 0 unless a and b are
 * seen in one place. */
static int
shifted_turn(int axis, const sg_point *a, const sg_point *b, const sg_point *p)
{
  int turn = sg_point_turn(axis, a, b, p), y = sg_point_compare(1, a, b);

  if (turn == 0 && axis == 0) {
    turn = sg_point_compare(2, a, b);
  } else if (turn == 0) {
    turn = axis == 1 ? sg_point_compare(0, a, b) : -sg_point_compare(0, a, b);
  }
  if (turn == 0) {
    turn = axis == 1 ? sg_point_compare(2, a, b) : -y;
  }
  return turn;
}

/* 1 if p, shifted, is below the triangle, else -1; it has an area. */
static int
shifted_side(const sg_point corner[3], const sg_point *p)
{
  static const int axis[3] = {1, 2, 0}, way[3] = {-1, -1, 1};
  int side = sg_point_orient3d(&corner[0], &corner[1], &corner[2], p);

  for (int k = 0; side == 0 && k < 3; k++) {
    side = way[k] * sg_point_turn(axis[k], &corner[0], &corner[1], &corner[2]);
  }
  return side;
}

/* How many more times the triangle goes round b than a, which differ along one
 * axis: 1, 0, -1. */
static int
passed(int axis, const sg_point corner[3], const sg_point *a, const sg_point *b)
{
  int turn = sg_point_turn(axis, &corner[0], &corner[1], &corner[2]);

  if (turn == 0 || shifted_turn(axis, &corner[0], &corner[1], a) != turn ||
      shifted_turn(axis, &corner[1], &corner[2], a) != turn ||
      shifted_turn(axis, &corner[2], &corner[0], a) != turn) {
    return 0;
  }
  return turn * ((shifted_side(corner, b) == turn) -
                 (shifted_side(corner, a) == turn));
}

/* ---- what is plainly apart ---- */

/* From the middle of a box, and half of its sides. */
typedef struct middle {
  double at[3], half[3];
} middle;

/* Whether a box is plainly beyond an edge of triangle t as it is seen along an
 * axis. What is rounded is far below 2^-40 of what is added. */
static bool
beyond_edge(const double t[3][3], int i, int axis, const middle *box)
{
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const double *p = t[i], *q = t[(i + 1) % 3], *r = t[(i + 2) % 3];
  double eu = q[u] - p[u], ev = q[v] - p[v];
  double bu = box->at[u] - p[u], bv = box->at[v] - p[v];
  double ru = r[u] - p[u], rv = r[v] - p[v];
  double third = eu * rv - ev * ru, at = eu * bv - ev * bu;
  double reach = fabs(eu) * box->half[v] + fabs(ev) * box->half[u];
  double off = 0x1p-40 * (fabs(eu) * (fabs(bv) + fabs(rv)) +
                          fabs(ev) * (fabs(bu) + fabs(ru)) + reach) +
               0x1p-1000;

  return at + reach < fmin(third, 0) - off || at - reach > fmax(third, 0) + off;
}

/* Whether it is plainly above or below the triangle's plane. */
static bool
beyond_plane(const double t[3][3], const middle *box)
{
  double at = 0, reach = 0, off = 0x1p-1000;

  for (int k = 0; k < 3; k++) {
    int u = (k + 1) % 3, v = (k + 2) % 3;
    double d = (t[1][u] - t[0][u]) * (t[2][v] - t[0][v]);
    double e = (t[1][v] - t[0][v]) * (t[2][u] - t[0][u]);

    at += (d - e) * (box->at[k] - t[0][k]);
    reach += fabs(d - e) * box->half[k];
    off += 0x1p-40 * (fabs(d) + fabs(e)) *
           (fabs(box->at[k] - t[0][k]) + box->half[k]);
  }
  return fabs(at) > reach + off;
}

static bool
is_apart(const double t[3][3], const sg_box *box)
{
  middle m;

  for (int k = 0; k < 3; k++) {
    m.at[k] = 0.5 * box->lo[k] + 0.5 * box->hi[k];
    m.half[k] = fmax(box->hi[k] - m.at[k], m.at[k] - box->lo[k]);
  }
  for (int k = 0; k < 9; k++) {
    if (beyond_edge(t, k / 3, k % 3, &m)) {
      return true;
    }
  }
  return beyond_plane(t, &m);
}

static bool
overlap(const sg_box32 *a, const sg_box32 *b)
{
  for (int k = 0; k < 3; k++) {
    if (a->lo[k] > b->hi[k] || b->lo[k] > a->hi[k]) {
      return false;
    }
  }
  return true;
}

/* ---- trees ---- */

static float
longest_side(const sg_box32 *box)
{
  float side = 0;

  for (int k = 0; k < 3; k++) {
    side = fmaxf(side, box->hi[k] - box->lo[k]);
  }
  return side;
}

static node
node_of(const sg_bvh *tree, unsigned level, uint32_t at)
{
  return (node){sg_bvh_box(tree, level, at), level, at, 0};
}

/* The nodes below one: from SG_BVH_WIDTH * at to before this. */
static uint32_t
end_below(const sg_bvh *tree, unsigned level, uint32_t at)
{
  size_t end = SG_BVH_WIDTH * ((size_t)at + 1);

  return (uint32_t)(end < tree->count[level - 1] ? end
                                                 : tree->count[level - 1]);
}

/* The box of a node of the points; of level 0: round the point alone. */
static sg_box
box_of_points(const walker *k, unsigned level, uint32_t at)
{
  const sg_bvh *tree = k->points;
  sg_box32 near = sg_bvh_box(tree, level, at);
  sg_box box;

  for (int c = 0; c < 3; c++) {
    const double p = k->at[tree->item[level == 0 ? at : 0]]->p[c];

    box.lo[c] = level == 0 ? nextafter(p, -INFINITY)
                           : tree->origin[c] + tree->unit * near.lo[c];
    box.hi[c] = level == 0 ? nextafter(p, INFINITY)
                           : tree->origin[c] + tree->unit * near.hi[c];
  }
  return box;
}

static void
put(walker *k, const node *one)
{
  if (!sg_list_grow(&k->near, k->n, &k->room, sizeof *k->near)) {
    k->failed = true;
    return;
  }
  k->near[k->n++] = *one;
}

/* ---- walking ---- */

static void
corners_of(const walker *k, uint32_t at, double out[3][3])
{
  k->walk->corners(k->walk->data, k->walk->tree->item[at], out);
}

static void
points_of(const double t[3][3], sg_point out[3])
{
  for (int i = 0; i < 3; i++) {
    sg_point_set(&out[i], t[i]);
  }
}

static bool
is_stopped(walker *k)
{
  k->failed = k->failed || (++k->steps % ASKED == 0 && sg_cancelled(k->cancel));
  return k->failed;
}

/* A part of the way, along one axis. */
typedef struct leg {
  int axis;
  sg_point from, to;
  sg_box box;
  sg_box32 box32;
} leg;

static void
pass_below(walker *k, const leg *way, const node *one)
{
  double t[3][3];
  sg_point corner[3];
  int turns;

  if (is_stopped(k) || !overlap(&one->box, &way->box32)) {
    return;
  }
  if (one->level == 0) {
    corners_of(k, one->at, t);
    if (!is_apart((const double(*)[3])t, &way->box)) {
      points_of((const double(*)[3])t, corner);
      turns = passed(way->axis, corner, &way->from, &way->to);
      if (turns != 0) {
        k->walk->pass(k->walk->data, k->walk->tree->item[one->at], turns);
      }
    }
    return;
  }
  uint32_t end = end_below(k->walk->tree, one->level, one->at);

  for (uint32_t i = SG_BVH_WIDTH * one->at; i < end; i++) {
    node below = node_of(k->walk->tree, one->level - 1, i);

    pass_below(k, way, &below);
  }
}

/* From here to another place, among what is near both. */
static void
go(walker *k, list near, const double to[3])
{
  for (int axis = 0; axis < 3; axis++) {
    leg way = {.axis = axis, .box = sg_box_none()};

    if (k->here[axis] == to[axis]) {
      continue;
    }
    sg_point_set(&way.from, k->here);
    sg_box_add(&way.box, k->here);
    k->here[axis] = to[axis];
    sg_point_set(&way.to, k->here);
    sg_box_add(&way.box, k->here);
    way.box32 = sg_box_let_out(&k->frame, &way.box);
    for (size_t i = near.begin; i < near.end; i++) {
      pass_below(k, &way, &k->near[i]);
    }
  }
}

/* Puts what of a node is near a box: opened, as long as it is longer than
 * `side`. */
static void
put_near(walker *k, const node *one, const sg_box *box, const sg_box32 *box32,
         float side)
{
  double t[3][3];

  if (is_stopped(k) || !overlap(&one->box, box32)) {
    return;
  }
  if (one->level == 0) {
    corners_of(k, one->at, t);
  }
  if (one->level == 0 ? !is_apart((const double(*)[3])t, box)
                      : longest_side(&one->box) <= side) {
    put(k, one);
  } else if (one->level > 0) {
    uint32_t end = end_below(k->walk->tree, one->level, one->at);

    for (uint32_t i = SG_BVH_WIDTH * one->at; i < end; i++) {
      node below = node_of(k->walk->tree, one->level - 1, i);

      put_near(k, &below, box, box32, side);
    }
  }
}

/* ---- at a point ---- */

/* The places between the double nearest to a point and the point. False: no
 * memory. */
static bool
find_steps(const sg_point *p, sg_point step[4])
{
  mpq_t *exact = sg_point_q(p), q[3];
  bool good = exact != NULL;

  for (int k = 0; k < 3; k++) {
    mpq_init(q[k]);
    mpq_set_d(q[k], p->p[k]);
  }
  sg_point_set(&step[0], p->p);
  for (int k = 0; k < 3; k++) {
    step[k + 1] = step[0];
    if (good) {
      mpq_set(q[k], exact[k]);
      good = sg_point_set_q(&step[k + 1], q[0], q[1], q[2]);
    }
  }
  for (int k = 0; k < 3; k++) {
    mpq_clear(q[k]);
  }
  return good;
}

/* From the double nearest to a point to the point itself. */
static void
step_to(walker *k, list near, const sg_point *p)
{
  sg_point step[4], corner[3];
  double t[3][3];

  if (!p->exactly || near.begin == near.end) {
    return;
  }
  k->failed = !find_steps(p, step) || k->failed;
  for (size_t i = near.begin; i < near.end && !k->failed; i++) {
    node *one = &k->near[i];

    corners_of(k, one->at, t);
    points_of((const double(*)[3])t, corner);
    for (int axis = 0; axis < 3; axis++) {
      one->turns += passed(axis, corner, &step[axis], &step[axis + 1]);
    }
  }
  for (int i = 1; i < 4; i++) {
    sg_point_clear(&step[i]);
  }
}

/* To the point, or back. */
static void
pass_step(walker *k, list near, int way)
{
  for (size_t i = near.begin; i < near.end; i++) {
    const node *one = &k->near[i];

    if (one->turns != 0) {
      k->walk->pass(k->walk->data, k->walk->tree->item[one->at],
                    way * one->turns);
    }
  }
}

static void
stop_at(walker *k, list near, size_t point)
{
  const sg_tour *walk = k->walk;
  const sg_point *p = k->at[point];
  sg_point corner[3];
  double t[3][3];

  for (size_t i = near.begin; i < near.end && !is_stopped(k); i++) {
    uint32_t at = k->near[i].at;

    corners_of(k, at, t);
    points_of((const double(*)[3])t, corner);
    if (sg_is_on_triangle(&corner[0], &corner[1], &corner[2], p)) {
      walk->on(walk->data, point, walk->tree->item[at]);
    }
  }
  step_to(k, near, p);
  pass_step(k, near, 1);
  walk->arrive(walk->data, point);
  pass_step(k, near, -1);
}

/* ---- all points ---- */

/* Goes to a node of the points, and over all that is below. `above` is what is
 * near where the walk comes from and the node. */
static void
visit(walker *k, list above, unsigned level, uint32_t at)
{
  size_t first = at, begin = k->n;
  sg_box box = box_of_points(k, level, at);
  sg_box32 box32 = sg_box_let_out(&k->frame, &box);
  float side = level == 0 ? -1 : longest_side(&box32);

  for (unsigned i = 0; i < level; i++) {
    first *= SG_BVH_WIDTH;
  }
  go(k, above, k->at[k->points->item[first]]->p);
  for (size_t i = above.begin; i < above.end; i++) {
    node one = k->near[i];

    put_near(k, &one, &box, &box32, side);
  }
  list near = {begin, k->n};

  if (level == 0 && !k->failed) {
    stop_at(k, near, k->points->item[at]);
  }
  uint32_t end = level == 0 ? 0 : end_below(k->points, level, at);

  for (uint32_t i = SG_BVH_WIDTH * at; i < end && !k->failed; i++) {
    visit(k, near, level - 1, i);
  }
  k->n = begin;
}

static sg_bvh *
plant(const sg_point *const *at, size_t n, const sg_cancel *cancel)
{
  sg_box *box = malloc((n + 1) * sizeof *box);
  sg_bvh *tree = NULL;

  for (size_t i = 0; box && i < n; i++) {
    for (int k = 0; k < 3; k++) {
      box[i].lo[k] = nextafter(at[i]->p[k], -INFINITY);
      box[i].hi[k] = nextafter(at[i]->p[k], INFINITY);
    }
  }
  if (box) {
    tree = sg_bvh_open(box, n, cancel);
  }
  free(box);
  return tree;
}

bool
sg_tour_over(const sg_tour *walk, const sg_point *const *at, size_t n,
             const sg_cancel *cancel)
{
  const sg_bvh *tree = walk->tree;
  walker k = {.walk = walk, .at = at, .cancel = cancel};
  node top;

  if (n == 0 || !(k.points = plant(at, n, cancel))) {
    return n == 0;
  }
  for (int c = 0; c < 3; c++) {
    k.frame.origin[c] = tree->origin[c];
    k.here[c] = at[k.points->item[0]]->p[c];
  }
  k.frame.unit = tree->unit;
  if (tree->n > 0) {
    k.here[0] = nextafter(fmax(k.here[0], tree->all.hi[0]), DBL_MAX);
    top = node_of(tree, tree->levels - 1, 0);
    put(&k, &top);
  }
  if (!k.failed) {
    visit(&k, (list){0, k.n}, k.points->levels - 1, 0);
  }
  free(k.near);
  sg_bvh_close((sg_bvh *)k.points);
  return !k.failed;
}
