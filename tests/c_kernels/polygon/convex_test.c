/* convex_test.c -- hulls, outlines and overlaps: by hand and by chance. */
#include "tests/check.h"

#include "polygon/convex.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

static uint64_t state = 11;

static double
chance(void)
{
  state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
  return (double)(state >> 11) * 0x1p-53;
}

static double
turn(const double a[2], const double b[2], const double c[2])
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* How far a point is outside of a polygon of unit size or so. */
static double
outside(const double (*corner)[2], size_t n, const double p[2])
{
  double most = -INFINITY;

  for (size_t i = 0; i < n; i++) {
    const double *q = corner[i], *r = corner[(i + 1) % n];
    double size = hypot(r[0] - q[0], r[1] - q[1]);
    most = size > 0 ? fmax(most, -turn(q, r, p) / size) : most;
  }
  return most;
}

/* ---- hulls and outlines ------------------------------------------------- */

enum { TIMES = 2000 };

static void
check_hulls(void)
{
  double few[4][2] = {{2, 2}, {0, 0}, {1, 1}, {3, 3}}, out[33][2];
  double one[3][2] = {{5, 7}, {5, 7}, {5, 7}};
  double square[6][2] = {{0, 0}, {1, 1}, {0.5, 0.2}, {1, 0}, {0, 1}, {0.5, 1}};

  CHECK("points in a line have two ends", sg_convex_hull(few, 4, out) == 2);
  CHECK("one point is one", sg_convex_hull(one, 1, out) == 1);
  CHECK("no point is none", sg_convex_hull(one, 0, out) == 0);
  CHECK("a square has four corners",
        sg_convex_hull(square, 6, out) == 4 && out[0][0] == 0);
  CHECK("counter-clockwise", turn(out[0], out[1], out[2]) > 0);
}

static void
check_outlines(void)
{
  size_t few = 0, wrong = 0, none = 0;

  for (int k = 0; k < TIMES; k++) {
    double point[SG_CONVEX_MOST][2], hull[SG_CONVEX_MOST + 1][2];
    double thin = pow(10, -8 * chance());
    for (int i = 0; i < SG_CONVEX_MOST; i++) {
      double at = 7 * chance();
      point[i][0] = cos(at);
      point[i][1] = thin * sin(at);
    }
    size_t n = sg_convex_hull(point, SG_CONVEX_MOST, hull);
    n = sg_convex_outline(hull, n);
    none += n == 0;
    few += n > 0 && n <= SG_CONVEX_CORNERS;
    for (int i = 0; n > 0 && i < SG_CONVEX_MOST; i++) {
      wrong += !(outside((const double(*)[2])hull, n, point[i]) < 1e-12);
    }
  }
  CHECK("outlines have few corners", few + none == TIMES && none < TIMES / 10);
  CHECK("everything lies inside", wrong == 0);
}

static double
area_of(const double (*corner)[2], size_t n)
{
  double sum = 0;

  for (size_t i = 2; i < n; i++) {
    sum += turn(corner[0], corner[i - 1], corner[i]) / 2;
  }
  return sum;
}

/* The outline of a fan of needles ends at its apex, to the last digit. */
static void
check_apex(void)
{
  double point[SG_CONVEX_MOST][2] = {{0.1, 0.7}};
  double hull[SG_CONVEX_MOST + 1][2];
  bool there = false;

  for (int i = 1; i < SG_CONVEX_MOST; i++) {
    point[i][0] = 0.1 + cos(0.02 * i);
    point[i][1] = 0.7 + sin(0.02 * i);
  }
  size_t n = sg_convex_hull(point, SG_CONVEX_MOST, hull);
  CHECK("a fan has many corners", n == SG_CONVEX_MOST);
  double area = area_of((const double(*)[2])hull, n);
  n = sg_convex_outline(hull, n);
  CHECK("its outline is hardly larger",
        area_of((const double(*)[2])hull, n) < 1.01 * area);
  CHECK("its outline has few", n == SG_CONVEX_CORNERS);
  for (size_t i = 0; i < n; i++) {
    there = there || (hull[i][0] == 0.1 && hull[i][1] == 0.7);
  }
  CHECK("its apex stays", there);
}

/* ---- overlap ------------------------------------------------------------ */

static bool
overlap(const double (*a)[2], const double (*b)[2], double depth)
{
  bool there = sg_convex_overlap(a, 3, b, 3, depth);

  CHECK("overlap does not depend on who is asked",
        there == sg_convex_overlap(b, 3, a, 3, depth));
  return there;
}

static void
check_overlaps(void)
{
  const double a[3][2] = {{0, 0}, {1, 0}, {0, 1}};
  const double beside[3][2] = {{1, 0}, {1, 1}, {0, 1}};
  const double at_a_corner[3][2] = {{1, 0}, {2, 0}, {1, 1}};
  const double hair = 1e-9 * sqrt(0.5);
  const double hardly[3][2] = {
      {1 - 0.9 * hair, -0.9 * hair}, {2, 2}, {-0.9 * hair, 1 - 0.9 * hair}};
  const double just[3][2] = {
      {1 - 1.1 * hair, -1.1 * hair}, {2, 2}, {-1.1 * hair, 1 - 1.1 * hair}};
  const double a_little_in[3][2] = {{1 - 1e-10, -1}, {2, 0}, {1, 1}};
  const double in[3][2] = {{0.9, -1}, {2, 0}, {1, 1}};
  const double inside[3][2] = {{0.1, 0.1}, {0.2, 0.1}, {0.1, 0.2}};
  const double sliver[3][2] = {{-1, 0.3}, {2, 0.3}, {2, 0.3 + 1e-13}};
  const double sliver_beside[3][2] = {{-1, -1e-13}, {2, -1e-13}, {2, 0}};

  CHECK("a triangle overlaps itself", overlap(a, a, 1e-9));
  CHECK("beside a common side", !overlap(a, beside, 1e-9));
  CHECK("at a common corner", !overlap(a, at_a_corner, 1e-9));
  CHECK("not deeper than that", !overlap(a, a_little_in, 1e-9));
  CHECK("a hair less", !overlap(a, hardly, 1e-9));
  CHECK("a hair more", overlap(a, just, 1e-9));
  CHECK("deeper", overlap(a, in, 1e-9));
  CHECK("one inside the other", overlap(a, inside, 1e-9));
  CHECK("a sliver across, however thin", overlap(a, sliver, 1e-9));
  CHECK("a sliver beside", !overlap(a, sliver_beside, 1e-9));
}

/* What does not overlap a polygon does not overlap a part of it. */
static void
check_parts(void)
{
  size_t wrong = 0, some = 0;

  for (int k = 0; k < TIMES; k++) {
    double a[3][2], point[6][2], part[4][2], whole[7][2], depth = chance() / 4;
    for (int i = 0; i < 6; i++) {
      for (int c = 0; c < 2; c++) {
        point[i][c] = chance();
        part[i % 3][c] = i < 3 ? point[i][c] : part[i % 3][c];
        a[i % 3][c] = chance() + 0.3;
      }
    }
    if (turn(a[0], a[1], a[2]) < 0 || turn(part[0], part[1], part[2]) < 0) {
      continue;
    }
    size_t n = sg_convex_hull(point, 6, whole);
    bool there = sg_convex_overlap((const double(*)[2])a, 3,
                                   (const double(*)[2])whole, n, depth);
    wrong += !there && sg_convex_overlap((const double(*)[2])a, 3,
                                         (const double(*)[2])part, 3, depth);
    some += !there;
  }
  CHECK("a part overlaps no deeper than the whole", wrong == 0 && some > 50);
}

int
main(void)
{
  check_hulls();
  check_outlines();
  check_apex();
  check_overlaps();
  check_parts();
  return check_report();
}
