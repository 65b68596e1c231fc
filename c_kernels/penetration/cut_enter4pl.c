/* cut_enter4pl.c -- cut sets: the scratch relation of a polygon, and the pieces
 * of lines that enter it and meet nothing there.
 *
 * Layer: glue. The doors are documented in rules/kernel/penetration.pl.
 */
#include "cut4pl.h"

#include "glue.h"
#include "polygon/work4pl.h"

#include "engine/install.h"

#include <stdlib.h>

static functor_t functor_minus2, functor_work3;

/* The name that a point has in segment s, of several the one that `work` has;
 * made if it has none. 0: an exception. */
static int32_t
name_in_work_ex(sg_cut_handle *handle, const sg_work *work, uint32_t point,
                int32_t s)
{
  return sg_cut_name_ex(handle, point, s) == 0
             ? 0
             : sg_cut_points_good_name(&handle->set.points, point, s,
                                       sg_cut_is_in_work, work);
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
  int entered = sg_cut_enter_free(&handle->set, work, key[0], key[1], &met);

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

static int
add_edge_ex(const sg_cut_handle *handle, sg_row row, sg_outlines *out)
{
  int32_t cell[5];

  for (unsigned c = 1; c < 5; c++) {
    cell[c] = sg_version_value(handle->version, SG_E, row, c).i;
  }
  return sg_outlines_add_edge(
             out, &(sg_outline_edge){cell[1], cell[2], cell[3], cell[4]}) ||
         sg_no_memory();
}

int
sg_cut_outline_ex(sg_cut_handle *handle, int32_t s, int32_t p, term_t p_term,
                  sg_outlines *out)
{
  sg_row polygon = sg_cut_row_of(handle, SG_P, s, p);
  double normal[3];

  if (polygon == SG_NO_ROW) {
    return PL_existence_error("polygon", p_term);
  }
  get_normal(handle, s, p, normal);
  if (!sg_outlines_add(out, s, p, normal)) {
    return sg_no_memory();
  }
  const int32_t *list =
      sg_version_value(handle->version, SG_P, polygon, 2).list;

  for (int32_t i = 0; i < list[0]; i++) {
    sg_row row = sg_cut_row_of(handle, SG_E, s, list[i + 1]);

    if (row != SG_NO_ROW && !add_edge_ex(handle, row, out)) {
      return FALSE;
    }
  }
  return list[0] <= 3 || sg_cut_add_folds_ex(handle, s, p, out);
}

/* Names all points that a polygon has. Mostly they have names. */
static int
name_points_ex(sg_cut_handle *handle, const sg_outline *polygon,
               const sg_outline_edge *edge)
{
  const sg_cut_set *set = &handle->set;
  const sg_cut_polygon *cut = sg_cut_set_polygon(set, polygon->s, polygon->p);
  int good = TRUE;

  for (size_t k = 0; k < polygon->n && good; k++) {
    const sg_split_edge *split =
        sg_cut_split_edge(set, polygon->s, edge[k].v1, edge[k].v2);

    for (size_t i = 0; split && i < split->n && good; i++) {
      good = sg_cut_name_ex(handle, split->point[i], polygon->s) != 0;
    }
  }
  for (size_t i = 0; cut && i < cut->n && good; i++) {
    const sg_cut_piece *piece = &set->piece[set->entering[cut->first + i]];

    good = sg_cut_name_ex(handle, piece->a, polygon->s) != 0 &&
           sg_cut_name_ex(handle, piece->b, polygon->s) != 0;
  }
  return good;
}

/* Fills an open work with the last outline. */
static int
fill_work_ex(sg_cut_handle *handle, const sg_outlines *all, sg_work *work)
{
  const sg_outline *polygon = &all->polygon[all->n - 1];
  sg_outcome outcome =
      sg_cut_enter_outline(&handle->set, all, all->n - 1, work);

  if (outcome == SG_STUCK) {
    if (!name_points_ex(handle, polygon, all->edge + polygon->first)) {
      return FALSE;
    }
    sg_work_clear(work, polygon->normal);
    outcome = sg_cut_enter_outline(&handle->set, all, all->n - 1, work);
  }
  return outcome == SG_DONE    ? TRUE
         : outcome == SG_STUCK ? PL_representation_error("vertex")
                               : sg_no_memory();
}

/* The scratch relation of polygon p; null: an exception. */
static sg_work *
open_work_ex(sg_cut_handle *handle, int32_t s, int32_t p, term_t p_term)
{
  sg_outlines one = {0};
  sg_work *work = NULL;

  if (sg_cut_outline_ex(handle, s, p, p_term, &one)) {
    work = sg_work_open(one.polygon->normal);
    if (!work) {
      sg_no_memory();
    } else if (!fill_work_ex(handle, &one, work)) {
      sg_work_close(work);
      work = NULL;
    }
  }
  sg_outlines_clear(&one);
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
  int entered = sg_cut_enter_free(&handle->set, work, s, p, met);

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
  PL_register_extensions_in_module("sg_kernel_penetration", predicates);
}
