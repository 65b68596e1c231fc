#include "sign.h"

#include <limits.h>
#include <math.h>
#include <stdbool.h>

/* More than all roundings of a determinant of differences together, as part of
 * the sum of its terms' absolute values; where those are tiny, underflow is
 * not covered. */
static const double ERROR = 1e-15, TINY = 1e-280;

int
lowest_bit(const double *const *points, int n)
{
  int lowest = INT_MAX;

  for (int i = 0; i < n; i++) {
    for (int k = 0; k < 3; k++) {
      int exponent;

      if (points[i][k] != 0) {
        (void)frexp(points[i][k], &exponent);
        lowest = exponent - 53 < lowest ? exponent - 53 : lowest;
      }
    }
  }
  return lowest == INT_MAX ? 0 : lowest;
}

void
integer_of(mpz_t out, double value, int lowest)
{
  int exponent;
  double digits = ldexp(frexp(value, &exponent), 53);

  mpz_set_d(out, digits);
  if (value != 0) {
    mpz_mul_2exp(out, out, (mp_bitcnt_t)(exponent - 53 - lowest));
  }
}

/* b - a in out[3]. */
static void
difference(mpz_t *out, const double *a, const double *b, int lowest)
{
  mpz_t from;

  mpz_init(from);
  for (int k = 0; k < 3; k++) {
    integer_of(out[k], b[k], lowest);
    integer_of(from, a[k], lowest);
    mpz_sub(out[k], out[k], from);
  }
  mpz_clear(from);
}

/* out += factor (u[x] v[y] - u[y] v[x]) */
static void
add_minor(mpz_t out, mpz_t factor, mpz_t *u, mpz_t *v, int x, int y)
{
  mpz_t minor;

  mpz_init(minor);
  mpz_mul(minor, u[x], v[y]);
  mpz_submul(minor, u[y], v[x]);
  mpz_addmul(out, factor, minor);
  mpz_clear(minor);
}

void
volume_of(mpz_t out, const double *a, const double *b, const double *c,
          const double *d, const double *const *all, int n)
{
  int lowest = lowest_bit(all, n);
  mpz_t u[3][3];

  for (int i = 0; i < 9; i++) {
    mpz_init(u[i / 3][i % 3]);
  }
  difference(u[0], a, b, lowest);
  difference(u[1], a, c, lowest);
  difference(u[2], a, d, lowest);
  mpz_set_ui(out, 0);
  add_minor(out, u[2][0], u[0], u[1], 1, 2);
  add_minor(out, u[2][1], u[0], u[1], 2, 0);
  add_minor(out, u[2][2], u[0], u[1], 0, 1);
  for (int i = 0; i < 9; i++) {
    mpz_clear(u[i / 3][i % 3]);
  }
}

/* True if the sign of `sum` is certain, whose terms' sizes add up to `size`. */
static bool
certain(double sum, double size)
{
  return size > TINY && fabs(sum) > ERROR * size;
}

int
sign_of_volume(const double *a, const double *b, const double *c,
               const double *d)
{
  const double *all[4] = {a, b, c, d};
  double u[3], v[3], w[3], sum = 0, size = 0;
  int sign;
  mpz_t volume;

  for (int k = 0; k < 3; k++) {
    u[k] = b[k] - a[k];
    v[k] = c[k] - a[k];
    w[k] = d[k] - a[k];
  }
  for (int k = 0; k < 3; k++) {
    int x = (k + 1) % 3, y = (k + 2) % 3;
    double p = u[x] * v[y], q = u[y] * v[x];

    sum += w[k] * (p - q);
    size += fabs(w[k]) * (fabs(p) + fabs(q));
  }
  if (certain(sum, size)) {
    return sum > 0 ? 1 : -1;
  }
  mpz_init(volume);
  volume_of(volume, a, b, c, d, all, 4);
  sign = mpz_sgn(volume);
  mpz_clear(volume);
  return sign;
}

static int
exact_sign_of_area(const double *a, const double *b, const double *c, int x,
                   int y)
{
  const double *all[3] = {a, b, c};
  int lowest = lowest_bit(all, 3), sign;
  mpz_t u[2][3], area, one;

  for (int i = 0; i < 6; i++) {
    mpz_init(u[i / 3][i % 3]);
  }
  mpz_init(area);
  mpz_init_set_ui(one, 1);
  difference(u[0], a, b, lowest);
  difference(u[1], a, c, lowest);
  add_minor(area, one, u[0], u[1], x, y);
  sign = mpz_sgn(area);
  for (int i = 0; i < 6; i++) {
    mpz_clear(u[i / 3][i % 3]);
  }
  mpz_clear(area);
  mpz_clear(one);
  return sign;
}

int
sign_of_area(const double *a, const double *b, const double *c, int x, int y)
{
  double p = (b[x] - a[x]) * (c[y] - a[y]);
  double q = (b[y] - a[y]) * (c[x] - a[x]);

  if (certain(p - q, fabs(p) + fabs(q))) {
    return p > q ? 1 : -1;
  }
  return exact_sign_of_area(a, b, c, x, y);
}
