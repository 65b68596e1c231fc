/* self_shape_test.c -- triangles in one plane: how far they overlap.
 *
 * Random triangles on a grid of whole numbers: what one cuts off the other is
 * found by clipping, exactly. They overlap if that has an area; one then has to
 * move by no less than was said, in whatever direction.
 */
#include "join/self_shape.h"
#include "tests/check.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

typedef struct polygon {
  int n;
  double at[12][2];
} polygon;

static double
turn(const double a[2], const double b[2], const double c[2])
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* Counter-clockwise, of some area. */
static void
random_triangle(uint32_t *seed, double out[3][3])
{
  do {
    for (int i = 0; i < 3; i++) {
      out[i][0] = check_below(seed, 9);
      out[i][1] = check_below(seed, 9);
      out[i][2] = 0;
    }
  } while (turn(out[0], out[1], out[2]) <= 0);
}

/* What of a polygon is to the left of a-b. */
static void
clip(polygon *p, const double a[2], const double b[2])
{
  polygon out = {0};

  for (int i = 0; i < p->n; i++) {
    const double *u = p->at[i], *w = p->at[(i + 1) % p->n];
    double x = turn(a, b, u), y = turn(a, b, w);
    if (x >= 0) {
      memcpy(out.at[out.n++], u, sizeof *out.at);
    }
    if ((x > 0 && y < 0) || (x < 0 && y > 0)) {
      for (int c = 0; c < 2; c++) {
        out.at[out.n][c] = u[c] + (w[c] - u[c]) * (x / (x - y));
      }
      out.n++;
    }
  }
  *p = out;
}

static double
common_area(const double a[3][3], const double b[3][3], const double by[2])
{
  polygon p = {.n = 3};
  double area = 0;

  for (int i = 0; i < 3; i++) {
    p.at[i][0] = b[i][0] + by[0];
    p.at[i][1] = b[i][1] + by[1];
  }
  for (int i = 0; i < 3; i++) {
    clip(&p, a[i], a[(i + 1) % 3]);
  }
  for (int i = 1; i + 1 < p.n; i++) {
    area += turn(p.at[0], p.at[i], p.at[i + 1]) / 2;
  }
  return area;
}

/* Whether b is free of a when it has moved so far in one of many directions. */
static bool
comes_free(const double a[3][3], const double b[3][3], double way)
{
  enum { DIRECTIONS = 720 };

  for (int i = 0; i < DIRECTIONS; i++) {
    double angle = 2 * 3.14159265358979 * i / DIRECTIONS;
    double by[2] = {way * cos(angle), way * sin(angle)};
    if (common_area(a, b, by) < 1e-9) {
      return true;
    }
  }
  return false;
}

/* How far a triangle is before and behind the plane of another one, which is
 * along an axis, any way round: as its corners say. */
static void
depths(void)
{
  uint32_t seed = 11;
  size_t wrong = 0;

  for (int i = 0; i < 1000; i++) {
    double a[3][3], b[3][3], flat[3][3], above = 0, below = 0;
    int axis = i % 3, at = check_below(&seed, 9);

    random_triangle(&seed, flat);
    for (int k = 0; k < 3; k++) {
      b[k][axis] = at / 8.0;
      b[k][(axis + 1) % 3] = flat[k][0];
      b[k][(axis + 2) % 3] = flat[k][1];
      for (int c = 0; c < 3; c++) {
        a[k][c] = check_below(&seed, 17) / 8.0 - 0.5;
      }
      above = fmax(above, a[k][axis] - b[0][axis]);
      below = fmax(below, b[0][axis] - a[k][axis]);
    }
    sg_depth depth =
        sg_shape_depth((const double(*)[3])a, (const double(*)[3])b);

    wrong +=
        fabs(depth.above - above) > 1e-12 || fabs(depth.below - below) > 1e-12;
  }
  CHECK("before and behind a plane", wrong == 0);
}

int
main(void)
{
  enum { PAIRS = 1000 };
  uint32_t seed = 7;
  size_t wrong = 0, apart = 0, less = 0, more = 0;

  for (int i = 0; i < PAIRS; i++) {
    double a[3][3], b[3][3];

    random_triangle(&seed, a);
    random_triangle(&seed, b);
    const double(*x)[3] = (const double(*)[3])a;
    const double(*y)[3] = (const double(*)[3])b;
    double overlap = sg_shape_overlap(x, y);
    bool common = common_area(x, y, (double[2]){0, 0}) > 1e-9;
    wrong += (overlap > 1e-12) != common;
    wrong += fabs(overlap - sg_shape_overlap(y, x)) > 1e-12;
    apart += !common;
    less += common && comes_free(x, y, 0.99 * overlap);
    more += common && !comes_free(x, y, 1.01 * overlap + 1e-3);
  }
  CHECK("those overlap that have an area in common", wrong == 0);
  CHECK("both were tried", apart > PAIRS / 10 && apart < PAIRS * 9 / 10);
  CHECK("less does not part them", less == 0);
  CHECK("so much does", more == 0);
  depths();
  return check_report();
}
