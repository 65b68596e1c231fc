/* outline.h -- whether loops in the plane are a polygon with holes.
 *
 * Layer: kernel. Sound loops meet nowhere: no two edges have a point in common
 * but neighbours the one between them; and each but the first is inside the
 * first, and in no other.
 */
#ifndef SG_OUTLINE_H
#define SG_OUTLINE_H

#include "engine/cancel.h"

#include <stddef.h>

/* Loop k has the points at[begin[k] .. begin[k + 1] - 1], three at least, no
 * two that follow each other in one place. */
typedef struct sg_flat_loops {
  size_t n;
  const double (*at)[2];
  const size_t *begin; /* [n + 1] */
} sg_flat_loops;

/* Whether the loops are sound. Exact.
 *
 * Returns: false: no memory, or the cancellation said stop.
 * Cost:    by trees of boxes; as the number of edges, where few overlap. */
bool sg_flat_loops_are_sound(const sg_flat_loops *loops,
                             const sg_cancel *cancel, bool *sound);

#endif
