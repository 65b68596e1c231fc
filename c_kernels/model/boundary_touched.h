/* boundary_touched.h -- polygons that other faces of their segment touch
 * inside.
 *
 * Layer: kernel, private to boundary.c. A vertex or an edge of another face may
 * lie in a polygon: then it is a corner or an edge of the polygon's triangles,
 * and none of the polygon. Whoever divided that polygon in another way would
 * cut through it.
 */
#ifndef SG_BOUNDARY_TOUCHED_H
#define SG_BOUNDARY_TOUCHED_H

#include "rows/dense.h"

/* The polygons of segment s (a place of dense) that are touched inside, each
 * with its triangles. */
typedef struct sg_touched {
  uint32_t *begin;    /* [polygons of s + 1] into triangle; of a polygon that
                         nothing touches inside, none. Null: of no polygon */
  uint32_t *triangle; /* places of triangles */
} sg_touched;

/* number[v] is that of the place of vertex v of s: vertices in one place are
 * one. If `all`, every polygon that has triangles is taken for touched.
 *
 * Returns: false: no memory, or (*stopped) stopped by the cancellation.
 * Owner:   sg_touched_clear() in any case.
 * Cost:    linear. */
bool sg_touched_find(const sg_dense *dense, size_t s, const uint32_t *number,
                     bool all, const sg_cancel *cancel, sg_touched *out,
                     bool *stopped);
void sg_touched_clear(sg_touched *touched);

#endif
