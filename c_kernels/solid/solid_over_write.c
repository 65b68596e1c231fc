/* solid_over_write.c -- the rows that are new: see solid_over.h. */
#include "solid_over.h"

#include <stdlib.h>
#include <string.h>

/* Bytes of the cells of each column; the rest are of no column. */
static const size_t cell[SG_OLD_RELATIONS][SG_MAX_COLUMNS] = {
    [SG_OLD_V] = {4, 4, 8, 8, 8},
    [SG_OLD_E] = {4, 4, 4, 4, 4},
    [SG_OLD_P] = {4, 4, sizeof(int32_t *)},
    [SG_OLD_PLANE] = {4, 4, 8, 8, 8, 8},
    [SG_OLD_T] = {4, 4, 4, 4, 4, 4},
    [SG_OLD_FROM_V] = {4, 4, 4, 4},
    [SG_OLD_FROM_P] = {4, 4, 4, 4, 4},
    [SG_OLD_ORIGIN] = {4, 4, sizeof(uint32_t *)},
};

/* ---- the faces that are new --------------------------------------------- */

/* Parts of faces that are new, with their new numbers. */
static void
take_parts(const sg_solid *solid, const uint32_t *number, sg_solid *rest)
{
  for (size_t i = 0; i < solid->parts; i++) {
    if (number[solid->part[i].face] != SG_NO_PLACE) {
      rest->part[rest->parts] = solid->part[i];
      rest->part[rest->parts++].face = number[solid->part[i].face];
    }
  }
}

static void
take_face(const sg_solid *solid, uint32_t f, sg_solid *rest)
{
  const sg_solid_face *face = &solid->face[f];
  sg_solid_face *to = &rest->face[rest->faces++];

  *to = *face;
  to->first = (uint32_t)rest->triangles;
  memcpy(rest->triangle[rest->triangles], solid->triangle[face->first],
         face->n * sizeof *solid->triangle);
  memcpy(rest->auxiliary + rest->triangles, solid->auxiliary + face->first,
         face->n);
  rest->triangles += face->n;
}

/* False: no memory. */
static bool
take_rest(const sg_solid *solid, sg_solid_over *out)
{
  sg_solid *rest = &out->rest;
  size_t triangles = 0, faces = solid->faces - out->faces_stay;
  uint32_t *number = malloc((solid->faces + 1) * sizeof *number);

  for (size_t f = 0; f < solid->faces; f++) {
    triangles += out->face[f] == SG_NO_PLACE ? solid->face[f].n : 0;
  }
  *rest =
      (sg_solid){.vertex = solid->vertex,
                 .vertices = solid->vertices,
                 .plain = solid->plain,
                 .origin = solid->origin,
                 .triangle = malloc((triangles + 1) * sizeof *rest->triangle),
                 .auxiliary = malloc(triangles + 1),
                 .face = malloc((faces + 1) * sizeof *rest->face),
                 .part = malloc((solid->parts + 1) * sizeof *rest->part)};
  bool good =
      number && rest->triangle && rest->auxiliary && rest->face && rest->part;

  for (uint32_t f = 0; good && f < solid->faces; f++) {
    number[f] = SG_NO_PLACE;
    if (out->face[f] == SG_NO_PLACE) {
      number[f] = (uint32_t)rest->faces;
      take_face(solid, f, rest);
    }
  }
  if (good) {
    take_parts(solid, number, rest);
  }
  free(number);
  return good;
}

/* ---- sheets in memory --------------------------------------------------- */

/* Room for n rows of a relation. False: no memory. */
static bool
open_rows(int relation, size_t n, sg_over_rows *out, sg_sheet *sheet)
{
  size_t pages = n / SG_PAGE_ROWS + 1;

  out->n = n;
  *sheet = (sg_sheet){.rows = n, .page = calloc(pages, sizeof *sheet->page)};
  if (!sheet->page) {
    return false;
  }
  for (unsigned c = 0; c < SG_MAX_COLUMNS && cell[relation][c]; c++) {
    out->column[c] = malloc((n + 1) * cell[relation][c]);
    if (!out->column[c]) {
      return false;
    }
    for (size_t k = 0; k < pages; k++) {
      sheet->page[k].column[c].i =
          (void *)((char *)out->column[c] +
                   k * SG_PAGE_ROWS * cell[relation][c]);
    }
  }
  for (sheet->pages = pages; pages-- > 0;) {
    size_t from = pages * SG_PAGE_ROWS, left = n - from;
    sheet->page[pages].from = from;
    sheet->page[pages].n = left < SG_PAGE_ROWS ? left : SG_PAGE_ROWS;
  }
  return true;
}

/* The lists of p, with their lengths. False: no memory. */
static bool
open_lists(sg_solid_over *out)
{
  const sg_solid_rows *rows = &out->rest_rows;
  size_t faces = out->rest.faces;
  int32_t **list = out->fresh[SG_OLD_P].column[2];

  out->list = malloc((faces + rows->edge[faces] + 1) * sizeof *out->list);
  for (size_t f = 0; out->list && f < faces; f++) {
    list[f] = out->list + f + rows->edge[f];
    list[f][0] = (int32_t)(rows->edge[f + 1] - rows->edge[f]);
  }
  return out->list;
}

/* Every cell, with dense ids. */
static bool
fill(sg_solid_over *out, int32_t s, sg_pool *pool, const sg_cancel *cancel,
     sg_sheet sheet[SG_OLD_RELATIONS])
{
  const sg_solid_rows *rows = &out->rest_rows;
  const sg_solid *rest = &out->rest;
  const size_t n[SG_OLD_RELATIONS] = {
      [SG_OLD_V] = rows->vertices,
      [SG_OLD_E] = rows->edge[rest->faces],
      [SG_OLD_P] = rest->faces,
      [SG_OLD_PLANE] = rest->faces,
      [SG_OLD_T] = rest->triangles,
      [SG_OLD_FROM_V] = rows->plain,
      [SG_OLD_FROM_P] = rest->faces + rest->parts,
      [SG_OLD_ORIGIN] = rows->vertices - rows->plain};
  const sg_solid_sheets to = {&sheet[SG_OLD_V],     &sheet[SG_OLD_E],
                              &sheet[SG_OLD_P],     &sheet[SG_OLD_PLANE],
                              &sheet[SG_OLD_T],     &sheet[SG_OLD_FROM_V],
                              &sheet[SG_OLD_FROM_P]};

  for (int k = 0; k < SG_OLD_RELATIONS; k++) {
    if (!open_rows(k, n[k], &out->fresh[k], &sheet[k])) {
      return false;
    }
  }
  return open_lists(out) && sg_solid_rows_write(rows, s, pool, cancel, &to,
                                                &out->fresh[SG_OLD_PLANE].n,
                                                &out->fresh[SG_OLD_FROM_P].n);
}

/* ---- ids ---------------------------------------------------------------- */

/* The least n ids that no row has which stays. Null: no memory. */
static int32_t *
free_ids(const sg_old_ids *ids, const uint8_t *gone, size_t n)
{
  int32_t *out = malloc((n + 1) * sizeof *out), id = 0;

  for (size_t i = 0; out && i < n;) {
    uint32_t at = sg_old_place(ids, ++id);
    if (at == SG_NO_PLACE ? !sg_old_is_held(ids, id) : gone[at]) {
      out[i++] = id;
    }
  }
  return out;
}

/* Of the vertices of the rest those that stay have their own. */
static bool
name_vertices(const sg_solid_old *old, sg_solid_over *out)
{
  const sg_solid_rows *rows = &out->rest_rows;
  int32_t *list = free_ids(&old->vertex, out->gone[SG_OLD_V], rows->vertices);
  int32_t *id = malloc((rows->vertices + 1) * sizeof *id);

  for (size_t i = 0, k = 0; list && id && i < rows->vertices; i++) {
    uint32_t at = out->vertex[rows->vertex[i]];
    id[i] = at == SG_NO_PLACE ? list[k++] : sg_old_int(old, SG_OLD_V, 1, at);
  }
  out->id[SG_OLD_V] = id;
  free(list);
  return list && id;
}

static bool
name_all(const sg_solid_old *old, sg_solid_over *out)
{
  out->id[SG_OLD_E] = free_ids(&old->edge, out->gone[SG_OLD_E],
                               out->rest_rows.edge[out->rest.faces]);
  out->id[SG_OLD_P] =
      free_ids(&old->polygon, out->gone[SG_OLD_P], out->rest.faces);
  out->id[SG_OLD_T] =
      free_ids(&old->triangle, out->gone[SG_OLD_T], out->rest.triangles);
  return out->id[SG_OLD_E] && out->id[SG_OLD_P] && out->id[SG_OLD_T] &&
         name_vertices(old, out);
}

/* Columns of ids, and what these are ids of. */
static const struct id_column {
  int relation;
  unsigned column;
  int kind;
} id_column[] = {{SG_OLD_V, 1, SG_OLD_V},     {SG_OLD_FROM_V, 1, SG_OLD_V},
                 {SG_OLD_E, 1, SG_OLD_E},     {SG_OLD_E, 2, SG_OLD_V},
                 {SG_OLD_E, 3, SG_OLD_V},     {SG_OLD_P, 1, SG_OLD_P},
                 {SG_OLD_PLANE, 1, SG_OLD_P}, {SG_OLD_FROM_P, 1, SG_OLD_P},
                 {SG_OLD_T, 1, SG_OLD_P},     {SG_OLD_T, 2, SG_OLD_T},
                 {SG_OLD_T, 3, SG_OLD_V},     {SG_OLD_T, 4, SG_OLD_V},
                 {SG_OLD_T, 5, SG_OLD_V}};

/* Ids in a column, dense up to here, get their names. False: stopped. */
static bool
rename_ids(sg_solid_over *out, const struct id_column *of,
           const sg_cancel *cancel)
{
  const sg_over_rows *rows = &out->fresh[of->relation];
  int32_t *column = rows->column[of->column];

  for (size_t i = 0; i < rows->n; i++) {
    if (sg_cancel_every(cancel, i)) {
      return false;
    }
    column[i] = out->id[of->kind][column[i] - 1];
  }
  return true;
}

static bool
rename_lists(sg_solid_over *out, const sg_cancel *cancel)
{
  int32_t **list = out->fresh[SG_OLD_P].column[2];

  for (size_t i = 0; i < out->fresh[SG_OLD_P].n; i++) {
    if (sg_cancel_every(cancel, i)) {
      return false;
    }
    for (int32_t k = 1; k <= list[i][0]; k++) {
      list[i][k] = out->id[SG_OLD_E][list[i][k] - 1];
    }
  }
  return true;
}

static bool
rename_all(sg_solid_over *out, const sg_cancel *cancel)
{
  bool good = rename_lists(out, cancel);

  for (size_t i = 0; good && i < sizeof id_column / sizeof *id_column; i++) {
    good = rename_ids(out, &id_column[i], cancel);
  }
  return good;
}

/* ---- vertices that are new ---------------------------------------------- */

/* Of the rows of a relation, row i being of vertex i of the rest, those of new
 * ones are left. */
static void
leave_new(sg_solid_over *out, int relation)
{
  sg_over_rows *rows = &out->fresh[relation];
  size_t left = 0;

  for (size_t i = 0; i < rows->n; i++) {
    if (out->vertex[out->rest_rows.vertex[i]] != SG_NO_PLACE) {
      continue;
    }
    for (unsigned c = 0; c < SG_MAX_COLUMNS && cell[relation][c]; c++) {
      size_t bytes = cell[relation][c];
      memcpy((char *)rows->column[c] + left * bytes,
             (char *)rows->column[c] + i * bytes, bytes);
    }
    left++;
  }
  rows->n = left;
}

static void
list_origins(sg_solid_over *out, int32_t s)
{
  sg_over_rows *rows = &out->fresh[SG_OLD_ORIGIN];
  const sg_solid *rest = &out->rest;
  int32_t *segment = rows->column[0], *vertex = rows->column[1];
  const uint32_t **origin = rows->column[2];

  rows->n = 0;
  for (size_t i = out->rest_rows.plain;
       rest->origin && i < out->rest_rows.vertices; i++) {
    uint32_t v = out->rest_rows.vertex[i];
    if (out->vertex[v] == SG_NO_PLACE && rest->origin[v - rest->plain]) {
      segment[rows->n] = s;
      vertex[rows->n] = out->id[SG_OLD_V][i];
      origin[rows->n++] = rest->origin[v - rest->plain];
    }
  }
}

/* ---- all of it ---------------------------------------------------------- */

bool
sg_solid_over_write(const sg_solid_rows *rows, const sg_solid_old *old,
                    int32_t s, sg_pool *pool, const sg_cancel *cancel,
                    sg_solid_over *out)
{
  sg_sheet sheet[SG_OLD_RELATIONS] = {{0}};
  bool good = take_rest(rows->solid, out) &&
              sg_solid_rows_make(&out->rest, pool, cancel, &out->rest_rows) &&
              fill(out, s, pool, cancel, sheet) && name_all(old, out) &&
              rename_all(out, cancel);

  for (int k = 0; k < SG_OLD_RELATIONS; k++) {
    free(sheet[k].page);
  }
  if (good) {
    leave_new(out, SG_OLD_V);
    leave_new(out, SG_OLD_FROM_V);
    list_origins(out, s);
  }
  return good;
}

void
sg_solid_over_clear(sg_solid_over *over)
{
  for (int k = 0; k < SG_OLD_RELATIONS; k++) {
    free(over->gone[k]);
    for (unsigned c = 0; c < SG_MAX_COLUMNS; c++) {
      free(over->fresh[k].column[c]);
    }
  }
  for (int k = 0; k <= SG_OLD_T; k++) {
    free(over->id[k]);
  }
  free(over->vertex);
  free(over->face);
  free(over->list);
  free(over->rest.triangle);
  free(over->rest.auxiliary);
  free(over->rest.face);
  free(over->rest.part);
  sg_solid_rows_clear(&over->rest_rows);
  *over = (sg_solid_over){0};
}
