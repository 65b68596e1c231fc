/* gap.c -- how far two triangles, or edges, are apart: see gap.h. */
#include "gap.h"

#include "number/vector.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

static void
point_along(const double from[3], double by, const double way[3], double out[3])
{
  for (int k = 0; k < 3; k++) {
    out[k] = from[k] + by * way[k];
  }
}

/* Whether p is inside side from-to of a triangle, or on it. */
static bool
is_inside(const double normal[3], const double from[3], const double to[3],
          const double p[3])
{
  double along[3], way[3], across[3];

  sg_minus(to, from, along);
  sg_minus(p, from, way);
  sg_cross(along, way, across);
  return sg_dot(normal, across) >= 0;
}

static void
keep_nearer(sg_gap *gap, double apart, const double end[2][3], bool turned)
{
  if (apart < gap->apart) {
    gap->apart = apart;
    memcpy(gap->end[turned], end[0], sizeof end[0]);
    memcpy(gap->end[!turned], end[1], sizeof end[1]);
  }
}

/* A corner square above the triangle `of`; `turned`: it is of the second. */
static void
corner_gap(const double corner[3], const sg_gap_piece *of, bool turned,
           sg_gap *gap)
{
  const double(*at)[3] = of->at;
  double u[3], w[3], normal[3], from[3], end[2][3];

  sg_minus(at[1], at[0], u);
  sg_minus(at[2], at[0], w);
  sg_cross(u, w, normal);
  sg_minus(corner, at[0], from);
  double square = sg_dot(normal, normal), height = sg_dot(from, normal);

  if (!(square > 0)) {
    return;
  }
  memcpy(end[0], corner, sizeof end[0]);
  point_along(corner, -height / square, normal, end[1]);
  if (is_inside(normal, at[0], at[1], end[1]) &&
      is_inside(normal, at[1], at[2], end[1]) &&
      is_inside(normal, at[2], at[0], end[1])) {
    keep_nearer(gap, fabs(height) / sqrt(square), (const double(*)[3])end,
                turned);
  }
}

static double
within_one(double t)
{
  return fmin(1, fmax(0, t));
}

static void
side_gap(const double a[2][3], const double b[2][3], sg_gap *gap)
{
  double u[3], v[3], w[3], end[2][3];

  sg_minus(a[1], a[0], u);
  sg_minus(b[1], b[0], v);
  sg_minus(a[0], b[0], w);
  double uu = sg_dot(u, u), vv = sg_dot(v, v), uv = sg_dot(u, v);
  double uw = sg_dot(u, w), vw = sg_dot(v, w), cross = uu * vv - uv * uv;

  if (!(uu > 0 && vv > 0)) {
    return;
  }
  double s = cross > uu * vv * DBL_EPSILON
                 ? within_one((uv * vw - vv * uw) / cross)
                 : 0;
  double t = within_one((uv * s + vw) / vv);

  s = within_one((uv * t - uw) / uu);
  point_along(a[0], s, u, end[0]);
  point_along(b[0], t, v, end[1]);
  keep_nearer(gap, sg_distance(end[0], end[1]), (const double(*)[3])end, false);
}

static void
take_side(const sg_gap_piece *of, int i, double out[2][3])
{
  memcpy(out[0], of->at[i], sizeof out[0]);
  memcpy(out[1], of->at[(i + 1) % of->corners], sizeof out[1]);
}

static int
sides_of(const sg_gap_piece *of)
{
  return of->corners == 3 ? 3 : 1;
}

sg_gap
sg_gap_between(const sg_gap_piece *a, const sg_gap_piece *b)
{
  sg_gap gap = {.apart = INFINITY};
  const sg_gap_piece *piece[2] = {a, b};

  for (int k = 0; k < 2; k++) {
    for (int i = 0; i < piece[k]->corners && piece[!k]->corners == 3; i++) {
      corner_gap(piece[k]->at[i], piece[!k], k == 1, &gap);
    }
  }
  for (int i = 0; i < sides_of(a); i++) {
    for (int k = 0; k < sides_of(b); k++) {
      double one[2][3], other[2][3];

      take_side(a, i, one);
      take_side(b, k, other);
      side_gap((const double(*)[3])one, (const double(*)[3])other, &gap);
    }
  }
  return gap;
}
