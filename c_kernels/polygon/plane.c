/* plane.c -- the nominal plane of a polygon: see plane.h. */
#include "plane.h"

#include <math.h>

/* The length, safe from overflow and underflow. */
static double
length(const double v[3])
{
  double most = fabs(v[0]);

  for (int k = 1; k < 3; k++) {
    most = fabs(v[k]) > most ? fabs(v[k]) : most; /* fmax() is a call */
  }
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
