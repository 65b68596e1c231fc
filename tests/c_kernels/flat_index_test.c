/* flat_index_test.c -- convex polygons near each other: by hand, and found
 * again by looking at all. */
#include "../check.h"

#include "../../c_kernels/flat_index.h"

#include <math.h>
#include <stdlib.h>

enum { MOST = 4000, ASKED = 300 };

static uint64_t state = 7;

static double
chance(void)
{
  state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
  return (double)(state >> 11) * 0x1p-53;
}

/* A box anywhere, of any size: from a hair to the whole sheet. */
static sg_flat_box
any_box(double sheet)
{
  double size = sheet * pow(10, -5 * chance()), thin = pow(10, -3 * chance());
  double x = sheet * (2 * chance() - 1), y = sheet * (2 * chance() - 1);

  return chance() < 0.5 ? (sg_flat_box){{x, y}, {x + size, y + size * thin}}
                        : (sg_flat_box){{x, y}, {x + size * thin, y + size}};
}

typedef struct found {
  bool seen[MOST];
  size_t n, twice;
} found;

static bool
note(void *data, uint32_t item)
{
  found *f = data;

  f->twice += f->seen[item];
  f->n += !f->seen[item];
  f->seen[item] = true;
  return false;
}

static bool
first_is_enough(void *data, uint32_t item)
{
  (void)item;
  ++*(size_t *)data;
  return true;
}

static void
check_against_all(double sheet)
{
  sg_flat_stock stock;
  sg_flat_index index = {0};
  size_t wrong = 0, asked = 0;

  CHECK("there is room", sg_flat_stock_make(MOST, 1, &stock));
  for (uint32_t i = 0; i < MOST; i++) {
    stock.box[i] = any_box(sheet);
    CHECK("an item is added", sg_flat_index_add(&index, &stock, i));
  }
  for (int k = 0; k < ASKED; k++) {
    found f = {.n = 0};
    size_t all = 0;
    sg_flat_box box = any_box(sheet);
    sg_flat_index_near(&index, &stock, &box, note, &f);
    for (uint32_t i = 0; i < MOST; i++) {
      all += sg_flat_boxes_meet(&box, &stock.box[i]);
    }
    wrong += f.n != all || f.twice > 0;
    asked += sg_flat_index_near(&index, &stock, &box, first_is_enough, &all);
  }
  CHECK("what is found are all whose boxes meet, each once", wrong == 0);
  CHECK("some are found", asked > 0);
  sg_flat_index_clear(&index);
  sg_flat_stock_clear(&stock);
}

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
  const double a_little_in[3][2] = {{1 - 1e-10, -1}, {2, 0}, {1, 1}};
  const double in[3][2] = {{0.9, -1}, {2, 0}, {1, 1}};
  const double inside[3][2] = {{0.1, 0.1}, {0.2, 0.1}, {0.1, 0.2}};
  const double sliver[3][2] = {{-1, 0.3}, {2, 0.3}, {2, 0.3 + 1e-13}};
  const double sliver_beside[3][2] = {{-1, -1e-13}, {2, -1e-13}, {2, 0}};

  CHECK("a triangle overlaps itself", overlap(a, a, 1e-9));
  CHECK("beside a common side", !overlap(a, beside, 1e-9));
  CHECK("at a common corner", !overlap(a, at_a_corner, 1e-9));
  CHECK("not deeper than that", !overlap(a, a_little_in, 1e-9));
  CHECK("deeper", overlap(a, in, 1e-9));
  CHECK("one inside the other", overlap(a, inside, 1e-9));
  CHECK("a sliver across, however thin", overlap(a, sliver, 1e-9));
  CHECK("a sliver beside", !overlap(a, sliver_beside, 1e-9));
}

int
main(void)
{
  check_overlaps();
  check_against_all(1);
  check_against_all(1000);
  check_against_all(1e-3);
  return check_report();
}
