/* append4pl.h -- rows that glue writes in place, unchecked.
 *
 * Layer: glue. False: an exception is pending. Include it before SWI-Prolog.h.
 */
#ifndef SG_APPEND4PL_H
#define SG_APPEND4PL_H

#include "engine/world4pl.h"

#include "segment_rows.h"

/* True if segment s has no rows in v, e, p, plane, t, from_v and from_p, so
 * that dense ids from 1 are keys of its own; else permission_error(write,
 * segment, s). The world should be claimed. Costs nothing for a segment that
 * never had a vertex. */
int sg_segment_is_empty_ex(sg_world *world, int32_t s);

/* The rows of segment s, ascending: out->row, out->begin[1] of them. By looking
 * at what lives, not by an index: that would hold what is kept for undo too,
 * and a segment that is made again and again has much of that. Clear it in any
 * case. */
int sg_rows_of_segment_ex(const sg_version *version, sg_relation relation,
                          int32_t s, sg_segment_rows *out);

/* Appends n rows that are right by construction, from columns of integers and
 * floats as of sg_world_add_many(). Prolog's signals come in between. */
int sg_append_columns_ex(sg_world *world, sg_relation relation, size_t n,
                         const void *const *column);

#endif
