/* boundary_again.c -- a boundary_mesh as a boundary (boundary_mesh.h). */
#include "boundary_mesh.h"

#include "polygon/plane.h"

#include <stdlib.h>
#include <string.h>

static bool
has_area(const sg_boundary_mesh *mesh, size_t t)
{
  const double(*at)[3] = (const double(*)[3])mesh->mesh.vertex;
  const int32_t *v = mesh->triangle[t];
  sg_newell sum;
  sg_plane plane;

  sg_newell_init(&sum);
  for (int k = 0; k < 3; k++) {
    sg_newell_edge(&sum, at[v[k]], at[v[(k + 1) % 3]]);
  }
  return sg_newell_plane(&sum, &plane);
}

static bool
open_boundary(const sg_boundary_mesh *mesh, sg_boundary *out)
{
  size_t v = mesh->mesh.vertices + 1, t = mesh->triangles + 1;

  out->at = malloc(v * sizeof *out->at);
  out->was = malloc(v * sizeof *out->was);
  out->moved = malloc(v);
  out->begin = malloc(t * sizeof *out->begin);
  out->edge = malloc(3 * t * sizeof *out->edge);
  out->changed = malloc(t);
  out->turned = malloc(t);
  return out->at && out->was && out->moved && out->begin && out->edge &&
         out->changed && out->turned;
}

static void
put_triangle(const sg_boundary_mesh *mesh, size_t t, sg_boundary *out)
{
  for (int k = 0; k < 3; k++) {
    out->edge[3 * t + (size_t)k][0] = mesh->triangle[t][k];
    out->edge[3 * t + (size_t)k][1] = mesh->triangle[t][(k + 1) % 3];
  }
  out->begin[t + 1] = (uint32_t)(3 * t + 3);
  out->changed[t] = mesh->changed[t];
  out->turned[t] = has_area(mesh, t) ? SG_UPRIGHT : SG_NO_AREA;
}

bool
sg_boundary_of_mesh(const sg_boundary_mesh *mesh, sg_boundary *out, bool *any)
{
  *out = (sg_boundary){0};
  *any = false;
  for (size_t t = 0; t < mesh->triangles && !*any; t++) {
    *any = mesh->changed[t] && !has_area(mesh, t);
  }
  if (!*any) {
    return true;
  }
  if (!open_boundary(mesh, out)) {
    return false;
  }
  out->grain = mesh->mesh.grain;
  out->vertices = mesh->mesh.vertices;
  out->faces = mesh->triangles;
  memcpy(out->at, mesh->mesh.vertex, out->vertices * sizeof *out->at);
  memcpy(out->was, mesh->mesh.vertex, out->vertices * sizeof *out->was);
  memset(out->moved, 1, out->vertices);
  out->begin[0] = 0;
  for (size_t t = 0; t < out->faces; t++) {
    put_triangle(mesh, t, out);
  }
  return true;
}
