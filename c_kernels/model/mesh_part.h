/* mesh_part.h -- a mesh by segments: each with its own vertices, numbered from
 * 1, and its faces and curves in the order of the file.
 *
 * Layer: kernel.
 */
#ifndef SG_MESH_PART_H
#define SG_MESH_PART_H

#include "mesh.h"

/* One segment. The directed edges of its faces come first, face by face, then
 * those of its curves; edge i (from 0) runs from[i] -> to[i], vertices counted
 * from 0 in vertex[]. */
typedef struct sg_mesh_part {
  const char *name; /* null: unnamed */
  size_t vertices;
  const int32_t *vertex; /* [vertices] numbers in the mesh, ascending */
  size_t faces;
  const uint32_t *start; /* [faces + 1] first edge of each face */
  size_t edges;
  const int32_t *from, *to; /* [edges] */
  bool closed;              /* it has faces, and every edge has its opposite */
} sg_mesh_part;

typedef struct sg_mesh_parts sg_mesh_parts;

/* Null: no memory. With one segment its vertices are all of the mesh; with
 * several those that it uses. The mesh must outlive the parts. */
sg_mesh_parts *sg_mesh_parts_open(const sg_mesh *mesh);
void sg_mesh_parts_close(sg_mesh_parts *parts);

/* Segment s; *out is valid until the next call. False: no memory, or (*stopped)
 * stopped by the cancellation. */
bool sg_mesh_parts_get(sg_mesh_parts *parts, size_t s, const sg_cancel *cancel,
                       sg_mesh_part *out, bool *stopped);

#endif
