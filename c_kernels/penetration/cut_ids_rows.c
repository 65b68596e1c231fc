/* cut_ids_rows.c -- cut sets: rows by id, and what is beside a split edge.
 *
 * Layer: rows. A cut set asks for some thousand rows of what may be millions,
 * just once. Most are found by counting; for the others to walk the segments is
 * cheaper than to build the indexes of the relations.
 */
#include "cut_rows.h"
#include "engine/list.h"

#include <stdlib.h>
#include <string.h>

/* The table of a relation; -1: it has none. */
static int
place_of(sg_relation relation)
{
  return relation == SG_E       ? 0
         : relation == SG_P     ? 1
         : relation == SG_PLANE ? 2
                                : -1;
}

static bool
fill_table(const sg_cut_handle *handle, sg_relation relation,
           sg_cut_rows_by_id *out)
{
  sg_view view;
  sg_segment_rows rows = {0};
  bool good = sg_version_view(handle->version, relation, &view);

  if (!good) {
    return false;
  }
  out->of = calloc(handle->segments + 1, sizeof *out->of);
  good = out->of && sg_segment_rows_find(&view, handle->segment,
                                         handle->segments, NULL, &rows);
  for (size_t i = 0; i < handle->segments && good; i++) {
    good = sg_id_rows_make(&view, rows.row + rows.begin[i],
                           rows.begin[i + 1] - rows.begin[i], &out->of[i]);
  }
  sg_segment_rows_clear(&rows);
  sg_view_clear(&view);
  return good;
}

void
sg_cut_rows_clear(sg_cut_handle *handle)
{
  for (int k = 0; k < SG_CUT_TABLES; k++) {
    for (size_t i = 0; handle->by_id[k].of && i < handle->segments; i++) {
      sg_id_rows_clear(&handle->by_id[k].of[i]);
    }
    free(handle->by_id[k].of);
    handle->by_id[k].of = NULL;
  }
}

sg_row
sg_cut_row_of(sg_cut_handle *handle, sg_relation relation, int32_t s,
              int32_t id)
{
  size_t place = sg_cut_place_of(handle, s);
  int k = place_of(relation);
  sg_value key[SG_MAX_COLUMNS] = {[0].i = s, [1].i = id};
  sg_row counted = sg_version_find_counted(handle->version, relation, key);

  if (counted != SG_NO_ROW) {
    return counted;
  }
  if (k >= 0 && place != SIZE_MAX && !handle->by_id[k].failed &&
      !handle->by_id[k].of) {
    handle->by_id[k].failed = !fill_table(handle, relation, &handle->by_id[k]);
  }
  if (k < 0 || place == SIZE_MAX || handle->by_id[k].failed) {
    return sg_version_find(handle->version, relation, key);
  }
  uint32_t row = sg_id_rows_find(&handle->by_id[k].of[place], id);

  return row == SG_NO_ID_ROW ? SG_NO_ROW : row;
}

/* ---- edges of several polygons ---- */

/* Notes the edges of a polygon in *seen, a bit an edge. 1: one was there
 * before; 0; -1: no memory. */
static int
see_edges(const int32_t *list, uint8_t **seen, size_t *room)
{
  for (int32_t i = 1; i <= list[0]; i++) {
    size_t at = (size_t)list[i] / 8;
    uint8_t bit = (uint8_t)(1 << list[i] % 8);

    if (!sg_list_need_zeroed(seen, at + 1, room, sizeof **seen)) {
      return -1;
    }
    if ((*seen)[at] & bit) {
      return 1;
    }
    (*seen)[at] |= bit;
  }
  return 0;
}

/* Without memory: they may. */
static bool
find_sharing(const sg_cut_handle *handle, int32_t s)
{
  sg_view view;
  sg_segment_rows rows = {0};
  uint8_t *seen = NULL;
  size_t room = 0;
  int shares = 0;

  if (!sg_version_view(handle->version, SG_P, &view)) {
    return true;
  }
  if (!sg_segment_rows_find(&view, &s, 1, NULL, &rows)) {
    shares = -1;
  }
  for (size_t i = 0; shares == 0 && i < rows.begin[1]; i++) {
    shares =
        see_edges(sg_version_value(handle->version, SG_P, rows.row[i], 2).list,
                  &seen, &room);
  }
  free(seen);
  sg_segment_rows_clear(&rows);
  sg_view_clear(&view);
  return shares != 0;
}

bool
sg_cut_shares_edges(sg_cut_handle *handle, int32_t s)
{
  enum { UNKNOWN, ALONE, SHARED };
  size_t place = sg_cut_place_of(handle, s);

  if (place == SIZE_MAX) {
    return true;
  }
  if (handle->sharing[place] == UNKNOWN) {
    handle->sharing[place] = find_sharing(handle, s) ? SHARED : ALONE;
  }
  return handle->sharing[place] == SHARED;
}

/* ---- beside split edges ---- */

/* The edge between two vertices of the model that is split, or a piece runs
 * along; null: it is none. */
static const sg_split_edge *
find_edge(const sg_cut_set *set, uint32_t a, uint32_t b)
{
  uint32_t key[2] = {a < b ? a : b, a < b ? b : a};
  uint32_t number = sg_key_table_get(&set->edge_number, key);

  return number == SG_NO_KEY ? NULL : &set->edge[number];
}

/* Whether side k of a triangle changes its polygon: 1 if it is split, or a fold
 * along which a piece runs, since the polygon has no such edge yet; 0; -1: no
 * memory. */
static int
is_beside(sg_cut_handle *handle, uint32_t triangle, int k, bool late)
{
  const uint32_t *v = handle->set.model.triangle[triangle].v;
  const sg_split_edge *edge = find_edge(&handle->set, v[k], v[(k + 1) % 3]);

  if (!edge || (late && !edge->late)) {
    return 0;
  }
  if (edge->n > 0) {
    return 1;
  }
  int real = sg_cut_is_real(handle, triangle, k);

  return real < 0 ? -1 : !real;
}

bool
sg_cut_add_beside(sg_cut_handle *handle, bool late, const sg_cancel *cancel)
{
  sg_cut_set *set = &handle->set;
  const sg_cut_model *model = &set->model;

  for (size_t i = 0; i < model->triangles; i++) {
    const sg_leaf_triangle *t = &model->triangle[i];
    int beside = 0;

    if (sg_cancel_every(cancel, i)) {
      return false;
    }
    for (int k = 0; k < 3 && beside == 0; k++) {
      beside = is_beside(handle, (uint32_t)i, k, late);
    }
    if (beside < 0 ||
        (beside > 0 && !sg_cut_set_add_polygon(set, t->s, t->p))) {
      return false;
    }
  }
  return true;
}
