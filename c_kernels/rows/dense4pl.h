/* dense4pl.h -- segments of the current world as flat arrays.
 *
 * Layer: glue. False: an exception is pending.
 */
#ifndef SG_DENSE4PL_H
#define SG_DENSE4PL_H

#include "dense.h"

/* The n segments `wanted` of the current world, null: all but patterns;
 * sg_dense_clear() in any case. */
int sg_get_dense_ex(const int32_t *wanted, size_t n, sg_dense *out);

#endif
