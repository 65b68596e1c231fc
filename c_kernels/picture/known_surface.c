/* known_surface.c -- see known_surface.h */
#include "known_surface.h"

#include "bezier_patch.h"
#include "number/bounds.h"
#include "number/vector.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define DEGREES (180.0 / acos(-1.0))

/* The cosine of how far the normal may be from that of a facet. */
#define FARTHEST 0.2

/* What is nearer to an axis or an apex, in radii, has no normal. */
#define NO_RADIUS 1e-9

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
  double x = p[0] / a, y = p[1] / b;

  if (a < NO_RADIUS || b < NO_RADIUS || hypot(x, y) < NO_RADIUS) {
    return false;
  }
  out[0] = x / a;
  out[1] = y / b;
  out[2] = -(x * x * (s->a - 1.0) / a + y * y * (s->b - 1.0) / b);
  /* the facet is a chord: the slope is that of the surface above it */
  out[0] *= hypot(x, y);
  out[1] *= hypot(x, y);
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
    return tapered_gradient(s, p, out);
  case SG_KNOWN_SPHERE:
    memcpy(out, p, 3 * sizeof *out);
    return true;
  case SG_KNOWN_TORUS:
    return torus_gradient(p, out);
  case SG_KNOWN_BEZIER:
  case SG_KNOWN_FREE:
    break;
  }
  return false;
}

/* The gradient, of any length, at a point of the model. */
static bool
placed_gradient(const sg_known_surface *s, const double p[3], double out[3])
{
  double from[3], at[3], grad[3];

  for (int k = 0; k < 3; k++) {
    from[k] = (p[k] - s->frame[0][k]) * s->unit;
  }
  for (int i = 0; i < 3; i++) {
    at[i] = sg_dot(s->row[i], from);
  }
  if (!gradient(s, at, grad)) {
    return false;
  }
  for (int k = 0; k < 3; k++) {
    out[k] = grad[0] * s->row[0][k] + grad[1] * s->row[1][k] +
             grad[2] * s->row[2][k];
  }
  return true;
}

bool
sg_known_surface_normal(const sg_known_surface *s, const double p[3],
                        const double facet[3], double out[3])
{
  double size, lean;

  if (!(s->kind == SG_KNOWN_BEZIER
            ? sg_bezier_patch_normal((const double(*)[3])s->frame, p, out)
            : placed_gradient(s, p, out))) {
    return false;
  }
  size = sg_length(out);
  lean = sg_dot(out, facet);
  for (int k = 0; k < 3; k++) {
    out[k] /= lean < 0.0 ? -size : size;
  }
  return fabs(lean) > FARTHEST * size * sg_length(facet);
}

/* ----------------------------------------------------------------- bends */

/* The normal of a side of a meeting at one of its ends. */
static void
normal_at(const sg_known_surfaces *surfaces, const sg_meeting *m, int side,
          int end, double out[3])
{
  int32_t of = sg_known_surface_of(surfaces, m->polygon[side]);

  if (of < 0 || !sg_known_surface_normal(&surfaces->surface[of], m->ends[end],
                                         m->normal[side], out)) {
    memcpy(out, m->normal[side], 3 * sizeof *out);
  }
}

double
sg_known_surfaces_bend(const sg_known_surfaces *surfaces, const sg_meeting *m)
{
  int32_t of[2] = {sg_known_surface_of(surfaces, m->polygon[0]),
                   sg_known_surface_of(surfaces, m->polygon[1])};
  double bend = sg_smaller(m->bend, SG_FACET_BEND);

  if (of[0] < 0 && of[1] < 0) {
    return m->bend;
  }
  for (int end = 0; end < 2 && of[0] != of[1]; end++) {
    double n[2][3];
    normal_at(surfaces, m, 0, end, n[0]);
    normal_at(surfaces, m, 1, end, n[1]);
    bend = sg_larger(bend, sg_angle(n[0], n[1]) * DEGREES);
  }
  return bend;
}

void
sg_known_surfaces_clear(sg_known_surfaces *surfaces)
{
  free(surfaces->surface);
  free(surfaces->of);
  *surfaces = (sg_known_surfaces){0};
}
