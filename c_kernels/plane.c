/* plane.c -- the nominal plane of a polygon: see plane.h. */
#include "plane.h"

#include <math.h>

void
sg_newell_init(sg_newell *sum)
{
  *sum = (sg_newell){.n = 0};
}

void
sg_newell_edge(sg_newell *sum, const double start[3], const double end[3])
{
  double a[3], b[3];

  for (int k = 0; k < 3; k++) {
    if (sum->n == 0) {
      sum->origin[k] = start[k];
    }
    a[k] = start[k] - sum->origin[k];
    b[k] = end[k] - sum->origin[k];
    sum->mean[k] += a[k];
  }
  sum->doubled[0] += a[1] * b[2] - a[2] * b[1];
  sum->doubled[1] += a[2] * b[0] - a[0] * b[2];
  sum->doubled[2] += a[0] * b[1] - a[1] * b[0];
  sum->n++;
}

/* The length, safe from overflow and underflow. */
static double
length(const double v[3])
{
  double most = fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));

  if (!(most > 0) || !isfinite(most)) {
    return most;
  }
  double x = v[0] / most, y = v[1] / most, z = v[2] / most;
  return most * sqrt(x * x + y * y + z * z);
}

bool
sg_newell_plane(const sg_newell *sum, sg_plane *out)
{
  double size = length(sum->doubled);

  if (!(size > 0) || !isfinite(size)) {
    return false;
  }
  double d = 0;
  for (int k = 0; k < 3; k++) {
    out->n[k] = sum->doubled[k] / size + 0.0;
    d -= out->n[k] * (sum->origin[k] + sum->mean[k] / (double)sum->n);
  }
  out->d = d + 0.0;
  return isfinite(d);
}

double
sg_newell_area(const sg_newell *sum)
{
  return length(sum->doubled) / 2;
}

double
sg_plane_distance(const sg_plane *plane, const double point[3])
{
  return plane->n[0] * point[0] + plane->n[1] * point[1] +
         plane->n[2] * point[2] + plane->d;
}
