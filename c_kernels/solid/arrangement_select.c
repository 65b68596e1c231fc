/* arrangement_select.c -- chosen components as a solid: see arrangement.h.
 *
 * Layer: kernel. Vertices that touch another leaf are one vertex where their
 * doubles are the same; all others keep theirs.
 */
#include "arrangement_choice.h"
#include "engine/list.h"

#include <stdlib.h>
#include <string.h>

static bool
room_for_triangle(sg_choice *k)
{
  size_t room = k->triangle_room; /* of both */

  return sg_list_grow(&k->out->triangle, k->out->triangles, &room,
                      sizeof *k->out->triangle) &&
         sg_list_grow(&k->out->auxiliary, k->out->triangles, &k->triangle_room,
                      sizeof *k->out->auxiliary);
}

/* ---- vertices ---- */

static uint32_t *
place_of(sg_choice *k, const double at[3])
{
  double p[3] = {at[0] + 0.0, at[1] + 0.0, at[2] + 0.0}; /* never -0.0 */
  uint32_t key[6];

  memcpy(key, p, sizeof key);
  return sg_key_table_put(&k->at, key);
}

static uint32_t
new_vertex(sg_choice *k, const double at[3], int32_t s, int32_t v)
{
  if (!sg_list_grow(&k->out->vertex, k->out->vertices, &k->vertex_room,
                    sizeof *k->out->vertex)) {
    return SG_NO_KEY;
  }
  k->out->vertex[k->out->vertices] = (sg_solid_vertex){
      .at = {at[0] + 0.0, at[1] + 0.0, at[2] + 0.0}, .s = s, .v = v};
  return (uint32_t)k->out->vertices++;
}

/* The vertex of the solid for vertex v, which is a leaf's own. */
uint32_t
sg_choice_plain_vertex(sg_choice *k, const sg_source *from, uint32_t node,
                       int32_t v)
{
  uint32_t *number = &from->number[node - from->leaf->node];
  double at[3] = {0};

  if (*number != SG_NO_KEY) {
    return *number;
  }
  sg_leaf_vertex_at(from->leaf->tree, from->a->leaves.views, v, at);
  if (!from->a->touched[node]) {
    return *number = new_vertex(k, at, from->leaf->s, v);
  }
  uint32_t *same = place_of(k, at);

  if (same && *same == SG_NO_KEY) {
    *same = new_vertex(k, at, from->leaf->s, v);
  }
  return *number = same ? *same : SG_NO_KEY;
}

/* A vertex that a cut made, after all plain ones; another leaf, or another
 * cut, may have made it already. */
static uint32_t
new_made_vertex(sg_choice *k, const sg_source *from, const sg_made_vertex *v)
{
  uint32_t *same = place_of(k, v->at);

  if (!same || *same != SG_NO_KEY) {
    return same ? *same : SG_NO_KEY;
  }
  size_t made = k->out->vertices - k->out->plain;

  if (!sg_list_grow(&k->made_by, made, &k->made_room, sizeof *k->made_by)) {
    return SG_NO_KEY;
  }
  k->made_by[made] = (sg_made_by){(uint32_t)(from - k->from), v->point};
  return *same = new_vertex(k, v->at, from->leaf->s, 0);
}

/* The vertex of the solid for vertex v that a cut made in the leaf. */
static uint32_t
made_vertex(sg_choice *k, const sg_source *from, int32_t v)
{
  int32_t place = v - from->leaf->first_made;
  uint32_t *number = &from->made[place];

  if (*number == SG_NO_KEY) {
    *number = new_made_vertex(k, from, &from->leaf->made[place]);
  }
  return *number;
}

/* ---- triangles and faces ---- */

void
sg_choice_set_triangle(sg_solid *out, size_t at, const uint32_t v[3],
                       uint8_t auxiliary, bool reversed)
{
  uint32_t *corners = out->triangle[at];

  corners[0] = v[0];
  corners[1] = v[reversed ? 2 : 1];
  corners[2] = v[reversed ? 1 : 2];
  if (reversed) {
    auxiliary = (uint8_t)((auxiliary & 2) | ((auxiliary & 1) << 2) |
                          ((auxiliary & 4) >> 2));
  }
  out->auxiliary[at] = auxiliary;
}

/* Adds a triangle to the last face, if its corners are three. */
static bool
add_triangle(sg_choice *k, const uint32_t v[3], uint8_t auxiliary,
             bool reversed)
{
  if (sg_is_collapsed(v)) {
    return true;
  }
  if (!room_for_triangle(k)) {
    return false;
  }
  sg_choice_set_triangle(k->out, k->out->triangles++, v, auxiliary, reversed);
  return true;
}

static bool
open_face(sg_choice *k, int32_t s, int32_t p, bool reversed)
{
  sg_solid *out = k->out;

  if (!sg_list_grow(&out->face, out->faces, &k->face_room, sizeof *out->face)) {
    return false;
  }
  out->face[out->faces++] =
      (sg_solid_face){s, p, reversed, (uint32_t)out->triangles, 0};
  return true;
}

/* A face whose triangles all collapsed is none. */
static void
close_face(sg_choice *k)
{
  sg_solid *out = k->out;
  sg_solid_face *face = &out->face[out->faces - 1];

  face->n = (uint32_t)out->triangles - face->first;
  if (face->n == 0) {
    out->faces--;
  }
}

/* ---- cells ---- */

/* The plain corners of a chosen cell. */
static bool
number_cell(sg_choice *k, const sg_source *from, const sg_cell *cell)
{
  for (size_t j = cell->first; j < cell->first + cell->n; j++) {
    for (int c = 0; c < 3; c++) {
      int32_t v = from->a->triangle[j].v[c];
      uint32_t node = sg_arrangement_node(from->leaf, v);

      if (node != SG_NO_KEY &&
          sg_choice_plain_vertex(k, from, node, v) == SG_NO_KEY) {
        return false;
      }
    }
  }
  return true;
}

/* The plain corners of chosen cells, before any made one. */
static bool
number_plain(sg_choice *k, const sg_source *from)
{
  const sg_arranged *leaf = from->leaf;

  for (size_t i = leaf->first_cell; i < leaf->first_cell + leaf->cells; i++) {
    const sg_cell *cell = &from->a->cell[i];

    if (sg_sense_of(from, cell->component) != 0 &&
        !number_cell(k, from, cell)) {
      return false;
    }
  }
  return true;
}

static bool
add_cell(sg_choice *k, const sg_source *from, const sg_cell *cell)
{
  const sg_arranged *leaf = from->leaf;
  bool reversed = sg_sense_of(from, cell->component) < 0;

  if (!open_face(k, leaf->s, cell->p, reversed)) {
    return false;
  }
  for (size_t j = cell->first; j < cell->first + cell->n; j++) {
    const sg_cell_triangle *t = &from->a->triangle[j];
    uint32_t v[3];

    for (int c = 0; c < 3; c++) {
      uint32_t node = sg_arrangement_node(leaf, t->v[c]);

      v[c] = node == SG_NO_KEY ? made_vertex(k, from, t->v[c])
                               : from->number[node - leaf->node];
      if (v[c] == SG_NO_KEY) {
        return false;
      }
    }
    if (!add_triangle(k, v, t->auxiliary, reversed)) {
      return false;
    }
  }
  close_face(k);
  return true;
}

static bool
add_cells(sg_choice *k, const sg_source *from, const sg_cancel *cancel)
{
  const sg_arranged *leaf = from->leaf;

  for (size_t i = leaf->first_cell; i < leaf->first_cell + leaf->cells; i++) {
    const sg_cell *cell = &from->a->cell[i];

    if ((i % SG_CHOICE_ASKED == SG_CHOICE_ASKED - 1 && sg_cancelled(cancel)) ||
        (sg_sense_of(from, cell->component) != 0 && !add_cell(k, from, cell))) {
      return false;
    }
  }
  return true;
}

/* ---- everything ---- */

/* Two leaves, mostly, share a vertex that a cut made. */
static bool
reserve_places(sg_choice *k)
{
  size_t mades = 0;

  for (size_t i = 0; i < k->n; i++) {
    mades += k->from[i].leaf->mades;
  }
  return sg_key_table_reserve(&k->at, mades / 2);
}

static bool
add_all(sg_choice *k, sg_pool *pool, const sg_cancel *cancel)
{
  bool good = reserve_places(k) && sg_choice_add_rows(k, pool, cancel);

  for (size_t i = 0; i < k->n && good; i++) {
    good = number_plain(k, &k->from[i]);
  }
  k->out->plain = k->out->vertices;
  for (size_t i = 0; i < k->n && good; i++) {
    good = add_cells(k, &k->from[i], cancel);
  }
  return good;
}

static bool
open_sources(sg_choice *k, const sg_chosen *chosen_of)
{
  k->from = calloc(k->n + 1, sizeof *k->from);
  for (size_t i = 0; k->from && i < k->n; i++) {
    sg_source *from = &k->from[i];

    from->a = chosen_of[i].a;
    from->place = sg_arrangement_leaf(from->a, chosen_of[i].s);
    from->leaf = &from->a->leaf[from->place];
    from->sense = chosen_of[i].sense;
    size_t places = from->leaf->tree->vertex.places + 1;

    from->number = malloc(places * sizeof *from->number);
    from->made = malloc((from->leaf->mades + 1) * sizeof *from->made);
    if (!from->number || !from->made) {
      return false;
    }
    memset(from->number, 0xff, places * sizeof *from->number);
    memset(from->made, 0xff, from->leaf->mades * sizeof *from->made);
  }
  return k->from != NULL;
}

static void
close_sources(sg_choice *k)
{
  for (size_t i = 0; k->from && i < k->n; i++) {
    free(k->from[i].number);
    free(k->from[i].made);
    free(k->from[i].list);
    free(k->from[i].fresh);
    free(k->from[i].touching);
  }
  free(k->from);
}

bool
sg_arrangement_select(const sg_chosen *chosen_of, size_t n, sg_pool *pool,
                      const sg_cancel *cancel, sg_solid *out,
                      sg_made_by **made_by)
{
  sg_choice k = {.n = n, .out = out};
  bool good;

  *out = (sg_solid){0};
  *made_by = NULL;
  sg_key_table_init(&k.at, 6);
  good = open_sources(&k, chosen_of) && add_all(&k, pool, cancel);
  close_sources(&k);
  sg_key_table_clear(&k.at);
  if (good) {
    *made_by = k.made_by;
  } else {
    free(k.made_by);
    sg_solid_clear(out);
  }
  return good;
}
