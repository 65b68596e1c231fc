/* travel_test.c -- the order of lines for a pen: by hand, and nearest by
 * nearest, found again by looking at all. */
#include "tests/check.h"

#include "drawing/travel.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 3000 };

static int32_t start[2];

static bool
orders_as(const sg_travel_line *line, size_t n, const int32_t *wanted)
{
  int32_t order[MOST];
  bool memory;

  return sg_travel_order(line, n, start, order, NULL, &memory) &&
         memcmp(order, wanted, n * sizeof *order) == 0;
}

/* The square of it. */
static double
way(const int32_t a[2], const int32_t b[2])
{
  double x = (double)(b[0] - a[0]), y = (double)(b[1] - a[1]);

  return x * x + y * y;
}

/* The order by the definition. */
static void
plain_order(const sg_travel_line *line, size_t n, int32_t *order)
{
  bool used[MOST] = {false};
  int32_t at[2] = {start[0], start[1]};

  for (size_t i = 0; i < n; i++) {
    double least = DBL_MAX;
    size_t best = 0;
    for (size_t e = 0; e < 2 * n; e++) {
      if (!used[e / 2] && way(at, line[e / 2].at[e % 2]) < least) {
        least = way(at, line[e / 2].at[e % 2]);
        best = e;
      }
    }
    used[best / 2] = true;
    order[i] = best % 2 ? -(int32_t)(best / 2) - 1 : (int32_t)(best / 2) + 1;
    memcpy(at, line[best / 2].at[1 - best % 2], sizeof at);
  }
}

/* Lines with corners on a grid of this size. */
static bool
random_agrees(unsigned seed, size_t n, int size)
{
  sg_travel_line line[MOST];
  int32_t wanted[MOST];

  srand(seed);
  for (size_t i = 0; i < n; i++) {
    for (int k = 0; k < 4; k++) {
      line[i].at[k / 2][k % 2] = rand() % size - size / 3;
    }
  }
  plain_order(line, n, wanted);
  return orders_as(line, n, wanted);
}

/* Many rays from one point, drawn out and in by turns: the other ends there are
 * all equally near. Takes minutes if each of them is looked at each time. */
static bool
star_is_quick(void)
{
  enum { RAYS = 300000 };
  sg_travel_line *line = calloc(RAYS, sizeof *line);
  int32_t *order = malloc(RAYS * sizeof *order);
  bool memory, good;

  for (int32_t i = 0; i < RAYS; i++) {
    line[i].at[1][0] = 1000000;
    line[i].at[1][1] = i;
  }
  good = sg_travel_order(line, RAYS, start, order, NULL, &memory);
  for (int32_t i = 0; i < RAYS && good; i++) {
    good = order[i] == (i % 2 ? -i - 1 : i + 1);
  }
  free(line);
  free(order);
  return good;
}

static bool
stop(void *data)
{
  (void)data;
  return true;
}

int
main(void)
{
  const sg_travel_line three[] = {
      {{{90, 0}, {100, 0}}}, {{{10, 0}, {1, 0}}}, {{{50, 12}, {12, 0}}}};
  const sg_travel_line same[] = {{{{5, 5}, {5, 5}}}, {{{5, 5}, {5, 5}}}};
  const sg_cancel cancel = {stop, NULL};
  int32_t order[3];
  bool all = true, memory;

  CHECK("none", orders_as(three, 0, (int32_t[]){0}));
  CHECK("the nearest end first", orders_as(three, 3, (int32_t[]){-2, -3, 1}));
  CHECK("in one place: in their order", orders_as(same, 2, (int32_t[]){1, 2}));
  for (unsigned seed = 1; seed <= 40; seed++) {
    start[1] = seed % 3 ? 0 : 70000;
    all = all && random_agrees(seed, seed * 7, seed % 2 ? 8 : 100000);
  }
  start[1] = 0;
  CHECK("as by looking at all", all);
  CHECK("many", random_agrees(1, MOST, 1000000));
  CHECK("many ends in one place", star_is_quick());
  CHECK("how far as they are", sg_travel_length(three, 3, start, NULL) ==
                                   90 + 90 + sqrt(49 * 49 + 144));
  CHECK("how far in an order",
        sg_travel_length(three, 3, start, (int32_t[]){-2, -3, 1}) ==
            3 + sqrt(40 * 40 + 12 * 12));
  CHECK("it stops",
        !sg_travel_order(three, 3, start, order, &cancel, &memory) && memory);
  return check_report();
}
