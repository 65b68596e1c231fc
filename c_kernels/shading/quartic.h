/* quartic.h -- real roots of the quartic of a torus along a line of sight.
 *
 * Layer: kernel. A torus lies where c[0] + c[1] z + .. + c[4] z^4 < 0, with
 * c[4] > 0: in one well or in two, and between SG_QUARTIC_REACH and less than
 * it. Roots are found by Newton's steps between places where the sign is known
 * to change: where derivatives are 0. Inexact, by + - * / and square roots
 * alone: the same on every machine.
 */
#ifndef SG_QUARTIC_H
#define SG_QUARTIC_H

#include <stdbool.h>
#include <stdint.h>

/* Roots lie between -it and it. */
#define SG_QUARTIC_REACH 1.125

/* Which root. What has no place counts as where it went: the bottom of its
 * well, or the ridge between the two. */
typedef enum sg_quartic_root {
  SG_ROOT_FIRST = 2, /* of all; more than what else sg_slice.arc can be */
  SG_ROOT_LAST,
  SG_ROOT_NEAR_IN, /* of two wells the nearer one, its near side */
  SG_ROOT_NEAR_OUT,
  SG_ROOT_FAR_IN,
  SG_ROOT_FAR_OUT
} sg_quartic_root;

/* Whether it is one of four. */
static inline bool
sg_quartic_of_four(int32_t root)
{
  return root > (int32_t)SG_ROOT_LAST;
}

/* Whether the torus begins there. */
static inline bool
sg_quartic_enters(int32_t root)
{
  return root % 2 == 0;
}

/* How many there are: 0, 2 or 4. */
int sg_quartic_count(const double c[5]);

double sg_quartic_place(const double c[5], sg_quartic_root root);

/* Where two neighbours of four roots meet, and beyond it there are two roots:
 * which one of the four goes on as `root`, SG_ROOT_FIRST or SG_ROOT_LAST. */
sg_quartic_root sg_quartic_before(const double c[5], sg_quartic_root root);

/* A place between low and high where c[0] + .. + c[n] z^n changes its sign, as
 * `rising` says; if it does not, the end that is nearer to one. */
double sg_root_between(const double *c, int n, double low, double high,
                       bool rising);

/* The number of real roots of the quartic is less than 4 and more than 0 where
 * it is below 0; a part of its discriminant. */
double sg_quartic_discriminant(const double c[5]);

/* A polynomial of degree n, for t from 0 to 1: the sum of c[k] u^k, times
 * (1 - t)^n, with u = t / (1 - t). So c[k] / choose(n, k) are its Bernstein
 * coefficients: if all of them are above 0, so is the polynomial there. */
enum { SG_POLYNOMIAL_MOST = 12 };

typedef struct sg_polynomial {
  int n; /* its degree */
  double c[SG_POLYNOMIAL_MOST + 1];
} sg_polynomial;

/* The discriminant, of degree 12, of a quartic whose c[k] has the degree 4 - k
 * in u. *out has its Bernstein coefficients; *noise is what rounding may leave
 * of 0 in each of them. */
void sg_discriminant_along(const sg_polynomial c[5], sg_polynomial *out,
                           double *noise);

/* out = a b */
void sg_polynomial_times(const sg_polynomial *a, const sg_polynomial *b,
                         sg_polynomial *out);

/* out += part a, of one degree */
void sg_polynomial_add(sg_polynomial *out, double part, const sg_polynomial *a);

#endif
