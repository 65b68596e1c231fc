/* exact_point_test.c -- exact points where they are hardest: equal doubles and
 * other rationals, ties, the ends of the range, several threads, no memory. */
#include "number/exact.h"
#include "tests/check.h"
#include "tests/memory/refusals.h"

#include <math.h>
#include <pthread.h>
#include <stdatomic.h>

/* Each coordinate: at / denominator + n 2^-200. */
static bool
set_near(sg_point *out, const long at[3], unsigned long denominator, long n)
{
  mpq_t q[3], off;
  bool done;

  mpq_init(off);
  mpq_set_si(off, n, 1);
  mpq_div_2exp(off, off, 200);
  for (int k = 0; k < 3; k++) {
    mpq_init(q[k]);
    mpq_set_si(q[k], at[k], denominator);
    mpq_canonicalize(q[k]);
    mpq_add(q[k], q[k], off);
  }
  done = sg_point_set_q(out, q[0], q[1], q[2]);
  mpq_clears(q[0], q[1], q[2], off, NULL);
  return done;
}

/* ---- order and equality ---- */

enum { NEAR = 7 };

static int
sign_of(int n)
{
  return (n > 0) - (n < 0);
}

/* Points a little apart, all with the doubles of the middle one, which is one:
 * their order is that of their rationals. */
static void
test_order(void)
{
  const long at[3] = {5, -3, 1};
  size_t bad = 0;
  sg_point p[NEAR];

  for (int i = 0; i < NEAR; i++) {
    bad += !set_near(&p[i], at, 4, i - NEAR / 2);
    bad += !p[i].exactly != (i == NEAR / 2);
    bad += p[i].p[0] != 1.25 || p[i].p[1] != -0.75 || p[i].p[2] != 0.25;
  }
  CHECK("same doubles, one of them exactly", bad == 0);
  for (int i = 0; i < NEAR; i++) {
    for (int j = 0; j < NEAR; j++) {
      for (int axis = 0; axis < 3; axis++) {
        bad += sg_point_compare(axis, &p[i], &p[j]) != sign_of(i - j);
      }
      bad += sg_point_equal(&p[i], &p[j]) != (i == j);
      bad +=
          sg_point_along(&p[0], &p[NEAR - 1], &p[i], &p[j]) != sign_of(i - j);
      bad +=
          sg_point_along(&p[NEAR - 1], &p[0], &p[i], &p[j]) != sign_of(j - i);
    }
  }
  CHECK("in order", bad == 0);
  for (int i = 0; i < NEAR; i++) {
    sg_point_clear(&p[i]);
  }
}

/* Points that differ in one coordinate only, by much or by nothing that a
 * double sees, are not equal. */
static void
test_one_coordinate(void)
{
  const long third[3] = {1, 1, 1};

  for (int k = 0; k < 3; k++) {
    for (long n = 0; n < 2; n++) {
      long at[3] = {1, 1, 1};
      sg_point p, q, same;
      at[k] += n;
      CHECK("made", set_near(&p, third, 3, 0) && set_near(&q, at, 3, 0) &&
                        set_near(&same, third, 3, 0));
      CHECK("equal if nothing differs", sg_point_equal(&p, &q) == (n == 0));
      for (int axis = 0; axis < 3; axis++) {
        int order = n > 0 && axis == k;
        CHECK("compared", sg_point_compare(axis, &p, &q) == -order &&
                              sg_point_compare(axis, &q, &p) == order);
      }
      CHECK("made twice, equal",
            p.exactly != same.exactly && sg_point_equal(&p, &same));
      sg_point rounded;
      sg_point_set(&rounded, p.p);
      CHECK("its doubles are another point",
            !sg_point_equal(&p, &rounded) && !sg_point_equal(&rounded, &p));
      sg_point_clear(&p);
      sg_point_clear(&q);
      sg_point_clear(&same);
    }
  }
}

static void
test_copies(void)
{
  const long at[3] = {1, 2, 5};
  sg_point p, copy;

  CHECK("made", set_near(&p, at, 7, 0));
  sg_point_copy(&copy, &p);
  CHECK("a copy is in the same place",
        sg_point_equal(&p, &copy) && sg_point_along(&p, &copy, &p, &copy) == 0);
  sg_point_clear(&p);
  CHECK("cleared: its doubles", !sg_point_q(&p));
  CHECK("the copy lives", mpq_cmp_si(sg_point_q(&copy)[1], 2, 7) == 0);
  sg_point_clear(&copy);
}

/* ---- signs ---- */

/* One made point among doubles, in each place of the question: on the plane
 * x + y + z = 1 (or the line x + y = 1), a little before, a little behind. */
static void
test_sides(void)
{
  const double corner[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const long third[3] = {1, 1, 1}, half[3] = {1, 1, 0};
  sg_point c[3];

  for (int k = 0; k < 3; k++) {
    sg_point_set(&c[k], corner[k]);
  }
  for (int n = -1; n <= 1; n++) {
    sg_point p, q;
    CHECK("made", set_near(&p, third, 3, n) && set_near(&q, half, 2, n));
    CHECK("side: last", sg_point_orient3d(&c[0], &c[1], &c[2], &p) == -n);
    CHECK("third", sg_point_orient3d(&c[0], &c[1], &p, &c[2]) == n);
    CHECK("second", sg_point_orient3d(&c[0], &p, &c[1], &c[2]) == -n);
    CHECK("first", sg_point_orient3d(&p, &c[0], &c[1], &c[2]) == n);
    CHECK("turn: last", sg_point_turn(2, &c[0], &c[1], &q) == -n);
    CHECK("second", sg_point_turn(2, &c[0], &q, &c[1]) == n);
    CHECK("first", sg_point_turn(2, &q, &c[0], &c[1]) == -n);
    sg_point_clear(&p);
    sg_point_clear(&q);
  }
  CHECK("the same point twice does not turn",
        sg_point_turn(2, &c[0], &c[0], &c[1]) == 0 &&
            sg_point_turn(2, &c[1], &c[0], &c[0]) == 0 &&
            sg_point_turn(2, &c[0], &c[1], &c[0]) == 0);
}

/* A plane through points whose differences are no doubles. Sums of doubles see
 * a last place of the fourth, unless it is so small that products vanish. */
static void
test_last_place(void)
{
  const double a[3] = {1, 0, 1}, b[3] = {0, 1, 1}, c[3] = {3, 5, 8};
  const double size[] = {0x1p-60, 0x1p-300};

  for (int i = 0; i < 6; i++) {
    double n = i / 2 - 1, unit = size[i % 2];
    double d[3] = {unit, unit / 2, unit * (1.5 + n * 0x1p-52)};
    uint64_t before = sg_exact_fallbacks_of(SG_ASKED_ORIENT3D);

    CHECK("on z = x + y, a last place below or above",
          sg_orient3d(a, b, c, d) == n);
    CHECK("mirrored", sg_orient3d(b, a, c, d) == -n);
    CHECK("integers are asked if they have to be",
          sg_exact_fallbacks_of(SG_ASKED_ORIENT3D) - before == (i % 2 ? 2 : 0));
  }
}

/* The same of a line. */
static void
test_last_place_of_turn(void)
{
  const double a[2] = {1, 1}, b[2] = {3, 3}, size[] = {0x1p-60, 0x1p-300};

  for (int i = 0; i < 6; i++) {
    double n = i / 2 - 1, unit = size[i % 2];
    double c[2] = {unit, unit * (1 + n * (n < 0 ? 0x1p-53 : 0x1p-52))};
    uint64_t before = sg_exact_fallbacks_of(SG_ASKED_ORIENT2D);

    CHECK("on x = y, a last place below or above", sg_orient2d(a, b, c) == n);
    CHECK("the other way", sg_orient2d(b, a, c) == -n);
    CHECK("integers are asked if they have to be",
          sg_exact_fallbacks_of(SG_ASKED_ORIENT2D) - before == (i % 2 ? 2 : 0));
  }
}

/* Four points, two of them on a line along `axis`, seen along which three turn
 * as n says, by a step of a number. All orders of them. */
static bool
turn_about_line(int axis, double unit, double step, int n)
{
  const double up[4] = {1.3, -0.2, 0.7, 5}, across[4] = {1, 1, 3, unit},
               along[4] = {1, 1, 3, unit * (1 + n * step)};
  double p[4][3];
  bool good = true;

  for (int i = 0; i < 4; i++) {
    p[i][axis] = up[i];
    p[i][(axis + 1) % 3] = across[i];
    p[i][(axis + 2) % 3] = along[i];
  }
  for (int i = 0; i < 24; i++) { /* i: digits of a permutation */
    int a = i / 6, b = i / 2 % 3, c = i % 2, order[4] = {0, 1, 2, 3};
    int chosen[4] = {a, b, c, 0}, parity = (a + b + c) % 2 ? -1 : 1;

    for (int k = 0; k < 4; k++) {
      int at = k + chosen[k], value = order[at];

      for (; at > k; at--) {
        order[at] = order[at - 1];
      }
      order[k] = value;
    }
    good = good && sg_orient3d(p[order[0]], p[order[1]], p[order[2]],
                               p[order[3]]) == n * parity;
  }
  return good;
}

static void
test_about_line(void)
{
  for (int i = 0; i < 9; i++) {
    CHECK("plainly", turn_about_line(i / 3, 0.5, 0.5, i % 3 - 1));
    CHECK("by a last place",
          turn_about_line(i / 3, 0x1p-60, 0x1p-52, i % 3 - 1));
    CHECK("for integers", turn_about_line(i / 3, 0x1p-300, 0x1p-52, i % 3 - 1));
  }
}

/* Numbers whose products overflow, and those that vanish. */
static void
test_range_of_signs(void)
{
  static const double size[] = {0x1p1020, 0x1p300, 1, 0x1p-300, 0x1p-1060};

  for (size_t i = 0; i < sizeof size / sizeof size[0]; i++) {
    double s = size[i];
    for (int n = -1; n <= 1; n++) {
      double a[3] = {s, 0, 0}, b[3] = {0, s, 0}, c[3] = {0, 0, s},
             d[3] = {s, s, -s + n * (s / 1024)};
      CHECK("orient3d, whatever the size", sg_orient3d(a, b, c, d) == -n);
      CHECK("orient2d",
            sg_orient2d(a, b, (double[2]){s / 2, s / 2 + n * (s / 1024)}) ==
                -n);
    }
  }
}

/* ---- rounding, and the ends of the range ---- */

/* k / 4 of the smallest double, ties to even. */
static void
test_smallest(void)
{
  size_t bad = 0;
  mpq_t q, zero;

  mpq_inits(q, zero, NULL);
  for (long k = -40; k <= 40; k++) {
    long size = labs(k), whole = size / 4, rest = size % 4;
    sg_point p;
    whole += rest > 2 || (rest == 2 && whole % 2 == 1);
    mpq_set_si(q, k, 1);
    mpq_div_2exp(q, q, 1076);
    bad += !sg_point_set_q(&p, q, zero, zero);
    bad += p.p[0] != (double)(k < 0 ? -whole : whole) * 0x1p-1074;
    bad += signbit(p.p[0]) && p.p[0] == 0;
    bad += !p.exactly != (rest == 0);
    sg_point_clear(&p);
  }
  CHECK("the smallest doubles, ties to even", bad == 0);
  mpq_clears(q, zero, NULL);
}

/* Lines and planes that meet beyond the doubles give no point, and such that
 * meet just inside do. */
static void
test_largest(void)
{
  const double d[][3] = {
      {0, 0, 1}, {0x1p1000, 0, 1 - 0x1p-53}, {0, 0, 0}, {1, 0, 0},
      {0, 1, 0}, {0x1p1000, 0, 1 - 0x1p-20}, {0, 1, 1}, {0, 0, 1}};
  sg_point p[8], out;

  for (int i = 0; i < 8; i++) {
    sg_point_set(&p[i], d[i]);
  }
  const sg_point *far[3][3] = {
      {&p[0], &p[1], &p[6]}, {&p[2], &p[3], &p[4]}, {&p[2], &p[3], &p[7]}};
  CHECK("a line and a plane",
        !sg_point_lpi(&out, &p[0], &p[1], &p[2], &p[3], &p[4]));
  CHECK("two lines", !sg_point_ll(&out, 1, &p[0], &p[1], &p[2], &p[3]));
  CHECK("three planes", !sg_point_tpi(&out, (const sg_point *const(*)[3])far));
  far[0][1] = &p[5];
  CHECK("nearer: a line and a plane",
        sg_point_lpi(&out, &p[0], &p[5], &p[2], &p[3], &p[4]) &&
            out.p[0] == 0x1p1020 && !out.exactly);
  CHECK("two lines", sg_point_ll(&out, 1, &p[0], &p[5], &p[2], &p[3]) &&
                         out.p[0] == 0x1p1020 && !out.exactly);
  CHECK("three planes", sg_point_tpi(&out, (const sg_point *const(*)[3])far) &&
                            out.p[0] == 0x1p1020 && out.p[1] == 0);
}

/* ---- points that are doubles ---- */

/* Lines along two axes that meet in (x, y, z); a plane there. */
static bool
meet_in_double(double x, double y, double z)
{
  const double d[7][3] = {{x, y, -2},    {x, y, 1.7}, {-1.3, y, z}, {2, y, z},
                          {0.1, 0.7, z}, {5, 1.1, z}, {-3, 2, z}};
  sg_point p[7], by_line, by_plane;

  for (int i = 0; i < 7; i++) {
    sg_point_set(&p[i], d[i]);
  }
  bool made = sg_point_ll(&by_line, 1, &p[0], &p[1], &p[2], &p[3]) &&
              sg_point_lpi(&by_plane, &p[0], &p[1], &p[4], &p[5], &p[6]);
  const sg_point *at[] = {&by_line, &by_plane};

  for (int i = 0; made && i < 2; i++) {
    made = !at[i]->exactly && at[i]->p[0] == x && at[i]->p[1] == y &&
           at[i]->p[2] == z && (x != 0 || !signbit(at[i]->p[0])) &&
           (z != 0 || !signbit(at[i]->p[2]));
  }
  return made;
}

static void
test_doubles(void)
{
  CHECK("of few digits", meet_in_double(0.25, 0.5, 1));
  CHECK("of all digits", meet_in_double(0.1, -0.7, 1.0 / 3));
  CHECK("zeros", meet_in_double(0, 0, 0) && meet_in_double(-0.0, 0.3, -0.0));
}

/* (1/3, 0, 0) on a line with y = z = 0, and one beside it whose y is not. */
static void
test_beside_doubles(void)
{
  const double d[4][3] = {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, -2, 0}};
  const double up[3] = {1, 0x1p-53, 0};
  sg_point p[4], q, on, beside;

  for (int i = 0; i < 4; i++) {
    sg_point_set(&p[i], d[i]);
  }
  sg_point_set(&q, up);
  CHECK("a third", sg_point_ll(&on, 2, &p[0], &p[1], &p[2], &p[3]) &&
                       on.exactly && on.p[1] == 0 && on.p[0] == 1.0 / 3 &&
                       mpq_cmp_si(sg_point_q(&on)[0], 1, 3) == 0 &&
                       mpq_sgn(sg_point_q(&on)[1]) == 0);
  CHECK("beside it", sg_point_ll(&beside, 2, &p[0], &q, &p[2], &p[3]) &&
                         beside.exactly && beside.p[1] > 0 &&
                         mpq_sgn(sg_point_q(&beside)[1]) > 0);
  sg_point_clear(&on);
  sg_point_clear(&beside);
}

/* ---- points made of made points ---- */

/* From (i, 1, 0) / 7 to (i, 0, 1) / 7: halfway lies z = 1 / 14. */
static void
test_made_of_made(void)
{
  size_t bad = 0;
  sg_point plane[3];
  const long corner[3][3] = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};

  for (int k = 0; k < 3; k++) {
    bad += !set_near(&plane[k], corner[k], 14, 0);
  }
  for (long i = 1; i < 50; i++) {
    const long from[3] = {i, 1, 0}, to[3] = {i, 0, 1},
               middle[3] = {2 * i, 1, 1};
    sg_point a, b, m, by_plane, by_line;
    bad += !set_near(&a, from, 7, 0) || !set_near(&b, to, 7, 0) ||
           !set_near(&m, middle, 14, 0);
    bad += !sg_point_lpi(&by_plane, &a, &b, &plane[0], &plane[1], &plane[2]);
    bad += !sg_point_ll(&by_line, 0, &b, &a, &plane[0], &plane[2]);
    bad += !sg_point_equal(&by_plane, &m) || !sg_point_equal(&by_line, &m);
    bad += sg_point_turn(0, &a, &b, &by_plane) != 0 ||
           sg_point_along(&a, &b, &by_line, &b) != -1;
    sg_point *made[] = {&a, &b, &m, &by_plane, &by_line};
    for (int k = 0; k < 5; k++) {
      sg_point_clear(made[k]);
    }
  }
  CHECK("halfway between rational ends", bad == 0);
  for (int k = 0; k < 3; k++) {
    sg_point_clear(&plane[k]);
  }
}

/* ---- threads ---- */

enum { THREADS = 2, SHARED = 2000 };

static sg_point shared[SHARED];
static mpq_t *seen[THREADS][SHARED];
static atomic_int arrived[SHARED];

static bool
make_third(sg_point *out, long i)
{
  const double d[5][3] = {{(double)i, 1, -1},
                          {(double)i, 4, 2.1},
                          {0, 0, 0.7},
                          {1, 0, 0.7},
                          {0, 1, 0.7}};
  sg_point p[5];

  for (int k = 0; k < 5; k++) {
    sg_point_set(&p[k], d[k]);
  }
  return sg_point_lpi(out, &p[0], &p[1], &p[2], &p[3], &p[4]);
}

/* All ask for the same point at about the same time. */
static void *
ask(void *data)
{
  size_t thread = (size_t)((mpq_t * (*)[SHARED]) data - seen);

  for (int i = 0; i < SHARED; i++) {
    atomic_fetch_add(&arrived[i], 1);
    for (int spin = 0; spin < 20000 && atomic_load(&arrived[i]) < THREADS;
         spin++) {
    }
    seen[thread][i] = sg_point_q(&shared[i]);
  }
  return NULL;
}

static void
test_threads(void)
{
  pthread_t thread[THREADS];
  size_t bad = 0, waiting = 0;

  for (int i = 0; i < SHARED; i++) {
    bad += !make_third(&shared[i], i) || !shared[i].exactly;
  }
  CHECK("made", bad == 0);
  for (int t = 0; t < THREADS; t++) {
    bad += pthread_create(&thread[t], NULL, ask, &seen[t]) != 0;
  }
  for (int t = 0; t < THREADS && bad == 0; t++) {
    pthread_join(thread[t], NULL);
  }
  for (int i = 0; i < SHARED; i++) {
    sg_point again;
    waiting += atomic_load(&arrived[i]) != THREADS;
    for (int t = 0; t < THREADS; t++) {
      bad += !seen[t][i] || seen[t][i] != seen[0][i];
    }
    bad += !make_third(&again, i) || !sg_point_equal(&again, &shared[i]);
    sg_point_clear(&again);
    sg_point_clear(&shared[i]);
  }
  CHECK("all threads get the same rationals", bad == 0 && waiting == 0);
}

/* ---- without memory ---- */

/* One point of each kind: from rationals, kept as what made it, made of made
 * points, of planes. True: all were made. */
static bool
make_each(sg_point out[4], int *n)
{
  const long at[3] = {1, 2, 3};
  const double d[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 7}};
  sg_point p[3];

  for (int k = 0; k < 3; k++) {
    sg_point_set(&p[k], d[k]);
  }
  *n = 0;
  if (!set_near(&out[0], at, 7, 0)) {
    return false;
  }
  *n = 1;
  if (!make_third(&out[1], 3)) {
    return false;
  }
  *n = 2;
  if (!sg_point_lpi(&out[2], &out[0], &out[1], &p[0], &p[1], &p[2])) {
    return false;
  }
  *n = 3;
  const sg_point *plane[3][3] = {{&p[0], &p[1], &p[2]},
                                 {&out[0], &out[1], &p[0]},
                                 {&out[1], &p[1], &out[0]}};
  *n += sg_point_tpi(&out[3], (const sg_point *const(*)[3])plane);
  return *n == 4;
}

static void
test_no_memory(void)
{
  enum { MOST = 100 };
  long n = 0, bad = 0;
  bool done = false;

  if (!is_counted()) {
    printf("skipped: allocations that fail: the checker has its own\n");
    return;
  }
  for (; n < MOST && !done; n++) {
    sg_point p[4];
    int made;
    living = 0;
    left = n;
    counting = true;
    done = make_each(p, &made);
    bad += done != (left >= 0);
    left = -1;
    bad += done && !sg_point_equal(&p[2], &p[3]);
    bad += !done && made != n;
    for (int i = 0; i < made; i++) {
      sg_point_clear(&p[i]);
    }
    counting = false;
    bad += living != 0;
  }
  CHECK("a refused point is told and nothing leaks", bad == 0);
  CHECK("each point asks once", n == 5 && done);
}

int
main(void)
{
  spare_gmp();
  test_order();
  test_one_coordinate();
  test_copies();
  test_sides();
  test_last_place();
  test_last_place_of_turn();
  test_about_line();
  test_range_of_signs();
  test_smallest();
  test_largest();
  test_doubles();
  test_beside_doubles();
  test_made_of_made();
  test_threads();
  test_no_memory();
  return check_report();
}
