/* solid_take.h -- segments as a solid under way: their polygons as they are.
 *
 * Layer: kernel. Reads views of v/5, e/5 and t/6 of one version.
 */
#ifndef SG_SOLID_TAKE_H
#define SG_SOLID_TAKE_H

#include "engine/cancel.h"
#include "engine/column.h"
#include "solid.h"

typedef struct sg_solid_input {
  const sg_view *v, *e, *t;
} sg_solid_input;

/* The polygons of n segments (ascending numbers), each a face of its triangles
 * in t/6: one without triangles is left out. Vertices are all of v/5, plain and
 * ascending; those of different segments stay apart. An edge is auxiliary if
 * every row of e/5 between its ends, in its direction, is.
 *
 * Returns: false: no memory, or the cancellation said stop.
 * Owner:   the caller, sg_solid_clear() in any case. Exact. */
bool sg_solid_take(const sg_solid_input *in, const int32_t *segment, size_t n,
                   const sg_cancel *cancel, sg_solid *out);

#endif
