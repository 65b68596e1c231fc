/* bezier_grid_test.c -- points of a patch, exact and rounded once.
 *
 * covers: bezier_grid_rows
 */
#include "doors/world.h"
#include "model/bezier_grid.h"
#include "tests/c_kernels/door_call.h"
#include "tests/check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static uint32_t seed = 3;

static void
any_patch(double control[16][3])
{
  for (int i = 0; i < 48; i++) {
    control[i / 3][i % 3] =
        (check_below(&seed, 20001) - 10000) / 7.0 * check_below(&seed, 3);
  }
}

/* A border the other way, as a column of another patch, is the same. */
static void
test_borders(void)
{
  double a[16][3], b[16][3], p[12 * 12][3], q[12 * 12][3];
  bool turned[11 * 11], same = true;

  for (int times = 0; times < 100; times++) {
    any_patch(a);
    any_patch(b);
    for (int i = 0; i < 4; i++) {
      memcpy(b[4 * (3 - i) + 3], a[i], sizeof a[i]);
    }
    for (size_t n = 1; n < 12; n++) {
      if (!sg_bezier_grid((const double(*)[3])a, n, p, turned) ||
          !sg_bezier_grid((const double(*)[3])b, n, q, turned)) {
        abort();
      }
      for (size_t i = 0; i <= n; i++) {
        same = same && memcmp(p[i], q[(n - i) * (n + 1) + n], sizeof p[i]) == 0;
      }
    }
  }
  CHECK("a border in two patches", same);
}

/* A patch that is flat and even, a power of two of cells: points are doubles,
 * and diagonals equal. Of one whose corner is far away they are not. */
static void
test_even(void)
{
  double control[16][3], at[17 * 17][3];
  bool turned[16 * 16], exact = true, any = false;

  for (int i = 0; i < 16; i++) {
    control[i][0] = 3 * (i % 4), control[i][1] = 3 * (i / 4);
    control[i][2] = 0.0;
  }
  CHECK("a grid", sg_bezier_grid((const double(*)[3])control, 16, at, turned));
  for (size_t k = 0; k < 17 * 17; k++) {
    exact = exact && at[k][0] == (double)(k % 17) * 9 / 16 &&
            at[k][1] == (double)(k / 17) * 9 / 16 && at[k][2] == 0.0 &&
            !signbit(at[k][2]);
  }
  CHECK("its points", exact);
  for (size_t k = 0; k < 16 * 16; k++) {
    any = any || turned[k];
  }
  CHECK("its diagonals", !any);
  control[15][0] += 5.0;
  CHECK("another grid",
        sg_bezier_grid((const double(*)[3])control, 2, at, turned) &&
            turned[3]);
}

/* What cancels is 0, or as small as it is; the largest is as large. */
static void
test_sizes(void)
{
  double control[16][3] = {{0}}, at[4][3];
  double most[16][3], mid[9][3];
  bool turned[4], held = true;

  for (int i = 0; i < 16; i++) {
    control[i][0] = (i % 4 < 2 ? 1 : -1) * (i % 4 % 3 == 0 ? 3e300 : 1e300);
    control[i][1] = 4.9e-324;
    memcpy(most[i], control[i], sizeof most[i]);
    most[i][2] = 1.7e308;
  }
  held = sg_bezier_grid((const double(*)[3])most, 2, mid, turned);
  CHECK("it cancels", held && mid[4][0] == 0.0 && mid[4][1] == 4.9e-324);
  CHECK("the largest", mid[4][2] == 1.7e308);
  CHECK("its corners",
        sg_bezier_grid((const double(*)[3])control, 1, at, turned) &&
            memcmp(at[3], control[15], sizeof at[3]) == 0);
}

/* The same through its door, which refuses what it cannot do. */
static void
test_door(void)
{
  double number[48], at[3 * 3][3];
  bool turned[2 * 2], same = true;
  sg_number_list controls = {.at = number, .n = 48, .room = 48};
  sg_space_point_list points = {0};
  sg_int_list is = {0};

  sg_call_open(&call, NULL, NULL);
  for (int i = 0; i < 48; i++) {
    number[i] = check_below(&seed, 1000) / 3.0;
  }
  CHECK("the kernel and its door",
        sg_bezier_grid((const double(*)[3])number, 2, at, turned) &&
            sg_door_bezier_grid(&call, &controls, 2, &points, &is));
  CHECK("as many", points.n == 9 && is.n == 4);
  for (size_t i = 0; i < points.n; i++) {
    same = same && points.at[i].x == at[i][0] && points.at[i].y == at[i][1] &&
           points.at[i].z == at[i][2];
  }
  for (size_t i = 0; i < is.n; i++) {
    same = same && is.at[i] == turned[i];
  }
  CHECK("the same", same);
  CHECK("no facets", !sg_door_bezier_grid(&call, &controls, 0, &points, &is) &&
                         is_domain("facets", 2));
  CHECK("too many", !sg_door_bezier_grid(&call, &controls, SG_BEZIER_MOST + 1,
                                         &points, &is) &&
                        is_domain("facets", 2));
  number[47] = INFINITY;
  CHECK("no patch", !sg_door_bezier_grid(&call, &controls, 2, &points, &is) &&
                        is_domain("patch", 1));
  controls.n = 47;
  CHECK("not all", !sg_door_bezier_grid(&call, &controls, 2, &points, &is) &&
                       is_domain("patch", 1));
  sg_call_close(&call);
}

int
main(void)
{
  test_borders();
  test_even();
  test_sizes();
  test_door();
  return check_report();
}
