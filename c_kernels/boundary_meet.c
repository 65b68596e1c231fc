/* boundary_meet.c -- where a boundary_mesh goes through itself. */
#include "boundary_mesh.h"

#include <stdlib.h>

/* A mesh as a segment: the arrays stay the mesh's. */
static sg_dense
segment_of(const sg_boundary_mesh *m, uint32_t begin[4][2], int32_t *ids,
           int32_t *places, int32_t *to)
{
  const sg_mesh_lists *face = &m->mesh.face;

  for (size_t f = 0; f < face->count; f++) {
    for (uint32_t i = face->start[f]; i < face->start[f + 1]; i++) {
      to[i] = face->corner[i + 1 < face->start[f + 1] ? i + 1 : face->start[f]];
      places[i] = (int32_t)i;
    }
    ids[f] = (int32_t)f + 1;
  }
  begin[0][1] = (uint32_t)m->mesh.vertices;
  begin[1][1] = (uint32_t)face->corners;
  begin[2][1] = (uint32_t)face->count;
  begin[3][1] = (uint32_t)m->triangles;
  return (sg_dense){.segments = 1,
                    .vertex_begin = begin[0],
                    .edge_begin = begin[1],
                    .polygon_begin = begin[2],
                    .triangle_begin = begin[3],
                    .vertices = m->mesh.vertices,
                    .at = m->mesh.vertex,
                    .edges = face->corners,
                    .from = face->corner,
                    .to = to,
                    .polygons = face->count,
                    .polygon_id = ids,
                    .list_begin = face->start,
                    .list = places,
                    .triangles = m->triangles,
                    .polygon_of = m->face_of,
                    .corner = m->triangle};
}

bool
sg_boundary_mesh_meetings(const sg_boundary_mesh *mesh, bool all,
                          double tolerance, sg_crew *crew, const sg_poll *poll,
                          sg_self_meetings *out)
{
  size_t corners = mesh->mesh.face.corners, faces = mesh->mesh.face.count;
  uint32_t begin[4][2] = {{0}};
  int32_t *ids = malloc((faces + 1) * sizeof *ids);
  int32_t *places = malloc((corners + 1) * sizeof *places);
  int32_t *to = malloc((corners + 1) * sizeof *to);
  bool done = ids && places && to;

  *out = (sg_self_meetings){0};
  if (done && faces > 0) {
    sg_dense dense = segment_of(mesh, begin, ids, places, to);
    done = all ? sg_self_cut(&dense, 0, tolerance, crew, poll, out)
               : sg_self_cut_changed(&dense, 0, mesh->changed, tolerance, crew,
                                     poll, out);
  }
  free(ids);
  free(places);
  free(to);
  return done;
}
