/* solid_seams.h -- rows of a solid whose faces end where others do.
 *
 * Layer: kernel. Of what is glued an edge of one face may run in the middle of
 * another, and a vertex may lie there. Then the edge is a seam of that other
 * one, there and back, and the vertex a point loop (gluing/regions.h).
 */
#ifndef SG_SOLID_SEAMS_H
#define SG_SOLID_SEAMS_H

#include "solid_out.h"

/* Counts the half-edges of rows again: one between two triangles of a face ends
 * it too if another face has the edge.
 *
 * Returns: false: no memory (or more edges than ids), or stopped. */
bool sg_solid_rows_seams(sg_solid_rows *rows, const sg_cancel *cancel);

/* Vertex v (an id) lies in the middle of face f. */
typedef struct sg_face_point {
  int32_t v;
  uint32_t f;
} sg_face_point;

/* The corners of triangles of faces at which none of their own edges ends, by
 * face, then by vertex.
 *
 * Returns: false: no memory, or stopped. Owner of *out: caller, free(). */
bool sg_solid_rows_points(const sg_solid_rows *rows, const sg_cancel *cancel,
                          sg_face_point **out, size_t *n);

#endif
