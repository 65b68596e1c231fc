/* crossing.c -- where two slices change their order. Of straight ones, and of
 * a straight one and an arc, it is the root of a linear or quadratic equation.
 * An arc bends one way only: between two places it lies in the triangle of its
 * chord and its tangents there. Two arcs whose triangles are apart do not
 * cross; else the way between is halved, down to 1/256 dot. Of a torus is asked
 * whether another slice, or the strip in which it lies between two places,
 * meets it at all: on a straight line it is a quartic, the signs of whose
 * Bernstein coefficients tell.
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

/* A slice in one place. */
typedef struct arc_point {
  double x, z, slope;
  bool steep; /* no tangent: it ends there */
} arc_point;

/* A slice between two places: bounded by its chord and, on the side to which
 * it bends, by its tangents. */
typedef struct triangle {
  arc_point end[2];
  int bend; /* 1: below its chord (nearer); -1: above */
  double apex;
} triangle;

static arc_point
point_at(const sg_slice *s, double x)
{
  if (sg_slice_is_ring(s)) {
    return (arc_point){.x = x, .z = sg_ring_depth(s, x), .steep = true};
  }
  double at = x - s->x0;
  double square = (s->e * at + s->f) * at + s->g;
  double root = square > 0 ? sqrt(square) : 0.0;
  bool steep = root <= 1e-9 * (1.0 + fabs(s->f));

  return (arc_point){
      .x = x,
      .z = s->a + s->b * at + s->arc * root,
      .slope =
          s->b + (steep ? 0.0 : s->arc * (2.0 * s->e * at + s->f) / (2 * root)),
      .steep = steep};
}

static arc_point
point_of(const sg_slice *s, int32_t place)
{
  return point_at(s, place / 256.0);
}

static int
bend_of(const sg_slice *s)
{
  return s->arc * (4.0 * s->e * s->g - s->f * s->f) > 0 ? 1 : -1;
}

static triangle
bound(int bend, const arc_point *left, const arc_point *right)
{
  double turn = left->slope - right->slope;
  double x =
      (right->z - left->z + left->slope * left->x - right->slope * right->x) /
      turn;

  return (triangle){.end = {*left, *right},
                    .bend = bend,
                    .apex = left->steep    ? left->x
                            : right->steep ? right->x
                            : x > left->x && x < right->x
                                ? x
                                : (left->x + right->x) / 2.0};
}

/* The least (way 1) or most (-1) that the depth can be at x. */
static double
limit(const triangle *t, double x, int way)
{
  const arc_point *end = t->end;
  double tangent[2];

  if (t->bend != way) {
    return end[0].z +
           (end[1].z - end[0].z) * ((x - end[0].x) / (end[1].x - end[0].x));
  }
  for (int i = 0; i < 2; i++) {
    tangent[i] = end[i].steep ? -way * (double)INFINITY
                              : end[i].z + end[i].slope * (x - end[i].x);
  }
  return (tangent[0] > tangent[1]) == (way > 0) ? tangent[0] : tangent[1];
}

static bool
apart(const triangle *p, const triangle *q, double t)
{
  double x[4] = {p->end[0].x, p->end[1].x, p->apex, q->apex};

  for (int i = 0; i < 4; i++) {
    if (!(limit(q, x[i], 1) - limit(p, x[i], -1) > t)) {
      return false;
    }
  }
  return true;
}

bool
sg_slice_is_behind(const sg_slice *front, const sg_slice *s, double x1,
                   double x2, double t)
{
  if (!(sg_slice_depth(s, x1) - sg_slice_depth(front, x1) > t &&
        sg_slice_depth(s, x2) - sg_slice_depth(front, x2) > t)) {
    return false;
  }
  if (front->arc == 0 && s->arc == 0) {
    return true;
  }
  const arc_point p[2] = {point_at(front, x1), point_at(front, x2)};
  const arc_point q[2] = {point_at(s, x1), point_at(s, x2)};
  /* the chord of what is straight bounds it on both sides */
  triangle near = bound(front->arc == 0 ? 1 : bend_of(front), &p[0], &p[1]);
  triangle far = bound(s->arc == 0 ? -1 : bend_of(s), &q[0], &q[1]);
  return apart(&near, &far, t);
}

/* Whether q - p rises all the way, or falls: as an arc bends one way, its slope
 * is between those at its ends. */
static bool
goes_one_way(const triangle *p, const triangle *q)
{
  const arc_point *a = p->end, *b = q->end;

  if (a[0].steep || a[1].steep || b[0].steep || b[1].steep) {
    return false;
  }
  double low = fmin(b[0].slope, b[1].slope) - fmax(a[0].slope, a[1].slope);
  double high = fmax(b[0].slope, b[1].slope) - fmin(a[0].slope, a[1].slope);

  return low > 0 || high < 0;
}

/* Where q begins or ends to be t deeper than p. */
typedef struct arc_pair {
  const sg_slice *p, *q;
  int bend[2];
  double t;
} arc_pair;

static double
beyond(const arc_pair *of, int32_t x)
{
  return sg_slice_depth(of->q, x / 256.0) - sg_slice_depth(of->p, x / 256.0) -
         of->t;
}

/* The one place between x1 and x2, where it is `left` and `right` too deep: by
 * chords, every other time by halves. */
static void
note_change(reach *r, const arc_pair *of, int32_t x1, int32_t x2, double left,
            double right)
{
  bool begins = left <= 0;

  if (begins == (right <= 0)) {
    return;
  }
  for (int turn = 0; x2 - x1 > 1; turn++) {
    double chord = x1 + (x2 - x1) * (left / (left - right));
    int32_t x = turn % 3 == 2    ? halfway(x1, x2)
                : chord < x1 + 1 ? x1 + 1
                : chord > x2 - 1 ? x2 - 1
                                 : (int32_t)chord;
    double here = beyond(of, x);

    if (begins == (here <= 0)) {
      x1 = x;
      left = here;
    } else {
      x2 = x;
      right = here;
    }
  }
  note(r, (x1 + left / (left - right)) / 256.0);
}

/* The first place from x1 to x2, where p and q are `a` and `b`. */
static void
cross_arcs(reach *r, const arc_pair *of, int32_t x1, int32_t x2,
           const arc_point a[2], const arc_point b[2])
{
  if (r->found != r->x1) {
    return;
  }
  triangle p = bound(of->bend[0], &a[0], &a[1]);
  triangle q = bound(of->bend[1], &b[0], &b[1]);

  if (x2 - x1 == 1 || goes_one_way(&p, &q)) {
    note_change(r, of, x1, x2, b[0].z - a[0].z - of->t,
                b[1].z - a[1].z - of->t);
  } else if (!apart(&p, &q, of->t) && !apart(&q, &p, -of->t)) {
    int32_t x = halfway(x1, x2);
    arc_point m = point_of(of->p, x), n = point_of(of->q, x);

    cross_arcs(r, of, x1, x, (arc_point[]){a[0], m}, (arc_point[]){b[0], n});
    cross_arcs(r, of, x, x2, (arc_point[]){m, a[1]}, (arc_point[]){n, b[1]});
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

/* ---- a torus and another slice ---- */

/* Where another slice lies between two places: in depth, at both. */
typedef struct strip {
  double low[2], high[2];
} strip;

typedef struct ring_pair {
  const sg_slice *ring, *other;
  double shift;  /* the other one is looked at so much deeper */
  arc_pair pair; /* the two, in order */
} ring_pair;

/* 1: a torus is met nowhere between two places, straight; -1: all is in it; 0:
 * it may be met. Null: only that is asked; else the quartic. */
static int
meets(const sg_slice *ring, const arc_point end[2], const double z[2],
      double c[5])
{
  int above = 0, below = 0;

  sg_ring_along(ring->line, (double[]){end[0].x, z[0]},
                (double[]){end[1].x, z[1]}, c);
  for (int k = 0; k < 5; k++) {
    above += c[k] > 0;
    below += c[k] < 0;
  }
  return above == 5 ? 1 : below == 5 ? -1 : 0;
}

/* A slice of a torus does not leave a strip whose borders do not meet it. */
static double
ring_strays(const sg_slice *s, const arc_point end[2])
{
  double z = sg_ring_depth(s, (end[0].x + end[1].x) / 2), c[5];
  double off = 2.0 * fabs(z - (end[0].z + end[1].z) / 2) + 1e-9;
  const double low[2] = {end[0].z - off, end[1].z - off};
  const double high[2] = {end[0].z + off, end[1].z + off};

  return meets(s, end, low, c) != 0 && meets(s, end, high, c) != 0
             ? off
             : (double)INFINITY;
}

/* False: nothing is known. */
static bool
find_strip(const ring_pair *of, const arc_point end[2], strip *out)
{
  const sg_slice *s = of->other;
  double near = 0.0, far = 0.0;

  if (sg_slice_is_ring(s)) {
    near = far = ring_strays(s, end);
  } else if (s->arc != 0) {
    triangle t = bound(bend_of(s), &end[0], &end[1]);
    double chord = limit(&t, t.apex, -t.bend);
    double off = fabs(limit(&t, t.apex, t.bend) - chord);
    *(t.bend > 0 ? &near : &far) = off;
  }
  for (int i = 0; i < 2; i++) {
    out->low[i] = end[i].z - near + of->shift;
    out->high[i] = end[i].z + far + of->shift;
  }
  return isfinite(near) && isfinite(far);
}

/* Whether the quartic changes its sign once. */
static bool
changes_once(const double c[5])
{
  int changes = 0;

  for (int k = 1; k < 5; k++) {
    changes += (c[k - 1] < 0) != (c[k] < 0);
  }
  return changes == 1;
}

/* Where the one place is. */
static void
note_root(reach *r, const double c[5], const arc_point end[2])
{
  const double turned[5] = {c[4], c[3], c[2], c[1], c[0]};
  bool rising = c[0] < 0;
  bool before = (c[0] + c[1] + c[2] + c[3] + c[4] > 0) == rising;
  double u = before ? sg_root_between(c, 4, 0.0, 1.0, rising)
                    : sg_root_between(turned, 4, 0.0, 1.0, !rising);

  note(r, before ? (end[0].x + u * end[1].x) / (1.0 + u)
                 : (u * end[0].x + end[1].x) / (1.0 + u));
}

/* As cross_arcs(); `end` is of the other one. */
static void
cross_ring(reach *r, const ring_pair *of, int32_t x1, int32_t x2,
           const arc_point end[2])
{
  strip s;

  if (r->found != r->x1) {
    return;
  }
  if (find_strip(of, end, &s)) {
    double c[5];
    int met = meets(of->ring, end, s.low, c);

    if (of->other->arc == 0) {
      if (met != 0) {
        return;
      }
      if (changes_once(c)) {
        note_root(r, c, end);
        return;
      }
    } else if (met != 0 && meets(of->ring, end, s.high, c) == met) {
      double z = sg_ring_depth(of->ring, end[0].x);
      if (z < s.low[0] || z > s.high[0]) {
        return;
      }
    }
  }
  if (x2 - x1 == 1) {
    note_change(r, &of->pair, x1, x2, beyond(&of->pair, x1),
                beyond(&of->pair, x2));
    return;
  }
  int32_t x = halfway(x1, x2);
  arc_point m = point_of(of->other, x);
  cross_ring(r, of, x1, x, (arc_point[]){end[0], m});
  cross_ring(r, of, x, x2, (arc_point[]){m, end[1]});
}

static void
cross_rings(reach *r, const sg_slice *p, const sg_slice *q, double t)
{
  bool first = sg_slice_is_ring(p);
  const ring_pair of = {.ring = first ? p : q,
                        .other = first ? q : p,
                        .shift = first ? -t : t,
                        .pair = {.p = p, .q = q, .t = t}};
  const arc_point end[] = {point_of(of.other, r->x1),
                           point_of(of.other, r->x2)};

  cross_ring(r, &of, r->x1, r->x2, end);
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

  bool rings = sg_slice_is_ring(p) || sg_slice_is_ring(q);

  if ((p->surface == q->surface && (p->arc == q->arc || rings)) ||
      (p->round && p->leaf == q->leaf)) {
    return x1;
  }
  if (rings && middle > t) {
    cross_rings(&r, p, q, t);
  } else if (rings) {
    cross_together(&r, p, q, (double[2]){left, right}, t);
  } else if (p->arc == 0 && q->arc == 0) {
    cross_straight(&r, left, middle, right, t);
  } else if (left > t && right > t && middle > t && bend_apart(p, q)) {
    return x1;
  } else if (q->arc == 0 || p->arc == 0) {
    const sg_slice *line = p->arc == 0 ? p : q, *arc = p->arc == 0 ? q : p;
    cross_line(&r, line, arc, p->arc == 0 ? t : -t);
    if (middle <= t) {
      cross_line(&r, line, arc, p->arc == 0 ? -t : t);
    }
  } else if (middle > t) {
    const arc_pair pair = {p, q, {bend_of(p), bend_of(q)}, t};
    const arc_point of_p[] = {point_of(p, x1), point_of(p, x2)};
    const arc_point of_q[] = {point_of(q, x1), point_of(q, x2)};
    cross_arcs(&r, &pair, x1, x2, of_p, of_q);
  } else {
    cross_together(&r, p, q, (double[2]){left, right}, t);
  }
  return r.found;
}
