/* flat_shapes.h -- convex shapes on paper: is there room for one more?
 *
 * Layer: kernel. Lines, triangles, tabs, the boxes of letters: each a convex
 * polygon of 2 (a line) to SG_FLAT_SHAPE_CORNERS corners, in whatever unit and
 * orientation. They are found again by the cells of a grid that they touch.
 * Inexact: depths are rounded, and meant to be compared with a tolerance much
 * larger than the last digit of a coordinate.
 */
#ifndef SG_FLAT_SHAPES_H
#define SG_FLAT_SHAPES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { SG_FLAT_SHAPE_CORNERS = 8 };

typedef struct sg_flat_shape {
  unsigned corners;
  double at[SG_FLAT_SHAPE_CORNERS][2];
} sg_flat_shape;

/* A shape in a cell of the grid, and the next one there. */
typedef struct sg_flat_shape_entry {
  int64_t cell[2];
  uint32_t shape;
  uint32_t next; /* entry of the same bucket, from 1; 0: none */
} sg_flat_shape_entry;

typedef struct sg_flat_shapes {
  double cell; /* side of a cell */
  sg_flat_shape *shape;
  size_t n, room;
  sg_flat_shape_entry *entry;
  size_t entries, entry_room;
  uint32_t *bucket; /* [buckets], entries from 1; 0: none */
  size_t buckets;   /* a power of two */
} sg_flat_shapes;

/* No shapes yet; cells of side `cell`, about the size of a shape. */
void sg_flat_shapes_init(sg_flat_shapes *shapes, double cell);
void sg_flat_shapes_clear(sg_flat_shapes *shapes);

/* Enters one more. False: no memory, and nothing was entered. */
bool sg_flat_shapes_add(sg_flat_shapes *shapes, const sg_flat_shape *shape);

/* True if no shape entered overlaps this one deeper than `tolerance`. */
bool sg_flat_shapes_free(const sg_flat_shapes *shapes,
                         const sg_flat_shape *shape, double tolerance);

/* How far one of the two has to be moved until they overlap no more; below
 * zero: so far they are apart, at least. A line inside a polygon has a depth
 * too. */
double sg_flat_shape_depth(const sg_flat_shape *a, const sg_flat_shape *b);

/* True if it has a valid number of corners, all of them finite and of a size
 * that cells can be counted for. */
bool sg_flat_shape_is_valid(const sg_flat_shape *shape, double cell);

#endif
