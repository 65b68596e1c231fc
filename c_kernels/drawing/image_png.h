/* image_png.h -- a shaded picture as a PNG file in memory, by several threads.
 *
 * Layer: kernel. Blocks of 64 rows are packed apart, so the bytes are the same
 * for any number of threads. sRGB, and pHYs if `per_metre` is not 0; no text,
 * no time. Source: PNG specification (third edition); RFC 1950, 1951.
 */
#ifndef SG_IMAGE_PNG_H
#define SG_IMAGE_PNG_H

#include "png.h"
#include "shading/buffer.h"

/* OK, NO_MEMORY or STOPPED. Owner: free(*bytes) when it is OK, else null. */
sg_png_status sg_image_png(const sg_image *image, uint32_t per_metre,
                           sg_pool *pool, const sg_cancel *cancel,
                           uint8_t **bytes, size_t *n);

#endif
