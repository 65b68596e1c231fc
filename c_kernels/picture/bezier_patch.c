/* bezier_patch.c -- see bezier_patch.h */
#include "bezier_patch.h"

#include "number/bounds.h"
#include "number/vector.h"

#include <math.h>

/* Steps from the nearest point of the net: those to a point on the patch
 * converge quadratically. */
enum { STEPS = 12, NET = 4 };

/* Directions that differ by less than this part of their lengths give no
 * normal. */
#define PARALLEL 1e-9

/* A step by less than this is none. */
#define THERE 1e-14

/* A point of the patch, and where u and v go there. */
typedef struct place {
  double at[3], along[2][3];
} place;

/* The four Bernstein polynomials and their derivatives. */
static void
bernstein(double t, double value[4], double slope[4])
{
  double m = 1.0 - t;

  value[0] = m * m * m;
  value[1] = 3.0 * m * m * t;
  value[2] = 3.0 * m * t * t;
  value[3] = t * t * t;
  slope[0] = -3.0 * m * m;
  slope[1] = 3.0 * m * m - 6.0 * m * t;
  slope[2] = 6.0 * m * t - 3.0 * t * t;
  slope[3] = 3.0 * t * t;
}

static void
place_at(const double control[16][3], const double uv[2], place *out)
{
  double value[2][4], slope[2][4];

  *out = (place){0};
  bernstein(uv[0], value[0], slope[0]);
  bernstein(uv[1], value[1], slope[1]);
  for (int i = 0; i < 16; i++) {
    int u = i % 4, v = i / 4;
    for (int k = 0; k < 3; k++) {
      out->at[k] += value[0][u] * value[1][v] * control[i][k];
      out->along[0][k] += slope[0][u] * value[1][v] * control[i][k];
      out->along[1][k] += value[0][u] * slope[1][v] * control[i][k];
    }
  }
}

/* A row of the net: the points where v has these polynomials, as the control
 * points of a curve. */
static void
row_of_net(const double control[16][3], const double weight[4],
           double out[4][3])
{
  for (int u = 0; u < 4; u++) {
    for (int k = 0; k < 3; k++) {
      out[u][k] = weight[0] * control[u][k] + weight[1] * control[4 + u][k] +
                  weight[2] * control[8 + u][k] +
                  weight[3] * control[12 + u][k];
    }
  }
}

static double
square_off(const double row[4][3], const double weight[4], const double p[3])
{
  double sum = 0.0;

  for (int k = 0; k < 3; k++) {
    double off = weight[0] * row[0][k] + weight[1] * row[1][k] +
                 weight[2] * row[2][k] + weight[3] * row[3][k] - p[k];
    sum += off * off;
  }
  return sum;
}

static void
nearest_of_net(const double control[16][3], const double p[3], double uv[2])
{
  double value[NET + 1][4], slope[4], row[4][3], least = INFINITY;

  for (int i = 0; i <= NET; i++) {
    bernstein((double)i / NET, value[i], slope);
  }
  for (int j = 0; j <= NET; j++) {
    row_of_net(control, value[j], row);
    for (int i = 0; i <= NET; i++) {
      double square = square_off((const double(*)[3])row, value[i], p);
      if (square < least) {
        least = square;
        uv[0] = (double)i / NET;
        uv[1] = (double)j / NET;
      }
    }
  }
}

/* One step to the point nearest to p. False: no direction is known, or it is
 * there. */
static bool
step(const place *here, const double p[3], double uv[2])
{
  double off[3], uu, vv, mixed, down[2], by[2], volume;

  sg_minus(p, here->at, off);
  uu = sg_dot(here->along[0], here->along[0]);
  vv = sg_dot(here->along[1], here->along[1]);
  mixed = sg_dot(here->along[0], here->along[1]);
  down[0] = sg_dot(off, here->along[0]);
  down[1] = sg_dot(off, here->along[1]);
  volume = uu * vv - mixed * mixed;
  if (!(volume > PARALLEL * PARALLEL * uu * vv)) {
    return false;
  }
  by[0] = (vv * down[0] - mixed * down[1]) / volume;
  by[1] = (uu * down[1] - mixed * down[0]) / volume;
  for (int k = 0; k < 2; k++) {
    uv[k] = sg_smaller(sg_larger(uv[k] + by[k], 0.0), 1.0);
  }
  return fabs(by[0]) + fabs(by[1]) > THERE;
}

bool
sg_bezier_patch_normal(const double control[16][3], const double p[3],
                       double out[3])
{
  double uv[2];
  place here;

  nearest_of_net(control, p, uv);
  place_at(control, uv, &here);
  for (int i = 0; i < STEPS && step(&here, p, uv); i++) {
    place_at(control, uv, &here);
  }
  sg_cross(here.along[0], here.along[1], out);
  return sg_length(out) >
         PARALLEL * sg_length(here.along[0]) * sg_length(here.along[1]);
}
