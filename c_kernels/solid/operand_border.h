/* operand_border.h -- where the boundaries of results turn from one operand to
 * another.
 *
 * Layer: kernel. Decided on numbers alone.
 */
#ifndef SG_OPERAND_BORDER_H
#define SG_OPERAND_BORDER_H

#include "rows/dense.h"

/* The edge from vertex low to vertex high is of the first polygon, its opposite
 * of the second: ids. */
typedef struct sg_operand_border {
  int32_t s;
  int32_t low, high; /* low < high */
  int32_t polygon[2];
} sg_operand_border;

typedef struct sg_operand_borders {
  size_t n;
  sg_operand_border *item; /* [n], ascending by s, low, high, polygons */
} sg_operand_borders;

/* The segments that polygon k (a place) has parts of: operand[begin[k]] ..
 * operand[begin[k + 1] - 1]. */
typedef struct sg_operands_of {
  const uint32_t *begin; /* [polygons + 1] */
  const int32_t *operand;
} sg_operands_of;

/* The edges of the segments of `dense` between two polygons that have parts of
 * operands, and of none in common.
 *
 * Returns: false: no memory, or (*stopped) stopped by the cancellation.
 * Owner:   out->item is the caller's, to free().
 * Cost:    n log n. */
bool sg_operand_borders_find(const sg_dense *dense, const sg_operands_of *of,
                             const sg_cancel *cancel, sg_operand_borders *out,
                             bool *stopped);

#endif
