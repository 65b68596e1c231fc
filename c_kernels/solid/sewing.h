/* sewing.h -- shells of one segment that touch exactly, as one surface.
 *
 * Layer: kernel. Vertices in one place become one vertex. So shells that touch
 * along an edge share it, as neighbours do, and polygons that lie on each other
 * are the same one, turned round or not: the first of them stays, with a
 * WEIGHT, how often all of them together go its way. A polygon whose weight is
 * 0 changes no winding number and falls out.
 *
 * Where a polygon would come to have a vertex twice nothing becomes one.
 * Polygons are the same if their edges are, and their triangles, or they are
 * flat.
 *
 * Exact, and the same for any order of rows; but where doubles are asked for,
 * what is flat within rounding (polygon/flatness.h) is flat.
 */
#ifndef SG_SEWING_H
#define SG_SEWING_H

#include "rows/dense.h"

#include <stdbool.h>

typedef struct sg_sewing {
  bool any;         /* some vertices are in one place; else nothing is set */
  uint32_t *vertex; /* [vertices]: the place of the one that each becomes */
  int32_t *weight;  /* [polygons]; 0: it falls out */
  bool *again;      /* [polygons]: it is the same as one that is before it */
  size_t doubles;   /* how many of these */
} sg_sewing;

/* Of a segment that is alone in `dense`. `doubles`: polygons that lie on each
 * other are looked for even if no vertices do, so all but `any` is set.
 *
 * Returns: false: no memory, or the cancellation said stop.
 * Owner:   sg_sewing_clear() in any case.
 * Cost:    n log n of its edges and triangles. */
bool sg_sewing_find(const sg_dense *dense, bool doubles,
                    const sg_cancel *cancel, sg_sewing *out);
void sg_sewing_clear(sg_sewing *sewing);

#endif
