/* image_change.h -- pictures in dots that are put together, or get fewer
 * colours.
 *
 * Layer: kernel.
 */
#ifndef SG_IMAGE_CHANGE_H
#define SG_IMAGE_CHANGE_H

#include "canvas.h"
#include "shading/buffer.h"

/* A picture of one colour. Requires: sg_raster_size_is_valid(). Null: no
 * memory. Owner: sg_image_close(). */
sg_image *sg_image_blank(int32_t width, int32_t height, const sg_colour colour);

/* `part`, which may be clear in places, over `image`, which has no alpha: its
 * first dot comes to x, y; what is outside is left out. Light is mixed, not
 * bytes. */
void sg_image_put(sg_image *image, int32_t x, int32_t y, const sg_image *part);

/* Each dot gets the nearest of `colours` colours, 1 .. 256, the first of
 * several: least squares of bytes. Requires: no alpha. */
void sg_image_colours(sg_image *image, size_t colours, const sg_colour *colour);

#endif
