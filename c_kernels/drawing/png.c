/* png.c -- see png.h.
 *
 * Every line is written without a filter: drawings are runs of one ink, which
 * deflate packs well as they are.
 */
#include "png.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

enum {
  CHUNK = 12,     /* length, type and check sum round a chunk's data */
  HEADER = 13,    /* data bytes of IHDR */
  PHYSICAL = 9,   /* data bytes of pHYs */
  TRUECOLOUR = 2, /* colour types */
  INDEXED = 3,
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

/* Bytes being written; `n` counts them. */
typedef struct buffer {
  uint8_t *byte;
  size_t n;
} buffer;

static void
put_number(buffer *out, size_t number)
{
  for (int shift = 24; shift >= 0; shift -= 8) {
    out->byte[out->n++] = (uint8_t)(number >> shift);
  }
}

static void
put_bytes(buffer *out, const void *bytes, size_t n)
{
  memcpy(out->byte + out->n, bytes, n);
  out->n += n;
}

/* A chunk round `n` bytes of data; a null `data` is in its place already. */
static void
put_chunk(buffer *out, const char *type, const uint8_t *data, size_t n)
{
  put_number(out, n);

  size_t checked = out->n;

  put_bytes(out, type, 4);
  if (data) {
    put_bytes(out, data, n);
  } else {
    out->n += n;
  }
  put_number(out, crc32(0, out->byte + checked, (uInt)(n + 4)));
}

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

static void
put_header(buffer *out, const image *in)
{
  static const uint8_t signature[8] = {137, 80, 78, 71, 13, 10, 26, 10};
  uint8_t header[HEADER] = {0};
  buffer size = {header, 0};

  put_bytes(out, signature, sizeof signature);
  put_number(&size, (size_t)in->width);
  put_number(&size, (size_t)in->height);
  header[8] = (uint8_t)sample_bits(in);
  header[9] = in->colours == 0 ? TRUECOLOUR : INDEXED;
  put_chunk(out, "IHDR", header, HEADER);
}

/* How many dots a metre has, which makes the picture as large as it is. */
static void
put_physical(buffer *out, uint32_t per_metre)
{
  uint8_t physical[PHYSICAL];
  buffer size = {physical, 0};

  put_number(&size, per_metre);
  put_number(&size, per_metre);
  physical[PHYSICAL - 1] = 1; /* the unit is the metre */
  put_chunk(out, "pHYs", physical, PHYSICAL);
}

static sg_png_status
write_image(const image *in, const sg_cancel *cancel, uint8_t **bytes,
            size_t *n)
{
  size_t raw = line_bytes(in) * (size_t)in->height;
  size_t packed = compressBound(raw) + 64;
  size_t room = 8 + 5 * CHUNK + HEADER + PHYSICAL + 3 * in->colours;
  buffer out = {malloc(room + packed), 0};
  sg_png_status status;

  *bytes = NULL;
  if (!out.byte) {
    return SG_PNG_NO_MEMORY;
  }
  put_header(&out, in);
  if (in->per_metre > 0) {
    put_physical(&out, in->per_metre);
  }
  if (in->colours > 0) {
    put_chunk(&out, "PLTE", (const uint8_t *)in->palette, 3 * in->colours);
  }
  status = deflate_image(in, cancel, out.byte + out.n + 8, &packed);
  if (status != SG_PNG_OK) {
    free(out.byte);
    return status;
  }
  put_chunk(&out, "IDAT", NULL, packed);
  put_chunk(&out, "IEND", (const uint8_t *)"", 0);
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
