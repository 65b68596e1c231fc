/* plane.h -- the nominal plane of a polygon.
 *
 * Layer: kernel. Inexact: it places and measures; signs are exact.h's.
 */
#ifndef SG_PLANE_H
#define SG_PLANE_H

#include <stdbool.h>
#include <stddef.h>

/* n . x + d = 0, n a unit vector pointing outward; d in model units. */
typedef struct sg_plane {
  double n[3], d;
} sg_plane;

/* Newell's normal from ALL directed edges of a polygon, in any order: the sum
 * over the edges of a x b is twice the area times the normal, holes counting
 * negative and seams nothing.
 *
 *   sg_newell sum;
 *   sg_newell_init(&sum);
 *   for each edge: sg_newell_edge(&sum, start, end);
 *   if (!sg_newell_plane(&sum, &plane)) it_has_no_area();
 */
typedef struct sg_newell {
  double origin[3];  /* the first start: what follows is relative to it */
  double doubled[3]; /* twice the area vector */
  double mean[3];    /* sum of the starts */
  size_t n;
} sg_newell;

static inline void
sg_newell_init(sg_newell *sum)
{
  *sum = (sg_newell){.n = 0};
}

/* Here, since every edge of a model goes through it. */
static inline void
sg_newell_edge(sg_newell *sum, const double start[3], const double end[3])
{
  double a[3], b[3];

  for (int k = 0; k < 3; k++) {
    if (sum->n == 0) {
      sum->origin[k] = start[k];
    }
    a[k] = start[k] - sum->origin[k];
    b[k] = end[k] - sum->origin[k];
    sum->mean[k] += a[k];
  }
  sum->doubled[0] += a[1] * b[2] - a[2] * b[1];
  sum->doubled[1] += a[2] * b[0] - a[0] * b[2];
  sum->doubled[2] += a[0] * b[1] - a[1] * b[0];
  sum->n++;
}

/* All three edges of a triangle at once, the first of `sum`: the same numbers.
 */
static inline void
sg_newell_triangle(sg_newell *sum, const double p[3], const double q[3],
                   const double r[3])
{
  double a[3], b[3];

  for (int k = 0; k < 3; k++) {
    sum->origin[k] = p[k];
    a[k] = q[k] - p[k];
    b[k] = r[k] - p[k];
    sum->mean[k] = a[k] + b[k];
  }
  sum->doubled[0] = a[1] * b[2] - a[2] * b[1] + 0.0;
  sum->doubled[1] = a[2] * b[0] - a[0] * b[2] + 0.0;
  sum->doubled[2] = a[0] * b[1] - a[1] * b[0] + 0.0;
  sum->n = 3;
}

/* The plane through the mean of the vertices. False: no edges, an area of
 * exactly 0, or numbers out of range. Components are never -0.0. */
bool sg_newell_plane(const sg_newell *sum, sg_plane *out);

/* The area, always >= 0; model units squared. */
double sg_newell_area(const sg_newell *sum);

/* Signed distance: > 0 outside. A polygon is flat within a tolerance if no
 * vertex is farther than that. */
double sg_plane_distance(const sg_plane *plane, const double point[3]);

#endif
