/* dense.h -- segments as flat arrays: places from 0 instead of ids.
 *
 * Layer: kernel. What kernels that walk a whole model work on. Everything is in
 * the order of segment and id, whatever the order of the rows, so that results
 * do not depend on how a model was made.
 */
#ifndef SG_DENSE_H
#define SG_DENSE_H

#include "engine/cancel.h"
#include "engine/column.h"

/* The things of segment i (a place) are begin[i] .. begin[i + 1] - 1. */
typedef struct sg_dense {
  size_t segments;
  int32_t *segment; /* [segments] numbers, ascending */
  double *grain;    /* [segments] of their sources (polygon/flatness.h), which
                       whoever knows the store fills in; else 0 */
  uint32_t *vertex_begin, *edge_begin, *polygon_begin, *triangle_begin;

  size_t vertices;
  int32_t *vertex_id;
  double (*at)[3];

  size_t edges;
  int32_t *edge_id;
  int32_t *from, *to;  /* places of vertices */
  unsigned char *real; /* Et */

  size_t polygons;
  int32_t *polygon_id;
  uint32_t *list_begin; /* [polygons + 1] */
  int32_t *list;        /* places of edges */

  size_t triangles;
  int32_t *triangle_id;
  int32_t *polygon_of;  /* places of polygons */
  int32_t (*corner)[3]; /* places of vertices */
} sg_dense;

/* Views of v/5, e/5, p/3 and t/6, of one version. */
typedef struct sg_dense_views {
  sg_view v, e, p, t;
} sg_dense_views;

/* The n segments `wanted`, ascending; null: all that have a vertex, an edge or
 * a polygon.
 *
 * Requires: references are sound (the store sees to it).
 * Returns:  false: no memory, or (*stopped) stopped by the cancellation.
 * Owner:    sg_dense_clear() in any case.
 */
bool sg_dense_make(const sg_dense_views *views, const int32_t *wanted, size_t n,
                   const sg_cancel *cancel, sg_dense *out, bool *stopped);
void sg_dense_clear(sg_dense *dense);

/* The triangles of polygon p (places), in order:
 * triangle[begin[p]] .. triangle[begin[p + 1] - 1]. False: no memory.
 * Owner: the caller, free() both in any case. */
bool sg_dense_by_polygon(const sg_dense *dense, uint32_t **begin,
                         uint32_t **triangle);

/* The place of vertex v of segment s, -1: there is none. */
int32_t sg_dense_vertex(const sg_dense *dense, int32_t s, int32_t v);

/* The same of polygon p, and of triangle t. */
int32_t sg_dense_polygon(const sg_dense *dense, int32_t s, int32_t p);
int32_t sg_dense_triangle(const sg_dense *dense, int32_t s, int32_t t);

/* The segment (a place) that a vertex, an edge, ... of this place is in. */
size_t sg_dense_segment_of(const sg_dense *dense, const uint32_t *begin,
                           uint32_t place);

#endif
