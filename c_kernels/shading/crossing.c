/* crossing.c -- where two slices change their order. Of straight ones, and of
 * a straight one and an arc, it is the root of a linear or quadratic equation.
 * An arc bends one way only: between two places it lies in the triangle of its
 * chord and its tangents there. Two arcs whose triangles are apart do not
 * cross; else the way between is halved, down to 1/256 dot.
 */
#include "shading_private.h"

#include <math.h>

/* Where the order is looked at, in 1/256 dot. */
typedef struct reach {
  int32_t x1, x2, found;
} reach;

/* A root at x dots: the nearest place, if it is between and the first one. */
static void
note(reach *r, double x)
{
  double place = floor(x * 256.0 + 0.5);

  if (place > r->x1 && place < r->x2 &&
      (r->found == r->x1 || place < r->found)) {
    r->found = (int32_t)place;
  }
}

/* Of two places that are not neighbours one between them. */
static int32_t
halfway(int32_t a, int32_t b)
{
  return (int32_t)(((int64_t)a + b) >> 1);
}

/* ---- straight slices ---- */

/* From `left` to `right` something is linear: where it is `wanted`. */
static void
note_linear(reach *r, double left, double right, double wanted)
{
  double part = (wanted - left) / (right - left);

  note(r, (r->x1 + part * (r->x2 - r->x1)) / 256.0);
}

static void
cross_straight(reach *r, double left, double middle, double right, double t)
{
  bool together = middle <= t;
  double end[2] = {left, right};

  for (int i = 0; i < 2; i++) {
    if (together ? fabs(end[i]) > t : end[i] <= t) {
      note_linear(r, left, right, together && end[i] < 0 ? -t : t);
    }
  }
}

/* ---- a straight one and an arc ---- */

/* Where the arc is `above` deeper than the straight slice. */
static void
cross_line(reach *r, const sg_slice *line, const sg_slice *arc, double above)
{
  double u = line->a + line->b * (arc->x0 - line->x0) - arc->a + above;
  double v = line->b - arc->b;
  double a = arc->e - v * v, b = (arc->f - 2.0 * u * v) / 2.0;
  double c = arc->g - u * u, square = b * b - a * c;

  if (square < 0) {
    return;
  }
  double big = -(b + (b < 0 ? -sqrt(square) : sqrt(square)));
  double root[2] = {big / a, c / big};

  for (int i = 0; i < 2; i++) {
    double t = root[i];
    if (isfinite(t) && arc->arc * (u + v * t) >= 0) {
      note(r, t + arc->x0);
    }
  }
}

/* ---- arcs ---- */

/* A slice between two places: bounded by its chord and, on the side to which
 * it bends, by its tangents. */
typedef struct triangle {
  double x[2], z[2], slope[2];
  bool steep[2]; /* no tangent: it ends there */
  int bend;      /* 1: below its chord (nearer); -1: above; 0: straight */
  double apex;
} triangle;

static void
find_apex(triangle *t)
{
  double turn = t->slope[0] - t->slope[1];
  double x =
      (t->z[1] - t->z[0] + t->slope[0] * t->x[0] - t->slope[1] * t->x[1]) /
      turn;

  t->apex = t->steep[0]                  ? t->x[0]
            : t->steep[1]                ? t->x[1]
            : x > t->x[0] && x < t->x[1] ? x
                                         : (t->x[0] + t->x[1]) / 2.0;
}

static triangle
bound(const sg_slice *s, const double x[2])
{
  triangle t = {.apex = x[0]};

  for (int i = 0; i < 2; i++) {
    double at = x[i] - s->x0, square = (s->e * at + s->f) * at + s->g;
    double root = square > 0 ? sqrt(square) : 0.0;

    t.x[i] = x[i];
    t.z[i] = s->a + s->b * at + s->arc * root;
    t.steep[i] = s->arc != 0 && root <= 1e-9 * (1.0 + fabs(s->f));
    t.slope[i] = s->b + (s->arc == 0 || t.steep[i]
                             ? 0.0
                             : s->arc * (2.0 * s->e * at + s->f) / (2 * root));
  }
  if (s->arc != 0) {
    double curved = s->arc * (4.0 * s->e * s->g - s->f * s->f);
    t.bend = curved > 0 ? 1 : -1;
    find_apex(&t);
  }
  return t;
}

/* The least (way 1) or most (-1) that the depth can be at x. */
static double
limit(const triangle *t, double x, int way)
{
  double tangent[2];

  if (t->bend != way) {
    return t->z[0] +
           (t->z[1] - t->z[0]) * ((x - t->x[0]) / (t->x[1] - t->x[0]));
  }
  for (int i = 0; i < 2; i++) {
    tangent[i] = t->steep[i] ? -way * (double)INFINITY
                             : t->z[i] + t->slope[i] * (x - t->x[i]);
  }
  return way > 0 ? fmax(tangent[0], tangent[1]) : fmin(tangent[0], tangent[1]);
}

static bool
apart(const triangle *p, const triangle *q, double t)
{
  double x[4] = {p->x[0], p->x[1], p->apex, q->apex};

  for (int i = 0; i < 4; i++) {
    if (!(limit(q, x[i], 1) - limit(p, x[i], -1) > t)) {
      return false;
    }
  }
  return true;
}

/* The first place from x1 to x2 where q begins or ends to be t deeper than p.
 */
static void
cross_arcs(reach *r, const sg_slice *p, const sg_slice *q, int32_t x1,
           int32_t x2, double t)
{
  double x[2] = {x1 / 256.0, x2 / 256.0};
  triangle a = bound(p, x), b = bound(q, x);

  if (r->found != r->x1 || apart(&a, &b, t) || apart(&b, &a, -t)) {
    return;
  }
  if (x2 - x1 > 1) {
    int32_t middle = halfway(x1, x2);
    cross_arcs(r, p, q, x1, middle, t);
    cross_arcs(r, p, q, middle, x2, t);
    return;
  }
  double left = b.z[0] - a.z[0] - t, right = b.z[1] - a.z[1] - t;

  if (left > 0 ? right <= 0 : right > 0) {
    note(r, x[0] + (x[1] - x[0]) * (left / (left - right)));
  }
}

/* Two arcs that lie together in the middle. */
static void
cross_together(reach *r, const sg_slice *p, const sg_slice *q,
               const double end[2], double t)
{
  for (int i = 0; i < 2; i++) {
    int32_t near = halfway(r->x1, r->x2), far = i == 0 ? r->x1 : r->x2;

    while (fabs(end[i]) > t && (far - near > 1 || near - far > 1)) {
      int32_t x = halfway(near, far);
      double d = sg_slice_depth(q, x / 256.0) - sg_slice_depth(p, x / 256.0);
      *(fabs(d) <= t ? &near : &far) = x;
    }
    if (fabs(end[i]) > t) {
      note(r, near / 256.0);
    }
  }
}

/* ---- all ---- */

/* Whether bends cannot bring them nearer than they are at the ends. */
static bool
bend_apart(const sg_slice *p, const sg_slice *q)
{
  double a = p->arc * (4.0 * p->e * p->g - p->f * p->f);
  double b = q->arc * (4.0 * q->e * q->g - q->f * q->f);

  return (p->arc == 0 || a > 0) && (q->arc == 0 || b <= 0);
}

int32_t
sg_slices_cross(const sg_active *a, const sg_active *b, int32_t x1, int32_t x2,
                double t)
{
  const sg_slice *p = a->slice, *q = b->slice;
  double left = b->left - a->left, middle = b->middle - a->middle;
  double right = b->right - a->right;
  reach r = {x1, x2, x1};

  if ((p->surface == q->surface && p->arc == q->arc) ||
      (p->round && p->leaf == q->leaf)) {
    return x1;
  }
  if (p->arc == 0 && q->arc == 0) {
    if (!(left > t && right > t && middle > t)) {
      cross_straight(&r, left, middle, right, t);
    }
  } else if (left > t && right > t && middle > t && bend_apart(p, q)) {
    return x1;
  } else if (q->arc == 0 || p->arc == 0) {
    const sg_slice *line = p->arc == 0 ? p : q, *arc = p->arc == 0 ? q : p;
    cross_line(&r, line, arc, p->arc == 0 ? t : -t);
    if (middle <= t) {
      cross_line(&r, line, arc, p->arc == 0 ? -t : t);
    }
  } else if (middle > t) {
    cross_arcs(&r, p, q, x1, x2, t);
  } else {
    cross_together(&r, p, q, (double[2]){left, right}, t);
  }
  return r.found;
}
