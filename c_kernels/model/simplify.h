/* simplify.h -- a mesh of triangles with fewer of them.
 *
 * Layer: kernel. Edges are contracted one by one, the one first that costs
 * least, after Garland and Heckbert (Surface Simplification Using Quadric Error
 * Metrics, SIGGRAPH 1997): a vertex remembers the planes of the triangles that
 * went into it, by their areas, and the cost is the sum of the squared
 * distances from them. Beside them stand planes across the triangles at borders
 * and at creases, which so keep their lines.
 *
 *  - What is closed stays closed, and every border a border: an edge is
 *    contracted only if that leaves each neighbour its fan.
 *  - Where it costs nothing, a vertex stays exactly in its place. So flat faces
 *    stay flat, but for rounding, and corners of flat faces where they were.
 *  - No triangle is turned over or loses its area. Whether the mesh goes
 *    through itself is not looked at here: see self_cut.h.
 *  - Vertices of edges with more or other than two opposite half-edges, and
 *    those with several fans, stay where they are.
 *
 * Costs are rounded; the result depends on the mesh alone. Time: n log n.
 */
#ifndef SG_SIMPLIFY_H
#define SG_SIMPLIFY_H

#include "engine/cancel.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct sg_simplified {
  size_t vertices;      /* of the mesh it was made from */
  double (*at)[3];      /* [vertices] model units; of those that are left */
  int32_t *into;        /* [vertices] the vertex that it went into, or itself */
  size_t triangles;     /* that are left, in their order */
  int32_t (*corner)[3]; /* [triangles] */
  int32_t *triangle_of; /* [triangles] which it was */
} sg_simplified;

typedef struct sg_simplify_mesh {
  size_t vertices, triangles; /* fewer than 2^31 / 3 */
  double (*at)[3];            /* these are only read */
  int32_t (*corner)[3];
  const double *weight; /* [vertices] how much it matters there, or null: 1 */
} sg_simplify_mesh;

/* At most `most` triangles, if so few can be had. False: no memory, or
 * (*stopped) stopped by the cancellation. Owner: sg_simplified_clear() in any
 * case. */
bool sg_simplify(const sg_simplify_mesh *mesh, size_t most,
                 const sg_cancel *cancel, sg_simplified *out, bool *stopped);
void sg_simplified_clear(sg_simplified *simplified);

#endif
