/* append4pl.h -- append_rows.h for glue that has no sg_call.
 *
 * Layer: glue. False: an exception is pending. Include it before SWI-Prolog.h.
 */
#ifndef SG_APPEND4PL_H
#define SG_APPEND4PL_H

#include "append_rows.h"

#include "engine/world4pl.h"

int sg_segment_is_empty_ex(sg_world *world, int32_t s);
int sg_rows_of_segment_ex(const sg_version *version, sg_relation relation,
                          int32_t s, sg_segment_rows *out);
int sg_append_columns_ex(sg_world *world, sg_relation relation, size_t n,
                         const void *const *column);

#endif
