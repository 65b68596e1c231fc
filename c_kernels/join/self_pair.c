/* self_pair.c -- two triangles of one segment (self_pair.h).
 *
 * Most candidates are neighbours that have nothing else in common. A plane
 * that plainly lies between them (in doubles, beyond all rounding) settles
 * nearly all of these, flat regions among them, where an exact sign would be
 * zero and dear.
 */
#include "self_pair.h"

#include "cut.h"
#include "number/exact.h"
#include "number/vector.h"
#include "self_shape.h"

#include <math.h>
#include <string.h>

typedef sg_self_two pair;
typedef const double (*corners)[3];

static void
fill(const sg_self_model *m, int32_t t, double at[3][3], uint32_t place[3])
{
  for (int i = 0; i < 3; i++) {
    int32_t v = m->d->corner[t][i];

    memcpy(at[i], m->d->at[v], sizeof at[i]);
    place[i] = m->place[(uint32_t)v - m->first];
  }
}

static void
find_shared(pair *p)
{
  p->n = 0;
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      if (p->a_at[i] == p->b_at[j]) {
        p->shared[p->n] = i;
        p->same[p->n++] = j;
        break;
      }
    }
  }
}

static bool
is_flat(const uint32_t at[3])
{
  return at[0] == at[1] || at[1] == at[2] || at[2] == at[0];
}

/* ---- plainly apart ------------------------------------------------------ */

/* Where x is along m from o, +1 before or -1 behind; 0: not plain (nor is what
 * overflows). */
static int
plain_side(const double m[3], const double o[3], const double x[3])
{
  double sum = 0, size = 0;

  for (int k = 0; k < 3; k++) {
    double term = m[k] * (x[k] - o[k]);
    sum += term;
    size += fabs(term);
  }
  return !(fabs(sum) > 1e-14 * size + 1e-290) ? 0 : sum > 0 ? 1 : -1;
}

/* The normal of a triangle, and how large what it is the difference of is. */
typedef struct sized_normal {
  double n[3], size[3];
} sized_normal;

static sized_normal
normal_of(corners of)
{
  sized_normal out;
  double u[3], v[3];

  sg_minus(of[1], of[0], u);
  sg_minus(of[2], of[0], v);
  for (int k = 0; k < 3; k++) {
    int g = (k + 1) % 3, h = (k + 2) % 3;
    double one = u[g] * v[h], other = u[h] * v[g];

    out.n[k] = one - other;
    out.size[k] = fabs(one) + fabs(other);
  }
  return out;
}

/* The same of x and the plane of a triangle with this normal, through o. */
static int
turn_of(const sized_normal *m, const double o[3], const double x[3])
{
  double sum = 0, size = 0;

  for (int k = 0; k < 3; k++) {
    double d = x[k] - o[k];

    sum += m->n[k] * d;
    size += m->size[k] * fabs(d);
  }
  return !(fabs(sum) > 1e-14 * size + 1e-290) ? 0 : sum > 0 ? 1 : -1;
}

static int
plain_turn(corners of, const double x[3])
{
  sized_normal m = normal_of(of);

  return turn_of(&m, of[0], x);
}

static bool
is_shared(const int *of, int n, int corner)
{
  return (n > 0 && of[0] == corner) || (n > 1 && of[1] == corner);
}

/* Whether the plane through o, across m, has all corners but one shared of a
 * before it and of b behind it. */
static bool
is_between(const pair *p, const double m[3], const double o[3])
{
  for (int i = 0; i < 3; i++) {
    if ((!is_shared(p->shared, p->n, i) && plain_side(m, o, p->a[i]) <= 0) ||
        (!is_shared(p->same, p->n, i) && plain_side(m, o, p->b[i]) >= 0)) {
      return false;
    }
  }
  return true;
}

/* Whether a plane across m lies between: through the shared corner, or in the
 * middle of the gap. */
static bool
apart_along(const pair *p, const double m[3])
{
  double back[3] = {-m[0], -m[1], -m[2]}, o[3];
  double a[2] = {INFINITY, -INFINITY}, b[2] = {INFINITY, -INFINITY};

  if (p->n == 1) {
    const double *v = p->a[p->shared[0]];
    return is_between(p, m, v) || is_between(p, back, v);
  }
  for (int i = 0; i < 3; i++) {
    double at_a = 0, at_b = 0;

    for (int k = 0; k < 3; k++) {
      at_a += m[k] * (p->a[i][k] - p->a[0][k]);
      at_b += m[k] * (p->b[i][k] - p->a[0][k]);
    }
    a[0] = at_a < a[0] ? at_a : a[0], a[1] = at_a > a[1] ? at_a : a[1];
    b[0] = at_b < b[0] ? at_b : b[0], b[1] = at_b > b[1] ? at_b : b[1];
  }
  if (a[0] <= b[1] && b[0] <= a[1]) {
    return false;
  }
  double gap = a[0] > b[1] ? (a[0] + b[1]) / 2 : (b[0] + a[1]) / 2;

  for (int k = 0; k < 3; k++) {
    o[k] = p->a[0][k] + gap * m[k] / (m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
  }
  return is_between(p, a[0] > b[1] ? m : back, o);
}

/* Seen along the normal of a, or of b: across its edges and those of b; or,
 * sharing a corner, half way between an edge of a and one of b that leave it.
 */
static bool
apart_in_plane(const pair *p, corners of)
{
  double n[3], e[3], m[3];

  sg_shape_normal(of, n);
  for (int i = 0; p->n == 0 && i < 6; i++) {
    const double *from = i < 3 ? p->a[i] : p->b[i - 3];
    const double *to = i < 3 ? p->a[(i + 1) % 3] : p->b[(i - 2) % 3];

    sg_minus(to, from, e);
    sg_cross(n, e, m);
    if (apart_along(p, m)) {
      return true;
    }
  }
  for (int i = 0; p->n == 1 && i < 4; i++) {
    const double *v = p->a[p->shared[0]];
    double f[3];

    sg_minus(p->a[(p->shared[0] + 1 + i / 2) % 3], v, e);
    sg_minus(p->b[(p->same[0] + 1 + i % 2) % 3], v, f);
    sg_shape_normalise(e);
    sg_shape_normalise(f);
    for (int k = 0; k < 3; k++) {
      e[k] += f[k];
    }
    sg_cross(n, e, m);
    if (apart_along(p, m)) {
      return true;
    }
  }
  return false;
}

/* Whether the corners of x but those shared are on one side of the plane of a
 * triangle. */
static bool
beside(const pair *p, corners of, corners x, const int *shared)
{
  sized_normal m = normal_of(of);
  int side = 0;

  for (int i = 0; i < 3; i++) {
    if (!is_shared(shared, p->n, i)) {
      int turn = turn_of(&m, of[0], x[i]);

      if (turn == 0 || turn == -side) {
        return false;
      }
      side = turn;
    }
  }
  return true;
}

/* First by their planes, then across the way between their middles. */
static bool
plainly_apart(const pair *p)
{
  double m[3];

  if (beside(p, (corners)p->a, (corners)p->b, p->same) ||
      beside(p, (corners)p->b, (corners)p->a, p->shared)) {
    return true;
  }

  for (int k = 0; k < 3; k++) {
    m[k] = p->a[0][k] + p->a[1][k] + p->a[2][k] -
           (p->b[0][k] + p->b[1][k] + p->b[2][k]);
  }
  return apart_along(p, m) || apart_in_plane(p, (corners)p->a) ||
         apart_in_plane(p, (corners)p->b);
}

/* ---- sharing an edge, or all -------------------------------------------- */

static int
turn(int axis, const double a[3], const double b[3], const double c[3])
{
  int x = (axis + 1) % 3, y = (axis + 2) % 3;

  return sg_orient2d((double[2]){a[x], a[y]}, (double[2]){b[x], b[y]},
                     (double[2]){c[x], c[y]});
}

/* The axis along which triangle t looks largest. */
static int
best_axis(const double t[3][3])
{
  double n[3];

  sg_shape_normal(t, n);
  int axis = fabs(n[1]) > fabs(n[0]) ? 1 : 0;

  return fabs(n[2]) > fabs(n[axis]) ? 2 : axis;
}

/* Beyond the edge u-w they share: only if they are folded over, in one plane
 * and on one side of it. Seen along an axis, opposite sides tell at once. */
static bool
folded(const pair *p)
{
  int other_a = 3 - p->shared[0] - p->shared[1];
  int other_b = 3 - p->same[0] - p->same[1];
  const double *u = p->a[p->shared[0]], *w = p->a[p->shared[1]];

  if (plain_turn((corners)p->a, p->b[other_b]) != 0) {
    return false;
  }
  int axis = best_axis((corners)p->a);
  int side_a = turn(axis, u, w, p->a[other_a]);
  int side_b = turn(axis, u, w, p->b[other_b]);

  if (side_a * side_b < 0) {
    return false;
  }
  if (sg_orient3d(p->a[0], p->a[1], p->a[2], p->b[other_b]) != 0) {
    return false;
  }
  axis = sg_cut_axis((corners)p->a);
  return axis >= 0 && sg_cut_axis((corners)p->b) >= 0 &&
         turn(axis, u, w, p->a[other_a]) == turn(axis, u, w, p->b[other_b]);
}

/* ---- the kind ----------------------------------------------------------- */

/* Whether an edge of a, in the plane of both, has a on one side and b on the
 * other, or on it. Exact. */
static bool
edge_between(int axis, corners a, corners b)
{
  int facing = turn(axis, a[0], a[1], a[2]);

  for (int i = 0; i < 3; i++) {
    int inside = 0;

    for (int j = 0; j < 3; j++) {
      inside += facing * turn(axis, a[i], a[(i + 1) % 3], b[j]) > 0;
    }
    if (inside == 0) {
      return true;
    }
  }
  return false;
}

static bool
share_area(const pair *p)
{
  int axis = sg_cut_axis((corners)p->a);

  return axis >= 0 && !edge_between(axis, (corners)p->a, (corners)p->b) &&
         !edge_between(axis, (corners)p->b, (corners)p->a);
}

/* A penetration no deeper than the tolerance is none; and what is in one plane
 * within it overlaps, or touches if it does so by no more. */
static sg_self_kind
kind_within(const pair *p, sg_self_kind exact, double tolerance)
{
  if (exact == SG_SELF_TOUCHING || tolerance == 0) {
    return exact;
  }
  sg_depth a = sg_shape_depth((corners)p->a, (corners)p->b);
  sg_depth b = sg_shape_depth((corners)p->b, (corners)p->a);

  if (exact == SG_SELF_OVERLAP || fmax(a.above, a.below) <= tolerance ||
      fmax(b.above, b.below) <= tolerance) {
    return sg_shape_overlap((corners)p->a, (corners)p->b) > tolerance
               ? SG_SELF_OVERLAP
               : SG_SELF_TOUCHING;
  }
  return fmin(fmin(a.above, a.below), fmin(b.above, b.below)) <= tolerance
             ? SG_SELF_TOUCHING
             : SG_SELF_PENETRATION;
}

/* Is all of the cut where their polygons share an edge or a vertex? */
static bool
is_where_shared(const sg_self_model *m, const pair *p, const int32_t t[2],
                const sg_cut *cut, int n)
{
  int32_t of[2] = {m->d->polygon_of[t[0]], m->d->polygon_of[t[1]]};

  if (of[0] == of[1]) {
    return true;
  }
  for (int i = 0; i < n; i++) {
    for (int k = 0; k < 2; k++) {
      double at[3];

      sg_shape_end((corners)p->a, (corners)p->b, &cut[i].end[k], at);
      if (!sg_shape_is_shared(m, of, at)) {
        return false;
      }
    }
  }
  return true;
}

/* The edge of `first` (0: a, 1: b) that lies in the face of the other. */
static void
note_edge(const pair *p, const int32_t t[2], const sg_cut *cut, int first,
          sg_self_edge *edge)
{
  corners in = first ? (corners)p->a : (corners)p->b;
  corners of = first ? (corners)p->b : (corners)p->a;
  const uint32_t *at = first ? p->b_at : p->a_at;
  int i = sg_cut_along(cut, first);

  if (i < 0 || sg_cut_along(cut, !first) >= 0) {
    return;
  }
  uint32_t u = at[i], w = at[(i + 1) % 3];

  *edge = (sg_self_edge){t[!first], u < w ? u : w, u < w ? w : u,
                         sg_orient3d(in[0], in[1], in[2], of[(i + 2) % 3])};
}

static sg_self_kind
exact_kind(const pair *p, sg_cut_kind how, const sg_cut *cut)
{
  if (how == SG_CUT_COPLANAR) {
    return share_area(p) ? SG_SELF_OVERLAP : SG_SELF_TOUCHING;
  }
  return sg_cut_is_point(cut) || sg_cut_along(cut, 0) >= 0 ||
                 sg_cut_along(cut, 1) >= 0
             ? SG_SELF_TOUCHING
             : SG_SELF_PENETRATION;
}

/* Only the corner they share? */
static bool
is_shared_corner(const pair *p, const sg_cut *cut, int n)
{
  return p->n == 1 && n == 1 && sg_cut_is_point(cut) &&
         cut->end[0].f[0] == (sg_feature)p->shared[0] &&
         cut->end[0].f[1] == (sg_feature)p->same[0];
}

static bool
meet(const sg_self_model *m, const pair *p, const int32_t t[2],
     sg_self_meeting *out, sg_self_edge *edge)
{
  sg_cut cut[SG_CUT_MAX];
  int n;
  sg_cut_kind how = sg_cut_triangles((corners)p->a, (corners)p->b, cut, &n);

  if (how == SG_CUT_NONE || is_shared_corner(p, cut, n)) {
    return false;
  }
  out->kind = kind_within(p, exact_kind(p, how, cut), m->tolerance);
  if (out->kind == SG_SELF_TOUCHING && m->tolerance > 0 &&
      is_where_shared(m, p, t, cut, n)) {
    return false;
  }
  if (how == SG_CUT_CROSSING && out->kind == SG_SELF_TOUCHING) {
    note_edge(p, t, cut, 0, edge);
    note_edge(p, t, cut, 1, edge);
  }
  double end[2][3];

  out->line = false;
  for (int i = 0; i < n; i++) {
    out->line = out->line || !sg_cut_is_point(&cut[i]);
  }
  for (int k = 0; k < 2; k++) {
    sg_shape_end((corners)p->a, (corners)p->b, &cut[0].end[k], end[k]);
  }
  for (int k = 0; k < 3; k++) {
    out->at[k] = end[0][k] / 2 + end[1][k] / 2;
  }
  return true;
}

/* Of two that share an edge or three corners, and may meet. */
static bool
lie_over(const sg_self_model *m, const pair *p, sg_self_meeting *out)
{
  out->kind = kind_within(p, SG_SELF_OVERLAP, m->tolerance);
  out->line = true;
  for (int k = 0; k < 3; k++) {
    out->at[k] = p->a[0][k] / 3 + p->a[1][k] / 3 + p->a[2][k] / 3;
  }
  return out->kind == SG_SELF_OVERLAP; /* else a sliver at what they share */
}

bool
sg_self_may_meet(sg_self_two *p)
{
  if (is_flat(p->a_at) || is_flat(p->b_at)) {
    return false;
  }
  find_shared(p);
  return p->n == 2   ? folded(p)
         : p->n == 3 ? sg_cut_axis((corners)p->a) >= 0
                     : !plainly_apart(p);
}

/* Whether the cut, along an edge of either, is longer than the tolerance, and
 * they do not lie in one plane within it. */
static bool
reaches_in(const pair *p, const sg_cut *cut, double tolerance)
{
  sg_depth a = sg_shape_depth((corners)p->a, (corners)p->b);
  sg_depth b = sg_shape_depth((corners)p->b, (corners)p->a);
  double end[2][3], way[3];

  for (int k = 0; k < 2; k++) {
    sg_shape_end((corners)p->a, (corners)p->b, &cut->end[k], end[k]);
  }
  sg_minus(end[1], end[0], way);
  return fmax(a.above, a.below) > tolerance &&
         fmax(b.above, b.below) > tolerance &&
         hypot(hypot(way[0], way[1]), way[2]) > tolerance;
}

bool
sg_self_goes_through(const sg_self_two *p, double tolerance)
{
  sg_cut cut[SG_CUT_MAX];
  int n;

  if (p->n >= 2) {
    return kind_within(p, SG_SELF_OVERLAP, tolerance) == SG_SELF_OVERLAP;
  }
  sg_cut_kind how = sg_cut_triangles((corners)p->a, (corners)p->b, cut, &n);

  if (how == SG_CUT_NONE || is_shared_corner(p, cut, n)) {
    return false;
  }
  return kind_within(p, exact_kind(p, how, cut), tolerance) !=
             SG_SELF_TOUCHING ||
         (how == SG_CUT_CROSSING && !sg_cut_is_point(cut) &&
          reaches_in(p, cut, tolerance));
}

void
sg_self_two_of(const sg_fan_triangle *a, const sg_fan_triangle *b,
               sg_self_two *out)
{
  memcpy(out->a, a->at, sizeof out->a);
  memcpy(out->b, b->at, sizeof out->b);
  memcpy(out->a_at, a->name, sizeof out->a_at);
  memcpy(out->b_at, b->name, sizeof out->b_at);
}

void
sg_self_read_triangle(const sg_self_model *model, int32_t t,
                      sg_fan_triangle *out)
{
  fill(model, t, out->at, out->name);
  out->polygon = model->d->polygon_of[t];
}

bool
sg_self_pair(const sg_self_model *model, int32_t a, int32_t b,
             sg_self_meeting *out, sg_self_edge *edge)
{
  const int32_t t[2] = {a, b};
  pair p;

  *edge = (sg_self_edge){.face = -1};
  fill(model, a, p.a, p.a_at);
  fill(model, b, p.b, p.b_at);
  if (!sg_self_may_meet(&p)) {
    return false;
  }
  return p.n >= 2 ? lie_over(model, &p, out) : meet(model, &p, t, out, edge);
}
