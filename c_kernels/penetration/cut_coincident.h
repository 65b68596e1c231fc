/* cut_coincident.h -- where two segments have the same triangles.
 *
 * Layer: kernel. Exact. A triangle of a segment is the TWIN of one of another
 * that has its three corners in the same places. A vertex is quiet between two
 * segments if every triangle of either that has it has one twin in the other,
 * which has it too. Two triangles whose corners are all quiet, and that have
 * nothing in common but corners and edges, or all, are quiet: they touch
 * exactly, and across their edges the segments go on together.
 */
#ifndef SG_CUT_COINCIDENT_H
#define SG_CUT_COINCIDENT_H

#include "cut_model.h"
#include "rows/sort.h"

/* Sets quiet[k] for the quiet ones of n pairs of triangles; but not of some
 * that share no edge and that no plain test shows to be apart. With a triangle
 * all that share a corner with it in place must be in the model, and the pairs
 * be all that touch. Cost: linear. */
sg_sort_end sg_cut_find_quiet(const sg_cut_model *model,
                              const uint32_t (*pair)[2], size_t n,
                              uint8_t *quiet, const sg_cancel *cancel);

#endif
