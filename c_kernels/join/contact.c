/* contact.c -- where two triangles touch up to rounding: see contact.h. */
#include "contact.h"

#include "number/exact.h"
#include "number/vector.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* ---- vectors ---- */

/* ---- the pair in hand ---- */

/* A triangle and its plane. One that is thinner than the reach has none. */
typedef struct side {
  const double (*at)[3];
  double normal[3]; /* unit length */
  bool plane;
} side;

typedef struct finder {
  side side[2];
  double reach;
  bool exactly; /* whether contacts are exact is asked */
  sg_contact *out;
  int n;
} finder;

/* False: the triangle has a side of hardly more than the reach. Its contacts
 * cannot be told apart, so they stay as they are. */
static bool
set_side(side *out, const double at[3][3], double reach)
{
  double u[3], w[3], z[3];

  out->at = at;
  sg_minus(at[1], at[0], u);
  sg_minus(at[2], at[0], w);
  sg_minus(at[2], at[1], z);
  sg_cross(u, w, out->normal);
  double area = sg_length(out->normal), a = sg_length(u), b = sg_length(w);
  double c = sg_length(z);

  out->plane = area > reach * fmax(a, fmax(b, c)) && isfinite(area);
  for (int k = 0; k < 3 && out->plane; k++) {
    out->normal[k] /= area;
  }
  return fmin(a, fmin(b, c)) > 4 * reach;
}

/* How far the corners of `other` are above the plane of `of`. */
static void
heights(const side *of, const side *other, double out[3])
{
  for (int i = 0; i < 3; i++) {
    double from[3];

    sg_minus(other->at[i], of->at[0], from);
    out[i] = sg_dot(of->normal, from);
  }
}

static bool
all_beyond(const double h[3], double reach)
{
  return (h[0] > reach && h[1] > reach && h[2] > reach) ||
         (h[0] < -reach && h[1] < -reach && h[2] < -reach);
}

/* Edge i is, whatever rounding does: it passes no edge of the other. */
static bool
edge_beyond(const double h[3], int i, double reach)
{
  double a = h[i], b = h[(i + 1) % 3];

  return (a > 2 * reach && b > 2 * reach) || (a < -2 * reach && b < -2 * reach);
}

/* ---- exactly ---- */

static bool
equal(const double a[3], const double b[3])
{
  return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

static bool
collinear(const double a[3], const double b[3], const double c[3])
{
  for (int k = 0; k < 3; k++) {
    int l = (k + 1) % 3;
    if (sg_orient2d((double[2]){a[k], a[l]}, (double[2]){b[k], b[l]},
                    (double[2]){c[k], c[l]}) != 0) {
      return false;
    }
  }
  return true;
}

/* ---- corners ---- */

/* Whether p, beside the plane of `s`, is inside the triangle. */
static bool
is_over(const side *s, const double p[3])
{
  for (int i = 0; i < 3; i++) {
    double along[3], from[3], inward[3];

    sg_minus(s->at[(i + 1) % 3], s->at[i], along);
    sg_minus(p, s->at[i], from);
    sg_cross(s->normal, along, inward);
    if (!(sg_dot(inward, from) > 0)) {
      return false;
    }
  }
  return true;
}

static void
add(finder *find, sg_feature f, sg_feature g, double apart, const double at[3],
    bool exact)
{
  sg_contact *contact = &find->out[find->n++];

  *contact = (sg_contact){{f, g}, apart, {at[0], at[1], at[2]}, exact};
}

/* What is near a point: a feature, how far, and whether without tolerance. */
typedef struct near {
  sg_feature f;
  double apart;
  bool exact;
} near;

/* The nearest corner of `s` within reach of p; false: there is none. */
static bool
nearest_corner(const side *s, const double p[3], double reach, near *out)
{
  out->apart = INFINITY;
  for (int i = 0; i < 3; i++) {
    double apart = sg_distance(s->at[i], p);
    if (apart <= reach && apart < out->apart) {
      *out = (near){(sg_feature)(SG_CORNER_0 + i), apart, equal(s->at[i], p)};
    }
  }
  return out->apart <= reach;
}

static bool
nearest_edge(const side *s, const double p[3], double reach, bool exactly,
             near *out)
{
  out->apart = INFINITY;
  for (int i = 0; i < 3; i++) {
    const double *a = s->at[i], *b = s->at[(i + 1) % 3];
    double apart = sg_to_segment(a, b, p);
    if (apart <= reach && apart < out->apart) {
      *out = (near){(sg_feature)(SG_EDGE_0 + i), apart,
                    exactly && collinear(a, b, p)};
    }
  }
  return out->apart <= reach;
}

static bool
face(const side *s, const double p[3], double reach, bool exactly, near *out)
{
  double from[3];

  sg_minus(p, s->at[0], from);
  *out = (near){SG_FACE, fabs(sg_dot(s->normal, from)), false};
  if (!s->plane || out->apart > reach || !is_over(s, p)) {
    return false;
  }
  out->exact = exactly && sg_orient3d(s->at[0], s->at[1], s->at[2], p) == 0;
  return true;
}

static bool
nearest(const side *s, const double p[3], double reach, bool exactly, near *out)
{
  *out = (near){SG_FACE, 0, false};
  return nearest_corner(s, p, reach, out) ||
         nearest_edge(s, p, reach, exactly, out) ||
         face(s, p, reach, exactly, out);
}

/* Corner i of side k against the other triangle. */
static void
corner(finder *find, int k, int i)
{
  const double *p = find->side[k].at[i];
  sg_feature own = (sg_feature)(SG_CORNER_0 + i);
  near other;

  if (!nearest(&find->side[!k], p, find->reach, find->exactly, &other)) {
    return;
  }
  if (k == 0) {
    add(find, own, other.f, other.apart, p, other.exact);
  } else if (other.f >= SG_EDGE_0) { /* two corners: found from the first */
    add(find, other.f, own, other.apart, p, other.exact);
  }
}

/* ---- edges ---- */

/* Whether |off| is more than reach * sqrt(square), whatever rounding does: most
 * pairs end here, without a root. */
static bool
is_far(double off, double reach, double square)
{
  return off * off > 1e-280 && off * off > reach * reach * square * (1 + 1e-9);
}

/* Edge i of the first against edge j of the second: contact if they pass each
 * other within reach, and no end of either is within reach of the other (then
 * that is the contact). */
static void
edges(finder *find, int i, int j)
{
  const double *a = find->side[0].at[i], *b = find->side[0].at[(i + 1) % 3];
  const double *c = find->side[1].at[j], *d = find->side[1].at[(j + 1) % 3];
  double u[3], w[3], n[3], from[3], p[3], q[3], at[3], m[3];

  sg_minus(b, a, u);
  sg_minus(d, c, w);
  sg_minus(c, a, from);
  sg_cross(u, w, n);
  double square = sg_dot(n, n), off = sg_dot(from, n);

  if (is_far(off, find->reach, square)) {
    return;
  }
  double parallel = sg_length(u) * sg_length(w) * 16 * DBL_EPSILON;

  if (!(square > parallel * parallel) ||
      fabs(off) > find->reach * sqrt(square)) {
    return;
  }
  sg_cross(from, w, m);
  double s = sg_dot(m, n) / square;
  sg_cross(from, u, m);
  double t = sg_dot(m, n) / square;

  if (!(s > 0 && s < 1 && t > 0 && t < 1)) {
    return;
  }
  for (int k = 0; k < 3; k++) {
    p[k] = a[k] + s * u[k];
    q[k] = c[k] + t * w[k];
    at[k] = 0.5 * p[k] + 0.5 * q[k];
  }
  double apart = sg_distance(p, q);

  if (apart <= find->reach && sg_to_segment(c, d, a) > find->reach &&
      sg_to_segment(c, d, b) > find->reach &&
      sg_to_segment(a, b, c) > find->reach &&
      sg_to_segment(a, b, d) > find->reach) {
    add(find, (sg_feature)(SG_EDGE_0 + i), (sg_feature)(SG_EDGE_0 + j), apart,
        at, find->exactly && sg_orient3d(a, b, c, d) == 0);
  }
}

/* Whether b is wholly beyond the reach on one side of the plane of a, which is
 * not thin: most pairs end here, without a root. */
static bool
is_apart(const double a[3][3], const double b[3][3], double reach)
{
  double u[3], w[3], n[3];
  int above = 0, below = 0;

  sg_minus(a[1], a[0], u);
  sg_minus(a[2], a[0], w);
  sg_cross(u, w, n);
  double square = sg_dot(n, n), limit = reach * reach * square;

  if (!(square > 4 * reach * reach * (sg_dot(u, u) + sg_dot(w, w)))) {
    return false;
  }
  for (int i = 0; i < 3; i++) {
    double from[3];

    sg_minus(b[i], a[0], from);
    double h = sg_dot(n, from);
    if (!(h * h > limit)) {
      return false;
    }
    above += h > 0;
    below += h < 0;
  }
  return above == 3 || below == 3;
}

static int
find_contacts(const double a[3][3], const double b[3][3], double reach,
              bool exactly, sg_contact out[SG_CONTACT_MAX])
{
  finder find = {.reach = reach, .exactly = exactly, .out = out};
  double h[2][3] = {{0}};

  if (is_apart(a, b, reach) || is_apart(b, a, reach)) {
    return 0;
  }

  if (!set_side(&find.side[0], a, reach) ||
      !set_side(&find.side[1], b, reach)) {
    return 0;
  }
  for (int k = 0; k < 2; k++) {
    if (find.side[!k].plane) {
      heights(&find.side[!k], &find.side[k], h[k]);
      if (all_beyond(h[k], reach)) {
        return 0;
      }
    }
  }
  for (int k = 0; k < 2; k++) {
    for (int i = 0; i < 3; i++) {
      if (fabs(h[k][i]) <= reach) {
        corner(&find, k, i);
      }
    }
  }
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3 && !edge_beyond(h[0], i, reach); j++) {
      if (!edge_beyond(h[1], j, reach)) {
        edges(&find, i, j);
      }
    }
  }
  return find.n;
}

int
sg_contacts(const double a[3][3], const double b[3][3], double reach,
            sg_contact out[SG_CONTACT_MAX])
{
  return find_contacts(a, b, reach, true, out);
}

int
sg_contacts_near(const double a[3][3], const double b[3][3], double reach,
                 sg_contact out[SG_CONTACT_MAX])
{
  return find_contacts(a, b, reach, false, out);
}

bool
sg_contact_point(const double point[3], const double b[3][3], double reach,
                 sg_contact *out)
{
  side s;
  near found;

  if (!set_side(&s, b, reach) || !nearest(&s, point, reach, false, &found)) {
    return false;
  }
  *out = (sg_contact){.f = {SG_CORNER_0, found.f}, .distance = found.apart};
  memcpy(out->at, point, sizeof out->at);
  return true;
}
