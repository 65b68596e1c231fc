/* seam_parts.h -- in how many parts a seam can be at most.
 *
 * Layer: kernel. Inexact: angles are rounded; what nearly balances counts as
 * balanced, so that there may be more parts, never fewer.
 *
 * What is bent at the vertices of a part that reaches no border sums to a
 * multiple of two whole turns (seam_bound.h). A part of two vertices is a pair
 * that balances, one of three a triple; all others have four or more. So with a
 * half for each vertex that has a partner, a third for each other one that is
 * in a triple and a quarter for the rest, each part has one or more.
 */
#ifndef SG_SEAM_PARTS_H
#define SG_SEAM_PARTS_H

#include "engine/cancel.h"

#include <stdbool.h>
#include <stddef.h>

/* Triples are looked for among so many vertices; of more all may be in one. */
enum { SG_TRIPLES = 1000 };

/* *parts: no more parts than this have n vertices that are bent by
 * bend[0] <= ... <= bend[n - 1], radians, each less than a whole turn and none
 * of them balanced alone. Time: n squared at most. False: no memory, or
 * (*stopped) stopped by the cancellation. */
bool sg_seam_parts_most(const double *bend, size_t n, const sg_cancel *cancel,
                        size_t *parts, bool *stopped);

#endif
