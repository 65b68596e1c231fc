/* known_surface_rows.h -- the smooth surfaces that the polygons of a world
 * stand for, and the named faces they are of.
 *
 * Layer: rows.
 */
#ifndef SG_KNOWN_SURFACE_ROWS_H
#define SG_KNOWN_SURFACE_ROWS_H

#include "doors/drawing.h"
#include "known_surface.h"
#include "rows/dense.h"

/* The surfaces of the polygons of a model, by what is known of segments
 * (known_surfaces/1 of rules/csg/known_surface.pl: in the order of segments).
 * sg_known_surfaces_clear() in any case. */
bool sg_known_surfaces_read(sg_call *call, const sg_known_segment_list *known,
                            const sg_dense *dense, sg_known_surfaces *out);

/* Frees them when the call is closed, whose answer has their frames; false:
 * refused, and freed at once. */
bool sg_known_surfaces_adopt(sg_call *call, sg_known_surfaces *surfaces);

#endif
