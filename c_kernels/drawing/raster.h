/* raster.h -- lines as dots: Bresenham's algorithm with dot patterns.
 *
 * Layer: kernel. Integers only, as in the paper: no dot depends on rounding.
 * Source: [PL] section 6.4, row PL-14.
 */
#ifndef SG_RASTER_H
#define SG_RASTER_H

#include "engine/cancel.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
  SG_RASTER_SIDE = 16384,   /* most dots along one side */
  SG_RASTER_DOTS = 1 << 26, /* most dots in all */
  SG_RASTER_FAR = 1 << 20,  /* coordinates lie in -FAR .. FAR */
  SG_RASTER_PEN = 64        /* widest pen */
};

/* Dots by rows from the top, x to the right, y DOWN. 0 is paper, any other
 * number the ink of the pen that drew last. Owner: sg_raster_clear(). */
typedef struct sg_raster {
  int32_t width, height;
  uint8_t *dot; /* [height][width] */
} sg_raster;

/* A pen: its ink, its width in dots, and its pattern as run lengths on, off,
 * on, off, ...; no runs: a solid line. The paper's `pattern 3` is {3, 3}.
 * Borrowed: the pen does not own `run`. */
typedef struct sg_pen {
  uint8_t ink;
  int32_t width;      /* 1 .. SG_RASTER_PEN */
  size_t runs;        /* even */
  const int32_t *run; /* [runs], each positive */
} sg_pen;

/* True if both sides are 1 .. SG_RASTER_SIDE and the dots are not too many. */
bool sg_raster_size_is_valid(int32_t width, int32_t height);
bool sg_pen_is_valid(const sg_pen *pen);

/* A raster of blank paper. Requires a valid size. False: no memory. */
bool sg_raster_open(sg_raster *out, int32_t width, int32_t height);
void sg_raster_clear(sg_raster *raster);

/* Draws the chain point[0], point[1], ... point[n - 1]. The pattern runs on
 * across the joints, and a dot common to two pieces counts once. Dots outside
 * the raster count, but are not drawn. One point is one dot.
 * Requires: a valid pen, coordinates within SG_RASTER_FAR.
 * Returns false if `cancel` said stop. */
bool sg_raster_chain(sg_raster *raster, const sg_pen *pen, size_t n,
                     const int32_t (*point)[2], const sg_cancel *cancel);

#endif
