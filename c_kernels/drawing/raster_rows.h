/* raster_rows.h -- what dots and smooth lines have in common as pictures.
 *
 * Layer: rows.
 */
#ifndef SG_RASTER_ROWS_H
#define SG_RASTER_ROWS_H

#include "canvas.h"
#include "doors/drawing.h"

/* domain_error(raster_size, Width-Height): the first two arguments. */
bool sg_raster_size(sg_call *call, int32_t width, int32_t height);

/* domain_error(byte, Part). */
bool sg_rgb_colour(sg_call *call, const sg_rgb *rgb, sg_colour out);

#endif
