/* quadric_test.c -- squared distances from planes, and where they are least. */
#include "tests/check.h"

#include "model/quadric.h"

#include <math.h>

int
main(void)
{
  const double x[3] = {1, 0, 0}, y[3] = {0, 1, 0}, z[3] = {0, 0, 1};
  const double p[3] = {1, 2, 3}, o[3] = {0, 0, 0}, q[3] = {4, 6, 3};
  sg_quadric one = {{0}, 2}, all = {{0}, 1};
  double at[3];

  sg_quadric_add_plane(&one, x, p, 2);
  CHECK("one plane",
        sg_quadric_value(&one, q) == 2 * 9 && sg_quadric_value(&one, p) == 0);
  sg_quadric_least(&one, o, at);
  CHECK("on the plane, beside the point",
        fabs(at[0] - 1) < 2e-3 && at[1] == 0 && at[2] == 0);
  sg_quadric_add_plane(&all, y, p, 1);
  sg_quadric_add_plane(&all, z, p, 1);
  sg_quadric_add(&all, &one);
  CHECK("three planes",
        sg_quadric_value(&all, q) == 2 * 9 + 16 && all.area == 3);
  sg_quadric_least(&all, p, at);
  CHECK("where they meet", fabs(at[0] - 1) < 1e-12 && fabs(at[1] - 2) < 1e-12 &&
                               fabs(at[2] - 3) < 1e-12);
  return check_report();
}
