/* waiting_rows.h -- rows of divided polygons that wait to be written together.
 *
 * Layer: rows. One row of many costs a tenth of one that is written alone. What
 * waits is not in the world yet; its numbers are taken. All zero: none wait.
 * False: refused.
 */
#ifndef SG_WAITING_ROWS_H
#define SG_WAITING_ROWS_H

#include "call.h"

SG_CALL_LIST(sg_waiting_terms, const uint32_t *);
SG_CALL_LIST(sg_waiting_lists, const int32_t *);

/* Columns; terms and lists last as long as the call. */
typedef struct sg_waiting {
  sg_int_list e[5], t[6], p[2], s; /* s: of origins */
  sg_waiting_terms item, origin;
  sg_waiting_lists edges; /* of p */
} sg_waiting;

bool sg_wait_edge(sg_call *call, sg_waiting *w, const int32_t row[5]);
bool sg_wait_triangle(sg_call *call, sg_waiting *w, const int32_t row[6]);
bool sg_wait_origin(sg_call *call, sg_waiting *w, int32_t s,
                    const uint32_t *item, const uint32_t *origin);
/* `edges`: their number first. */
bool sg_wait_polygon(sg_call *call, sg_waiting *w, int32_t s, int32_t p,
                     const int32_t *edges);

/* Writes them, each relation in the order in which they came; none wait. The
 * world is claimed. */
bool sg_waiting_write(sg_call *call, sg_waiting *w, sg_world *world);

#endif
