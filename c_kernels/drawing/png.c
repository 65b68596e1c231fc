/* png.c -- see png.h.
 *
 * Every line is written without a filter: drawings are runs of one ink, which
 * deflate packs well as they are.
 */
#include "png.h"

#include "png_chunk.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

enum {
  POLL_LINES = 64 /* lines packed between two cancellations */
};

/* What is written: dots as numbers in a palette, or, without one, as three
 * bytes each. */
typedef struct image {
  int32_t width, height;
  const uint8_t *dot;
  size_t colours; /* of the palette; 0: none */
  const sg_colour *palette;
  uint32_t per_metre; /* dots; 0: not said */
} image;

static unsigned /* bits of a sample: of a dot, if there is a palette */
sample_bits(const image *in)
{
  size_t colours = in->colours;

  if (colours == 0) {
    return 8;
  }
  return colours <= 2 ? 1 : colours <= 4 ? 2 : colours <= 16 ? 4 : 8;
}

static size_t
dot_bytes(const image *in) /* in memory */
{
  return in->colours == 0 ? sizeof(sg_colour) : 1;
}

static size_t
line_bytes(const image *in)
{
  size_t bits = sample_bits(in) * dot_bytes(in);

  return 1 + ((size_t)in->width * bits + 7) / 8;
}

/* One line of dots, high bits first, after its filter byte 0. */
static sg_png_status
pack_line(const uint8_t *dot, int32_t width, unsigned bits, size_t colours,
          uint8_t *out)
{
  *out = 0;
  for (int32_t x = 0; x < width; x++) {
    unsigned place = (unsigned)x * bits % 8;

    if (dot[x] >= colours) {
      return SG_PNG_NO_COLOUR;
    }
    if (place == 0) {
      *++out = 0;
    }
    *out |= (uint8_t)(dot[x] << (8 - bits - place));
  }
  return SG_PNG_OK;
}

static sg_png_status
pack_any_line(const image *in, int32_t y, uint8_t *line)
{
  size_t length = (size_t)in->width * dot_bytes(in);
  const uint8_t *dot = in->dot + (size_t)y * length;

  if (in->colours > 0) {
    return pack_line(dot, in->width, sample_bits(in), in->colours, line);
  }
  line[0] = 0;
  memcpy(line + 1, dot, length);
  return SG_PNG_OK;
}

/* All lines through deflate, into `zip`'s room, which is large enough. */
static sg_png_status
pack(const image *in, const sg_cancel *cancel, z_stream *zip, uint8_t *line)
{
  for (int32_t y = 0; y < in->height; y++) {
    sg_png_status status = pack_any_line(in, y, line);

    if (status != SG_PNG_OK) {
      return status;
    }
    if (y % POLL_LINES == 0 && sg_cancelled(cancel)) {
      return SG_PNG_STOPPED;
    }
    zip->next_in = line;
    zip->avail_in = (uInt)line_bytes(in);
    if (deflate(zip, Z_NO_FLUSH) != Z_OK) {
      return SG_PNG_NO_MEMORY;
    }
  }
  zip->avail_in = 0;
  return deflate(zip, Z_FINISH) == Z_STREAM_END ? SG_PNG_OK : SG_PNG_NO_MEMORY;
}

/* Deflates the image to `room`; *n is how much there is, then the length. */
static sg_png_status
deflate_image(const image *in, const sg_cancel *cancel, uint8_t *room,
              size_t *n)
{
  z_stream zip = {0};
  uint8_t *line = malloc(line_bytes(in));
  sg_png_status status = SG_PNG_NO_MEMORY;

  if (line && deflateInit(&zip, Z_BEST_COMPRESSION) == Z_OK) {
    zip.next_out = room;
    zip.avail_out = (uInt)*n;
    status = pack(in, cancel, &zip, line);
    *n = zip.total_out;
    (void)deflateEnd(&zip);
  }
  free(line);
  return status;
}

static sg_png_status
write_image(const image *in, const sg_cancel *cancel, uint8_t **bytes,
            size_t *n)
{
  size_t raw = line_bytes(in) * (size_t)in->height;
  size_t packed = compressBound(raw) + 64;
  size_t room = SG_PNG_HEAD + 3 * in->colours;
  sg_png_file out = {malloc(room + packed), 0};
  sg_png_status status;

  *bytes = NULL;
  if (!out.byte) {
    return SG_PNG_NO_MEMORY;
  }
  sg_png_start(&out, in->width, in->height, sample_bits(in),
               in->colours == 0 ? SG_PNG_TRUECOLOUR : SG_PNG_INDEXED);
  if (in->per_metre > 0) {
    sg_png_physical(&out, in->per_metre);
  }
  if (in->colours > 0) {
    sg_png_chunk(&out, "PLTE", (const uint8_t *)in->palette, 3 * in->colours);
  }
  status = deflate_image(in, cancel, out.byte + out.n + 8, &packed);
  if (status != SG_PNG_OK) {
    free(out.byte);
    return status;
  }
  sg_png_chunk(&out, "IDAT", NULL, packed);
  sg_png_chunk(&out, "IEND", (const uint8_t *)"", 0);
  *bytes = out.byte;
  *n = out.n;
  return SG_PNG_OK;
}

sg_png_status
sg_png_write(const sg_raster *raster, size_t colours, const sg_colour *palette,
             const sg_cancel *cancel, uint8_t **bytes, size_t *n)
{
  image in = {raster->width, raster->height, raster->dot, colours, palette, 0};

  assert(colours >= 1 && colours <= 256);
  return write_image(&in, cancel, bytes, n);
}

sg_png_status
sg_png_write_canvas(const sg_canvas *canvas, uint32_t per_metre,
                    const sg_cancel *cancel, uint8_t **bytes, size_t *n)
{
  image in = {canvas->width, canvas->height, (const uint8_t *)canvas->dot, 0,
              NULL,          per_metre};

  return write_image(&in, cancel, bytes, n);
}
