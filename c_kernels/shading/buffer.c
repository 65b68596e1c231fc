/* buffer.c -- see buffer.h. */
#include "buffer.h"

#include "srgb.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

typedef struct bands {
  const sg_shaded *in;
  sg_image *image;
  int32_t first;      /* row of the picture, the first of the image */
  const size_t *band; /* of each task; null: its own number */
  uint8_t byte[SG_LIGHT_MOST + 1];
  atomic_bool no_memory;
} bands;

static bool
band_rows(const bands *all, size_t band, sg_dot_row *cover,
          sg_shading_work *work, sg_spans *spans)
{
  const sg_image *image = all->image;
  int32_t y = (int32_t)band * SG_IMAGE_BAND, end = y + SG_IMAGE_BAND;
  size_t row = (size_t)image->width * image->bytes;

  end = end < image->height ? end : image->height;
  for (; y < end && !sg_pool_stopping(); y++) {
    if (!sg_cover_row(cover, all->in, work, spans, all->first + y)) {
      return false;
    }
    sg_cover_bytes(cover, all->in, all->byte, image->dot + (size_t)y * row);
  }
  return true;
}

static void
do_band(void *data, size_t task)
{
  bands *all = data;
  size_t band = all->band ? all->band[task] : task;
  sg_spans spans = {0};
  sg_dot_row cover = {0};
  sg_shading_work *work =
      sg_shading_work_open(all->in->scene, all->in->opacities);

  if (!work || !sg_cover_open(&cover, all->image->width) ||
      !band_rows(all, band, &cover, work, &spans)) {
    atomic_store(&all->no_memory, true);
  }
  sg_cover_close(&cover);
  free(spans.span);
  if (work) {
    sg_shading_work_close(work);
  }
}

static sg_image *
open_image(const sg_shaded *in, int32_t height)
{
  sg_image *image = malloc(sizeof *image);

  if (image) {
    *image = (sg_image){.width = sg_shading_frame_of(in->scene)->width,
                        .height = height,
                        .bytes = in->clear ? 4 : 3};
    image->dot =
        malloc((size_t)image->width * (size_t)image->height * image->bytes);
    if (!image->dot) {
      free(image);
      image = NULL;
    }
  }
  return image;
}

/* Bands n of the image, all if `band` is null; the others are those of `old`.
 * Its first row is that row of the picture. */
static sg_shading_end
shade_bands(const sg_shaded *in, int32_t first, sg_image *image,
            const sg_image *old, const size_t *band, size_t n, sg_pool *pool,
            const sg_cancel *cancel, sg_image **out)
{
  bands *all = malloc(sizeof *all);
  sg_shading_end end = SG_SHADING_NO_MEMORY;

  if (all && image) {
    all->in = in;
    all->image = image;
    all->first = first;
    all->band = band;
    if (old) {
      memcpy(image->dot, old->dot,
             (size_t)image->width * (size_t)image->height * image->bytes);
    }
    atomic_init(&all->no_memory, false);
    sg_srgb_bytes(all->byte);
    end = !sg_pool_run(pool, n, do_band, all, cancel) ? SG_SHADING_STOPPED
          : atomic_load(&all->no_memory)              ? SG_SHADING_NO_MEMORY
                                                      : SG_SHADING_GOOD;
  }
  free(all);
  if (end != SG_SHADING_GOOD) {
    sg_image_close(image);
    image = NULL;
  }
  *out = image;
  return end;
}

sg_shading_end
sg_shade_rows(const sg_shaded *in, int32_t from, int32_t to, sg_pool *pool,
              const sg_cancel *cancel, sg_image **out)
{
  size_t rows = (size_t)(to - from);

  return shade_bands(in, from, open_image(in, to - from), NULL, NULL,
                     (rows + SG_IMAGE_BAND - 1) / SG_IMAGE_BAND, pool, cancel,
                     out);
}

sg_shading_end
sg_shade(const sg_shaded *in, sg_pool *pool, const sg_cancel *cancel,
         sg_image **out)
{
  return sg_shade_rows(in, 0, sg_shading_frame_of(in->scene)->height, pool,
                       cancel, out);
}

sg_shading_end
sg_shade_again(const sg_shaded *in, const sg_image *old, const size_t *band,
               size_t n, sg_pool *pool, const sg_cancel *cancel, sg_image **out)
{
  return shade_bands(in, 0, open_image(in, old->height), old, band, n, pool,
                     cancel, out);
}

void
sg_image_close(sg_image *image)
{
  if (image) {
    free(image->dot);
    free(image);
  }
}
