/* bezier_patch_test.c -- normals and points of patches whose are known. */
#include "picture/bezier_patch.h"
#include "tests/check.h"

#include <math.h>
#include <string.h>

/* The patch over the square of side 1 that is z = height * u * v: control
 * points of a product of lines are where the lines are. */
static void
saddle_init(double control[16][3], double height)
{
  for (int i = 0; i < 16; i++) {
    double u = i % 4 / 3.0, v = i / 4 / 3.0;
    control[i][0] = u, control[i][1] = v, control[i][2] = height * u * v;
  }
}

/* How far the normal found at (u, v) is from (-h v, -h u, 1). */
static double
error_at(const double control[16][3], double height, double u, double v)
{
  double p[3] = {u, v, height * u * v}, n[3] = {0};

  if (!sg_bezier_patch_normal(control, p, n)) {
    return INFINITY;
  }
  return hypot(n[0] / n[2] + height * v, n[1] / n[2] + height * u);
}

static void
test_saddle(void)
{
  double control[16][3], worst = 0.0;

  for (int h = -3; h <= 3; h++) {
    saddle_init(control, h);
    for (int i = 0; i <= 10; i++) {
      for (int j = 0; j <= 10; j++) {
        worst = fmax(worst, error_at((const double(*)[3])control, h, i / 10.0,
                                     j / 10.0));
      }
    }
  }
  CHECK("normals of saddles", worst < 1e-12);
}

/* The side v = 0 is one point. */
static void
test_point_side(void)
{
  double control[16][3], n[3], p[3] = {0.0, 0.0, 0.0}, q[3] = {0.25, 0.5, 0.0};

  for (int i = 0; i < 16; i++) {
    double u = i % 4 / 3.0, v = i / 4 / 3.0;
    control[i][0] = u * v, control[i][1] = v, control[i][2] = 0.0;
  }
  CHECK("none at a point",
        !sg_bezier_patch_normal((const double(*)[3])control, p, n));
  CHECK("one beside it",
        sg_bezier_patch_normal((const double(*)[3])control, q, n) &&
            n[0] == 0.0 && n[1] == 0.0 && n[2] > 0.0);
}

/* ---- points ---- */

static uint32_t seed = 11;

static void
any_patch(double control[16][3])
{
  for (int i = 0; i < 16; i++) {
    control[i][0] = i % 4, control[i][1] = i / 4.0;
    control[i][2] = (check_below(&seed, 2001) - 1000.0) / 700.0;
  }
}

static void
point_at(const double control[16][3], size_t i, size_t j, size_t n,
         double out[3])
{
  double weight[4], row[4][3];

  sg_bezier_weights(j, n, weight);
  sg_bezier_row(control, weight, row);
  sg_bezier_weights(i, n, weight);
  sg_bezier_point((const double(*)[3])row, weight, out);
}

static void
test_points(void)
{
  double control[16][3], p[3], worst = 0.0;

  saddle_init(control, 2.0);
  for (size_t i = 0; i <= 7; i++) {
    for (size_t j = 0; j <= 7; j++) {
      double u = (double)i / 7, v = (double)j / 7;
      point_at((const double(*)[3])control, i, j, 7, p);
      worst = fmax(worst,
                   fabs(p[0] - u) + fabs(p[1] - v) + fabs(p[2] - 2.0 * u * v));
    }
  }
  CHECK("points of a saddle", worst < 1e-14);
}

/* The first row of one patch is a column of another one, the other way. */
static void
test_borders(void)
{
  double a[16][3], b[16][3], p[3], q[3];
  bool same = true;

  for (int times = 0; times < 50; times++) {
    any_patch(a);
    any_patch(b);
    for (int i = 0; i < 4; i++) {
      memcpy(b[4 * (3 - i) + 3], a[i], sizeof a[i]);
    }
    for (size_t n = 1; n < 40; n += 3) {
      for (size_t i = 0; i <= n; i++) {
        point_at((const double(*)[3])a, i, 0, n, p);
        point_at((const double(*)[3])b, n, n - i, n, q);
        same = same && memcmp(p, q, sizeof p) == 0;
      }
    }
  }
  CHECK("a border in two patches", same);
}

/* The middle of a side of a cell, or of its diagonal, is no farther from the
 * surface than the bend says; of n = 1 it comes near. */
static void
test_bend(void)
{
  const double map[3][3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 1}};
  double control[16][3], most = 0.0;
  bool good = true;

  for (int times = 0; times < 200; times++) {
    any_patch(control);
    double bend = sg_bezier_bend((const double(*)[3])control, map);
    for (size_t n = 1; n < 9; n++) {
      for (size_t k = 0; k < n * n; k++) {
        double p[3], q[3], at[3];
        size_t i = k % n, j = k / n;
        point_at((const double(*)[3])control, i, j, n, p);
        point_at((const double(*)[3])control, i + 1, j + 1, n, q);
        point_at((const double(*)[3])control, 2 * i + 1, 2 * j + 1, 2 * n, at);
        double part = fabs((p[2] + q[2]) / 2 - at[2]) * 8.0 * (double)(n * n);
        good = good && part <= bend * (1 + 1e-12);
        most = fmax(most, part / bend);
      }
    }
  }
  CHECK("no farther than the bend", good && most > 0.3);
}

int
main(void)
{
  test_points();
  test_borders();
  test_bend();
  test_saddle();
  test_point_side();
  return check_report();
}
