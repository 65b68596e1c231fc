/* plane_test.c -- normals from whole loops, and what counts as flat. */
#include "polygon/flatness.h"
#include "polygon/plane.h"
#include "tests/check.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

typedef const double place[3];

static bool
plane_of(place *loop, size_t n, sg_plane *out, double *area)
{
  sg_newell sum;

  sg_newell_init(&sum);
  for (size_t i = 0; i < n; i++) {
    sg_newell_edge(&sum, loop[i], loop[(i + 1) % n]);
  }
  *area = sg_newell_area(&sum);
  return sg_newell_plane(&sum, out);
}

static bool
is_plane(const sg_plane *plane, double a, double b, double c, double d)
{
  return plane->n[0] == a && plane->n[1] == b && plane->n[2] == c &&
         plane->d == d && !signbit(plane->n[0]) && !signbit(plane->n[1]);
}

static void
test_normals(void)
{
  static place square[] = {{0, 0, 2}, {4, 0, 2}, {4, 4, 2}, {0, 4, 2}};
  static place reflex[] = {{2, 2, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  static place straight[] = {
      {0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  static place line[] = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  static place huge[] = {{0, 0, 0}, {1e150, 0, 0}, {0, 1e150, 0}};
  static place tiny[] = {{0, 0, 0}, {1e-150, 0, 0}, {0, 1e-150, 0}};
  sg_plane plane;
  double area;

  CHECK("a square", plane_of(square, 4, &plane, &area) && area == 16);
  CHECK("its plane", is_plane(&plane, 0, 0, 1, -2));
  CHECK("a reflex start",
        plane_of(reflex, 4, &plane, &area) && plane.n[2] == 1);
  CHECK("a straight start",
        plane_of(straight, 5, &plane, &area) && plane.n[2] == 1 && area == 16);
  CHECK("no area", !plane_of(line, 3, &plane, &area) && area == 0);
  CHECK("huge", plane_of(huge, 3, &plane, &area) && plane.n[2] == 1);
  CHECK("tiny", plane_of(tiny, 3, &plane, &area) && plane.n[2] == 1);
}

/* Beyond the doubles there is no plane; the area says so. */
static void
test_out_of_range(void)
{
  static place wide[] = {{0, 0, 0}, {1e200, 0, 0}, {0, 1e200, 0}};
  static place slanted[] = {{0, 0, 0}, {1e200, 1e200, 0}, {0, 1, 1e200}};
  static place most[] = {{0, 0, 0}, {1.3e154, 0, 0}, {0, 1.3e154, 1.3e154}};
  static place small[] = {{0, 0, 0}, {1e-200, 0, 0}, {0, 1e-200, 0}};
  static place far[] = {{1e15, 1, 0}, {1e15, 2, 0}, {1e15, 1, 1}};
  sg_newell none;
  sg_plane plane;
  double area;

  CHECK("an area beyond the doubles",
        !plane_of(wide, 3, &plane, &area) && isinf(area));
  CHECK("in several components",
        !plane_of(slanted, 3, &plane, &area) && !isfinite(area));
  CHECK("components that fit, a length that does not",
        !plane_of(most, 3, &plane, &area) && isinf(area));
  CHECK("an area below the doubles",
        !plane_of(small, 3, &plane, &area) && area == 0);
  CHECK("small and far: its own normal", plane_of(far, 3, &plane, &area) &&
                                             area == 0.5 &&
                                             is_plane(&plane, 1, 0, 0, -1e15));
  sg_newell_init(&none);
  CHECK("no edges", !sg_newell_plane(&none, &plane));
  CHECK("no edges, no area", sg_newell_area(&none) == 0);
}

static void
test_edges_in_any_order(void)
{
  static place outer[] = {{0, 0, 0}, {0, 9, 0}, {0, 9, 9}, {0, 0, 9}};
  static place hole[] = {{0, 3, 3}, {0, 3, 6}, {0, 6, 6}, {0, 6, 3}};
  sg_newell sum;
  sg_plane plane;

  sg_newell_init(&sum);
  for (size_t i = 0; i < 4; i++) {
    sg_newell_edge(&sum, hole[(i + 1) % 4], hole[i]);
    sg_newell_edge(&sum, hole[i], hole[(i + 1) % 4]); /* a seam, too */
    sg_newell_edge(&sum, hole[i], hole[(i + 1) % 4]);
    sg_newell_edge(&sum, outer[i], outer[(i + 1) % 4]);
  }
  CHECK("a hole counts negative", sg_newell_area(&sum) == 81 - 9);
  CHECK("outward", sg_newell_plane(&sum, &plane) && plane.n[0] == 1);
  CHECK("in front is positive",
        sg_plane_distance(&plane, (const double[3]){2, 0, 0}) == 2);
}

static sg_flatness
seen(place *points, size_t n, double grain)
{
  enum { ROWS = 8 };
  double x[ROWS] = {0}, y[ROWS] = {0}, z[ROWS] = {0};
  uint64_t live[SG_LIVE_WORDS] = {0};
  const uint64_t *pages[1] = {live};
  sg_cells cells[3] = {{.f = x}, {.f = y}, {.f = z}};
  sg_view view = {.pages = 1, .live = pages};
  sg_flatness flatness;

  for (size_t i = 0; i < n; i++) {
    x[i] = points[i][0];
    y[i] = points[i][1];
    z[i] = points[i][2];
    live[0] |= (uint64_t)1 << i;
  }
  for (int k = 0; k < 3; k++) {
    view.column[2 + k].page = &cells[k];
  }
  sg_flatness_init(&flatness, grain);
  sg_flatness_page(&flatness, &view, 0);
  return flatness;
}

/* What the numbers look like does not matter: where they come from does. */
static void
test_tolerance(void)
{
  static place near[] = {{0, 0, 0}, {8, 1.4142135623730951, 3.14}};
  static place single[] = {{0, 0, 0}, {8, 0.1f, 0.7f}};
  static place far[] = {{-1000001, 0, 0}, {-1000000.5, 0.25, 0}};
  static place odd[] = {{0, 0, 0}, {0, 9, 0}};
  sg_flatness a = seen(near, 2, 0), b = seen(single, 2, 0);
  sg_flatness c = seen(far, 2, 0), d = seen(odd, 2, 0x1p-20);

  CHECK("doubles: 256 units in the last place",
        sg_flatness_touch(&a) == ldexp(8, -44) &&
            sg_flatness_touch(&b) == ldexp(8, -44));
  CHECK("of the farthest, upwards to a power of two",
        sg_flatness_touch(&c) == ldexp(1, 20 - 44));
  CHECK("rounded: less than a unit", sg_flatness_touch(&d) == 0x1.cp-21);
  CHECK("flat: of the size", sg_flatness_flat(&a) == ldexp(8, -33));
  CHECK("or two units", sg_flatness_flat(&d) == 0x1p-19);
  CHECK("never less than what touches",
        sg_flatness_flat(&c) == ldexp(1, 20 - 44));
  CHECK("size", sg_flatness_size(&c) == 0.5);
  sg_flatness_join(&a, &c);
  sg_flatness_join(&a, &d);
  CHECK("joined", sg_flatness_size(&a) == 1000009 && a.grain == 0x1p-20 &&
                      a.largest == 1000001);
  CHECK("float32", sg_flatness_single(8) == 0x1p-20 &&
                       sg_flatness_single(7.9) == 0x1p-21 &&
                       sg_flatness_single(0) == 0);
}

/* Numbers of few bits, so that some vanish, and of many. */
static double
any_number(uint64_t *state)
{
  *state = *state * 6364136223846793005u + 1442695040888963407u;
  int64_t n = (int64_t)(*state >> 33) - (INT64_C(1) << 30);

  return *state >> 20 & 1 ? (double)(n % 4) : ldexp((double)n, -25);
}

static void
test_triangles(void)
{
  uint64_t state = 1;
  size_t same = 0;

  for (int i = 0; i < 10000; i++) {
    double at[3][3], area;
    sg_plane edges = {{0}, 0}, whole = {{0}, 0};
    sg_newell sum;

    for (int k = 0; k < 9; k++) {
      at[k / 3][k % 3] = any_number(&state);
    }
    sg_newell_init(&sum);
    sg_newell_triangle(&sum, at[0], at[1], at[2]);
    bool is = plane_of((place *)at, 3, &edges, &area);
    same += sg_newell_plane(&sum, &whole) == is &&
            sg_newell_area(&sum) == area &&
            memcmp(&edges, &whole, sizeof edges) == 0;
  }
  CHECK("a triangle at once: bit for bit what its edges give", same == 10000);
}

int
main(void)
{
  test_normals();
  test_out_of_range();
  test_edges_in_any_order();
  test_tolerance();
  test_triangles();
  return check_report();
}
