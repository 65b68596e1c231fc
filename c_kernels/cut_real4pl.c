/* cut_real4pl.c -- cut sets: which edges of leaf triangles are real.
 *
 * Layer: glue; no predicates of its own. The edges of a polygon are read when
 * the first cut comes near it, by their keys; so nothing is indexed or walked
 * that is far from the lines.
 */
#include "cut4pl.h"

/* Notes the directed edge v1-v2, in both directions. */
static bool
note_edge(sg_cut_handle *handle, int32_t s, int32_t p, const sg_value *edge)
{
  int32_t v1 = edge[2].i, v2 = edge[3].i;
  uint32_t key[4] = {(uint32_t)s, (uint32_t)p, (uint32_t)(v1 < v2 ? v1 : v2),
                     (uint32_t)(v1 < v2 ? v2 : v1)};
  uint32_t *type = sg_key_table_put(&handle->edge_type, key);

  if (!type) {
    return false;
  }
  if (*type == SG_NO_KEY || edge[4].i == 1) {
    *type = (uint32_t)edge[4].i;
  }
  return true;
}

/* Reads the edges of a polygon. */
static bool
read_edges(sg_cut_handle *handle, int32_t s, int32_t p)
{
  const sg_version *version = handle->version;
  sg_value key[SG_MAX_COLUMNS] = {[0].i = s, [1].i = p};
  sg_row row = sg_version_find(version, SG_P, key);

  if (row == SG_NO_ROW) {
    return true;
  }
  const int32_t *list = sg_version_value(version, SG_P, row, 2).list;

  for (int32_t i = 1; i <= list[0]; i++) {
    sg_value edge[SG_MAX_COLUMNS] = {[0].i = s, [1].i = list[i]};
    sg_row found = sg_version_find(version, SG_E, edge);

    if (found != SG_NO_ROW) {
      sg_version_row(version, SG_E, found, 0x1c, edge);
      if (!note_edge(handle, s, p, edge)) {
        return false;
      }
    }
  }
  return true;
}

int
sg_cut_is_real(void *data, uint32_t triangle, int edge)
{
  sg_cut_handle *handle = data;
  const sg_cut_model *model = &handle->set.model;
  const sg_leaf_triangle *leaf = &model->triangle[triangle];
  int32_t a = model->vertex[leaf->v[edge]].v;
  int32_t b = model->vertex[leaf->v[(edge + 1) % 3]].v;
  uint32_t polygon[2] = {(uint32_t)leaf->s, (uint32_t)leaf->p};
  uint32_t key[4] = {polygon[0], polygon[1], (uint32_t)(a < b ? a : b),
                     (uint32_t)(a < b ? b : a)};
  uint32_t *read = sg_key_table_put(&handle->edges_read, polygon);

  if (!read) {
    return -1;
  }
  if (*read == SG_NO_KEY) {
    *read = 1;
    if (!read_edges(handle, leaf->s, leaf->p)) {
      return -1;
    }
  }
  return sg_key_table_get(&handle->edge_type, key) == 1;
}
