#include "cut_model.h"
#include "engine/list.h"

#include <stdlib.h>
#include <string.h>

void
sg_cut_model_init(sg_cut_model *model)
{
  memset(model, 0, sizeof *model);
  sg_key_table_init(&model->vertex_number, 2);
}

void
sg_cut_model_clear(sg_cut_model *model)
{
  free(model->vertex);
  free(model->triangle);
  free(model->edge);
  sg_key_table_clear(&model->vertex_number);
  sg_cut_model_init(model);
}

bool
sg_cut_model_vertex(sg_cut_model *model, int32_t s, int32_t v,
                    const double at[3])
{
  uint32_t key[2] = {(uint32_t)s, (uint32_t)v};

  if (!sg_list_grow(&model->vertex, model->vertices, &model->vertex_room,
                    sizeof *model->vertex)) {
    return false;
  }
  uint32_t *number = sg_key_table_put(&model->vertex_number, key);

  if (!number) {
    return false;
  }
  if (*number == SG_NO_KEY) {
    *number = (uint32_t)model->vertices++;
  }
  model->vertex[*number] = (sg_leaf_vertex){s, v, {at[0], at[1], at[2]}};
  return true;
}

uint32_t
sg_cut_model_find(const sg_cut_model *model, int32_t s, int32_t v)
{
  uint32_t key[2] = {(uint32_t)s, (uint32_t)v};

  return sg_key_table_get(&model->vertex_number, key);
}

/* The number of a vertex, fetched or not; SG_NO_KEY: there is none. False: no
 * memory. */
static bool
reach_vertex(sg_cut_model *model, int32_t s, int32_t v, uint32_t *number)
{
  double at[3];

  *number = sg_cut_model_find(model, s, v);
  if (*number != SG_NO_KEY || !model->fetch ||
      !model->fetch(model->fetch_data, s, v, at)) {
    return true;
  }
  *number = (uint32_t)model->vertices;
  return sg_cut_model_vertex(model, s, v, at);
}

uint32_t
sg_cut_model_fetch(sg_cut_model *model, int32_t s, int32_t v)
{
  uint32_t number;

  return reach_vertex(model, s, v, &number) ? number : SG_NO_KEY;
}

/* False: no memory. */
static bool
reach_all(sg_cut_model *model, int32_t s, const int32_t *v, int n,
          uint32_t *out, bool *known)
{
  *known = true;
  for (int i = 0; i < n && *known; i++) {
    if (!reach_vertex(model, s, v[i], &out[i])) {
      return false;
    }
    *known = out[i] != SG_NO_KEY;
  }
  return true;
}

bool
sg_cut_model_triangle(sg_cut_model *model, int32_t s, int32_t p, int32_t t,
                      const int32_t v[3], bool *known)
{
  sg_leaf_triangle triangle = {s, p, t, {0, 0, 0}};

  if (!reach_all(model, s, v, 3, triangle.v, known)) {
    return false;
  }
  if (!*known) {
    return true;
  }
  if (!sg_list_grow(&model->triangle, model->triangles, &model->triangle_room,
                    sizeof *model->triangle)) {
    return false;
  }
  model->triangle[model->triangles++] = triangle;
  return true;
}

bool
sg_cut_model_edge(sg_cut_model *model, int32_t s, int32_t e, const int32_t v[2],
                  bool *known)
{
  sg_leaf_edge edge = {s, e, {0, 0}};

  if (!reach_all(model, s, v, 2, edge.v, known)) {
    return false;
  }
  if (!*known) {
    return true;
  }
  if (!sg_list_grow(&model->edge, model->edges, &model->edge_room,
                    sizeof *model->edge)) {
    return false;
  }
  model->edge[model->edges++] = edge;
  return true;
}

void
sg_cut_model_corners(const sg_cut_model *model, uint32_t triangle,
                     double out[3][3])
{
  for (int i = 0; i < 3; i++) {
    memcpy(out[i], model->vertex[model->triangle[triangle].v[i]].at,
           sizeof out[i]);
  }
}
