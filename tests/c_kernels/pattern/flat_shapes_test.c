/* flat_shapes_test.c -- depths by hand; an index against looking at all. */
#include "tests/check.h"

#include "pattern/flat_shapes.h"

#include <math.h>

static uint64_t seed = 7;

static double
random_below(double most)
{
  seed = seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
  return most * (double)(seed >> 33) / 2147483648.0;
}

static sg_flat_shape
box(double x0, double y0, double x1, double y1)
{
  return (sg_flat_shape){4, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

static sg_flat_shape
line(double x0, double y0, double x1, double y1)
{
  return (sg_flat_shape){2, {{x0, y0}, {x1, y1}}};
}

static void
check_depths(void)
{
  sg_flat_shape a = box(0, 0, 10, 10), b = box(9, 3, 20, 4);
  sg_flat_shape beside = box(10, 0, 20, 10), far = box(30, 0, 40, 10);
  sg_flat_shape across = line(-5, 5, 15, 5), along = line(0, -3, 0, 13);
  sg_flat_shape inner = line(4, 5, 6, 5);

  CHECK("a corner", sg_flat_shape_depth(&a, &b) == 1.0);
  CHECK("side by side", sg_flat_shape_depth(&a, &beside) == 0.0);
  CHECK("apart", sg_flat_shape_depth(&a, &far) == -20.0);
  CHECK("a line through", sg_flat_shape_depth(&a, &across) == 5.0);
  CHECK("a line along", sg_flat_shape_depth(&a, &along) == 0.0);
  CHECK("a line inside", sg_flat_shape_depth(&inner, &a) == 5.0);
  CHECK("lines that cross", sg_flat_shape_depth(&across, &along) > 0.0);
}

static void
check_validity(void)
{
  sg_flat_shape a = box(0, 0, 1, 1);

  CHECK("a box", sg_flat_shape_is_valid(&a, 1.0));
  a.at[2][0] = NAN;
  CHECK("no number", !sg_flat_shape_is_valid(&a, 1.0));
  a.at[2][0] = 1e12;
  CHECK("too far", !sg_flat_shape_is_valid(&a, 1.0));
  a = line(0, 0, 1, 1);
  a.corners = 1;
  CHECK("a point", !sg_flat_shape_is_valid(&a, 1.0));
}

static sg_flat_shape
random_shape(void)
{
  double x = random_below(100) - 50, y = random_below(100) - 50;

  if (random_below(1) < 0.3) {
    return line(x, y, x + random_below(30) - 15, y + random_below(30) - 15);
  }
  return (sg_flat_shape){3,
                         {{x, y},
                          {x + random_below(8), y + random_below(3)},
                          {x + random_below(3), y + random_below(8)}}};
}

static void
check_many(double size)
{
  enum { MANY = 300 };
  sg_flat_shape all[MANY];
  sg_flat_shapes shapes;
  unsigned wrong = 0;

  sg_flat_shapes_init(&shapes, size);
  for (unsigned i = 0; i < MANY; i++) {
    bool alone = true;

    all[i] = random_shape();
    for (unsigned k = 0; k < i; k++) {
      alone = alone && !(sg_flat_shape_depth(&all[i], &all[k]) > 0.1);
    }
    wrong += sg_flat_shapes_free(&shapes, &all[i], 0.1) != alone;
    wrong += !sg_flat_shapes_add(&shapes, &all[i]);
  }
  CHECK("what is in the way is what looking at all finds", wrong == 0);
  sg_flat_shapes_clear(&shapes);
}

int
main(void)
{
  check_depths();
  check_validity();
  check_many(0.7);
  check_many(5.0);
  check_many(60.0);
  return check_report();
}
