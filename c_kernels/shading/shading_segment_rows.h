/* shading_segment_rows.h -- a leaf of a shaded scene from rows.
 *
 * Layer: rows.
 */
#ifndef SG_SHADING_SEGMENT_ROWS_H
#define SG_SHADING_SEGMENT_ROWS_H

#include "call.h"
#include "shading_scene.h"

/* Adds the triangles of segment s, as faces their polygons, to the last leaf,
 * where `map` brings them: three rows A, B, C, D; null: nowhere. What was
 * refused or stopped the call knows. */
sg_shading_end sg_shading_read_segment(sg_call *call, sg_shading *scene,
                                       int32_t s, const double *map);

#endif
