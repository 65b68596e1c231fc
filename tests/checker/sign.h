/* sign.h -- exact signs of determinants, for the checker of results.
 *
 * Written for the tests alone and shares nothing with the kernels: a filter in
 * doubles, then integers of GMP. Points are double[3], finite. Exact.
 */
#ifndef SG_CHECKER_SIGN_H
#define SG_CHECKER_SIGN_H

#include <gmp.h>

/* The sign of det(b - a, c - a, d - a): 1 where d is on the side from which
 * a, b, c run counter-clockwise. */
int sign_of_volume(const double *a, const double *b, const double *c,
                   const double *d);

/* det(b - a, c - a, d - a) times a power of two: the same one for all four
 * choices of d from `all`, which has `n` points (a, b, c among them). */
void volume_of(mpz_t out, const double *a, const double *b, const double *c,
               const double *d, const double *const *all, int n);

/* The sign of det(b - a, c - a) of the coordinates `x` and `y` of the points:
 * 1 where a, b, c run counter-clockwise. */
int sign_of_area(const double *a, const double *b, const double *c, int x,
                 int y);

/* The exponent of the lowest bit of any of n points, for integer_of(). */
int lowest_bit(const double *const *points, int n);

/* value / 2^lowest. */
void integer_of(mpz_t out, double value, int lowest);

#endif
