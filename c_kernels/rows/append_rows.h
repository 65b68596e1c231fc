/* append_rows.h -- rows that are written in place, unchecked.
 *
 * Layer: rows. False: see call.h.
 */
#ifndef SG_APPEND_ROWS_H
#define SG_APPEND_ROWS_H

#include "by_segment.h"
#include "call.h"

/* True if segment s has no rows in v, e, p, plane, t, from_v and from_p, so
 * that dense ids from 1 are keys of its own; else permission_error(write,
 * segment, s). The world should be claimed. Costs nothing for a segment that
 * never had a vertex. */
bool sg_segment_is_empty(sg_call *call, sg_world *world, int32_t s);

/* The rows of segment s, ascending: out->row, out->begin[1] of them. By looking
 * at what lives, not by an index: that would hold what is kept for undo too,
 * and a segment that is made again and again has much of that. Clear it in any
 * case. */
bool sg_rows_of_segment(sg_call *call, const sg_version *version,
                        sg_relation relation, int32_t s, sg_segment_rows *out);

/* Appends n rows that are right by construction, from columns as of
 * sg_world_add_many(). The call is asked for a stop in between. */
bool sg_append_columns(sg_call *call, sg_world *world, sg_relation relation,
                       size_t n, const void *const *column);

#endif
