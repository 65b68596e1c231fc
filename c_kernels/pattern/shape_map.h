/* shape_map.h -- convex shapes on paper: which of them has a point?
 *
 * Layer: kernel. Inexact: what is as good as on the border of a shape is in it.
 */
#ifndef SG_SHAPE_MAP_H
#define SG_SHAPE_MAP_H

#include "development/flat_index.h"

/* Shapes one after another, counter-clockwise, of one corner or more. */
typedef struct sg_shape_map {
  const double (*at)[2];
  const size_t *end; /* [shapes]: after the last corner of each */
  size_t shapes;     /* less than SG_NO_ITEM */
  double near;       /* part of a side that a point may be outside of it */
  sg_flat_stock stock;
  sg_flat_index index;
} sg_shape_map;

/* Indexes the shapes, which stay where they are. False: no memory. Owner:
 * sg_shape_map_clear() in any case. */
bool sg_shape_map_make(const double (*at)[2], const size_t *end, size_t shapes,
                       double near, sg_shape_map *out);
void sg_shape_map_clear(sg_shape_map *map);

/* The first shape that has the point: it is right of no side farther than
 * `near` times that, and not farther out of the box round the shape than `near`
 * times the sides of that. SG_NO_ITEM: none has it. */
uint32_t sg_shape_map_at(sg_shape_map *map, const double point[2]);

#endif
