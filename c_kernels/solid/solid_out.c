/* solid_out.c -- the rows that a solid becomes: see solid_out.h. */
#include "solid_out.h"

#include "engine/search.h"
#include "polygon/plane.h"
#include "solid_border.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

enum {
  BLOCK = 4096, /* faces, or vertices, of a task */
  ASKED = 4096  /* triangles of a face between questions */
};

static size_t
blocks_of(size_t n)
{
  return (n + BLOCK - 1) / BLOCK;
}

static size_t
end_of(size_t block, size_t n)
{
  return (block + 1) * BLOCK < n ? (block + 1) * BLOCK : n;
}

/* ---- what is counted ---------------------------------------------------- */

typedef struct counting {
  sg_solid_rows *rows;
  atomic_bool failed;
} counting;

/* The borders of a block of faces; edge[f + 1] gets the face's own count. */
static void
count_block(void *data, size_t block)
{
  counting *c = data;
  sg_solid_rows *rows = c->rows;
  const sg_solid *solid = rows->solid;
  sg_border scratch = {0};

  for (size_t f = block * BLOCK; f < end_of(block, solid->faces); f++) {
    const sg_solid_face *face = &solid->face[f];
    if (!sg_border_find(&scratch, solid, f, rows->border, &rows->edge[f + 1])) {
      atomic_store(&c->failed, true);
      break;
    }
    rows->triangle[f + 1] = face->n;
    for (size_t t = face->first; t < (size_t)face->first + face->n; t++) {
      for (int k = 0; k < 3; k++) { /* all write the same */
        __atomic_store_n(&rows->id[solid->triangle[t][k]], 1, __ATOMIC_RELAXED);
      }
    }
  }
  sg_border_clear(&scratch);
}

/* From counts to sums of those before. False: more than there are numbers. */
static bool
sum_up(sg_solid_rows *rows)
{
  uint64_t edges = 0;

  for (size_t f = 0; f < rows->solid->faces; f++) {
    edges += rows->edge[f + 1];
    rows->edge[f + 1] = (uint32_t)edges;
    rows->triangle[f + 1] += rows->triangle[f];
  }
  return edges < INT32_MAX;
}

static void
number_vertices(sg_solid_rows *rows)
{
  for (size_t v = 0; v < rows->solid->vertices; v++) {
    if (rows->id[v]) {
      rows->vertex[rows->vertices++] = (uint32_t)v;
      rows->id[v] = (int32_t)rows->vertices;
      rows->plain += v < rows->solid->plain;
    }
  }
}

bool
sg_solid_rows_make(const sg_solid *solid, sg_pool *pool,
                   const sg_cancel *cancel, sg_solid_rows *out)
{
  counting c = {.rows = out};

  *out = (sg_solid_rows){
      .solid = solid,
      .border = malloc(solid->triangles + 1),
      .edge = malloc((solid->faces + 1) * sizeof *out->edge),
      .triangle = malloc((solid->faces + 1) * sizeof *out->triangle),
      .id = calloc(solid->vertices + 1, sizeof *out->id),
      .vertex = malloc((solid->vertices + 1) * sizeof *out->vertex)};
  if (!out->border || !out->edge || !out->triangle || !out->id ||
      !out->vertex) {
    return false;
  }
  out->edge[0] = out->triangle[0] = 0;
  if (!sg_pool_run(pool, blocks_of(solid->faces), count_block, &c, cancel) ||
      atomic_load(&c.failed) || !sum_up(out)) {
    return false;
  }
  number_vertices(out);
  return true;
}

void
sg_solid_rows_clear(sg_solid_rows *rows)
{
  free(rows->border);
  free(rows->edge);
  free(rows->triangle);
  free(rows->id);
  free(rows->vertex);
  *rows = (sg_solid_rows){0};
}

/* ---- cells: vertices ---------------------------------------------------- */

typedef struct writing {
  const sg_solid_rows *rows;
  int32_t s;
  const sg_solid_sheets *out;
  size_t vertex_blocks; /* these tasks first, then blocks of faces */
} writing;

static void
write_vertices(const writing *w, size_t from, size_t end)
{
  sg_sheet_place at = sg_sheet_at(w->out->v, from);

  for (size_t i = from; i < end; i++, sg_sheet_next(&at)) {
    const double *p = w->rows->solid->vertex[w->rows->vertex[i]].at;
    const sg_blank *column = at.page->column;
    column[0].i[at.at] = w->s;
    column[1].i[at.at] = (int32_t)i + 1;
    for (int k = 0; k < 3; k++) {
      column[2 + k].f[at.at] = p[k] + 0.0; /* no -0.0 */
    }
  }
}

static void
write_vertex_sources(const writing *w, size_t from, size_t end)
{
  sg_sheet_place at = sg_sheet_at(w->out->from_v, from);

  for (size_t i = from; i < end; i++, sg_sheet_next(&at)) {
    const sg_solid_vertex *v = &w->rows->solid->vertex[w->rows->vertex[i]];
    const sg_blank *column = at.page->column;
    column[0].i[at.at] = w->s;
    column[1].i[at.at] = (int32_t)i + 1;
    column[2].i[at.at] = v->s;
    column[3].i[at.at] = v->v;
  }
}

/* ---- cells: faces ------------------------------------------------------- */

/* Where the next row of each relation goes. */
typedef struct places {
  sg_sheet_place e, p, plane, t, from_p;
} places;

static places
places_at(const writing *w, size_t face)
{
  return (places){.e = sg_sheet_at(w->out->e, w->rows->edge[face]),
                  .p = sg_sheet_at(w->out->p, face),
                  .plane = sg_sheet_at(w->out->plane, face),
                  .t = sg_sheet_at(w->out->t, w->rows->triangle[face]),
                  .from_p = sg_sheet_at(w->out->from_p, face)};
}

/* Writes the edges of triangle t of the solid; *e is the id of the last one. */
static void
write_edges(const writing *w, size_t t, sg_sheet_place *at, int32_t *e)
{
  const sg_solid *solid = w->rows->solid;
  const uint32_t *v = solid->triangle[t];

  for (int k = 0; k < 3; k++) {
    if (!(w->rows->border[t] >> k & 1)) {
      continue;
    }
    const sg_blank *column = at->page->column;
    column[0].i[at->at] = w->s;
    column[1].i[at->at] = ++*e;
    column[2].i[at->at] = w->rows->id[v[k]];
    column[3].i[at->at] = w->rows->id[v[(k + 1) % 3]];
    column[4].i[at->at] = !(solid->auxiliary[t] >> k & 1);
    sg_sheet_next(at);
  }
}

/* Sums the edges of triangle t up that are its face's. */
static void
sum_edges(const writing *w, size_t t, sg_newell *sum)
{
  const sg_solid *solid = w->rows->solid;
  const uint32_t *v = solid->triangle[t];

  for (int k = 0; k < 3; k++) {
    if (w->rows->border[t] >> k & 1) {
      sg_newell_edge(sum, solid->vertex[v[k]].at,
                     solid->vertex[v[(k + 1) % 3]].at);
    }
  }
}

static void
sum_face(const writing *w, const sg_solid_face *face, sg_newell *sum)
{
  const sg_solid *solid = w->rows->solid;
  const uint32_t *v = solid->triangle[face->first];

  sg_newell_init(sum);
  if (face->n == 1 && w->rows->border[face->first] == 7) {
    sg_newell_triangle(sum, solid->vertex[v[0]].at, solid->vertex[v[1]].at,
                       solid->vertex[v[2]].at);
    return;
  }
  for (uint32_t i = 0; i < face->n; i++) {
    sum_edges(w, face->first + i, sum);
  }
}

static void
write_triangle(const writing *w, int32_t p, int32_t t, const uint32_t v[3],
               sg_sheet_place *at)
{
  const sg_blank *column = at->page->column;

  column[0].i[at->at] = w->s;
  column[1].i[at->at] = p;
  column[2].i[at->at] = t;
  for (int k = 0; k < 3; k++) {
    column[3 + k].i[at->at] = w->rows->id[v[k]];
  }
  sg_sheet_next(at);
}

static void
write_polygon(const writing *w, int32_t p, int32_t first_edge, int32_t n,
              sg_sheet_place *at)
{
  const sg_blank *column = at->page->column;
  int32_t *list = column[2].list[at->at];

  column[0].i[at->at] = w->s;
  column[1].i[at->at] = p;
  list[0] = n;
  for (int32_t i = 0; i < n; i++) {
    list[1 + i] = first_edge + i;
  }
  sg_sheet_next(at);
}

/* Polygon 0: there is no plane; such rows are taken out afterwards. */
static void
write_plane(const writing *w, int32_t p, const sg_newell *sum,
            sg_sheet_place *at)
{
  const sg_blank *column = at->page->column;
  sg_plane plane = {{0}, 0};

  column[0].i[at->at] = w->s;
  column[1].i[at->at] = sg_newell_plane(sum, &plane) ? p : 0;
  for (int k = 0; k < 3; k++) {
    column[2 + k].f[at->at] = plane.n[k];
  }
  column[5].f[at->at] = plane.d;
  sg_sheet_next(at);
}

static void
write_source(const writing *w, int32_t p, int32_t s0, int32_t p0, bool reversed,
             sg_sheet_place *at)
{
  const sg_blank *column = at->page->column;

  column[0].i[at->at] = w->s;
  column[1].i[at->at] = p;
  column[2].i[at->at] = s0;
  column[3].i[at->at] = p0;
  column[4].i[at->at] = reversed ? -1 : 1;
  sg_sheet_next(at);
}

static void
write_faces(const writing *w, size_t from, size_t end)
{
  const sg_solid *solid = w->rows->solid;
  places at = places_at(w, from);
  int32_t e = (int32_t)w->rows->edge[from];
  int32_t t = (int32_t)w->rows->triangle[from];

  for (size_t f = from; f < end; f++) {
    const sg_solid_face *face = &solid->face[f];
    int32_t p = (int32_t)f + 1;
    sg_newell sum;
    write_polygon(w, p, e + 1,
                  (int32_t)(w->rows->edge[f + 1] - w->rows->edge[f]), &at.p);
    for (uint32_t i = 0; i < face->n; i++) {
      write_edges(w, face->first + i, &at.e, &e);
      write_triangle(w, p, ++t, solid->triangle[face->first + i], &at.t);
      if (i % ASKED == ASKED - 1 && sg_pool_stopping()) {
        return;
      }
    }
    sum_face(w, face, &sum);
    write_plane(w, p, &sum, &at.plane);
    if (solid->parts == 0) {
      write_source(w, p, face->s, face->p, face->reversed, &at.from_p);
    }
  }
}

static void
write_block(void *data, size_t task)
{
  const writing *w = data;
  const sg_solid_rows *rows = w->rows;

  if (task >= w->vertex_blocks) {
    size_t block = task - w->vertex_blocks;
    write_faces(w, block * BLOCK, end_of(block, rows->solid->faces));
    return;
  }
  size_t from = task * BLOCK, end = end_of(task, rows->vertices);

  write_vertices(w, from, end);
  if (from < rows->plain) {
    write_vertex_sources(w, from, end < rows->plain ? end : rows->plain);
  }
}

/* ---- faces of several polygons ------------------------------------------ */

typedef struct sg_solid_part part;

SG_ORDER(compare_parts, part, SG_BY(s) SG_BY(p));

/* What a face came from, n of them, each once; returns how many. */
static size_t
write_sources_of(const writing *w, size_t f, part *from, size_t n,
                 sg_sheet_place *at)
{
  size_t written = 0;

  qsort(from, n, sizeof *from, compare_parts);
  for (size_t i = 0; i < n; i++) {
    if (i == 0 || compare_parts(&from[i], &from[i - 1]) != 0) {
      write_source(w, (int32_t)f + 1, from[i].s, from[i].p, from[i].reversed,
                   at);
      written++;
    }
  }
  return written;
}

/* Where there are parts, that of the face itself is one more. */
static bool
write_sources(const writing *w, const sg_cancel *cancel, size_t *sources)
{
  const sg_solid *solid = w->rows->solid;
  sg_sheet_place at = sg_sheet_at(w->out->from_p, 0);
  part *from = malloc((solid->parts + 1) * sizeof *from);
  bool good = from != NULL;

  for (size_t f = 0, k = 0; f < solid->faces && good; f++) {
    const sg_solid_face *face = &solid->face[f];
    size_t n = 1;
    from[0] = (part){(uint32_t)f, face->s, face->p, face->reversed};
    while (k < solid->parts && solid->part[k].face == f) {
      from[n++] = solid->part[k++];
    }
    *sources += write_sources_of(w, f, from, n, &at);
    good = f % BLOCK != BLOCK - 1 || !sg_cancelled(cancel);
  }
  free(from);
  return good;
}

/* ---- together ----------------------------------------------------------- */

static void
move_plane(const sg_sheet_place *from, const sg_sheet_place *to)
{
  const sg_blank *a = from->page->column, *b = to->page->column;

  for (int c = 0; c < 2; c++) {
    b[c].i[to->at] = a[c].i[from->at];
  }
  for (int c = 2; c < 6; c++) {
    b[c].f[to->at] = a[c].f[from->at];
  }
}

/* Takes the rows of polygon 0 out; returns how many are left. */
static size_t
close_up_planes(const sg_sheet *plane)
{
  sg_sheet_place to = sg_sheet_at(plane, 0), from = to;
  size_t kept = 0;

  for (size_t i = 0; i < plane->rows; i++, sg_sheet_next(&from)) {
    if (from.page->column[1].i[from.at] != 0) {
      if (kept++ != i) {
        move_plane(&from, &to);
      }
      sg_sheet_next(&to);
    }
  }
  return kept;
}

bool
sg_solid_rows_write(const sg_solid_rows *rows, int32_t s, sg_pool *pool,
                    const sg_cancel *cancel, const sg_solid_sheets *out,
                    size_t *planes, size_t *sources)
{
  writing w = {rows, s, out, blocks_of(rows->vertices)};
  size_t tasks = w.vertex_blocks + blocks_of(rows->solid->faces);

  *sources = 0;
  if (!sg_pool_run(pool, tasks, write_block, &w, cancel)) {
    return false;
  }
  *planes = close_up_planes(out->plane);
  if (rows->solid->parts == 0) {
    *sources = rows->solid->faces;
    return true;
  }
  return write_sources(&w, cancel, sources);
}
