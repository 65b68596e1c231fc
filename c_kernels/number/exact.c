/* exact.c -- exact signs and exact points: see exact.h.
 *
 * Layer: kernel. Three stages, each exact when it answers:
 *   1. doubles with a bound of the rounding error;
 *   2. for double points: error-free sums and products of doubles (so that
 *      grids and axis-parallel models, where zeros are common, stay fast); for
 *      a plane of points whose differences are not exact, twice the digits with
 *      a bound before that;
 *   3. integers: all points of the question times one common denominator.
 * Stage 3 is counted. Source of the idea of 1 and 2: J. R. Shewchuk, Adaptive
 * precision floating-point arithmetic, 1997, sections 2 and 4.
 */
#include "exact.h"
#include "bounded_double.h"
#include "integers.h"

#include <float.h>
#include <math.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdlib.h>

#if defined(__FAST_MATH__)
#error "exact.c must not be compiled with fast-math"
#endif

static const double UNIT = DBL_EPSILON / 2; /* 2^-53: half an ulp of 1 */
static atomic_uint_fast64_t fallbacks[SG_EXACT_QUESTIONS];

uint64_t
sg_exact_fallbacks_of(sg_exact_question question)
{
  return atomic_load_explicit(&fallbacks[question], memory_order_relaxed);
}

uint64_t
sg_exact_fallbacks(void)
{
  uint64_t sum = 0;

  for (int i = 0; i < SG_EXACT_QUESTIONS; i++) {
    sum += sg_exact_fallbacks_of((sg_exact_question)i);
  }
  return sum;
}

static void
count_fallback(sg_exact_question question)
{
  atomic_fetch_add_explicit(&fallbacks[question], 1, memory_order_relaxed);
}

static int
sign(double x)
{
  return (x > 0) - (x < 0);
}

/* ---- stage 2: error-free transformations ------------------------------- */

/* A number as hi + lo, lo at most half a unit in the last place of hi. */
typedef struct pair {
  double hi, lo;
} pair;

/* Differences may be multiplied three at a time without overflow and without
 * losing low bits to underflow. */
static bool
is_in_range(double x)
{
  double size = fabs(x);

  return size == 0 || (size > 1e-80 && size < 1e80);
}

static bool
in_range(const double *x, int n)
{
  for (int i = 0; i < n; i++) {
    if (!is_in_range(x[i])) {
      return false;
    }
  }
  return true;
}

static bool
pairs_in_range(const pair *x, int n)
{
  for (int i = 0; i < n; i++) {
    if (!is_in_range(x[i].hi) || !is_in_range(x[i].lo)) {
      return false;
    }
  }
  return true;
}

/* Whether all are doubles. */
static bool
are_doubles(const pair *x, int n)
{
  for (int i = 0; i < n; i++) {
    if (x[i].lo != 0) {
      return false;
    }
  }
  return true;
}

/* a - b, exactly. */
static pair
exact_difference(double a, double b)
{
  pair d;

  sg_two_sum(a, -b, &d.hi, &d.lo);
  return d;
}

static pair
negative(pair x)
{
  return (pair){-x.hi, -x.lo};
}

/* The sign of a*b - c*d: rounding keeps order, so unequal roundings decide,
 * and equal ones leave it to the tails. */
static int
sign_of_minor(double a, double b, double c, double d)
{
  double lh, ll, rh, rl;

  sg_two_product(a, b, &lh, &ll);
  sg_two_product(c, d, &rh, &rl);
  return lh != rh ? sign(lh - rh) : (ll > rl) - (ll < rl);
}

/* Adds x to an expansion (components growing in size, not overlapping, none of
 * them 0). */
static int
grow(double *sum, int n, double x)
{
  int m = 0;

  if (x == 0) {
    return n;
  }
  for (int i = 0; i < n; i++) {
    double lo;
    sg_two_sum(x, sum[i], &x, &lo);
    if (lo != 0) {
      sum[m++] = lo;
    }
  }
  if (x != 0) {
    sum[m++] = x;
  }
  return m;
}

/* Adds (a * b) * c to an expansion. */
static int
grow_doubles(double *sum, int n, double a, double b, double c)
{
  double hi, lo, p, q;

  sg_two_product(a, b, &hi, &lo);
  sg_two_product(lo, c, &p, &q);
  n = grow(sum, grow(sum, n, q), p);
  sg_two_product(hi, c, &p, &q);
  return grow(sum, grow(sum, n, q), p);
}

enum {
  OF_PRODUCT = 2 * 2 * 2 * 4
}; /* components that a product adds at most */

static int
grow_product(double *sum, int n, pair a, pair b, pair c)
{
  const double x[2] = {a.hi, a.lo}, y[2] = {b.hi, b.lo}, z[2] = {c.hi, c.lo};

  for (int i = 0; i < 8; i++) {
    double of_a = x[i & 1], of_b = y[i >> 1 & 1], of_c = z[i >> 2];

    if (of_a != 0 && of_b != 0 && of_c != 0) {
      n = grow_doubles(sum, n, of_a, of_b, of_c);
    }
  }
  return n;
}

/* The sign of d[0]*d[3] - d[1]*d[2]. */
static int
sign_of_turn(const pair d[4])
{
  double sum[2 * OF_PRODUCT];
  int n = 0;

  if (are_doubles(d, 4)) {
    return sign_of_minor(d[0].hi, d[3].hi, d[1].hi, d[2].hi);
  }
  n = grow_product(sum, n, d[0], d[3], (pair){1, 0});
  n = grow_product(sum, n, negative(d[1]), d[2], (pair){1, 0});
  return n ? sign(sum[n - 1]) : 0;
}

/* The sign of the determinant with rows d, d+3, d+6. */
static int
sign_of_determinant(const pair d[9])
{
  double sum[6 * OF_PRODUCT];
  int n = 0;

  n = grow_product(sum, n, d[0], d[4], d[8]);
  n = grow_product(sum, n, negative(d[0]), d[5], d[7]);
  n = grow_product(sum, n, d[1], d[5], d[6]);
  n = grow_product(sum, n, negative(d[1]), d[3], d[8]);
  n = grow_product(sum, n, d[2], d[3], d[7]);
  n = grow_product(sum, n, negative(d[2]), d[4], d[6]);
  return n ? sign(sum[n - 1]) : 0;
}

/* ---- stage 2 for any doubles: twice the digits ------------------------- */

static pair
pair_sum(pair x, pair y)
{
  double s, t, lo;

  sg_two_sum(x.hi, y.hi, &s, &t);
  sg_two_sum(s, t + (x.lo + y.lo), &s, &lo);
  return (pair){s, lo};
}

static pair
pair_product(pair x, pair y)
{
  double h, l;
  pair p;

  sg_two_product(x.hi, y.hi, &h, &l);
  sg_two_sum(h, l + (x.hi * y.lo + x.lo * y.hi), &p.hi, &p.lo);
  return p;
}

/* x * y - z * w */
static pair
pair_minor(pair x, pair y, pair z, pair w)
{
  return pair_sum(pair_product(x, y), negative(pair_product(z, w)));
}

static bool
is_same_row(const double *a, const double *b)
{
  return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

/* The sign of the determinant with rows x, x+3, x+6, of numbers in range. Each
 * product and sum is wrong by less than 2^-100 of its terms' sizes, so that the
 * whole is by less than 2^-95 of theirs. 2: undecided. */
static int
sign_of_pairs(const pair x[9])
{
  pair det = {0, 0};
  double size = 0;

  for (int r = 0; r < 3; r++) {
    int p = 3 * ((r + 1) % 3), q = 3 * ((r + 2) % 3);
    pair minor = pair_minor(x[p], x[q + 1], x[q], x[p + 1]);

    det = pair_sum(det, pair_product(minor, x[3 * r + 2]));
    size += (fabs(x[p].hi * x[q + 1].hi) + fabs(x[q].hi * x[p + 1].hi)) *
            fabs(x[3 * r + 2].hi);
  }
  return fabs(det.hi) > 0x1p-95 * size ? sign(det.hi) : 2;
}

/* ---- stage 3: integers -------------------------------------------------- */

/* The determinant of the rows (x, y, w) has the sign of the turn. */
static int
turn_exactly(sg_exact_question question, int axis, const sg_point *a,
             const sg_point *b, const sg_point *c)
{
  const sg_point *point[3] = {a, b, c};
  mpz_t room[3][3], minor, det;
  mpz_srcptr of[3][3];

  count_fallback(question);
  for (int i = 0; i < 3; i++) {
    sg_integers_init3(room[i]);
    sg_integers_of_two(point[i], (axis + 1) % 3, (axis + 2) % 3, room[i],
                       of[i]);
  }
  mpz_init2(minor, 2 * SG_INTEGER_BITS);
  mpz_init2(det, 2 * SG_INTEGER_BITS);
  for (int i = 0; i < 3; i++) {
    mpz_srcptr *k = of[(i + 1) % 3], *l = of[(i + 2) % 3];

    mpz_mul(minor, k[0], l[1]);
    mpz_submul(minor, l[0], k[1]);
    mpz_addmul(det, minor, of[i][2]);
  }
  int answer = mpz_sgn(det);

  mpz_clear(det);
  mpz_clear(minor);
  for (int i = 0; i < 3; i++) {
    sg_integers_clear3(room[i]);
  }
  return answer;
}

static int
orient3d_exactly(sg_exact_question question, const sg_point *a,
                 const sg_point *b, const sg_point *c, const sg_point *d)
{
  const sg_point *point[4] = {a, b, c, d};
  mpz_t room[4][3], n[3], s[3], t[3], det;
  sg_integers in;

  count_fallback(question);
  sg_integers_open(&in, room, point, 4);
  sg_integers_init3(n);
  sg_integers_init3(s);
  sg_integers_init3(t);
  mpz_init(det);
  sg_integers_normal(n, in.x[0], in.x[1], in.x[2], s, t);
  sg_integers_subtract(s, in.x[3], in.x[0]);
  sg_integers_dot(det, n, s);
  int answer = -mpz_sgn(det); /* above the plane, where n points, is -1 */
  mpz_clear(det);
  sg_integers_clear3(t);
  sg_integers_clear3(s);
  sg_integers_clear3(n);
  sg_integers_close(&in);
  return answer;
}

static int
along_exactly(const sg_point *from, const sg_point *to, const sg_point *a,
              const sg_point *b)
{
  const sg_point *point[4] = {from, to, a, b};
  mpz_t room[4][3], s[3], t[3], product;
  sg_integers in;

  count_fallback(SG_ASKED_ALONG);
  sg_integers_open(&in, room, point, 4);
  sg_integers_init3(s);
  sg_integers_init3(t);
  mpz_init(product);
  sg_integers_subtract(s, in.x[2], in.x[3]);
  sg_integers_subtract(t, in.x[1], in.x[0]);
  sg_integers_dot(product, s, t);
  int answer = mpz_sgn(product);
  mpz_clear(product);
  sg_integers_clear3(t);
  sg_integers_clear3(s);
  sg_integers_close(&in);
  return answer;
}

/* ---- signs of doubles --------------------------------------------------- */

static sg_point
plain(double x, double y, double z)
{
  return (sg_point){{x, y, z}, NULL};
}

/* Stages 2 and 3 of sg_orient2d(). */
static int
orient2d_carefully(const double a[2], const double b[2], const double c[2])
{
  const pair d[4] = {exact_difference(a[0], c[0]), exact_difference(a[1], c[1]),
                     exact_difference(b[0], c[0]),
                     exact_difference(b[1], c[1])};

  if (pairs_in_range(d, 4)) {
    return sign_of_turn(d);
  }
  sg_point p = plain(a[0], a[1], 0), q = plain(b[0], b[1], 0),
           r = plain(c[0], c[1], 0);
  return turn_exactly(SG_ASKED_ORIENT2D, 2, &p, &q, &r);
}

int
sg_orient2d(const double a[2], const double b[2], const double c[2])
{
  double l = (a[0] - c[0]) * (b[1] - c[1]), r = (a[1] - c[1]) * (b[0] - c[0]);
  double det = l - r;
  double bound = (3 + 16 * UNIT) * UNIT * (fabs(l) + fabs(r)) + DBL_MIN;

  return fabs(det) > bound && isfinite(det) ? sign(det)
                                            : orient2d_carefully(a, b, c);
}

/* The sign where two of four points differ along one axis only: there it is
 * that of a turn seen along this axis. 2: no two do. */
static int
orient3d_along(const double *const point[4])
{
  /* Two points, and the others in the order of an even permutation. */
  static const int order[6][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2},
                                  {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}};

  for (int i = 0; i < 18; i++) {
    const int *of = order[i / 3];
    const double *p = point[of[0]], *q = point[of[1]], *r = point[of[2]],
                 *s = point[of[3]];
    int u = (i + 1) % 3, v = (i + 2) % 3;

    if (p[u] == q[u] && p[v] == q[v]) {
      return sign(p[i % 3] - q[i % 3]) * sg_orient2d((double[2]){p[u], p[v]},
                                                     (double[2]){r[u], r[v]},
                                                     (double[2]){s[u], s[v]});
    }
  }
  return 2;
}

/* Stages 2 and 3 of sg_orient3d(). Points in one place need neither. */
static int
orient3d_carefully(const double a[3], const double b[3], const double c[3],
                   const double d[3])
{
  const double *const point[4] = {a, b, c, d};
  double rounded[9];
  pair x[9];
  int answer;

  if (is_same_row(a, d) || is_same_row(b, d) || is_same_row(c, d) ||
      is_same_row(a, b) || is_same_row(b, c) || is_same_row(c, a)) {
    return 0;
  }
  if ((answer = orient3d_along(point)) != 2) {
    return answer;
  }
  for (int i = 0; i < 9; i++) {
    x[i] = exact_difference(point[i / 3][i % 3], d[i % 3]);
    rounded[i] = x[i].hi;
  }
  if (in_range(rounded, 9) && !are_doubles(x, 9)) {
    answer = sign_of_pairs(x);
  }
  if (answer == 2 && pairs_in_range(x, 9)) {
    answer = sign_of_determinant(x);
  }
  if (answer != 2) {
    return answer;
  }
  sg_point p = plain(a[0], a[1], a[2]), q = plain(b[0], b[1], b[2]),
           r = plain(c[0], c[1], c[2]), s = plain(d[0], d[1], d[2]);
  return orient3d_exactly(SG_ASKED_ORIENT3D, &p, &q, &r, &s);
}

int
sg_orient3d(const double a[3], const double b[3], const double c[3],
            const double d[3])
{
  double m[9] = {a[0] - d[0], a[1] - d[1], a[2] - d[2],
                 b[0] - d[0], b[1] - d[1], b[2] - d[2],
                 c[0] - d[0], c[1] - d[1], c[2] - d[2]};
  double bc = m[3] * m[7], cb = m[6] * m[4], ca = m[6] * m[1], ac = m[0] * m[7],
         ab = m[0] * m[4], ba = m[3] * m[1];
  double det = m[2] * (bc - cb) + m[5] * (ca - ac) + m[8] * (ab - ba);
  double size = (fabs(bc) + fabs(cb)) * fabs(m[2]) +
                (fabs(ca) + fabs(ac)) * fabs(m[5]) +
                (fabs(ab) + fabs(ba)) * fabs(m[8]);
  double bound = (7 + 56 * UNIT) * UNIT * size +
                 DBL_MIN * (4 + fabs(m[2]) + fabs(m[5]) + fabs(m[8]));

  if (fabs(det) > bound && isfinite(det)) {
    return sign(det);
  }
  return orient3d_carefully(a, b, c, d);
}

/* ---- signs of points ---------------------------------------------------- */

/* A double and a bound of its error; DBL_MIN covers underflow, and a bound
 * that is not finite never decides. */
typedef struct approx {
  double v, e;
} approx;

static inline approx
coordinate(const sg_point *p, int k)
{
  return (approx){p->p[k], p->exactly ? fabs(p->p[k]) * UNIT + DBL_MIN : 0};
}

static inline approx
minus(approx a, approx b)
{
  double v = a.v - b.v;

  return (approx){v, (a.e + b.e + fabs(v) * UNIT + DBL_MIN) * (1 + 8 * UNIT)};
}

static inline approx
times(approx a, approx b)
{
  double v = a.v * b.v;

  return (approx){v, (fabs(a.v) * b.e + fabs(b.v) * a.e + a.e * b.e +
                      fabs(v) * UNIT + DBL_MIN) *
                         (1 + 8 * UNIT)};
}

static inline approx
plus(approx a, approx b)
{
  return minus(a, (approx){-b.v, b.e});
}

/* 2: not decided. */
static inline int
sign_of_approx(approx a)
{
  return fabs(a.v) > a.e && isfinite(a.v) ? sign(a.v) : 2;
}

static inline approx
difference(const sg_point *a, const sg_point *b, int k)
{
  return minus(coordinate(a, k), coordinate(b, k));
}

int
sg_point_turn(int axis, const sg_point *a, const sg_point *b, const sg_point *c)
{
  int u = (axis + 1) % 3, v = (axis + 2) % 3;

  if (a == b || b == c || c == a) {
    return 0;
  }
  if (!a->exactly && !b->exactly && !c->exactly) {
    return sg_orient2d((const double[2]){a->p[u], a->p[v]},
                       (const double[2]){b->p[u], b->p[v]},
                       (const double[2]){c->p[u], c->p[v]});
  }
  int answer =
      sign_of_approx(minus(times(difference(a, c, u), difference(b, c, v)),
                           times(difference(a, c, v), difference(b, c, u))));
  return answer != 2 ? answer : turn_exactly(SG_ASKED_TURN, axis, a, b, c);
}

int
sg_point_orient3d(const sg_point *a, const sg_point *b, const sg_point *c,
                  const sg_point *d)
{
  if (!a->exactly && !b->exactly && !c->exactly && !d->exactly) {
    return sg_orient3d(a->p, b->p, c->p, d->p);
  }
  approx m[3][3];
  for (int k = 0; k < 3; k++) {
    m[0][k] = difference(a, d, k);
    m[1][k] = difference(b, d, k);
    m[2][k] = difference(c, d, k);
  }
  approx x = minus(times(m[1][0], m[2][1]), times(m[2][0], m[1][1]));
  approx y = minus(times(m[2][0], m[0][1]), times(m[0][0], m[2][1]));
  approx z = minus(times(m[0][0], m[1][1]), times(m[1][0], m[0][1]));
  int answer = sign_of_approx(
      plus(plus(times(m[0][2], x), times(m[1][2], y)), times(m[2][2], z)));
  return answer != 2 ? answer : orient3d_exactly(SG_ASKED_SIDE, a, b, c, d);
}

int
sg_point_along(const sg_point *from, const sg_point *to, const sg_point *a,
               const sg_point *b)
{
  if (a == b || (a->exactly == b->exactly && is_same_row(a->p, b->p))) {
    return 0;
  }
  approx sum = times(difference(a, b, 0), difference(to, from, 0));
  for (int k = 1; k < 3; k++) {
    sum = plus(sum, times(difference(a, b, k), difference(to, from, k)));
  }
  int answer = sign_of_approx(sum);
  return answer != 2 ? answer : along_exactly(from, to, a, b);
}

int
sg_point_compare(int axis, const sg_point *a, const sg_point *b)
{
  if (a->p[axis] != b->p[axis]) { /* rounding keeps order */
    return a->p[axis] < b->p[axis] ? -1 : 1;
  }
  if (a->exactly == b->exactly) { /* both null, or copies */
    return 0;
  }
  mpq_t other;
  count_fallback(SG_ASKED_COMPARE);
  mpq_init(other);
  mpq_set_d(other, a->p[axis]);
  mpq_t *of_a = sg_point_q(a), *of_b = sg_point_q(b);
  int answer = mpq_cmp(of_a ? of_a[axis] : other, of_b ? of_b[axis] : other);
  mpq_clear(other);
  return (answer > 0) - (answer < 0);
}

bool
sg_point_equal(const sg_point *a, const sg_point *b)
{
  return a == b ||
         (!a->exactly == !b->exactly && sg_point_compare(0, a, b) == 0 &&
          sg_point_compare(1, a, b) == 0 && sg_point_compare(2, a, b) == 0);
}
