/* grid.c -- see grid.h */
#include "grid.h"

#include "engine/list.h"
#include "number/bounds.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Cells are never smaller than this: finer ones would only repeat items. */
#define SMALLEST 16 /* margins */

/* A shape of so few rows takes all cells of its box: quicker than to look. */
enum { MOST_CELLS_A_SIDE = 4096, MOST_ROWS = 1 << 16, FEW_ROWS = 2 };

/* Items are entered MOST times each at most, on average, or MANY times where
 * they are more than MOST_ENTRIES in all: where they are large and many the
 * cells are wider. Between two cancellations there are so many entries, an item
 * counting as AN_ITEM of them. */
enum {
  MOST = 128,
  MOST_ENTRIES = 1 << 26,
  MANY = 8,
  ASK_EVERY = 1 << 18,
  AN_ITEM = 64
};

/* The items that are entered, and where they are: one is looked at again only
 * where its box does not say all. */
typedef struct items {
  size_t n;
  sg_grid_shape_of *shape_of;
  sg_grid_box_of *box_of; /* null: from the shape */
  const void *data;
  sg_grid_box *box; /* [n] */
} items;

static sg_grid_box
box_of_shape(const sg_grid_shape *shape)
{
  sg_grid_box out = {{DBL_MAX, DBL_MAX}, {-DBL_MAX, -DBL_MAX}};

  for (unsigned i = 0; i < shape->corners; i++) {
    for (int k = 0; k < 2; k++) {
      out.low[k] = sg_smaller(out.low[k], shape->at[i][k]);
      out.high[k] = sg_larger(out.high[k], shape->at[i][k]);
    }
  }
  return out;
}

static unsigned
cells(double size, double cell, unsigned most)
{
  double n = floor(size / cell) + 1.0;

  return n < most ? (unsigned)n : most;
}

/* The boxes; the sides of that of all items, and its corner; of theirs,
 * summed. */
static void
find_boxes(sg_grid *grid, const items *of, double size[2], double sum[2])
{
  double high[2] = {-DBL_MAX, -DBL_MAX};
  sg_grid_shape shape;

  sum[0] = sum[1] = 0.0;

  grid->low[0] = grid->low[1] = DBL_MAX;
  for (size_t i = 0; i < of->n; i++) {
    sg_grid_box *b = &of->box[i];

    if (of->box_of) {
      of->box_of(of->data, i, b);
    } else {
      of->shape_of(of->data, i, &shape);
      *b = box_of_shape(&shape);
    }
    for (int k = 0; k < 2; k++) {
      grid->low[k] = sg_smaller(grid->low[k], b->low[k]);
      high[k] = sg_larger(high[k], b->high[k]);
      sum[k] += b->high[k] - b->low[k];
    }
  }
  for (int k = 0; k < 2; k++) {
    grid->low[k] = of->n ? grid->low[k] - grid->margin : 0.0;
    size[k] = of->n ? high[k] - grid->low[k] + grid->margin : 1.0;
  }
}

static void
divide(sg_grid *grid, const double size[2], unsigned nx, unsigned ny)
{
  grid->nx = nx;
  grid->ny = ny;
  grid->wide[0] = size[0] / nx;
  grid->wide[1] = size[1] / ny;
  grid->per[0] = nx / size[0];
  grid->per[1] = ny / size[1];
}

static void
choose_cells(sg_grid *grid, const double size[2], double cell, double longer)
{
  double low = sg_larger(SMALLEST * grid->margin, cell / longer);

  divide(grid, size, cells(size[0], cell * longer, MOST_CELLS_A_SIDE),
         cells(size[1], low, longer > 1 ? MOST_ROWS : MOST_CELLS_A_SIDE));
}

/* How many times longer than a square cells are for items of this size. */
static double
find_longer(const double sum[2], size_t n, double cell)
{
  double most = sum[0] / (double)n / cell;

  return sum[0] > sum[1] && most > 1
             ? sg_smaller(sqrt(sum[0] / sg_larger(sum[1], DBL_MIN)), most)
             : 1;
}

static unsigned
cell_of(const sg_grid *grid, int k, double x)
{
  unsigned n = k ? grid->ny : grid->nx;
  double c = (x - grid->low[k]) * grid->per[k];

  return c <= 0.0 ? 0 : c < n ? (unsigned)c : n - 1;
}

sg_grid_rows
sg_grid_rows_of_box(const sg_grid *grid, const sg_grid_box *b)
{
  return (sg_grid_rows){.y0 = cell_of(grid, 1, b->low[1] - grid->margin),
                        .y1 = cell_of(grid, 1, b->high[1] + grid->margin) + 1,
                        .x0 = cell_of(grid, 0, b->low[0] - grid->margin),
                        .x1 = cell_of(grid, 0, b->high[0] + grid->margin) + 1};
}

sg_grid_rows
sg_grid_rows_of(const sg_grid *grid, const sg_grid_shape *shape)
{
  sg_grid_box b = box_of_shape(shape);

  return sg_grid_rows_of_box(grid, &b);
}

/* Whether all cells of the box are the shape's. */
static bool
is_box(sg_grid_rows rows)
{
  return rows.y1 - rows.y0 <= FEW_ROWS || rows.x1 - rows.x0 == 1;
}

/* Widens x by the part of side p-q that lies between y = low and y = high. */
static void
side_in_row(const double p[2], const double q[2], double low, double high,
            double x[2])
{
  double dy = q[1] - p[1];
  double ends[2] = {p[1], q[1]};

  if (sg_larger(ends[0], ends[1]) < low ||
      sg_smaller(ends[0], ends[1]) > high) {
    return;
  }
  for (int i = 0; i < 2; i++) {
    double y = sg_smaller(sg_larger(ends[i], low), high);
    double at =
        ends[i] == y ? (i ? q : p)[0] : p[0] + (y - p[1]) / dy * (q[0] - p[0]);
    x[0] = sg_smaller(x[0], at);
    x[1] = sg_larger(x[1], at);
  }
}

sg_grid_columns
sg_grid_row(const sg_grid *grid, const sg_grid_shape *shape, sg_grid_rows rows,
            unsigned y)
{
  double low = grid->low[1] + y * grid->wide[1] - grid->margin;
  double high = low + grid->wide[1] + 2 * grid->margin;
  double x[2] = {DBL_MAX, -DBL_MAX};

  if (is_box(rows)) {
    return (sg_grid_columns){rows.x0, rows.x1};
  }
  if (y == 0) {
    low = -DBL_MAX;
  }
  if (y == grid->ny - 1) {
    high = DBL_MAX;
  }
  for (unsigned i = 0; i < shape->corners; i++) {
    side_in_row(shape->at[i], shape->at[(i + 1) % shape->corners], low, high,
                x);
  }
  if (x[0] > x[1]) {
    return (sg_grid_columns){0, 0};
  }
  return (sg_grid_columns){cell_of(grid, 0, x[0] - grid->margin),
                           cell_of(grid, 0, x[1] + grid->margin) + 1};
}

/* Counts item i in its cells, or enters it there once they are counted.
 * Returns in how many. */
static size_t
enter(sg_grid *grid, const items *of, size_t i)
{
  uint32_t *item = grid->item, *count = grid->start + (item ? 1 : 2);
  sg_grid_rows rows = sg_grid_rows_of_box(grid, &of->box[i]);
  sg_grid_columns columns = {rows.x0, rows.x1};
  bool all = is_box(rows);
  sg_grid_shape shape;
  size_t entries = 0;

  if (!all) {
    of->shape_of(of->data, i, &shape);
  }
  for (unsigned y = rows.y0; y < rows.y1; y++) {
    if (!all) {
      columns = sg_grid_row(grid, &shape, rows, y);
    }
    for (unsigned x = columns.x0; x < columns.x1; x++) {
      size_t cell = (size_t)y * grid->nx + x;
      if (item) {
        item[count[cell]] = (uint32_t)i;
      }
      count[cell]++;
    }
    entries += columns.x1 - columns.x0;
  }
  return entries;
}

static size_t
most_entries(const sg_grid *grid, size_t n)
{
  bool one = grid->nx == 1 && grid->ny == 1;

  return one                       ? SIZE_MAX
         : n < MOST_ENTRIES / MOST ? MOST * n
         : n < MOST_ENTRIES / MANY ? MOST_ENTRIES
                                   : MANY * n;
}

/* All items: entered, or counted until they are too many. False: stopped. */
static bool
enter_all(sg_grid *grid, const items *of, const sg_cancel *cancel,
          size_t *entries)
{
  size_t asked = 0, most = most_entries(grid, of->n);

  *entries = 0;
  for (size_t i = 0; i < of->n && *entries <= most; i++) {
    size_t done = *entries + AN_ITEM * i;
    if (i == 0 || done - asked > ASK_EVERY) {
      asked = done;
      if (sg_cancelled(cancel)) {
        return false;
      }
    }
    *entries += enter(grid, of, i);
  }
  return true;
}

/* start[]: how many items each cell has, two places on. False: stopped, or no
 * memory. */
static bool
count_items(sg_grid *grid, const items *of, bool along, const sg_cancel *cancel,
            bool *memory)
{
  double size[2], sum[2], cell, longer;
  size_t entries;

  find_boxes(grid, of, size, sum);
  cell = sg_larger(SMALLEST * grid->margin,
                   sqrt(size[0] * size[1] / ((double)of->n + 1.0)));
  longer = along ? find_longer(sum, of->n, cell) : 1;
  do {
    choose_cells(grid, size, cell, longer);
    cell *= 2;
    free(grid->start);
    grid->start = calloc((size_t)grid->nx * grid->ny + 2, sizeof *grid->start);
    *memory = grid->start != NULL;
    if (!*memory || !enter_all(grid, of, cancel, &entries)) {
      return false;
    }
  } while (entries > most_entries(grid, of->n));
  return true;
}

static bool
fill(sg_grid *grid, const items *of, bool along, const sg_cancel *cancel,
     bool *memory)
{
  size_t total, entries;

  if (!count_items(grid, of, along, cancel, memory)) {
    return false;
  }
  total = (size_t)grid->nx * grid->ny;
  for (size_t c = 2; c < total + 2; c++) {
    grid->start[c] += grid->start[c - 1];
  }
  grid->item = sg_list_room(grid->start[total + 1], sizeof *grid->item);
  *memory = grid->item != NULL;
  return *memory && enter_all(grid, of, cancel, &entries);
}

bool
sg_grid_init(sg_grid *grid, size_t n, sg_grid_shape_of *shape_of,
             sg_grid_box_of *box_of, const void *data, double margin,
             bool along, const sg_cancel *cancel, bool *memory)
{
  items of = {n, shape_of, box_of, data, sg_list_room(n, sizeof *of.box)};
  bool good;

  *grid = (sg_grid){.margin = margin};
  *memory = of.box != NULL;
  good = *memory && fill(grid, &of, along, cancel, memory);
  free(of.box);
  return good;
}

sg_grid
sg_grid_empty(const sg_grid_box *box, unsigned n, double margin)
{
  sg_grid grid = {.margin = margin};
  double size[2];

  for (int k = 0; k < 2; k++) {
    grid.low[k] = box->low[k] - margin;
    size[k] = box->high[k] + margin - grid.low[k];
  }
  divide(&grid, size, n, n);
  return grid;
}

void
sg_grid_clear(sg_grid *grid)
{
  free(grid->start);
  free(grid->item);
  *grid = (sg_grid){0};
}
