/* bounded_double.h -- error-free sums and products of doubles, and numbers of
 * twice the digits that know how wrong they are.
 *
 * Layer: kernel. Source: T. J. Dekker, A floating-point technique for extending
 * the available precision, 1971; D. E. Knuth, The Art of Computer Programming,
 * 4.2.2. Needs rounding to nearest and no contraction.
 */
#ifndef SG_BOUNDED_DOUBLE_H
#define SG_BOUNDED_DOUBLE_H

#include <float.h>
#include <math.h>

/* a + b = *hi + *lo, exactly. */
static inline void
sg_two_sum(double a, double b, double *hi, double *lo)
{
  double s = a + b, bb = s - a;

  *lo = (a - (s - bb)) + (b - bb);
  *hi = s;
}

static inline void
sg_split(double a, double *hi, double *lo)
{
  double c = 134217729.0 * a; /* 2^27 + 1 */

  *hi = c - (c - a);
  *lo = a - *hi;
}

/* a * b = *hi + *lo, exactly unless it over- or underflows. */
static inline void
sg_two_product(double a, double b, double *hi, double *lo)
{
  double ah, al, bh, bl, p = a * b;

  sg_split(a, &ah, &al);
  sg_split(b, &bh, &bl);
  *lo = al * bl - (((p - ah * bh) - al * bh) - ah * bl);
  *hi = p;
}

/* A number that differs from hi + lo by at most e; lo is at most half a unit in
 * the last place of hi. Where something overflowed, e or a part is not finite.
 *
 * A sum or product of bounded numbers is wrong by less than 2^-103 of the sizes
 * of its terms, of which 2^-100 is taken; DBL_MIN covers underflow, and 1 +
 * 2^-50 the rounding of e itself. */
typedef struct sg_bounded {
  double hi, lo, e;
} sg_bounded;

static inline double
sg_bounded_bound(double e, double size)
{
  return (e + 0x1p-100 * size + DBL_MIN) * (1 + 0x1p-50);
}

/* a - b, exactly. */
static inline sg_bounded
sg_bounded_difference(double a, double b)
{
  sg_bounded out = {0, 0, 0};

  sg_two_sum(a, -b, &out.hi, &out.lo);
  return out;
}

static inline sg_bounded
sg_bounded_plus(sg_bounded x, sg_bounded y)
{
  sg_bounded out;
  double s, t;

  sg_two_sum(x.hi, y.hi, &s, &t);
  sg_two_sum(s, t + (x.lo + y.lo), &out.hi, &out.lo);
  out.e = sg_bounded_bound(x.e + y.e, fabs(x.hi) + fabs(y.hi));
  return out;
}

static inline sg_bounded
sg_bounded_minus(sg_bounded x, sg_bounded y)
{
  return sg_bounded_plus(x, (sg_bounded){-y.hi, -y.lo, y.e});
}

static inline sg_bounded
sg_bounded_times(sg_bounded x, sg_bounded y)
{
  sg_bounded out;
  double h, l, size_x = fabs(x.hi), size_y = fabs(y.hi);

  sg_two_product(x.hi, y.hi, &h, &l);
  sg_two_sum(h, l + (x.hi * y.lo + x.lo * y.hi), &out.hi, &out.lo);
  out.e = sg_bounded_bound(size_x * y.e + size_y * x.e + x.e * y.e,
                           size_x * size_y);
  return out;
}

/* x / y, with a bound from what is left of x; e is infinite or no number if y
 * may be 0. */
static inline sg_bounded
sg_bounded_quotient(sg_bounded x, sg_bounded y)
{
  sg_bounded out = {0, 0, 0};
  double first = x.hi / y.hi;
  sg_bounded rest =
      sg_bounded_minus(x, sg_bounded_times((sg_bounded){first, 0, 0}, y));

  sg_two_sum(first, rest.hi / y.hi, &out.hi, &out.lo);
  rest = sg_bounded_minus(x, sg_bounded_times(out, y));
  double least = fabs(y.hi) * (1 - 0x1p-50) - y.e;

  out.e = least > 0 ? sg_bounded_bound(
                          (fabs(rest.hi) + rest.e) * (1 + 0x1p-50) / least, 0)
                    : INFINITY;
  return out;
}

/* Whether every number that x may be has x.hi as its nearest double. */
static inline int
sg_bounded_is_rounded(sg_bounded x)
{
  double size = fabs(x.hi);
  double gap = size - nextafter(size, 0); /* the smaller of the two */

  return size > DBL_MIN && fabs(x.lo) + x.e < (0.5 - 0x1p-40) * gap;
}

/* Whether x may be a double. */
static inline int
sg_bounded_may_be_double(sg_bounded x)
{
  return !(fabs(x.lo) > x.e);
}

#endif
