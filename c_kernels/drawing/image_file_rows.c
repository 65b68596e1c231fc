/* image_file_rows.c -- dots in files; of a large picture as they are made. */
#include "doors/image.h"

#include "image_change.h"
#include "image_lzw.h"
#include "image_png.h"
#include "raster_rows.h"
#include "shaded_rows.h"

#include <stdio.h>
#include <stdlib.h>

/* The arguments that are refused. */
enum { IMAGE = 1, FILE_ASKED = 5 };

/* So many bytes of a large picture are there at once, or a few rows. */
enum { PART_BYTES = 1 << 25, PART_BLOCKS = 4 };

/* Sides, and dots, of what is made as it is written. */
enum { WIDEST = 1 << 20 };
static const uint64_t most_dots = (uint64_t)1 << 31;

/* ---- rows ---- */

/* Of grey dots one byte each. */
static bool
write_grey(sg_call *call, const sg_image *image, const sg_output *stream)
{
  size_t width = (size_t)image->width;
  char *row = sg_call_alloc(call, width);
  bool good = row != NULL;

  for (int32_t y = 0; good && y < image->height; y++) {
    const uint8_t *dot = image->dot + (size_t)y * width * 3;
    for (size_t x = 0; x < width; x++) {
      row[x] = (char)dot[3 * x];
    }
    good = stream->write(stream->data, row, width);
  }
  return good;
}

static bool
write_dots(const sg_image *image, const sg_output *stream)
{
  size_t row = (size_t)image->width * image->bytes;
  bool good = true;

  for (int32_t y = 0; good && y < image->height; y++) {
    good = stream->write(stream->data,
                         (const char *)image->dot + (size_t)y * row, row);
  }
  return good;
}

static bool
write_head(const char *kind, int32_t width, int32_t height,
           const sg_output *stream)
{
  char head[64];
  int n = snprintf(head, sizeof head, "%s\n%d %d\n255\n", kind, (int)width,
                   (int)height);

  return stream->write(stream->data, head, (size_t)n);
}

static bool
has_no_alpha(sg_call *call, bool alpha)
{
  return !alpha || sg_call_domain(call, "image_without_alpha", IMAGE);
}

/* The next rows of a PNG file. */
static bool
write_png(sg_call *call, sg_png_parts *parts, const sg_image *part,
          size_t per_metre, const sg_output *stream)
{
  sg_pool *pool = sg_call_pool(call);
  uint8_t *bytes;
  size_t n;

  if (!pool) {
    return false;
  }
  switch (sg_image_png_part(parts, part, (uint32_t)per_metre, pool,
                            &call->cancel, &bytes, &n)) {
  case SG_PNG_OK:
    break;
  case SG_PNG_NO_MEMORY:
    return sg_call_no_memory(call);
  case SG_PNG_NO_COLOUR:
  case SG_PNG_STOPPED:
    return sg_call_ended(call);
  }
  bool good = stream->write(stream->data, (const char *)bytes, n);

  free(bytes);
  return good;
}

/* ---- images ---- */

bool
sg_door_image_png(sg_call *call, sg_image *image, size_t per_metre,
                  const sg_output *stream)
{
  sg_png_parts parts = {.height = image->height};

  return write_png(call, &parts, image, per_metre, stream);
}

bool
sg_door_image_ppm(sg_call *call, sg_image *image, const sg_output *stream)
{
  return has_no_alpha(call, image->bytes != 3) &&
         write_head("P6", image->width, image->height, stream) &&
         write_dots(image, stream);
}

bool
sg_door_image_lzw(sg_call *call, sg_image *image, const sg_output *stream)
{
  size_t n = (size_t)image->width * (size_t)image->height * image->bytes;
  uint8_t *bytes;
  size_t packed;

  if (image->bytes != 3) {
    return sg_call_domain(call, "image_without_alpha", IMAGE);
  }
  if (!sg_image_lzw(image->dot, n, &bytes, &packed)) {
    return sg_call_no_memory(call);
  }
  bool good = stream->write(stream->data, (const char *)bytes, packed);

  free(bytes);
  return good;
}

/* ---- pictures that are written as they are made ---- */

typedef struct making {
  const sg_shaded *in;
  const sg_image_file *file;
  const sg_colour *colour; /* [file->colours.n] */
  int32_t width, height;
  sg_png_parts png;
} making;

static bool
read_colours(sg_call *call, const sg_rgb_list *list, sg_colour *colour)
{
  if (list->n > 256) {
    return sg_call_domain(call, "colours", FILE_ASKED);
  }
  for (size_t i = 0; i < list->n; i++) {
    if (!sg_rgb_colour(call, &list->at[i], colour[i])) {
      return false;
    }
  }
  return true;
}

static bool
size_is_good(sg_call *call, int32_t width, int32_t height)
{
  return (width <= WIDEST && height <= WIDEST &&
          (uint64_t)width * (uint64_t)height <= most_dots) ||
         sg_call_domain(call, "picture_size", IMAGE);
}

/* So many rows are made at once: whole blocks of a PNG file. */
static int32_t
rows_at_once(const making *m)
{
  size_t row = (size_t)m->width * (m->in->clear ? 4 : 3);
  size_t block = (size_t)sg_image_png_block(row);
  size_t blocks = PART_BYTES / (row * block);

  blocks = blocks > PART_BLOCKS ? blocks : PART_BLOCKS;
  blocks = m->file->blocks > 0 ? m->file->blocks : blocks;
  return blocks * block < (size_t)m->height ? (int32_t)(blocks * block)
                                            : m->height;
}

static bool
write_part(sg_call *call, making *m, sg_image *part, const sg_output *stream)
{
  if (m->file->colours.n > 0) {
    sg_image_colours(part, m->file->colours.n, m->colour);
  }
  switch (m->file->format) {
  case SG_IMAGE_FORMAT_PNG:
    return write_png(call, &m->png, part, m->file->per_metre, stream);
  case SG_IMAGE_FORMAT_PPM:
    return write_dots(part, stream);
  case SG_IMAGE_FORMAT_PGM:
    break;
  }
  return write_grey(call, part, stream);
}

static bool
write_parts(sg_call *call, making *m, const sg_output *stream)
{
  sg_pool *pool = sg_call_pool(call);
  int32_t rows = rows_at_once(m);
  bool good = pool != NULL;

  if (m->file->format != SG_IMAGE_FORMAT_PNG) {
    good =
        good && write_head(m->file->format == SG_IMAGE_FORMAT_PPM ? "P6" : "P5",
                           m->width, m->height, stream);
  }
  for (int32_t y = 0; good && y < m->height; y += rows) {
    int32_t to = rows < m->height - y ? y + rows : m->height;
    sg_image *part;

    good = sg_shaded_ended(
               call, sg_shade_rows(m->in, y, to, pool, &call->cancel, &part)) &&
           write_part(call, m, part, stream);
    sg_image_close(part);
  }
  return good;
}

bool
sg_door_image_written(sg_call *call, sg_shading *scene, const sg_image_how *how,
                      const sg_shading_look_list *looks,
                      const sg_list_count_list *leaves,
                      const sg_image_file *file, const sg_output *stream)
{
  const sg_shading_frame *frame = sg_shading_frame_of(scene);
  sg_shaded in = {.scene = scene};
  sg_opacities opacities;
  sg_colour *colour =
      sg_call_alloc(call, (file->colours.n + 1) * sizeof *colour);

  if (!colour || !size_is_good(call, frame->width, frame->height) ||
      !read_colours(call, &file->colours, colour) ||
      !sg_shaded_read(call, how, looks, leaves, &in, &opacities)) {
    return false;
  }
  bool plain = file->format != SG_IMAGE_FORMAT_PNG || file->colours.n > 0;
  making m = {.in = &in,
              .file = file,
              .colour = (const sg_colour *)colour,
              .width = frame->width,
              .height = frame->height,
              .png = {.height = frame->height}};
  bool good =
      has_no_alpha(call, plain && in.clear) && write_parts(call, &m, stream);

  sg_png_parts_clear(&m.png);
  return good;
}
