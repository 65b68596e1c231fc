/* arrangement.c -- nodes, lines, and opening an arrangement: see arrangement.h.
 */
#include "arrangement_private.h"
#include "engine/list.h"
#include "engine/search.h"

#include <stdlib.h>
#include <string.h>

/* ---- nodes ---- */

uint32_t
sg_arrangement_leaf(const sg_arrangement *a, int32_t s)
{
  size_t low = sg_first_id(a->leaf, a->leaves.n, sizeof *a->leaf, s);

  return low < a->leaves.n && a->leaf[low].s == s ? (uint32_t)low : SG_NO_KEY;
}

uint32_t
sg_arrangement_new_node(sg_arrangement *a)
{
  if (!sg_list_grow(&a->parent, a->nodes, &a->node_room, sizeof *a->parent)) {
    return SG_NO_KEY;
  }
  a->parent[a->nodes] = (uint32_t)a->nodes;
  return (uint32_t)a->nodes++;
}

/* The smaller node is the root, so nothing depends on the order of hanging. */
void
sg_arrangement_hang(sg_arrangement *a, uint32_t node, uint32_t other)
{
  sg_disjoint_join(a->parent, node, other);
}

/* ---- lines, and what touches ---- */

enum { ASKED = 1 << 12 }; /* rows between questions */

static bool
stops(const sg_cancel *cancel, size_t i)
{
  return i % ASKED == ASKED - 1 && sg_cancelled(cancel);
}

static void
line_key(uint32_t leaf, int32_t v1, int32_t v2, uint32_t key[3])
{
  key[0] = leaf;
  key[1] = (uint32_t)(v1 < v2 ? v1 : v2);
  key[2] = (uint32_t)(v1 < v2 ? v2 : v1);
}

/* A line between two points runs between all vertices that are there. */
static bool
is_cut_line(const sg_arrangement *a, uint32_t leaf, int32_t v1, int32_t v2)
{
  const sg_cut_points *points = &a->leaves.set->points;
  int32_t s = a->leaf[leaf].s;
  uint32_t p = sg_cut_points_named(points, s, v1);
  uint32_t q = p == SG_NO_KEY ? p : sg_cut_points_named(points, s, v2);
  uint32_t key[3] = {leaf, p < q ? p : q, p < q ? q : p};

  return q != SG_NO_KEY && sg_key_table_get(&a->cut_line, key) != SG_NO_KEY;
}

bool
sg_arrangement_is_line(const sg_arrangement *a, uint32_t leaf, int32_t v1,
                       int32_t v2)
{
  uint32_t key[3];

  line_key(leaf, v1, v2, key);
  return sg_key_table_get(&a->barrier, key) != SG_NO_KEY ||
         is_cut_line(a, leaf, v1, v2);
}

static bool
note_line(sg_arrangement *a, int32_t s, const sg_cut_piece *piece)
{
  uint32_t leaf = sg_arrangement_leaf(a, s);
  uint32_t key[3] = {leaf, piece->a < piece->b ? piece->a : piece->b,
                     piece->a < piece->b ? piece->b : piece->a};

  return leaf == SG_NO_KEY || !a->leaf[leaf].wanted ||
         sg_key_table_add(&a->cut_line, key);
}

static bool
note_lines(sg_arrangement *a, const sg_cancel *cancel)
{
  const sg_cut_set *set = a->leaves.set;

  for (size_t i = 0; i < set->pieces; i++) {
    const sg_cut_piece *piece = &set->piece[i];

    if (stops(cancel, i)) {
      return false;
    }
    for (int k = 0; piece->live && k < 2; k++) {
      if (!note_line(a, piece->s[k], piece)) {
        return false;
      }
    }
  }
  return true;
}

/* Polygons without area have no triangles, and so no pieces. All triangles at
 * a line are in the model, those beside an edge that it divides too. */
static bool
note_triangles(sg_arrangement *a, const sg_cancel *cancel)
{
  const sg_cut_model *model = &a->leaves.set->model;

  a->next_of_polygon = malloc((model->triangles + 1) * sizeof(uint32_t));
  for (uint32_t i = 0; a->next_of_polygon && i < model->triangles; i++) {
    uint32_t key[2] = {sg_arrangement_leaf(a, model->triangle[i].s),
                       (uint32_t)model->triangle[i].p};
    uint32_t *last = sg_key_table_put(&a->has_triangles, key);

    if (!last || stops(cancel, i)) {
      return false;
    }
    a->next_of_polygon[i] = *last;
    *last = i;
  }
  return a->next_of_polygon != NULL;
}

static bool
note_touched(sg_arrangement *a, const sg_cancel *cancel)
{
  const sg_cut_points *points = &a->leaves.set->points;

  for (size_t i = 0; i < points->seats; i++) {
    uint32_t leaf = sg_arrangement_leaf(a, points->seat[i].s);
    uint32_t node =
        leaf == SG_NO_KEY || !a->leaf[leaf].wanted || points->seat[i].v == 0
            ? SG_NO_KEY
            : sg_arrangement_node(&a->leaf[leaf], points->seat[i].v);

    if (node != SG_NO_KEY) {
      a->touched[node] = 1;
    }
    if (stops(cancel, i)) {
      return false;
    }
  }
  return true;
}

/* The points on an edge of a leaf, from v1 to v2 if *forward; null: there are
 * none. */
static const sg_split_edge *
points_on(const sg_arrangement *a, int32_t s, int32_t v1, int32_t v2,
          bool *forward)
{
  const sg_cut_set *set = a->leaves.set;
  uint32_t x = sg_cut_model_find(&set->model, s, v1);
  uint32_t y = sg_cut_model_find(&set->model, s, v2);
  uint32_t key[2] = {x < y ? x : y, x < y ? y : x};
  uint32_t number = sg_key_table_get(&set->edge_number, key);

  *forward = x < y;
  return number == SG_NO_KEY ? NULL : &set->edge[number];
}

/* An edge of a leaf is as a line, in all parts that it is divided into. */
static bool
note_edge(sg_arrangement *a, uint32_t leaf, int32_t v1, int32_t v2)
{
  const sg_cut_points *points = &a->leaves.set->points;
  int32_t s = a->leaf[leaf].s, from = v1;
  bool forward;
  const sg_split_edge *edge = points_on(a, s, v1, v2, &forward);
  size_t n = edge ? edge->n : 0;
  uint32_t key[3];

  for (size_t i = 0; i <= n; i++) {
    int32_t to = v2;

    if (i < n) {
      to = sg_cut_points_name(points, edge->point[forward ? i : n - 1 - i], s);
    }
    line_key(leaf, from, to, key);
    if (!sg_key_table_add(&a->barrier, key)) {
      return false;
    }
    from = to;
  }
  return true;
}

/* Where a leaf is not one sheet, nothing is connected, and its edges of more
 * than two triangles are as lines. */
static bool
note_nonmanifold(sg_arrangement *a, const sg_cancel *cancel)
{
  for (uint32_t i = 0; i < a->leaves.n; i++) {
    const sg_nonmanifold *nonmanifold = a->leaves.nonmanifold[i];

    if (!a->leaf[i].wanted) {
      continue;
    }
    for (size_t k = 0; k < nonmanifold->vertices; k++) {
      uint32_t node = sg_arrangement_node(&a->leaf[i], nonmanifold->vertex[k]);

      if (node != SG_NO_KEY) {
        a->touched[node] = 1;
      }
    }
    for (size_t k = 0; k < nonmanifold->edges; k++) {
      if (stops(cancel, k) ||
          !note_edge(a, i, nonmanifold->edge[k][0], nonmanifold->edge[k][1])) {
        return false;
      }
    }
  }
  return true;
}

/* ---- opening ---- */

static bool
lay_leaves(sg_arrangement *a)
{
  const sg_leaves *leaves = &a->leaves;
  size_t nodes = 0;

  for (size_t i = 0; i < leaves->n; i++) {
    a->leaf[i] = (sg_arranged){.s = leaves->s[i],
                               .tree = leaves->tree[i],
                               .node = (uint32_t)nodes,
                               .wanted = leaves->wanted[i],
                               .surface = leaves->surface[i]};
    nodes += leaves->wanted[i] ? leaves->tree[i]->vertex.places : 0;
  }
  a->vertex_nodes = nodes;
  a->touched = calloc(nodes + 1, 1);
  a->node_room = nodes + 64;
  a->parent = malloc(a->node_room * sizeof *a->parent);
  if (!a->touched || !a->parent) {
    return false;
  }
  for (; a->nodes < nodes; a->nodes++) {
    a->parent[a->nodes] = (uint32_t)a->nodes;
  }
  return true;
}

sg_arrangement *
sg_arrangement_open(const sg_leaves *leaves, const sg_cancel *cancel)
{
  sg_arrangement *a = calloc(1, sizeof *a);

  if (!a) {
    return NULL;
  }
  a->leaves = *leaves;
  a->leaf = calloc(leaves->n + 1, sizeof *a->leaf);
  sg_key_table_init(&a->barrier, 3);
  sg_key_table_init(&a->cut_line, 3);
  sg_key_table_init(&a->has_triangles, 2);
  sg_key_table_init(&a->auxiliary, 3);
  if (!a->leaf || !lay_leaves(a) || !note_lines(a, cancel) ||
      !note_triangles(a, cancel) || !note_touched(a, cancel) ||
      !note_nonmanifold(a, cancel)) {
    sg_arrangement_close(a);
    return NULL;
  }
  return a;
}

static void
trim_arrays(sg_arrangement *a)
{
  sg_list_trim(&a->cell, a->cells, &a->cell_room, sizeof *a->cell);
  sg_list_trim(&a->triangle, a->triangles, &a->triangle_room,
               sizeof *a->triangle);
  sg_list_trim(&a->side, a->sides, &a->side_room, sizeof *a->side);
}

void
sg_arrangement_compact(sg_arrangement *a, const sg_leaf_views *views)
{
  trim_arrays(a);
  sg_key_table_clear(&a->barrier);
  sg_key_table_clear(&a->cut_line);
  sg_key_table_clear(&a->has_triangles);
  free(a->next_of_polygon);
  free(a->cut_row);
  free(a->parent);
  a->next_of_polygon = NULL;
  a->cut_row = NULL;
  a->parent = NULL;
  a->nodes = a->node_room = a->cut_rows = a->cut_row_room = 0;
  a->leaves.set = NULL;
  a->leaves.weight = NULL;
  a->leaves.weights = 0;
  a->leaves.views = views;
}

void
sg_arrangement_close(sg_arrangement *a)
{
  if (!a) {
    return;
  }
  for (size_t i = 0; a->leaf && i < a->leaves.n; i++) {
    free(a->leaf[i].component);
    free(a->leaf[i].made);
    sg_id_set_clear(&a->leaf[i].cut);
  }
  for (size_t i = 0; i < a->parts; i++) {
    sg_point_clear(&a->part[i].at);
  }
  sg_segment_rows_clear(&a->rows);
  sg_key_table_clear(&a->barrier);
  sg_key_table_clear(&a->cut_line);
  sg_key_table_clear(&a->has_triangles);
  sg_key_table_clear(&a->auxiliary);
  free(a->leaf);
  free(a->touched);
  free(a->next_of_polygon);
  free(a->cell);
  free(a->triangle);
  free(a->cut_row);
  free(a->parent);
  free(a->part);
  free(a->side);
  free(a);
}
