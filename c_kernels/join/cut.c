#include "cut.h"

#include "number/exact.h"

/* A mark on the line L that two planes share: a feature of one triangle, and
 * a stretch lo-hi of that triangle's plane that passes through L there, from
 * below (or on) the other plane to above (or on) it. Two such stretches tell
 * by one orient3d which of two marks comes first along L. */
typedef struct mark {
  sg_feature f;
  const double *lo, *hi;
} mark;

/* What of L lies in one triangle. */
typedef struct interval {
  mark start, end;
  sg_feature
      inside; /* of the points between: an edge that lies in L, or FACE */
} interval;

static int
next(int i)
{
  return (i + 1) % 3;
}

static int
previous(int i)
{
  return (i + 2) % 3;
}

static sg_feature
corner(int i)
{
  return (sg_feature)(SG_CORNER_0 + i);
}

static sg_feature
edge(int i)
{
  return (sg_feature)(SG_EDGE_0 + i);
}

/* Whether feature f lies on the closed edge i. */
static bool
on_edge(sg_feature f, int i)
{
  return f == corner(i) || f == edge(i) || f == corner(next(i));
}

int
sg_feature_edge(sg_feature f, sg_feature g)
{
  for (int i = 0; i < 3; i++) {
    if (on_edge(f, i) && on_edge(g, i)) {
      return i;
    }
  }
  return -1;
}

bool
sg_cut_is_point(const sg_cut *cut)
{
  return cut->end[0].f[0] == cut->end[1].f[0] &&
         cut->end[0].f[1] == cut->end[1].f[1];
}

int
sg_cut_along(const sg_cut *cut, int which)
{
  if (sg_cut_is_point(cut)) {
    return -1;
  }
  return sg_feature_edge(cut->end[0].f[which], cut->end[1].f[which]);
}

/* +1 above the plane of t (where t looks counter-clockwise), -1 below. */
static int
above(const double t[3][3], const double p[3])
{
  return -sg_orient3d(t[0], t[1], t[2], p);
}

static bool
is_at(const double p[3], const double q[3])
{
  return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

/* A corner that two triangles have in common. */
typedef struct shared {
  int of, t; /* which of each it is; -1: there is none */
} shared;

/* Which side of t's plane each corner of `of` is on: corners in common are in
 * it. *at: the last of these. */
static void
sides(const double t[3][3], const double of[3][3], int side[3], shared *at)
{
  *at = (shared){-1, -1};
  for (int i = 0; i < 3; i++) {
    int k = 0;

    while (k < 3 && !is_at(t[k], of[i])) {
      k++;
    }
    if (k < 3) {
      *at = (shared){i, k};
    }
    side[i] = k < 3 ? 0 : above(t, of[i]);
  }
}

/* A triangle has only that corner in the plane of the other, and the rest of it
 * on one side. */
static bool
only_touches(const int side[3], int corner)
{
  int i = (corner + 1) % 3, j = (corner + 2) % 3;

  return corner >= 0 && side[i] != 0 && side[i] == side[j];
}

static bool
all_zero(const int side[3])
{
  return side[0] == 0 && side[1] == 0 && side[2] == 0;
}

static bool
apart(const int side[3])
{
  return side[0] == side[1] && side[1] == side[2] && side[0] != 0;
}

/* The mark of feature f, on the stretch between corners i and j. */
static mark
mark_between(sg_feature f, const double t[3][3], const int side[3], int i,
             int j)
{
  bool up = side[i] < side[j];

  return (mark){f, up ? t[i] : t[j], up ? t[j] : t[i]};
}

/* Corner k is on the plane. */
static void
interval_at_corner(const double t[3][3], const int side[3], int k,
                   interval *out)
{
  int i = next(k), j = previous(k);
  mark at = mark_between(corner(k), t, side, k, i);
  mark across = mark_between(edge(i), t, side, i, j);

  out->inside = SG_FACE;
  if (side[i] == side[j]) {
    out->start = out->end = at;
  } else if (side[i] < side[j]) {
    out->start = across;
    out->end = at;
  } else {
    out->start = at;
    out->end = across;
  }
}

/* Only corner k is off the plane. */
static void
interval_on_edge(const double t[3][3], const int side[3], int k, interval *out)
{
  int i = next(k), j = previous(k);
  mark first = mark_between(corner(i), t, side, i, k);
  mark second = mark_between(corner(j), t, side, j, k);

  out->inside = edge(i);
  out->start = side[k] > 0 ? second : first;
  out->end = side[k] > 0 ? first : second;
}

/* No corner is on the plane; two edges cross it. */
static void
interval_across(const double t[3][3], const int side[3], interval *out)
{
  out->inside = SG_FACE;
  for (int i = 0; i < 3; i++) {
    mark at = mark_between(edge(i), t, side, i, next(i));

    if (side[i] < side[next(i)]) {
      out->start = at;
    } else if (side[i] > side[next(i)]) {
      out->end = at;
    }
  }
}

/* What of L lies in t, given t's sides of the other plane: from start to end
 * in the direction normal(t) x normal(other). (A counter-clockwise loop seen
 * with that direction to the right comes DOWN on the left, that is, rises
 * through the other plane there.) */
static void
line_in_triangle(const double t[3][3], const int side[3], interval *out)
{
  int zeros = 0, zero = 0, other = 0;

  for (int i = 0; i < 3; i++) {
    if (side[i] == 0) {
      zeros++;
      zero = i;
    } else {
      other = i;
    }
  }
  if (zeros == 0) {
    interval_across(t, side, out);
  } else if (zeros == 1) {
    interval_at_corner(t, side, zero, out);
  } else {
    interval_on_edge(t, side, other, out);
  }
}

/* -1 when mark p of the first triangle comes before mark q of the second in
 * the direction normal(first) x normal(second). */
static int
order(const mark *p, const mark *q)
{
  return sg_orient3d(p->lo, p->hi, q->lo, q->hi);
}

/* The feature of a triangle at a mark of the other one that is not before its
 * interval's near end: that of its `far` end where both are there (`order` is
 * 0), else that of the inside. */
static sg_feature
seen(const interval *in, int order_of_both, const mark *far)
{
  return order_of_both == 0 ? far->f : in->inside;
}

/* The common part of both intervals; false: none. */
static bool
meet(const interval *a, const interval *b, sg_cut *out)
{
  int first = order(&a->start, &b->end), last;

  if (first > 0 || (last = order(&a->end, &b->start)) < 0) {
    return false;
  }
  int starts = order(&a->start, &b->start), ends = order(&a->end, &b->end);

  out->end[0] =
      (sg_cut_end){{starts >= 0 ? a->start.f : seen(a, last, &a->end),
                    starts <= 0 ? b->start.f : seen(b, first, &b->end)}};
  out->end[1] = (sg_cut_end){{ends <= 0 ? a->end.f : seen(a, first, &a->start),
                              ends >= 0 ? b->end.f : seen(b, last, &b->start)}};
  return true;
}

/* ---- in one plane ---- */

static int
turn(int axis, const double a[3], const double b[3], const double c[3])
{
  int x = next(axis), y = previous(axis);

  return sg_orient2d((double[2]){a[x], a[y]}, (double[2]){b[x], b[y]},
                     (double[2]){c[x], c[y]});
}

int
sg_cut_axis(const double a[3][3])
{
  for (int axis = 2; axis >= 0; axis--) {
    if (turn(axis, a[0], a[1], a[2]) != 0) {
      return axis;
    }
  }
  return -1;
}

/* Where a point with these sides of the three edges lies (+1 inside); false:
 * outside. */
static bool
locate(const int side[3], sg_feature *out)
{
  *out = SG_FACE;
  for (int i = 0; i < 3; i++) {
    if (side[i] < 0) {
      return false;
    }
    if (side[i] == 0) {
      *out = side[next(i)] == 0       ? corner(next(i))
             : side[previous(i)] == 0 ? corner(i)
                                      : edge(i);
    }
  }
  return true;
}

/* A coordinate in which u and w differ, or -1. */
static int
widest(const double u[3], const double w[3])
{
  for (int c = 0; c < 3; c++) {
    if (u[c] != w[c]) {
      return c;
    }
  }
  return -1;
}

/* -1, 0, +1: p before, at, after q in the direction u to w, all on one line. */
static int
along(const double u[3], const double w[3], const double p[3],
      const double q[3])
{
  int c = widest(u, w);
  int sign = (p[c] > q[c]) - (p[c] < q[c]);

  return u[c] < w[c] ? sign : -sign;
}

/* A meeting strictly between u and w: the feature of b, and whether the way
 * from u to w enters b there. */
typedef struct meeting {
  sg_feature f;
  bool enters;
} meeting;

/* The corners and edges of b that the open segment u-w meets: 0, 1 or 2. */
static int
meetings(int axis, const double u[3], const double w[3], const double b[3][3],
         const int su[3], const int sw[3], meeting out[2])
{
  int n = 0, o[3];

  for (int i = 0; i < 3; i++) {
    o[i] = turn(axis, u, w, b[i]);
  }
  for (int i = 0; i < 3 && n < 2; i++) {
    if (o[i] == 0 && along(u, w, u, b[i]) < 0 && along(u, w, b[i], w) < 0) {
      out[n++] = (meeting){corner(i), false};
    }
  }
  if (n == 2) { /* u-w runs along an edge: the corner met first enters */
    int first = along(u, w, b[out[0].f], b[out[1].f]) < 0 ? 0 : 1;
    out[first].enters = true;
  }
  for (int i = 0; i < 3 && n < 2; i++) {
    if (o[i] * o[next(i)] < 0 && su[i] * sw[i] < 0) {
      out[n++] = (meeting){edge(i), su[i] < 0};
      if (n == 2 && out[0].f <= SG_CORNER_2) {
        out[0].enters = !out[1].enters;
      }
    }
  }
  return n;
}

/* sg_cut_segment() in the plane of b, seen along `axis`. */
static bool
clip(int axis, const double u[3], const double w[3], const double b[3][3],
     sg_cut *out)
{
  int su[3], sw[3];
  int facing = turn(axis, b[0], b[1], b[2]);
  meeting met[2];
  sg_cut_end *start = &out->end[0], *end = &out->end[1];

  for (int i = 0; i < 3; i++) {
    su[i] = facing * turn(axis, b[i], b[next(i)], u);
    sw[i] = facing * turn(axis, b[i], b[next(i)], w);
  }
  bool u_in = locate(su, &start->f[1]), w_in = locate(sw, &end->f[1]);
  int n = u_in && w_in ? 0 : meetings(axis, u, w, b, su, sw, met);

  if (n + u_in + w_in == 0) {
    return false;
  }
  start->f[0] = SG_CORNER_0;
  end->f[0] = SG_CORNER_1;
  if (!u_in && n > 0) {
    int first = n == 2 && met[1].enters;
    *start = (sg_cut_end){{SG_EDGE_0, met[first].f}};
  }
  if (!w_in && n > 0) {
    int last = n == 2 && !met[1].enters;
    *end = (sg_cut_end){{SG_EDGE_0, met[last].f}};
  }
  if (!w_in && n == 0) {
    *end = *start;
  }
  if (!u_in && n == 0) {
    *start = *end;
  }
  return true;
}

/* The feature of a triangle that feature f of its edge i is. */
static sg_feature
of_triangle(sg_feature f, int i)
{
  return f == SG_CORNER_0   ? corner(i)
         : f == SG_CORNER_1 ? corner(next(i))
                            : edge(i);
}

/* Clips the edges of a by b and adds the pieces; `swap`: a is the second
 * triangle of the pair. Pieces along an edge of the first are then left out:
 * they were found before. A point is kept in `point`. */
static void
clip_edges(int axis, const double a[3][3], const double b[3][3], bool swap,
           sg_cut out[SG_CUT_MAX], int *n, sg_cut *point, bool *has_point)
{
  for (int i = 0; i < 3; i++) {
    sg_cut piece, cut;

    if (!clip(axis, a[i], a[next(i)], b, &piece)) {
      continue;
    }
    for (int k = 0; k < 2; k++) {
      cut.end[k].f[swap] = of_triangle(piece.end[k].f[0], i);
      cut.end[k].f[!swap] = piece.end[k].f[1];
    }
    if (sg_cut_is_point(&cut)) {
      *point = cut;
      *has_point = true;
    } else if (!swap || sg_cut_along(&cut, 0) < 0) {
      out[(*n)++] = cut;
    }
  }
}

static sg_cut_kind
cut_coplanar(const double a[3][3], const double b[3][3], sg_cut out[SG_CUT_MAX],
             int *n)
{
  int axis = sg_cut_axis(a);
  sg_cut point;
  bool has_point = false;

  if (axis < 0 || sg_cut_axis(b) < 0) {
    return SG_CUT_NONE;
  }
  clip_edges(axis, a, b, false, out, n, &point, &has_point);
  clip_edges(axis, b, a, true, out, n, &point, &has_point);
  if (*n == 0 && has_point) {
    out[(*n)++] = point;
  }
  return *n > 0 ? SG_CUT_COPLANAR : SG_CUT_NONE;
}

int
sg_cut_side(const double a[3][3], const double b[3][3])
{
  int side = above(b, a[0]);

  return side != 0 && above(b, a[1]) == side && above(b, a[2]) == side ? side
                                                                       : 0;
}

/* A corner that both have is all that they have in common. */
static sg_cut_kind
cut_at_corner(int of_a, int of_b, sg_cut out[SG_CUT_MAX], int *n)
{
  sg_cut_end end = {{corner(of_a), corner(of_b)}};

  out[0] = (sg_cut){{end, end}};
  *n = 1;
  return SG_CUT_CROSSING;
}

sg_cut_kind
sg_cut_triangles(const double a[3][3], const double b[3][3],
                 sg_cut out[SG_CUT_MAX], int *n)
{
  int side_a[3], side_b[3];
  interval in_a, in_b;
  shared at;

  *n = 0;
  sides(b, a, side_a, &at);
  if (apart(side_a)) {
    return SG_CUT_NONE;
  }
  if (all_zero(side_a)) {
    return cut_coplanar(a, b, out, n);
  }
  if (only_touches(side_a, at.of)) {
    return sg_cut_axis(a) < 0 ? SG_CUT_NONE
                              : cut_at_corner(at.of, at.t, out, n);
  }
  sides(a, b, side_b, &at);
  if (apart(side_b) || all_zero(side_b)) { /* all zero: a has no area */
    return SG_CUT_NONE;
  }
  if (only_touches(side_b, at.of)) {
    return cut_at_corner(at.t, at.of, out, n);
  }
  line_in_triangle(a, side_a, &in_a);
  line_in_triangle(b, side_b, &in_b);
  mark start = in_b.start; /* b's own direction is the other way */
  in_b.start = in_b.end;
  in_b.end = start;
  if (!meet(&in_a, &in_b, &out[0])) {
    return SG_CUT_NONE;
  }
  *n = 1;
  return SG_CUT_CROSSING;
}

/* The feature of b where line u-w crosses its plane, coming from below when
 * `up`; false: outside b. */
static bool
pierced(const double u[3], const double w[3], const double b[3][3], bool up,
        sg_feature *out)
{
  int side[3];

  for (int i = 0; i < 3; i++) {
    int sign = sg_orient3d(u, w, b[i], b[next(i)]);
    side[i] = up ? -sign : sign;
  }
  return locate(side, out);
}

sg_cut_kind
sg_cut_segment(const double u[3], const double w[3], const double b[3][3],
               sg_cut *out)
{
  int su = above(b, u), sw = above(b, w);
  int axis;

  if (su * sw > 0 || widest(u, w) < 0 || (axis = sg_cut_axis(b)) < 0) {
    return SG_CUT_NONE;
  }
  if (su == 0 && sw == 0) {
    return clip(axis, u, w, b, out) ? SG_CUT_COPLANAR : SG_CUT_NONE;
  }
  sg_cut_end end = {{su == 0   ? SG_CORNER_0
                     : sw == 0 ? SG_CORNER_1
                               : SG_EDGE_0,
                     SG_FACE}};

  if (!pierced(u, w, b, su < sw, &end.f[1])) {
    return SG_CUT_NONE;
  }
  *out = (sg_cut){{end, end}};
  return SG_CUT_CROSSING;
}
