/* hide_near.c -- how near masks come in a cell of their grid: see
 * hide_search.h. */
#include "hide_search_private.h"

#include "number/bounds.h"
#include "rows/sort.h"

#include <stdatomic.h>
#include <stdlib.h>

/* A cell and what is near it; both in the grid's own x and y. */
typedef struct cell_box {
  double low[2], high[2];
} cell_box;

static cell_box
cell_at(const sg_grid *grid, size_t cell)
{
  const size_t at[2] = {cell % grid->nx, cell / grid->nx};
  double more = SG_REACH * grid->margin;
  cell_box out;

  for (int k = 0; k < 2; k++) {
    double low = grid->low[k] + (double)at[k] * grid->wide[k];
    out.low[k] = low - more;
    out.high[k] = low + grid->wide[k] + more;
  }
  return out;
}

/* Leaves of the box what is near the mask. */
static void
narrow(cell_box *box, const sg_grid_shape *mask, double more)
{
  for (int k = 0; k < 2; k++) {
    double x = mask->at[0][k], y = mask->at[1][k], z = mask->at[2][k];
    double low = sg_smaller(x, sg_smaller(y, z)) - more;
    double high = sg_larger(x, sg_larger(y, z)) + more;

    box->low[k] = sg_larger(box->low[k], low);
    box->high[k] = sg_smaller(box->high[k], high);
  }
}

/* A mask in the grid's own x and y, and how its depth rises along these. */
typedef struct turned {
  const sg_scene_mask *mask;
  sg_grid_shape shape;
  double depth, rise[2]; /* at the first corner */
} turned;

static turned
turned_mask(const sg_mask_grid *masks, uint32_t m)
{
  const sg_scene *scene = masks->scene;
  const sg_scene_mask *mask = &scene->mask[m];
  const double *way = masks->way, *n = mask->normal;
  turned out = {.mask = mask,
                .shape = {.corners = 3},
                .depth = scene->at[mask->v[0]][2],
                .rise = {-(n[0] * way[0] + n[1] * way[1]) / n[2],
                         -(n[1] * way[0] - n[0] * way[1]) / n[2]}};

  for (int k = 0; k < 3; k++) {
    memcpy(out.shape.at[k], scene->at[mask->v[k]], sizeof out.shape.at[k]);
  }
  sg_turn_shape(way, &out.shape);
  return out;
}

/* Makes its depths those behind a plane. */
static void
count_from(turned *of, const sg_near_plane *plane)
{
  of->depth -= sg_plane_depth(plane, of->shape.at[0]);
  for (int k = 0; k < 2; k++) {
    of->rise[k] -= plane->rise[k];
  }
}

static double
depth_at(const turned *of, const double at[2])
{
  return of->depth + of->rise[0] * (at[0] - of->shape.at[0][0]) +
         of->rise[1] * (at[1] - of->shape.at[0][1]);
}

/* The nearest point of the plane over the box, or the farthest one. */
static double
plane_in(const turned *of, const cell_box *box, bool far)
{
  double at[2];

  for (int k = 0; k < 2; k++) {
    at[k] = (of->rise[k] > 0.0) != far ? box->low[k] : box->high[k];
  }
  return depth_at(of, at);
}

/* What rounding may have taken from a depth. */
static double
slack_of(const turned *of)
{
  return SG_DEPTH_SLACK * (1.0 + fabs(of->rise[0]) + fabs(of->rise[1]));
}

/* How far p is to the left of q-r, times its length. */
static double
left_of(const double q[2], const double r[2], const double p[2])
{
  return (r[0] - q[0]) * (p[1] - q[1]) - (r[1] - q[1]) * (p[0] - q[0]);
}

/* A depth that no point of the mask's plane in the cell is nearer than, nor any
 * point of the mask. */
static double
near_in(const sg_mask_grid *masks, cell_box box, const turned *of)
{
  double least = INFINITY;

  narrow(&box, &of->shape, SG_REACH * masks->grid.margin);
  for (int k = 0; k < 3; k++) {
    least = sg_smaller(least, depth_at(of, of->shape.at[k]));
  }
  return sg_larger(plane_in(of, &box, false), least) - slack_of(of);
}

/* Whether all of the box is inside the mask. */
static bool
covers(const turned *of, const cell_box *box)
{
  for (int k = 0; k < 3; k++) {
    const double *p = of->shape.at[k], *q = of->shape.at[(k + 1) % 3];
    double worst[2] = {q[1] > p[1] ? box->high[0] : box->low[0],
                       q[0] > p[0] ? box->low[1] : box->high[1]};

    if (!(left_of(p, q, worst) > 0.0)) {
      return false;
    }
  }
  return true;
}

/* A depth that what a covering mask does not hide in the cell is nearer than.
 */
static double
far_in(const sg_scene *scene, const cell_box *box, const turned *of)
{
  return plane_in(of, box, true) + slack_of(of) +
         2 * scene->tolerance / of->mask->normal[2];
}

/* ---- what is seen ---- */

enum { STEEPEST = 64, ASKED = 32 };

/* The nearest mask at a point; SG_NO_MASK: there is none. */
static uint32_t
seen_at(const sg_mask_grid *masks, const uint32_t *item, uint32_t n,
        const double at[2])
{
  double near = INFINITY;
  uint32_t seen = SG_NO_MASK;

  for (uint32_t i = 0; i < n && masks->box[item[i]].low[2] < near; i++) {
    turned of = turned_mask(masks, item[i]);
    const double(*p)[2] = (const double(*)[2])of.shape.at;

    if (left_of(p[0], p[1], at) >= 0.0 && left_of(p[1], p[2], at) >= 0.0 &&
        left_of(p[2], p[0], at) >= 0.0 && depth_at(&of, at) < near) {
      near = depth_at(&of, at);
      seen = item[i];
    }
  }
  return seen;
}

/* How many of some masks are behind the plane in the cell. */
static unsigned
behind_plane(const sg_mask_grid *masks, const uint32_t *item, uint32_t n,
             const cell_box *box, const sg_near_plane *plane)
{
  unsigned behind = 0;

  for (uint32_t i = 0; i < n; i += n / ASKED + 1) {
    turned of = turned_mask(masks, item[i]);

    count_from(&of, plane);
    behind += near_in(masks, *box, &of) > -masks->scene->tolerance;
  }
  return behind;
}

/* The plane of a mask. */
static sg_near_plane
plane_of(const sg_mask_grid *masks, uint32_t m)
{
  turned of = turned_mask(masks, m);

  return (sg_near_plane){depth_at(&of, (double[2]){0.0, 0.0}),
                         {of.rise[0], of.rise[1]}};
}

/* What is seen in places of the cell, and the plane of one of these. */
static void
find_seen(const sg_mask_grid *masks, const uint32_t *item, uint32_t n,
          const cell_box *box, sg_mask_near *out)
{
  static const double place[SG_SEEN_PLACES][2] = {
      {0.5, 0.5}, {0.2, 0.3}, {0.7, 0.2}, {0.3, 0.8}, {0.8, 0.7}};
  unsigned most = 0;

  for (size_t i = 0; i < SG_SEEN_PLACES; i++) {
    double at[2];

    for (int k = 0; k < 2; k++) {
      at[k] = box->low[k] + place[i][k] * (box->high[k] - box->low[k]);
    }
    out->seen[i] = seen_at(masks, item, n, at);
    if (out->seen[i] != SG_NO_MASK) {
      sg_near_plane plane = plane_of(masks, out->seen[i]);
      bool steep = fabs(plane.rise[0]) + fabs(plane.rise[1]) > STEEPEST;
      unsigned behind = steep ? 0 : behind_plane(masks, item, n, box, &plane);

      if (behind > most) {
        most = behind;
        out->plane = plane;
      }
    }
  }
}

/* ---- the cell ---- */

/* Puts those that come nearer than `far` first. */
static uint32_t
part(sg_mask_order *key, uint32_t n, float far)
{
  uint32_t front = 0;

  for (uint32_t i = 0; i < n; i++) {
    if (key[i] >> 32 < sg_depth_order(far)) {
      sg_mask_order moved = key[i];
      key[i] = key[front];
      key[front++] = moved;
    }
  }
  return front;
}

/* For the caller to free. */
static sg_mask_near *
look_at_cell(const sg_mask_grid *masks, size_t cell)
{
  const uint32_t *item = masks->grid.item + masks->grid.start[cell];
  uint32_t n = masks->grid.start[cell + 1] - masks->grid.start[cell];
  sg_mask_near *near = malloc(sizeof *near + n * sizeof *near->order);
  cell_box box = cell_at(&masks->grid, cell);
  double far = INFINITY;

  if (!near) {
    return NULL;
  }
  *near = (sg_mask_near){.cover = SG_NO_MASK, .front = n, .n = n};
  find_seen(masks, item, n, &box, near);
  for (uint32_t i = 0; i < n; i++) {
    turned of = turned_mask(masks, item[i]);

    count_from(&of, &near->plane);
    double depth = near_in(masks, box, &of);

    near->order[i] =
        (uint64_t)sg_depth_order(sg_float_below(depth)) << 32 | item[i];
    if (covers(&of, &box) && far_in(masks->scene, &box, &of) < far) {
      near->cover = item[i];
      far = far_in(masks->scene, &box, &of);
    }
  }
  if (near->cover != SG_NO_MASK) {
    near->front = part(near->order, n, -sg_float_below(-far));
  }
  if (!sg_sort_upper(near->order, near->front)) {
    free(near);
    near = NULL;
  }
  return near;
}

const sg_mask_near *
sg_mask_grid_near(const sg_mask_grid *masks, size_t cell)
{
  sg_mask_near *known = atomic_load(&masks->near[cell]);
  sg_mask_near *made = known ? NULL : look_at_cell(masks, cell);

  if (made &&
      !atomic_compare_exchange_strong(&masks->near[cell], &known, made)) {
    free(made); /* another thread was first */
    return known;
  }
  return known ? known : made;
}
