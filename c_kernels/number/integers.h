/* integers.h -- several points as integers over one common denominator.
 *
 * Layer: kernel; the last stage of exact.c, and what the constructions of
 * exact_point.c compute with. Everything here is exact.
 */
#ifndef SG_INTEGERS_H
#define SG_INTEGERS_H

#include "exact.h"

/* Point i is (x[i][0], x[i][1], x[i][2]) / w, with w > 0. */
typedef struct sg_integers {
  mpz_t (*x)[3]; /* [n], the caller's room */
  mpz_t w;
  int n;
} sg_integers;

/* The coordinates u and v of a point over a denominator of their own: out[0] /
 * out[2] and out[1] / out[2], out[2] > 0. They are the point's, or in room[],
 * which is initialised. Where only signs of determinants are wanted, no common
 * denominator has to be found.
 */
void sg_integers_of_two(const sg_point *point, int u, int v, mpz_t room[3],
                        mpz_srcptr out[3]);

/* Initialises room[n][3] too; sg_integers_close() clears it. */
void sg_integers_open(sg_integers *out, mpz_t (*room)[3],
                      const sg_point *const *point, int n);
void sg_integers_close(sg_integers *in);

/* Room that hardly any number needs more of. */
enum { SG_INTEGER_BITS = 256 };

void sg_integers_init3(mpz_t v[3]);
void sg_integers_clear3(mpz_t v[3]);

/* out := a_u b_v - a_v b_u */
void sg_integers_minor(mpz_ptr out, mpz_t a[3], mpz_t b[3], int u, int v);
/* out := a - b */
void sg_integers_subtract(mpz_t out[3], mpz_t a[3], mpz_t b[3]);
/* out := a . b */
void sg_integers_dot(mpz_ptr out, mpz_t a[3], mpz_t b[3]);
/* n := (b - a) x (c - a); s and t are scratch */
void sg_integers_normal(mpz_t n[3], mpz_t a[3], mpz_t b[3], mpz_t c[3],
                        mpz_t s[3], mpz_t t[3]);

#endif
