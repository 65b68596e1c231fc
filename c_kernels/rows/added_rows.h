/* added_rows.h -- rows of one relation, gathered and then written at once: each
 * is checked, but indexes take them in when they are used next.
 *
 * Layer: rows.
 *
 *   sg_added_rows e = {.relation = SG_E};
 *   sg_added_rows_put(call, &e, row) ...
 *   sg_added_rows_write(call, world, &e);
 */
#ifndef SG_ADDED_ROWS_H
#define SG_ADDED_ROWS_H

#include "call.h"

typedef struct sg_added_rows {
  sg_relation relation;
  size_t n, room; /* private: */
  sg_value *value;
} sg_added_rows;

/* Lists and terms of the row are good until it is written. False: refused. */
bool sg_added_rows_put(sg_call *call, sg_added_rows *rows, const sg_value *row);

/* Writes them, in order, and has none any more. The world is claimed. False:
 * refused, and none is written. */
bool sg_added_rows_write(sg_call *call, sg_world *world, sg_added_rows *rows);

#endif
