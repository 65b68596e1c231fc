/* buffer.h -- the dots of a shaded picture, made in bands by several threads.
 *
 * Layer: kernel. A band is 16 rows; nothing passes from band to band, so the
 * bytes are the same for any number of threads.
 */
#ifndef SG_BUFFER_H
#define SG_BUFFER_H

#include "cover.h"
#include "thread_pool.h"

enum { SG_IMAGE_BAND = 16 };

/* Rows from the top; `bytes` a dot: 3, red, green, blue (sRGB), or 4, also
 * alpha, not multiplied. Owner: sg_image_close(). */
typedef struct sg_image {
  int32_t width, height;
  unsigned bytes;
  uint8_t *dot; /* [height][width][bytes] */
} sg_image;

/* GOOD, NO_MEMORY or STOPPED; the picture is as large as the scene's frame. */
sg_shading_end sg_shade(const sg_shaded *in, sg_pool *pool,
                        const sg_cancel *cancel, sg_image **out);
/* The same of the rows from `from` to before `to`, an image of so many rows. */
sg_shading_end sg_shade_rows(const sg_shaded *in, int32_t from, int32_t to,
                             sg_pool *pool, const sg_cancel *cancel,
                             sg_image **out);
/* The same of a picture that differs from `old`, of the same size, in the
 * wanted dots of `n` bands alone; band i is rows i * SG_IMAGE_BAND and on.
 * Others are as they were. */
sg_shading_end sg_shade_again(const sg_shaded *in, const sg_image *old,
                              const size_t *band, size_t n, sg_pool *pool,
                              const sg_cancel *cancel, sg_image **out);
void sg_image_close(sg_image *image);

#endif
