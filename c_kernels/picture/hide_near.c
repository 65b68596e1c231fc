/* hide_near.c -- how near masks come in a cell of their grid: see
 * hide_search.h. */
#include "hide_search_private.h"

#include "number/bounds.h"
#include "rows/sort.h"

#include <stdatomic.h>
#include <stdlib.h>

/* Rounding is far below this part of a depth. */
#define DEPTH_SLACK 1e-12

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

/* A depth that no point of the mask's plane in the cell is nearer than, nor any
 * point of the mask. */
static float
near_in(const sg_mask_grid *masks, cell_box box, uint32_t m)
{
  const sg_scene *scene = masks->scene;
  const sg_scene_mask *mask = &scene->mask[m];
  const double *way = masks->way, *n = mask->normal;
  const double across[2] = {n[0] * way[0] + n[1] * way[1],
                            n[1] * way[0] - n[0] * way[1]};
  double near = scene->at[mask->v[0]][2];
  sg_grid_shape shape = {.corners = 3};

  for (int k = 0; k < 3; k++) {
    memcpy(shape.at[k], scene->at[mask->v[k]], sizeof shape.at[k]);
  }
  sg_turn_shape(way, &shape);
  narrow(&box, &shape, SG_REACH * masks->grid.margin);
  for (int k = 0; k < 2; k++) {
    double rise = -across[k] / n[2];
    double at = rise > 0.0 ? box.low[k] : box.high[k];

    near += rise * (at - shape.at[0][k]) - DEPTH_SLACK * (1.0 + fabs(rise));
  }
  return sg_float_below(near > mask->low[2] ? near : mask->low[2]);
}

/* The same for the caller to free. */
static sg_mask_order *
sort_cell(const sg_mask_grid *masks, size_t cell)
{
  uint32_t begin = masks->grid.start[cell];
  const uint32_t *item = masks->grid.item + begin;
  size_t n = masks->grid.start[cell + 1] - begin;
  sg_mask_order *key = malloc((n + 1) * sizeof *key);
  cell_box box = cell_at(&masks->grid, cell);

  for (size_t i = 0; key && i < n; i++) {
    uint32_t depth = sg_depth_order(near_in(masks, box, item[i]));
    key[i] = (uint64_t)depth << 32 | item[i];
  }
  if (key && !sg_sort_upper(key, n)) {
    free(key);
    key = NULL;
  }
  return key;
}

const sg_mask_order *
sg_mask_grid_near(const sg_mask_grid *masks, size_t cell)
{
  sg_mask_order *known = atomic_load(&masks->near[cell]);
  sg_mask_order *made = known ? NULL : sort_cell(masks, cell);

  if (made &&
      !atomic_compare_exchange_strong(&masks->near[cell], &known, made)) {
    free(made); /* another thread was first */
    return known;
  }
  return known ? known : made;
}
