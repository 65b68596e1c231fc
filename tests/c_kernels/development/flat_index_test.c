/* flat_index_test.c -- convex polygons near each other, found again by looking
 * at all. */
#include "tests/check.h"

#include "development/flat_index.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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
    const sg_flat_question q = {.box = any_box(sheet)};
    sg_flat_index_near(&index, &stock, &q, note, &f);
    for (uint32_t i = 0; i < MOST; i++) {
      all += sg_flat_boxes_meet(&q.box, &stock.box[i]);
    }
    wrong += f.n != all || f.twice > 0;
    asked += sg_flat_index_near(&index, &stock, &q, first_is_enough, &all);
  }
  CHECK("what is found are all whose boxes meet, each once", wrong == 0);
  CHECK("some are found", asked > 0);
  sg_flat_index_clear(&index, &stock);
  sg_flat_stock_clear(&stock);
}

/* Many items in one place, then some far away, as far as can be. */
static void
check_places(void)
{
  sg_flat_stock stock;
  sg_flat_index index = {0};
  found f = {.n = 0};
  const sg_flat_question q = {.box = {{0, 0}, {1, 1}}};

  CHECK("there is room", sg_flat_stock_make(1, 1, &stock));
  CHECK("and more", sg_flat_stock_reserve(&stock, MOST));
  for (uint32_t i = 0; i < MOST; i++) {
    double x = i < MOST - 20 ? 0.5 : i % 2 ? 1e200 : 1.7e308;
    stock.box[i] = (sg_flat_box){{x, x}, {x, x}};
    CHECK("an item is added", sg_flat_index_add(&index, &stock, i));
  }
  sg_flat_index_near(&index, &stock, &q, note, &f);
  CHECK("items in one place are found", f.n == MOST - 20 && f.twice == 0);
  CHECK("and not those that are far", !f.seen[MOST - 20]);
  size_t nodes = stock.nodes;
  sg_flat_index_clear(&index, &stock);
  CHECK("an index that is cleared has none",
        !sg_flat_index_near(&index, &stock, &q, first_is_enough, &f));
  CHECK("its items may be added again",
        sg_flat_index_add(&index, &stock, 0) && f.n == MOST - 20);
  CHECK("in the memory they had", stock.nodes == nodes);
  sg_flat_stock_clear(&stock);
}

/* ---- needles ------------------------------------------------------------ */

enum { NEEDLES = 2000 };

#define DEEP 1e-9

typedef double triangle[3][2];

typedef struct needles {
  triangle of[NEEDLES];
  triangle asked;
  size_t tests, overlaps;
} needles;

static size_t
corners_of_needle(const void *data, uint32_t item, double out[][2])
{
  memcpy(out, ((const needles *)data)->of[item], sizeof(triangle));
  return 3;
}

static bool
count_overlap(void *data, uint32_t item)
{
  needles *n = data;

  n->tests++;
  n->overlaps += sg_convex_overlap((const double(*)[2])n->asked, 3,
                                   (const double(*)[2])n->of[item], 3, DEEP);
  return false;
}

/* Needle i of a fan all round a point, a little narrower than its part of the
 * whole turn; turned on by this part of it. */
static void
needle_of_fan(int i, double on, triangle out)
{
  double step = 2 * acos(-1.0) / NEEDLES, at = step * (i + on);

  memcpy(out[0], (double[2]){0.3, -0.2}, sizeof out[0]);
  for (int k = 0; k < 2; k++) {
    out[k + 1][0] = 0.3 + cos(at + k * 0.999 * step);
    out[k + 1][1] = -0.2 + sin(at + k * 0.999 * step);
  }
}

/* Needle i of a row of parallel ones, aslant. */
static void
needle_of_row(int i, double on, triangle out)
{
  double at = 1e-3 * (i + on);

  memcpy(out, (triangle){{at, 0}, {at + 0.999e-3, 0}, {at + 1, 0.8}},
         sizeof(triangle));
}

typedef void needle(int i, double on, triangle out);

/* Every needle is asked for, and one between two, when those before it are
 * there: all overlaps are found, with few tests. */
static void
check_needles(needle *make)
{
  needles *n = calloc(1, sizeof *n);
  sg_flat_stock stock;
  sg_flat_index index = {0};
  sg_flat_question q = {.corner = (const double(*)[2])n->asked,
                        .corners = 3,
                        .depth = DEEP,
                        .corners_of = corners_of_needle,
                        .items = n};
  size_t wrong = 0;

  CHECK("there is room", sg_flat_stock_make(NEEDLES, 1, &stock));
  for (int i = 0; i < NEEDLES; i++) {
    make(i, 0, n->of[i]);
    for (int between = 0; between < 2; between++) {
      size_t all = 0;
      make(i, between ? -0.5 : 0, n->asked);
      q.box = sg_flat_box_round(q.corner, 3);
      n->overlaps = 0;
      sg_flat_index_near(&index, &stock, &q, count_overlap, n);
      for (int k = 0; k < i; k++) {
        all += sg_convex_overlap(q.corner, 3, (const double(*)[2])n->of[k], 3,
                                 DEEP);
      }
      wrong += n->overlaps != all || all != (size_t)(between && i > 0);
    }
    stock.box[i] = sg_flat_box_round((const double(*)[2])n->of[i], 3);
    CHECK("a needle is added", sg_flat_index_add(&index, &stock, (uint32_t)i));
  }
  CHECK("all needles that overlap are found", wrong == 0);
  CHECK("without looking at most of the others", n->tests < 100 * NEEDLES);
  sg_flat_stock_clear(&stock);
  free(n);
}

/* A corner of a square of this middle and size, below its diagonal. */
static void
half_square(double middle, double size, triangle out)
{
  memcpy(out,
         (triangle){{middle - size, middle - size},
                    {middle + size, middle - size},
                    {middle + size, middle + size}},
         sizeof(triangle));
}

/* Triangles with one middle, the largest first: whoever asks again and again
 * for what only that one overlaps always finds it. */
static void
check_one_middle(void)
{
  enum { OTHERS = 20, ONES = 12, TIMES = 40 };
  needles *n = calloc(1, sizeof *n);
  sg_flat_stock stock;
  sg_flat_index index = {0};
  sg_flat_question q = {.corner = (const double(*)[2])n->asked,
                        .corners = 3,
                        .depth = DEEP,
                        .corners_of = corners_of_needle,
                        .items = n};
  size_t wrong = 0;

  CHECK("there is room", sg_flat_stock_make(OTHERS + ONES, 1, &stock));
  for (uint32_t i = 0; i < OTHERS + ONES; i++) {
    if (i < OTHERS) { /* whose boxes are in the way, and come first */
      double low = -20.0 - i;
      memcpy(n->of[i], (triangle){{low, low}, {8, low}, {low, 8}},
             sizeof(triangle));
    } else {
      half_square(3, 4 - 0.3 * (i - OTHERS), n->of[i]);
    }
    stock.box[i] = sg_flat_box_round((const double(*)[2])n->of[i], 3);
    CHECK("added", sg_flat_index_add(&index, &stock, i));
  }
  half_square(6.9, 0.05, n->asked);
  q.box = sg_flat_box_round(q.corner, 3);
  for (int k = 0; k < TIMES; k++) {
    n->overlaps = 0;
    sg_flat_index_near(&index, &stock, &q, count_overlap, n);
    wrong += n->overlaps != 1;
  }
  CHECK("the largest is found each time", wrong == 0);
  sg_flat_stock_clear(&stock);
  free(n);
}

/* ---- walking ------------------------------------------------------------ */

static bool
is_left(void *data, const sg_flat_box *box)
{
  (void)data;
  return box->low[0] < 0;
}

static void
check_walk(void)
{
  sg_flat_stock stock;
  sg_flat_index index = {0};
  found f = {.n = 0};
  size_t left = 0, seen = 0;

  CHECK("there is room", sg_flat_stock_make(MOST, 1, &stock));
  for (uint32_t i = 0; i < MOST; i++) {
    stock.box[i] = any_box(1);
    CHECK("an item is added", sg_flat_index_add(&index, &stock, i));
  }
  CHECK("nobody says stop",
        !sg_flat_index_walk(&index, &stock, is_left, note, &f));
  for (uint32_t i = 0; i < MOST; i++) {
    left += stock.box[i].low[0] < 0;
    seen += stock.box[i].low[0] < 0 && f.seen[i];
  }
  CHECK("a walk comes to all that it looks for", left == seen && left > 0);
  CHECK("each once, and not to all others", f.twice == 0 && f.n < MOST);
  CHECK("it stops",
        sg_flat_index_walk(&index, &stock, is_left, first_is_enough, &left));
  sg_flat_stock_clear(&stock);
}

int
main(void)
{
  check_against_all(1);
  check_against_all(1000);
  check_against_all(1e-3);
  check_places();
  check_needles(needle_of_fan);
  check_needles(needle_of_row);
  check_one_middle();
  check_walk();
  return check_report();
}
