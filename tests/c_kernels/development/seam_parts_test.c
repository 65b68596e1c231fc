/* seam_parts_test.c -- against all ways to divide some vertices. */
#include "tests/check.h"

#include "development/seam_moats.h"
#include "development/seam_parts.h"

#include <math.h>
#include <stdlib.h>

enum { MOST = 8, MANY = 3000 };

static uint64_t seed = 11;

static int
random_below(int most)
{
  seed = seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
  return (int)((seed >> 33) % (uint64_t)most);
}

static bool
go_on(void *data)
{
  (void)data;
  return false;
}

static bool
stop(void *data)
{
  (void)data;
  return true;
}

static int
by_size(const void *a, const void *b)
{
  double x = *(const double *)a, y = *(const double *)b;

  return (x > y) - (x < y);
}

/* Bends in twelfths of two whole turns. */
static size_t
most_parts(const int *twelfth, size_t n)
{
  double *bend = malloc((n + 1) * sizeof *bend);
  size_t parts = SIZE_MAX;
  bool stopped;

  for (size_t i = 0; i < n; i++) {
    bend[i] = twelfth[i] * acos(-1.0) / 3;
  }
  qsort(bend, n, sizeof *bend, by_size);
  CHECK("no memory", sg_seam_parts_most(bend, n, &(sg_cancel){go_on, NULL},
                                        &parts, &stopped));
  CHECK("stopped", !stopped);
  free(bend);
  return parts;
}

/* Into how many sets whose sums are whole those of `left` can be divided, or
 * some of them. */
static size_t
parts_of(const int *twelfth, unsigned left)
{
  size_t most = 0;

  for (unsigned set = left; set > 0; set = (set - 1) & left) {
    int sum = 0;

    if (!(set & (left & -left))) {
      continue; /* the first one is in a set, or is left out below */
    }
    for (unsigned i = 0; i < MOST; i++) {
      sum += set >> i & 1 ? twelfth[i] : 0;
    }
    if (sum % 12 == 0) {
      size_t parts = 1 + parts_of(twelfth, left & ~set);
      most = parts > most ? parts : most;
    }
  }
  if (left) {
    size_t parts = parts_of(twelfth, left & (left - 1));
    most = parts > most ? parts : most;
  }
  return most;
}

static void
check_by_hand(void)
{
  static const int cube[8] = {3, 3, 3, 3, 3, 3, 3, 3};
  static const int pairs[6] = {5, 5, 5, 7, 7, 7};
  static const int below[4] = {-5, -5, 5, 5};
  static const int deep[3] = {-30, -11, 5};
  static const int triples[6] = {4, 4, 4, 4, 4, 4};
  static const int low[6] = {-8, -8, -8, -8, -8, -8};
  static const int mixed[7] = {1, 11, 2, 2, 8, 3, 3};
  static const int alone[1] = {5};
  static const int twins[2] = {6, 6};
  static const int half[3] = {6, 1, 1};
  static const int equal[9] = {1, 1, 1, 3, 3, 3, 8, 8, 8};
  static const int above[6] = {4, 4, 4, 5, 5, 5};
  static const int under[6] = {3, 3, 3, 4, 4, 4};

  CHECK("four of a cube at a time", most_parts(cube, 8) == 2);
  CHECK("seven of it have one part", most_parts(cube, 7) == 1);
  CHECK("three have none", most_parts(cube, 3) == 0);
  CHECK("pairs", most_parts(pairs, 6) == 3);
  CHECK("pairs that sum to nothing", most_parts(below, 4) == 2);
  CHECK("a triple far below", most_parts(deep, 3) == 1);
  CHECK("triples", most_parts(triples, 6) == 2);
  CHECK("triples below", most_parts(low, 6) == 2);
  CHECK("no triple of two", most_parts(triples, 2) == 0);
  CHECK("two, three and two more", most_parts(mixed, 7) == 2);
  CHECK("nobody is his own partner", most_parts(alone, 1) == 0);
  CHECK("but of another one", most_parts(twins, 2) == 1);
  CHECK("half of two", most_parts(twins, 1) == 0);
  CHECK("nor half of a part", most_parts(half, 3) == 0);
  CHECK("as bent as one of a triple", most_parts(equal, 9) == 3);
  CHECK("more bent than those", most_parts(above, 6) == 1);
  CHECK("less bent than those", most_parts(under, 6) == 1);
  CHECK("nothing", most_parts(NULL, 0) == 0);
}

/* Never fewer than there can be; as many, mostly. */
static void
check_all_ways(void)
{
  unsigned fewer = 0, same = 0, runs = 4000;

  for (unsigned run = 0; run < runs; run++) {
    int twelfth[MOST];
    size_t n = 1 + (size_t)random_below(MOST);

    for (size_t i = 0; i < MOST; i++) {
      do {
        twelfth[i] = run % 2 ? random_below(6) : random_below(30) - 24;
      } while (twelfth[i] % 12 == 0);
    }
    size_t most = parts_of(twelfth, (1u << n) - 1);
    size_t told = most_parts(twelfth, n);

    fewer += told < most;
    same += told == most;
  }
  CHECK("no fewer", fewer == 0);
  CHECK("as many, mostly", same > runs / 2);
}

/* Of many vertices all may be in triples. */
static void
check_many(void)
{
  static int twelfth[MANY];

  for (int i = 0; i < MANY; i++) {
    twelfth[i] = 3;
  }
  CHECK("triples are looked for",
        most_parts(twelfth, SG_TRIPLES) == SG_TRIPLES / 4);
  CHECK("and are not among more", most_parts(twelfth, MANY) == MANY / 3);
  for (int i = 0; i < MANY; i++) {
    twelfth[i] = i % 2 ? 5 : 7;
  }
  CHECK("pairs are", most_parts(twelfth, MANY) == MANY / 2);
}

/* What is off by rounding balances. */
static void
check_rounding(void)
{
  double turns = 4 * acos(-1.0), off = 0.9 * SG_BENT_LEAST;
  double pair[2] = {0.4 * turns, 0.6 * turns + off};
  double triple[3] = {0.3 * turns, 0.3 * turns + off, 0.4 * turns + off};
  double apart[2] = {0.4 * turns, 0.6 * turns + 1.1 * SG_BENT_LEAST};
  sg_cancel cancel = {go_on, NULL};
  size_t parts;
  bool stopped;

  CHECK("a pair",
        sg_seam_parts_most(pair, 2, &cancel, &parts, &stopped) && parts == 1);
  CHECK("a triple",
        sg_seam_parts_most(triple, 3, &cancel, &parts, &stopped) && parts == 1);
  CHECK("too far apart",
        sg_seam_parts_most(apart, 2, &cancel, &parts, &stopped) && parts == 0);
  pair[1] -= 2 * off;
  CHECK("a little less",
        sg_seam_parts_most(pair, 2, &cancel, &parts, &stopped) && parts == 1);
}

/* Three triples of bends that are equal up to rounding: whichever is asked
 * first, all of them are in one. */
static void
check_nearly_equal(void)
{
  double part = acos(-1.0) / 3, off[2] = {1e-12, -1e-12};
  sg_cancel cancel = {go_on, NULL};
  size_t parts;
  bool stopped;

  for (int k = 0; k < 2; k++) {
    double bend[9];
    for (int i = 0; i < 9; i++) {
      bend[i] = part * (i < 3 ? 1 : i < 6 ? 3 : 8) + off[k];
    }
    CHECK("three triples",
          sg_seam_parts_most(bend, 9, &cancel, &parts, &stopped) && parts == 3);
  }
}

static void
check_stop(void)
{
  double bend[1] = {1};
  size_t parts;
  bool stopped;

  CHECK("stopped", !sg_seam_parts_most(bend, 1, &(sg_cancel){stop, NULL},
                                       &parts, &stopped) &&
                       stopped);
}

int
main(void)
{
  check_by_hand();
  check_all_ways();
  check_many();
  check_rounding();
  check_nearly_equal();
  check_stop();
  return check_report();
}
