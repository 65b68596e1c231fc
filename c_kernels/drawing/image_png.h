/* image_png.h -- a shaded picture as a PNG file in memory, by several threads;
 * of a large one part after part.
 *
 * Layer: kernel. Blocks of 64 rows, of wide pictures of fewer, are packed
 * apart, so the bytes are the same for any number of threads, and of parts.
 * sRGB, and pHYs if `per_metre` is not 0; no text, no time. Source: PNG
 * specification (third edition); RFC 1950, 1951.
 */
#ifndef SG_IMAGE_PNG_H
#define SG_IMAGE_PNG_H

#include "png.h"
#include "shading/buffer.h"

/* Rows of a block of a picture whose rows have so many bytes. */
int32_t sg_image_png_block(size_t row);

/* A file that is made part after part: zero but for `height`, that of all. */
typedef struct sg_png_parts {
  int32_t height, done; /* rows; those of the parts before */
  unsigned long check;  /* of what was packed */
  uint8_t *above;       /* the last row of the part before. Owner: clear */
} sg_png_parts;

void sg_png_parts_clear(sg_png_parts *parts);
/* The bytes of the next rows, `part`; with the first the head, with the last
 * the end. Requires: parts but the last have whole blocks. OK, NO_MEMORY or
 * STOPPED. Owner: free(*bytes) when it is OK, else null. */
sg_png_status sg_image_png_part(sg_png_parts *parts, const sg_image *part,
                                uint32_t per_metre, sg_pool *pool,
                                const sg_cancel *cancel, uint8_t **bytes,
                                size_t *n);

#endif
