/* bezier_grid.c -- see bezier_grid.h */
#include "bezier_grid.h"

#include "number/exact.h"

#include <gmp.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>

enum { MANTISSA = 53 };

/* Coordinates are whole multiples of 2^exponent / n^6. */
typedef struct grid {
  size_t n;
  mpz_t control[16][3];
  mpz_t curve[4][3];     /* of a row of points */
  mpz_t (*line[2])[3];   /* [n + 1] points of the last two rows */
  mpz_t square[2], part; /* of diagonals */
  mpq_t value;
  int exponent;
} grid;

/* The four Bernstein polynomials at i / n, times n^3. */
static void
weights(size_t i, size_t n, unsigned long out[4])
{
  unsigned long a = i, b = n - i;

  out[0] = b * b * b;
  out[1] = 3 * b * b * a;
  out[2] = 3 * b * a * a;
  out[3] = a * a * a;
}

static void
mix(mpz_t out, const unsigned long weight[4], mpz_t a, mpz_t b, mpz_t c,
    mpz_t d)
{
  mpz_mul_ui(out, a, weight[0]);
  mpz_addmul_ui(out, b, weight[1]);
  mpz_addmul_ui(out, c, weight[2]);
  mpz_addmul_ui(out, d, weight[3]);
}

/* ---- control points as integers ---- */

static int
exponent_of(double x)
{
  int exponent;

  (void)frexp(x, &exponent);
  return exponent - MANTISSA;
}

static void
read_control(grid *g, const double control[16][3])
{
  g->exponent = INT_MAX;
  for (int i = 0; i < 48; i++) {
    double x = control[i / 3][i % 3];
    int exponent = exponent_of(x);
    g->exponent = x != 0 && exponent < g->exponent ? exponent : g->exponent;
  }
  g->exponent = g->exponent == INT_MAX ? 0 : g->exponent;
  for (int i = 0; i < 48; i++) {
    mpz_t *out = &g->control[i / 3][i % 3];
    double x = control[i / 3][i % 3];
    if (x != 0) {
      int exponent = exponent_of(x);
      mpz_set_d(*out, ldexp(x, -exponent));
      mpz_mul_2exp(*out, *out, (mp_bitcnt_t)(exponent - g->exponent));
    }
  }
}

/* ---- points ---- */

/* n^6 / 2^exponent, as far as it is whole. */
static void
set_scale(grid *g)
{
  mpz_ui_pow_ui(mpq_denref(g->value), g->n, 6);
  if (g->exponent < 0) {
    mpz_mul_2exp(mpq_denref(g->value), mpq_denref(g->value),
                 (mp_bitcnt_t)-g->exponent);
  }
}

static double
rounded(grid *g, mpz_t whole)
{
  mpz_mul_2exp(mpq_numref(g->value), whole,
               (mp_bitcnt_t)(g->exponent > 0 ? g->exponent : 0));
  return sg_nearest_double(g->value);
}

static void
fill_line(grid *g, size_t j, mpz_t (*line)[3], double (*at)[3])
{
  unsigned long weight[4];

  weights(j, g->n, weight);
  for (int i = 0; i < 12; i++) {
    int u = i / 3, k = i % 3;
    mix(g->curve[u][k], weight, g->control[u][k], g->control[4 + u][k],
        g->control[8 + u][k], g->control[12 + u][k]);
  }
  for (size_t i = 0; i <= g->n; i++) {
    weights(i, g->n, weight);
    for (int k = 0; k < 3; k++) {
      mix(line[i][k], weight, g->curve[0][k], g->curve[1][k], g->curve[2][k],
          g->curve[3][k]);
      at[i][k] = rounded(g, line[i][k]);
    }
  }
}

/* ---- diagonals ---- */

static void
set_square(grid *g, mpz_t out, mpz_t *p, mpz_t *q)
{
  mpz_set_ui(out, 0);
  for (int k = 0; k < 3; k++) {
    mpz_sub(g->part, p[k], q[k]);
    mpz_addmul(out, g->part, g->part);
  }
}

static void
fill_turned(grid *g, bool *turned)
{
  mpz_t(*below)[3] = g->line[0], (*above)[3] = g->line[1];

  for (size_t i = 0; i < g->n; i++) {
    set_square(g, g->square[0], below[i], above[i + 1]);
    set_square(g, g->square[1], below[i + 1], above[i]);
    turned[i] = mpz_cmp(g->square[0], g->square[1]) > 0;
  }
}

/* ---- all ---- */

/* All numbers of a grid: made, or given back. */
static void
each_number(grid *g, void (*do_it)(mpz_ptr))
{
  for (int k = 0; k < 48; k++) {
    do_it(g->control[k / 3][k % 3]);
  }
  for (int k = 0; k < 12; k++) {
    do_it(g->curve[k / 3][k % 3]);
  }
  for (size_t k = 0; k < 3 * (g->n + 1); k++) {
    do_it(g->line[0][k / 3][k % 3]);
    do_it(g->line[1][k / 3][k % 3]);
  }
  do_it(g->square[0]);
  do_it(g->square[1]);
  do_it(g->part);
}

static void
fill(grid *g, const double control[16][3], double (*at)[3], bool *turned)
{
  each_number(g, mpz_init);
  mpq_init(g->value);
  read_control(g, control);
  set_scale(g);
  for (size_t j = 0; j <= g->n; j++) {
    fill_line(g, j, g->line[1], &at[j * (g->n + 1)]);
    if (j > 0) {
      fill_turned(g, &turned[(j - 1) * g->n]);
    }
    mpz_t(*last)[3] = g->line[0];
    g->line[0] = g->line[1];
    g->line[1] = last;
  }
  each_number(g, mpz_clear);
  mpq_clear(g->value);
}

bool
sg_bezier_grid(const double control[16][3], size_t n, double (*at)[3],
               bool *turned)
{
  grid g = {.n = n};

  for (int k = 0; k < 2; k++) {
    g.line[k] = malloc((n + 1) * sizeof *g.line[k]);
  }
  bool good = g.line[0] && g.line[1];
  if (good) {
    fill(&g, control, at, turned);
  }
  free(g.line[0]);
  free(g.line[1]);
  return good;
}
