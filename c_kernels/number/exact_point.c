/* exact_point.c -- exact points and their constructions: see exact.h.
 *
 * Layer: kernel. A construction is done with twice the digits first: if that
 * proves which doubles are nearest, they are the position, and the rationals
 * wait until somebody asks. If they may be the point itself, exact signs say
 * so. Else, and then, it is done in integers over the common denominator of its
 * arguments, made rational, and rounded once.
 */
#include "bounded_double.h"
#include "exact.h"
#include "integers.h"

#include <math.h>
#include <sched.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { LINE_AND_PLANE = -1, MADE_OF = 5 };

enum { UNKNOWN, BEING_PUT, KNOWN };

/* A point that is no point of doubles. Threads may ask for its rationals at the
 * same time: each makes them, the first puts its own here. */
struct sg_exactly {
  atomic_uint holders; /* points that share this */
  atomic_int state;    /* of q */
  mpq_t q[3];
  int how; /* LINE_AND_PLANE, or two lines seen along this axis */
  double from[MADE_OF][3];
};

/* Held once, nothing known; null: no memory. */
static sg_exactly *
new_exactly(void)
{
  sg_exactly *out = malloc(sizeof *out);

  if (out) {
    atomic_init(&out->holders, 1);
    atomic_init(&out->state, UNKNOWN);
  }
  return out;
}

void
sg_point_set(sg_point *out, const double p[3])
{
  for (int k = 0; k < 3; k++) {
    out->p[k] = p[k] + 0.0; /* never -0.0 */
  }
  out->exactly = NULL;
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

double
sg_nearest_double(mpq_srcptr q)
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

bool
sg_point_set_q(sg_point *out, mpq_srcptr x, mpq_srcptr y, mpq_srcptr z)
{
  mpq_srcptr q[3] = {x, y, z};
  bool doubles = true;

  out->exactly = NULL;
  for (int k = 0; k < 3; k++) {
    out->p[k] = sg_nearest_double(q[k]);
    if (!isfinite(out->p[k])) {
      return false;
    }
    doubles = doubles && is_double(q[k], out->p[k]);
  }
  if (doubles) {
    return true;
  }
  if (!(out->exactly = new_exactly())) {
    return false;
  }
  for (int k = 0; k < 3; k++) {
    mpq_init(out->exactly->q[k]);
    mpq_set(out->exactly->q[k], q[k]);
  }
  atomic_init(&out->exactly->state, KNOWN);
  return true;
}

void
sg_point_copy(sg_point *out, const sg_point *from)
{
  *out = *from;
  if (out->exactly) {
    atomic_fetch_add_explicit(&out->exactly->holders, 1, memory_order_relaxed);
  }
}

void
sg_point_clear(sg_point *point)
{
  sg_exactly *exactly = point->exactly;

  point->exactly = NULL;
  if (!exactly || atomic_fetch_sub(&exactly->holders, 1) != 1) {
    return;
  }
  for (int k = 0; k < 3 && atomic_load(&exactly->state) == KNOWN; k++) {
    mpq_clear(exactly->q[k]);
  }
  free(exactly);
}

/* ---- in rationals ------------------------------------------------------- */

static void
init_q(mpq_t q[3])
{
  mpq_inits(q[0], q[1], q[2], NULL);
}

static void
clear_q(mpq_t q[3])
{
  mpq_clears(q[0], q[1], q[2], NULL);
}

/* out := numerator / (denominator * w). Requires denominator != 0. */
static void
set_quotients(mpq_t out[3], mpz_t numerator[3], mpz_srcptr denominator,
              mpz_srcptr w)
{
  for (int k = 0; k < 3; k++) {
    mpz_set(mpq_numref(out[k]), numerator[k]);
    mpz_mul(mpq_denref(out[k]), denominator, w);
    mpq_canonicalize(out[k]);
  }
}

/* The point of line a-b where a quantity linear along it, `at_a` at a and
 * `at_b` at b, is 0: (at_a b - at_b a) / (at_a - at_b). False: it is constant.
 * Uses up at_a and at_b. */
static bool
set_zero(mpq_t out[3], mpz_t a[3], mpz_t b[3], mpz_ptr at_a, mpz_ptr at_b,
         mpz_srcptr w)
{
  mpz_t numerator[3];

  sg_integers_init3(numerator);
  for (int k = 0; k < 3; k++) {
    mpz_mul(numerator[k], b[k], at_a);
    mpz_submul(numerator[k], a[k], at_b);
  }
  mpz_sub(at_a, at_a, at_b);
  bool found = mpz_sgn(at_a) != 0;

  if (found) {
    set_quotients(out, numerator, at_a, w);
  }
  sg_integers_clear3(numerator);
  return found;
}

/* Line 0-1 and plane 2, 3, 4. False: parallel. */
static bool
line_meets_plane(mpq_t out[3], const sg_point *const point[5])
{
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

/* Lines 0-1 and 2-3, seen along `axis`. False: parallel. */
static bool
line_meets_line(mpq_t out[3], int axis, const sg_point *const point[4])
{
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
solve_planes(mpq_t out[3], mpz_t n[3][3], mpz_t at[3], mpz_srcptr w)
{
  mpz_t numerator[3], cross[3], det;

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
  bool found = mpz_sgn(det) != 0;

  if (found) {
    set_quotients(out, numerator, det, w);
  }
  mpz_clear(det);
  sg_integers_clear3(cross);
  sg_integers_clear3(numerator);
  return found;
}

/* ---- with twice the digits ---------------------------------------------- */

/* Differences and products of them are far from over- and underflow. */
static bool
in_range(const sg_point *const *point, int n)
{
  for (int i = 0; i < n; i++) {
    for (int k = 0; k < 3; k++) {
      double size = fabs(point[i]->p[k]);

      if (point[i]->exactly || !(size == 0 || (size > 1e-70 && size < 1e70))) {
        return false;
      }
    }
  }
  return true;
}

static void
subtract(sg_bounded out[3], const double a[3], const double b[3])
{
  for (int k = 0; k < 3; k++) {
    out[k] = sg_bounded_difference(a[k], b[k]);
  }
}

static sg_bounded
minor(const sg_bounded a[3], const sg_bounded b[3], int u, int v)
{
  return sg_bounded_minus(sg_bounded_times(a[u], b[v]),
                          sg_bounded_times(a[v], b[u]));
}

static sg_bounded
dot(const sg_bounded a[3], const sg_bounded b[3])
{
  return sg_bounded_plus(sg_bounded_plus(sg_bounded_times(a[0], b[0]),
                                         sg_bounded_times(a[1], b[1])),
                         sg_bounded_times(a[2], b[2]));
}

/* The quantities of set_zero(), of a line and a plane. */
static void
heights_over_plane(const sg_point *const point[5], sg_bounded at[2])
{
  sg_bounded s[3], t[3], n[3];

  subtract(s, point[3]->p, point[2]->p);
  subtract(t, point[4]->p, point[2]->p);
  for (int k = 0; k < 3; k++) {
    n[k] = minor(s, t, (k + 1) % 3, (k + 2) % 3);
  }
  for (int i = 0; i < 2; i++) {
    subtract(s, point[i]->p, point[2]->p);
    at[i] = dot(n, s);
  }
}

/* The same of two lines. */
static void
heights_beside_line(int axis, const sg_point *const point[4], sg_bounded at[2])
{
  sg_bounded n[3], s[3];

  subtract(n, point[3]->p, point[2]->p);
  for (int i = 0; i < 2; i++) {
    subtract(s, point[i]->p, point[2]->p);
    at[i] = minor(n, s, (axis + 1) % 3, (axis + 2) % 3);
  }
}

typedef enum rounding {
  NOT_ROUNDED,  /* the nearest doubles are not proved */
  ROUNDED,      /* they are, and the point is another one */
  MAY_BE_DOUBLE /* they may be the point itself */
} rounding;

/* Whether lines 0-1 and 2-3 are plainly parallel as they are seen along `axis`:
 * each product of their cross product has a zero. */
static bool
are_seen_parallel(int axis, const sg_point *const point[4])
{
  const double *a = point[0]->p, *b = point[1]->p, *c = point[2]->p,
               *d = point[3]->p;
  int u = (axis + 1) % 3, v = (axis + 2) % 3;

  return (a[u] == b[u] || c[v] == d[v]) && (a[v] == b[v] || c[u] == d[u]);
}

/* The nearest doubles of the point where the quantity is 0. */
static rounding
round_zero(const double a[3], const double b[3], const sg_bounded at[2],
           double out[3])
{
  sg_bounded part = sg_bounded_quotient(at[0], sg_bounded_minus(at[0], at[1]));
  bool rounded = isfinite(part.e), is_double = rounded;

  for (int k = 0; k < 3; k++) {
    sg_bounded x = {a[k] + 0.0, 0, 0}; /* never -0.0 */

    if (a[k] != b[k]) {
      x = sg_bounded_plus(
          x, sg_bounded_times(part, sg_bounded_difference(b[k], a[k])));
      rounded = rounded && sg_bounded_is_rounded(x);
      is_double = is_double && sg_bounded_may_be_double(x);
    }
    out[k] = fabs(x.hi) > x.e ? x.hi : 0;
  }
  return is_double ? MAY_BE_DOUBLE : rounded ? ROUNDED : NOT_ROUNDED;
}

/* ---- points that are doubles -------------------------------------------- */

/* Whether p is on the line a-b as it is seen along the third axis. */
static bool
is_on_line(const double a[3], const double b[3], const double p[3], int u,
           int v)
{
  if (a[u] == b[u] || a[v] == b[v]) {
    return (a[u] != b[u] || p[u] == a[u]) && (a[v] != b[v] || p[v] == a[v]);
  }
  return sg_orient2d((double[2]){a[u], a[v]}, (double[2]){b[u], b[v]},
                     (double[2]){p[u], p[v]}) == 0;
}

/* Whether p is exactly what make() makes. */
static bool
is_made_of(const double p[3], int how, const sg_point *const *point)
{
  const double *a = point[0]->p, *b = point[1]->p;

  for (int k = 0; k < 3; k++) {
    if (!is_on_line(a, b, p, k, (k + 1) % 3)) {
      return false;
    }
  }
  return how == LINE_AND_PLANE
             ? sg_orient3d(point[2]->p, point[3]->p, point[4]->p, p) == 0
             : is_on_line(point[2]->p, point[3]->p, p, (how + 1) % 3,
                          (how + 2) % 3);
}

/* ---- points that are made ----------------------------------------------- */

/* Keeps what made a point. False: no memory. */
static bool
keep_made(sg_point *out, int how, const sg_point *const *point, int n)
{
  if (!(out->exactly = new_exactly())) {
    return false;
  }
  out->exactly->how = how;
  for (int i = 0; i < n; i++) {
    memcpy(out->exactly->from[i], point[i]->p, sizeof point[i]->p);
  }
  return true;
}

static bool
make_q(mpq_t out[3], int how, const sg_point *const *point)
{
  return how == LINE_AND_PLANE ? line_meets_plane(out, point)
                               : line_meets_line(out, how, point);
}

static bool
make(sg_point *out, int how, const sg_point *const *point)
{
  int n = how == LINE_AND_PLANE ? 5 : 4;
  mpq_t q[3];

  out->exactly = NULL;
  if (in_range(point, n)) {
    sg_bounded at[2];

    if (how != LINE_AND_PLANE && are_seen_parallel(how, point)) {
      return false;
    }
    if (how == LINE_AND_PLANE) {
      heights_over_plane(point, at);
    } else {
      heights_beside_line(how, point, at);
    }
    rounding found = round_zero(point[0]->p, point[1]->p, at, out->p);
    if (found == ROUNDED) {
      return keep_made(out, how, point, n);
    }
    if (found == MAY_BE_DOUBLE && is_made_of(out->p, how, point)) {
      return true;
    }
  }
  init_q(q);
  bool done = make_q(q, how, point) && sg_point_set_q(out, q[0], q[1], q[2]);
  clear_q(q);
  return done;
}

/* The rationals of a point, from what it was made of. */
static void
make_known(sg_exactly *exactly)
{
  sg_point from[MADE_OF];
  const sg_point *of[MADE_OF];
  int unknown = UNKNOWN;
  mpq_t q[3];

  for (int i = 0; i < (exactly->how == LINE_AND_PLANE ? 5 : 4); i++) {
    sg_point_set(&from[i], exactly->from[i]);
    of[i] = &from[i];
  }
  init_q(q);
  make_q(q, exactly->how, of);
  if (atomic_compare_exchange_strong(&exactly->state, &unknown, BEING_PUT)) {
    memcpy(exactly->q, q, sizeof q);
    atomic_store_explicit(&exactly->state, KNOWN, memory_order_release);
    return;
  }
  clear_q(q);
  while (atomic_load_explicit(&exactly->state, memory_order_acquire) != KNOWN) {
    sched_yield(); /* for as long as three numbers are put there */
  }
}

mpq_t *
sg_point_q(const sg_point *point)
{
  sg_exactly *exactly = point->exactly;

  if (exactly &&
      atomic_load_explicit(&exactly->state, memory_order_acquire) != KNOWN) {
    make_known(exactly);
  }
  return exactly ? exactly->q : NULL;
}

bool
sg_point_lpi(sg_point *out, const sg_point *a, const sg_point *b,
             const sg_point *c, const sg_point *d, const sg_point *e)
{
  const sg_point *const point[5] = {a, b, c, d, e};

  return make(out, LINE_AND_PLANE, point);
}

bool
sg_point_ll(sg_point *out, int axis, const sg_point *a, const sg_point *b,
            const sg_point *c, const sg_point *d)
{
  const sg_point *const point[4] = {a, b, c, d};

  return make(out, axis, point);
}

bool
sg_point_tpi(sg_point *out, const sg_point *const plane[3][3])
{
  mpz_t room[9][3], n[3][3], at[3], s[3], t[3];
  mpq_t q[3];
  const sg_point *point[9];
  sg_integers in;

  out->exactly = NULL;
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
  init_q(q);
  bool done =
      solve_planes(q, n, at, in.w) && sg_point_set_q(out, q[0], q[1], q[2]);
  clear_q(q);
  for (int i = 0; i < 3; i++) {
    sg_integers_clear3(n[i]);
  }
  sg_integers_clear3(at);
  sg_integers_clear3(t);
  sg_integers_clear3(s);
  sg_integers_close(&in);
  return done;
}
