/* grid.h -- a uniform grid of cells on the picture.
 *
 * Layer: kernel. Items (triangles, lines) are entered in the cells that they
 * touch, row by row of cells, and found again along a line. Inexact, but
 * conservative: what comes within the grid's margin of a cell is in it.
 */
#ifndef SG_GRID_H
#define SG_GRID_H

#include "engine/cancel.h"

#include <stddef.h>
#include <stdint.h>

typedef struct sg_grid {
  unsigned nx, ny;
  double margin;
  double low[2], wide[2]; /* corner of cell 0,0; size of a cell */
  double per[2];          /* cells in a unit */
  uint32_t *start;        /* [nx * ny + 1] */
  uint32_t *item;         /* cell by cell, in the order of entering */
} sg_grid;

/* The corners of an item in the picture: 2 for a line, 3 for a triangle. */
typedef struct sg_grid_shape {
  unsigned corners;
  double at[3][2];
} sg_grid_shape;

typedef void sg_grid_shape_of(const void *data, size_t i, sg_grid_shape *out);
typedef struct sg_grid_box {
  double low[2], high[2];
} sg_grid_box;
typedef void sg_grid_box_of(const void *data, size_t i, sg_grid_box *out);

/* A grid of n items, about one cell for each, or fewer where large items would
 * be in too many. Its cells are squares, or for items that run `along` x about
 * as long as these. box_of: the box of a shape, where it is known; else null.
 * Things nearer than `margin`, which is not 0, have a cell in
 * common. False: stopped by the cancellation, or no memory (then *memory is
 * false). Owner: the caller, sg_grid_clear(). */
bool sg_grid_init(sg_grid *grid, size_t n, sg_grid_shape_of *shape_of,
                  sg_grid_box_of *box_of, const void *data, double margin,
                  bool along, const sg_cancel *cancel, bool *memory);
void sg_grid_clear(sg_grid *grid);

/* The n x n cells of a box alone, for who keeps something of his own in them:
 * nothing is entered, and nothing is to be cleared. */
sg_grid sg_grid_empty(const sg_grid_box *box, unsigned n, double margin);

/* The cells of a shape: rows y0 <= y < y1, in each of them the columns that
 * sg_grid_row() gives. Beyond the grid's border the border's cells count. */
typedef struct sg_grid_rows {
  unsigned y0, y1;
  unsigned x0, x1; /* the columns of all rows together */
} sg_grid_rows;
typedef struct sg_grid_columns {
  unsigned x0, x1;
} sg_grid_columns;

sg_grid_rows sg_grid_rows_of_box(const sg_grid *grid, const sg_grid_box *box);
sg_grid_rows sg_grid_rows_of(const sg_grid *grid, const sg_grid_shape *shape);
sg_grid_columns sg_grid_row(const sg_grid *grid, const sg_grid_shape *shape,
                            sg_grid_rows rows, unsigned y);

#endif
