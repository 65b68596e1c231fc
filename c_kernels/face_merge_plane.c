/* face_merge_plane.c -- sizes and planes of faces: see face_merge_private.h.
 *
 * Layer: kernel. Inexact; sums run over the triangles in their order.
 */
#include "face_merge_private.h"

#include <math.h>
#include <string.h>

static void
less(const double a[3], const double b[3], double out[3])
{
  for (int k = 0; k < 3; k++) {
    out[k] = a[k] - b[k];
  }
}

static double
dot(const double a[3], const double b[3])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Adds the area vector of a triangle. */
static void
add_area(const sg_merge *m, const uint32_t corner[3], double sum[3])
{
  double u[3], v[3];

  less(sg_merge_at(m, corner[1]), sg_merge_at(m, corner[0]), u);
  less(sg_merge_at(m, corner[2]), sg_merge_at(m, corner[0]), v);
  for (int k = 0; k < 3; k++) {
    int i = (k + 1) % 3, j = (k + 2) % 3;
    sum[k] += (u[i] * v[j] - u[j] * v[i]) / 2;
  }
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
  out->area = sqrt(dot(out->vector, out->vector));
  out->length = sqrt(dot(high, high));
}

bool
sg_merge_is_thin(const sg_merge *m, const sg_face_size *size)
{
  return !(size->area > m->tolerance * size->length);
}

bool
sg_merge_is_near(const sg_merge *m, const sg_plane *plane, uint32_t face)
{
  const sg_solid_face *row = &m->solid->face[face];

  for (uint32_t t = row->first; t < row->first + row->n; t++) {
    for (int i = 0; i < 3; i++) {
      const double *at = sg_merge_at(m, m->solid->triangle[t][i]);
      if (!(fabs(sg_plane_distance(plane, at)) <= m->tolerance)) {
        return false;
      }
    }
  }
  return true;
}

/* ---- fitting ------------------------------------------------------------ */

/* The faces, and the mean of their corners. */
typedef struct face_set {
  const sg_merge *m;
  const uint32_t *face;
  size_t n;
  double centre[3];
} face_set;

typedef void visit(void *data, const double from_centre[3]);

/* Of all corners, from the centre. */
static void
each_corner(const face_set *set, visit *see, void *data)
{
  const sg_solid *solid = set->m->solid;

  for (size_t i = 0; i < set->n; i++) {
    const sg_solid_face *row = &solid->face[set->face[i]];
    for (uint32_t t = row->first; t < row->first + row->n; t++) {
      for (int k = 0; k < 3; k++) {
        double at[3];
        less(sg_merge_at(set->m, solid->triangle[t][k]), set->centre, at);
        see(data, at);
      }
    }
  }
}

typedef struct vector_sum {
  double sum[3], n;
} vector_sum;

static void
see_mean(void *data, const double at[3])
{
  vector_sum *mean = data;

  for (int k = 0; k < 3; k++) {
    mean->sum[k] += at[k];
  }
  mean->n++;
}

/* Sums run from a corner, so that they are right far from the origin too. */
static void
find_centre(face_set *set)
{
  const sg_merge *m = set->m;
  uint32_t t = m->solid->face[set->face[0]].first;
  vector_sum mean = {{0, 0, 0}, 0};

  memcpy(set->centre, sg_merge_at(m, m->solid->triangle[t][0]),
         sizeof set->centre);
  each_corner(set, see_mean, &mean);
  for (int k = 0; k < 3; k++) {
    set->centre[k] += mean.sum[k] / mean.n;
  }
}

typedef struct extent {
  double normal[3], low, high;
} extent;

static void
see_range(void *data, const double at[3])
{
  extent *range = data;
  double x = dot(range->normal, at);

  range->low = x < range->low ? x : range->low;
  range->high = x > range->high ? x : range->high;
}

/* The plane of this normal in the middle of all corners; returns how far off
 * the farthest is. */
static double
middle_plane(const face_set *set, const double normal[3], sg_plane *out)
{
  extent range = {{normal[0], normal[1], normal[2]}, INFINITY, -INFINITY};

  each_corner(set, see_range, &range);
  memcpy(out->n, normal, sizeof out->n);
  out->d = -dot(normal, set->centre) - (range.low + range.high) / 2;
  return (range.high - range.low) / 2;
}

/* Moments in a frame whose third axis is the normal. */
typedef struct moments {
  double axis[3][3];
  double xx, xy, yy, xz, yz;
} moments;

static void
see_moments(void *data, const double at[3])
{
  moments *s = data;
  double x = dot(s->axis[0], at), y = dot(s->axis[1], at);
  double z = dot(s->axis[2], at);

  s->xx += x * x;
  s->xy += x * y;
  s->yy += y * y;
  s->xz += x * z;
  s->yz += y * z;
}

static bool
to_unit(double v[3])
{
  double length = sqrt(dot(v, v));

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
  each_corner(set, see_moments, &s);
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
  const sg_solid *solid = m->solid;
  face_set set = {m, face, n, {0, 0, 0}};
  double normal[3] = {0, 0, 0};

  for (size_t i = 0; i < n; i++) {
    const sg_solid_face *row = &solid->face[face[i]];
    for (uint32_t t = row->first; t < row->first + row->n; t++) {
      add_area(m, solid->triangle[t], normal);
    }
  }
  find_centre(&set);
  return to_unit(normal) && (middle_plane(&set, normal, out) <= m->tolerance ||
                             (tilt(&set, normal) &&
                              middle_plane(&set, normal, out) <= m->tolerance));
}
