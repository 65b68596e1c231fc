/* raster.c -- see raster.h. */
#include "raster.h"

#include <assert.h>
#include <stdlib.h>

enum { POLL_DOTS = 1 << 18 };

/* Where a chain stands in its pattern. */
typedef struct phase {
  size_t run;   /* even: the pen is down */
  int32_t left; /* dots left of this run */
} phase;

/* A chain being drawn. */
typedef struct stroke {
  sg_raster *raster;
  const sg_pen *pen;
  phase phase;
  uint32_t dots; /* since the last cancel */
} stroke;

bool
sg_raster_size_is_valid(int32_t width, int32_t height)
{
  return width >= 1 && height >= 1 && width <= SG_RASTER_SIDE &&
         height <= SG_RASTER_SIDE && (int64_t)width * height <= SG_RASTER_DOTS;
}

bool
sg_pen_is_valid(const sg_pen *pen)
{
  if (pen->width < 1 || pen->width > SG_RASTER_PEN || pen->runs % 2 != 0) {
    return false;
  }
  for (size_t i = 0; i < pen->runs; i++) {
    if (pen->run[i] < 1) {
      return false;
    }
  }
  return true;
}

bool
sg_raster_open(sg_raster *out, int32_t width, int32_t height)
{
  assert(sg_raster_size_is_valid(width, height));
  out->width = width;
  out->height = height;
  out->dot = calloc((size_t)width * (size_t)height, 1);
  return out->dot != NULL;
}

void
sg_raster_clear(sg_raster *raster)
{
  free(raster->dot);
  raster->dot = NULL;
}

static void
put(sg_raster *raster, int32_t x, int32_t y, uint8_t ink)
{
  if (x >= 0 && y >= 0 && x < raster->width && y < raster->height) {
    raster->dot[(size_t)y * (size_t)raster->width + (size_t)x] = ink;
  }
}

/* A round nib: the dots whose middles lie within width / 2 of its middle. */
static void
stamp(sg_raster *raster, const sg_pen *pen, int32_t x, int32_t y)
{
  int32_t w = pen->width;

  for (int32_t j = 0; j < w; j++) {
    for (int32_t i = 0; i < w; i++) {
      int32_t dx = 2 * i - (w - 1), dy = 2 * j - (w - 1);

      if (dx * dx + dy * dy <= w * w) {
        put(raster, x + i - (w - 1) / 2, y + j - (w - 1) / 2, pen->ink);
      }
    }
  }
}

/* True if the pen is down at this dot; moves the pattern on by one dot. */
static bool
pen_down(const sg_pen *pen, phase *at)
{
  bool down = at->run % 2 == 0;

  if (pen->runs > 0 && --at->left == 0) {
    at->run = (at->run + 1) % pen->runs;
    at->left = pen->run[at->run];
  }
  return down;
}

static void
dot(stroke *s, int32_t x, int32_t y)
{
  s->dots++;
  if (pen_down(s->pen, &s->phase)) {
    stamp(s->raster, s->pen, x, y);
  }
}

/* The dots after a, to b itself. */
static void
piece(stroke *s, const int32_t a[2], const int32_t b[2])
{
  int32_t x = a[0], y = a[1];
  int32_t dx = abs(b[0] - x), dy = abs(b[1] - y);
  int32_t sx = b[0] < x ? -1 : 1, sy = b[1] < y ? -1 : 1;
  int32_t error = dx - dy;

  while (x != b[0] || y != b[1]) {
    int32_t twice = 2 * error;

    if (twice > -dy) {
      error -= dy;
      x += sx;
    }
    if (twice < dx) {
      error += dx;
      y += sy;
    }
    dot(s, x, y);
  }
}

bool
sg_raster_chain(sg_raster *raster, const sg_pen *pen, size_t n,
                const int32_t (*point)[2], const sg_cancel *cancel)
{
  stroke s = {raster, pen, {0, pen->runs > 0 ? pen->run[0] : 0}, 0};

  assert(sg_pen_is_valid(pen));
  if (n > 0) {
    dot(&s, point[0][0], point[0][1]);
  }
  for (size_t i = 1; i < n; i++) {
    piece(&s, point[i - 1], point[i]);
    if (s.dots >= POLL_DOTS) {
      s.dots = 0;
      if (sg_cancelled(cancel)) {
        return false;
      }
    }
  }
  return true;
}
