/* exact_test.c -- exact signs and points against plain rational arithmetic.
 *
 * The hard cases are made here, from a fixed seed: points almost or exactly
 * on a line or plane, a few units in the last place off, on grids, far from
 * the origin, tiny, huge, subnormal.
 *
 * covers: bounded_double, integers
 */
#include "doors/world.h"
#include "number/exact.h"
#include "tests/check.h"
#include "tests/memory/refusals.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

enum { CASES = 4000, FAMILIES = 6 };

static uint64_t seed = 20261121;

static uint64_t
random64(void)
{
  seed ^= seed << 13;
  seed ^= seed >> 7;
  seed ^= seed << 17;
  return seed * 0x2545F4914F6CDD1Du;
}

static double
unit(void) /* in [-1, 1) */
{
  return ldexp((double)(random64() >> 11), -52) - 1;
}

/* A few units in the last place up or down, or none. */
static double
nudge(double x)
{
  int steps = (int)(random64() % 7) - 3;

  for (; steps > 0; steps--) {
    x = nextafter(x, INFINITY);
  }
  for (; steps < 0; steps++) {
    x = nextafter(x, -INFINITY);
  }
  return x;
}

static double
scale_of(int family)
{
  switch (family) {
  case 3:
    return 1e-160;
  case 4:
    return 1e150;
  case 5:
    return 3e-320; /* subnormal */
  default:
    return 1;
  }
}

static double
number(int family)
{
  switch (family) {
  case 0:
    return unit();
  case 1:
    return (double)(random64() % 9) - 4; /* a small grid: many zeros */
  case 2:
    return 1e6 + unit(); /* far from the origin */
  default:
    return unit() * scale_of(family);
  }
}

/* n points of R^3, the last one almost in the span of the others. */
static void
points(int family, double p[][3], int n)
{
  for (int i = 0; i < n; i++) {
    for (int k = 0; k < 3; k++) {
      p[i][k] = number(family);
    }
  }
  if (family == 1 || random64() % 8 == 0) {
    return;
  }
  double s = unit(), t = unit();
  for (int k = 0; k < 3; k++) {
    double x = p[0][k] + s * (p[1][k] - p[0][k]);
    if (n == 4) {
      x += t * (p[2][k] - p[0][k]);
    }
    p[n - 1][k] = nudge(x);
  }
}

/* ---- the same in rationals ---------------------------------------------- */

static void
rational(mpq_t out[3], const sg_point *p)
{
  for (int k = 0; k < 3; k++) {
    mpq_t *q = sg_point_q(p);

    mpq_init(out[k]);
    if (q) {
      mpq_set(out[k], q[k]);
    } else {
      mpq_set_d(out[k], p->p[k]);
    }
  }
}

static void
clear(mpq_t p[3])
{
  mpq_clears(p[0], p[1], p[2], NULL);
}

/* out := (b - a) x (c - a), one component */
static void
cross(mpq_t out, int k, mpq_t a[3], mpq_t b[3], mpq_t c[3])
{
  int u = (k + 1) % 3, v = (k + 2) % 3;
  mpq_t x, y;

  mpq_inits(x, y, NULL);
  mpq_sub(x, b[u], a[u]);
  mpq_sub(y, c[v], a[v]);
  mpq_mul(out, x, y);
  mpq_sub(x, b[v], a[v]);
  mpq_sub(y, c[u], a[u]);
  mpq_mul(x, x, y);
  mpq_sub(out, out, x);
  mpq_clears(x, y, NULL);
}

/* out := ((b - a) x (c - a)) . (d - a) */
static void
volume(mpq_t out, mpq_t a[3], mpq_t b[3], mpq_t c[3], mpq_t d[3])
{
  mpq_t n, x;

  mpq_inits(n, x, NULL);
  mpq_set_ui(out, 0, 1);
  for (int k = 0; k < 3; k++) {
    cross(n, k, a, b, c);
    mpq_sub(x, d[k], a[k]);
    mpq_mul(x, x, n);
    mpq_add(out, out, x);
  }
  mpq_clears(n, x, NULL);
}

static int
turn_reference(int axis, const sg_point *p[3])
{
  mpq_t q[3][3], area;

  for (int i = 0; i < 3; i++) {
    rational(q[i], p[i]);
  }
  mpq_init(area);
  cross(area, axis, q[0], q[1], q[2]);
  int sign = mpq_sgn(area);
  mpq_clear(area);
  for (int i = 0; i < 3; i++) {
    clear(q[i]);
  }
  return sign;
}

static int
orient3d_reference(const sg_point *p[4])
{
  mpq_t q[4][3], v;

  for (int i = 0; i < 4; i++) {
    rational(q[i], p[i]);
  }
  mpq_init(v);
  volume(v, q[0], q[1], q[2], q[3]);
  int sign = -mpq_sgn(v);
  mpq_clear(v);
  for (int i = 0; i < 4; i++) {
    clear(q[i]);
  }
  return sign;
}

static int
along_reference(const sg_point *p[4]) /* from, to, a, b */
{
  mpq_t q[4][3], sum, x, y;

  for (int i = 0; i < 4; i++) {
    rational(q[i], p[i]);
  }
  mpq_inits(sum, x, y, NULL);
  for (int k = 0; k < 3; k++) {
    mpq_sub(x, q[1][k], q[0][k]);
    mpq_sub(y, q[2][k], q[3][k]);
    mpq_mul(x, x, y);
    mpq_add(sum, sum, x);
  }
  int sign = mpq_sgn(sum);
  mpq_clears(sum, x, y, NULL);
  for (int i = 0; i < 4; i++) {
    clear(q[i]);
  }
  return sign;
}

/* ---- the tests ---------------------------------------------------------- */

static void
test_conventions(void)
{
  double a[3] = {0, 0, 0}, b[3] = {1, 0, 0}, c[3] = {0, 1, 0},
         below[3] = {0, 0, -1}, above[3] = {0, 0, 1};
  sg_point pa, pb, pc, pz, pd;

  CHECK("below is +1", sg_orient3d(a, b, c, below) == 1);
  CHECK("above is -1", sg_orient3d(a, b, c, above) == -1);
  CHECK("in the plane is 0", sg_orient3d(a, b, c, b) == 0);
  CHECK("left is +1", sg_orient2d(a, b, c) == 1);
  CHECK("right is -1", sg_orient2d(b, a, c) == -1);
  sg_point_set(&pa, a);
  sg_point_set(&pb, b);
  sg_point_set(&pc, c);
  sg_point_set(&pz, above);
  sg_point_set(&pd, below);
  CHECK("axis 2 sees x, y", sg_point_turn(2, &pa, &pb, &pc) == 1);
  CHECK("axis 0 sees y, z", sg_point_turn(0, &pa, &pc, &pz) == 1);
  CHECK("axis 1 sees z, x", sg_point_turn(1, &pa, &pz, &pb) == 1);
  CHECK("points as doubles", sg_point_orient3d(&pa, &pb, &pc, &pd) == 1);
  CHECK("a before b", sg_point_along(&pa, &pb, &pa, &pb) == -1);
  CHECK("b after a", sg_point_along(&pa, &pb, &pb, &pa) == 1);
  CHECK("compare", sg_point_compare(0, &pa, &pb) == -1 &&
                       sg_point_compare(1, &pa, &pb) == 0);
  double minus[3] = {-0.0, 0, 0};
  sg_point_set(&pa, minus);
  CHECK("-0.0 is never kept", !signbit(pa.p[0]));
}

static void
test_doubles(int family)
{
  unsigned bad2 = 0, bad3 = 0, bad_turn = 0, bad_along = 0, zeros = 0;

  for (int i = 0; i < CASES; i++) {
    double d[4][3];
    sg_point p[4];
    const sg_point *q[4] = {&p[0], &p[1], &p[2], &p[3]};
    points(family, d, 4);
    for (int j = 0; j < 4; j++) {
      sg_point_set(&p[j], d[j]);
    }
    int want = orient3d_reference(q);
    bad3 += sg_orient3d(d[0], d[1], d[2], d[3]) != want ||
            sg_orient3d(d[1], d[0], d[2], d[3]) != -want ||
            sg_orient3d(d[0], d[3], d[1], d[2]) != want;
    zeros += want == 0;
    bad_along += sg_point_along(q[0], q[1], q[2], q[3]) != along_reference(q);
    points(family, d, 3);
    for (int j = 0; j < 3; j++) {
      sg_point_set(&p[j], d[j]);
    }
    want = turn_reference(2, q);
    bad2 += sg_orient2d(d[0], d[1], d[2]) != want ||
            sg_orient2d(d[2], d[1], d[0]) != -want;
    for (int axis = 0; axis < 3; axis++) {
      bad_turn +=
          sg_point_turn(axis, q[0], q[1], q[2]) != turn_reference(axis, q);
    }
  }
  CHECK("orient3d", bad3 == 0);
  CHECK("orient2d", bad2 == 0);
  CHECK("turn", bad_turn == 0);
  CHECK("along", bad_along == 0);
  CHECK("the grid has zeros", family != 1 || zeros > CASES / 100);
}

/* |q - p| <= |q - neighbours of p|, and even where equal. */
static bool
is_nearest(mpq_srcptr q, double p)
{
  mpq_t x, here, there;
  bool nearest = !signbit(p) || p != 0;

  mpq_inits(x, here, there, NULL);
  mpq_set_d(x, p);
  mpq_sub(here, q, x);
  mpq_abs(here, here);
  for (int up = 0; up < 2; up++) {
    double other = nextafter(p, up ? INFINITY : -INFINITY);
    int exponent;
    mpq_set_d(x, other);
    mpq_sub(there, q, x);
    mpq_abs(there, there);
    int order = mpq_cmp(here, there);
    double m =
        fabs(p) < DBL_MIN ? p / DBL_TRUE_MIN : ldexp(frexp(p, &exponent), 53);
    nearest = nearest && (order < 0 || (order == 0 && fmod(m, 2) == 0));
  }
  mpq_clears(x, here, there, NULL);
  return nearest;
}

/* A made point has the nearest doubles, and rationals only if it is not them.
 */
static bool
is_rounded(const sg_point *p)
{
  mpq_t *q = sg_point_q(p), x;
  bool rounded = true, same = true;

  mpq_init(x);
  for (int k = 0; q && k < 3; k++) {
    mpq_set_d(x, p->p[k]);
    same = same && mpq_equal(x, q[k]);
    rounded = rounded && is_nearest(q[k], p->p[k]);
  }
  mpq_clear(x);
  return !q || (rounded && !same);
}

static void
test_rounding(void)
{
  unsigned bad = 0;
  mpq_t q;

  mpq_init(q);
  for (int i = 0; i < CASES; i++) {
    sg_point p;
    double x = unit();
    int shift = (int)(random64() % 2000) - 1080;
    mpq_set_d(q, x);
    if (i % 2) { /* half way between two doubles, or almost */
      mpq_t half;
      mpq_init(half);
      mpq_set_d(half, (nextafter(x, INFINITY) - x) / 2);
      mpq_add(q, q, half);
      mpq_set_d(half, i % 4 == 1 ? 0 : ldexp(unit(), -200));
      mpq_add(q, q, half);
      mpq_clear(half);
    } else {
      mpq_set_si(q, (long)(random64() >> 1), (random64() >> 2) + 1);
      mpq_canonicalize(q);
    }
    if (shift >= 0) {
      mpq_mul_2exp(q, q, (mp_bitcnt_t)shift);
    } else {
      mpq_div_2exp(q, q, (mp_bitcnt_t)-shift);
    }
    if (!sg_point_set_q(&p, q, q, q)) {
      bad++;
      continue;
    }
    bad += !is_nearest(q, p.p[0]);
    sg_point_clear(&p);
  }
  CHECK("positions are rounded to nearest", bad == 0);
  mpq_set_ui(q, 1, 1);
  mpq_mul_2exp(q, q, 1024);
  sg_point p;
  CHECK("beyond the doubles is refused", !sg_point_set_q(&p, q, q, q));
  mpq_set_d(q, 0.1);
  CHECK("a double is kept as one", sg_point_set_q(&p, q, q, q) && !p.exactly);
  mpq_clear(q);
}

/* Made points lie where they must; then the signs of made points, near and on
 * things, against rationals. */
static void
test_constructions(int family)
{
  unsigned bad_on = 0, bad_sign = 0, bad_round = 0, made = 0;

  for (int i = 0; i < CASES / 8; i++) {
    double d[9][3];
    sg_point p[9], lpi, ll, tpi;
    const sg_point *q[9];
    points(family, d, 9);
    for (int j = 0; j < 9; j++) {
      sg_point_set(&p[j], d[j]);
      q[j] = &p[j];
    }
    const sg_point *plane[3][3] = {
        {q[0], q[1], q[2]}, {q[3], q[4], q[5]}, {q[6], q[7], q[8]}};
    if (!sg_point_lpi(&lpi, q[0], q[1], q[2], q[3], q[4])) {
      continue;
    }
    if (!sg_point_ll(&ll, 2, q[0], q[1], q[5], q[6])) {
      sg_point_clear(&lpi);
      continue;
    }
    if (!sg_point_tpi(&tpi, (const sg_point *const(*)[3])plane)) {
      sg_point_clear(&lpi);
      sg_point_clear(&ll);
      continue;
    }
    made++;
    bad_on += sg_point_orient3d(q[2], q[3], q[4], &lpi) != 0 ||
              sg_point_turn(0, q[0], q[1], &lpi) != 0 ||
              sg_point_turn(1, q[0], q[1], &lpi) != 0 ||
              sg_point_turn(2, q[0], q[1], &lpi) != 0;
    bad_on += sg_point_turn(2, q[0], q[1], &ll) != 0 ||
              sg_point_turn(2, q[5], q[6], &ll) != 0 ||
              sg_point_turn(0, q[0], q[1], &ll) != 0;
    for (int j = 0; j < 3; j++) {
      bad_on +=
          sg_point_orient3d(plane[j][0], plane[j][1], plane[j][2], &tpi) != 0;
    }
    sg_point rounded; /* next to the exact point: the hardest neighbour */
    sg_point_set(&rounded, lpi.p);
    const sg_point *mixed[4] = {&lpi, &ll, q[7], &rounded};
    bad_sign += sg_point_orient3d(mixed[0], mixed[1], mixed[2], mixed[3]) !=
                orient3d_reference(mixed);
    bad_sign += sg_point_along(mixed[0], mixed[1], mixed[2], mixed[3]) !=
                along_reference(mixed);
    for (int axis = 0; axis < 3; axis++) {
      const sg_point *t[3] = {&lpi, &rounded, &tpi};
      bad_sign +=
          sg_point_turn(axis, t[0], t[1], t[2]) != turn_reference(axis, t);
    }
    bad_round += !is_rounded(&lpi) || !is_rounded(&ll) || !is_rounded(&tpi);
    sg_point copy;
    sg_point_copy(&copy, &lpi);
    bad_on += !sg_point_equal(&copy, &lpi);
    sg_point_clear(&copy);
    sg_point_clear(&lpi);
    sg_point_clear(&ll);
    sg_point_clear(&tpi);
  }
  CHECK("made points lie on what they came from", bad_on == 0);
  CHECK("signs of made points", bad_sign == 0);
  CHECK("made points are rounded to nearest", bad_round == 0);
  CHECK("points were made", made > CASES / 32);
}

static void
test_none(void)
{
  double d[5][3] = {{0, 0, 1}, {1, 0, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  sg_point p[5], out;

  for (int i = 0; i < 5; i++) {
    sg_point_set(&p[i], d[i]);
  }
  CHECK("a line beside a plane",
        !sg_point_lpi(&out, &p[0], &p[1], &p[2], &p[3], &p[4]));
  CHECK("parallel lines", !sg_point_ll(&out, 2, &p[0], &p[1], &p[2], &p[3]));
}

/* Each predicate has its own count. */
static void
test_counts(void)
{
  uint64_t before[SG_EXACT_QUESTIONS], sum = 0;
  const double tiny = 1e-300;

  for (int i = 0; i < SG_EXACT_QUESTIONS; i++) {
    before[i] = sg_exact_fallbacks_of((sg_exact_question)i);
  }
  sg_orient2d((double[2]){0, 0}, (double[2]){tiny, tiny},
              (double[2]){2 * tiny, 2 * tiny});
  for (int i = 0; i < SG_EXACT_QUESTIONS; i++) {
    uint64_t now = sg_exact_fallbacks_of((sg_exact_question)i);

    CHECK("one fall-back, of the one that was asked",
          now - before[i] == (i == SG_ASKED_ORIENT2D));
    sum += now;
  }
  CHECK("all of them", sum == sg_exact_fallbacks());
}

/* Doubles of no great range need no rationals, also in one plane or nearly. */
static void
test_no_fall_back(void)
{
  uint64_t before = sg_exact_fallbacks();
  uint32_t state = 5;
  int zeros = 0;

  for (int i = 0; i < 20000; i++) {
    double p[4][3];

    for (int k = 0; k < 12; k++) {
      p[k / 3][k % 3] = 0.1 * check_below(&state, 5) * (1 + 1e-16 * (k == 7));
    }
    zeros += sg_orient3d(p[0], p[1], p[2], p[3]) == 0;
    zeros += sg_orient2d(p[0], p[1], p[2]) == 0;
  }
  CHECK("many are in one plane", zeros > 4000);
  CHECK("and nobody asked for rationals", sg_exact_fallbacks() == before);
}

/* The same counts through the functions of the doors. */
static void
test_counts_told(void)
{
  sg_exact_counts counts = {0};
  size_t n = 0;
  sg_call call;

  sg_call_open(&call, NULL, NULL);
  CHECK("fall-backs",
        sg_door_exact_fallbacks(&call, &n) && n == sg_exact_fallbacks());
  CHECK("of each", sg_door_exact_statistics(&call, &counts));
  CHECK("add up", counts.orient2d + counts.orient3d + counts.turn +
                          counts.side + counts.along + counts.compare ==
                      n);
  sg_call_close(&call);
}

/* ---- memory ---- */

/* Each question that needs whole numbers, and each point that is made. */
static void
ask_all(const sg_point p[6])
{
  const sg_point *const plane[3][3] = {
      {&p[0], &p[1], &p[2]}, {&p[0], &p[1], &p[3]}, {&p[0], &p[2], &p[3]}};
  sg_point out, copy;

  (void)sg_point_orient3d(&p[0], &p[1], &p[2], &p[4]);
  for (int axis = 0; axis < 3; axis++) {
    (void)sg_point_turn(axis, &p[0], &p[1], &p[4]);
    (void)sg_point_compare(axis, &p[4], &p[5]);
    if (sg_point_ll(&out, axis, &p[0], &p[1], &p[2], &p[5])) {
      (void)sg_point_compare(axis, &out, &p[4]);
      sg_point_clear(&out);
    }
  }
  (void)sg_point_along(&p[0], &p[1], &p[4], &p[5]);
  (void)sg_point_along(&p[0], &p[1], &p[4], &p[4]);
  (void)sg_point_equal(&p[4], &p[5]);
  if (sg_point_lpi(&out, &p[3], &p[4], &p[0], &p[1], &p[2])) {
    sg_point_copy(&copy, &out);
    (void)sg_point_orient3d(&copy, &p[1], &p[2], &out);
    sg_point_clear(&copy);
    sg_point_clear(&out);
  }
  if (sg_point_tpi(&out, plane)) {
    sg_point_clear(&out);
  }
}

/* Points of one plane, and one above it; two that are made, and rational. */
static void
test_memory(void)
{
  const double at[4][3] = {
      {0.1, 0.2, 0.3}, {1.1, 0.27, 0.9}, {0.13, 1.7, 0.35}, {0.4, 0.5, 9.7}};
  sg_point p[6];

  if (!is_counted()) {
    printf("skipped: blocks that stay: the checker has its own\n");
    return;
  }
  for (int i = 0; i < 4; i++) {
    sg_point_set(&p[i], at[i]);
  }
  const sg_point below = {{0.7, 0.3, -9.1}, NULL};
  CHECK("a point between",
        sg_point_lpi(&p[4], &p[3], &below, &p[0], &p[1], &p[2]) &&
            sg_point_ll(&p[5], 2, &p[0], &p[1], &p[2], &p[3]));
  ask_all(p);
  uint64_t before = sg_exact_fallbacks();
  living = 0;
  counting = true;
  ask_all(p);
  counting = false;
  CHECK("nothing is kept", living == 0);
  CHECK("whole numbers were needed", sg_exact_fallbacks() > before + 1);
  for (int i = 0; i < 6; i++) {
    sg_point_clear(&p[i]);
  }
}

int
main(void)
{
  spare_gmp();
  test_memory();
  test_conventions();
  test_none();
  test_rounding();
  for (int family = 0; family < FAMILIES; family++) {
    uint64_t before = sg_exact_fallbacks();
    test_doubles(family);
    if (family < 5) {
      test_constructions(family);
    }
    CHECK("fall-backs are counted",
          family == 1 || sg_exact_fallbacks() > before);
  }
  test_counts();
  test_no_fall_back();
  test_counts_told();
  return check_report();
}
