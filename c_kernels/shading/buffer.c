/* buffer.c -- see buffer.h. */
#include "buffer.h"

#include "srgb.h"

#include <stdatomic.h>
#include <stdlib.h>

enum { BAND = 16 }; /* rows */

typedef struct bands {
  const sg_shaded *in;
  sg_image *image;
  uint8_t byte[SG_LIGHT_MOST + 1];
  atomic_bool no_memory;
} bands;

static bool
band_rows(const bands *all, size_t band, sg_dot_row *cover,
          sg_shading_work *work, sg_spans *spans)
{
  const sg_image *image = all->image;
  int32_t y = (int32_t)band * BAND, end = y + BAND;
  size_t row = (size_t)image->width * image->bytes;

  end = end < image->height ? end : image->height;
  for (; y < end && !sg_pool_stopping(); y++) {
    if (!sg_cover_row(cover, all->in, work, spans, y)) {
      return false;
    }
    sg_cover_bytes(cover, all->in, all->byte, image->dot + (size_t)y * row);
  }
  return true;
}

static void
do_band(void *data, size_t band)
{
  bands *all = data;
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
open_image(const sg_shaded *in)
{
  const sg_shading_frame *frame = sg_shading_frame_of(in->scene);
  sg_image *image = malloc(sizeof *image);

  if (image) {
    *image = (sg_image){.width = frame->width,
                        .height = frame->height,
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

sg_shading_end
sg_shade(const sg_shaded *in, sg_pool *pool, const sg_cancel *cancel,
         sg_image **out)
{
  bands *all = malloc(sizeof *all);
  sg_image *image = open_image(in);
  sg_shading_end end = SG_SHADING_NO_MEMORY;

  if (all && image) {
    all->in = in;
    all->image = image;
    atomic_init(&all->no_memory, false);
    sg_srgb_bytes(all->byte);
    end = !sg_pool_run(pool, (size_t)(image->height + BAND - 1) / BAND, do_band,
                       all, cancel)
              ? SG_SHADING_STOPPED
          : atomic_load(&all->no_memory) ? SG_SHADING_NO_MEMORY
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

void
sg_image_close(sg_image *image)
{
  if (image) {
    free(image->dot);
    free(image);
  }
}
