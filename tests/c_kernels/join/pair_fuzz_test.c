/* pair_fuzz_test.c -- random pairs of triangles and random polygons, with
 * coordinates from denormals to 1e90 in one triangle: the kernels stay whole,
 * and what two triangles have in common does not depend on which comes first
 * or on the corner that a triangle begins with.
 *
 * An argument is the number of rounds; a failure names its round.
 */
#include "tests/c_kernels/polygon/work_valid.h"
#include "tests/check.h"

#include "join/cut.h"
#include "polygon/triangulate.h"
#include "polygon/work.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static unsigned long long state;

static unsigned
draw(unsigned n)
{
  state ^= state << 13;
  state ^= state >> 7;
  state ^= state << 17;
  return (unsigned)(state >> 33) % n;
}

static double
coordinate(unsigned style)
{
  static const double extreme[] = {0.0,  -0.0,  5e-324, -5e-324, 2e-308,
                                   1e90, -1e90, 1e-300, 1e-90,   1e16,
                                   1.0,  -1.0,  0.1,    3e89,    1e-154};
  double x = (double)draw(5) - 2;

  switch (style) {
  case 0:
    return x;
  case 1:
    return x / 3;
  case 2: /* a unit in the last place off, or not */
    return draw(3) == 0 ? nextafter(x, 9) : x;
  case 3:
    return extreme[draw(sizeof extreme / sizeof *extreme)];
  case 4:
    return ldexp(x, (int)draw(600) - 300);
  default:
    return draw(2) ? x : extreme[draw(sizeof extreme / sizeof *extreme)];
  }
}

static void
draw_triangle(unsigned style, double t[3][3])
{
  for (int i = 0; i < 9; i++) {
    t[i / 3][i % 3] = coordinate(style);
  }
}

typedef const double (*corners)[3];

static bool
same_end(const sg_cut_end *a, const sg_cut_end *b, int swap)
{
  return a->f[0] == b->f[swap] && a->f[1] == b->f[!swap];
}

/* Of a crossing: the same piece, whichever triangle is the first. */
static bool
is_symmetric(corners a, corners b)
{
  sg_cut ab[SG_CUT_MAX], ba[SG_CUT_MAX];
  int n, m;
  sg_cut_kind kind = sg_cut_triangles(a, b, ab, &n);

  if (sg_cut_triangles(b, a, ba, &m) != kind || (n > 0) != (m > 0)) {
    return false;
  }
  return kind != SG_CUT_CROSSING ||
         (same_end(&ab[0].end[0], &ba[0].end[1], 1) &&
          same_end(&ab[0].end[1], &ba[0].end[0], 1));
}

static bool
is_cyclic(corners a, corners b)
{
  double turned[3][3];
  sg_cut out[SG_CUT_MAX];
  int n, m;
  sg_cut_kind kind = sg_cut_triangles(a, b, out, &n);

  for (int i = 0; i < 3; i++) {
    memcpy(turned[i], a[(i + 1) % 3], sizeof turned[i]);
  }
  return sg_cut_triangles((corners)turned, b, out, &m) == kind && n == m;
}

static bool
pair_holds(void)
{
  unsigned style = draw(6);
  double a[3][3], b[3][3];

  draw_triangle(style, a);
  draw_triangle(style, b);
  for (unsigned shared = draw(4); shared > 0; shared--) {
    memcpy(b[draw(3)], a[draw(3)], sizeof b[0]);
  }
  return is_symmetric((corners)a, (corners)b) &&
         is_cyclic((corners)a, (corners)b);
}

/* Any closed walk over a few points, seen along z. */
static bool
polygon_holds(void)
{
  static const double up[3] = {0, 0, 1};
  sg_work *work = sg_work_open(up);
  sg_triangles found = {0};
  int32_t id[12], edge;
  unsigned style = draw(6), points = 3 + draw(5), n = 3 + draw(9);

  for (unsigned v = 0; v < points; v++) {
    double at[3] = {coordinate(style), coordinate(style), 0};
    sg_point point;
    sg_point_set(&point, at);
    sg_work_vertex(work, (int32_t)v + 1, &point);
  }
  for (unsigned i = 0; i < n; i++) {
    id[i] = (int32_t)draw(points);
  }
  for (unsigned i = 0; i < n; i++) {
    if (id[i] != id[(i + 1) % n]) {
      sg_work_add(work, id[i], id[(i + 1) % n], 1, (int32_t)i + 1);
    }
  }
  bool good =
      sg_work_resolve(work, draw(2) ? 0.0 : 1e-9) && work_is_valid(work);
  if (good) {
    sg_outcome outcome = sg_work_triangulate(work, &found, &edge, NULL);
    good = (outcome == SG_DONE || outcome == SG_STUCK) && work_is_valid(work);
  }
  free(found.item);
  sg_work_close(work);
  return good;
}

int
main(int argc, char **argv)
{
  long rounds = argc > 1 ? atol(argv[1]) : 20000;
  long bad = 0;

  for (long i = 0; i < rounds && bad == 0; i++) {
    state = 20261121 + 7919 * (unsigned long long)i;
    draw(2);
    if (!pair_holds()) {
      bad = i + 1;
      fprintf(stderr, "round %ld: a pair\n", i);
    }
    if (!polygon_holds()) {
      bad = i + 1;
      fprintf(stderr, "round %ld: a polygon\n", i);
    }
  }
  CHECK("pairs and polygons hold", bad == 0);
  return check_report();
}
