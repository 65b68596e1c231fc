/* arrangement_select.c -- chosen components as a solid: see arrangement.h.
 *
 * Layer: kernel. Vertices that touch another leaf are one vertex where their
 * doubles are the same; all others keep theirs.
 */
#include "arrangement_private.h"

#include <stdlib.h>
#include <string.h>

enum { ASKED = 1 << 14 }; /* rows between questions */

/* A solid under way. */
typedef struct choice {
  const sg_arrangement *a;
  const int8_t *sense;
  sg_solid *out;
  uint32_t *number;       /* [vertex_nodes]: of a vertex of the solid */
  sg_key_table at;        /* three doubles -> vertex of the solid */
  sg_key_table auxiliary; /* segment, two names: of polygons not cut */
  uint32_t *point_of;     /* [vertices - plain] */
  size_t vertex_room, triangle_room, face_room, made_room;
} choice;

/* ---- auxiliary edges ---- */

static bool
note_auxiliary(choice *k, uint32_t row)
{
  const sg_view *e = &k->a->leaves.views->e;
  size_t page = row / SG_PAGE_ROWS, at = row % SG_PAGE_ROWS;
  uint32_t key[3];

  for (unsigned c = 0; c < 3; c++) {
    key[c] = (uint32_t)e->column[c == 0 ? 0 : c + 1].page[page].i[at];
  }
  uint32_t leaf = sg_arrangement_leaf(k->a, (int32_t)key[0]);

  if (leaf == SG_NO_KEY ||
      sg_arrangement_is_line(k->a, leaf, (int32_t)key[1], (int32_t)key[2])) {
    return true;
  }
  uint32_t *known = sg_key_table_put(&k->auxiliary, key);

  if (known) {
    *known = 1;
  }
  return known != NULL;
}

static bool
find_auxiliary(choice *k, const sg_poll *poll)
{
  const sg_view *e = &k->a->leaves.views->e;

  for (size_t page = 0; page < e->pages; page++) {
    const int32_t *et = e->column[4].page[page].i;

    if (page % 16 == 15 && sg_poll_stop(poll)) {
      return false;
    }
    for (unsigned r = sg_live_next(e->live[page], 0); r < SG_PAGE_ROWS;
         r = sg_live_next(e->live[page], r + 1)) {
      if (et[r] == 0 && !note_auxiliary(k, (uint32_t)page * SG_PAGE_ROWS + r)) {
        return false;
      }
    }
  }
  return true;
}

static uint8_t
auxiliary_of(const choice *k, int32_t s, const int32_t v[3])
{
  uint8_t bits = 0;

  for (int c = 0; c < 3 && k->auxiliary.n > 0; c++) {
    uint32_t key[3] = {(uint32_t)s, (uint32_t)v[c], (uint32_t)v[(c + 1) % 3]};

    if (sg_key_table_get(&k->auxiliary, key) != SG_NO_KEY) {
      bits |= (uint8_t)(1 << c);
    }
  }
  return bits;
}

/* ---- room ---- */

static void *
grown(void *array, size_t n, size_t *room, size_t size)
{
  if (n < *room) {
    return array;
  }
  size_t more = *room + *room / 2 + 1024;
  void *out = realloc(array, more * size);

  if (out) {
    *room = more;
  }
  return out;
}

static bool
room_for_vertex(choice *k)
{
  void *out = grown(k->out->vertex, k->out->vertices, &k->vertex_room,
                    sizeof *k->out->vertex);

  if (out) {
    k->out->vertex = out;
  }
  return out != NULL;
}

static bool
room_for_triangle(choice *k)
{
  size_t room = k->triangle_room;
  void *out = grown(k->out->triangle, k->out->triangles, &room,
                    sizeof *k->out->triangle);

  if (!out) {
    return false;
  }
  k->out->triangle = out;
  out = grown(k->out->auxiliary, k->out->triangles, &k->triangle_room,
              sizeof *k->out->auxiliary);
  if (out) {
    k->out->auxiliary = out;
  }
  return out != NULL;
}

/* ---- vertices ---- */

static uint32_t *
place_of(choice *k, const double at[3])
{
  double p[3] = {at[0] + 0.0, at[1] + 0.0, at[2] + 0.0}; /* never -0.0 */
  uint32_t key[6];

  memcpy(key, p, sizeof key);
  return sg_key_table_put(&k->at, key);
}

static uint32_t
new_vertex(choice *k, const double at[3], int32_t s, int32_t v)
{
  if (!room_for_vertex(k)) {
    return SG_NO_KEY;
  }
  k->out->vertex[k->out->vertices] = (sg_solid_vertex){
      .at = {at[0] + 0.0, at[1] + 0.0, at[2] + 0.0}, .s = s, .v = v};
  return (uint32_t)k->out->vertices++;
}

/* The vertex of the solid for vertex v, which is a leaf's own. */
static uint32_t
plain_vertex(choice *k, const sg_arranged *leaf, uint32_t node, int32_t v)
{
  uint32_t *number = &k->number[node];
  double at[3] = {0};

  if (*number != SG_NO_KEY) {
    return *number;
  }
  sg_leaf_vertex_at(leaf->tree, k->a->leaves.views, v, at);
  if (!k->a->touched[node]) {
    return *number = new_vertex(k, at, leaf->s, v);
  }
  uint32_t *same = place_of(k, at);

  if (same && *same == SG_NO_KEY) {
    *same = new_vertex(k, at, leaf->s, v);
  }
  return *number = same ? *same : SG_NO_KEY;
}

/* The same for one that a cut made, after all plain ones. */
static uint32_t
made_vertex(choice *k, const sg_arranged *leaf, int32_t v)
{
  const sg_cut_points *points = &k->a->leaves.set->points;
  uint32_t point = sg_cut_points_named(points, leaf->s, v);
  uint32_t *same = place_of(k, points->point[point].at.p);

  if (!same || *same != SG_NO_KEY) {
    return same ? *same : SG_NO_KEY;
  }
  size_t made = k->out->vertices - k->out->plain;
  uint32_t *all = grown(k->point_of, made, &k->made_room, sizeof *k->point_of);

  if (!all) {
    return SG_NO_KEY;
  }
  k->point_of = all;
  all[made] = point;
  return *same = new_vertex(k, points->point[point].at.p, leaf->s, 0);
}

/* ---- triangles and faces ---- */

/* Adds a triangle to the last face, if its corners are three. */
static bool
add_triangle(choice *k, const uint32_t v[3], uint8_t auxiliary, bool reversed)
{
  sg_solid *out = k->out;

  if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) {
    return true;
  }
  if (!room_for_triangle(k)) {
    return false;
  }
  uint32_t *corner = out->triangle[out->triangles];

  corner[0] = v[0];
  corner[1] = v[reversed ? 2 : 1];
  corner[2] = v[reversed ? 1 : 2];
  if (reversed) {
    auxiliary = (uint8_t)((auxiliary & 2) | ((auxiliary & 1) << 2) |
                          ((auxiliary & 4) >> 2));
  }
  out->auxiliary[out->triangles++] = auxiliary;
  return true;
}

static bool
open_face(choice *k, int32_t s, int32_t p, bool reversed)
{
  sg_solid *out = k->out;
  void *more = grown(out->face, out->faces, &k->face_room, sizeof *out->face);

  if (!more) {
    return false;
  }
  out->face = more;
  out->face[out->faces++] =
      (sg_solid_face){s, p, reversed, (uint32_t)out->triangles, 0};
  return true;
}

/* A face whose triangles all collapsed is none. */
static void
close_face(choice *k)
{
  sg_solid *out = k->out;
  sg_solid_face *face = &out->face[out->faces - 1];

  face->n = (uint32_t)out->triangles - face->first;
  if (face->n == 0) {
    out->faces--;
  }
}

/* A chosen leaf triangle. */
typedef struct chosen {
  int32_t p;
  uint32_t row; /* place among the leaf's rows */
} chosen;

static int
compare_chosen(const void *x, const void *y)
{
  const chosen *a = x, *b = y;

  return a->p != b->p ? (a->p > b->p) - (a->p < b->p)
                      : (a->row > b->row) - (a->row < b->row);
}

/* The chosen triangles of polygons that are not cut, polygon by polygon. */
static chosen *
choose_rows(const choice *k, const sg_arranged *leaf, size_t *n)
{
  chosen *list = malloc((leaf->rows + 1) * sizeof *list);
  bool sorted = true;

  *n = 0;
  for (size_t i = 0; list && i < leaf->rows; i++) {
    uint32_t c = leaf->component[i];

    if (c != SG_NO_KEY && k->sense[c] != 0) {
      list[*n] = (chosen){sg_arranged_row(k->a, leaf->row[i]).p, (uint32_t)i};
      sorted = sorted && (*n == 0 || list[*n - 1].p <= list[*n].p);
      ++*n;
    }
  }
  if (list && !sorted) {
    qsort(list, *n, sizeof *list, compare_chosen);
  }
  return list;
}

static bool
add_row(choice *k, const sg_arranged *leaf, const chosen *one)
{
  sg_leaf t = sg_arranged_row(k->a, leaf->row[one->row]);
  uint32_t v[3];

  for (int c = 0; c < 3; c++) {
    v[c] = plain_vertex(k, leaf, sg_arrangement_node(leaf, t.v[c]), t.v[c]);
    if (v[c] == SG_NO_KEY) {
      return false;
    }
  }
  return add_triangle(k, v, auxiliary_of(k, leaf->s, t.v),
                      k->sense[leaf->component[one->row]] < 0);
}

static bool
add_rows(choice *k, const sg_arranged *leaf, const sg_poll *poll)
{
  size_t n;
  chosen *list = choose_rows(k, leaf, &n);
  bool good = list != NULL;

  for (size_t i = 0; i < n && good; i++) {
    if (i == 0 || list[i - 1].p != list[i].p) {
      good = open_face(k, leaf->s, list[i].p,
                       k->sense[leaf->component[list[i].row]] < 0);
    }
    good = good && (i % ASKED != ASKED - 1 || !sg_poll_stop(poll)) &&
           add_row(k, leaf, &list[i]);
    if (good && (i + 1 == n || list[i + 1].p != list[i].p)) {
      close_face(k);
    }
  }
  free(list);
  return good;
}

/* ---- cells ---- */

/* The plain corners of chosen cells, before any made one. */
static bool
number_plain(choice *k)
{
  const sg_arrangement *a = k->a;

  for (size_t i = 0; i < a->cells; i++) {
    const sg_cell *cell = &a->cell[i];
    const sg_arranged *leaf = &a->leaf[cell->leaf];

    if (k->sense[cell->component] == 0) {
      continue;
    }
    for (size_t j = cell->first; j < cell->first + cell->n; j++) {
      for (int c = 0; c < 3; c++) {
        int32_t v = a->triangle[j].v[c];
        uint32_t node = sg_arrangement_node(leaf, v);

        if (node != SG_NO_KEY && plain_vertex(k, leaf, node, v) == SG_NO_KEY) {
          return false;
        }
      }
    }
  }
  k->out->plain = k->out->vertices;
  return true;
}

static bool
add_cell(choice *k, const sg_cell *cell)
{
  const sg_arranged *leaf = &k->a->leaf[cell->leaf];
  bool reversed = k->sense[cell->component] < 0;

  if (!open_face(k, leaf->s, cell->p, reversed)) {
    return false;
  }
  for (size_t j = cell->first; j < cell->first + cell->n; j++) {
    const sg_cell_triangle *t = &k->a->triangle[j];
    uint32_t v[3];

    for (int c = 0; c < 3; c++) {
      uint32_t node = sg_arrangement_node(leaf, t->v[c]);

      v[c] =
          node == SG_NO_KEY ? made_vertex(k, leaf, t->v[c]) : k->number[node];
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
add_all(choice *k, const sg_poll *poll)
{
  const sg_arrangement *a = k->a;
  bool good = find_auxiliary(k, poll);

  for (size_t i = 0; i < a->leaves.n && good; i++) {
    good = add_rows(k, &a->leaf[i], poll);
  }
  good = good && number_plain(k);
  for (size_t i = 0; i < a->cells && good; i++) {
    good = (i % ASKED != ASKED - 1 || !sg_poll_stop(poll)) &&
           (k->sense[a->cell[i].component] == 0 || add_cell(k, &a->cell[i]));
  }
  return good;
}

bool
sg_arrangement_select(const sg_arrangement *a, const int8_t *sense,
                      const sg_poll *poll, sg_solid *out, uint32_t **point_of)
{
  choice k = {.a = a, .sense = sense, .out = out};
  bool good;

  *out = (sg_solid){0};
  *point_of = NULL;
  sg_key_table_init(&k.at, 6);
  sg_key_table_init(&k.auxiliary, 3);
  k.number = malloc((a->vertex_nodes + 1) * sizeof *k.number);
  if (k.number) {
    memset(k.number, 0xff, (a->vertex_nodes + 1) * sizeof *k.number);
  }
  good = k.number && add_all(&k, poll);
  free(k.number);
  sg_key_table_clear(&k.at);
  sg_key_table_clear(&k.auxiliary);
  if (good) {
    *point_of = k.point_of;
  } else {
    free(k.point_of);
    sg_solid_clear(out);
  }
  return good;
}
