/* quartic_test.c -- roots of quartics that are made of known ones: four, two,
 * two that are one, none; and where the discriminant says that it changes.
 */
#include "shading/quartic.h"

#include "tests/check.h"

#include <math.h>

static uint32_t seed = 3;

static double
uniform(double from, double to)
{
  return from + (to - from) * check_below(&seed, 10007) / 10006;
}

/* (z z + p z + q) (z z + r z + s), times `lead`. */
static void
product(double p, double q, double r, double s, double lead, double c[5])
{
  c[0] = lead * q * s;
  c[1] = lead * (p * s + q * r);
  c[2] = lead * (s + p * r + q);
  c[3] = lead * (p + r);
  c[4] = lead;
}

static void
of_roots(const double z[4], double c[5])
{
  product(-z[0] - z[1], z[0] * z[1], -z[2] - z[3], z[2] * z[3],
          uniform(0.5, 20), c);
}

static bool
near(double a, double b, double off)
{
  return fabs(a - b) <= off;
}

static void
four(void)
{
  double z[4], c[5];
  bool good = true;

  z[0] = uniform(-0.9, -0.3);
  for (int i = 1; i < 4; i++) {
    z[i] = z[i - 1] + uniform(0.001, 0.4);
  }
  of_roots(z, c);
  for (int i = 0; i < 4; i++) {
    sg_quartic_root root = (sg_quartic_root)(SG_ROOT_NEAR_IN + i);
    good = good && near(sg_quartic_place(c, root), z[i], 1e-7);
  }
  CHECK("four roots", sg_quartic_count(c) == 4 && good);
  CHECK("the first and the last one",
        near(sg_quartic_place(c, SG_ROOT_FIRST), z[0], 1e-7) &&
            near(sg_quartic_place(c, SG_ROOT_LAST), z[3], 1e-7));
  CHECK("its discriminant", sg_quartic_discriminant(c) > 0);
}

/* Two real ones, and two that are not: a well beside, or a bend of one. */
static void
two(void)
{
  double a = uniform(-0.9, 0.8), b = a + uniform(0.001, 0.9 - a);
  double m = uniform(-0.9, 0.9), n = uniform(0.01, 0.6), c[5];

  product(-a - b, a * b, -2 * m, m * m + n * n, uniform(0.5, 20), c);
  CHECK("two roots", sg_quartic_count(c) == 2);
  CHECK("where they are", near(sg_quartic_place(c, SG_ROOT_FIRST), a, 1e-7) &&
                              near(sg_quartic_place(c, SG_ROOT_LAST), b, 1e-7));
  CHECK("their discriminant", sg_quartic_discriminant(c) < 0);
}

/* The nearer well is but touched. */
static void
touched(void)
{
  double z = uniform(-0.9, -0.2), c[5];
  double far[2] = {uniform(0, 0.4), uniform(0.5, 0.9)};

  product(-2 * z, z * z, -far[0] - far[1], far[0] * far[1], 1.0, c);
  CHECK("two roots that are one",
        near(sg_quartic_place(c, SG_ROOT_NEAR_IN), z, 1e-6) &&
            near(sg_quartic_place(c, SG_ROOT_NEAR_OUT), z, 1e-6));
  CHECK("behind them the others",
        near(sg_quartic_place(c, SG_ROOT_FAR_IN), far[0], 1e-7) &&
            near(sg_quartic_place(c, SG_ROOT_FAR_OUT), far[1], 1e-7));
  c[0] += 1e-3; /* now it is missed */
  CHECK("a well that is missed", sg_quartic_count(c) == 2);
  CHECK("its bottom", near(sg_quartic_place(c, SG_ROOT_NEAR_OUT), z, 0.1) &&
                          sg_quartic_place(c, SG_ROOT_FIRST) > -0.05);
}

static void
none(void)
{
  double c[5];

  product(-2 * uniform(-0.5, 0.5), 1.0, -2 * uniform(-0.9, 0.9), 1.5, 2.0, c);
  CHECK("no root", sg_quartic_count(c) == 0);
}

static double
bernstein(const sg_polynomial *p, double s)
{
  double sum = 0.0, choose = 1.0;

  for (int k = 0; k <= p->n; k++) {
    sum += choose * p->c[k] * pow(s, k) * pow(1 - s, p->n - k);
    choose = choose * (p->n - k) / (k + 1);
  }
  return sum;
}

static void
along(void)
{
  sg_polynomial c[5], out;
  double here[5], noise, s = uniform(0, 0.9), u = s / (1 - s);

  for (int k = 0; k < 5; k++) {
    double power = 1.0, whole = 0.0;
    c[k].n = 4 - k;
    for (int i = 0; i <= 4 - k; i++) {
      c[k].c[i] = uniform(-1, 1);
      whole += c[k].c[i] * power;
      power *= u;
    }
    here[k] = whole / pow(1 + u, 4 - k);
  }
  sg_discriminant_along(c, &out, &noise);
  double is = bernstein(&out, s), wanted = sg_quartic_discriminant(here);
  CHECK("a discriminant of degree 12",
        out.n == 12 && near(is, wanted, 1e-9 * (1 + fabs(wanted))));
  CHECK("its noise is small", noise > 0 && noise < 1e-9);
}

static void
between(void)
{
  const double c[] = {-0.25, 0, 1}; /* z z = 1/4 */

  CHECK("up", sg_root_between(c, 2, 0, 1, true) == 0.5);
  CHECK("down", sg_root_between(c, 2, -1, 0, false) == -0.5);
  CHECK("above all", sg_root_between(c, 2, 0.75, 1, true) == 0.75);
  CHECK("below all", sg_root_between(c, 2, 0, 0.25, true) == 0.25);
}

int
main(void)
{
  for (int i = 0; i < 2000; i++) {
    four();
    two();
    touched();
    none();
    along();
  }
  between();
  return check_report();
}
