/* shading_point.c -- depth and normal at a point of a span. */
#include "number/vector.h"
#include "shading_private.h"

#include <math.h>
#include <string.h>

/* Whether it is the side where the gradient comes towards the eye: by signs,
 * for where it is seen edge-on the gradient itself says what rounding left. */
static bool
faces_eye(const sg_shading_quadric *s, int sense)
{
  return (sense > 0) == (s->q[2] > 0);
}

static double
quadric_depth(const sg_shading_quadric *s, int sense, double x, double y)
{
  const double *q = s->q;
  double a = q[2], b = (q[4] * x + q[5] * y + q[8]) / 2;
  double c = (q[0] * x + q[3] * y + q[6]) * x + (q[1] * y + q[7]) * y + q[9];
  double square = b * b - a * c;
  double root = square > 0 ? sqrt(square) : 0.0;

  /* the side that is nearer, or the other one; without cancelling */
  bool same = faces_eye(s, sense);
  double big = same ? -b - root : -b + root;
  double other = same ? -b + root : -b - root;

  return fabs(other) > fabs(big) ? c / other : a != 0 ? big / a : 0.0;
}

/* The gradient in the picture, with its value at the origin of the axes, of a
 * quadric at a point of it from `at`. */
static void
tangent_plane(const sg_shading_quadric *s, const double p[3], double out[4])
{
  const double *q = s->q;

  out[0] = 2 * q[0] * p[0] + q[3] * p[1] + q[4] * p[2] + q[6];
  out[1] = 2 * q[1] * p[1] + q[3] * p[0] + q[5] * p[2] + q[7];
  out[2] = 2 * q[2] * p[2] + q[4] * p[0] + q[5] * p[1] + q[8];
  out[3] = -(sg_dot(out, p) + sg_dot(out, s->at));
}

void
sg_shading_place(const sg_shading *scene, const double seen[3], double out[3])
{
  double p[4];

  for (int i = 0; i < 4; i++) {
    const double *b = scene->back[i];
    p[i] = b[0] * seen[0] + b[1] * seen[1] + b[2] * seen[2] + b[3];
  }
  for (int k = 0; k < 3; k++) {
    out[k] = p[k] / p[3];
  }
}

/* The normal of the surface that a facet stands for, where it has one. */
static void
known_normal(const sg_shading *scene, const sg_shading_surface *s,
             const double seen[3], double normal[3])
{
  double p[3], out[3];

  sg_shading_place(scene, seen, p);
  if (sg_known_surface_normal(&scene->known.item[s->of - 1], p, s->normal,
                              out)) {
    memcpy(normal, out, sizeof out);
  }
}

/* A unit vector of the model that looks as a plane in the picture does. */
static void
normal_of(const sg_shading *scene, const double plane[4], double way,
          double normal[3])
{
  for (int k = 0; k < 3; k++) {
    normal[k] = 0.0;
    for (int j = 0; j < 4; j++) {
      normal[k] += way * plane[j] * scene->frame.matrix[j][k];
    }
  }
  double length = sg_any_length(normal);
  for (int k = 0; k < 3; k++) {
    normal[k] = length > 0 ? normal[k] / length : 0.0;
  }
}

/* Half of A dA - 2 (B dW + W dB) at a place from `at`, in parts of its size. */
static void
ring_gradient(const sg_shading_torus *torus, const double p[3], double out[3])
{
  double value[3], grad[3][3];

  for (int i = 0; i < 3; i++) {
    const double *q = torus->form[i];
    double *g = grad[i];

    g[0] = q[0] * p[0] + (q[3] * p[1] + q[4] * p[2] + q[6]) / 2;
    g[1] = q[1] * p[1] + (q[3] * p[0] + q[5] * p[2] + q[7]) / 2;
    g[2] = q[2] * p[2] + (q[4] * p[0] + q[5] * p[1] + q[8]) / 2;
    value[i] =
        sg_dot(g, p) + q[9] + (q[6] * p[0] + q[7] * p[1] + q[8] * p[2]) / 2;
  }
  for (int k = 0; k < 3; k++) {
    out[k] = value[0] * grad[0][k] -
             2 * (value[1] * grad[2][k] + value[2] * grad[1][k]);
  }
}

/* A side of a torus, which looks to the eye where it is entered, but for what
 * rounding leaves where it is edge-on. */
static void
ring_point(const sg_shading *scene, const sg_span *span, double x, double y,
           double *depth, double normal[3])
{
  const sg_shading_torus *torus =
      &scene->torus.item[scene->surface.item[span->surface].of];
  sg_ring_line line = sg_ring_line_of(torus, y);
  sg_quartic_root root = (sg_quartic_root)span->sense;
  bool enters = sg_quartic_enters(root);
  double t = (x - line.x) / line.size, c[5], plane[4];

  sg_ring_quartic(&line, t, c);
  double z = sg_quartic_place(c, root);
  double p[3] = {t, (y - torus->at[1]) / torus->size, z};
  ring_gradient(torus, p, plane);
  *depth = line.z + z * line.size;
  plane[3] = -(sg_dot(plane, p) * torus->size + sg_dot(plane, torus->at));
  normal_of(scene, plane, enters ? 1.0 : -1.0, normal);
}

void
sg_shading_point(const sg_shading *scene, const sg_span *span, double x,
                 double y, double *depth, double normal[3])
{
  const sg_shading_surface *s = &scene->surface.item[span->surface];
  const double *at =
      s->kind == SG_IS_QUADRIC ? scene->quadric.item[s->of].at : scene->middle;
  double p[3] = {x - at[0], y - at[1], 0}, plane[4];

  if (s->kind == SG_IS_RING) {
    ring_point(scene, span, x, y, depth, normal);
    return;
  }
  if (s->kind == SG_IS_PLANE) {
    *depth =
        at[2] - (fabs(s->q[2]) < SG_EDGE_ON
                     ? 0.0
                     : (s->q[0] * p[0] + s->q[1] * p[1] + s->q[3]) / s->q[2]);
    memcpy(normal, s->normal, 3 * sizeof *normal);
    if (s->of > 0) {
      known_normal(scene, s, (double[3]){x, y, *depth}, normal);
    }
    return;
  }
  const sg_shading_quadric *quadric = &scene->quadric.item[s->of];
  p[2] = quadric_depth(quadric, span->sense, p[0], p[1]);
  *depth = at[2] + p[2];
  tangent_plane(quadric, p, plane);
  normal_of(scene, plane, faces_eye(quadric, span->sense) ? 1.0 : -1.0, normal);
}

bool
sg_shading_is_faceted(const sg_shading *scene, const sg_span *span)
{
  const sg_shading_surface *s = &scene->surface.item[span->surface];

  return s->kind == SG_IS_PLANE && s->of > 0;
}

bool
sg_shading_is_flat(const sg_shading *scene, const sg_span *span)
{
  const sg_shading_surface *s = &scene->surface.item[span->surface];

  return s->kind == SG_IS_PLANE && s->of == 0;
}
