/* cell_added_read_rows.c -- a glue near a solid: see cell_added_rows.h. */
#include "cell_added_rows.h"
#include "engine/search.h"

#include "engine/search.h"
#include "rows/sort.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- reading ------------------------------------------------------------ */

bool
sg_cells_part_read(sg_call *call, const sg_version *version,
                   sg_relation relation, int32_t s, sg_cells_part *out)
{
  bool good =
      sg_version_view(version, relation, &out->view) &&
      sg_segment_rows_find(&out->view, &s, 1, &call->cancel, &out->rows);

  out->n = good ? out->rows.begin[1] : 0;
  return good || sg_call_ended(call);
}

void
sg_cells_part_clear(sg_cells_part *part)
{
  sg_segment_rows_clear(&part->rows);
  sg_view_clear(&part->view);
}

static bool
read_part(sg_cell_joiner *j, sg_relation relation, sg_cells_part *out)
{
  return sg_cells_part_read(j->call, j->version, relation, j->s, out);
}

static int32_t
last_id(const sg_cells_part *part, unsigned column)
{
  int32_t last = 0;

  for (size_t i = 0; i < part->n; i++) {
    int32_t id = sg_view_int(&part->view, column, part->rows.row[i]);

    last = id > last ? id : last;
  }
  return last;
}

static int32_t
last_edge(const sg_cell_joiner *j)
{
  int32_t last = 0;

  for (size_t i = 0; i < j->p.n; i++) {
    uint32_t row = j->p.rows.row[i];
    const int32_t *list = sg_view_list(&j->p.view, 2, row);

    for (int32_t k = 1; k <= list[0]; k++) {
      last = list[k] > last ? list[k] : last;
    }
  }
  return last;
}

static void
widen(double low[3], double high[3], const double at[3], double by)
{
  for (int k = 0; k < 3; k++) {
    double least = by > 0 ? nextafter(at[k] - by, -INFINITY) : at[k];
    double most = by > 0 ? nextafter(at[k] + by, INFINITY) : at[k];

    low[k] = least < low[k] ? least : low[k];
    high[k] = most > high[k] ? most : high[k];
  }
}

/* On which sides of the box of the solid a place is; 0: in it. */
static uint8_t
sides_out(const sg_cell_joiner *j, const double at[3])
{
  unsigned out = 0;

  for (int k = 0; k < 3; k++) {
    out |= (unsigned)(at[k] < j->low[k]) << 2 * k |
           (unsigned)(at[k] > j->high[k]) << (2 * k + 1);
  }
  return (uint8_t)out;
}

static bool
find_boxes(sg_cell_joiner *j)
{
  j->out = sg_call_alloc(j->call, j->place.places + 1);
  if (!j->out) {
    return false;
  }
  for (int k = 0; k < 3; k++) {
    j->low[k] = j->least[k] = INFINITY;
    j->high[k] = j->most[k] = -INFINITY;
  }
  for (size_t t = 0; t < j->solid->triangles; t++) {
    for (int c = 0; c < 3; c++) {
      widen(j->low, j->high, j->solid->vertex[j->solid->triangle[t][c]].at,
            j->reach);
    }
  }
  for (size_t i = 0; i < j->v.n; i++) {
    uint32_t row = j->v.rows.row[i];
    double at[3];

    sg_view_point(&j->v.view, row, at);
    widen(j->least, j->most, at, 0);
    j->out[sg_id_rows_place(&j->place, sg_view_int(&j->v.view, 1, row))] =
        sides_out(j, at);
  }
  return true;
}

static bool
read_all(sg_cell_joiner *j)
{
  if (!read_part(j, SG_V, &j->v) || !read_part(j, SG_P, &j->p) ||
      !read_part(j, SG_T, &j->t) ||
      (!j->rest_only && (!read_part(j, SG_SIDES, &j->sides) ||
                         !read_part(j, SG_REGION, &j->region))) ||
      (!sg_id_rows_make(&j->v.view, j->v.rows.row, j->v.n, &j->place) &&
       !sg_call_no_memory(j->call))) {
    return false;
  }
  j->last_v = last_id(&j->v, 1);
  j->last_p = last_id(&j->p, 1);
  j->last_e = last_edge(j);
  j->last_t = last_id(&j->t, 2);
  j->before = last_id(&j->region, 1);
  return find_boxes(j);
}

/* ---- what is near ------------------------------------------------------- */

static bool
comes_near(const sg_cell_joiner *j, uint32_t row)
{
  unsigned out = 0xff;

  for (unsigned c = 0; c < 3; c++) {
    out &= j->out[sg_id_rows_place(&j->place,
                                   sg_view_int(&j->t.view, 3 + c, row))];
  }
  return out == 0;
}

/* A triangle that is taken. */
typedef struct taken {
  int32_t p;
  uint32_t row;
} taken;

SG_ORDER(compare_taken, taken, SG_BY(p) SG_BY(row));

/* All triangles of polygons one of which comes near. */
static bool
list_near(sg_cell_joiner *j, taken **out, size_t *n)
{
  uint8_t *near = sg_call_alloc(j->call, (size_t)j->last_p + 1);

  *n = 0;
  if (!near) {
    return false;
  }
  memset(near, 0, (size_t)j->last_p + 1);
  for (size_t i = 0; i < j->t.n; i++) {
    if (comes_near(j, j->t.rows.row[i])) {
      near[sg_view_int(&j->t.view, 1, j->t.rows.row[i])] = 1;
    }
  }
  for (size_t i = 0; i < j->t.n; i++) {
    *n += near[sg_view_int(&j->t.view, 1, j->t.rows.row[i])];
  }
  if (!(*out = sg_call_alloc(j->call, (*n + 1) * sizeof **out))) {
    return false;
  }
  *n = 0;
  for (size_t i = 0; i < j->t.n; i++) {
    uint32_t row = j->t.rows.row[i];

    if (near[sg_view_int(&j->t.view, 1, row)]) {
      (*out)[(*n)++] = (taken){sg_view_int(&j->t.view, 1, row), row};
    }
  }
  return sg_sort(*out, *n, sizeof **out, compare_taken, &j->call->cancel) ==
             SG_SORTED ||
         sg_call_ended(j->call);
}

static bool
make_room(sg_cell_joiner *j, size_t triangles)
{
  sg_solid *both = &j->both;
  size_t most = triangles + j->solid->triangles + 1;
  size_t vertices = 3 * triangles + j->solid->vertices + 1;

  both->vertex = malloc(vertices * sizeof *both->vertex);
  both->triangle = malloc(most * sizeof *both->triangle);
  both->auxiliary = calloc(most, sizeof *both->auxiliary);
  both->face = malloc(most * sizeof *both->face);
  return (both->vertex && both->triangle && both->auxiliary && both->face) ||
         sg_call_no_memory(j->call);
}

/* The number in `both` of a vertex of the glue. */
static uint32_t
number_of(sg_cell_joiner *j, uint32_t *number, int32_t v)
{
  uint32_t *is = &number[sg_id_rows_place(&j->place, v)];

  if (*is == UINT32_MAX) {
    sg_solid_vertex *to = &j->both.vertex[j->both.vertices];

    *to = (sg_solid_vertex){.s = j->s, .v = v};
    sg_view_point(&j->v.view, sg_id_rows_find(&j->place, v), to->at);
    *is = (uint32_t)j->both.vertices++;
  }
  return *is;
}

static bool
take_near(sg_cell_joiner *j, const taken *list, size_t n)
{
  sg_solid *both = &j->both;
  size_t bytes = (j->place.places + 1) * sizeof(uint32_t);
  uint32_t *number = sg_call_alloc(j->call, bytes);

  if (!number) {
    return false;
  }
  memset(number, 0xff, bytes);
  for (size_t i = 0; i < n; i++) {
    if (i == 0 || list[i].p != list[i - 1].p) {
      both->face[both->faces++] = (sg_solid_face){
          .s = j->s, .p = list[i].p, .first = (uint32_t)both->triangles};
    }
    for (unsigned c = 0; c < 3; c++) {
      both->triangle[both->triangles][c] =
          number_of(j, number, sg_view_int(&j->t.view, 3 + c, list[i].row));
    }
    both->triangles++;
    both->face[both->faces - 1].n++;
  }
  j->known = both->vertices;
  j->near = both->faces;
  return true;
}

static void
take_solid(sg_cell_joiner *j)
{
  const sg_solid *solid = j->solid;
  sg_solid *both = &j->both;

  memcpy(both->vertex + both->vertices, solid->vertex,
         solid->vertices * sizeof *solid->vertex);
  for (size_t f = 0; f < solid->faces; f++) {
    both->face[both->faces] = solid->face[f];
    both->face[both->faces++].first += (uint32_t)both->triangles;
  }
  for (size_t t = 0; t < solid->triangles; t++) {
    for (int c = 0; c < 3; c++) {
      both->triangle[both->triangles + t][c] =
          solid->triangle[t][c] + (uint32_t)both->vertices;
    }
    both->auxiliary[both->triangles + t] = solid->auxiliary[t];
  }
  both->triangles += solid->triangles;
  both->vertices += solid->vertices;
  both->plain = both->vertices;
}

/* Where a vertex that a cut made is exactly its row does not say. */
static bool
has_made(const sg_cell_joiner *j)
{
  for (size_t v = 0; v < j->known; v++) {
    if (sg_find_id(j->made->at, j->made->n, j->both.vertex[v].v) != SIZE_MAX) {
      return true;
    }
  }
  return false;
}

/* ---- together ----------------------------------------------------------- */

bool
sg_cell_read(sg_cell_joiner *j)
{
  taken *list;
  size_t n;

  if (!read_all(j) || !list_near(j, &list, &n) || !make_room(j, n) ||
      !take_near(j, list, n) || has_made(j)) {
    return false;
  }
  take_solid(j);
  return true;
}

void
sg_cell_clear(sg_cell_joiner *j)
{
  sg_cells_part_clear(&j->v);
  sg_cells_part_clear(&j->p);
  sg_cells_part_clear(&j->t);
  sg_cells_part_clear(&j->sides);
  sg_cells_part_clear(&j->region);
  sg_id_rows_clear(&j->place);
  sg_solid_clear(&j->both);
}
