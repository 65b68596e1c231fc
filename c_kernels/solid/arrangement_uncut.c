/* arrangement_uncut.c -- chosen polygons that are not cut, into a solid: see
 * arrangement_choice.h.
 *
 * Layer: kernel. These are the bulk, and each leaf's are a task of its own: it
 * looks which triangles and vertices there are; then all get their places; then
 * it fills them. So nothing depends on which thread did what.
 */
#include "arrangement_choice.h"
#include "engine/list.h"
#include "engine/search.h"

#include <stdlib.h>
#include <string.h>

static uint8_t
auxiliary_of(const sg_arrangement *a, uint32_t leaf, const int32_t v[3])
{
  uint8_t bits = 0;

  for (int c = 0; c < 3 && a->auxiliary.n > 0; c++) {
    uint32_t key[3] = {leaf, (uint32_t)v[c], (uint32_t)v[(c + 1) % 3]};

    if (sg_key_table_get(&a->auxiliary, key) != SG_NO_KEY) {
      bits |= (uint8_t)(1 << c);
    }
  }
  return bits;
}

SG_ORDER(compare_chosen, sg_chosen_row, SG_BY(p) SG_BY(row));

/* The chosen triangles, polygon by polygon. */
static bool
choose_rows(sg_source *from)
{
  const sg_arranged *leaf = from->leaf;
  bool sorted = true;
  int32_t last = INT32_MIN;

  from->list = malloc((leaf->rows + 1) * sizeof *from->list);
  for (size_t i = 0; from->list && i < leaf->rows; i++) {
    uint32_t c = leaf->component[i];

    if (c != SG_NO_KEY && sg_sense_of(from, c) != 0) {
      int32_t p = sg_arranged_polygon(from->a, leaf->row[i]);

      from->list[from->n++] = (sg_chosen_row){p, (uint32_t)i};
      sorted = sorted && last <= p;
      last = p;
    }
  }
  if (from->list && !sorted) {
    qsort(from->list, from->n, sizeof *from->list, compare_chosen);
  }
  return from->list != NULL;
}

/* A vertex that is not numbered yet. */
static bool
note_vertex(sg_source *from, uint32_t node, int32_t v)
{
  uint32_t *number = &from->number[node - from->leaf->node];

  if (!from->a->touched[node]) {
    *number = (uint32_t)from->fresh_n;
    from->fresh[from->fresh_n++] = (sg_chosen_corner){node, v};
    return true;
  }
  if (!sg_list_grow(&from->touching, from->touching_n, &from->touching_room,
                    sizeof *from->touching)) {
    return false;
  }
  *number = 0;
  from->touching[from->touching_n++] = (sg_chosen_corner){node, v};
  return true;
}

/* First task: which triangles, how many faces, which vertices. */
static void
look_at_rows(void *data, size_t task)
{
  sg_source *from = &((sg_choice *)data)->from[task];
  const sg_arranged *leaf = from->leaf;

  from->failed = !choose_rows(from);
  if (!from->failed) {
    size_t most = leaf->tree->vertex.places;

    most = most < 3 * from->n ? most : 3 * from->n;
    from->fresh = malloc((most + 1) * sizeof *from->fresh);
    from->failed = !from->fresh;
  }
  for (size_t i = 0; i < from->n && !from->failed; i++) {
    int32_t v[3];

    if (i % SG_CHOICE_ASKED == SG_CHOICE_ASKED - 1 && sg_pool_stopping()) {
      return;
    }
    sg_arranged_corners(from->a, leaf->row[from->list[i].row], v);
    from->faces += i == 0 || from->list[i - 1].p != from->list[i].p;
    for (int c = 0; c < 3 && !from->failed; c++) {
      uint32_t node = sg_arrangement_own_node(leaf, v[c]);

      if (from->number[node - leaf->node] == SG_NO_KEY) {
        from->failed = !note_vertex(from, node, v[c]);
      }
    }
  }
}

/* The triangles of the chosen cells, which come after; *cells: how many. */
static size_t
count_cells(const sg_source *from, size_t *cells)
{
  const sg_arranged *leaf = from->leaf;
  size_t n = 0;

  for (size_t i = leaf->first_cell; i < leaf->first_cell + leaf->cells; i++) {
    const sg_cell *cell = &from->a->cell[i];

    if (sg_sense_of(from, cell->component) != 0) {
      n += cell->n;
      ++*cells;
    }
  }
  return n;
}

/* For this much, and for the chosen cells with all of their corners: what has
 * a million rows is not to be moved because of a few thousand cells. */
static bool
make_room(sg_choice *k, size_t vertices, size_t triangles, size_t faces)
{
  sg_solid *out = k->out;
  size_t cells = 0, parts = 0;

  for (size_t i = 0; i < k->n; i++) {
    parts += count_cells(&k->from[i], &cells);
    vertices += k->from[i].touching_n;
  }
  k->vertex_room = vertices + 3 * parts + 1;
  k->triangle_room = triangles + parts + 1;
  k->face_room = faces + cells + 1;
  out->vertex = malloc(k->vertex_room * sizeof *out->vertex);
  out->triangle = malloc(k->triangle_room * sizeof *out->triangle);
  out->auxiliary = malloc(k->triangle_room * sizeof *out->auxiliary);
  out->face = malloc(k->face_room * sizeof *out->face);
  return out->vertex && out->triangle && out->auxiliary && out->face;
}

/* Between the tasks: where each leaf's part begins; and vertices that touch, of
 * all leaves. */
static bool
lay_out(sg_choice *k)
{
  size_t vertices = 0, triangles = 0, faces = 0;

  for (size_t i = 0; i < k->n; i++) {
    sg_source *from = &k->from[i];

    if (from->failed) {
      return false;
    }
    from->first_vertex = vertices;
    from->first_triangle = triangles;
    from->first_face = faces;
    vertices += from->fresh_n;
    triangles += from->n;
    faces += from->faces;
  }
  if (!make_room(k, vertices, triangles, faces)) {
    return false;
  }
  k->out->vertices = vertices;
  k->out->triangles = triangles;
  k->out->faces = faces;
  for (size_t i = 0; i < k->n; i++) {
    for (size_t c = 0; c < k->from[i].touching_n; c++) {
      const sg_chosen_corner *one = &k->from[i].touching[c];

      k->from[i].number[one->node - k->from[i].leaf->node] = SG_NO_KEY;
      if (sg_choice_plain_vertex(k, &k->from[i], one->node, one->v) ==
          SG_NO_KEY) {
        return false;
      }
    }
  }
  return true;
}

static void
place_vertices(const sg_choice *k, sg_source *from)
{
  for (size_t i = 0; i < from->fresh_n; i++) {
    const sg_chosen_corner *one = &from->fresh[i];
    sg_solid_vertex *out = &k->out->vertex[from->first_vertex + i];
    double at[3] = {0};

    sg_leaf_vertex_at(from->leaf->tree, from->a->leaves.views, one->v, at);
    *out = (sg_solid_vertex){.at = {at[0] + 0.0, at[1] + 0.0, at[2] + 0.0},
                             .s = from->leaf->s,
                             .v = one->v};
    from->number[one->node - from->leaf->node] =
        (uint32_t)(from->first_vertex + i);
  }
}

static void
place_triangle(const sg_choice *k, sg_source *from, size_t i)
{
  const sg_arranged *leaf = from->leaf;
  bool reversed = sg_sense_of(from, leaf->component[from->list[i].row]) < 0;
  size_t at = from->first_triangle + i;
  int32_t name[3];
  uint32_t v[3];

  sg_arranged_corners(from->a, leaf->row[from->list[i].row], name);
  for (int c = 0; c < 3; c++) {
    v[c] = from->number[sg_arrangement_own_node(leaf, name[c]) - leaf->node];
  }
  from->collapsed = from->collapsed || sg_is_collapsed(v);
  sg_choice_set_triangle(k->out, at, v,
                         auxiliary_of(from->a, from->place, name), reversed);
}

/* Second task: vertices, triangles and faces in their places. */
static void
place_rows(void *data, size_t task)
{
  const sg_choice *k = data;
  sg_source *from = &((sg_choice *)data)->from[task];
  size_t face = from->first_face;

  place_vertices(k, from);
  for (size_t i = 0; i < from->n; i++) {
    if (i % SG_CHOICE_ASKED == SG_CHOICE_ASKED - 1 && sg_pool_stopping()) {
      return;
    }
    if (i == 0 || from->list[i - 1].p != from->list[i].p) {
      uint32_t c = from->leaf->component[from->list[i].row];

      k->out->face[face++] = (sg_solid_face){
          from->leaf->s, from->list[i].p, sg_sense_of(from, c) < 0,
          (uint32_t)(from->first_triangle + i), 0};
    }
    k->out->face[face - 1].n++;
    place_triangle(k, from, i);
  }
}

/* Drops triangles whose corners became one, and faces of such alone. */
static void
drop_collapsed(sg_solid *out)
{
  size_t triangles = 0, faces = 0;

  for (size_t i = 0; i < out->faces; i++) {
    sg_solid_face face = out->face[i];
    size_t end = face.first + face.n;

    out->face[faces] = face;
    out->face[faces].first = (uint32_t)triangles;
    for (size_t t = face.first; t < end; t++) {
      if (!sg_is_collapsed(out->triangle[t])) {
        memmove(out->triangle[triangles], out->triangle[t],
                sizeof out->triangle[t]);
        out->auxiliary[triangles++] = out->auxiliary[t];
      }
    }
    out->face[faces].n = (uint32_t)triangles - out->face[faces].first;
    faces += out->face[faces].n > 0;
  }
  out->triangles = triangles;
  out->faces = faces;
}

bool
sg_choice_add_rows(sg_choice *k, sg_pool *pool, const sg_cancel *cancel)
{
  bool collapsed = false;

  if (!sg_pool_run(pool, k->n, look_at_rows, k, cancel) || !lay_out(k) ||
      !sg_pool_run(pool, k->n, place_rows, k, cancel)) {
    return false;
  }
  for (size_t i = 0; i < k->n; i++) {
    collapsed = collapsed || k->from[i].collapsed;
  }
  if (collapsed) {
    drop_collapsed(k->out);
  }
  return true;
}
