/* apart_test.c -- triangles that are said to be apart have no cut, no contact,
 * and all corners on one side, exactly; and those far away are said to be. */
#include "join/apart.h"
#include "join/contact.h"
#include "join/cut.h"
#include "number/exact.h"
#include "tests/check.h"

#include <math.h>

enum { PAIRS = 200000 };

static const double flat[3][3] = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

/* Whether `other` is said to be apart by the plane of `of`. */
static bool
said(const double of[3][3], double reach, const double other[3][3])
{
  sg_apart apart;

  sg_apart_make(of, reach, &apart);
  return sg_apart_by_plane(
      &apart, (const double *const[3]){other[0], other[1], other[2]});
}

static bool
at_heights(double reach, double a, double b, double c)
{
  return said(flat, reach,
              (const double[3][3]){{0, 1, a}, {2, -9, b}, {9, 9, c}});
}

static void
test_heights(void)
{
  CHECK("above", at_heights(0, 1, 2, 3));
  CHECK("below", at_heights(0, -1, -2, -3));
  CHECK("one on the plane", !at_heights(0, 1, 2, 0));
  CHECK("on both sides", !at_heights(0, 1, 2, -3));
  CHECK("as small as doubles go", !at_heights(0, 1, 2, 1e-300));
  CHECK("farther than four reaches", at_heights(0.125, 0.51, 2, 3));
  CHECK("not so far", !at_heights(0.125, 0.49, 2, 3));
  CHECK("far away", !at_heights(0, 1e308, 1e308, 1e308));
  CHECK("no number", !at_heights(0, 1, NAN, 3) && !at_heights(0, NAN, 2, 3));
}

static void
test_without_area(void)
{
  const double line[3][3] = {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}};
  const double far[3][3] = {{9, 0, 0}, {9, 1, 0}, {9, 0, 1}};

  CHECK("no plane", !said(line, 0, far));
  CHECK("its box", said(far, 0, line));
}

/* A corner on a grid of which some are moved by a few units in the last place,
 * at a distance where differences are rounded. */
static void
draw(uint32_t *seed, double out[3][3])
{
  for (int i = 0; i < 9; i++) {
    double x = check_below(seed, 5) + 0x1p20 / 3;

    for (int k = check_below(seed, 4); k > 0; k--) {
      x = nextafter(x, check_below(seed, 2) ? INFINITY : 0);
    }
    out[i / 3][i % 3] = x;
  }
}

static bool
on_one_side(const double of[3][3], const double other[3][3])
{
  int side = sg_orient3d(of[0], of[1], of[2], other[0]);

  return side != 0 && sg_orient3d(of[0], of[1], of[2], other[1]) == side &&
         sg_orient3d(of[0], of[1], of[2], other[2]) == side;
}

static bool
have_nothing(const double a[3][3], const double b[3][3], double reach)
{
  sg_contact contact[SG_CONTACT_MAX];
  sg_cut cut[SG_CUT_MAX];
  int n;

  return sg_cut_triangles(a, b, cut, &n) == SG_CUT_NONE &&
         (!(reach > 0) || sg_contacts(a, b, reach, contact) == 0);
}

static void
test_random(double reach)
{
  uint32_t seed = 5;
  int apart = 0, wrong = 0;

  for (int i = 0; i < PAIRS; i++) {
    double a[3][3], b[3][3];

    draw(&seed, a);
    draw(&seed, b);
    const double(*first)[3] = (const double(*)[3])a;
    const double(*second)[3] = (const double(*)[3])b;

    if (said(first, reach, second)) {
      apart++;
      wrong +=
          !on_one_side(first, second) || !have_nothing(first, second, reach);
    }
  }
  CHECK("none is wrong", wrong == 0);
  CHECK("many are found", apart > PAIRS / 10);
}

int
main(void)
{
  test_heights();
  test_without_area();
  test_random(0);
  test_random(1e-8);
  return check_report();
}
