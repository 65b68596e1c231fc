/* dense_rows.h -- segments of the current world as flat arrays.
 *
 * Layer: rows. False: see call.h.
 */
#ifndef SG_DENSE_ROWS_H
#define SG_DENSE_ROWS_H

#include "call.h"
#include "dense.h"

/* The n segments `wanted` of the current world, null: all but patterns;
 * sg_dense_clear() in any case. */
bool sg_dense_read(sg_call *call, const int32_t *wanted, size_t n,
                   sg_dense *out);
/* The same of a list, which may be empty. */
bool sg_dense_read_these(sg_call *call, const sg_int_list *wanted,
                         sg_dense *out);

#endif
