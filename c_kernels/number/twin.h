/* twin.h -- numbers of twice the digits, without bounds, and vectors of them.
 *
 * Layer: kernel. Inexact: wrong by some 2^-100 of the terms. twofold.h has such
 * that know how wrong they are.
 */
#ifndef SG_TWIN_H
#define SG_TWIN_H

#include "twofold.h"

typedef struct sg_twin {
  double hi, lo;
} sg_twin;

static inline sg_twin
sg_twin_of(double a)
{
  return (sg_twin){a, 0};
}

static inline sg_twin
sg_twin_plus(sg_twin a, sg_twin b)
{
  sg_twin out;
  double s, t;

  sg_two_sum(a.hi, b.hi, &s, &t);
  sg_two_sum(s, t + (a.lo + b.lo), &out.hi, &out.lo);
  return out;
}

static inline sg_twin
sg_twin_minus(sg_twin a, sg_twin b)
{
  return sg_twin_plus(a, (sg_twin){-b.hi, -b.lo});
}

static inline sg_twin
sg_twin_times(sg_twin a, sg_twin b)
{
  sg_twin out;
  double h, l;

  sg_two_product(a.hi, b.hi, &h, &l);
  sg_two_sum(h, l + (a.hi * b.lo + a.lo * b.hi), &out.hi, &out.lo);
  return out;
}

/* a / b, to about 2^-100. */
static inline sg_twin
sg_twin_quotient(sg_twin a, sg_twin b)
{
  double first = a.hi / b.hi;
  sg_twin rest = sg_twin_minus(a, sg_twin_times(sg_twin_of(first), b)), out;

  sg_two_sum(first, rest.hi / b.hi, &out.hi, &out.lo);
  return out;
}

/* The root of what is not negative: one step of Newton's. */
static inline sg_twin
sg_twin_root(sg_twin a)
{
  double first = sqrt(a.hi);
  sg_twin square = sg_twin_times(sg_twin_of(first), sg_twin_of(first)), out;
  sg_twin rest = sg_twin_minus(a, square);

  if (first == 0) {
    return sg_twin_of(0);
  }
  sg_two_sum(first, rest.hi / (2 * first), &out.hi, &out.lo);
  return out;
}

/* What makes a vector of nearly this square a unit: one step of Newton's. */
static inline sg_twin
sg_twin_unit_scale(sg_twin square)
{
  return sg_twin_plus(
      sg_twin_of(1),
      sg_twin_times(sg_twin_minus(sg_twin_of(1), square), sg_twin_of(0.5)));
}

typedef struct sg_twin_vector {
  sg_twin k[3];
} sg_twin_vector;

/* b - a, exactly. */
static inline sg_twin_vector
sg_twin_difference(const double a[3], const double b[3])
{
  sg_twin_vector out;

  for (int k = 0; k < 3; k++) {
    sg_two_sum(b[k], -a[k], &out.k[k].hi, &out.k[k].lo);
  }
  return out;
}

static inline sg_twin
sg_twin_dot(const sg_twin_vector *a, const sg_twin_vector *b)
{
  return sg_twin_plus(sg_twin_plus(sg_twin_times(a->k[0], b->k[0]),
                                   sg_twin_times(a->k[1], b->k[1])),
                      sg_twin_times(a->k[2], b->k[2]));
}

static inline sg_twin_vector
sg_twin_cross(const sg_twin_vector *a, const sg_twin_vector *b)
{
  sg_twin_vector out;

  for (int k = 0; k < 3; k++) {
    int i = (k + 1) % 3, j = (k + 2) % 3;
    out.k[k] = sg_twin_minus(sg_twin_times(a->k[i], b->k[j]),
                             sg_twin_times(a->k[j], b->k[i]));
  }
  return out;
}

#endif
