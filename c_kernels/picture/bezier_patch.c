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

/* At t, m being 1 - t: what is turned round is the same the other way. */
static void
polynomials(double t, double m, double value[4])
{
  value[0] = m * m * m;
  value[1] = 3.0 * (m * m) * t;
  value[2] = 3.0 * (t * t) * m;
  value[3] = t * t * t;
}

static void
slopes(double t, double slope[4])
{
  double m = 1.0 - t;

  slope[0] = -3.0 * m * m;
  slope[1] = 3.0 * m * m - 6.0 * m * t;
  slope[2] = 6.0 * m * t - 3.0 * t * t;
  slope[3] = 3.0 * t * t;
}

void
sg_bezier_weights(size_t i, size_t n, double weight[4])
{
  polynomials((double)i / (double)n, (double)(n - i) / (double)n, weight);
}

/* The same, whichever end is first. */
static double
mixed(const double weight[4], double a, double b, double c, double d)
{
  return (weight[0] * a + weight[3] * d) + (weight[1] * b + weight[2] * c);
}

void
sg_bezier_row(const double control[16][3], const double weight[4],
              double row[4][3])
{
  for (int u = 0; u < 4; u++) {
    for (int k = 0; k < 3; k++) {
      row[u][k] = mixed(weight, control[u][k], control[4 + u][k],
                        control[8 + u][k], control[12 + u][k]);
    }
  }
}

void
sg_bezier_point(const double row[4][3], const double weight[4], double out[3])
{
  for (int k = 0; k < 3; k++) {
    out[k] = mixed(weight, row[0][k], row[1][k], row[2][k], row[3][k]);
  }
}

/* ---- how much it bends ---- */

/* The length of A - B - C + D, where `map` brings it, of these control points.
 */
static double
bend_of(const double control[16][3], const double map[3][3], const int of[4])
{
  double v[3], out[3];

  for (int k = 0; k < 3; k++) {
    v[k] = control[of[0]][k] - control[of[1]][k] - control[of[2]][k] +
           control[of[3]][k];
  }
  for (int k = 0; k < 3; k++) {
    out[k] = sg_dot(map[k], v);
  }
  return sg_any_length(out);
}

double
sg_bezier_bend(const double control[16][3], const double map[3][3])
{
  double most[3] = {0, 0, 0}; /* along u, along v, of both */

  for (int i = 0; i < 16; i++) {
    int u = i % 4, v = i / 4;
    const int of[3][4] = {{i, i + 1, i + 1, i + 2},
                          {i, i + 4, i + 4, i + 8},
                          {i, i + 1, i + 4, i + 5}};
    const bool is[3] = {u < 2, v < 2, u < 3 && v < 3};
    for (int k = 0; k < 3; k++) {
      if (is[k]) {
        most[k] = sg_larger(most[k], bend_of(control, map, of[k]));
      }
    }
  }
  return 6.0 * most[0] + 6.0 * most[1] + 18.0 * most[2];
}

/* ---- the nearest point ---- */

static void
place_at(const double control[16][3], const double uv[2], place *out)
{
  double value[2][4], slope[2][4];

  *out = (place){0};
  for (int k = 0; k < 2; k++) {
    polynomials(uv[k], 1.0 - uv[k], value[k]);
    slopes(uv[k], slope[k]);
  }
  for (int i = 0; i < 16; i++) {
    int u = i % 4, v = i / 4;
    for (int k = 0; k < 3; k++) {
      out->at[k] += value[0][u] * value[1][v] * control[i][k];
      out->along[0][k] += slope[0][u] * value[1][v] * control[i][k];
      out->along[1][k] += value[0][u] * slope[1][v] * control[i][k];
    }
  }
}

static void
nearest_of_net(const double control[16][3], const double p[3], double uv[2])
{
  double value[NET + 1][4], row[4][3], at[3], least = INFINITY;

  for (size_t i = 0; i <= NET; i++) {
    sg_bezier_weights(i, NET, value[i]);
  }
  for (size_t j = 0; j <= NET; j++) {
    sg_bezier_row(control, value[j], row);
    for (size_t i = 0; i <= NET; i++) {
      double off[3];
      sg_bezier_point((const double(*)[3])row, value[i], at);
      sg_minus(at, p, off);
      double square = sg_dot(off, off);
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
