/* png_chunk.h -- the chunks of a PNG file, into memory that is large enough.
 *
 * Layer: kernel. Source: PNG specification (third edition), sections 5 and 11.
 */
#ifndef SG_PNG_CHUNK_H
#define SG_PNG_CHUNK_H

#include <stddef.h>
#include <stdint.h>

enum {
  SG_PNG_CHUNK = 12,     /* length, type and check sum round a chunk's data */
  SG_PNG_HEAD = 160,     /* room for all that is here but what stands in IDAT
                            and PLTE */
  SG_PNG_TRUECOLOUR = 2, /* colour types */
  SG_PNG_INDEXED = 3,
  SG_PNG_WITH_ALPHA = 6
};

/* Bytes being written; `n` counts them. */
typedef struct sg_png_file {
  uint8_t *byte;
  size_t n;
} sg_png_file;

/* A chunk round `n` bytes of data; a null `data` is in its place already. */
void sg_png_chunk(sg_png_file *out, const char *type, const uint8_t *data,
                  size_t n);

/* The signature and IHDR. */
void sg_png_start(sg_png_file *out, int32_t width, int32_t height,
                  unsigned bits, unsigned colour_type);
/* pHYs: so many dots are a metre, which makes the picture as large as it is. */
void sg_png_physical(sg_png_file *out, uint32_t per_metre);
/* sRGB: what its bytes mean. */
void sg_png_srgb(sg_png_file *out);

#endif
