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
  INDEXED = 3,    /* colour type */
  POLL_LINES = 64 /* lines packed between two polls */
};

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

static unsigned
bits_for(size_t colours)
{
  return colours <= 2 ? 1 : colours <= 4 ? 2 : colours <= 16 ? 4 : 8;
}

static size_t
line_bytes(const sg_raster *raster, unsigned bits)
{
  return 1 + ((size_t)raster->width * bits + 7) / 8;
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

/* All lines through deflate, into `out`, which is large enough. */
static sg_png_status
pack(const sg_raster *raster, size_t colours, const sg_poll *poll,
     z_stream *zip, uint8_t *line)
{
  unsigned bits = bits_for(colours);

  for (int32_t y = 0; y < raster->height; y++) {
    const uint8_t *dot = raster->dot + (size_t)y * (size_t)raster->width;
    sg_png_status status = pack_line(dot, raster->width, bits, colours, line);

    if (status != SG_PNG_OK) {
      return status;
    }
    if (y % POLL_LINES == 0 && sg_poll_stop(poll)) {
      return SG_PNG_STOPPED;
    }
    zip->next_in = line;
    zip->avail_in = (uInt)line_bytes(raster, bits);
    if (deflate(zip, Z_NO_FLUSH) != Z_OK) {
      return SG_PNG_NO_MEMORY;
    }
  }
  zip->avail_in = 0;
  return deflate(zip, Z_FINISH) == Z_STREAM_END ? SG_PNG_OK : SG_PNG_NO_MEMORY;
}

/* Deflates the raster to out->byte + out->n; *n is the length. */
static sg_png_status
deflate_raster(const sg_raster *raster, size_t colours, const sg_poll *poll,
               uint8_t *room, size_t *n)
{
  z_stream zip = {0};
  uint8_t *line = malloc(line_bytes(raster, bits_for(colours)));
  sg_png_status status = SG_PNG_NO_MEMORY;

  if (line && deflateInit(&zip, Z_BEST_COMPRESSION) == Z_OK) {
    zip.next_out = room;
    zip.avail_out = (uInt)*n;
    status = pack(raster, colours, poll, &zip, line);
    *n = zip.total_out;
    (void)deflateEnd(&zip);
  }
  free(line);
  return status;
}

static void
put_header(buffer *out, const sg_raster *raster, size_t colours)
{
  static const uint8_t signature[8] = {137, 80, 78, 71, 13, 10, 26, 10};
  uint8_t header[HEADER] = {0};
  buffer size = {header, 0};

  put_bytes(out, signature, sizeof signature);
  put_number(&size, (size_t)raster->width);
  put_number(&size, (size_t)raster->height);
  header[8] = (uint8_t)bits_for(colours);
  header[9] = INDEXED;
  put_chunk(out, "IHDR", header, HEADER);
}

sg_png_status
sg_png_write(const sg_raster *raster, size_t colours, const sg_colour *palette,
             const sg_poll *poll, uint8_t **bytes, size_t *n)
{
  size_t raw = line_bytes(raster, bits_for(colours)) * (size_t)raster->height;
  size_t packed = compressBound(raw) + 64;
  size_t room = 8 + CHUNK + HEADER + CHUNK + 3 * colours + CHUNK + CHUNK;
  buffer out = {malloc(room + packed), 0};
  sg_png_status status;

  assert(colours >= 1 && colours <= 256);
  *bytes = NULL;
  if (!out.byte) {
    return SG_PNG_NO_MEMORY;
  }
  put_header(&out, raster, colours);
  put_chunk(&out, "PLTE", (const uint8_t *)palette, 3 * colours);
  status = deflate_raster(raster, colours, poll, out.byte + out.n + 8, &packed);
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
