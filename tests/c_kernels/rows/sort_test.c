/* sort_test.c -- sg_sort(): stable, and whole when it is stopped;
 * sg_sort_measured(), sg_sort_upper(): the same order. */
#include "rows/sort.h"
#include "tests/check.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 20000 };

typedef struct item {
  int32_t key, place;
} item;

static int
by_key(const void *a, const void *b)
{
  const item *x = a, *y = b;

  return (x->key > y->key) - (x->key < y->key);
}

/* A cancel that says stop when it has been asked often enough. */
static bool
stop_at_zero(void *data)
{
  int *left = data;

  return (*left)-- <= 0;
}

static void
fill(item *array, size_t n)
{
  for (size_t i = 0; i < n; i++) {
    array[i] = (item){rand() % 100, (int32_t)i};
  }
}

static bool
is_stable(const item *array, size_t n)
{
  for (size_t i = 1; i < n; i++) {
    if (array[i - 1].key > array[i].key ||
        (array[i - 1].key == array[i].key &&
         array[i - 1].place >= array[i].place)) {
      return false;
    }
  }
  return true;
}

static bool
is_whole(const item *array, size_t n)
{
  static bool seen[MOST];

  memset(seen, 0, sizeof seen);
  for (size_t i = 0; i < n; i++) {
    if (seen[array[i].place]) {
      return false;
    }
    seen[array[i].place] = true;
  }
  return true;
}

static int
by_value(const void *a, const void *b)
{
  const sg_measured *x = a, *y = b;

  return x->value != y->value ? (x->value > y->value) - (x->value < y->value)
                              : (x->of > y->of) - (x->of < y->of);
}

/* Numbers of all sizes and signs, many of them equal. */
static double
any_number(void)
{
  static const double scale[] = {1,     -1,     1e-300, -1e-300,
                                 1e300, -1e300, 0,      -0.0};

  return scale[rand() % 8] * (rand() % 100);
}

static bool
sorts_measured(size_t n)
{
  static sg_measured found[MOST], expected[MOST];

  for (size_t i = 0; i < n; i++) {
    expected[i] = found[i] = (sg_measured){any_number(), (uint32_t)i};
  }
  qsort(expected, n, sizeof *expected, by_value);
  bool good = sg_sort_measured(found, n, NULL) == SG_SORTED;

  for (size_t i = 0; i < n; i++) {
    good &=
        found[i].of == expected[i].of && found[i].value == expected[i].value;
  }
  return good;
}

static int
by_upper(const void *a, const void *b)
{
  const uint64_t *x = a, *y = b; /* lower halves are places */

  return (*x > *y) - (*x < *y);
}

/* Keys in an array of just their size, or one with room for more, which stays
 * as it is. `wide`: how many bits of the upper halves differ. */
static bool
sorts_upper(size_t n, size_t more, unsigned wide)
{
  uint64_t *found = malloc((n + more) * sizeof *found + 1);
  uint64_t *expected = malloc(n * sizeof *expected + 1);

  for (size_t i = 0; i < n + more; i++) {
    uint64_t upper = (uint64_t)rand() << 16 ^ (uint64_t)rand();
    found[i] = (wide ? upper << (64 - wide) : 0) | i;
  }
  memcpy(expected, found, n * sizeof *found);
  qsort(expected, n, sizeof *expected, by_upper);
  uint64_t behind = more > 0 ? found[n] : 0;
  bool good = sg_sort_upper(found, n) &&
              memcmp(found, expected, n * sizeof *found) == 0 &&
              (more == 0 || found[n] == behind);

  free(found);
  free(expected);
  return good;
}

/* Ids: each once, ascending, each found where it is. */
static bool
sorts_ids(size_t n)
{
  static int32_t id[MOST];
  bool good = true;

  for (size_t i = 0; i < n; i++) {
    id[i] = 2 * (rand() % 1000);
  }
  size_t kept = sg_sort_ids(id, n);

  for (size_t i = 0; i < kept; i++) {
    good = good && (i == 0 || id[i - 1] < id[i]) &&
           sg_find_id(id, kept, id[i]) == i &&
           sg_find_id(id, kept, id[i] + 1) == SIZE_MAX;
  }
  return good && (n == 0) == (kept == 0);
}

int
main(void)
{
  static item array[MOST];
  static const size_t size[] = {0, 1, 2, 4095, 4096, 4097, 8193, MOST};
  bool stable = true, whole = true;

  srand(3);
  for (size_t i = 0; i < sizeof size / sizeof *size; i++) {
    fill(array, size[i]);
    stable &= sg_sort(array, size[i], sizeof *array, by_key, NULL) == SG_SORTED;
    stable &= is_stable(array, size[i]);
  }
  CHECK("sorted, equals in order", stable);
  bool measured = true;
  for (size_t i = 0; i < sizeof size / sizeof *size; i++) {
    measured &= sorts_measured(size[i]);
  }
  CHECK("numbers sorted, equals in order", measured);
  bool upper = true;
  for (size_t i = 0; i < sizeof size / sizeof *size; i++) {
    for (unsigned wide = 0; wide <= 32; wide += 4) {
      upper = upper && sorts_upper(size[i], 0, wide) &&
              sorts_upper(size[i], 1000, wide);
    }
  }
  CHECK("upper halves sorted, equals in order", upper);
  for (int asks = 0; asks < 12; asks++) {
    int left = asks;
    sg_cancel cancel = {stop_at_zero, &left};
    sg_sort_end end;
    fill(array, MOST);
    end = sg_sort(array, MOST, sizeof *array, by_key, &cancel);
    whole &=
        is_whole(array, MOST) && (end == SG_SORTED) == is_stable(array, MOST);
  }
  CHECK("nothing is lost when it is stopped", whole);
  CHECK("ids", sorts_ids(0) && sorts_ids(1) && sorts_ids(MOST));
  return check_report();
}
