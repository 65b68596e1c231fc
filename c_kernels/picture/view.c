/* view.c -- see view.h */
#include "view.h"

#include "number/bounded_double.h"

#include <math.h>

#define GRID 0x1p48

/* The rows of an eye are whole numbers of this. */
#define UNIT 0x1p-30

/* Ranges narrower than this part of their distance are flat: a double holds
 * only 2^-52 of it. */
#define FLAT 0x1p-40

static double
snapped(double x)
{
  return rint(x * GRID) / GRID + 0.0;
}

void
sg_sine_cosine(double degrees, double *sine, double *cosine)
{
  int quarter;
  double rest = remquo(fmod(degrees, 360.0), 90.0, &quarter);
  double angle = rest * (acos(-1.0) / 180.0);
  double s = rest == 0.0 ? 0.0 : snapped(sin(angle));
  double c = rest == 0.0 ? 1.0 : snapped(cos(angle));

  switch ((unsigned)quarter & 3) {
  case 0:
    *sine = s;
    *cosine = c;
    break;
  case 1:
    *sine = c;
    *cosine = 0.0 - s;
    break;
  case 2:
    *sine = 0.0 - s;
    *cosine = 0.0 - c;
    break;
  default:
    *sine = 0.0 - c;
    *cosine = s;
    break;
  }
}

void
sg_eye_init(sg_eye *eye, double theta, double phi, double rho)
{
  double st, ct, sp, cp;

  sg_sine_cosine(theta, &st, &ct);
  sg_sine_cosine(phi, &sp, &cp);
  *eye = (sg_eye){.row = {{-st, ct, 0.0},
                          {-ct * cp, -st * cp, sp},
                          {-sp * ct, -st * sp, -cp}},
                  .rho = rho};
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      eye->row[i][k] = rint(eye->row[i][k] / UNIT) * UNIT + 0.0;
    }
  }
}

/* r . p, rounded once: products without error, and the errors of sums summed
 * apart. */
static double
exact_dot(const double r[3], const double p[3])
{
  double sum = 0.0, rest = 0.0;

  for (int k = 0; k < 3; k++) {
    double high, low, off;
    sg_two_product(r[k], p[k], &high, &low);
    sg_two_sum(sum, high, &sum, &off);
    rest += off;
    rest += low;
  }
  return sum + rest + 0.0;
}

void
sg_eye_point(const sg_eye *eye, const double p[3], double out[3])
{
  for (int i = 0; i < 3; i++) {
    out[i] = exact_dot(eye->row[i], p);
  }
}

sg_range
sg_range_empty(void)
{
  return (sg_range){INFINITY, -INFINITY};
}

void
sg_range_add(sg_range *range, const sg_eye *eye, double depth)
{
  double ze = depth + eye->rho;

  range->nearest = fmin(range->nearest, ze);
  range->farthest = fmax(range->farthest, ze);
}

bool
sg_range_is_visible(const sg_range *range)
{
  return range->nearest > 0.0;
}

bool
sg_range_is_flat(const sg_range *range)
{
  return range->farthest - range->nearest <= FLAT * range->farthest;
}

void
sg_central_point(const sg_eye *eye, const sg_range *range, double p[3])
{
  double d = range->nearest, f = range->farthest;
  double ze = p[2] + eye->rho;
  double w = ze / d;

  p[0] = p[0] / w + 0.0;
  p[1] = p[1] / w + 0.0;
  p[2] =
      sg_range_is_flat(range) ? 0.0 : (ze / d - 1.0) / (1.0 - d / f) / w + 0.0;
}

double
sg_central_depth(const sg_range *range)
{
  double d = range->nearest, f = range->farthest;

  return sg_range_is_flat(range) ? d : (1.0 - d / f) * d;
}
