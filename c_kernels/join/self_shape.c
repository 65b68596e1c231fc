/* self_shape.c -- sizes and places in doubles (self_shape.h). */
#include "self_shape.h"
#include "number/vector.h"

#include <math.h>
#include <string.h>

void
sg_shape_normalise(double v[3])
{
  double size = sg_any_length(v);

  for (int k = 0; k < 3 && size > 0; k++) {
    v[k] /= size;
  }
}

void
sg_shape_normal(const double t[3][3], double out[3])
{
  double u[3], v[3];

  sg_minus(t[1], t[0], u);
  sg_minus(t[2], t[0], v);
  sg_cross(u, v, out);
}

static void
unit_normal(const double t[3][3], double out[3])
{
  double u[3], v[3];

  sg_minus(t[1], t[0], u);
  sg_minus(t[2], t[0], v);
  sg_shape_normalise(u);
  sg_shape_normalise(v);
  sg_cross(u, v, out);
  sg_shape_normalise(out);
}

sg_depth
sg_shape_depth(const double a[3][3], const double b[3][3])
{
  double n[3];
  sg_depth depth = {0, 0};

  unit_normal(b, n);
  for (int i = 0; i < 3; i++) {
    double off[3];

    sg_minus(a[i], b[0], off);
    depth.above = fmax(depth.above, sg_dot(n, off));
    depth.below = fmax(depth.below, -sg_dot(n, off));
  }
  return depth;
}

/* How far b reaches over the edges of a, at least. */
static double
reach_over_edges(const double a[3][3], const double b[3][3])
{
  double n[3], least = INFINITY;

  unit_normal(a, n);
  for (int i = 0; i < 3; i++) {
    double along[3], inward[3], most = 0;

    sg_minus(a[(i + 1) % 3], a[i], along);
    sg_shape_normalise(along);
    sg_cross(n, along, inward);
    for (int j = 0; j < 3; j++) {
      double off[3];

      sg_minus(b[j], a[i], off);
      most = fmax(most, sg_dot(inward, off));
    }
    least = fmin(least, most);
  }
  return least;
}

double
sg_shape_overlap(const double a[3][3], const double b[3][3])
{
  return fmin(reach_over_edges(a, b), reach_over_edges(b, a));
}

/* ---- the end of a cut --------------------------------------------------- */

/* Where the edge i of t meets the plane through o across n; its start if it
 * runs along it. */
static void
edge_at_plane(const double t[3][3], int i, const double o[3], const double n[3],
              double out[3])
{
  const double *u = t[i], *w = t[(i + 1) % 3];
  double from[3], to[3];

  sg_minus(u, o, from);
  sg_minus(w, o, to);
  double low = sg_dot(n, from), high = sg_dot(n, to);
  double part = low / (low - high);

  part = part > 0 ? fmin(part, 1) : 0;
  for (int k = 0; k < 3; k++) {
    out[k] = u[k] + part * (w[k] - u[k]);
  }
}

/* Where edge i of a crosses edge j of b: the plane through b's edge that looks
 * most at a's. */
static void
edge_at_edge(const double a[3][3], int i, const double b[3][3], int j,
             double out[3])
{
  double e[3], f[3], both[3], n[3];

  sg_minus(a[(i + 1) % 3], a[i], e);
  sg_minus(b[(j + 1) % 3], b[j], f);
  sg_shape_normalise(e);
  sg_shape_normalise(f);
  sg_cross(e, f, both);
  sg_cross(f, both, n);
  edge_at_plane(a, i, b[j], n, out);
}

void
sg_shape_end(const double a[3][3], const double b[3][3], const sg_cut_end *end,
             double out[3])
{
  sg_feature f = end->f[0], g = end->f[1];
  double n[3];

  if (f <= SG_CORNER_2) {
    memcpy(out, a[f], 3 * sizeof *out);
  } else if (g <= SG_CORNER_2) {
    memcpy(out, b[g], 3 * sizeof *out);
  } else if (f <= SG_EDGE_2 && g <= SG_EDGE_2) {
    edge_at_edge(a, (int)(f - SG_EDGE_0), b, (int)(g - SG_EDGE_0), out);
  } else if (f <= SG_EDGE_2) {
    unit_normal(b, n);
    edge_at_plane(a, (int)(f - SG_EDGE_0), b[0], n, out);
  } else {
    unit_normal(a, n);
    edge_at_plane(b, (int)(g - SG_EDGE_0), a[0], n, out);
  }
}

/* ---- what polygons share ------------------------------------------------ */

static double
distance_to_edge(const double u[3], const double w[3], const double at[3])
{
  double along[3], off[3];

  sg_minus(w, u, along);
  sg_minus(at, u, off);
  double square = sg_dot(along, along);
  double part = square > 0 ? sg_dot(along, off) / square : 0;

  part = part > 0 ? fmin(part, 1) : 0;
  for (int k = 0; k < 3; k++) {
    off[k] -= part * along[k];
  }
  return sg_any_length(off);
}

static uint32_t
place_of(const sg_self_model *m, int32_t vertex)
{
  return m->place[(uint32_t)vertex - m->first];
}

/* Half-edge e, or its ends alone, are in polygon p: bits 1 and 2 for its ends,
 * 4 for all of it. */
static int
in_polygon(const sg_self_model *m, int32_t e, int32_t p)
{
  const sg_dense *d = m->d;
  uint32_t u = place_of(m, d->from[e]), w = place_of(m, d->to[e]);
  int in = 0;

  for (size_t k = d->list_begin[p]; k < d->list_begin[p + 1]; k++) {
    uint32_t from = place_of(m, d->from[d->list[k]]);
    uint32_t to = place_of(m, d->to[d->list[k]]);

    in |= (from == u || to == u) | (from == w || to == w) << 1 |
          ((from == u && to == w) || (from == w && to == u)) << 2;
  }
  return in;
}

bool
sg_shape_is_shared(const sg_self_model *m, const int32_t polygon[2],
                   const double at[3])
{
  const sg_dense *d = m->d;

  for (size_t k = d->list_begin[polygon[0]]; k < d->list_begin[polygon[0] + 1];
       k++) {
    const double *u = d->at[d->from[d->list[k]]];
    const double *w = d->at[d->to[d->list[k]]];

    if (distance_to_edge(u, w, at) > m->tolerance) {
      continue;
    }
    int in = in_polygon(m, d->list[k], polygon[1]);

    if ((in & 4) || ((in & 1) && distance_to_edge(u, u, at) <= m->tolerance) ||
        ((in & 2) && distance_to_edge(w, w, at) <= m->tolerance)) {
      return true;
    }
  }
  return false;
}
