/* double_double.h -- numbers of twice the digits, without bounds, and vectors
 * of them.
 *
 * Layer: kernel. Inexact: wrong by some 2^-100 of the terms. bounded_double.h
 * has such that know how wrong they are.
 */
#ifndef SG_DOUBLE_DOUBLE_H
#define SG_DOUBLE_DOUBLE_H

#include "bounded_double.h"

typedef struct sg_dd {
  double hi, lo;
} sg_dd;

static inline sg_dd
sg_dd_of(double a)
{
  return (sg_dd){a, 0};
}

static inline sg_dd
sg_dd_plus(sg_dd a, sg_dd b)
{
  sg_dd out;
  double s, t;

  sg_two_sum(a.hi, b.hi, &s, &t);
  sg_two_sum(s, t + (a.lo + b.lo), &out.hi, &out.lo);
  return out;
}

static inline sg_dd
sg_dd_minus(sg_dd a, sg_dd b)
{
  return sg_dd_plus(a, (sg_dd){-b.hi, -b.lo});
}

static inline sg_dd
sg_dd_times(sg_dd a, sg_dd b)
{
  sg_dd out;
  double h, l;

  sg_two_product(a.hi, b.hi, &h, &l);
  sg_two_sum(h, l + (a.hi * b.lo + a.lo * b.hi), &out.hi, &out.lo);
  return out;
}

/* a / b, to about 2^-100. */
static inline sg_dd
sg_dd_quotient(sg_dd a, sg_dd b)
{
  double first = a.hi / b.hi;
  sg_dd rest = sg_dd_minus(a, sg_dd_times(sg_dd_of(first), b)), out;

  sg_two_sum(first, rest.hi / b.hi, &out.hi, &out.lo);
  return out;
}

/* The root of what is not negative: one step of Newton's. */
static inline sg_dd
sg_dd_root(sg_dd a)
{
  double first = sqrt(a.hi);
  sg_dd square = sg_dd_times(sg_dd_of(first), sg_dd_of(first)), out;
  sg_dd rest = sg_dd_minus(a, square);

  if (first == 0) {
    return sg_dd_of(0);
  }
  sg_two_sum(first, rest.hi / (2 * first), &out.hi, &out.lo);
  return out;
}

/* What makes a vector of nearly this square a unit: one step of Newton's. */
static inline sg_dd
sg_dd_unit_scale(sg_dd square)
{
  return sg_dd_plus(sg_dd_of(1), sg_dd_times(sg_dd_minus(sg_dd_of(1), square),
                                             sg_dd_of(0.5)));
}

typedef struct sg_dd_vector {
  sg_dd k[3];
} sg_dd_vector;

/* b - a, exactly. */
static inline sg_dd_vector
sg_dd_difference(const double a[3], const double b[3])
{
  sg_dd_vector out;

  for (int k = 0; k < 3; k++) {
    sg_two_sum(b[k], -a[k], &out.k[k].hi, &out.k[k].lo);
  }
  return out;
}

static inline sg_dd
sg_dd_dot(const sg_dd_vector *a, const sg_dd_vector *b)
{
  return sg_dd_plus(
      sg_dd_plus(sg_dd_times(a->k[0], b->k[0]), sg_dd_times(a->k[1], b->k[1])),
      sg_dd_times(a->k[2], b->k[2]));
}

static inline sg_dd_vector
sg_dd_cross(const sg_dd_vector *a, const sg_dd_vector *b)
{
  sg_dd_vector out;

  for (int k = 0; k < 3; k++) {
    int i = (k + 1) % 3, j = (k + 2) % 3;
    out.k[k] = sg_dd_minus(sg_dd_times(a->k[i], b->k[j]),
                           sg_dd_times(a->k[j], b->k[i]));
  }
  return out;
}

#endif
