/* exact_point.c -- exact points and their constructions: see exact.h.
 *
 * Layer: kernel. Constructions are done in integers over the common
 * denominator of their arguments, then made rational, then rounded once.
 */
#include "exact.h"
#include "integers.h"

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

void
sg_point_set(sg_point *out, const double p[3])
{
  for (int k = 0; k < 3; k++) {
    out->p[k] = p[k] + 0.0; /* never -0.0 */
  }
  out->q = NULL;
}

/* Bits of the quotient to be found are 55 or 56, or fewer where doubles have
 * fewer: two more than the last place of the smallest double at most. */
static long
quotient_shift(mpz_srcptr numerator, mpz_srcptr denominator)
{
  long bits =
      (long)mpz_sizeinbase(numerator, 2) - (long)mpz_sizeinbase(denominator, 2);
  long shift = 55 - bits;

  return shift > 1076 ? 1076 : shift;
}

/* floor(numerator * 2^shift / denominator), its last bit set if there is a
 * rest (so that no rounding later mistakes it for a tie). */
static uint64_t
quotient(mpz_srcptr numerator, mpz_srcptr denominator, long shift)
{
  mpz_t n, d, rest;

  mpz_init_set(n, numerator);
  mpz_init_set(d, denominator);
  mpz_init(rest);
  if (shift >= 0) {
    mpz_mul_2exp(n, n, (mp_bitcnt_t)shift);
  } else {
    mpz_mul_2exp(d, d, (mp_bitcnt_t)-shift);
  }
  mpz_tdiv_qr(n, rest, n, d);
  uint64_t found = mpz_get_ui(n) | (mpz_sgn(rest) != 0);
  mpz_clears(n, d, rest, NULL);
  return found;
}

/* The double nearest to q, ties to even; infinite when out of range. */
static double
nearest_double(mpq_srcptr q)
{
  mpz_t size;
  double answer;

  if (mpq_sgn(q) == 0) {
    return 0;
  }
  mpz_init(size);
  mpz_abs(size, mpq_numref(q));
  long shift = quotient_shift(size, mpq_denref(q));
  uint64_t bits = quotient(size, mpq_denref(q), shift);
  mpz_clear(size);
  if (shift == 1076) { /* to a whole number of smallest doubles */
    uint64_t rest = bits & 3, whole = bits >> 2;
    if ((whole >> 53) == 0) {
      whole += rest > 2 || (rest == 2 && (whole & 1));
      answer = ldexp((double)whole, -1074);
      return mpq_sgn(q) < 0 ? 0 - answer : answer; /* never -0.0 */
    }
  }
  answer = ldexp((double)bits, (int)-shift);   /* (double) rounds once */
  return mpq_sgn(q) < 0 ? 0 - answer : answer; /* never -0.0 */
}

static bool
is_double(mpq_srcptr q, double value)
{
  mpq_t exact;

  mpq_init(exact);
  mpq_set_d(exact, value);
  bool same = mpq_equal(exact, q);
  mpq_clear(exact);
  return same;
}

static mpq_t *
new_rationals(void)
{
  mpq_t *q = malloc(3 * sizeof *q);

  for (int k = 0; q && k < 3; k++) {
    mpq_init(q[k]);
  }
  return q;
}

bool
sg_point_set_q(sg_point *out, mpq_srcptr x, mpq_srcptr y, mpq_srcptr z)
{
  mpq_srcptr q[3] = {x, y, z};
  bool doubles = true;

  out->q = NULL;
  for (int k = 0; k < 3; k++) {
    out->p[k] = nearest_double(q[k]);
    if (!isfinite(out->p[k])) {
      return false;
    }
    doubles = doubles && is_double(q[k], out->p[k]);
  }
  if (doubles) {
    return true;
  }
  if (!(out->q = new_rationals())) {
    return false;
  }
  for (int k = 0; k < 3; k++) {
    mpq_set(out->q[k], q[k]);
  }
  return true;
}

bool
sg_point_copy(sg_point *out, const sg_point *from)
{
  memcpy(out->p, from->p, sizeof out->p);
  out->q = NULL;
  if (!from->q) {
    return true;
  }
  if (!(out->q = new_rationals())) {
    return false;
  }
  for (int k = 0; k < 3; k++) {
    mpq_set(out->q[k], from->q[k]);
  }
  return true;
}

void
sg_point_clear(sg_point *point)
{
  if (point->q) {
    for (int k = 0; k < 3; k++) {
      mpq_clear(point->q[k]);
    }
    free(point->q);
    point->q = NULL;
  }
}

/* out := numerator / (denominator * w). Requires denominator != 0. */
static bool
set_quotients(sg_point *out, mpz_t numerator[3], mpz_srcptr denominator,
              mpz_srcptr w)
{
  mpq_t q[3];

  for (int k = 0; k < 3; k++) {
    mpq_init(q[k]);
    mpz_set(mpq_numref(q[k]), numerator[k]);
    mpz_mul(mpq_denref(q[k]), denominator, w);
    mpq_canonicalize(q[k]);
  }
  bool done = sg_point_set_q(out, q[0], q[1], q[2]);
  for (int k = 0; k < 3; k++) {
    mpq_clear(q[k]);
  }
  return done;
}

/* The point of line a-b where a quantity linear along it, `at_a` at a and
 * `at_b` at b, is 0: (at_a b - at_b a) / (at_a - at_b). False: it is constant.
 * Uses up at_a and at_b. */
static bool
set_zero(sg_point *out, mpz_t a[3], mpz_t b[3], mpz_ptr at_a, mpz_ptr at_b,
         mpz_srcptr w)
{
  mpz_t numerator[3];
  bool done = false;

  out->q = NULL;
  sg_integers_init3(numerator);
  for (int k = 0; k < 3; k++) {
    mpz_mul(numerator[k], b[k], at_a);
    mpz_submul(numerator[k], a[k], at_b);
  }
  mpz_sub(at_a, at_a, at_b);
  if (mpz_sgn(at_a) != 0) {
    done = set_quotients(out, numerator, at_a, w);
  }
  sg_integers_clear3(numerator);
  return done;
}

bool
sg_point_lpi(sg_point *out, const sg_point *a, const sg_point *b,
             const sg_point *c, const sg_point *d, const sg_point *e)
{
  const sg_point *point[5] = {a, b, c, d, e};
  mpz_t room[5][3], n[3], s[3], t[3], at_a, at_b;
  sg_integers in;

  sg_integers_open(&in, room, point, 5);
  sg_integers_init3(n);
  sg_integers_init3(s);
  sg_integers_init3(t);
  mpz_inits(at_a, at_b, NULL);
  sg_integers_normal(n, in.x[2], in.x[3], in.x[4], s, t);
  sg_integers_subtract(s, in.x[0], in.x[2]);
  sg_integers_subtract(t, in.x[1], in.x[2]);
  sg_integers_dot(at_a, n, s);
  sg_integers_dot(at_b, n, t);
  bool done = set_zero(out, in.x[0], in.x[1], at_a, at_b, in.w);
  mpz_clears(at_a, at_b, NULL);
  sg_integers_clear3(t);
  sg_integers_clear3(s);
  sg_integers_clear3(n);
  sg_integers_close(&in);
  return done;
}

bool
sg_point_ll(sg_point *out, int axis, const sg_point *a, const sg_point *b,
            const sg_point *c, const sg_point *d)
{
  const sg_point *point[4] = {a, b, c, d};
  mpz_t room[4][3], n[3], s[3], at_a, at_b;
  sg_integers in;
  int u = (axis + 1) % 3, v = (axis + 2) % 3;

  sg_integers_open(&in, room, point, 4);
  sg_integers_init3(n);
  sg_integers_init3(s);
  mpz_inits(at_a, at_b, NULL);
  sg_integers_subtract(n, in.x[3], in.x[2]);
  sg_integers_subtract(s, in.x[0], in.x[2]);
  sg_integers_minor(at_a, n, s, u, v);
  sg_integers_subtract(s, in.x[1], in.x[2]);
  sg_integers_minor(at_b, n, s, u, v);
  bool done = set_zero(out, in.x[0], in.x[1], at_a, at_b, in.w);
  mpz_clears(at_a, at_b, NULL);
  sg_integers_clear3(s);
  sg_integers_clear3(n);
  sg_integers_close(&in);
  return done;
}

/* The three planes n[i] . x = at[i], by Cramer: x = (sum of at[i] times the
 * cross product of the other two normals) / determinant. */
static bool
solve_planes(sg_point *out, mpz_t n[3][3], mpz_t at[3], mpz_srcptr w)
{
  mpz_t numerator[3], cross[3], det;
  bool done = false;

  sg_integers_init3(numerator);
  sg_integers_init3(cross);
  mpz_init(det);
  for (int i = 0; i < 3; i++) {
    mpz_t *b = n[(i + 1) % 3], *c = n[(i + 2) % 3];
    for (int k = 0; k < 3; k++) {
      sg_integers_minor(cross[k], b, c, (k + 1) % 3, (k + 2) % 3);
      mpz_addmul(numerator[k], at[i], cross[k]);
    }
  }
  sg_integers_dot(det, n[2], cross); /* of n[0] and n[1] */
  out->q = NULL;
  if (mpz_sgn(det) != 0) {
    done = set_quotients(out, numerator, det, w);
  }
  mpz_clear(det);
  sg_integers_clear3(cross);
  sg_integers_clear3(numerator);
  return done;
}

bool
sg_point_tpi(sg_point *out, const sg_point *const plane[3][3])
{
  mpz_t room[9][3], n[3][3], at[3], s[3], t[3];
  const sg_point *point[9];
  sg_integers in;

  for (int i = 0; i < 9; i++) {
    point[i] = plane[i / 3][i % 3];
  }
  sg_integers_open(&in, room, point, 9);
  sg_integers_init3(s);
  sg_integers_init3(t);
  sg_integers_init3(at);
  for (int i = 0; i < 3; i++) {
    mpz_t(*x)[3] = &in.x[(ptrdiff_t)i * 3];
    sg_integers_init3(n[i]);
    sg_integers_normal(n[i], x[0], x[1], x[2], s, t);
    sg_integers_dot(at[i], n[i], x[0]);
  }
  bool done = solve_planes(out, n, at, in.w);
  for (int i = 0; i < 3; i++) {
    sg_integers_clear3(n[i]);
  }
  sg_integers_clear3(at);
  sg_integers_clear3(t);
  sg_integers_clear3(s);
  sg_integers_close(&in);
  return done;
}
