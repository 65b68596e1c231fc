/* dense4pl.h -- dense_rows.h for glue that has no sg_call.
 *
 * Layer: glue. False: an exception is pending.
 */
#ifndef SG_DENSE4PL_H
#define SG_DENSE4PL_H

#include "dense_rows.h"

int sg_get_dense_ex(const int32_t *wanted, size_t n, sg_dense *out);

#endif
