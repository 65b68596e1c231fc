/* contour_rise.c -- see contour.h: pieces in the picture, on the surface. */
#include "contour_private.h"

#include <math.h>

/* A corner lies outside of a piece if it does by more than this part of what it
 * is from the ends. */
#define OUTSIDE 1e-9

/* ------------------------------------------------------------- the rise */

/* What one is in the picture, at the distance 1, told by the places of two
 * vertices; 0: they lie in the middle. */
static double
scale_of(const sg_contour_finder *f, uint32_t v, uint32_t w)
{
  const double(*row)[3] = f->in->eye.row;
  double most = 0.0, scale = 0.0;

  for (int i = 0; i < 2 && f->in->central; i++) {
    const double *p = f->in->dense->at[i ? w : v];
    const double *seen = f->in->screen[i ? w : v];
    double from_middle = hypot(sg_dot(p, row[0]), sg_dot(p, row[1]));
    if (from_middle > most) {
      most = from_middle;
      scale =
          hypot(seen[0], seen[1]) * sg_contour_distance(f->in, p) / from_middle;
    }
  }
  return f->in->central ? scale : 1.0;
}

/* Where the surface runs as a side does that has these normals at its ends, it
 * rises so far above the side, at zero of it, along the normal there: a circle
 * does, up to the fourth power of its angle. */
static double
height_of(const double along[3], const double turn[3], double zero)
{
  return zero * (1.0 - zero) / 2.0 * sg_dot(turn, along);
}

static void
find_rise(const sg_contour_finder *f, uint32_t side, double rise[2])
{
  const sg_smooth *smooth = f->in->smooth;
  uint32_t next = sg_contour_next(side);
  bool first = sg_contour_vertex(f, side) < sg_contour_vertex(f, next);
  uint32_t a = first ? side : next, b = first ? next : side;
  uint32_t v = sg_contour_vertex(f, a), w = sg_contour_vertex(f, b);
  const double *n = smooth->normal[smooth->fan[a]];
  double zero = sg_contour_model_zero(f, a, b), scale = scale_of(f, v, w),
         height;
  double along[3], turn[3], normal[3], on_side[3], risen[3];

  sg_minus(f->in->dense->at[w], f->in->dense->at[v], along);
  sg_minus(smooth->normal[smooth->fan[b]], n, turn);
  for (int k = 0; k < 3; k++) {
    normal[k] = n[k] + zero * turn[k];
    on_side[k] = f->in->dense->at[v][k] + zero * along[k];
  }
  height = (height_of(along, turn, zero) +
            (1.0 - zero) * smooth->sunk[smooth->fan[a]] +
            zero * smooth->sunk[smooth->fan[b]]) /
           sg_length(normal);
  for (int k = 0; k < 3; k++) {
    risen[k] = on_side[k] + height * normal[k];
  }
  for (int k = 0; k < 2; k++) {
    const double *axis = f->in->eye.row[k];
    rise[k] =
        scale * (sg_dot(risen, axis) / sg_contour_distance(f->in, risen) -
                 sg_dot(on_side, axis) / sg_contour_distance(f->in, on_side));
  }
}

void
sg_contour_rise(const sg_contour_finder *f, uint32_t side, double rise[2])
{
  if (f->in->smooth->side[side] & SG_SIDE_KNOWN) {
    find_rise(f, side, rise);
  }
}

/* ------------------------------------------------------------ outermost */

static bool
has_risen(const sg_contour *piece)
{
  const double(*rise)[2] = piece->rise;

  return rise[0][0] != 0.0 || rise[0][1] != 0.0 || rise[1][0] != 0.0 ||
         rise[1][1] != 0.0;
}

/* The corner that a piece parts from the two others. */
static uint32_t
parted_corner(const sg_contour *piece)
{
  bool first = piece->side[0] == (piece->side[1] + 1) % 3;

  return 3 * piece->t + piece->side[first ? 0 : 1];
}

/* Whether a piece on the surface leaves the corner that it parts from the
 * others outside in the picture: on its right, and with the ends more than a
 * right angle apart. The surface is seen on the left of a piece, whichever half
 * is the nearer one: where the surface bends towards the line of sight it looks
 * to the left, too. */
static bool
leaves_outside(const sg_contour_finder *f, const sg_contour *piece)
{
  const double *p = f->in->screen[sg_contour_vertex(f, parted_corner(piece))];
  double a[3], b[3], u[2], w[2];

  if (!has_risen(piece)) {
    return false;
  }
  sg_contour_point(f, piece, 0, a);
  sg_contour_point(f, piece, 1, b);
  for (int k = 0; k < 2; k++) {
    u[k] = a[k] - p[k];
    w[k] = b[k] - p[k];
  }
  return u[0] * w[1] - u[1] * w[0] < OUTSIDE * (u[0] * w[0] + u[1] * w[1]) &&
         u[0] * w[0] + u[1] * w[1] < 0.0;
}

/* Where the corner is on a side of it. */
static double
at_corner(const sg_contour_finder *f, uint32_t side, uint32_t corner)
{
  uint32_t other = side == corner ? sg_contour_next(side) : side;

  return sg_contour_vertex(f, corner) < sg_contour_vertex(f, other) ? 0.0 : 1.0;
}

bool
sg_contour_outermost(const sg_contour_finder *f, const sg_contour *piece,
                     sg_contour half[2])
{
  uint32_t corner = parted_corner(piece);

  if (!leaves_outside(f, piece)) {
    return false;
  }
  half[0] = half[1] = *piece;
  for (int k = 0; k < 2; k++) { /* its end, then its start */
    half[k].at[1 - k] = at_corner(f, 3 * piece->t + piece->side[1 - k], corner);
    half[k].rise[1 - k][0] = half[k].rise[1 - k][1] = 0.0;
  }
  return true;
}
