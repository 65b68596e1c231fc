/* known_surface.c -- see known_surface.h */
#include "known_surface.h"

#include "bezier_patch.h"
#include "number/bounds.h"
#include "number/vector.h"
#include "polygon/flatness.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define DEGREES (180.0 / acos(-1.0))

/* The cosine of how far the normal may be from that of a facet. */
#define FARTHEST 0.2

/* What is nearer to an axis or an apex, in radii, has no normal. */
#define NO_RADIUS 1e-9

/* Degrees by which two points are off one straight line of a tapered surface,
 * at most. */
#define STRAIGHT 1e-4

/* ---------------------------------------------------------------- making */

/* The power of two that brings the largest coordinate of the axes between 1/2
 * and 1: their products stay in the doubles. */
static double
unit_of(const double axis[3][3])
{
  double most = 0.0;
  int exponent;

  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      most = sg_larger(most, fabs(axis[i][k]));
    }
  }
  frexp(most, &exponent);
  return ldexp(1.0, exponent < -1022 ? 1022 : -exponent);
}

/* The rows of the inverse of the matrix with these columns. False: it has
 * none. */
static bool
invert(double axis[3][3], double row[3][3])
{
  double volume;

  for (int i = 0; i < 3; i++) {
    sg_cross(axis[(i + 1) % 3], axis[(i + 2) % 3], row[i]);
  }
  volume = sg_dot(axis[0], row[0]);
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      row[i][k] /= volume;
      if (!isfinite(row[i][k])) {
        return false;
      }
    }
  }
  return true;
}

void
sg_known_surface_init(sg_known_surface *surface, sg_known_surface_kind kind,
                      const double frame[][3], double a, double b)
{
  size_t rows = (size_t)sg_known_surface_rows(kind);
  double axis[3][3], unit = unit_of(frame + 1);

  *surface = (sg_known_surface){.kind = kind, .unit = unit, .a = a, .b = b};
  memcpy(surface->frame, frame, rows * sizeof *frame);
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      axis[i][k] = frame[i + 1][k] * unit;
    }
  }
  if (rows == 4 && kind != SG_KNOWN_FREE && !invert(axis, surface->row)) {
    surface->kind = SG_KNOWN_FREE;
  }
}

void
sg_known_surface_move(const sg_known_surface *surface, const double map[3][4],
                      sg_known_surface *out)
{
  double frame[16][3];
  int rows = sg_known_surface_rows(surface->kind);

  for (int i = 0; i < rows; i++) {
    bool point = i == 0 || rows == 16;
    const double *from = surface->frame[i];
    for (int k = 0; k < 3; k++) {
      frame[i][k] = map[k][0] * from[0] + map[k][1] * from[1] +
                    map[k][2] * from[2] + (point ? map[k][3] : 0.0);
    }
  }
  sg_known_surface_init(out, surface->kind, (const double(*)[3])frame,
                        surface->a, surface->b);
}

/* --------------------------------------------------------------- normals */

static bool
tapered_gradient(const sg_known_surface *s, const double p[3], double out[3])
{
  double a = 1.0 - p[2] + p[2] * s->a, b = 1.0 - p[2] + p[2] * s->b;
  double x = p[0] / a, y = p[1] / b, radius = hypot(x, y);

  if (a < NO_RADIUS || b < NO_RADIUS || radius < NO_RADIUS) {
    return false;
  }
  out[0] = x / a;
  out[1] = y / b;
  out[2] = -(x * x * (s->a - 1.0) / a + y * y * (s->b - 1.0) / b);
  /* the facet is a chord: the slope is that of the surface above it */
  out[0] *= radius;
  out[1] *= radius;
  return true;
}

static bool
torus_gradient(const double p[3], double out[3])
{
  double radius = hypot(p[0], p[1]);

  if (radius < NO_RADIUS) {
    return false;
  }
  out[0] = (radius - 1.0) * p[0] / radius;
  out[1] = (radius - 1.0) * p[1] / radius;
  out[2] = p[2];
  return true;
}

/* Of what is zero on the surface, at a point in its own coordinates. */
static bool
gradient(const sg_known_surface *s, const double p[3], double out[3])
{
  switch (s->kind) {
  case SG_KNOWN_TAPERED:
  case SG_KNOWN_TURNED:
    return tapered_gradient(s, p, out);
  case SG_KNOWN_SPHERE:
    memcpy(out, p, 3 * sizeof *out);
    return true;
  case SG_KNOWN_TORUS:
    return torus_gradient(p, out);
  case SG_KNOWN_BEZIER:
  case SG_KNOWN_BENT:
  case SG_KNOWN_FREE:
    break;
  }
  return false;
}

void
sg_known_surface_place(const sg_known_surface *s, const double p[3],
                       double out[3])
{
  double from[3];

  for (int k = 0; k < 3; k++) {
    from[k] = (p[k] - s->frame[0][k]) * s->unit;
  }
  for (int i = 0; i < 3; i++) {
    out[i] = sg_dot(s->row[i], from);
  }
}

/* The gradient, of any length, at a point of the model. */
static bool
placed_gradient(const sg_known_surface *s, const double p[3], double out[3])
{
  double at[3], grad[3];

  sg_known_surface_place(s, p, at);
  if (!gradient(s, at, grad)) {
    return false;
  }
  for (int k = 0; k < 3; k++) {
    out[k] = grad[0] * s->row[0][k] + grad[1] * s->row[1][k] +
             grad[2] * s->row[2][k];
  }
  return true;
}

static bool
bent_normal(const sg_known_surface *s, const double p[3], double out[3])
{
  for (int k = 0; k < 3; k++) {
    out[k] = s->frame[1][k];
    for (int i = 0; i < 3; i++) {
      out[k] += (p[i] - s->frame[0][i]) * s->frame[2 + i][k];
    }
  }
  return true;
}

/* The normal, of any length, at a point of the model. False: it has none. */
static bool
own_normal(const sg_known_surface *s, const double p[3], double out[3])
{
  return s->kind == SG_KNOWN_BEZIER
             ? sg_bezier_patch_normal((const double(*)[3])s->frame, p, out)
         : s->kind == SG_KNOWN_BENT ? bent_normal(s, p, out)
                                    : placed_gradient(s, p, out);
}

bool
sg_known_surface_normal(const sg_known_surface *s, const double p[3],
                        const double facet[3], double out[3])
{
  double size, lean;

  if (!own_normal(s, p, out)) {
    return false;
  }
  size = sg_length(out);
  lean = sg_dot(out, facet);
  for (int k = 0; k < 3; k++) {
    out[k] /= lean < 0.0 ? -size : size;
  }
  return fabs(lean) > FARTHEST * size * sg_length(facet);
}

/* ---------------------------------------------------------------- heights */

/* What is zero on the surface, at a point in its own coordinates: half of a
 * difference of squares, whose gradient is gradient(). */
static double
value(const sg_known_surface *s, const double p[3])
{
  double a = 1.0 - p[2] + p[2] * s->a, b = 1.0 - p[2] + p[2] * s->b;
  double off = hypot(p[0], p[1]) - 1.0;

  switch (s->kind) {
  case SG_KNOWN_TAPERED:
  case SG_KNOWN_TURNED:
    return (p[0] / a * p[0] / a + p[1] / b * p[1] / b - 1.0) / 2.0;
  case SG_KNOWN_SPHERE:
    return (sg_dot(p, p) - 1.0) / 2.0;
  case SG_KNOWN_TORUS:
    return (off * off + p[2] * p[2] - s->a * s->a) / 2.0;
  case SG_KNOWN_BEZIER:
  case SG_KNOWN_BENT:
  case SG_KNOWN_FREE:
    break;
  }
  return 0.0;
}

bool
sg_known_surface_height(const sg_known_surface *s, const double p[3],
                        const double facet[3], double *height)
{
  double at[3], grad[3], normal[3], lean;

  if (!sg_known_surface_is_measured(s) ||
      !sg_known_surface_normal(s, p, facet, normal) ||
      !placed_gradient(s, p, grad)) {
    return false;
  }
  sg_known_surface_place(s, p, at);
  lean = sg_dot(grad, normal) * s->unit;
  *height = -value(s, at) / lean;
  return isfinite(*height);
}

/* ----------------------------------------------------------------- reach */

/* In tolerances: three, and what is rounded then (penetration/resolve.h). */
#define MOVED 4.0

bool
sg_known_surfaces_find_reach(sg_known_surfaces *surfaces, const sg_dense *d)
{
  surfaces->reach = calloc(d->segments + 1, sizeof *surfaces->reach);
  for (size_t s = 0; surfaces->reach && s < d->segments; s++) {
    size_t begin = d->vertex_begin[s];
    surfaces->reach[s] =
        MOVED * sg_flatness_touch_of((const double(*)[3])(d->at + begin),
                                     d->vertex_begin[s + 1] - begin,
                                     d->grain[s]);
  }
  return surfaces->reach != NULL;
}

/* How far polygon p goes from the line through two of its vertices. */
static double
width_from(const sg_dense *d, int32_t p, const double *const ends[2])
{
  double way[3], most = 0.0, length;

  sg_minus(ends[1], ends[0], way);
  length = sg_any_length(way);
  for (uint32_t i = d->list_begin[p]; i < d->list_begin[p + 1]; i++) {
    double off[3], area[3];
    sg_minus(d->at[d->from[d->list[i]]], ends[0], off);
    sg_cross(way, off, area);
    most = sg_larger(most, sg_any_length(area));
  }
  return most / length;
}

/* Degrees by which two polygons may bend and be meant flat: each turns about
 * their line when its corners are moved by their reach. */
static double
meant_flat(const sg_known_surfaces *surfaces, const sg_facets_meeting *m)
{
  const sg_dense *d = m->dense;
  double flat = 0.0;

  for (int i = 0; i < 2 && surfaces->reach; i++) {
    size_t s =
        sg_dense_segment_of(d, d->polygon_begin, (uint32_t)m->polygon[i]);
    flat += surfaces->reach[s] / width_from(d, m->polygon[i], m->ends);
  }
  return flat * DEGREES;
}

/* ----------------------------------------------------------------- bends */

/* One of two polygons that meet. */
typedef struct side {
  const sg_known_surface *surface; /* null: of none */
  const double *facet;
  double normal[2][3]; /* at the ends */
  bool has[2];         /* the normal is that of the surface, or of a plane */
} side;

static void
make_side(const sg_known_surfaces *surfaces, const sg_facets_meeting *m, int i,
          side *out)
{
  int32_t of = sg_known_surface_of(surfaces, m->polygon[i]);

  *out = (side){.surface = of < 0 ? NULL : &surfaces->surface[of],
                .facet = m->normal[i]};
  for (int end = 0; end < 2; end++) {
    out->has[end] =
        of < 0 || sg_known_surface_normal(out->surface, m->ends[end],
                                          out->facet, out->normal[end]);
    if (of < 0 || !out->has[end]) {
      memcpy(out->normal[end], out->facet, sizeof out->normal[end]);
    }
  }
}

/* Whether p and q are on one straight line of a tapered surface. */
static bool
is_generator(const sg_known_surface *s, const double p[3], const double q[3])
{
  const double *end[2] = {p, q};
  double way[2][3] = {{0.0}};

  if (!s || !sg_known_surface_is_tapered(s)) {
    return false;
  }
  for (int i = 0; i < 2; i++) {
    double at[3], a, b;
    sg_known_surface_place(s, end[i], at);
    a = 1.0 - at[2] + at[2] * s->a;
    b = 1.0 - at[2] + at[2] * s->b;
    if (a < NO_RADIUS || b < NO_RADIUS) { /* its apex */
      return true;
    }
    way[i][0] = at[0] / a;
    way[i][1] = at[1] / b;
  }
  return sg_angle(way[0], way[1]) * DEGREES < STRAIGHT;
}

/* Degrees by which two sides bend, where the normals of both are known; if
 * that is nowhere, by the facets. */
static double
known_bend(const side x[2], double facets)
{
  double bend = -1.0;

  for (int end = 0; end < 2; end++) {
    if (x[0].has[end] && x[1].has[end]) {
      bend = sg_larger(bend,
                       sg_angle(x[0].normal[end], x[1].normal[end]) * DEGREES);
    }
  }
  return bend < 0.0 ? facets : bend;
}

/* Whether two polygons are tangent that bend by so many degrees: a patch tells
 * its normal only beside it, and a bent facet was one of others. */
static bool
is_tangent(const sg_known_surfaces *surfaces, const sg_facets_meeting *m,
           double degrees)
{
  for (int i = 0; i < 2; i++) {
    int32_t of = sg_known_surface_of(surfaces, m->polygon[i]);
    if (of >= 0 && !sg_known_surface_is_measured(&surfaces->surface[of])) {
      return degrees <= SG_FLAT_BEND;
    }
  }
  return degrees <= SG_FLAT_BEND && degrees <= meant_flat(surfaces, m);
}

static bool
is_edge(const sg_known_surfaces *surfaces, const sg_facets_meeting *m,
        const side x[2])
{
  bool turned = x[0].surface && x[1].surface &&
                x[0].surface->kind == SG_KNOWN_TURNED &&
                x[1].surface->kind == SG_KNOWN_TURNED;

  return !turned && !is_generator(x[0].surface, m->ends[0], m->ends[1]) &&
         !is_generator(x[1].surface, m->ends[0], m->ends[1]) &&
         !is_tangent(surfaces, m, known_bend(x, m->bend));
}

sg_bend
sg_known_surfaces_bend(const sg_known_surfaces *surfaces,
                       const sg_facets_meeting *m)
{
  int32_t of[2] = {sg_known_surface_of(surfaces, m->polygon[0]),
                   sg_known_surface_of(surfaces, m->polygon[1])};
  bool named = of[0] != SG_NOT_KNOWN && of[1] != SG_NOT_KNOWN;
  sg_bend bend = {.degrees = sg_smaller(m->bend, SG_FACET_BEND)};
  side x[2];

  if (of[0] < 0 && of[1] < 0 && !(named && of[0] == of[1])) {
    return (sg_bend){.degrees = m->bend,
                     .edge = named && !is_tangent(surfaces, m, m->bend)};
  }
  if (of[0] != of[1]) {
    make_side(surfaces, m, 0, &x[0]);
    make_side(surfaces, m, 1, &x[1]);
    for (int end = 0; end < 2; end++) {
      bend.degrees = sg_larger(
          bend.degrees, sg_angle(x[0].normal[end], x[1].normal[end]) * DEGREES);
    }
    bend.edge = named && m->bend > 0.0 && is_edge(surfaces, m, x);
    bend.tangent = named && is_tangent(surfaces, m, known_bend(x, m->bend));
  }
  return bend;
}

void
sg_known_surfaces_clear(sg_known_surfaces *surfaces)
{
  free(surfaces->surface);
  free(surfaces->of);
  free(surfaces->reach);
  *surfaces = (sg_known_surfaces){0};
}
