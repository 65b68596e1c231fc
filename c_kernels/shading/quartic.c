/* quartic.c -- see quartic.h. */
#include "quartic.h"

#include <math.h>

/* A bottom that is no lower is rounded: it is no well. */
#define NO_WELL 4e-14

/* Steps, at most: bisection alone needs no more. */
#define MOST_STEPS 64

/* Steps so small are the last. */
#define LEAST_STEP 4e-16

/* Where Newton's steps turn, they are so small, or there is no root. */
#define NEAR_STEP 1e-7

/* What rounding leaves of a sum of products, in parts of them. */
#define ROUNDED 1e-14

static double
value(const double *c, int n, double z)
{
  double sum = c[n];

  for (int k = n - 1; k >= 0; k--) {
    sum = sum * z + c[k];
  }
  return sum;
}

double
sg_root_between(const double *c, int n, double low, double high, bool rising)
{
  double way = rising ? 1.0 : -1.0, z = (low + high) / 2;

  if (!(way * value(c, n, low) < 0)) {
    return low;
  }
  if (!(way * value(c, n, high) > 0)) {
    return high;
  }
  for (int i = 0; i < MOST_STEPS; i++) {
    double f = c[n], slope = 0.0;

    for (int k = n - 1; k >= 0; k--) {
      slope = slope * z + f;
      f = f * z + c[k];
    }
    if (!(way * f < 0 || way * f > 0)) {
      return z;
    }
    *(way * f < 0 ? &low : &high) = z;
    double next = z - f / slope;
    next = next > low && next < high ? next : (low + high) / 2;
    if (fabs(next - z) <= LEAST_STEP) {
      return next;
    }
    z = next;
  }
  return z;
}

/* ---- wells ---- */

/* Where the quartic is steepest, between which its derivative falls. */
typedef struct wells {
  const double *c;
  double slope[4]; /* the derivative */
  double steep[2];
  bool two;
} wells;

static wells
wells_of(const double c[5])
{
  wells w = {.c = c};
  double b = c[3] / (4.0 * c[4]), square = b * b - c[2] / (6.0 * c[4]);

  for (int k = 0; k < 4; k++) {
    w.slope[k] = (k + 1) * c[k + 1];
  }
  if (square > 0) {
    double root = sqrt(square);
    w.steep[0] = -b - root;
    w.steep[1] = -b + root;
    w.two =
        value(w.slope, 3, w.steep[0]) > 0 && value(w.slope, 3, w.steep[1]) < 0;
  }
  return w;
}

/* The bottom of the nearer well, or of the only one. */
static double
near_bottom(const wells *w)
{
  return sg_root_between(w->slope, 3, -SG_QUARTIC_REACH,
                         w->two ? w->steep[0] : SG_QUARTIC_REACH, true);
}

static double
ridge(const wells *w)
{
  return sg_root_between(w->slope, 3, w->steep[0], w->steep[1], false);
}

static double
far_bottom(const wells *w)
{
  return sg_root_between(w->slope, 3, w->steep[1], SG_QUARTIC_REACH, true);
}

int
sg_quartic_count(const double c[5])
{
  wells w = wells_of(c);
  bool near = value(c, 4, near_bottom(&w)) < 0;

  if (!w.two) {
    return near ? 2 : 0;
  }
  bool far = value(c, 4, far_bottom(&w)) < 0;
  if (near && far) {
    return value(c, 4, ridge(&w)) > 0 ? 4 : 2;
  }
  return near || far ? 2 : 0;
}

/* ---- places ---- */

/* From the nearer well to the ridge. */
static double
near_out(const wells *w)
{
  double bottom = near_bottom(w);

  return value(w->c, 4, bottom) < 0
             ? sg_root_between(w->c, 4, bottom, ridge(w), true)
             : bottom;
}

static double
near_side(const wells *w, double bottom)
{
  return sg_root_between(w->c, 4, -SG_QUARTIC_REACH, bottom, false);
}

static double
first(const wells *w)
{
  double near = near_bottom(w), low = value(w->c, 4, near);

  if (low < -NO_WELL) {
    return near_side(w, near);
  }
  double far = far_bottom(w), other = value(w->c, 4, far);
  return other < 0     ? sg_root_between(w->c, 4, ridge(w), far, false)
         : low < other ? near
                       : far;
}

/* Between derivatives that are 0. */
static double
careful_place(const double c[5], sg_quartic_root root)
{
  wells w = wells_of(c);

  if (!w.two) {
    double bottom = near_bottom(&w);
    return root == SG_ROOT_NEAR_OUT
               ? sg_root_between(c, 4, bottom, SG_QUARTIC_REACH, true)
               : near_side(&w, bottom);
  }
  return root == SG_ROOT_FIRST     ? first(&w)
         : root == SG_ROOT_NEAR_IN ? near_side(&w, near_bottom(&w))
                                   : near_out(&w);
}

/* Newton's steps from z up to a root, where the quartic bends one way up to
 * `end` and so no step goes too far, if there is a root. False: there may be
 * none. */
static bool
step_up(const double c[5], double *z, double end)
{
  double at = *z, way = 0.0;

  for (int i = 0; i < MOST_STEPS; i++) {
    double f = (((c[4] * at + c[3]) * at + c[2]) * at + c[1]) * at + c[0];
    double slope =
        ((4.0 * c[4] * at + 3.0 * c[3]) * at + 2.0 * c[2]) * at + c[1];
    double step = -f / slope;

    if (fabs(step) <= LEAST_STEP) {
      *z = at;
      return true;
    }
    way = way == 0.0 ? (step > 0 ? 1.0 : -1.0) : way;
    if (step * way < 0) { /* it is there, but for rounding */
      *z = at;
      return fabs(step) <= NEAR_STEP;
    }
    at += step;
    if (!(at < end && at > -SG_QUARTIC_REACH)) {
      return false;
    }
  }
  return false;
}

static double
place(const double c[5], sg_quartic_root root)
{
  double b = c[3] / (4.0 * c[4]), square = b * b - c[2] / (6.0 * c[4]);
  double steep = square > 0 ? -b - sqrt(square) : SG_QUARTIC_REACH;
  double z = root == SG_ROOT_NEAR_OUT ? steep : -SG_QUARTIC_REACH;

  return (root == SG_ROOT_NEAR_OUT
              ? square > 0 && step_up(c, &z, -b + sqrt(square))
              : step_up(c, &z, steep))
             ? z
             : careful_place(c, root);
}

/* Seen from behind the last is the first. */
double
sg_quartic_place(const double c[5], sg_quartic_root root)
{
  static const sg_quartic_root behind[] = {[SG_ROOT_LAST] = SG_ROOT_FIRST,
                                           [SG_ROOT_FAR_IN] = SG_ROOT_NEAR_OUT,
                                           [SG_ROOT_FAR_OUT] = SG_ROOT_NEAR_IN};

  if (root == SG_ROOT_FIRST || root == SG_ROOT_NEAR_IN ||
      root == SG_ROOT_NEAR_OUT) {
    return place(c, root);
  }
  return -place((const double[]){c[0], -c[1], c[2], -c[3], c[4]}, behind[root]);
}

/* The two that meet are about the bottom, or the ridge, nearest to 0. */
sg_quartic_root
sg_quartic_before(const double c[5], sg_quartic_root root)
{
  wells w = wells_of(c);
  bool first = root == SG_ROOT_FIRST;

  if (w.two) {
    double near = fabs(value(c, 4, near_bottom(&w)));
    double far = fabs(value(c, 4, far_bottom(&w)));
    double between = fabs(value(c, 4, ridge(&w)));

    if (near < far && near < between) {
      return first ? SG_ROOT_FAR_IN : SG_ROOT_FAR_OUT;
    }
    if (far < between) {
      return first ? SG_ROOT_NEAR_IN : SG_ROOT_NEAR_OUT;
    }
  }
  return first ? SG_ROOT_NEAR_IN : SG_ROOT_FAR_OUT;
}

/* ---- the discriminant ---- */

double
sg_quartic_discriminant(const double c[5])
{
  double i = 12.0 * c[4] * c[0] - 3.0 * c[3] * c[1] + c[2] * c[2];
  double j = 72.0 * c[4] * c[2] * c[0] + 9.0 * c[3] * c[2] * c[1] -
             27.0 * (c[4] * c[1] * c[1] + c[0] * c[3] * c[3]) -
             2.0 * c[2] * c[2] * c[2];

  return 4.0 * i * i * i - j * j;
}

void
sg_polynomial_times(const sg_polynomial *a, const sg_polynomial *b,
                    sg_polynomial *out)
{
  sg_polynomial product = {.n = a->n + b->n};

  for (int i = 0; i <= a->n; i++) {
    for (int k = 0; k <= b->n; k++) {
      product.c[i + k] += a->c[i] * b->c[k];
    }
  }
  *out = product;
}

void
sg_polynomial_add(sg_polynomial *out, double part, const sg_polynomial *a)
{
  for (int k = 0; k <= a->n; k++) {
    out->c[k] += part * a->c[k];
  }
}

/* out += part a b d */
static void
add_product(sg_polynomial *out, double part, const sg_polynomial *a,
            const sg_polynomial *b, const sg_polynomial *d)
{
  sg_polynomial product;

  sg_polynomial_times(a, b, &product);
  sg_polynomial_times(&product, d, &product);
  sg_polynomial_add(out, part, &product);
}

/* Coefficients of u^k become Bernstein coefficients; the largest of them. */
static double
make_bernstein(sg_polynomial *p)
{
  double choose = 1.0, most = 0.0;

  for (int k = 0; k <= p->n; k++) {
    p->c[k] /= choose;
    most = fmax(most, fabs(p->c[k]));
    choose = choose * (p->n - k) / (k + 1);
  }
  return most;
}

void
sg_discriminant_along(const sg_polynomial c[5], sg_polynomial *out,
                      double *noise)
{
  static const sg_polynomial one = {.n = 0, .c = {1.0}};
  sg_polynomial i = {.n = 4}, j = {.n = 6};

  add_product(&i, 12.0, &c[4], &c[0], &one);
  add_product(&i, -3.0, &c[3], &c[1], &one);
  add_product(&i, 1.0, &c[2], &c[2], &one);
  add_product(&j, 72.0, &c[4], &c[2], &c[0]);
  add_product(&j, 9.0, &c[3], &c[2], &c[1]);
  add_product(&j, -27.0, &c[4], &c[1], &c[1]);
  add_product(&j, -27.0, &c[0], &c[3], &c[3]);
  add_product(&j, -2.0, &c[2], &c[2], &c[2]);
  *out = (sg_polynomial){.n = SG_POLYNOMIAL_MOST};
  add_product(out, 4.0, &i, &i, &i);
  add_product(out, -1.0, &j, &j, &one);
  (void)make_bernstein(out);
  double a = make_bernstein(&i), b = make_bernstein(&j);
  *noise = ROUNDED * (4.0 * a * a * a + b * b);
}
