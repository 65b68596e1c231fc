/* vector.h -- differences, products and angles of vectors of doubles. Rounded.
 *
 * Layer: kernel.
 */
#ifndef SG_VECTOR_H
#define SG_VECTOR_H

#include <math.h>

/* out = a - b. */
static inline void
sg_minus(const double a[3], const double b[3], double out[3])
{
  for (int k = 0; k < 3; k++) {
    out[k] = a[k] - b[k];
  }
}

static inline double
sg_dot(const double a[3], const double b[3])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline double
sg_length(const double a[3])
{
  return sqrt(sg_dot(a, a));
}

static inline void
sg_cross(const double a[3], const double b[3], double out[3])
{
  out[0] = a[1] * b[2] - a[2] * b[1];
  out[1] = a[2] * b[0] - a[0] * b[2];
  out[2] = a[0] * b[1] - a[1] * b[0];
}

/* Between two directions, in radians. */
static inline double
sg_angle(const double a[3], const double b[3])
{
  double c[3];

  sg_cross(a, b, c);
  return atan2(sg_length(c), sg_dot(a, b));
}

#endif
