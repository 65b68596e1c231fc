/* convex.c -- see convex.h. */
#include "convex.h"

#include "engine/search.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FEW = 48 }; /* points that are sorted by insertion */

/* ---- hulls -------------------------------------------------------------- */

SG_ORDER(compare_points, double, SG_BY_AT(0) SG_BY_AT(1));

static void
sort_points(double (*point)[2], size_t n)
{
  if (n > FEW) {
    qsort(point, n, sizeof *point, compare_points);
    return;
  }
  for (size_t i = 1; i < n; i++) {
    double p[2] = {point[i][0], point[i][1]};
    size_t k = i;
    for (; k > 0 && compare_points(p, point[k - 1]) < 0; k--) {
      memcpy(point[k], point[k - 1], sizeof p);
    }
    memcpy(point[k], p, sizeof p);
  }
}

static double
turn(const double a[2], const double b[2], const double c[2])
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

size_t
sg_convex_hull(double (*point)[2], size_t n, double (*out)[2])
{
  size_t corners = 0;

  sort_points(point, n);
  for (int way = 0; way < 2; way++) {
    size_t base = corners;
    for (size_t i = 0; i < n; i++) {
      const double *p = point[way ? n - 1 - i : i];
      while (corners >= base + 2 &&
             turn(out[corners - 2], out[corners - 1], p) <= 0) {
        corners--;
      }
      memcpy(out[corners++], p, sizeof *out);
    }
    corners -= corners > 1; /* it begins the way back */
  }
  return corners;
}

/* ---- outlines ----------------------------------------------------------- */

/* A polygon that loses sides: the side from corner i to the next one could go;
 * then both are at `meet`, and the polygon is larger by `area`. */
typedef struct outline {
  double (*corner)[2];
  size_t n;
  double (*meet)[2], *area;
} outline;

/* Where the sides before and after side i meet. */
static void
measure_side(const outline *o, size_t i)
{
  const double *p = o->corner[(i + o->n - 1) % o->n], *q = o->corner[i];
  const double *r = o->corner[(i + 1) % o->n], *s = o->corner[(i + 2) % o->n];
  double ux = q[0] - p[0], uy = q[1] - p[1];
  double wx = s[0] - r[0], wy = s[1] - r[1];
  double across = ux * wy - uy * wx;
  double t = ((r[0] - q[0]) * wy - (r[1] - q[1]) * wx) / across;

  o->meet[i][0] = q[0] + t * ux;
  o->meet[i][1] = q[1] + t * uy;
  o->area[i] =
      across > 0 && t >= 0 && isfinite(o->meet[i][0]) && isfinite(o->meet[i][1])
          ? fabs(turn(q, o->meet[i], r))
          : INFINITY;
}

/* Side i goes. */
static void
drop_side(outline *o, size_t i)
{
  size_t next = (i + 1) % o->n, after = o->n - 1 - next;

  memcpy(o->corner[i], o->meet[i], sizeof *o->corner);
  memmove(o->corner + next, o->corner + next + 1, after * sizeof *o->corner);
  memmove(o->meet + next, o->meet + next + 1, after * sizeof *o->meet);
  memmove(o->area + next, o->area + next + 1, after * sizeof *o->area);
  o->n--;
  i -= next < i;
  for (size_t k = 0; k < 4; k++) { /* the sides that ask for this corner */
    measure_side(o, (i + o->n + k - 2) % o->n);
  }
}

size_t
sg_convex_outline(double (*corner)[2], size_t n)
{
  double meet[SG_CONVEX_MOST][2], area[SG_CONVEX_MOST];
  outline o = {corner, n, meet, area};

  for (size_t i = 0; n > SG_CONVEX_CORNERS && i < n; i++) {
    measure_side(&o, i);
  }
  while (o.n > SG_CONVEX_CORNERS) {
    size_t least = 0;
    for (size_t i = 1; i < o.n; i++) {
      least = area[i] < area[least] ? i : least;
    }
    if (isinf(area[least])) {
      return 0;
    }
    drop_side(&o, least);
  }
  return o.n;
}

/* ---- overlap ------------------------------------------------------------ */

/* Whether a side of a has all of b outside, or inside by no more than depth. */
static bool
side_parts(const double (*a)[2], size_t na, const double (*b)[2], size_t nb,
           double depth)
{
  for (size_t i = 0; i < na; i++) {
    const double *p = a[i], *q = a[i + 1 < na ? i + 1 : 0];
    double nx = p[1] - q[1], ny = q[0] - p[0], most = -INFINITY;
    for (size_t k = 0; k < nb; k++) {
      double in = nx * (b[k][0] - p[0]) + ny * (b[k][1] - p[1]);
      most = in > most ? in : most;
    }
    if ((nx != 0 || ny != 0) &&
        (most <= 0 || most * most <= depth * depth * (nx * nx + ny * ny))) {
      return true;
    }
  }
  return false;
}

bool
sg_convex_overlap(const double (*a)[2], size_t na, const double (*b)[2],
                  size_t nb, double depth)
{
  return !side_parts(a, na, b, nb, depth) && !side_parts(b, nb, a, na, depth);
}
