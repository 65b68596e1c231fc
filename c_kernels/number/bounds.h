/* bounds.h -- smaller and larger of two numbers, neither of them NaN.
 *
 * Layer: kernel. Unlike fmin() and fmax() they cost no call.
 */
#ifndef SG_BOUNDS_H
#define SG_BOUNDS_H

static inline double
sg_smaller(double a, double b)
{
  return a < b ? a : b;
}

static inline double
sg_larger(double a, double b)
{
  return a > b ? a : b;
}

#endif
