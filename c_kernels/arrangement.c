/* arrangement.c -- opening an arrangement, and the cells of cut polygons: see
 * arrangement.h.
 */
#include "arrangement_private.h"

#include <stdlib.h>
#include <string.h>

/* ---- nodes ---- */

uint32_t
sg_arrangement_leaf(const sg_arrangement *a, int32_t s)
{
  size_t low = 0, high = a->leaves.n;

  while (low < high) {
    size_t middle = (low + high) / 2;
    if (a->leaf[middle].s < s) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low < a->leaves.n && a->leaf[low].s == s ? (uint32_t)low : SG_NO_KEY;
}

uint32_t
sg_arrangement_node(const sg_arranged *leaf, int32_t v)
{
  const sg_id_rows *table = &leaf->tree->vertex;

  if (!table->id) {
    size_t at = (size_t)((int64_t)v - table->first); /* below first: huge */

    return at < table->places && table->row[at] != SG_NO_ID_ROW
               ? leaf->node + (uint32_t)at
               : SG_NO_KEY;
  }
  size_t low = 0, high = table->places;

  while (low < high) {
    size_t middle = (low + high) / 2;
    if (table->id[middle] < v) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low < table->places && table->id[low] == v ? leaf->node + (uint32_t)low
                                                    : SG_NO_KEY;
}

uint32_t
sg_arrangement_new_node(sg_arrangement *a)
{
  if (a->nodes == a->node_room) {
    size_t room = a->node_room + a->node_room / 2 + 64;
    uint32_t *grown = realloc(a->parent, room * sizeof *grown);

    if (!grown) {
      return SG_NO_KEY;
    }
    a->parent = grown;
    a->node_room = room;
  }
  a->parent[a->nodes] = (uint32_t)a->nodes;
  return (uint32_t)a->nodes++;
}

uint32_t
sg_arrangement_root(sg_arrangement *a, uint32_t node)
{
  uint32_t *parent = a->parent;

  while (parent[node] != node) {
    node = parent[node] = parent[parent[node]];
  }
  return node;
}

/* The smaller node is the root, so nothing depends on the order of hanging. */
void
sg_arrangement_hang(sg_arrangement *a, uint32_t node, uint32_t other)
{
  uint32_t x = sg_arrangement_root(a, node), y = sg_arrangement_root(a, other);

  if (x < y) {
    a->parent[y] = x;
  } else {
    a->parent[x] = y;
  }
}

/* ---- lines, and what touches ---- */

static void
line_key(uint32_t leaf, int32_t v1, int32_t v2, uint32_t key[3])
{
  key[0] = leaf;
  key[1] = (uint32_t)(v1 < v2 ? v1 : v2);
  key[2] = (uint32_t)(v1 < v2 ? v2 : v1);
}

bool
sg_arrangement_is_line(const sg_arrangement *a, uint32_t leaf, int32_t v1,
                       int32_t v2)
{
  uint32_t key[3];

  line_key(leaf, v1, v2, key);
  return sg_key_table_get(&a->barrier, key) != SG_NO_KEY;
}

static bool
note(sg_key_table *table, const uint32_t *key)
{
  uint32_t *known = sg_key_table_put(table, key);

  if (known) {
    *known = 1;
  }
  return known != NULL;
}

/* A line in leaf s, between all names that its ends have there. */
static bool
note_line(sg_arrangement *a, int32_t s, const sg_cut_piece *piece)
{
  const sg_cut_points *points = &a->leaves.set->points;
  uint32_t leaf = sg_arrangement_leaf(a, s), key[3];

  if (leaf == SG_NO_KEY || !a->leaf[leaf].wanted) {
    return true;
  }
  for (int32_t v = 0; (v = sg_cut_points_next_name(points, piece->a, s, v));) {
    for (int32_t w = 0;
         (w = sg_cut_points_next_name(points, piece->b, s, w));) {
      line_key(leaf, v, w, key);
      if (!note(&a->barrier, key)) {
        return false;
      }
    }
  }
  return true;
}

static bool
note_lines(sg_arrangement *a)
{
  const sg_cut_set *set = a->leaves.set;

  for (size_t i = 0; i < set->pieces; i++) {
    const sg_cut_piece *piece = &set->piece[i];

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
note_triangles(sg_arrangement *a)
{
  const sg_cut_model *model = &a->leaves.set->model;

  for (size_t i = 0; i < model->triangles; i++) {
    uint32_t key[2] = {sg_arrangement_leaf(a, model->triangle[i].s),
                       (uint32_t)model->triangle[i].p};

    if (!note(&a->has_triangles, key)) {
      return false;
    }
  }
  return true;
}

static void
note_touched(sg_arrangement *a)
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
  }
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
    if (!note(&a->barrier, key)) {
      return false;
    }
    from = to;
  }
  return true;
}

/* Where a leaf is not one sheet, nothing hangs together, and its edges of more
 * than two triangles are as lines. */
static bool
note_knots(sg_arrangement *a)
{
  for (uint32_t i = 0; i < a->leaves.n; i++) {
    const sg_knots *knots = a->leaves.knots[i];

    if (!a->leaf[i].wanted) {
      continue;
    }
    for (size_t k = 0; k < knots->vertices; k++) {
      uint32_t node = sg_arrangement_node(&a->leaf[i], knots->vertex[k]);

      if (node != SG_NO_KEY) {
        a->touched[node] = 1;
      }
    }
    for (size_t k = 0; k < knots->edges; k++) {
      if (!note_edge(a, i, knots->edge[k][0], knots->edge[k][1])) {
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
sg_arrangement_open(const sg_leaves *leaves)
{
  sg_arrangement *a = calloc(1, sizeof *a);

  if (!a) {
    return NULL;
  }
  a->leaves = *leaves;
  a->leaf = calloc(leaves->n + 1, sizeof *a->leaf);
  sg_key_table_init(&a->barrier, 3);
  sg_key_table_init(&a->has_triangles, 2);
  sg_key_table_init(&a->auxiliary, 3);
  if (!a->leaf || !lay_leaves(a) || !note_lines(a) || !note_triangles(a)) {
    sg_arrangement_close(a);
    return NULL;
  }
  note_touched(a);
  if (!note_knots(a)) {
    sg_arrangement_close(a);
    return NULL;
  }
  return a;
}

void
sg_arrangement_close(sg_arrangement *a)
{
  if (!a) {
    return;
  }
  for (size_t i = 0; a->leaf && i < a->leaves.n; i++) {
    free(a->leaf[i].component);
    sg_id_set_clear(&a->leaf[i].cut);
  }
  for (size_t i = 0; i < a->parts; i++) {
    sg_point_clear(&a->part[i].at);
  }
  sg_segment_rows_clear(&a->rows);
  sg_key_table_clear(&a->barrier);
  sg_key_table_clear(&a->has_triangles);
  sg_key_table_clear(&a->auxiliary);
  free(a->leaf);
  free(a->touched);
  free(a->cell);
  free(a->triangle);
  free(a->cut_row);
  free(a->parent);
  free(a->part);
  free(a->side);
  free(a);
}

/* ---- the cells of a polygon ---- */

/* A polygon that is being taken in. */
typedef struct taking {
  sg_arrangement *a;
  uint32_t leaf;
  int32_t p;
  sg_work *work;
  sg_work_edge *edge; /* [edges]: as they were */
  size_t edges;
  sg_key_table auxiliary; /* two names: an edge that is no line */
  sg_key_table border;    /* two names, the lower first: a real edge */
  sg_triangles found;
  uint32_t *cell; /* [found.n]: which of the cells, by union */
} taking;

static void
taking_clear(taking *k)
{
  free(k->edge);
  free(k->found.item);
  free(k->cell);
  sg_key_table_clear(&k->auxiliary);
  sg_key_table_clear(&k->border);
}

static void
border_key(int32_t v1, int32_t v2, uint32_t key[2])
{
  key[0] = (uint32_t)(v1 < v2 ? v1 : v2);
  key[1] = (uint32_t)(v1 < v2 ? v2 : v1);
}

static bool
copy_edges(taking *k)
{
  sg_key_table_init(&k->auxiliary, 2);
  sg_key_table_init(&k->border, 2);
  k->edge = malloc((sg_work_edges(k->work) + 1) * sizeof *k->edge);
  for (int32_t e = 0; k->edge && (e = sg_work_next(k->work, e));) {
    const sg_work_edge *edge = sg_work_get(k->work, e);
    int32_t v1 = sg_work_id(k->work, edge->start);
    int32_t v2 = sg_work_id(k->work, edge->end);

    uint32_t key[2];

    k->edge[k->edges++] = *edge;
    border_key(v1, v2, key);
    if (edge->et != 0 && !note(&k->border, key)) {
      return false;
    }
    if (edge->et == 0 && !sg_arrangement_is_line(k->a, k->leaf, v1, v2) &&
        !note(&k->auxiliary, (uint32_t[2]){(uint32_t)v1, (uint32_t)v2})) {
      return false;
    }
  }
  return k->edge != NULL;
}

static bool
restore_edges(taking *k)
{
  for (int32_t e; (e = sg_work_next(k->work, 0));) {
    sg_work_delete(k->work, e);
  }
  for (size_t i = 0; i < k->edges; i++) {
    const sg_work_edge *edge = &k->edge[i];

    if (!sg_work_add(k->work, edge->start, edge->end, edge->et, edge->label)) {
      return false;
    }
  }
  k->found.n = 0;
  return true;
}

/* A polygon that touches itself is stuck until what touches is one vertex:
 * first what does so exactly, then within the reach. */
static sg_outcome
triangulate(taking *k, double reach, int32_t *edge, const sg_poll *poll)
{
  double reaches[2] = {0, reach};
  int32_t stuck;
  sg_outcome outcome = sg_work_triangulate(k->work, &k->found, &stuck, poll);

  for (int i = 0; i < 2 && outcome == SG_STUCK; i++) {
    if (!restore_edges(k) || !sg_work_resolve(k->work, reaches[i])) {
      return SG_NO_SPACE;
    }
    outcome = sg_work_triangulate(k->work, &k->found, &stuck, poll);
  }
  if (edge) {
    *edge = stuck;
  }
  return outcome;
}

static uint32_t
cell_root(uint32_t *cell, uint32_t i)
{
  while (cell[i] != i) {
    i = cell[i] = cell[cell[i]];
  }
  return i;
}

/* Joins triangles of the polygon that have an edge in common which is no
 * line. */
static bool
join_cells(taking *k)
{
  sg_key_table at; /* two names of an edge -> triangle */
  bool good = true;

  k->cell = malloc((k->found.n + 1) * sizeof *k->cell);
  sg_key_table_init(&at, 2);
  for (uint32_t i = 0; k->cell && i < k->found.n; i++) {
    k->cell[i] = i;
  }
  for (uint32_t i = 0; k->cell && i < k->found.n && good; i++) {
    for (int c = 0; c < 3 && good; c++) {
      int32_t v1 = sg_work_id(k->work, k->found.item[i].v[c]);
      int32_t v2 = sg_work_id(k->work, k->found.item[i].v[(c + 1) % 3]);
      uint32_t key[2] = {(uint32_t)(v1 < v2 ? v1 : v2),
                         (uint32_t)(v1 < v2 ? v2 : v1)};

      if (sg_arrangement_is_line(k->a, k->leaf, v1, v2)) {
        continue;
      }
      uint32_t *other = sg_key_table_put(&at, key);

      good = other != NULL;
      if (good && *other == SG_NO_KEY) {
        *other = i;
      } else if (good) {
        uint32_t x = cell_root(k->cell, i), y = cell_root(k->cell, *other);
        k->cell[x < y ? y : x] = x < y ? x : y;
      }
    }
  }
  sg_key_table_clear(&at);
  return good && k->cell != NULL;
}

static bool
room_for(sg_arrangement *a, size_t cells, size_t triangles)
{
  if (a->cells + cells > a->cell_room) {
    size_t room = 2 * a->cell_room + cells + 64;
    sg_cell *grown = realloc(a->cell, room * sizeof *grown);

    if (!grown) {
      return false;
    }
    a->cell = grown;
    a->cell_room = room;
  }
  if (a->triangles + triangles > a->triangle_room) {
    size_t room = 2 * a->triangle_room + triangles + 64;
    sg_cell_triangle *grown = realloc(a->triangle, room * sizeof *grown);

    if (!grown) {
      return false;
    }
    a->triangle = grown;
    a->triangle_room = room;
  }
  return true;
}

static void
add_triangle(taking *k, const sg_triangle *found)
{
  sg_cell_triangle *out = &k->a->triangle[k->a->triangles++];

  out->auxiliary = out->chord = 0;
  for (int c = 0; c < 3; c++) {
    out->v[c] = sg_work_id(k->work, found->v[c]);
  }
  for (int c = 0; c < 3; c++) {
    uint32_t key[2] = {(uint32_t)out->v[c], (uint32_t)out->v[(c + 1) % 3]};

    if (sg_key_table_get(&k->auxiliary, key) != SG_NO_KEY) {
      out->auxiliary |= (uint8_t)(1 << c);
    }
    border_key(out->v[c], out->v[(c + 1) % 3], key);
    if (sg_key_table_get(&k->border, key) == SG_NO_KEY) {
      out->chord |= (uint8_t)(1 << c);
    }
  }
}

/* The cells in the order of their first triangles. */
static bool
add_cells(taking *k)
{
  sg_arrangement *a = k->a;

  if (!room_for(a, k->found.n, k->found.n)) {
    return false;
  }
  for (uint32_t i = 0; i < k->found.n; i++) {
    if (k->cell[i] != i) {
      continue;
    }
    uint32_t node = sg_arrangement_new_node(a);

    if (node == SG_NO_KEY) {
      return false;
    }
    sg_cell *cell = &a->cell[a->cells++];

    *cell = (sg_cell){.leaf = k->leaf,
                      .p = k->p,
                      .axis = sg_work_axis(k->work),
                      .first = a->triangles,
                      .node = node};
    for (uint32_t j = i; j < k->found.n; j++) {
      if (cell_root(k->cell, j) == i) {
        add_triangle(k, &k->found.item[j]);
      }
    }
    cell->n = a->triangles - cell->first;
  }
  return true;
}

sg_outcome
sg_arrangement_polygon(sg_arrangement *a, int32_t s, int32_t p, sg_work *work,
                       double reach, int32_t *edge, const sg_poll *poll)
{
  taking k = {.a = a, .leaf = sg_arrangement_leaf(a, s), .p = p, .work = work};
  uint32_t key[2] = {k.leaf, (uint32_t)p};
  sg_outcome outcome = SG_NO_SPACE;

  if (k.leaf == SG_NO_KEY || !a->leaf[k.leaf].wanted ||
      sg_key_table_get(&a->has_triangles, key) == SG_NO_KEY) {
    return SG_DONE;
  }
  if (copy_edges(&k)) {
    outcome = triangulate(&k, reach, edge, poll);
  }
  if (outcome == SG_DONE && (!join_cells(&k) || !add_cells(&k))) {
    outcome = SG_NO_SPACE;
  }
  taking_clear(&k);
  return outcome;
}
