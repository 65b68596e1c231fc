/* face_merge_plane.c -- sizes and planes of faces: see face_merge_private.h.
 *
 * Layer: kernel. Inexact; sums run over the triangles in their order.
 */
#include "face_merge_private.h"
#include "number/vector.h"

#include <math.h>
#include <string.h>

static inline void
less(const double a[3], const double b[3], double out[3])
{
  for (int k = 0; k < 3; k++) {
    out[k] = a[k] - b[k];
  }
}

/* Adds the area vector of a triangle. */
static void
add_area(const sg_merge *m, const uint32_t corner[3], double sum[3])
{
  double u[3], v[3];

  less(sg_merge_at(m, corner[1]), sg_merge_at(m, corner[0]), u);
  less(sg_merge_at(m, corner[2]), sg_merge_at(m, corner[0]), v);
  sum[0] += (u[1] * v[2] - u[2] * v[1]) / 2;
  sum[1] += (u[2] * v[0] - u[0] * v[2]) / 2;
  sum[2] += (u[0] * v[1] - u[1] * v[0]) / 2;
}

void
sg_merge_size(const sg_merge *m, uint32_t face, sg_face_size *out)
{
  const sg_solid_face *row = &m->solid->face[face];
  double low[3], high[3];

  *out = (sg_face_size){0};
  memcpy(low, sg_merge_at(m, m->solid->triangle[row->first][0]), sizeof low);
  memcpy(high, low, sizeof high);
  for (uint32_t t = row->first; t < row->first + row->n; t++) {
    add_area(m, m->solid->triangle[t], out->vector);
    for (int i = 0; i < 3; i++) {
      const double *at = sg_merge_at(m, m->solid->triangle[t][i]);
      for (int k = 0; k < 3; k++) {
        low[k] = at[k] < low[k] ? at[k] : low[k];
        high[k] = at[k] > high[k] ? at[k] : high[k];
        out->centre[k] += at[k];
      }
    }
  }
  less(high, low, high);
  out->area = sqrt(sg_dot(out->vector, out->vector));
  out->length = sqrt(sg_dot(high, high));
}

bool
sg_merge_is_thin(const sg_merge *m, const sg_face_size *size)
{
  return !(size->area > m->tolerance * size->length);
}

bool
sg_merge_is_near(const sg_merge *m, const sg_plane *plane, uint32_t face,
                 double most)
{
  const sg_solid_face *row = &m->solid->face[face];

  for (uint32_t t = row->first; t < row->first + row->n; t++) {
    for (int i = 0; i < 3; i++) {
      const double *at = sg_merge_at(m, m->solid->triangle[t][i]);
      if (!(fabs(sg_plane_distance(plane, at)) <= most)) {
        return false;
      }
    }
  }
  return true;
}

/* ---- fitting ------------------------------------------------------------ */

/* Faces, and the mean of their corners. */
typedef struct face_set {
  const sg_merge *m;
  const uint32_t *face;
  size_t n;
  double centre[3];
} face_set;

/* Sums of areas and places, these from a corner, so that they are right far
 * from the origin too. */
static void
find_centre(face_set *set, double normal[3])
{
  const sg_solid *solid = set->m->solid;
  const uint32_t *first = solid->triangle[solid->face[set->face[0]].first];
  const double *from = sg_merge_at(set->m, first[0]);
  double sum[3] = {0, 0, 0}, corners = 0;

  for (size_t i = 0; i < set->n; i++) {
    const sg_solid_face *row = &solid->face[set->face[i]];
    corners += 3 * (double)row->n;
    for (uint32_t t = row->first; t < row->first + row->n; t++) {
      const uint32_t *corner = solid->triangle[t];
      add_area(set->m, corner, normal);
      for (int k = 0; k < 3; k++) {
        sum[k] += sg_merge_at(set->m, corner[0])[k] - from[k];
        sum[k] += sg_merge_at(set->m, corner[1])[k] - from[k];
        sum[k] += sg_merge_at(set->m, corner[2])[k] - from[k];
      }
    }
  }
  for (int k = 0; k < 3; k++) {
    set->centre[k] = from[k] + sum[k] / corners;
  }
}

/* The plane of this normal in the middle of all corners; returns how far off
 * the farthest is. */
static double
middle_plane(const face_set *set, const double normal[3], sg_plane *out)
{
  const sg_solid *solid = set->m->solid;
  double low = INFINITY, high = -INFINITY;

  for (size_t i = 0; i < set->n; i++) {
    const sg_solid_face *row = &solid->face[set->face[i]];
    for (uint32_t t = row->first; t < row->first + row->n; t++) {
      for (int k = 0; k < 3; k++) {
        double from[3];
        less(sg_merge_at(set->m, solid->triangle[t][k]), set->centre, from);
        double x = sg_dot(normal, from);
        low = x < low ? x : low;
        high = x > high ? x : high;
      }
    }
  }
  memcpy(out->n, normal, sizeof out->n);
  out->d = -sg_dot(normal, set->centre) - (low + high) / 2;
  return (high - low) / 2;
}

/* Moments in a frame whose third axis is the normal. */
typedef struct moments {
  double axis[3][3];
  double xx, xy, yy, xz, yz;
} moments;

static void
add_moments(moments *s, const double at[3])
{
  double x = sg_dot(s->axis[0], at), y = sg_dot(s->axis[1], at);
  double z = sg_dot(s->axis[2], at);

  s->xx += x * x;
  s->xy += x * y;
  s->yy += y * y;
  s->xz += x * z;
  s->yz += y * z;
}

static void
find_moments(const face_set *set, moments *out)
{
  const sg_solid *solid = set->m->solid;

  for (size_t i = 0; i < set->n; i++) {
    const sg_solid_face *row = &solid->face[set->face[i]];
    for (uint32_t t = row->first; t < row->first + row->n; t++) {
      for (int k = 0; k < 3; k++) {
        double from[3];
        less(sg_merge_at(set->m, solid->triangle[t][k]), set->centre, from);
        add_moments(out, from);
      }
    }
  }
}

static bool
to_unit(double v[3])
{
  double length = sqrt(sg_dot(v, v));

  for (int k = 0; k < 3; k++) {
    v[k] /= length;
  }
  return length > 0 && isfinite(length);
}

static void
make_frame(double axis[3][3])
{
  const double *n = axis[2];
  int least = 0;

  for (int k = 1; k < 3; k++) {
    least = fabs(n[k]) < fabs(n[least]) ? k : least;
  }
  for (int k = 0; k < 3; k++) {
    axis[0][k] = (k == least) - n[least] * n[k];
  }
  to_unit(axis[0]);
  for (int k = 0; k < 3; k++) {
    int i = (k + 1) % 3, j = (k + 2) % 3;
    axis[1][k] = n[i] * axis[0][j] - n[j] * axis[0][i];
  }
}

/* Tilts the normal so that the squares of the distances are least. */
static bool
tilt(const face_set *set, double normal[3])
{
  moments s = {0};

  memcpy(s.axis[2], normal, sizeof s.axis[2]);
  make_frame(s.axis);
  find_moments(set, &s);
  double determinant = s.xx * s.yy - s.xy * s.xy;
  if (!(determinant > 1e-20 * s.xx * s.yy)) {
    return false; /* all on a line */
  }
  double a = (s.xz * s.yy - s.yz * s.xy) / determinant;
  double b = (s.yz * s.xx - s.xz * s.xy) / determinant;
  for (int k = 0; k < 3; k++) {
    normal[k] -= a * s.axis[0][k] + b * s.axis[1][k];
  }
  return to_unit(normal);
}

bool
sg_merge_fit(const sg_merge *m, const uint32_t *face, size_t n, sg_plane *out)
{
  face_set set = {m, face, n, {0, 0, 0}};
  double normal[3] = {0, 0, 0};

  find_centre(&set, normal);
  return to_unit(normal) && (middle_plane(&set, normal, out) <= m->tolerance ||
                             (tilt(&set, normal) &&
                              middle_plane(&set, normal, out) <= m->tolerance));
}
