/* vertex_polygons_rows.h -- which polygons have a vertex.
 *
 * Layer: rows.
 */
#ifndef SG_VERTEX_POLYGONS_ROWS_H
#define SG_VERTEX_POLYGONS_ROWS_H

#include "call.h"

/* The polygons of segment s that have an edge from vertex v, or, if there are
 * none, a triangle at it: ascending, each once, behind those in `out`. False:
 * refused. */
bool sg_polygons_at(sg_call *call, const sg_version *version, int32_t s,
                    int32_t v, sg_int_list *out);

#endif
