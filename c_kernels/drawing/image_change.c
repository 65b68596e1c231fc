/* image_change.c -- see image_change.h. */
#include "image_change.h"

#include "shading/srgb.h"

#include <stdlib.h>
#include <string.h>

sg_image *
sg_image_blank(int32_t width, int32_t height, const sg_colour colour)
{
  size_t dots = (size_t)width * (size_t)height;
  sg_image *image = malloc(sizeof *image);

  if (!image) {
    return NULL;
  }
  *image = (sg_image){.width = width,
                      .height = height,
                      .bytes = 3,
                      .dot = malloc(dots * sizeof(sg_colour))};
  if (!image->dot) {
    free(image);
    return NULL;
  }
  for (size_t i = 0; i < dots; i++) {
    memcpy(image->dot + 3 * i, colour, sizeof(sg_colour));
  }
  return image;
}

/* ---- one over the other ---- */

static void
put_dot(uint8_t *under, const uint8_t *over, unsigned bytes)
{
  uint32_t part = bytes == 4 ? over[3] : UINT8_MAX;

  if (part == UINT8_MAX) {
    memcpy(under, over, 3);
  } else if (part > 0) {
    for (int c = 0; c < 3; c++) {
      uint32_t light = part * sg_srgb_light(over[c]) +
                       (UINT8_MAX - part) * sg_srgb_light(under[c]);
      under[c] = sg_srgb_byte((light + UINT8_MAX / 2) / UINT8_MAX);
    }
  }
}

void
sg_image_put(sg_image *image, int32_t x, int32_t y, const sg_image *part)
{
  for (int32_t row = 0; row < part->height; row++) {
    for (int32_t at = 0; at < part->width; at++) {
      int64_t to_x = (int64_t)x + at, to_y = (int64_t)y + row;

      if (to_x >= 0 && to_x < image->width && to_y >= 0 &&
          to_y < image->height) {
        size_t to = (size_t)to_y * (size_t)image->width + (size_t)to_x;
        size_t from = (size_t)row * (size_t)part->width + (size_t)at;
        put_dot(image->dot + 3 * to, part->dot + part->bytes * from,
                part->bytes);
      }
    }
  }
}

/* ---- fewer colours ---- */

static size_t
nearest(const uint8_t *dot, size_t colours, const sg_colour *colour)
{
  int32_t least = INT32_MAX;
  size_t out = 0;

  for (size_t i = 0; i < colours; i++) {
    int32_t sum = 0;
    for (int c = 0; c < 3; c++) {
      int32_t apart = (int32_t)dot[c] - colour[i][c];
      sum += apart * apart;
    }
    if (sum < least) {
      least = sum;
      out = i;
    }
  }
  return out;
}

enum { KNOWN = 4096 };

void
sg_image_colours(sg_image *image, size_t colours, const sg_colour *colour)
{
  size_t dots = (size_t)image->width * (size_t)image->height;
  struct {
    uint32_t dot; /* and a bit that is always set */
    uint32_t of;
  } known[KNOWN] = {{0, 0}}; /* what was found last of such dots */

  for (size_t i = 0; i < dots; i++) {
    uint8_t *dot = image->dot + 3 * i;
    uint32_t key = 1U << 24 | (uint32_t)dot[0] << 16 | (uint32_t)dot[1] << 8 |
                   (uint32_t)dot[2];
    size_t at = key * 2654435761U >> 20;

    if (known[at].dot != key) {
      known[at].dot = key;
      known[at].of = (uint32_t)nearest(dot, colours, colour);
    }
    memcpy(dot, colour[known[at].of], sizeof *colour);
  }
}
