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

/* domain_error(scale, Scale): dots to a unit of lines. */
bool sg_canvas_scale(sg_call *call, double scale, int argument);

/* Draws lines, `argument` of the call, in units of which each is `scale` dots.
 * False: refused, or stopped. */
bool sg_canvas_lines(sg_call *call, sg_canvas *canvas,
                     const sg_canvas_line_fact_list *lines, double scale,
                     int argument);

#endif
