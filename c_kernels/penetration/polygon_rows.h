/* polygon_rows.h -- a polygon of the world while its rows are replaced.
 *
 * Layer: rows. A version must not be held while rows are written: they would be
 * copied. So each of these asks for one and drops it. False, null or 0:
 * refused, if nothing else is said.
 */
#ifndef SG_POLYGON_ROWS_H
#define SG_POLYGON_ROWS_H

#include "cut_rows.h"
#include "polygon/triangulate.h"
#include "rows/key_table.h"

/* The row (s, id) of a relation, and its values (null: not wanted), of which
 * lists and terms are the world's. SG_NO_ROW: there is none. */
sg_row sg_row_now(sg_world *world, sg_relation relation, int32_t s, int32_t id,
                  sg_value out[SG_MAX_COLUMNS]);
/* Whether edge e of segment s is there and runs from v1 to v2. */
bool sg_edge_runs(sg_world *world, int32_t s, int32_t e, int32_t v1,
                  int32_t v2);

/* symbol(Id), as sg_call_term(). */
const uint32_t *sg_unary_term(sg_call *call, int32_t symbol, int32_t id);

/* Whether there is an origin(S, Item, _). */
bool sg_origin_is_there(sg_world *world, int32_t s, const uint32_t *item);

/* Retracts p/3 and returns its edges, their number first, which last as long as
 * the call. Null also if there is no such polygon. */
int32_t *sg_polygon_retract(sg_call *call, sg_world *world, int32_t s,
                            int32_t p);
/* Retracts the edges of the list but those (e, v1, v2) that are in `same` as
 * they are, and those that a polygon has: one may, unless `set` says that s
 * shares none (null: it may). */
bool sg_edges_drop(sg_call *call, sg_world *world, int32_t s,
                   const int32_t *list, const sg_key_table *same,
                   sg_cut_handle *set);
/* Notes one that stays. */
bool sg_edge_is_same(sg_call *call, sg_key_table *same, int32_t e, int32_t v1,
                     int32_t v2);
/* Retracts the triangles of polygon p. */
bool sg_triangles_drop(sg_call *call, sg_world *world, int32_t s, int32_t p);

#endif
