/* contour_told.c -- see contour.h: outlines of triangles that no piece tells
 * of.
 */
#include "contour_private.h"

#include "bounds.h"

#include <math.h>

/* A piece tells of what is nearer to it than this part of the longer side of
 * its segment's picture. */
#define LINE 1e-3

/* -------------------------------------------------------- in the picture */

static double
measured_size(const sg_contour_finder *f, size_t s)
{
  const sg_dense *d = f->in->dense;
  double size = 0.0;

  for (int k = 0; k < 2; k++) {
    double low = INFINITY, high = -INFINITY;
    for (uint32_t v = d->vertex_begin[s]; v < d->vertex_begin[s + 1]; v++) {
      low = sg_smaller(low, f->in->screen[v][k]);
      high = sg_larger(high, f->in->screen[v][k]);
    }
    size = sg_larger(size, high - low);
  }
  return size;
}

/* The longer side of the picture of the segment of triangle t. */
static double
picture_size(sg_contour_finder *f, uint32_t t)
{
  size_t s = sg_dense_segment_of(f->in->dense, f->in->dense->triangle_begin, t);

  if (f->measured != s + 1) {
    f->measured = s + 1;
    f->size = measured_size(f, s);
  }
  return f->size;
}

/* How far the middle of a side is from a piece. */
static double
distance(const sg_contour_finder *f, uint32_t side, const sg_contour *piece)
{
  const double *v = f->in->screen[sg_contour_vertex(f, side)];
  const double *w = f->in->screen[sg_contour_vertex(f, sg_contour_next(side))];
  double a[3], b[3], along[2], from[2], square, part = 0.0;

  sg_contour_point(f, piece, 0, a);
  sg_contour_point(f, piece, 1, b);
  for (int k = 0; k < 2; k++) {
    along[k] = b[k] - a[k];
    from[k] = (v[k] + w[k]) / 2.0 - a[k];
  }
  square = along[0] * along[0] + along[1] * along[1];
  if (square > 0.0) {
    part = (from[0] * along[0] + from[1] * along[1]) / square;
    part = sg_smaller(sg_larger(part, 0.0), 1.0);
  }
  return hypot(from[0] - part * along[0], from[1] - part * along[1]);
}

/* ------------------------------------------------------------- who tells */

static bool
tells(const sg_contour_finder *f, uint32_t side, uint32_t t, double near)
{
  sg_contour piece;

  return f->sense[t] != 0 && sg_contour_across(f, t, &piece) &&
         distance(f, side, &piece) < near;
}

/* The corner that follows in its fan, one way round or the other; SG_NO_SIDE:
 * there is none. */
static uint32_t
turned(const sg_contour_finder *f, uint32_t corner, bool forward)
{
  const sg_smooth *smooth = f->in->smooth;
  uint32_t before = sg_contour_next(sg_contour_next(corner));
  uint32_t side = forward ? corner : before;

  if (!(smooth->side[side] & SG_SIDE_SMOOTH)) {
    return SG_NO_SIDE;
  }
  return forward ? sg_contour_next(smooth->across[side]) : smooth->across[side];
}

/* True if a triangle of a corner's fan tells of the side. */
static bool
fan_tells(const sg_contour_finder *f, uint32_t side, uint32_t corner,
          double near)
{
  uint32_t c = corner;

  do {
    if (tells(f, side, c / 3, near)) {
      return true;
    }
    c = turned(f, c, true);
  } while (c != SG_NO_SIDE && c != corner);
  if (c == corner) {
    return false;
  }
  for (c = turned(f, corner, false); c != SG_NO_SIDE; c = turned(f, c, false)) {
    if (tells(f, side, c / 3, near)) {
      return true;
    }
  }
  return false;
}

static bool
bulges(const sg_contour_finder *f, uint32_t t)
{
  const uint8_t *side = f->in->smooth->side + 3 * (size_t)t;

  return (side[0] | side[1] | side[2]) & SG_SIDE_BULGES;
}

bool
sg_contour_is_untold(sg_contour_finder *f, uint32_t side)
{
  const sg_smooth *smooth = f->in->smooth;
  uint32_t t = side / 3, u = smooth->across[side] / 3;
  double near;

  if (!(smooth->side[side] & SG_SIDE_SMOOTH) ||
      !(smooth->side[side] & SG_SIDE_CONVEX) || f->sense[t] > 0 ||
      f->sense[u] > 0 || !(bulges(f, t) || bulges(f, u))) {
    return false;
  }
  near = LINE * picture_size(f, t);
  return !fan_tells(f, side, side, near) &&
         !fan_tells(f, side, sg_contour_next(side), near);
}
