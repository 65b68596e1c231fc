/* boundary_rows.c -- boundaries of segments on their way to files.
 *
 * Layer: rows.
 */
#include "boundary_mesh.h"
#include "engine/search.h"
#include "mesh_rows.h"
#include "rows/dense_rows.h"

#include <math.h>
#include <stdlib.h>

/* Behind a handle: segments as they will be written. */
struct sg_boundaries {
  size_t segments;
  sg_form form;
  bool single;
  sg_boundary_mesh part[]; /* [segments] */
};

void
sg_boundaries_free(sg_boundaries *b)
{
  for (size_t i = 0; i < b->segments; i++) {
    sg_boundary_mesh_clear(&b->part[i]);
  }
  free(b);
}

/* Parts that are all zeros. Null: refused. */
static sg_boundaries *
make_boundaries(sg_call *call, size_t segments, sg_form form, bool single)
{
  sg_boundaries *b = calloc(1, sizeof *b + segments * sizeof b->part[0]);

  if (!b) {
    sg_call_no_memory(call);
    return NULL;
  }
  b->segments = segments;
  b->form = form;
  b->single = single;
  return b;
}

/* ---- opening ------------------------------------------------------------- */

typedef struct manner {
  sg_rounding rounding;
  sg_form form;
  bool keep_turned; /* polygons go as their triangles, and those that
                       rounding turned over stay */
} manner;

/* The place of segment s, or `segments`. */
static size_t
segment_place(const sg_dense *d, int32_t s)
{
  size_t i = 0;

  while (i < d->segments && d->segment[i] != s) {
    i++;
  }
  return i;
}

/* Marks the vertices listed, if there are such. */
static void
mark_made(const sg_dense *d, const sg_id_pair_list *list, unsigned char *made)
{
  for (size_t i = 0; i < list->n; i++) {
    size_t s = segment_place(d, list->at[i].a);

    if (s < d->segments) {
      size_t first = d->vertex_begin[s];
      size_t v = sg_find_id(d->vertex_id + first,
                            d->vertex_begin[s + 1] - first, list->at[i].b);
      if (v != SIZE_MAX) {
        made[first + v] = 1;
      }
    }
  }
}

/* The place of polygon p of segment s, or SIZE_MAX; mostly behind the last. */
static size_t
polygon_place(const sg_dense *d, int32_t s, int32_t p, size_t *last)
{
  size_t next = *last + 1;

  if (next < d->polygons && d->polygon_id[next] == p &&
      d->segment[sg_dense_segment_of(d, d->polygon_begin, (uint32_t)next)] ==
          s) {
    return *last = next;
  }
  size_t place = segment_place(d, s);

  if (place == d->segments) {
    return SIZE_MAX;
  }
  size_t first = d->polygon_begin[place];
  size_t found =
      sg_find_id(d->polygon_id + first, d->polygon_begin[place + 1] - first, p);

  return found == SIZE_MAX ? SIZE_MAX : (*last = first + found);
}

/* Fills normal[] of all polygons that have a row in plane/6. */
static bool
read_normals(sg_call *call, const sg_dense *d, double (*normal)[3])
{
  const sg_version *version = sg_call_version(call);
  sg_view view = {0};
  size_t last = SIZE_MAX - 1;

  if (!version || !sg_version_view(version, SG_PLANE, &view)) {
    return version ? sg_call_no_memory(call) : false;
  }
  for (size_t i = 0; i < view.pages; i++) {
    for (unsigned r = sg_live_next(view.live[i], 0); r < SG_PAGE_ROWS;
         r = sg_live_next(view.live[i], r + 1)) {
      size_t at = polygon_place(d, view.column[0].page[i].i[r],
                                view.column[1].page[i].i[r], &last);
      for (int k = 0; at != SIZE_MAX && k < 3; k++) {
        normal[at][k] = view.column[2 + k].page[i].f[r];
      }
    }
  }
  sg_view_clear(&view);
  return true;
}

enum { MOST_AGAIN = 4 };

/* Dividing faces may leave triangles without area: these go like others. */
static sg_boundary_end
make_again(const manner *how, const sg_cancel *cancel, sg_boundary_mesh *mesh)
{
  sg_boundary_end end = SG_BOUNDARY_DONE;
  bool any = how->form.triangles;

  for (int i = 0; i < MOST_AGAIN && any && end == SG_BOUNDARY_DONE; i++) {
    sg_boundary boundary;

    end = SG_BOUNDARY_NO_MEMORY;
    if (sg_boundary_of_mesh(mesh, &boundary, &any)) {
      end = SG_BOUNDARY_DONE;
    }
    if (any && end == SG_BOUNDARY_DONE) {
      sg_boundary_mesh_clear(mesh);
      end = sg_boundary_drop_flat(&boundary, false)
                ? sg_boundary_mesh_make(&boundary, &how->form, cancel, mesh)
                : SG_BOUNDARY_NO_MEMORY;
    }
    sg_boundary_clear(&boundary);
  }
  return end;
}

/* What boundaries are made from. */
typedef struct rows_read {
  sg_dense dense;
  unsigned char *made;
  double (*normal)[3];
} rows_read;

static void
rows_read_clear(rows_read *rows)
{
  sg_dense_clear(&rows->dense);
  free(rows->made);
  free(rows->normal);
  *rows = (rows_read){0};
}

/* The rows are cleared once the last part has a boundary. */
static sg_boundary_end
make_part(rows_read *rows, uint32_t s, const manner *how,
          const sg_cancel *cancel, sg_boundary_mesh *out)
{
  const sg_boundary_source source = {.dense = &rows->dense,
                                     .s = s,
                                     .made = rows->made,
                                     .normal = (const double(*)[3])rows->normal,
                                     .divided = how->keep_turned};
  sg_boundary boundary;
  sg_boundary_end end =
      sg_boundary_make(&source, &how->rounding, cancel, &boundary);

  if (s + 1 == rows->dense.segments) {
    rows_read_clear(rows);
  }
  if (end == SG_BOUNDARY_DONE) {
    end = sg_boundary_drop_flat(&boundary, !how->keep_turned)
              ? sg_boundary_mesh_make(&boundary, &how->form, cancel, out)
              : SG_BOUNDARY_NO_MEMORY;
  }
  sg_boundary_clear(&boundary);
  return end == SG_BOUNDARY_DONE ? make_again(how, cancel, out) : end;
}

static bool
is_done(sg_call *call, sg_boundary_end end)
{
  return end == SG_BOUNDARY_DONE      ? true
         : end == SG_BOUNDARY_TOO_FAR ? sg_call_cannot_hold(call, "float32")
                                      : sg_call_ended(call);
}

/* Frees what is not done. */
static bool
give(sg_boundaries *b, bool done, sg_boundaries **out)
{
  if (done) {
    *out = b;
  } else if (b) {
    sg_boundaries_free(b);
  }
  return done;
}

static bool
open_parts(sg_call *call, rows_read *rows, const sg_id_pair_list *list,
           const manner *how, sg_boundaries **out)
{
  const sg_dense *d = &rows->dense;
  uint32_t n = (uint32_t)d->segments;

  rows->made = calloc(d->vertices + 1, 1);
  rows->normal = calloc(d->polygons + 1, sizeof *rows->normal);
  sg_boundaries *b = make_boundaries(call, n, how->form, how->rounding.single);
  bool done =
      b && rows->made && rows->normal && read_normals(call, d, rows->normal);

  if (done) {
    mark_made(d, list, rows->made);
  } else if (b) {
    sg_call_ended(call);
  }
  for (uint32_t s = 0; done && s < n; s++) {
    done = is_done(call, make_part(rows, s, how, &call->cancel, &b->part[s]));
  }
  return give(b, done, out);
}

bool
sg_door_boundary_open(sg_call *call, const sg_int_list *segments,
                      const sg_id_pair_list *made, bool single, double grid,
                      int form, bool copies, sg_boundaries **out)
{
  bool soup = form == SG_BOUNDARY_FORM_SOUP;
  const manner how = {
      .rounding = {grid, single},
      .form = {.triangles = soup || form == SG_BOUNDARY_FORM_TRIANGLES,
               .flat = form == SG_BOUNDARY_FORM_FLAT,
               .copies = copies},
      .keep_turned = soup};
  rows_read rows = {0};
  bool done = sg_dense_read_these(call, segments, &rows.dense) &&
              open_parts(call, &rows, made, &how, out);

  rows_read_clear(&rows);
  return done;
}

bool
sg_door_boundary_coarsen(sg_call *call, sg_boundaries *from, double grid,
                         sg_boundaries **out)
{
  const manner how = {.rounding = {grid, from->single}, .form = from->form};
  sg_pool *pool = sg_call_pool(call);
  sg_boundaries *b =
      pool ? make_boundaries(call, from->segments, from->form, from->single)
           : NULL;
  bool done = b != NULL;

  for (size_t i = 0; done && i < b->segments; i++) {
    sg_boundary_end end =
        sg_boundary_mesh_coarsen(&from->part[i], &how.rounding, &how.form, pool,
                                 &call->cancel, &b->part[i]);
    done = is_done(call, end == SG_BOUNDARY_DONE
                             ? make_again(&how, &call->cancel, &b->part[i])
                             : end);
  }
  return give(b, done, out);
}

/* ---- what it is ---------------------------------------------------------- */

bool
sg_door_boundary_counts(sg_call *call, sg_boundaries *b,
                        sg_boundary_counts *out)
{
  (void)call;
  for (size_t i = 0; i < b->segments; i++) {
    const sg_boundary_mesh *m = &b->part[i];

    out->faces += m->mesh.face.count;
    out->open += m->open;
    out->crossing += m->crossing;
    out->stuck += m->stuck;
  }
  return true;
}

/* Those that are no mere touching in a point; of triangles that are not `all`,
 * no touching at all. */
static bool
add_meetings(sg_call *call, bool all, const sg_self_meetings *found,
             sg_boundary_meeting_list *out)
{
  bool good = true;

  for (size_t i = 0; good && i < found->n; i++) {
    const sg_self_meeting *m = &found->item[i];

    if (m->kind != SG_SELF_TOUCHING || (all && m->line)) {
      good = sg_boundary_meeting_list_add(call, out, *m);
    }
  }
  return good;
}

bool
sg_door_boundary_meetings(sg_call *call, sg_boundaries *b, bool all,
                          sg_boundary_meeting_list *out)
{
  sg_pool *pool = sg_call_pool(call);
  bool good = pool != NULL;

  for (size_t i = 0; good && i < b->segments; i++) {
    sg_self_meetings found;

    if (!sg_boundary_mesh_meetings(&b->part[i], all, pool, &call->cancel,
                                   &found)) {
      return sg_call_ended(call);
    }
    good = add_meetings(call, all, &found, out);
    free(found.item);
  }
  return good;
}

/* ---- where it goes ------------------------------------------------------- */

bool
sg_door_boundary_add(sg_call *call, sg_boundaries *b, int32_t s)
{
  sg_mesh_part_fact_list parts = {0};
  bool good = true;

  for (size_t i = 0; good && i < b->segments; i++) {
    good = sg_mesh_add_rows(call, &b->part[i].mesh, s + (int32_t)i, &parts);
  }
  return good;
}

/* All of one mesh behind another, as a segment of its own. */
static bool
append(const sg_mesh *from, sg_mesh *to)
{
  int32_t first = (int32_t)to->vertices, s = sg_mesh_add_segment(to, NULL, 0);
  bool done = s >= 0;

  to->grain = fmax(to->grain, from->grain);
  for (size_t v = 0; done && v < from->vertices; v++) {
    done = sg_mesh_add_vertex(to, from->vertex[v]);
  }
  for (size_t f = 0; done && f < from->face.count; f++) {
    for (uint32_t i = from->face.start[f]; done && i < from->face.start[f + 1];
         i++) {
      done = sg_mesh_add_corner(&to->face, from->face.corner[i] + first);
    }
    done = done && sg_mesh_end_list(&to->face, s);
  }
  return done;
}

bool
sg_door_boundary_write(sg_call *call, sg_boundaries *b, const sg_output *stream,
                       sg_mesh_format format, const sg_name_list *names,
                       sg_mesh_written *result)
{
  sg_mesh mesh = {0};
  bool good = true;

  if (b->segments == 1) {
    return sg_mesh_send(call, &b->part[0].mesh, names, format, stream, result);
  }
  for (size_t i = 0; good && i < b->segments; i++) {
    good = append(&b->part[i].mesh, &mesh);
  }
  good = good ? sg_mesh_send(call, &mesh, names, format, stream, result)
              : sg_call_no_memory(call);
  sg_mesh_clear(&mesh);
  return good;
}
