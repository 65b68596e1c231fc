/* resolve_polygon.h -- one polygon with the shared points and seams it got.
 *
 * Layer: kernel. See resolve.h.
 */
#ifndef SG_RESOLVE_POLYGON_H
#define SG_RESOLVE_POLYGON_H

#include "polygon/triangulate.h"
#include "resolve.h"

/* A row of e/5, with where its ends are (before anything moved). */
typedef struct sg_polygon_row {
  int32_t e, v[2], et;
  double at[2][3];
} sg_polygon_row;

/* A directed edge: a part of row `label`, or a seam (label 0). */
typedef struct sg_resolved_edge {
  int32_t v[2], et, label;
} sg_resolved_edge;

typedef struct sg_resolved_polygon {
  int32_t s, p;
  bool no_area; /* then it has no triangles, before and after */
  SG_LIST_OF(sg_resolved_edge) edge;
  SG_LIST_OF(sg_triangle) triangle;
} sg_resolved_polygon;

/* Divides the edges of polygon out->p of segment out->s, enters its seams and
 * triangulates it, with the points inside it as corners, in `work`, which is
 * empty. Chords are chosen so that no angle is thin (Delaunay) as far as
 * doubles tell. */
sg_resolved sg_resolve_polygon(const sg_resolve *r, const sg_polygon_row *row,
                               size_t rows, sg_work *work,
                               sg_resolved_polygon *out,
                               const sg_cancel *cancel);
void sg_resolved_polygon_clear(sg_resolved_polygon *polygon);

/* Where polygons of different segments have a part in common, bounded by the
 * same points, the later one gets the triangles of the first. Never
 * SG_UNRESOLVED. */
sg_resolved sg_resolve_match(const sg_resolve *r, sg_resolved_polygon *polygon,
                             size_t polygons, const sg_cancel *cancel);

#endif
