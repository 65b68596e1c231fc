/* cut_enter4pl.c -- cut sets: the scratch relation of a polygon, and the pieces
 * of lines that enter it and meet nothing there.
 *
 * Layer: glue. The doors are documented in rules/kernel.pl.
 */
#include "cut4pl.h"

#include "glue.h"
#include "work4pl.h"

#include "../engine/install.h"

#include <stdlib.h>

static functor_t functor_minus2, functor_work3;

/* The name that a point has in segment s, of several the one that `work` has;
 * made if it has none. 0: an exception. */
static int32_t
name_in_work_ex(sg_cut_handle *handle, const sg_work *work, uint32_t point,
                int32_t s)
{
  const sg_cut_points *points = &handle->set.points;
  int32_t first = sg_cut_name_ex(handle, point, s), v = first;

  while (v != 0 && sg_work_find(work, v) == SG_WORK_NONE) {
    v = sg_cut_points_next_name(points, point, s, v);
  }
  return v != 0 ? v : first;
}

/* ---- pieces ---- */

/* Enters piece k of segment s into `work`: 1; 0 if it meets anything there, or
 * has been divided elsewhere; -1: no memory. */
static int
enter_free(sg_cut_handle *handle, sg_work *work, int32_t s, uint32_t k,
           sg_meetings *met)
{
  const sg_cut_set *set = &handle->set;
  const sg_cut_piece *piece = &set->piece[k];
  int32_t v = sg_work_find(work, name_in_work_ex(handle, work, piece->a, s));
  int32_t w = sg_work_find(work, name_in_work_ex(handle, work, piece->b, s));

  if (v == SG_WORK_NONE || w == SG_WORK_NONE || v == w ||
      sg_cut_set_between(set, piece->a, piece->b) != SG_NO_KEY) {
    return 0;
  }
  if (!sg_work_meeting(work, v, w, met)) {
    return -1;
  }
  if (met->n > 0) {
    return 0;
  }
  return sg_work_add(work, v, w, 1, -1 - (int64_t)k) &&
                 sg_work_add(work, w, v, 1, -1 - (int64_t)k)
             ? 1
             : -1;
}

/* Takes out what was added after edge `last`. */
static void
take_out_after(sg_work *work, int32_t last)
{
  for (int32_t e = sg_work_newest(work); e > last; e--) {
    if (sg_work_get(work, e)) {
      sg_work_delete(work, e);
    }
  }
}

/* Enters all pieces of polygon p: 1; 0, with `work` as it was, if one meets
 * anything; -1: no memory. */
static int
enter_all_free(sg_cut_handle *handle, sg_work *work, int32_t s, int32_t p,
               sg_meetings *met)
{
  const sg_cut_set *set = &handle->set;
  const sg_cut_polygon *polygon = sg_cut_set_polygon(set, s, p);
  int32_t last = sg_work_newest(work);
  int entered = 1;

  for (size_t i = 0; polygon && i < polygon->n && entered > 0; i++) {
    entered =
        enter_free(handle, work, s, set->entering[polygon->first + i], met);
  }
  if (entered <= 0) {
    take_out_after(work, last);
  }
  return entered;
}

/* cut_enter_free(+Set, +S, +P, +Work) is semidet. */
static foreign_t
cut_enter_free(term_t t, term_t s, term_t p, term_t w)
{
  sg_cut_handle *handle;
  sg_work *work;
  int32_t key[2];
  sg_meetings met = {0};

  if (!sg_get_cut_set_ex(t, &handle) || !sg_get_id_ex(s, &key[0]) ||
      !sg_get_id_ex(p, &key[1]) || !sg_get_work_ex(w, &work)) {
    return FALSE;
  }
  int entered = enter_all_free(handle, work, key[0], key[1], &met);

  sg_meetings_clear(&met);
  return entered < 0 ? sg_no_memory() : entered;
}

/* ---- the scratch relation of one polygon ---- */

int32_t
sg_cut_enter_point_ex(sg_cut_handle *handle, sg_work *work, uint32_t point,
                      int32_t s)
{
  int32_t name = name_in_work_ex(handle, work, point, s);
  int32_t vertex =
      name ? sg_work_vertex(work, name, &handle->set.points.point[point].at)
           : SG_WORK_NONE;

  if (name && vertex == SG_WORK_NONE) {
    sg_no_memory();
  }
  return vertex;
}

/* The handle in `work` of a vertex of the model. */
static int32_t
enter_vertex_ex(sg_cut_handle *handle, sg_work *work, int32_t s, int32_t v)
{
  uint32_t number = sg_cut_model_fetch(&handle->set.model, s, v);
  sg_point at;

  if (number == SG_NO_KEY) {
    return SG_WORK_NONE;
  }
  sg_point_set(&at, handle->set.model.vertex[number].at);
  int32_t vertex = sg_work_vertex(work, v, &at);

  if (vertex == SG_WORK_NONE) {
    sg_no_memory();
  }
  return vertex;
}

/* The split edge v1-v2, null: it is not split. */
static const sg_split_edge *
find_split(const sg_cut_set *set, int32_t s, int32_t v1, int32_t v2)
{
  uint32_t a = sg_cut_model_find(&set->model, s, v1);
  uint32_t b = sg_cut_model_find(&set->model, s, v2);
  uint32_t key[2] = {a < b ? a : b, a < b ? b : a};
  uint32_t number = sg_key_table_get(&set->edge_number, key);

  return number == SG_NO_KEY ? NULL : &set->edge[number];
}

/* The points on an edge that came last, in n + 1 pieces: they are exactly on
 * it, but for those that it has from polygons which are not quite flat. */
static void
note_points(sg_work *work, int32_t n)
{
  int32_t last = sg_work_newest(work);
  int32_t start = sg_work_get(work, last - n)->start;
  int32_t end = sg_work_get(work, last)->end;

  for (int32_t e = last - n; e < last && start != end; e++) {
    sg_work_note_along(work, sg_work_get(work, e)->end, start, end);
  }
}

int
sg_cut_add_parts_ex(sg_cut_handle *handle, sg_work *work, int32_t s,
                    const int32_t v[2], int32_t et, int32_t label)
{
  const sg_split_edge *split = find_split(&handle->set, s, v[0], v[1]);
  size_t n = split ? split->n : 0;
  bool forward = n > 0 && handle->set.model.vertex[split->place.a].v == v[0];
  int32_t from = enter_vertex_ex(handle, work, s, v[0]);

  for (size_t i = 0; i <= n && from != SG_WORK_NONE; i++) {
    int32_t to =
        i == n ? enter_vertex_ex(handle, work, s, v[1])
               : sg_cut_enter_point_ex(
                     handle, work, split->point[forward ? i : n - 1 - i], s);
    if (to == SG_WORK_NONE) {
      return FALSE;
    }
    if (!sg_work_add(work, from, to, et, label)) {
      return sg_no_memory();
    }
    from = to;
  }
  if (n > 0 && !split->late && from != SG_WORK_NONE) {
    note_points(work, (int32_t)n);
  }
  return from != SG_WORK_NONE;
}

static int
add_edge_ex(sg_cut_handle *handle, sg_work *work, sg_row row)
{
  const sg_version *version = handle->version;
  int32_t v[2] = {sg_version_value(version, SG_E, row, 2).i,
                  sg_version_value(version, SG_E, row, 3).i};

  return sg_cut_add_parts_ex(handle, work,
                             sg_version_value(version, SG_E, row, 0).i, v,
                             sg_version_value(version, SG_E, row, 4).i,
                             sg_version_value(version, SG_E, row, 1).i);
}

static int
fill_work_ex(sg_cut_handle *handle, sg_work *work, int32_t s, sg_row polygon)
{
  const int32_t *list =
      sg_version_value(handle->version, SG_P, polygon, 2).list;

  for (int32_t i = 0; i < list[0]; i++) {
    sg_row row = sg_cut_row_of(handle, SG_E, s, list[i + 1]);

    if (row != SG_NO_ROW && !add_edge_ex(handle, work, row)) {
      return PL_exception(0) ? FALSE : PL_representation_error("vertex");
    }
  }
  return TRUE;
}

static int
enter_piece_ends_ex(sg_cut_handle *handle, sg_work *work, int32_t s, int32_t p)
{
  const sg_cut_set *set = &handle->set;
  const sg_cut_polygon *polygon = sg_cut_set_polygon(set, s, p);

  for (size_t i = 0; polygon && i < polygon->n; i++) {
    const sg_cut_piece *piece = &set->piece[set->entering[polygon->first + i]];

    if (sg_cut_enter_point_ex(handle, work, piece->a, s) == SG_WORK_NONE ||
        sg_cut_enter_point_ex(handle, work, piece->b, s) == SG_WORK_NONE) {
      return FALSE;
    }
  }
  return TRUE;
}

/* The polygon's normal. One without area has no plane; nothing enters it, so
 * any direction will do. */
static void
get_normal(sg_cut_handle *handle, int32_t s, int32_t p, double out[3])
{
  sg_row plane = sg_cut_row_of(handle, SG_PLANE, s, p);

  out[0] = out[1] = 0;
  out[2] = 1;
  for (unsigned c = 0; c < 3 && plane != SG_NO_ROW; c++) {
    out[c] = sg_version_value(handle->version, SG_PLANE, plane, c + 2).f;
  }
}

/* The scratch relation of polygon p; null: an exception. */
static sg_work *
open_work_ex(sg_cut_handle *handle, int32_t s, int32_t p, term_t p_term)
{
  sg_row polygon = sg_cut_row_of(handle, SG_P, s, p);
  double normal[3];

  if (polygon == SG_NO_ROW) {
    PL_existence_error("polygon", p_term);
    return NULL;
  }
  get_normal(handle, s, p, normal);
  sg_work *work = sg_work_open(normal);

  if (!work) {
    sg_no_memory();
    return NULL;
  }
  if (!fill_work_ex(handle, work, s, polygon) ||
      !sg_cut_add_folds_ex(handle, work, s, p) ||
      !enter_piece_ends_ex(handle, work, s, p)) {
    sg_work_close(work);
    return NULL;
  }
  return work;
}

static foreign_t
cut_work(term_t t, term_t s, term_t p, term_t out)
{
  sg_cut_handle *handle;
  int32_t key[2];

  if (!sg_get_cut_set_ex(t, &handle) || !sg_get_id_ex(s, &key[0]) ||
      !sg_get_id_ex(p, &key[1])) {
    return FALSE;
  }
  sg_work *work = open_work_ex(handle, key[0], key[1], p);

  return work && sg_unify_work(out, work);
}

/* ---- many polygons ---- */

enum { ASKED = 64 }; /* polygons between questions */

/* One polygon S-P, as work(S, P, Work) in `head`: 1; 0: it is not free; -1: an
 * exception. */
static int
enter_polygon_ex(sg_cut_handle *handle, term_t polygon, term_t head,
                 sg_meetings *met)
{
  term_t arg = PL_new_term_ref(), handle_term = PL_new_term_ref();
  int32_t s, p;

  if (!PL_is_functor(polygon, functor_minus2)) {
    PL_type_error("pair", polygon);
    return -1;
  }
  if (!PL_get_arg(1, polygon, arg) || !sg_get_id_ex(arg, &s) ||
      !PL_get_arg(2, polygon, arg) || !sg_get_id_ex(arg, &p)) {
    return -1;
  }
  sg_work *work = open_work_ex(handle, s, p, arg);

  if (!work) {
    return -1;
  }
  int entered = enter_all_free(handle, work, s, p, met);

  if (entered <= 0) {
    sg_work_close(work);
    return entered < 0 && !sg_no_memory() ? -1 : 0;
  }
  return sg_unify_work(handle_term, work) &&
                 PL_unify_term(head, PL_FUNCTOR, functor_work3, PL_INT, s,
                               PL_INT, p, PL_TERM, handle_term)
             ? 1
             : -1;
}

/* cut_enter_polygons(+Set, +Polygons, -Works, ?End, -Rest) is det. */
static foreign_t
cut_enter_polygons(term_t t, term_t polygons, term_t works, term_t end,
                   term_t rest)
{
  term_t from = PL_copy_term_ref(polygons), to = PL_copy_term_ref(works);
  term_t next = PL_new_term_ref(), polygon = PL_new_term_ref();
  term_t head = PL_new_term_ref();
  sg_cut_handle *handle;
  sg_meetings met = {0};
  int entered = 1;

  if (!sg_get_cut_set_ex(t, &handle)) {
    return FALSE;
  }
  for (size_t i = 1; entered > 0 && PL_get_list(from, polygon, next); i++) {
    fid_t frame = PL_open_foreign_frame();
    term_t one = PL_new_term_ref();

    entered = enter_polygon_ex(handle, polygon, one, &met);
    if (entered > 0 && (!PL_unify_list(to, head, to) || !PL_unify(head, one) ||
                        !PL_put_term(from, next) ||
                        (i % ASKED == 0 && PL_handle_signals() < 0))) {
      entered = -1;
    }
    PL_close_foreign_frame(frame);
  }
  sg_meetings_clear(&met);
  return entered >= 0 && PL_unify(to, end) && PL_unify(rest, from);
}

static const PL_extension predicates[] = {
    {"cut_enter_free", 4, cut_enter_free, 0},
    {"cut_work", 4, cut_work, 0},
    {"cut_enter_polygons", 5, cut_enter_polygons, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_cut_enter(void)
{
  functor_minus2 = PL_new_functor(PL_new_atom("-"), 2);
  functor_work3 = PL_new_functor(PL_new_atom("work"), 3);
  PL_register_extensions_in_module("sg_kernel", predicates);
}
