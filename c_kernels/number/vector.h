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

/* The same of vectors whose squares no double holds. */
static inline double
sg_any_length(const double v[3])
{
  double square = sg_dot(v, v);

  return square > 1e-280 && square < 1e300 ? sqrt(square)
                                           : hypot(hypot(v[0], v[1]), v[2]);
}

static inline double
sg_distance(const double a[3], const double b[3])
{
  double d[3];

  sg_minus(a, b, d);
  return sg_length(d);
}

/* How far p is from the segment a-b. */
static inline double
sg_to_segment(const double a[3], const double b[3], const double p[3])
{
  double along[3], from[3], at[3];

  sg_minus(b, a, along);
  sg_minus(p, a, from);
  double square = sg_dot(along, along);
  double t = square > 0 ? fmin(fmax(sg_dot(along, from) / square, 0), 1) : 0;

  for (int k = 0; k < 3; k++) {
    at[k] = a[k] + t * along[k];
  }
  return sg_distance(p, at);
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
