/* png_chunk.c -- see png_chunk.h. */
#include "png_chunk.h"

#include <string.h>
#include <zlib.h>

enum {
  HEADER = 13, /* data bytes of IHDR */
  PHYSICAL = 9 /* of pHYs */
};

static void
put_number(sg_png_file *out, size_t number)
{
  for (int shift = 24; shift >= 0; shift -= 8) {
    out->byte[out->n++] = (uint8_t)(number >> shift);
  }
}

static void
put_bytes(sg_png_file *out, const void *bytes, size_t n)
{
  memcpy(out->byte + out->n, bytes, n);
  out->n += n;
}

void
sg_png_chunk(sg_png_file *out, const char *type, const uint8_t *data, size_t n)
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

void
sg_png_start(sg_png_file *out, int32_t width, int32_t height, unsigned bits,
             unsigned colour_type)
{
  static const uint8_t signature[8] = {137, 80, 78, 71, 13, 10, 26, 10};
  uint8_t header[HEADER] = {0};
  sg_png_file size = {header, 0};

  put_bytes(out, signature, sizeof signature);
  put_number(&size, (size_t)width);
  put_number(&size, (size_t)height);
  header[8] = (uint8_t)bits;
  header[9] = (uint8_t)colour_type;
  sg_png_chunk(out, "IHDR", header, HEADER);
}

void
sg_png_physical(sg_png_file *out, uint32_t per_metre)
{
  uint8_t physical[PHYSICAL];
  sg_png_file size = {physical, 0};

  put_number(&size, per_metre);
  put_number(&size, per_metre);
  physical[PHYSICAL - 1] = 1; /* the unit is the metre */
  sg_png_chunk(out, "pHYs", physical, PHYSICAL);
}

void
sg_png_srgb(sg_png_file *out)
{
  const uint8_t intent = 0; /* perceptual */

  sg_png_chunk(out, "sRGB", &intent, 1);
}
