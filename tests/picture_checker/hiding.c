/* hiding.c -- see hiding.h */
#include "hiding.h"

#include <math.h>

/* Doubles tell what is farther apart than this part of the coordinates. */
#define CLOSE 1e-9

/* And what is outside of a side by this part of their squares. */
#define OUTSIDE 1e-12

/* A line no farther behind a plane than this part of the size is in it: faces
 * of several triangles are flat only so far. */
#define IN_PLANE 1e-12

/* det(b - a, c - a) in the picture: positive if they run counter-clockwise. */
static void
area(const place *a, const place *b, const place *c, mpq_t out)
{
  mpq_t u, v, w;

  mpq_inits(u, v, w, NULL);
  mpq_sub(u, b->at[0], a->at[0]);
  mpq_sub(v, c->at[1], a->at[1]);
  mpq_mul(out, u, v);
  mpq_sub(u, b->at[1], a->at[1]);
  mpq_sub(v, c->at[0], a->at[0]);
  mpq_mul(w, u, v);
  mpq_sub(out, out, w);
  mpq_clears(u, v, w, NULL);
}

/* How far behind the triangle's plane p is, times its area. The depths at the
 * corners, weighed with the areas opposite to them, are the depth at p. */
static void
behind(const triangle *t, const place *p, mpq_t out)
{
  mpq_t weight, below;

  mpq_inits(weight, below, NULL);
  mpq_set_ui(out, 0, 1);
  for (int k = 0; k < 3; k++) {
    area(&t->corner[(k + 1) % 3], &t->corner[(k + 2) % 3], p, weight);
    mpq_sub(below, p->at[2], t->corner[k].at[2]);
    mpq_mul(below, below, weight);
    mpq_add(out, out, below);
  }
  mpq_clears(weight, below, NULL);
}

/* What area() says, nearly. */
static double
left_of(const place *a, const place *b, const place *c)
{
  const double *p = a->near, *q = b->near, *r = c->near;

  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

/* True only if the line is outside of one of the triangle's sides. */
static bool
is_beside(const triangle *t, double size, const line *l)
{
  for (int k = 0; k < 3; k++) {
    const place *p = &t->corner[k], *q = &t->corner[(k + 1) % 3];
    bool outside = true;
    for (int i = 0; i < 2; i++) {
      outside &= left_of(p, q, &l->end[i]) < -OUTSIDE * size * size;
    }
    if (outside) {
      return true;
    }
  }
  return false;
}

/* IN_PLANE, in what behind() says of a triangle. */
static void
in_plane(const triangle *t, double size, mpq_t out)
{
  const double *a = t->corner[0].near, *b = t->corner[1].near,
               *c = t->corner[2].near;
  double u[3], w[3], n[3];

  for (int k = 0; k < 3; k++) {
    u[k] = b[k] - a[k];
    w[k] = c[k] - a[k];
  }
  for (int k = 0; k < 3; k++) {
    int i = (k + 1) % 3, j = (k + 2) % 3;
    n[k] = u[i] * w[j] - u[j] * w[i];
  }
  mpq_set_d(out,
            IN_PLANE * size * sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]));
}

/* Keeps of from-to where a value that runs linearly from f0 at 0 to f1 at 1 is
 * positive (or zero: an end more or less). False: it is positive nowhere, and
 * not zero everywhere either. */
static bool
keep(const mpq_t f0, const mpq_t f1, mpq_t from, mpq_t to)
{
  int s0 = mpq_sgn(f0), s1 = mpq_sgn(f1);
  mpq_t t;

  if ((s0 < 0 && s1 <= 0) || (s0 <= 0 && s1 < 0)) {
    return false;
  }
  if (s0 < 0 || s1 < 0) {
    mpq_init(t);
    mpq_sub(t, f0, f1);
    mpq_div(t, f0, t);
    if (s0 < 0 && mpq_cmp(t, from) > 0) {
      mpq_set(from, t);
    } else if (s1 < 0 && mpq_cmp(t, to) < 0) {
      mpq_set(to, t);
    }
    mpq_clear(t);
  }
  return mpq_cmp(from, to) < 0;
}

static double
low(const triangle *t, int k)
{
  return fmin(t->corner[0].near[k],
              fmin(t->corner[1].near[k], t->corner[2].near[k]));
}

static double
high(const triangle *t, int k)
{
  return fmax(t->corner[0].near[k],
              fmax(t->corner[1].near[k], t->corner[2].near[k]));
}

/* True only if the line is beside the triangle, or before it. */
static bool
is_apart(const triangle *t, const line *l)
{
  const double *a = l->end[0].near, *b = l->end[1].near;

  for (int k = 0; k < 3; k++) {
    double least = fmin(a[k], b[k]), most = fmax(a[k], b[k]);
    double close =
        CLOSE * (fabs(least) + fabs(most) + fabs(low(t, k)) + fabs(high(t, k)));
    if (most < low(t, k) - close || (k < 2 && least > high(t, k) + close)) {
      return true;
    }
  }
  return false;
}

/* Adds what the triangle hides of the line. Its corners run counter-clockwise
 * in the picture. */
static void
hide(const triangle *t, double size, line *l)
{
  mpq_t from, to, f0, f1, close;
  bool some = true;

  mpq_inits(from, to, f0, f1, close, NULL);
  mpq_set_ui(to, 1, 1);
  for (int k = 0; k < 3 && some; k++) {
    const place *p = &t->corner[k], *q = &t->corner[(k + 1) % 3];
    area(p, q, &l->end[0], f0);
    area(p, q, &l->end[1], f1);
    some = keep(f0, f1, from, to);
  }
  if (some) {
    behind(t, &l->end[0], f0);
    behind(t, &l->end[1], f1);
    in_plane(t, size, close);
    mpq_sub(f0, f0, close);
    mpq_sub(f1, f1, close);
    if (keep(f0, f1, from, to)) {
      intervals_add(&l->hidden, from, to);
    }
  }
  mpq_clears(from, to, f0, f1, close, NULL);
}

/* Makes its corners run counter-clockwise; false: it is seen edge-on. */
static bool
turned(triangle *t)
{
  mpq_t whole;
  int sign;

  mpq_init(whole);
  area(&t->corner[0], &t->corner[1], &t->corner[2], whole);
  sign = mpq_sgn(whole);
  mpq_clear(whole);
  if (sign < 0) {
    place corner = t->corner[1];
    t->corner[1] = t->corner[2];
    t->corner[2] = corner;
  }
  return sign != 0;
}

void
hiding_find(scene *s)
{
  for (size_t i = 0; i < s->triangles; i++) {
    if (!turned(&s->triangle[i])) {
      continue;
    }
    for (size_t k = 0; k < s->lines; k++) {
      if (!is_apart(&s->triangle[i], &s->line[k]) &&
          !is_beside(&s->triangle[i], s->size, &s->line[k])) {
        hide(&s->triangle[i], s->size, &s->line[k]);
      }
    }
  }
  for (size_t k = 0; k < s->lines; k++) {
    intervals_join(&s->line[k].hidden);
    intervals_gaps(&s->line[k].hidden, &s->line[k].shown);
  }
}

bool
hiding_in_line(const line *a, const line *b, double size)
{
  bool in_line = true;
  mpq_t off;

  for (int k = 0; k < 2; k++) {
    double close = CLOSE * (fabs(a->end[0].near[k]) + fabs(a->end[1].near[k]));
    if (fmax(b->end[0].near[k], b->end[1].near[k]) <
            fmin(a->end[0].near[k], a->end[1].near[k]) - close ||
        fmin(b->end[0].near[k], b->end[1].near[k]) >
            fmax(a->end[0].near[k], a->end[1].near[k]) + close) {
      return false;
    }
  }
  for (int i = 0; i < 2; i++) {
    if (fabs(left_of(&a->end[0], &a->end[1], &b->end[i])) >
        OUTSIDE * size * size) {
      return false;
    }
  }
  mpq_init(off);
  for (int i = 0; i < 2 && in_line; i++) {
    area(&a->end[0], &a->end[1], &b->end[i], off);
    in_line = mpq_sgn(off) == 0;
  }
  mpq_clear(off);
  return in_line;
}

void
hiding_moved(const line *a, const line *b, const mpq_t t, mpq_t out)
{
  int k = mpq_equal(a->end[0].at[0], a->end[1].at[0]) ? 1 : 0;
  mpq_t x;

  mpq_init(x);
  mpq_sub(out, b->end[1].at[k], b->end[0].at[k]);
  mpq_mul(out, out, t);
  mpq_add(out, out, b->end[0].at[k]);
  mpq_sub(out, out, a->end[0].at[k]);
  mpq_sub(x, a->end[1].at[k], a->end[0].at[k]);
  mpq_div(out, out, x);
  mpq_clear(x);
}
