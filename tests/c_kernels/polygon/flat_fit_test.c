/* flat_fit_test.c -- the smallest box round points: by hand, and by looking in
 * all directions. */
#include "tests/check.h"

#include "polygon/flat_fit.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

enum { MOST = 500, WAYS = 20000 };

static double room[MOST + 1][2];

static uint64_t state = 3;

static double
chance(void)
{
  state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
  return (double)(state >> 11) * 0x1p-53;
}

/* The sides of the box along a direction: the product, and which is longer. */
static double
area(const double (*p)[2], size_t n, double x, double y, bool *along)
{
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};

  for (size_t i = 0; i < n; i++) {
    const double at[2] = {p[i][0] * x + p[i][1] * y, p[i][1] * x - p[i][0] * y};
    for (int k = 0; k < 2; k++) {
      low[k] = fmin(low[k], at[k]);
      high[k] = fmax(high[k], at[k]);
    }
  }
  *along = high[0] - low[0] >= high[1] - low[1];
  return (high[0] - low[0]) * (high[1] - low[1]);
}

static double
least_area(const double (*p)[2], size_t n)
{
  double least = INFINITY;
  bool along;

  for (int k = 0; k < WAYS; k++) {
    double angle = acos(-1.0) * k / WAYS;
    least = fmin(least, area(p, n, cos(angle), sin(angle), &along));
  }
  return least;
}

static void
check_points(double (*p)[2], size_t n)
{
  double least = least_area((const double(*)[2])p, n);
  bool stopped;
  sg_flat_fit fit = sg_flat_fit_find(p, n, room, NULL, &stopped);
  bool along;
  double found = area((const double(*)[2])p, n, fit.x, fit.y, &along);

  CHECK("no box is smaller", found <= least * (1 + 1e-9));
  CHECK("its longer side runs that way", along);
  CHECK("a unit", fabs(fit.x * fit.x + fit.y * fit.y - 1) < 1e-15);
}

static void
check_none(const char *name, double (*p)[2], size_t n)
{
  bool stopped;
  sg_flat_fit fit = sg_flat_fit_find(p, n, room, NULL, &stopped);

  CHECK(name, fit.x == 1 && fit.y == 0);
}

int
main(void)
{
  double p[MOST][2];

  check_points((double[4][2]){{0, 0}, {2, 2}, {1, 3}, {-1, 1}}, 4);
  check_none("one point", (double[1][2]){{1, 1}}, 1);
  check_none("points in one place", (double[3][2]){{1, 1}, {1, 1}, {1, 1}}, 3);
  check_none("points in a line", (double[3][2]){{0, 0}, {1, 1}, {2, 2}}, 3);
  for (int round = 0; round < 40; round++) {
    size_t n = 3 + (size_t)(chance() * (MOST - 3));
    double flat = pow(10, -2 * chance()), turn = 6 * chance();
    for (size_t i = 0; i < n; i++) {
      double x = chance(), y = flat * chance();
      memcpy(p[i],
             (double[2]){cos(turn) * x - sin(turn) * y,
                         sin(turn) * x + cos(turn) * y},
             sizeof p[i]);
    }
    check_points(p, n);
  }
  return check_report();
}
