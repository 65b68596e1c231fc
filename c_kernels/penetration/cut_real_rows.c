/* cut_real_rows.c -- cut sets: which edges of leaf triangles are real.
 *
 * Layer: rows. The edges of a polygon are read when
 * the first cut comes near it. What is found for a triangle is kept with its
 * number, what is found for a polygon of many edges in a table.
 */
#include "cut_rows.h"
#include "engine/list.h"

#include <stdlib.h>
#include <string.h>

enum {
  FEW = 4,    /* edges of a polygon that are read for each of its triangles */
  KNOWN = 8,  /* beside bits 1, 2, 4: edges 0, 1, 2 are real */
  EDGE = 0x1c /* columns of e/5: its vertices and type */
};

/* The vertices and type of an edge, in their columns. False: there is none. */
static bool
read_edge(sg_cut_handle *handle, int32_t s, int32_t e, sg_value *out)
{
  sg_row row = sg_cut_row_of(handle, SG_E, s, e);

  if (row != SG_NO_ROW) {
    sg_version_row(handle->version, SG_E, row, EDGE, out);
  }
  return row != SG_NO_ROW;
}

/* ---- polygons of many edges ---- */

static void
set_key(uint32_t key[4], int32_t s, int32_t p, int32_t v1, int32_t v2)
{
  key[0] = (uint32_t)s;
  key[1] = (uint32_t)p;
  key[2] = (uint32_t)(v1 < v2 ? v1 : v2);
  key[3] = (uint32_t)(v1 < v2 ? v2 : v1);
}

/* Notes an edge, in both directions. */
static bool
note_edge(sg_cut_handle *handle, int32_t s, int32_t p, const sg_value *edge)
{
  uint32_t key[4];

  set_key(key, s, p, edge[2].i, edge[3].i);
  uint32_t *type = sg_key_table_put(&handle->edge_type, key);

  if (!type) {
    return false;
  }
  if (*type == SG_NO_KEY || edge[4].i == 1) {
    *type = (uint32_t)edge[4].i;
  }
  return true;
}

/* Reads all edges of a polygon, once. */
static bool
note_edges(sg_cut_handle *handle, int32_t s, int32_t p, const int32_t *list)
{
  uint32_t *read = sg_key_table_put(&handle->edges_read,
                                    (uint32_t[2]){(uint32_t)s, (uint32_t)p});
  bool good = read != NULL;

  if (!good || *read == 1) {
    return good;
  }
  *read = 1;
  for (int32_t i = 1; i <= list[0] && good; i++) {
    sg_value edge[SG_MAX_COLUMNS];

    good =
        !read_edge(handle, s, list[i], edge) || note_edge(handle, s, p, edge);
  }
  return good;
}

/* ---- triangles ---- */

/* The real ones of the edges v[0]-v[1], v[1]-v[2], v[2]-v[0] of a triangle. */
static unsigned
find_few(sg_cut_handle *handle, int32_t s, const int32_t *list,
         const int32_t v[3])
{
  unsigned bits = 0;

  for (int32_t i = 1; i <= list[0]; i++) {
    sg_value edge[SG_MAX_COLUMNS];

    if (!read_edge(handle, s, list[i], edge) || edge[4].i != 1) {
      continue;
    }
    for (int k = 0; k < 3; k++) {
      int32_t a = v[k], b = v[(k + 1) % 3];
      bool is = (edge[2].i == a && edge[3].i == b) ||
                (edge[2].i == b && edge[3].i == a);
      bits |= (unsigned)is << k;
    }
  }
  return bits;
}

/* The same in a polygon of many edges; -1: no memory. */
static int
find_many(sg_cut_handle *handle, int32_t s, int32_t p, const int32_t *list,
          const int32_t v[3])
{
  unsigned bits = 0;

  if (!note_edges(handle, s, p, list)) {
    return -1;
  }
  for (int k = 0; k < 3; k++) {
    uint32_t key[4];

    set_key(key, s, p, v[k], v[(k + 1) % 3]);
    bits |= (unsigned)(sg_key_table_get(&handle->edge_type, key) == 1) << k;
  }
  return (int)bits;
}

/* The bits of a triangle; -1: no memory. */
static int
find_bits(sg_cut_handle *handle, uint32_t triangle)
{
  const sg_cut_model *model = &handle->set.model;
  const sg_leaf_triangle *leaf = &model->triangle[triangle];
  sg_row row = sg_cut_row_of(handle, SG_P, leaf->s, leaf->p);
  int32_t v[3];

  if (row == SG_NO_ROW) {
    return 0;
  }
  const int32_t *list = sg_version_value(handle->version, SG_P, row, 2).list;

  for (int k = 0; k < 3; k++) {
    v[k] = model->vertex[leaf->v[k]].v;
  }
  return list[0] <= FEW ? (int)find_few(handle, leaf->s, list, v)
                        : find_many(handle, leaf->s, leaf->p, list, v);
}

int
sg_cut_is_real(void *data, uint32_t triangle, int edge)
{
  sg_cut_handle *handle = data;

  if (!sg_list_need_zeroed(&handle->real, handle->set.model.triangles,
                           &handle->real_room, sizeof *handle->real)) {
    return -1;
  }
  if (handle->real[triangle] == 0) {
    int bits = find_bits(handle, triangle);

    if (bits < 0) {
      return -1;
    }
    handle->real[triangle] = (uint8_t)(bits | KNOWN);
  }
  return handle->real[triangle] >> edge & 1;
}
