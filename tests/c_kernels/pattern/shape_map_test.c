/* shape_map_test.c -- an index against looking at all shapes; near misses. */
#include "tests/check.h"

#include "pattern/shape_map.h"

enum { MANY = 500, POINTS = 4000 };

static uint64_t seed = 5;

static double
random_below(double most)
{
  seed = seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
  return most * (double)(seed >> 33) / 2147483648.0;
}

static bool
is_left(const double a[2], const double b[2], const double p[2])
{
  return (b[0] - a[0]) * (p[1] - a[1]) >= (b[1] - a[1]) * (p[0] - a[0]);
}

static void
check_random(void)
{
  static double at[3 * MANY][2];
  static size_t end[MANY];
  unsigned wrong = 0, found = 0;
  sg_shape_map map;

  for (size_t i = 0; i < MANY; i++) {
    double x = random_below(100), y = random_below(100);
    double(*p)[2] = &at[3 * i];

    p[0][0] = x;
    p[0][1] = y;
    p[1][0] = x + 1 + random_below(8);
    p[1][1] = y + random_below(1);
    p[2][0] = x + random_below(5);
    p[2][1] = y + 2 + random_below(5);
    end[i] = 3 * i + 3;
  }
  CHECK("map",
        sg_shape_map_make((const double(*)[2])at, end, MANY, 1e-6, &map));
  for (unsigned k = 0; k < POINTS; k++) {
    const double point[2] = {random_below(110), random_below(110)};
    uint32_t first = SG_NO_ITEM;

    for (uint32_t i = MANY; i-- > 0;) {
      const double(*p)[2] = (const double(*)[2]) & at[3 * i];

      if (is_left(p[0], p[1], point) && is_left(p[1], p[2], point) &&
          is_left(p[2], p[0], point)) {
        first = i;
      }
    }
    wrong += sg_shape_map_at(&map, point) != first;
    found += first != SG_NO_ITEM;
  }
  CHECK("the first that has it", wrong == 0);
  CHECK("some, not all", found > POINTS / 4 && found < POINTS);
  sg_shape_map_clear(&map);
}

static void
check_near(void)
{
  const double square[4][2] = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  const size_t end = 4;
  sg_shape_map map;

  CHECK("map", sg_shape_map_make(square, &end, 1, 1e-6, &map));
  CHECK("on the border", sg_shape_map_at(&map, (double[2]){10, 5}) == 0);
  CHECK("as good as", sg_shape_map_at(&map, (double[2]){10 + 5e-6, 5}) == 0);
  CHECK("beside",
        sg_shape_map_at(&map, (double[2]){10 + 2e-5, 5}) == SG_NO_ITEM);
  sg_shape_map_clear(&map);
  CHECK("none", sg_shape_map_make(square, &end, 0, 1e-6, &map));
  CHECK("nothing there",
        sg_shape_map_at(&map, (double[2]){5, 5}) == SG_NO_ITEM);
  sg_shape_map_clear(&map);
}

int
main(void)
{
  check_random();
  check_near();
  return check_report();
}
