/* oriented_box_test.c -- boxes along the points in them: they hold the points,
 * what is said to be apart is, what plainly is apart is said to be, and which
 * way triangles run.
 */
#include "join/oriented_box.h"
#include "number/vector.h"
#include "tests/check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 40 };

typedef struct cloud {
  double at[POINTS][3];
  size_t n;
} cloud;

static void
point_of(const void *data, size_t i, double out[3])
{
  const cloud *c = data;

  memcpy(out, c->at[i], sizeof c->at[i]);
}

static sg_oriented_box
box_of(const cloud *c)
{
  sg_oriented_box box;

  sg_oriented_box_make(c->n, point_of, c, &box);
  return box;
}

static double
random_in(double lo, double hi)
{
  return lo + (hi - lo) * (rand() / (double)RAND_MAX);
}

/* A direction of length 1. */
static void
random_way(double out[3])
{
  double size = 0;

  while (!(size > 0.1 && size < 1)) {
    for (int k = 0; k < 3; k++) {
      out[k] = random_in(-1, 1);
    }
    size = sg_length(out);
  }
  for (int k = 0; k < 3; k++) {
    out[k] /= size;
  }
}

/* Points along `way` through `from`, to both ends, no farther than `wide` from
 * that line along each axis. */
static cloud
cloud_along(const double from[3], const double way[3], double along,
            double wide, size_t n)
{
  cloud c = {.n = n};

  for (size_t i = 0; i < n; i++) {
    double t = i == 0 ? -along : i == 1 ? along : random_in(-along, along);
    for (int k = 0; k < 3; k++) {
      c.at[i][k] = from[k] + t * way[k] + random_in(-wide, wide);
    }
  }
  return c;
}

/* ---- one box ---- */

/* How far a point is outside of a box, along the box's axes. */
static double
outside(const sg_oriented_box *box, const double p[3])
{
  double most = -INFINITY;

  for (int k = 0; k < 3; k++) {
    double along = sg_dot(box->axis[k], p), lo = INFINITY, hi = -INFINITY;
    for (int c = 0; c < 8; c++) {
      double x = sg_dot(box->axis[k], box->corner[c]);
      lo = fmin(lo, x);
      hi = fmax(hi, x);
    }
    most = fmax(most, fmax(lo - along, along - hi));
  }
  return most;
}

static double
length_along(const sg_oriented_box *box, int k)
{
  double across[3];

  sg_minus(box->corner[1 << k], box->corner[0], across);
  return sg_length(across);
}

/* Whether the axes are of length 1 and across each other, and every point is in
 * the box, which touches some on all sides. */
static bool
is_box(const cloud *c, const sg_oriented_box *box)
{
  bool good = true;

  for (int k = 0; k < 3; k++) {
    double lo = INFINITY, hi = -INFINITY;
    for (int l = 0; l < 3; l++) {
      good =
          good && fabs(sg_dot(box->axis[k], box->axis[l]) - (k == l)) < 1e-12;
    }
    for (size_t i = 0; i < c->n; i++) {
      lo = fmin(lo, sg_dot(box->axis[k], c->at[i]));
      hi = fmax(hi, sg_dot(box->axis[k], c->at[i]));
    }
    good = good && fabs(length_along(box, k) - (hi - lo)) < 1e-10;
  }
  for (size_t i = 0; i < c->n; i++) {
    good = good && outside(box, c->at[i]) < 1e-10;
  }
  return good;
}

static void
test_boxes(void)
{
  bool good = true, along = true;

  for (int i = 0; i < 2000; i++) {
    double from[3], way[3];
    random_way(way);
    for (int k = 0; k < 3; k++) {
      from[k] = random_in(-50, 50);
    }
    cloud c = cloud_along(from, way, 8, i % 2 ? 0.1 : 3, 2 + (size_t)i % 38);
    sg_oriented_box box = box_of(&c);
    good = good && is_box(&c, &box);
    if (i % 2) {
      along = along && fabs(sg_dot(box.axis[0], way)) > 0.99 &&
              length_along(&box, 1) < 0.5 && length_along(&box, 2) < 0.5;
    }
  }
  CHECK("a box holds its points and no more", good);
  CHECK("its first axis is the longest way", along);
}

/* Points on a grid that is turned: the box is no larger than the grid. */
static void
test_slab(void)
{
  double way[3][3] = {
      {2.0 / 3, -1.0 / 3, 2.0 / 3}, {2.0 / 3, 2.0 / 3, -1.0 / 3}, {0, 0, 0}};
  cloud c = {.n = 0};

  sg_cross(way[0], way[1], way[2]);
  for (int i = 0; i < 8; i++, c.n++) {
    for (int k = 0; k < 3; k++) {
      c.at[c.n][k] = 100 + (i & 1 ? 9 : 0) * way[0][k] +
                     (i & 2 ? 4 : 0) * way[1][k] + (i & 4 ? 1 : 0) * way[2][k];
    }
  }
  sg_oriented_box box = box_of(&c);
  double sides = length_along(&box, 1) + length_along(&box, 2);

  CHECK("along the longest side", fabs(length_along(&box, 0) - 9) < 1e-9);
  CHECK("and the others", fabs(sides - 5) < 1e-9);
}

/* ---- two boxes ---- */

/* The distance of two segments, which are clouds of two points: by the best
 * place on each in turn. */
static double
segments_apart(const cloud *a, const cloud *b)
{
  double s = 0.5, t = 0.5, gap[3];

  for (int i = 0; i < 4000; i++) {
    const cloud *on = i % 2 ? a : b, *to = i % 2 ? b : a;
    double other = i % 2 ? t : s, way[3], from[3], p[3];
    for (int k = 0; k < 3; k++) {
      p[k] = to->at[0][k] + other * (to->at[1][k] - to->at[0][k]);
    }
    sg_minus(on->at[1], on->at[0], way);
    sg_minus(p, on->at[0], from);
    double best = sg_dot(from, way) / sg_dot(way, way);
    best = fmin(fmax(best, 0), 1);
    *(i % 2 ? &s : &t) = best;
    for (int k = 0; k < 3; k++) {
      gap[k] = p[k] - on->at[0][k] - best * way[k];
    }
  }
  return sg_length(gap);
}

/* Segments at random: what is said of them is true, and where no way along or
 * across them parts them nothing is said. */
static void
test_segments(void)
{
  int apart = 0, missed = 0, wrong = 0;

  for (int i = 0; i < 4000; i++) {
    cloud c[2];
    for (int j = 0; j < 2; j++) {
      double from[3], way[3];
      random_way(way);
      for (int k = 0; k < 3; k++) {
        from[k] = random_in(-4, 4);
      }
      c[j] = cloud_along(from, way, 5, 0, 2);
    }
    sg_oriented_box a = box_of(&c[0]), b = box_of(&c[1]);
    double gap = segments_apart(&c[0], &c[1]), reach = random_in(0, 3);
    bool said = sg_oriented_boxes_apart(&a, &b, reach);

    wrong +=
        said != sg_oriented_boxes_apart(&b, &a, reach) || (said && gap < reach);
    apart += said;
    missed += !said && gap > 1.5 * reach + 0.5;
  }
  CHECK("what is said to be apart is", wrong == 0);
  CHECK("much is said", apart > 1500);
  CHECK("little that is far apart is not", missed < 40);
}

/* Two clouds across each other, `gap` apart along what is across both. */
static bool
crossed_apart(const double u[3], const double w[3], double gap, double reach)
{
  double across[3], from[3];

  sg_cross(u, w, across);
  for (int k = 0; k < 3; k++) {
    from[k] = gap * across[k] / sg_length(across);
  }
  cloud a = cloud_along((double[3]){0}, u, 9, 0, 2);
  cloud b = cloud_along(from, w, 9, 0, 2);
  sg_oriented_box x = box_of(&a), y = box_of(&b);

  return sg_oriented_boxes_apart(&x, &y, reach);
}

static void
test_gaps(void)
{
  double u[3] = {0.6, 0.48, 0.64}, w[3] = {0.64, -0.6, 0.48};

  CHECK("apart across both", crossed_apart(u, w, 1.01, 1));
  CHECK("within the reach", !crossed_apart(u, w, 0.99, 1));
  CHECK("apart by little", crossed_apart(u, w, 0x1p-30, 0));
  CHECK("by what may be rounded", !crossed_apart(u, w, 0x1p-42, 0));
  CHECK("through each other", !crossed_apart(u, w, 0, 0));
}

/* Parallel needles, one beyond the other's end or beside it. */
static void
test_parallel(void)
{
  double way[3] = {0.6, 0.48, 0.64}, side[3] = {-0.8, 0.36, 0.48}, at[3];
  cloud a = cloud_along((double[3]){0}, way, 5, 0.001, POINTS);
  sg_oriented_box x = box_of(&a);

  for (int end = 0; end < 2; end++) {
    for (int k = 0; k < 3; k++) {
      at[k] = end ? 10.1 * way[k] : 0.1 * side[k];
    }
    cloud b = cloud_along(at, way, 5, 0.001, POINTS);
    sg_oriented_box y = box_of(&b);
    CHECK("parallel", sg_oriented_boxes_apart(&x, &y, 0.05));
    CHECK("nearer than the reach", !sg_oriented_boxes_apart(&x, &y, 0.2));
  }
}

static void
test_limits(void)
{
  cloud a = {.n = 2}, b = {.n = 2};

  a.at[1][0] = 1;
  b.at[0][1] = b.at[1][1] = 1e150;
  b.at[1][0] = 1;
  sg_oriented_box x = box_of(&a), y = box_of(&b);
  CHECK("so far away that nothing is said",
        !sg_oriented_boxes_apart(&x, &y, 1));
  CHECK("nor for such a reach", !sg_oriented_boxes_apart(&x, &x, INFINITY));
  b.at[0][1] = b.at[1][1] = 0;
  b.at[0][2] = b.at[1][2] = 1e150;
  y = box_of(&b);
  CHECK("along any axis", !sg_oriented_boxes_apart(&x, &y, 1));
  b.at[0][2] = b.at[1][2] = 0;
  b.at[0][1] = b.at[1][1] = 1e90;
  y = box_of(&b);
  CHECK("far, but not so far", sg_oriented_boxes_apart(&x, &y, 1));
  y.corner[3][2] = NAN;
  CHECK("not a number", !sg_oriented_boxes_apart(&x, &y, 1));
  b = (cloud){.at = {{7, 7, 7}, {7, 7, 7}}, .n = 2};
  y = box_of(&b);
  CHECK("one point", is_box(&b, &y));
  CHECK("is apart too", sg_oriented_boxes_apart(&x, &y, 1));
}

/* ---- which way triangles run ---- */

/* N triangles along a way that is `tilt` degrees off the x-axis, towards what
 * is off all three; each as wide as told, beside its length. */
static sg_run
run_of(double tilt, double wide, size_t n)
{
  double c = cos(tilt * 3.14159265358979 / 180), s = sqrt((1 - c * c) / 2);
  double way[3] = {c, s, s}, side[3] = {0, 1 / sqrt(2), -1 / sqrt(2)};
  sg_run run = {.askew = false};

  for (size_t i = 0; i < n; i++) {
    double t[3][3];
    for (int k = 0; k < 3; k++) {
      t[0][k] = random_in(-9, 9);
      t[1][k] = t[0][k] + way[k] - wide / 2 * side[k];
      t[2][k] = t[0][k] + way[k] + wide / 2 * side[k];
    }
    sg_run_add(&run, (const double(*)[3])t);
  }
  sg_run_end(&run);
  return run;
}

static void
test_run(void)
{
  sg_run run = run_of(40, 0.01, 20);
  double p[3] = {3, -5, 7}, q[3] = {-4, 1, 2}, a[3], b[3], before[3], after[3];

  CHECK("needles askew", run.askew);
  CHECK("along them",
        fabs(fabs(run.axis[0][0]) - cos(40 * 3.14159265358979 / 180)) < 1e-4);
  sg_run_turn(&run, p, a);
  sg_run_turn(&run, q, b);
  sg_minus(p, q, before);
  sg_minus(a, b, after);
  CHECK("turned, not stretched",
        fabs(sg_length(before) - sg_length(after)) < 1e-12);
  CHECK("and turned indeed", fabs(a[0] - sg_dot(run.axis[0], p)) < 1e-12 &&
                                 fabs(a[1] - sg_dot(run.axis[1], p)) < 1e-12 &&
                                 fabs(a[2] - sg_dot(run.axis[2], p)) < 1e-12);
  run = run_of(0, 0.01, 20);
  sg_run_turn(&run, p, a);
  CHECK("along an axis", !run.askew && memcmp(a, p, sizeof a) == 0);
  /* sin^2 of the tilt is 1/256 at 3.58 degrees */
  CHECK("nearly along an axis", !run_of(3.4, 0.01, 20).askew);
  CHECK("not so nearly", run_of(3.8, 0.01, 20).askew);
  /* across is 1.5 w^2, all 2 + 1.5 w^2: a 64th at w = 0.145 */
  CHECK("long enough", run_of(40, 0.14, 20).askew);
  CHECK("not long enough", !run_of(40, 0.15, 20).askew);
  CHECK("every way", !run_of(40, 2, 20).askew);
  run = (sg_run){.askew = false};
  sg_run_end(&run);
  CHECK("nothing runs no way", !run.askew);
  sg_run_add(&run, (const double[3][3]){{0}, {1e150, 1e150, 0}, {0}});
  sg_run_end(&run);
  CHECK("nor what is too large", !run.askew);
}

int
main(void)
{
  srand(1988);
  test_boxes();
  test_slab();
  test_segments();
  test_gaps();
  test_parallel();
  test_limits();
  test_run();
  return check_report();
}
