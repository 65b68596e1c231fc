/* mesh_export.h -- segments as a mesh that can be written.
 *
 * Layer: kernel.
 */
#ifndef SG_MESH_EXPORT_H
#define SG_MESH_EXPORT_H

#include "mesh.h"
#include "rows/dense.h"

typedef enum sg_export_status {
  SG_EXPORT_DONE,
  SG_EXPORT_NO_MEMORY,
  SG_EXPORT_NO_TRIANGLES /* a polygon that needs its triangles has none */
} sg_export_status;

/* Every segment of `dense` as a segment of the mesh, unnamed.
 *
 * A polygon that is one loop stays a polygon; its seams (pairs of opposite
 * edges in it) are left out. One with holes or several parts becomes its
 * triangles, as do all but triangles if `triangles`. Real edges that are in no
 * polygon become curves, unless `triangles`.
 *
 * Returns: DONE: *out filled, sg_mesh_clear() it. NO_TRIANGLES: *polygon is the
 *          place of the first such polygon.
 */
sg_export_status sg_mesh_export(const sg_dense *dense, bool triangles,
                                sg_mesh *out, size_t *polygon);

#endif
