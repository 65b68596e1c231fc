/* arrangement_point.c -- a point inside a piece: see arrangement.h.
 *
 * Layer: kernel. The point must lie on the leaf itself, exactly: where faces of
 * two leaves lie on each other, it decides whether it is on both. A polygon
 * that is flat only within the tolerance was triangulated anew, so a point
 * inside a triangle of a cell is moved, along the axis by which the polygon is
 * seen, to the leaf triangle there.
 */
#include "arrangement_private.h"
#include "engine/search.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WEIGHTS = 8, SIXTEEN = 16 };

/* Points of a triangle: sixteenths of its corners. */
static const int weight[WEIGHTS][3] = {{6, 5, 5},  {7, 5, 4}, {4, 5, 7},
                                       {5, 8, 3},  {9, 4, 3}, {3, 4, 9},
                                       {2, 3, 11}, {11, 3, 2}};

static void
init3(mpq_t q[3])
{
  for (int k = 0; k < 3; k++) {
    mpq_init(q[k]);
  }
}

static void
clear3(mpq_t q[3])
{
  for (int k = 0; k < 3; k++) {
    mpq_clear(q[k]);
  }
}

/* out := the point with these weights. */
static void
weigh(const sg_point corner[3], const int *w, mpq_t out[3])
{
  mpq_t term, factor;

  mpq_init(term);
  mpq_init(factor);
  for (int k = 0; k < 3; k++) {
    mpq_set_ui(out[k], 0, 1);
    for (int c = 0; c < 3; c++) {
      mpq_t *exact = sg_point_q(&corner[c]);

      if (exact) {
        mpq_set(term, exact[k]);
      } else {
        mpq_set_d(term, corner[c].p[k]);
      }
      mpq_set_ui(factor, (unsigned long)w[c], SIXTEEN);
      mpq_canonicalize(factor);
      mpq_mul(term, term, factor);
      mpq_add(out[k], out[k], term);
    }
  }
  mpq_clear(term);
  mpq_clear(factor);
}

/* The corners of a leaf triangle, and the signs of its normal; false: it has
 * no area. */
static bool
leaf_corners(const sg_arrangement *a, uint32_t leaf, uint32_t row,
             sg_point corner[3], int normal[3])
{
  int32_t v[3];

  sg_arranged_corners(a, row, v);
  for (int c = 0; c < 3; c++) {
    double at[3] = {0};

    sg_leaf_vertex_at(a->leaf[leaf].tree, a->leaves.views, v[c], at);
    sg_point_set(&corner[c], at);
  }
  for (int k = 0; k < 3; k++) {
    normal[k] = sg_point_turn(k, &corner[0], &corner[1], &corner[2]);
  }
  return normal[0] != 0 || normal[1] != 0 || normal[2] != 0;
}

/* ---- of a polygon that is not cut ---- */

static bool
row_point(const sg_arrangement *a, sg_part *part)
{
  sg_point corner[3];
  mpq_t q[3];
  bool good = true;

  if (!leaf_corners(a, part->leaf, part->row, corner, part->normal) ||
      part->tries >= WEIGHTS) {
    return true;
  }
  part->p = sg_arranged_polygon(a, part->row);
  init3(q);
  weigh(corner, weight[part->tries++], q);
  good = sg_point_set_q(&part->at, q[0], q[1], q[2]);
  part->unknown = !good;
  clear3(q);
  return good;
}

/* ---- of a cell ---- */

/* The corners of a cell's triangle: copies, to be cleared. */
static void
corners_of_cell(const sg_arrangement *a, const sg_cell *cell,
                const sg_cell_triangle *triangle, sg_point out[3])
{
  const sg_arranged *leaf = &a->leaf[cell->leaf];
  const sg_cut_points *points = &a->leaves.set->points;

  for (int c = 0; c < 3; c++) {
    int32_t v = triangle->v[c];
    double at[3] = {0};

    if (sg_leaf_vertex_at(leaf->tree, a->leaves.views, v, at)) {
      sg_point_set(&out[c], at);
    } else {
      sg_point_copy(&out[c],
                    &points->point[sg_cut_points_named(points, leaf->s, v)].at);
    }
  }
}

static void
clear_corners(sg_point corner[3])
{
  for (int c = 0; c < 3; c++) {
    sg_point_clear(&corner[c]);
  }
}

/* Twice the size of a cell's triangle, as its polygon is seen; rounded. */
static double
size_of(const sg_arrangement *a, const sg_cell *cell, size_t i)
{
  sg_point corner[3];
  int u = (cell->axis + 1) % 3, v = (cell->axis + 2) % 3;

  corners_of_cell(a, cell, &a->triangle[cell->first + i], corner);
  const double *p = corner[0].p, *q = corner[1].p, *r = corner[2].p;
  double size = (q[u] - p[u]) * (r[v] - p[v]) - (q[v] - p[v]) * (r[u] - p[u]);

  clear_corners(corner);
  return fabs(size);
}

/* Triangle 0 is the largest of the cell, then they come in order. */
static size_t
triangle_of(const sg_arrangement *a, const sg_cell *cell, unsigned rank)
{
  size_t best = 0;
  double most = -1;

  if (rank > 0) {
    return rank - 1;
  }
  for (size_t i = 0; i < cell->n; i++) {
    double size = size_of(a, cell, i);

    if (size > most) {
      most = size;
      best = i;
    }
  }
  return best;
}

/* q[axis] := where the plane of the corners is above q's other two. */
static void
lift(int axis, const sg_point corner[3], mpq_t q[3])
{
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  mpq_t d[2][3], n[3], t;

  init3(d[0]);
  init3(d[1]);
  init3(n);
  mpq_init(t);
  for (int i = 0; i < 2; i++) {
    for (int k = 0; k < 3; k++) {
      mpq_set_d(d[i][k], corner[i + 1].p[k]);
      mpq_set_d(t, corner[0].p[k]);
      mpq_sub(d[i][k], d[i][k], t);
    }
  }
  for (int k = 0; k < 3; k++) {
    int g = (k + 1) % 3, h = (k + 2) % 3;

    mpq_mul(n[k], d[0][g], d[1][h]);
    mpq_mul(t, d[0][h], d[1][g]);
    mpq_sub(n[k], n[k], t);
  }
  mpq_set_ui(q[axis], 0, 1);
  for (int i = 0; i < 2; i++) {
    int k = i == 0 ? u : v;

    mpq_set_d(t, corner[0].p[k]);
    mpq_sub(t, q[k], t);
    mpq_mul(t, t, n[k]);
    mpq_sub(q[axis], q[axis], t);
  }
  mpq_div(q[axis], q[axis], n[axis]);
  mpq_set_d(t, corner[0].p[axis]);
  mpq_add(q[axis], q[axis], t);
  clear3(d[0]);
  clear3(d[1]);
  clear3(n);
  mpq_clear(t);
}

/* The first leaf triangle of a polygon that is cut. */
static size_t
first_cut_row(const sg_arrangement *a, uint32_t leaf, int32_t p)
{
  const sg_cut_row_of *row = a->cut_row;
  size_t at;

  SG_SEARCH(at, 0, a->cut_rows,
            row[at].leaf < leaf || (row[at].leaf == leaf && row[at].p < p));
  return at;
}

/* Whether q is inside the corners, seen along the axis. */
static bool
is_inside(int axis, const sg_point corner[3], const sg_point *q)
{
  int turn = sg_point_turn(axis, &corner[0], &corner[1], &corner[2]);

  return turn != 0 && sg_point_turn(axis, &corner[0], &corner[1], q) == turn &&
         sg_point_turn(axis, &corner[1], &corner[2], q) == turn &&
         sg_point_turn(axis, &corner[2], &corner[0], q) == turn;
}

/* Moves q to the leaf triangle of the cell's polygon there; *found = false:
 * there is none. False: no memory. */
static bool
lower(const sg_arrangement *a, const sg_cell *cell, mpq_t q[3], sg_part *part,
      bool *found)
{
  sg_point seen, corner[3];

  *found = false;
  if (!sg_point_set_q(&seen, q[0], q[1], q[2])) {
    return false;
  }
  for (size_t i = first_cut_row(a, cell->leaf, cell->p);
       i < a->cut_rows && a->cut_row[i].leaf == cell->leaf &&
       a->cut_row[i].p == cell->p && !*found;
       i++) {
    *found =
        leaf_corners(a, cell->leaf, a->cut_row[i].row, corner, part->normal) &&
        is_inside(cell->axis, corner, &seen);
    part->row = a->cut_row[i].row;
  }
  sg_point_clear(&seen);
  if (*found) {
    lift(cell->axis, corner, q);
  }
  return true;
}

static bool
cell_point(const sg_arrangement *a, sg_part *part)
{
  const sg_cell *cell = &a->cell[part->of];
  bool good = true, found = false;
  mpq_t q[3];

  init3(q);
  part->p = cell->p;
  for (; good && !found && part->tries / WEIGHTS <= cell->n; part->tries++) {
    size_t i = triangle_of(a, cell, part->tries / WEIGHTS);
    sg_point corner[3];

    corners_of_cell(a, cell, &a->triangle[cell->first + i], corner);
    if (sg_point_turn(cell->axis, &corner[0], &corner[1], &corner[2]) != 0) {
      weigh((const sg_point *)corner, weight[part->tries % WEIGHTS], q);
      good = lower(a, cell, q, part, &found);
    }
    clear_corners(corner);
  }
  if (good && found) {
    good = sg_point_set_q(&part->at, q[0], q[1], q[2]);
    part->unknown = !good;
  }
  clear3(q);
  return good;
}

bool
sg_arrangement_point(const sg_arrangement *a, sg_part *part)
{
  sg_point_clear(&part->at);
  part->unknown = true;
  return part->cut ? cell_point(a, part) : row_point(a, part);
}
