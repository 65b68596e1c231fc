/* boundary4pl.c -- boundaries of segments on their way to files (documented in
 * kernel/file.pl).
 *
 * Layer: glue.
 */
#include "boundary_mesh.h"
#include "glue.h"
#include "mesh4pl.h"
#include "rows/dense4pl.h"

#include "engine/install.h"
#include "engine/world4pl.h"

#include <SWI-Stream.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- the handle -----------------------------------------------------------
 */

typedef struct handle {
  size_t segments;
  sg_boundary_mesh *part; /* [segments] */
  sg_form form;
  bool single;
  bool closed;
} handle;

static void
close_handle(handle *h)
{
  for (size_t i = 0; i < h->segments && !h->closed; i++) {
    sg_boundary_mesh_clear(&h->part[i]);
  }
  free(h->part);
  h->part = NULL;
  h->closed = true;
}

static int
release_handle(atom_t atom)
{
  handle *h = PL_blob_data(atom, NULL, NULL);

  close_handle(h);
  free(h);
  return TRUE;
}

static int
write_handle(IOSTREAM *out, atom_t atom, int flags)
{
  const handle *h = PL_blob_data(atom, NULL, NULL);

  (void)flags;
  Sfprintf(out, h->closed ? "<boundary>(closed)" : "<boundary>(%zu)",
           h->segments);
  return TRUE;
}

static PL_blob_t boundary_blob = {.magic = PL_BLOB_MAGIC,
                                  .flags = PL_BLOB_UNIQUE | PL_BLOB_NOCOPY,
                                  .name = "boundary",
                                  .release = release_handle,
                                  .write = write_handle};

static int
get_boundary_ex(term_t t, handle **out)
{
  PL_blob_t *type;
  void *data;

  if (!PL_get_blob(t, &data, NULL, &type) || type != &boundary_blob) {
    return PL_type_error("boundary", t);
  }
  *out = data;
  return !(*out)->closed || PL_existence_error("boundary", t);
}

/* ---- opening ---------------------------------------------------------------
 */

typedef struct manner {
  sg_rounding rounding;
  sg_form form;
  bool keep_turned; /* polygons go as their triangles, and those that
                       rounding turned over stay */
} manner;

/* Marks vertex v of segment s, if there are such. */
static void
mark_made(const sg_dense *d, int32_t s, int32_t v, unsigned char *made)
{
  for (size_t i = 0; i < d->segments; i++) {
    size_t low = d->vertex_begin[i], end = d->vertex_begin[i + 1];

    if (d->segment[i] != s) {
      continue;
    }
    for (size_t high = end; low < high;) {
      size_t middle = low + (high - low) / 2;
      if (d->vertex_id[middle] < v) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    if (low < end && d->vertex_id[low] == v) {
      made[low] = 1;
    }
  }
}

/* From a list of S-V. */
static int
get_made_ex(term_t list, const sg_dense *d, unsigned char *made)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  term_t arg = PL_new_term_ref();
  functor_t pair = PL_new_functor(PL_new_atom("-"), 2);
  int32_t at[2];

  while (PL_get_list(tail, head, tail)) {
    if (!PL_is_functor(head, pair)) {
      return PL_type_error("pair", head);
    }
    for (int k = 0; k < 2; k++) {
      if (!PL_get_arg(k + 1, head, arg) || !sg_get_id_ex(arg, &at[k])) {
        return FALSE;
      }
    }
    mark_made(d, at[0], at[1], made);
  }
  return PL_get_nil_ex(tail);
}

/* The place of polygon p of segment s, or SIZE_MAX. */
static size_t
polygon_place(const sg_dense *d, int32_t s, int32_t p, size_t *last)
{
  if (*last + 1 < d->polygons && d->polygon_id[*last + 1] == p &&
      d->segment[sg_dense_segment_of(d, d->polygon_begin,
                                     (uint32_t)*last + 1)] == s) {
    return ++*last;
  }
  for (size_t i = 0; i < d->segments; i++) {
    size_t low = d->polygon_begin[i], end = d->polygon_begin[i + 1];

    if (d->segment[i] != s) {
      continue;
    }
    for (size_t high = end; low < high;) {
      size_t middle = low + (high - low) / 2;
      if (d->polygon_id[middle] < p) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    if (low < end && d->polygon_id[low] == p) {
      return *last = low;
    }
  }
  return SIZE_MAX;
}

/* Fills normal[] of all polygons that have a row in plane/6. */
static int
get_normals_ex(const sg_dense *d, double (*normal)[3])
{
  sg_world *world = sg_current_world_ex();
  const sg_version *version = world ? sg_world_version(world) : NULL;
  sg_view view;
  size_t last = SIZE_MAX - 1;

  if (!version || !sg_version_view(version, SG_PLANE, &view)) {
    sg_version_drop(version);
    return world ? sg_no_memory() : FALSE;
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
  sg_version_drop(version);
  return TRUE;
}

enum { MOST_AGAIN = 4 };

/* Dividing faces may leave triangles without area: these go like others. */
static sg_boundary_end
make_again(const manner *how, sg_boundary_mesh *mesh)
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
                ? sg_boundary_mesh_make(&boundary, &how->form, &sg_prolog_poll,
                                        mesh)
                : SG_BOUNDARY_NO_MEMORY;
    }
    sg_boundary_clear(&boundary);
  }
  return end;
}

static sg_boundary_end
make_part(const sg_boundary_source *source, const manner *how,
          sg_boundary_mesh *out)
{
  sg_boundary boundary;
  sg_boundary_end end =
      sg_boundary_make(source, &how->rounding, &sg_prolog_poll, &boundary);

  if (end == SG_BOUNDARY_DONE) {
    end =
        sg_boundary_drop_flat(&boundary, !how->keep_turned)
            ? sg_boundary_mesh_make(&boundary, &how->form, &sg_prolog_poll, out)
            : SG_BOUNDARY_NO_MEMORY;
  }
  sg_boundary_clear(&boundary);
  return end == SG_BOUNDARY_DONE ? make_again(how, out) : end;
}

/* Raises what `end` means. */
static int
raise_end_ex(sg_boundary_end end)
{
  switch (end) {
  case SG_BOUNDARY_DONE:
    return TRUE;
  case SG_BOUNDARY_STOPPED:
    return FALSE;
  case SG_BOUNDARY_NO_MEMORY:
    return PL_exception(0) ? FALSE : sg_no_memory();
  case SG_BOUNDARY_TOO_FAR:
    return PL_representation_error("float32");
  }
  return FALSE;
}

static int
make_parts_ex(handle *h, sg_boundary_source *source, const manner *how)
{
  size_t segments = source->dense->segments;

  h->part = calloc(segments + 1, sizeof *h->part);
  if (!h->part) {
    return sg_no_memory();
  }
  for (source->s = 0; source->s < segments; source->s++) {
    h->segments++;
    if (!raise_end_ex(make_part(source, how, &h->part[source->s]))) {
      return FALSE;
    }
  }
  return TRUE;
}

static int
read_parts_ex(handle *h, const sg_dense *d, term_t made_list, const manner *how)
{
  unsigned char *made = calloc(d->vertices + 1, 1);
  double(*normal)[3] = calloc(d->polygons + 1, sizeof *normal);
  sg_boundary_source source = {.dense = d,
                               .made = made,
                               .normal = (const double(*)[3])normal,
                               .divided = how->keep_turned};
  int done = made && normal ? get_made_ex(made_list, d, made) &&
                                  get_normals_ex(d, normal) &&
                                  make_parts_ex(h, &source, how)
                            : sg_no_memory();

  free(made);
  free(normal);
  return done;
}

/* polygons, flat, triangles or soup. */
static int
get_form_ex(term_t t, manner *out)
{
  char *name;

  if (!PL_get_chars(t, &name, CVT_ATOM | CVT_EXCEPTION)) {
    return FALSE;
  }
  out->keep_turned = !strcmp(name, "soup");
  out->form.triangles = out->keep_turned || !strcmp(name, "triangles");
  out->form.flat = !strcmp(name, "flat");
  return out->form.triangles || out->form.flat || !strcmp(name, "polygons") ||
         PL_domain_error("boundary_form", t);
}

/* boundary_open(+Segments, +Made, +Single, +Grid, +Form, +Copies, -Boundary)
 * is det. */
static foreign_t
boundary_open(term_t a0, int arity, void *context)
{
  manner how;
  int single, copies;
  int32_t *segment = NULL;
  size_t n;
  sg_dense dense;
  handle *h;

  (void)arity, (void)context;
  if (!PL_get_bool_ex(a0 + 2, &single) ||
      !sg_get_finite_ex(a0 + 3, &how.rounding.grid) ||
      !get_form_ex(a0 + 4, &how) || !PL_get_bool_ex(a0 + 5, &copies) ||
      !sg_get_ids_ex(a0, &segment, &n)) {
    return FALSE;
  }
  how.rounding.single = single;
  how.form.copies = copies;
  int32_t none = 0;
  if (!(h = calloc(1, sizeof *h))) {
    free(segment);
    return sg_no_memory();
  }
  h->form = how.form;
  h->single = single;
  int done = sg_get_dense_ex(segment ? segment : &none, n, &dense) &&
             read_parts_ex(h, &dense, a0 + 1, &how);
  sg_dense_clear(&dense);
  free(segment);
  if (!done) {
    close_handle(h);
    free(h);
    return FALSE;
  }
  return PL_unify_blob(a0 + 6, h, sizeof *h, &boundary_blob);
}

/* boundary_coarsen(+Boundary, +Grid, -Coarser) is det. */
static foreign_t
boundary_coarsen(term_t boundary, term_t grid, term_t coarser)
{
  handle *from, *h;
  sg_crew *crew;
  manner how = {.keep_turned = false};
  int done = TRUE;

  if (!get_boundary_ex(boundary, &from) ||
      !sg_get_finite_ex(grid, &how.rounding.grid)) {
    return FALSE;
  }
  how.rounding.single = from->single;
  how.form = from->form;
  h = calloc(1, sizeof *h);
  crew = sg_crew_open(0);
  if (!h || !crew || !(h->part = calloc(from->segments + 1, sizeof *h->part))) {
    sg_crew_close(crew);
    free(h);
    return sg_no_memory();
  }
  h->form = from->form;
  h->single = from->single;
  for (size_t i = 0; done && i < from->segments; i++) {
    h->segments++;
    sg_boundary_end end =
        sg_boundary_mesh_coarsen(&from->part[i], &how.rounding, &how.form, crew,
                                 &sg_prolog_poll, &h->part[i]);
    end = end == SG_BOUNDARY_DONE ? make_again(&how, &h->part[i]) : end;
    done = raise_end_ex(end);
  }
  sg_crew_close(crew);
  if (!done) {
    close_handle(h);
    free(h);
    return FALSE;
  }
  return PL_unify_blob(coarser, h, sizeof *h, &boundary_blob);
}

static foreign_t
boundary_close(term_t boundary)
{
  handle *h;

  if (!get_boundary_ex(boundary, &h)) {
    return FALSE;
  }
  close_handle(h);
  return TRUE;
}

/* ---- what it is
 * --------------------------------------------------------------- */

/* boundary_counts(+Boundary, -Counts) is det. */
static foreign_t
boundary_counts(term_t boundary, term_t counts)
{
  handle *h;
  int64_t n[9] = {0};

  if (!get_boundary_ex(boundary, &h)) {
    return FALSE;
  }
  for (size_t i = 0; i < h->segments; i++) {
    const sg_boundary_mesh *m = &h->part[i];
    size_t each[9] = {m->mesh.vertices, m->mesh.face.count, m->triangles,
                      m->open,          m->crossing,        m->touching,
                      m->copies,        m->stuck,           m->cancelled};
    for (int k = 0; k < 9; k++) {
      n[k] += (int64_t)each[k];
    }
  }
  return PL_unify_term(counts, PL_FUNCTOR_CHARS, "counts", 9, PL_INT64, n[0],
                       PL_INT64, n[1], PL_INT64, n[2], PL_INT64, n[3], PL_INT64,
                       n[4], PL_INT64, n[5], PL_INT64, n[6], PL_INT64, n[7],
                       PL_INT64, n[8]);
}

static int
unify_meeting(term_t t, const sg_self_meeting *m)
{
  return PL_unify_term(t, PL_FUNCTOR_CHARS, "meeting", 4, PL_CHARS,
                       sg_self_name[m->kind], PL_FLOAT, m->at[0] + 0.0,
                       PL_FLOAT, m->at[1] + 0.0, PL_FLOAT, m->at[2] + 0.0);
}

/* Adds to `list` those that are no mere touching in a point; of triangles that
 * are not `all`, no touching at all. */
static int
add_meetings(term_t tail, term_t head, bool all, const sg_self_meetings *found)
{
  for (size_t i = 0; i < found->n; i++) {
    if ((found->item[i].kind != SG_SELF_TOUCHING ||
         (all && found->item[i].line)) &&
        (!PL_unify_list(tail, head, tail) ||
         !unify_meeting(head, &found->item[i]))) {
      return FALSE;
    }
  }
  return TRUE;
}

/* boundary_meetings(+Boundary, +All, -Meetings) is det. */
static foreign_t
boundary_meetings(term_t boundary, term_t all_term, term_t meetings)
{
  handle *h;
  int all, done = TRUE;
  term_t tail = PL_copy_term_ref(meetings), head = PL_new_term_ref();
  sg_crew *crew;

  if (!get_boundary_ex(boundary, &h) || !PL_get_bool_ex(all_term, &all)) {
    return FALSE;
  }
  if (!(crew = sg_crew_open(0))) {
    return sg_no_memory();
  }
  for (size_t i = 0; done && i < h->segments; i++) {
    sg_self_meetings found;
    if (!sg_boundary_mesh_meetings(&h->part[i], all, crew, &sg_prolog_poll,
                                   &found)) {
      done = PL_exception(0) ? FALSE : sg_no_memory();
      break;
    }
    done = add_meetings(tail, head, all, &found);
    free(found.item);
  }
  sg_crew_close(crew);
  return done && PL_unify_nil(tail);
}

/* ---- where it goes
 * --------------------------------------------------------------- */

/* boundary_add(+Boundary, +S) is det. */
static foreign_t
boundary_add(term_t boundary, term_t segment)
{
  handle *h;
  int32_t s;

  if (!get_boundary_ex(boundary, &h) || !sg_get_id_ex(segment, &s)) {
    return FALSE;
  }
  for (size_t i = 0; i < h->segments; i++) {
    if (!sg_add_mesh_ex(&h->part[i].mesh, s + (int32_t)i, PL_new_term_ref())) {
      return FALSE;
    }
  }
  return TRUE;
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

/* boundary_write(+Boundary, +Stream, +Format, +Names, -Result) is det. */
static foreign_t
boundary_write(term_t boundary, term_t stream, term_t format_term, term_t names,
               term_t result)
{
  handle *h;
  sg_mesh_format format;
  sg_mesh mesh = {0};
  bool room = true;

  if (!get_boundary_ex(boundary, &h) ||
      !sg_get_mesh_format_ex(format_term, &format)) {
    return FALSE;
  }
  for (size_t i = 0; room && i < h->segments; i++) {
    room = append(&h->part[i].mesh, &mesh);
  }
  int done = room ? sg_name_segments_ex(names, &mesh) &&
                        sg_write_mesh_ex(stream, format, &mesh, result)
                  : sg_no_memory();
  sg_mesh_clear(&mesh);
  return done;
}

static const PL_extension predicates[] = {
    {"boundary_open", 7, boundary_open, PL_FA_VARARGS},
    {"boundary_coarsen", 3, boundary_coarsen, 0},
    {"boundary_close", 1, boundary_close, 0},
    {"boundary_counts", 2, boundary_counts, 0},
    {"boundary_meetings", 3, boundary_meetings, 0},
    {"boundary_add", 2, boundary_add, 0},
    {"boundary_write", 5, boundary_write, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_boundary(void)
{
  PL_register_extensions_in_module("sg_kernel_file", predicates);
}
