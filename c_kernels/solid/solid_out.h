/* solid_out.h -- the rows that a solid becomes in a segment.
 *
 * Layer: kernel. First what is counted (sg_solid_rows_make()), so that the
 * store can make room, then every cell in place (sg_solid_rows_write()).
 *
 * Ids are dense, from 1: vertices in the solid's order, those that no triangle
 * has left out; a polygon for each face; its edges, one after another, are the
 * half-edges of its triangles that have no opposite one in the same face, in
 * the order of the triangles; triangles by face.
 */
#ifndef SG_SOLID_OUT_H
#define SG_SOLID_OUT_H

#include "engine/cancel.h"
#include "engine/sheet.h"
#include "solid.h"
#include "thread_pool.h"

/* What becomes of a solid, which must outlive it. */
typedef struct sg_solid_rows {
  const sg_solid *solid;
  uint8_t *border;    /* [triangles]: bit k: the half-edge from corner k ends
                         its face */
  uint32_t *edge;     /* [faces + 1]: edges of the faces before each */
  uint32_t *triangle; /* [faces + 1]: triangles of the faces before each */
  int32_t *id;        /* [vertices]: of v/5, 0: no triangle has it */
  uint32_t *vertex;   /* [vertices]: the vertex with id i + 1 */
  size_t vertices;    /* with an id */
  size_t plain;       /* of those, that were vertices of a segment: the first */
} sg_solid_rows;

/* False: no memory (or more edges than ids), or the cancellation said stop.
 * Owner: sg_solid_rows_clear() in any case. A null thread pool is the caller
 * alone. Exact. */
bool sg_solid_rows_make(const sg_solid *solid, sg_pool *pool,
                        const sg_cancel *cancel, sg_solid_rows *out);
void sg_solid_rows_clear(sg_solid_rows *rows);

/* Room in each relation: v and from_v of `vertices` and `plain` rows, e of
 * edge[faces], p and plane of `faces`, t of `triangles`, from_p of `faces` +
 * `parts`. The lists of p have their lengths: the edges of each face. */
typedef struct sg_solid_sheets {
  const sg_sheet *v, *e, *p, *plane, *t, *from_v, *from_p;
} sg_solid_sheets;

/* Every cell, for segment s. A face without an area has no plane, and a source
 * is named once for a face, so *planes and *sources tell how many rows of plane
 * and from_p there are, the first ones. Planes are by Newell (plane.h),
 * rounded; nothing else is.
 *
 * Returns: false: no memory, or the cancellation said stop. */
bool sg_solid_rows_write(const sg_solid_rows *rows, int32_t s, sg_pool *pool,
                         const sg_cancel *cancel, const sg_solid_sheets *out,
                         size_t *planes, size_t *sources);

#endif
