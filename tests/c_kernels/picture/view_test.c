/* view_test.c -- PL-11, PL-12: the formulas, by their own words. */
#include "picture/view.h"
#include "tests/check.h"

#include <math.h>
#include <stdlib.h>

static bool
is(const double a[3], double x, double y, double z)
{
  return a[0] == x && a[1] == y && a[2] == z && !signbit(a[0] + 0.0);
}

/* Where the model point (1,2,3) is seen from (theta, phi). */
static bool
sees(double theta, double phi, double x, double y, double z)
{
  const double p[3] = {1, 2, 3};
  double out[3];
  sg_eye eye;

  sg_eye_init(&eye, theta, phi, 10);
  sg_eye_point(&eye, p, out);
  return out[0] == x && out[1] == y && out[2] == z;
}

static void
quarters(void)
{
  double s, c;

  CHECK("front is (270,90)", sees(270, 90, 1, 3, 2));
  CHECK("right is (0,90)", sees(0, 90, 2, 3, -1));
  CHECK("top is (270,0)", sees(270, 0, 1, 2, -3));
  CHECK("back is (90,90)", sees(90, 90, -1, 3, -2));
  CHECK("left is (180,90)", sees(180, 90, -2, 3, 1));
  CHECK("bottom is (270,180)", sees(270, 180, 1, -2, 3));
  CHECK("-90 is 270", sees(-90, 90, 1, 3, 2));
  CHECK("a million turns later", sees(270 + 360e6, 90, 1, 3, 2));
  for (int k = -8; k <= 8; k++) {
    sg_sine_cosine(90.0 * k, &s, &c);
    CHECK("multiples of 90 are exact",
          (s == 0 || fabs(s) == 1) && s * s + c * c == 1);
  }
  sg_sine_cosine(30, &s, &c);
  CHECK("the sine of 30 is a half", s == 0.5);
  sg_sine_cosine(150, &s, &c);
  CHECK("and of 150", s == 0.5 && c < 0);
}

static void
against_libm(void)
{
  double s, c, worst = 0;

  srand(7);
  for (int i = 0; i < 2000; i++) {
    double degrees = 1440.0 * rand() / RAND_MAX - 720.0;
    double angle = degrees * acos(-1.0) / 180;
    sg_sine_cosine(degrees, &s, &c);
    worst = fmax(worst, fmax(fabs(s - sin(angle)), fabs(c - cos(angle))));
  }
  CHECK("as the library's sine", worst < 1e-14);
}

/* The paper's formulas, term by term, in long double. */
static void
eye_by_formula(long double theta, long double phi, const double p[3],
               double out[3])
{
  long double d = acosl(-1.0L) / 180, X = p[0], Y = p[1], Z = p[2];
  long double st = sinl(theta * d), ct = cosl(theta * d);
  long double sp = sinl(phi * d), cp = cosl(phi * d);

  out[0] = (double)(-X * st + Y * ct);
  out[1] = (double)(-X * ct * cp - Y * st * cp + Z * sp);
  out[2] = (double)(-X * sp * ct - Y * st * sp - Z * cp);
}

static double
uniform(void)
{
  return 2.0 * rand() / RAND_MAX - 1.0;
}

static void
against_formula(void)
{
  double p[3], out[3], want[3], worst = 0, rounded = 0, off = 0;
  sg_eye eye;

  srand(8);
  for (int i = 0; i < 2000; i++) {
    double theta = 360 * uniform(), phi = 90 + 90 * uniform();
    for (int k = 0; k < 3; k++) {
      p[k] = uniform();
    }
    sg_eye_init(&eye, theta, phi, 5);
    sg_eye_point(&eye, p, out);
    eye_by_formula(theta, phi, p, want);
    for (int k = 0; k < 3; k++) {
      const double *r = eye.row[k];
      long double sum = (long double)p[0] * r[0] + (long double)p[1] * r[1] +
                        (long double)p[2] * r[2];
      worst = fmax(worst, fabs(out[k] - want[k]));
      off = fmax(off, fabs(out[k] - (double)sum));
      for (int j = 0; j < 3; j++) {
        rounded = fmax(rounded, fabs(rint(r[j] * 0x1p30) - r[j] * 0x1p30));
      }
    }
  }
  CHECK("PL-11 as printed, to 30 bits", worst < 2e-9);
  CHECK("the matrix has 30 bits after the point", rounded == 0);
  CHECK("and then it is exact", off < 1.2e-16);
}

static void
central(void)
{
  double a[3] = {1, 2, -1}, b[3] = {1, 2, 3}, m[3] = {1, 2, 1};
  double along;
  sg_eye eye;
  sg_range range = sg_range_empty(), flat = sg_range_empty();

  sg_eye_init(&eye, 270, 90, 5);
  sg_range_add(&range, &eye, a[2]);
  sg_range_add(&range, &eye, b[2]);
  CHECK("D and F", range.nearest == 4 && range.farthest == 8);
  CHECK("in front of the eye", sg_range_is_visible(&range));
  sg_central_point(&eye, &range, a);
  sg_central_point(&eye, &range, b);
  sg_central_point(&eye, &range, m);
  CHECK("at D nothing shrinks, depth 0", is(a, 1, 2, 0));
  CHECK("at F by D/F, depth 1", is(b, 0.5, 1, 1));
  along = (m[0] - a[0]) / (b[0] - a[0]);
  CHECK("depth is linear on the screen", fabs(m[2] - along) < 1e-15);
  CHECK("one unit of Zs at D", fabs(sg_central_depth(&range) - 2) < 1e-15);
  sg_range_add(&range, &eye, -5);
  CHECK("the eye in the model", !sg_range_is_visible(&range));
  sg_range_add(&flat, &eye, 1);
  sg_range_add(&flat, &eye, 1 + 1e-15);
  CHECK("D = F up to rounding", sg_range_is_flat(&flat));
  m[0] = 1, m[1] = 2, m[2] = 1;
  sg_central_point(&eye, &flat, m);
  CHECK("then depth is 0", is(m, 1, 2, 0));
}

int
main(void)
{
  quarters();
  against_libm();
  against_formula();
  central();
  return check_report();
}
