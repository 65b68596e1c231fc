/* simplify_rows.c -- segments of the current world with fewer triangles.
 *
 * Layer: rows. All segments together: where detail costs least it goes first,
 * whichever it is of.
 */
#include "mesh_rows.h"
#include "rows/dense_rows.h"
#include "simplify.h"

#include <stdlib.h>
#include <string.h>

struct sg_simplifying {
  sg_dense dense;
  double *weight; /* [dense.vertices] */
  sg_simplified result;
  sg_mesh mesh;         /* of the result */
  int32_t *vertex_of;   /* [mesh.vertices] places in dense */
  sg_mesh_parts *parts; /* of the mesh */
  int32_t *segment_of;  /* [dense.segments] of the mesh, -1: nothing */
};

void
sg_simplifying_free(sg_simplifying *x)
{
  sg_mesh_parts_close(x->parts);
  sg_mesh_clear(&x->mesh);
  sg_simplified_clear(&x->result);
  sg_dense_clear(&x->dense);
  free(x->vertex_of);
  free(x->segment_of);
  free(x->weight);
  free(x);
}

bool
sg_door_simplified_open(sg_call *call, const sg_int_list *segments,
                        sg_simplifying **simplified)
{
  sg_simplifying *x = calloc(1, sizeof *x);

  if (!x) {
    return sg_call_no_memory(call);
  }
  if (!sg_dense_read_these(call, segments, &x->dense)) {
    sg_simplifying_free(x);
    return false;
  }
  x->weight = malloc((x->dense.vertices + 1) * sizeof *x->weight);
  if (!x->weight || x->dense.triangles >= INT32_MAX / 3) {
    sg_simplifying_free(x);
    return sg_call_no_memory(call);
  }
  for (size_t v = 0; v < x->dense.vertices; v++) {
    x->weight[v] = 1;
  }
  *simplified = x;
  return true;
}

/* ---- the result as a mesh ---- */

static void
forget(sg_simplifying *x)
{
  sg_mesh_parts_close(x->parts);
  sg_mesh_clear(&x->mesh);
  sg_simplified_clear(&x->result);
  free(x->vertex_of);
  free(x->segment_of);
  x->parts = NULL;
  x->mesh = (sg_mesh){0};
  x->vertex_of = x->segment_of = NULL;
}

/* The vertices that triangles have, in their order. *number: [dense.vertices]
 * what they are in the mesh. */
static bool
add_vertices(sg_simplifying *x, int32_t *number)
{
  const sg_simplified *s = &x->result;

  memset(number, -1, s->vertices * sizeof *number);
  for (size_t t = 0; t < s->triangles; t++) {
    for (int k = 0; k < 3; k++) {
      number[s->corner[t][k]] = 0;
    }
  }
  for (size_t v = 0; v < s->vertices; v++) {
    if (number[v] == 0) {
      number[v] = (int32_t)x->mesh.vertices;
      x->vertex_of[x->mesh.vertices] = (int32_t)v;
      if (!sg_mesh_add_vertex(&x->mesh, s->at[v])) {
        return false;
      }
    }
  }
  return true;
}

static bool
add_triangle(sg_simplifying *x, size_t t, const int32_t *number)
{
  const sg_dense *d = &x->dense;
  size_t s = sg_dense_segment_of(d, d->triangle_begin,
                                 (uint32_t)x->result.triangle_of[t]);
  sg_mesh_lists *face = &x->mesh.face;

  if (x->segment_of[s] < 0) {
    x->segment_of[s] = sg_mesh_add_segment(&x->mesh, NULL, 0);
  }
  for (int k = 0; k < 3; k++) {
    if (!sg_mesh_add_corner(face, number[x->result.corner[t][k]])) {
      return false;
    }
  }
  return x->segment_of[s] >= 0 && sg_mesh_end_list(face, x->segment_of[s]);
}

static bool
make_mesh(sg_simplifying *x)
{
  int32_t *number = malloc((x->dense.vertices + 1) * sizeof *number);

  x->vertex_of = malloc((x->dense.vertices + 1) * sizeof *x->vertex_of);
  x->segment_of = malloc((x->dense.segments + 1) * sizeof *x->segment_of);
  bool good = number && x->vertex_of && x->segment_of;

  for (size_t s = 0; good && s < x->dense.segments; s++) {
    x->segment_of[s] = -1;
  }
  good = good && add_vertices(x, number);
  for (size_t t = 0; good && t < x->result.triangles; t++) {
    good = add_triangle(x, t, number);
  }
  free(number);
  x->parts = good ? sg_mesh_parts_open(&x->mesh) : NULL;
  return x->parts;
}

bool
sg_door_simplified_run(sg_call *call, sg_simplifying *x, size_t faces,
                       size_t *left)
{
  const sg_simplify_mesh mesh = {x->dense.vertices, x->dense.triangles,
                                 x->dense.at, x->dense.corner, x->weight};
  bool stopped;

  forget(x);
  if (!sg_simplify(&mesh, faces, &call->cancel, &x->result, &stopped)) {
    return sg_call_ended(call);
  }
  *left = x->result.triangles;
  return make_mesh(x) || sg_call_no_memory(call);
}

/* ---- its segments ---- */

/* Part s (an id) of the result. */
static bool
part_of(sg_call *call, sg_simplifying *x, int32_t s, sg_mesh_part *part)
{
  bool stopped;

  for (size_t i = 0; i < x->dense.segments; i++) {
    if (x->dense.segment[i] == s && x->parts && x->segment_of[i] >= 0) {
      return sg_mesh_parts_get(x->parts, (size_t)x->segment_of[i],
                               &call->cancel, part, &stopped) ||
             sg_call_ended(call);
    }
  }
  return sg_call_missing(call, "segment", 2);
}

bool
sg_door_simplified_add(sg_call *call, sg_simplifying *x, int32_t s)
{
  sg_mesh_part part;

  if (!part_of(call, x, s, &part)) {
    return false;
  }
  sg_world *world = sg_call_claim(call);
  bool good = world && sg_mesh_add_part(call, world, &x->mesh, &part, s);

  if (world) {
    sg_world_release(world);
  }
  return good;
}

bool
sg_door_simplified_weigh(sg_call *call, sg_simplifying *x, int32_t s,
                         const sg_int_list *vertices, double factor)
{
  sg_mesh_part part;

  if (!part_of(call, x, s, &part)) {
    return false;
  }
  unsigned char *here = sg_call_alloc(call, x->dense.vertices + 1);

  if (!here) {
    return false;
  }
  memset(here, 0, x->dense.vertices + 1);
  for (size_t i = 0; i < vertices->n; i++) {
    size_t v = (size_t)vertices->at[i] - 1;

    if (v >= part.vertices) {
      return sg_call_missing(call, "vertex", 3);
    }
    here[x->vertex_of[part.vertex[v]]] = 1;
  }
  for (size_t v = 0; v < x->dense.vertices; v++) {
    if (here[x->result.into[v]]) {
      x->weight[v] *= factor;
    }
  }
  return true;
}
