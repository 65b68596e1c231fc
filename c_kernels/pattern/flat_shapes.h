/* flat_shapes.h -- convex shapes on paper: is there room for one more?
 *
 * Layer: kernel. Lines, triangles, tabs, the boxes of letters: each a convex
 * polygon of 2 (a line) to SG_FLAT_SHAPE_CORNERS corners, in whatever unit and
 * orientation. They are found again by the index of islands, flat_index.h.
 * Inexact: depths are rounded, and meant to be compared with a tolerance much
 * larger than the last digit of a coordinate.
 */
#ifndef SG_FLAT_SHAPES_H
#define SG_FLAT_SHAPES_H

#include "development/flat_index.h"

enum { SG_FLAT_SHAPE_CORNERS = SG_CONVEX_CORNERS };

typedef struct sg_flat_shape {
  unsigned corners;
  double at[SG_FLAT_SHAPE_CORNERS][2];
} sg_flat_shape;

typedef struct sg_flat_shapes {
  double size;          /* of a shape, about */
  sg_flat_shape *shape; /* [n], counter-clockwise */
  size_t n, room;
  sg_flat_stock stock; /* items are shapes */
  sg_flat_index index;
} sg_flat_shapes;

/* No shapes yet; `size` is about that of a shape. */
void sg_flat_shapes_init(sg_flat_shapes *shapes, double size);
void sg_flat_shapes_clear(sg_flat_shapes *shapes);

/* Enters one more. False: no memory; shapes are then good for nothing but to be
 * cleared. */
bool sg_flat_shapes_add(sg_flat_shapes *shapes, const sg_flat_shape *shape);

/* True if no shape entered overlaps this one deeper than `tolerance`, which is
 * not below zero. */
bool sg_flat_shapes_free(sg_flat_shapes *shapes, const sg_flat_shape *shape,
                         double tolerance);

/* How far one of the two has to be moved until they overlap no more; below
 * zero: so far they are apart, at least. A line inside a polygon has a depth
 * too. */
double sg_flat_shape_depth(const sg_flat_shape *a, const sg_flat_shape *b);

/* True if it has a valid number of corners, all of them finite and not farther
 * away than 1e9 times `size`. */
bool sg_flat_shape_is_valid(const sg_flat_shape *shape, double size);

#endif
