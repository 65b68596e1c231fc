/* bezier_patch_test.c -- normals of patches whose normals are known. */
#include "picture/bezier_patch.h"
#include "tests/check.h"

#include <math.h>

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

int
main(void)
{
  test_saddle();
  test_point_side();
  return check_report();
}
