/* leaf_rows.h -- polygons as they are before a cut, kept.
 *
 * Layer: rows.
 */
#ifndef SG_LEAF_ROWS_H
#define SG_LEAF_ROWS_H

#include "call.h"

struct sg_segment_polygon_list;

/* leaf_e/5, leaf_p/3 and leaf_t/6 of these polygons, unless they are there. The
 * world is claimed. False: refused, or there is no such polygon. */
bool sg_leaves_keep(sg_call *call, sg_world *world,
                    const struct sg_segment_polygon_list *polygons);

#endif
