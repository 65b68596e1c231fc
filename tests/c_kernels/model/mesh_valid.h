/* mesh_valid.h -- whether a mesh is sound, for tests. */
#ifndef MESH_VALID_H
#define MESH_VALID_H

#include "model/mesh.h"

#include <math.h>

static bool
lists_are_valid(const sg_mesh *mesh, const sg_mesh_lists *lists, size_t least)
{
  if (lists->count == 0) {
    return lists->corners == 0;
  }
  for (size_t i = 0; i < lists->count; i++) {
    if (lists->start[i + 1] < lists->start[i] + least ||
        lists->segment[i] < 0 || (size_t)lists->segment[i] >= mesh->segments) {
      return false;
    }
  }
  for (size_t i = 0; i < lists->corners; i++) {
    if (lists->corner[i] < 0 || (size_t)lists->corner[i] >= mesh->vertices) {
      return false;
    }
  }
  return lists->start[0] == 0 && lists->start[lists->count] == lists->corners;
}

/* True if every index, list and coordinate of `mesh` is in range. */
static bool
mesh_is_valid(const sg_mesh *mesh)
{
  for (size_t i = 0; i < mesh->vertices; i++) {
    const double *p = mesh->vertex[i];
    if (!isfinite(p[0]) || !isfinite(p[1]) || !isfinite(p[2])) {
      return false;
    }
  }
  return lists_are_valid(mesh, &mesh->face, 3) &&
         lists_are_valid(mesh, &mesh->curve, 2);
}

#endif
