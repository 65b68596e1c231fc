/* seam4pl.c -- cut sets: putting the cuts into polygons, and what comes out.
 *
 * Layer: glue. The doors are documented in rules/kernel.pl.
 */
#include "cut4pl.h"

#include "glue.h"
#include "work4pl.h"

#include "../engine/install.h"

#include <stdlib.h>

/* ---- names ---- */

/* The name of a point in segment s, made if it has none; 0: an exception. */
static int32_t
name_ex(sg_cut_handle *handle, uint32_t point, int32_t s)
{
  int32_t name = sg_cut_points_name(&handle->set.points, point, s);
  uint32_t key = (uint32_t)s;

  if (name != 0) {
    return name;
  }
  uint32_t *next = sg_key_table_put(&handle->next_name, &key);

  if (!next || *next == SG_NO_KEY ||
      !sg_cut_points_set_name(&handle->set.points, point, s, (int32_t)*next)) {
    sg_no_memory();
    return 0;
  }
  return (int32_t)(*next)++;
}

/* Whether vertex v is one of polygon p. */
static bool
is_in_polygon(sg_cut_handle *handle, int32_t s, int32_t p, int32_t v)
{
  sg_row row = sg_cut_row_of(handle, SG_P, s, p);
  const int32_t *list =
      row == SG_NO_ROW ? NULL
                       : sg_version_value(handle->version, SG_P, row, 2).list;

  for (int32_t i = 1; list && i <= list[0]; i++) {
    sg_row at = sg_cut_row_of(handle, SG_E, s, list[i]);

    if (at != SG_NO_ROW &&
        (sg_version_value(handle->version, SG_E, at, 2).i == v ||
         sg_version_value(handle->version, SG_E, at, 3).i == v)) {
      return true;
    }
  }
  return false;
}

int32_t
sg_cut_name_in(sg_cut_handle *handle, uint32_t point, int32_t s, int32_t p)
{
  const sg_cut_points *points = &handle->set.points;
  int32_t first = sg_cut_points_name(points, point, s);
  int32_t v = first;

  if (sg_cut_points_next_name(points, point, s, first) == 0) {
    return first;
  }
  while (v != 0 && !is_in_polygon(handle, s, p, v)) {
    v = sg_cut_points_next_name(points, point, s, v);
  }
  return v != 0 ? v : first;
}

/* The same for a polygon whose edges are in `work`; made if it has none. 0: an
 * exception. */
static int32_t
name_in_work_ex(sg_cut_handle *handle, const sg_work *work, uint32_t point,
                int32_t s)
{
  const sg_cut_points *points = &handle->set.points;
  int32_t first = name_ex(handle, point, s), v = first;

  while (v != 0 && sg_work_find(work, v) == SG_WORK_NONE) {
    v = sg_cut_points_next_name(points, point, s, v);
  }
  return v != 0 ? v : first;
}

static bool
is_joint(const sg_cut_set *set, uint32_t point)
{
  uint32_t k, l;

  return sg_cut_set_joint(set, point, &k, &l);
}

/* Names all ends of pieces, all points on edges and all contacts. Those that
 * will likely be joined away come last, so that the others are numbered without
 * gaps. */
static int
name_all_ex(sg_cut_handle *handle)
{
  const sg_cut_set *set = &handle->set;

  for (int pass = 0; pass < 2; pass++) {
    for (size_t i = 0; i < set->pieces; i++) {
      const sg_cut_piece *piece = &set->piece[i];

      for (int k = 0; piece->live && k < 4; k++) {
        uint32_t end = k < 2 ? piece->a : piece->b;
        if (is_joint(set, end) == (pass == 1) &&
            !name_ex(handle, end, piece->s[k % 2])) {
          return FALSE;
        }
      }
    }
  }
  for (size_t i = 0; i < set->edges; i++) {
    for (size_t k = 0; k < set->edge[i].n; k++) {
      if (!name_ex(handle, set->edge[i].point[k], set->edge[i].s)) {
        return FALSE;
      }
    }
  }
  for (size_t i = 0; i < set->contacts; i++) {
    const sg_cut_contact *contact = &set->contact[i];

    if (!name_ex(handle, contact->point, contact->s[0]) ||
        !name_ex(handle, contact->point, contact->s[1])) {
      return FALSE;
    }
  }
  return TRUE;
}

/* ---- sealing ---- */

static foreign_t
cut_seal(term_t t)
{
  sg_cut_handle *handle;

  return sg_get_cut_set_ex(t, &handle) &&
         ((sg_cut_set_seal(&handle->set) && sg_cut_set_link(&handle->set)) ||
          sg_no_memory());
}

/* ---- the polygons ---- */

/* Lists the polygons and names the points, once. */
static int
group_ex(sg_cut_handle *handle)
{
  sg_cut_set *set = &handle->set;

  if (handle->grouped) {
    return TRUE;
  }
  if (!sg_cut_add_beside(handle, false)) {
    return sg_no_memory();
  }
  handle->grouped = true;
  return (sg_cut_set_group(set) || sg_no_memory()) && name_all_ex(handle);
}

static foreign_t
cut_polygons(term_t t, term_t list)
{
  sg_cut_handle *handle;
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  if (!sg_get_cut_set_ex(t, &handle) || !group_ex(handle)) {
    return FALSE;
  }
  for (size_t i = 0; i < handle->set.polygons; i++) {
    const sg_cut_polygon *polygon = &handle->set.polygon[i];

    if (!PL_unify_list(tail, head, tail) ||
        !PL_unify_term(head, PL_FUNCTOR_CHARS, "-", 2, PL_INT, polygon->s,
                       PL_INT, polygon->p)) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

static bool
is_among(const int32_t *s, size_t n, int32_t one)
{
  for (size_t i = 0; i < n; i++) {
    if (s[i] == one) {
      return true;
    }
  }
  return false;
}

/* The polygons that carry a piece of one of n segments. */
static bool
note_carriers(const sg_cut_set *set, const int32_t *s, size_t n,
              sg_key_table *out)
{
  for (size_t i = 0; i < set->pieces; i++) {
    const sg_cut_piece *piece = &set->piece[i];

    if (!piece->live ||
        !(is_among(s, n, piece->s[0]) || is_among(s, n, piece->s[1]))) {
      continue;
    }
    for (int k = 0; k < 2; k++) {
      uint32_t key[2] = {(uint32_t)piece->s[k], (uint32_t)piece->p[k]};
      uint32_t *known = sg_key_table_put(out, key);

      if (!known) {
        return false;
      }
      *known = 1;
    }
  }
  return true;
}

/* cut_polygons_of(+Set, +Segments, -Polygons) is det. */
static foreign_t
cut_polygons_of(term_t t, term_t segments, term_t list)
{
  sg_cut_handle *handle;
  int32_t *s;
  size_t n;
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  if (!sg_get_cut_set_ex(t, &handle) || !group_ex(handle) ||
      !sg_get_ids_ex(segments, &s, &n)) {
    return FALSE;
  }
  sg_key_table carrier;

  sg_key_table_init(&carrier, 2);
  int good = note_carriers(&handle->set, s, n, &carrier) || sg_no_memory();

  for (size_t i = 0; i < handle->set.polygons && good; i++) {
    const sg_cut_polygon *polygon = &handle->set.polygon[i];
    uint32_t key[2] = {(uint32_t)polygon->s, (uint32_t)polygon->p};

    if (is_among(s, n, polygon->s) ||
        sg_key_table_get(&carrier, key) != SG_NO_KEY) {
      good = PL_unify_list(tail, head, tail) &&
             PL_unify_term(head, PL_FUNCTOR_CHARS, "-", 2, PL_INT, polygon->s,
                           PL_INT, polygon->p);
    }
  }
  sg_key_table_clear(&carrier);
  free(s);
  return good && PL_unify_nil(tail);
}

/* ---- the scratch relation of one polygon ---- */

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

/* cut_enter_free(+Set, +S, +P, +Work) is semidet. */
static foreign_t
cut_enter_free(term_t t, term_t s, term_t p, term_t w)
{
  sg_cut_handle *handle;
  sg_work *work;
  int32_t key[2];
  sg_meetings met = {0};
  int entered = 1;

  if (!sg_get_cut_set_ex(t, &handle) || !sg_get_id_ex(s, &key[0]) ||
      !sg_get_id_ex(p, &key[1]) || !sg_get_work_ex(w, &work)) {
    return FALSE;
  }
  const sg_cut_set *set = &handle->set;
  const sg_cut_polygon *polygon = sg_cut_set_polygon(set, key[0], key[1]);
  int32_t last = sg_work_newest(work);

  for (size_t i = 0; polygon && i < polygon->n && entered > 0; i++) {
    entered = enter_free(handle, work, key[0],
                         set->entering[polygon->first + i], &met);
  }
  sg_meetings_clear(&met);
  if (entered <= 0) {
    take_out_after(work, last);
  }
  return entered < 0 ? sg_no_memory() : entered;
}

/* The pieces that enter polygon p: piece(K, V1, V2), V1-V2 in its segment. */
static foreign_t
cut_entering(term_t t, term_t s, term_t p, term_t list)
{
  sg_cut_handle *handle;
  int32_t key[2];
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  if (!sg_get_cut_set_ex(t, &handle) || !sg_get_id_ex(s, &key[0]) ||
      !sg_get_id_ex(p, &key[1])) {
    return FALSE;
  }
  const sg_cut_set *set = &handle->set;
  const sg_cut_polygon *polygon = sg_cut_set_polygon(set, key[0], key[1]);

  for (size_t i = 0; polygon && i < polygon->n; i++) {
    uint32_t k = set->entering[polygon->first + i];
    const sg_cut_piece *piece = &set->piece[k];

    if (!PL_unify_list(tail, head, tail) ||
        !PL_unify_term(head, PL_FUNCTOR_CHARS, "piece", 3, PL_INT, (int)k,
                       PL_INT, sg_cut_name_in(handle, piece->a, key[0], key[1]),
                       PL_INT,
                       sg_cut_name_in(handle, piece->b, key[0], key[1]))) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

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

/* Adds one edge of the polygon in the pieces it is split into. */
static int
add_split_edge_ex(sg_cut_handle *handle, sg_work *work, sg_row row)
{
  int32_t s = sg_version_value(handle->version, SG_E, row, 0).i;
  int32_t e = sg_version_value(handle->version, SG_E, row, 1).i;
  int32_t v1 = sg_version_value(handle->version, SG_E, row, 2).i;
  int32_t v2 = sg_version_value(handle->version, SG_E, row, 3).i;
  int32_t et = sg_version_value(handle->version, SG_E, row, 4).i;
  const sg_split_edge *split = find_split(&handle->set, s, v1, v2);
  size_t n = split ? split->n : 0;
  bool forward = n > 0 && handle->set.model.vertex[split->place.a].v == v1;
  int32_t from = enter_vertex_ex(handle, work, s, v1);

  for (size_t i = 0; i <= n && from != SG_WORK_NONE; i++) {
    int32_t to =
        i == n ? enter_vertex_ex(handle, work, s, v2)
               : sg_cut_enter_point_ex(
                     handle, work, split->point[forward ? i : n - 1 - i], s);
    if (to == SG_WORK_NONE) {
      return FALSE;
    }
    if (!sg_work_add(work, from, to, et, e)) {
      return sg_no_memory();
    }
    from = to;
  }
  return from != SG_WORK_NONE;
}

static int
fill_work_ex(sg_cut_handle *handle, sg_work *work, int32_t s, sg_row polygon)
{
  const int32_t *list =
      sg_version_value(handle->version, SG_P, polygon, 2).list;

  for (int32_t i = 0; i < list[0]; i++) {
    sg_row row = sg_cut_row_of(handle, SG_E, s, list[i + 1]);

    if (row != SG_NO_ROW && !add_split_edge_ex(handle, work, row)) {
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

static foreign_t
cut_work(term_t t, term_t s, term_t p, term_t out)
{
  sg_cut_handle *handle;
  int32_t key[2];
  double normal[3];

  if (!sg_get_cut_set_ex(t, &handle) || !sg_get_id_ex(s, &key[0]) ||
      !sg_get_id_ex(p, &key[1])) {
    return FALSE;
  }
  sg_row polygon = sg_cut_row_of(handle, SG_P, key[0], key[1]);

  if (polygon == SG_NO_ROW) {
    return PL_existence_error("polygon", p);
  }
  get_normal(handle, key[0], key[1], normal);
  sg_work *work = sg_work_open(normal);

  if (!work) {
    return sg_no_memory();
  }
  if (!fill_work_ex(handle, work, key[0], polygon) ||
      !enter_piece_ends_ex(handle, work, key[0], key[1])) {
    sg_work_close(work);
    return FALSE;
  }
  return sg_unify_work(out, work);
}

/* ---- what was found while entering ---- */

static foreign_t
cut_agree(term_t t)
{
  sg_cut_handle *handle;

  if (!sg_get_cut_set_ex(t, &handle)) {
    return FALSE;
  }
  return ((sg_cut_set_agree(&handle->set) && sg_cut_set_link(&handle->set)) ||
          sg_no_memory()) &&
         name_all_ex(handle);
}

/* The polygons, S-P, with edges that were divided while others were entered. */
static foreign_t
cut_late_polygons(term_t t, term_t list)
{
  sg_cut_handle *handle;
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  if (!sg_get_cut_set_ex(t, &handle)) {
    return FALSE;
  }
  sg_cut_set *set = &handle->set;

  if (set->late.n == 0) { /* mostly nothing was divided anywhere */
    return PL_unify_nil(tail);
  }
  size_t listed = set->polygons;
  int good = sg_cut_add_beside(handle, true) || sg_no_memory();

  for (size_t i = listed; good && i < set->polygons; i++) {
    good = PL_unify_list(tail, head, tail) &&
           PL_unify_term(head, PL_FUNCTOR_CHARS, "-", 2, PL_INT,
                         set->polygon[i].s, PL_INT, set->polygon[i].p);
  }
  set->polygons = listed;
  return good && PL_unify_nil(tail);
}

static const PL_extension predicates[] = {
    {"cut_seal", 1, cut_seal, 0},
    {"cut_polygons", 2, cut_polygons, 0},
    {"cut_polygons_of", 3, cut_polygons_of, 0},
    {"cut_entering", 4, cut_entering, 0},
    {"cut_enter_free", 4, cut_enter_free, 0},
    {"cut_work", 4, cut_work, 0},
    {"cut_agree", 1, cut_agree, 0},
    {"cut_late_polygons", 2, cut_late_polygons, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_seam(void)
{
  PL_register_extensions_in_module("sg_kernel", predicates);
}
