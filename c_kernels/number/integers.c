/* integers.c -- points as integers over one denominator: see integers.h. */
#include "integers.h"

#include <math.h>

/* x = mantissa * 2^*exponent, mantissa odd or 0. */
static int64_t
mantissa(double x, int *exponent)
{
  int64_t m = (int64_t)ldexp(frexp(x, exponent), 53);

  *exponent -= 53;
  if (m == 0) {
    *exponent = 0;
    return 0;
  }
  int zeros = __builtin_ctzll((unsigned long long)m);
  *exponent += zeros;
  return m / ((int64_t)1 << zeros);
}

static void
common_denominator(mpz_ptr w, const sg_point *const *point, int n)
{
  int lowest = 0;

  mpz_set_ui(w, 1);
  for (int i = 0; i < n; i++) {
    mpq_t *q = sg_point_q(point[i]);

    for (int k = 0; k < 3; k++) {
      if (q) {
        mpz_lcm(w, w, mpq_denref(q[k]));
      } else {
        int exponent;
        mantissa(point[i]->p[k], &exponent);
        lowest = exponent < lowest ? exponent : lowest;
      }
    }
  }
  mp_bitcnt_t twos = mpz_scan1(w, 0), need = (mp_bitcnt_t)-lowest;
  if (need > twos) {
    mpz_mul_2exp(w, w, need - twos);
  }
}

static void
scale_double(mpz_ptr out, double x, mpz_srcptr w)
{
  int exponent;
  int64_t m = mantissa(x, &exponent);

  mpz_mul_si(out, w, (long)m);
  if (exponent >= 0) {
    mpz_mul_2exp(out, out, (mp_bitcnt_t)exponent);
  } else {
    mpz_fdiv_q_2exp(out, out, (mp_bitcnt_t)-exponent);
  }
}

/* x and y over 2^-lowest, from doubles. */
static void
of_two_doubles(double p, double q, mpz_ptr x, mpz_ptr y, mpz_ptr w)
{
  int of_p, of_q;
  int64_t m = mantissa(p, &of_p), n = mantissa(q, &of_q);
  int lowest = of_p < of_q ? of_p : of_q;

  lowest = lowest < 0 ? lowest : 0;
  mpz_set_si(x, (long)m);
  mpz_mul_2exp(x, x, (mp_bitcnt_t)(of_p - lowest));
  mpz_set_si(y, (long)n);
  mpz_mul_2exp(y, y, (mp_bitcnt_t)(of_q - lowest));
  mpz_set_ui(w, 1);
  mpz_mul_2exp(w, w, (mp_bitcnt_t)-lowest);
}

void
sg_integers_of_two(const sg_point *point, int u, int v, mpz_t room[3],
                   mpz_srcptr out[3])
{
  mpq_t *q = sg_point_q(point);

  for (int k = 0; k < 3; k++) {
    out[k] = room[k];
  }
  if (!q) {
    of_two_doubles(point->p[u], point->p[v], room[0], room[1], room[2]);
  } else if (mpz_cmp(mpq_denref(q[u]), mpq_denref(q[v])) == 0) {
    out[0] = mpq_numref(q[u]);
    out[1] = mpq_numref(q[v]);
    out[2] = mpq_denref(q[u]);
  } else {
    mpz_mul(room[0], mpq_numref(q[u]), mpq_denref(q[v]));
    mpz_mul(room[1], mpq_numref(q[v]), mpq_denref(q[u]));
    mpz_mul(room[2], mpq_denref(q[u]), mpq_denref(q[v]));
  }
}

void
sg_integers_open(sg_integers *out, mpz_t (*room)[3],
                 const sg_point *const *point, int n)
{
  mpz_init(out->w);
  common_denominator(out->w, point, n);
  out->x = room;
  out->n = n;
  for (int i = 0; i < n; i++) {
    mpq_t *q = sg_point_q(point[i]);

    for (int k = 0; k < 3; k++) {
      mpz_init2(room[i][k], SG_INTEGER_BITS);
      if (q) {
        mpz_divexact(room[i][k], out->w, mpq_denref(q[k]));
        mpz_mul(room[i][k], room[i][k], mpq_numref(q[k]));
      } else {
        scale_double(room[i][k], point[i]->p[k], out->w);
      }
    }
  }
}

void
sg_integers_close(sg_integers *in)
{
  for (int i = 0; i < in->n; i++) {
    for (int k = 0; k < 3; k++) {
      mpz_clear(in->x[i][k]);
    }
  }
  mpz_clear(in->w);
}

void
sg_integers_minor(mpz_ptr out, mpz_t a[3], mpz_t b[3], int u, int v)
{
  mpz_mul(out, a[u], b[v]);
  mpz_submul(out, a[v], b[u]);
}

void
sg_integers_subtract(mpz_t out[3], mpz_t a[3], mpz_t b[3])
{
  for (int k = 0; k < 3; k++) {
    mpz_sub(out[k], a[k], b[k]);
  }
}

void
sg_integers_init3(mpz_t v[3])
{
  for (int k = 0; k < 3; k++) {
    mpz_init2(v[k], SG_INTEGER_BITS);
  }
}

void
sg_integers_clear3(mpz_t v[3])
{
  mpz_clears(v[0], v[1], v[2], NULL);
}

void
sg_integers_normal(mpz_t n[3], mpz_t a[3], mpz_t b[3], mpz_t c[3], mpz_t s[3],
                   mpz_t t[3])
{
  sg_integers_subtract(s, b, a);
  sg_integers_subtract(t, c, a);
  sg_integers_minor(n[0], s, t, 1, 2);
  sg_integers_minor(n[1], s, t, 2, 0);
  sg_integers_minor(n[2], s, t, 0, 1);
}

void
sg_integers_dot(mpz_ptr out, mpz_t a[3], mpz_t b[3])
{
  mpz_mul(out, a[0], b[0]);
  mpz_addmul(out, a[1], b[1]);
  mpz_addmul(out, a[2], b[2]);
}
