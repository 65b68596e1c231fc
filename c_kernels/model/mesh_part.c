/* mesh_part.c -- see mesh_part.h. Lists are ordered by segment once (counting
 * sort), so that each segment costs only what it has. */
#include "mesh_part.h"
#include "engine/search.h"
#include "rows/edge_pairs.h"

#include <stdlib.h>
#include <string.h>

/* Which lists belong to each segment. */
typedef struct sg_list_order {
  uint32_t *begin; /* [segments + 1] */
  uint32_t *list;  /* [lists] */
} sg_list_order;

struct sg_mesh_parts {
  const sg_mesh *mesh;
  sg_list_order face, curve;
  int32_t *local;  /* [mesh->vertices] number in the part, or -1 */
  int32_t *vertex; /* [mesh->vertices] */
  uint32_t *start; /* [faces + 1] */
  int32_t *from, *to;
};

static bool
order_lists(const sg_mesh_lists *lists, size_t segments, sg_list_order *out)
{
  out->begin = calloc(segments + 2, sizeof *out->begin);
  out->list = malloc((lists->count + 1) * sizeof *out->list);
  if (!out->begin || !out->list) {
    return false;
  }
  for (size_t i = 0; i < lists->count; i++) {
    out->begin[lists->segment[i] + 2]++;
  }
  for (size_t s = 0; s < segments; s++) {
    out->begin[s + 2] += out->begin[s + 1];
  }
  for (size_t i = 0; i < lists->count; i++) {
    out->list[out->begin[lists->segment[i] + 1]++] = (uint32_t)i;
  }
  return true;
}

sg_mesh_parts *
sg_mesh_parts_open(const sg_mesh *mesh)
{
  sg_mesh_parts *parts = calloc(1, sizeof *parts);
  size_t edges = mesh->face.corners + mesh->curve.corners + 1;

  if (!parts) {
    return NULL;
  }
  parts->mesh = mesh;
  parts->local = malloc((mesh->vertices + 1) * sizeof *parts->local);
  parts->vertex = malloc((mesh->vertices + 1) * sizeof *parts->vertex);
  parts->start = malloc((mesh->face.count + 1) * sizeof *parts->start);
  parts->from = malloc(edges * sizeof *parts->from);
  parts->to = malloc(edges * sizeof *parts->to);
  if (!parts->local || !parts->vertex || !parts->start || !parts->from ||
      !parts->to || !order_lists(&mesh->face, mesh->segments, &parts->face) ||
      !order_lists(&mesh->curve, mesh->segments, &parts->curve)) {
    sg_mesh_parts_close(parts);
    return NULL;
  }
  memset(parts->local, -1, mesh->vertices * sizeof *parts->local);
  return parts;
}

void
sg_mesh_parts_close(sg_mesh_parts *parts)
{
  if (parts) {
    free(parts->face.begin);
    free(parts->face.list);
    free(parts->curve.begin);
    free(parts->curve.list);
    free(parts->local);
    free(parts->vertex);
    free(parts->start);
    free(parts->from);
    free(parts->to);
    free(parts);
  }
}

static void
add_edges(sg_mesh_parts *parts, const sg_mesh_lists *lists,
          const sg_list_order *order, size_t s, bool closed, sg_mesh_part *out)
{
  for (size_t k = order->begin[s]; k < order->begin[s + 1]; k++) {
    size_t i = order->list[k];
    size_t begin = lists->start[i], end = lists->start[i + 1];
    if (closed) {
      parts->start[out->faces++] = (uint32_t)out->edges;
    }
    for (size_t c = begin; c + !closed < end; c++) {
      parts->from[out->edges] = lists->corner[c];
      parts->to[out->edges] = lists->corner[c + 1 < end ? c + 1 : begin];
      out->edges++;
    }
  }
}

/* The vertices that the edges use, ascending. */
static void
gather_vertices(sg_mesh_parts *parts, sg_mesh_part *out)
{
  for (size_t i = 0; i < out->edges; i++) {
    int32_t ends[2] = {parts->from[i], parts->to[i]};
    for (int k = 0; k < 2; k++) {
      if (parts->local[ends[k]] < 0) {
        parts->local[ends[k]] = 0;
        parts->vertex[out->vertices++] = ends[k];
      }
    }
  }
  qsort(parts->vertex, out->vertices, sizeof *parts->vertex, sg_compare_ids);
}

static void
all_vertices(sg_mesh_parts *parts, sg_mesh_part *out)
{
  for (size_t v = 0; v < parts->mesh->vertices; v++) {
    parts->vertex[v] = (int32_t)v;
  }
  out->vertices = parts->mesh->vertices;
}

static void
number_vertices(sg_mesh_parts *parts, const sg_mesh_part *part)
{
  for (size_t v = 0; v < part->vertices; v++) {
    parts->local[parts->vertex[v]] = (int32_t)v;
  }
  for (size_t i = 0; i < part->edges; i++) {
    parts->from[i] = parts->local[parts->from[i]];
    parts->to[i] = parts->local[parts->to[i]];
  }
  for (size_t v = 0; v < part->vertices; v++) {
    parts->local[parts->vertex[v]] = -1;
  }
}

bool
sg_mesh_parts_get(sg_mesh_parts *parts, size_t s, const sg_cancel *cancel,
                  sg_mesh_part *out, bool *stopped)
{
  const sg_mesh *mesh = parts->mesh;
  sg_edge_pairs pairs;

  *out = (sg_mesh_part){.name = mesh->name[s],
                        .vertex = parts->vertex,
                        .start = parts->start,
                        .from = parts->from,
                        .to = parts->to};
  add_edges(parts, &mesh->face, &parts->face, s, true, out);
  size_t of_faces = out->edges;
  parts->start[out->faces] = (uint32_t)of_faces;
  add_edges(parts, &mesh->curve, &parts->curve, s, false, out);
  if (mesh->segments == 1) {
    all_vertices(parts, out);
  } else {
    gather_vertices(parts, out);
  }
  number_vertices(parts, out);
  bool made = sg_edge_pairs_make(of_faces, parts->from, parts->to,
                                 out->vertices, cancel, &pairs, stopped);
  out->closed = made && out->faces && sg_edge_pairs_closed(&pairs);
  sg_edge_pairs_clear(&pairs);
  return made;
}
