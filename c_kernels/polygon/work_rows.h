/* work_rows.h -- the scratch relation of one polygon behind its doors.
 *
 * Layer: rows. Vertices are named by their ids.
 */
#ifndef SG_WORK_ROWS_H
#define SG_WORK_ROWS_H

#include "call.h"
#include "work.h"

/* The handle of the vertex with this id: existence_error(work_vertex). */
bool sg_work_known(sg_call *call, const sg_work *work, int32_t id,
                   int32_t *out);
/* Of an edge between two of them that are not one: domain_error(
 * another_vertex) of this argument. */
bool sg_work_known_ends(sg_call *call, const sg_work *work, int32_t v1,
                        int32_t v2, int argument, int32_t out[2]);

#endif
