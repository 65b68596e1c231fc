/* divided_rows.h -- rows of divided polygons that wait to be written together.
 *
 * Layer: rows. One row of many costs a tenth of one that is written alone. What
 * waits is not in the world yet; its numbers are taken. All zero: none wait.
 * False: refused.
 */
#ifndef SG_DIVIDED_ROWS_H
#define SG_DIVIDED_ROWS_H

#include "call.h"

SG_CALL_LIST(sg_divided_terms, const uint32_t *);
SG_CALL_LIST(sg_divided_lists, const int32_t *);

/* Columns; terms and lists last as long as the call. */
typedef struct sg_divided {
  sg_int_list e[5], t[6], p[2], s; /* s: of origins */
  sg_divided_terms item, origin;
  sg_divided_lists edges; /* of p */
} sg_divided;

bool sg_divided_edge(sg_call *call, sg_divided *w, const int32_t row[5]);
bool sg_divided_triangle(sg_call *call, sg_divided *w, const int32_t row[6]);
bool sg_divided_origin(sg_call *call, sg_divided *w, int32_t s,
                       const uint32_t *item, const uint32_t *origin);
/* `edges`: their number first. */
bool sg_divided_polygon(sg_call *call, sg_divided *w, int32_t s, int32_t p,
                        const int32_t *edges);

/* Writes them, each relation in the order in which they came; none wait. The
 * world is claimed. */
bool sg_divided_write(sg_call *call, sg_divided *w, sg_world *world);

#endif
