/* cut_enter_rows.c -- cut sets: the scratch relation of a polygon, and the
 * pieces of lines that enter it and meet nothing there.
 *
 * Layer: rows. The doors are documented in rules/kernel/penetration.pl.
 */
#include "cut_rows.h"

#include "doors/penetration.h"

#include <stdlib.h>
#include <string.h>

/* The name that a point has in segment s, of several the one that `work` has;
 * made if it has none. 0: an exception. */
static int32_t
name_in_work(sg_call *call, sg_cut_handle *handle, const sg_work *work,
             uint32_t point, int32_t s)
{
  return sg_cut_name(call, handle, point, s) == 0
             ? 0
             : sg_cut_points_good_name(&handle->set.points, point, s,
                                       sg_cut_is_in_work, work);
}

bool
sg_door_cut_enter_free(sg_call *call, sg_cut_handle *handle, int32_t s,
                       int32_t p, sg_work *work)
{
  sg_meetings met = {0};
  int entered = sg_cut_enter_free(&handle->set, work, s, p, &met);

  sg_meetings_clear(&met);
  return entered < 0 ? sg_call_no_memory(call) : entered;
}

/* ---- the scratch relation of one polygon ---- */

int32_t
sg_cut_enter_point(sg_call *call, sg_cut_handle *handle, sg_work *work,
                   uint32_t point, int32_t s)
{
  int32_t name = name_in_work(call, handle, work, point, s);
  int32_t vertex =
      name ? sg_work_vertex(work, name, &handle->set.points.point[point].at)
           : SG_WORK_NONE;

  if (name && vertex == SG_WORK_NONE) {
    sg_call_no_memory(call);
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

static bool
add_edge(sg_call *call, const sg_cut_handle *handle, sg_row row,
         sg_outlines *out)
{
  int32_t cell[5];

  for (unsigned c = 1; c < 5; c++) {
    cell[c] = sg_version_value(handle->version, SG_E, row, c).i;
  }
  return sg_outlines_add_edge(
             out, &(sg_outline_edge){cell[1], cell[2], cell[3], cell[4]}) ||
         sg_call_no_memory(call);
}

bool
sg_cut_outline(sg_call *call, sg_cut_handle *handle, int32_t s, int32_t p,
               sg_outlines *out)
{
  sg_row polygon = sg_cut_row_of(handle, SG_P, s, p);
  double normal[3];

  if (polygon == SG_NO_ROW) {
    return sg_call_missing_id(call, "polygon", p);
  }
  get_normal(handle, s, p, normal);
  if (!sg_outlines_add(out, s, p, normal)) {
    return sg_call_no_memory(call);
  }
  const int32_t *list =
      sg_version_value(handle->version, SG_P, polygon, 2).list;

  for (int32_t i = 0; i < list[0]; i++) {
    sg_row row = sg_cut_row_of(handle, SG_E, s, list[i + 1]);

    if (row != SG_NO_ROW && !add_edge(call, handle, row, out)) {
      return false;
    }
  }
  return list[0] <= 3 || sg_cut_add_folds(call, handle, s, p, out);
}

/* Names all points that a polygon has. Mostly they have names. */
static bool
name_points(sg_call *call, sg_cut_handle *handle, const sg_outline *polygon,
            const sg_outline_edge *edge)
{
  const sg_cut_set *set = &handle->set;
  const sg_cut_polygon *cut = sg_cut_set_polygon(set, polygon->s, polygon->p);
  bool good = true;

  for (size_t k = 0; k < polygon->n && good; k++) {
    const sg_split_edge *split =
        sg_cut_split_edge(set, polygon->s, edge[k].v1, edge[k].v2);

    for (size_t i = 0; split && i < split->n && good; i++) {
      good = sg_cut_name(call, handle, split->point[i], polygon->s) != 0;
    }
  }
  for (size_t i = 0; cut && i < cut->n && good; i++) {
    const sg_cut_piece *piece = &set->piece[set->entering[cut->first + i]];

    good = sg_cut_name(call, handle, piece->a, polygon->s) != 0 &&
           sg_cut_name(call, handle, piece->b, polygon->s) != 0;
  }
  return good;
}

/* Fills an open work with the last outline. */
static bool
fill_work(sg_call *call, sg_cut_handle *handle, const sg_outlines *all,
          sg_work *work)
{
  const sg_outline *polygon = &all->polygon[all->n - 1];
  sg_outcome outcome =
      sg_cut_enter_outline(&handle->set, all, all->n - 1, work);

  if (outcome == SG_STUCK) {
    if (!name_points(call, handle, polygon, all->edge + polygon->first)) {
      return false;
    }
    sg_work_clear(work, polygon->normal);
    outcome = sg_cut_enter_outline(&handle->set, all, all->n - 1, work);
  }
  return outcome == SG_DONE    ? true
         : outcome == SG_STUCK ? sg_call_cannot_hold(call, "vertex")
                               : sg_call_no_memory(call);
}

/* The scratch relation of polygon p; null: an exception. */
static sg_work *
open_work(sg_call *call, sg_cut_handle *handle, int32_t s, int32_t p)
{
  sg_outlines one = {0};
  sg_work *work = NULL;

  if (sg_cut_outline(call, handle, s, p, &one)) {
    work = sg_work_open(one.polygon->normal);
    if (!work) {
      sg_call_no_memory(call);
    } else if (!fill_work(call, handle, &one, work)) {
      sg_work_close(work);
      work = NULL;
    }
  }
  sg_outlines_clear(&one);
  return work;
}

bool
sg_door_cut_work(sg_call *call, sg_cut_handle *handle, int32_t s, int32_t p,
                 sg_work **work)
{
  *work = open_work(call, handle, s, p);
  return *work != NULL;
}

/* ---- many polygons ---- */

enum { ASKED = 64 }; /* polygons between questions */

bool
sg_door_cut_queue(sg_call *call, sg_cut_handle *handle,
                  const sg_segment_polygon_list *polygons)
{
  size_t bytes = polygons->n * sizeof *polygons->at;

  free(handle->queue);
  handle->queue = malloc(bytes + 1);
  handle->queued = handle->entered = 0;
  if (!handle->queue) {
    return sg_call_no_memory(call);
  }
  if (bytes > 0) {
    memcpy(handle->queue, polygons->at, bytes);
  }
  handle->queued = polygons->n;
  return true;
}

/* The work of a polygon that is free. False, *out null: it is not, or refused.
 */
static bool
enter_polygon(sg_call *call, sg_cut_handle *handle,
              const sg_segment_polygon *polygon, sg_meetings *met,
              sg_work **out)
{
  *out = open_work(call, handle, polygon->s, polygon->p);
  int entered =
      *out ? sg_cut_enter_free(&handle->set, *out, polygon->s, polygon->p, met)
           : 0;

  if (entered > 0) {
    return true;
  }
  sg_work_close(*out);
  *out = NULL;
  return entered < 0 && sg_call_no_memory(call);
}

bool
sg_door_cut_enter_queued(sg_call *call, sg_cut_handle *handle,
                         sg_work_list *works)
{
  sg_meetings met = {0};
  bool good = true;
  sg_work *work = NULL;

  while (good && handle->entered < handle->queued) {
    const sg_segment_polygon *polygon = &handle->queue[handle->entered++];

    if (!enter_polygon(call, handle, polygon, &met, &work)) {
      good = call->refusal.how == SG_REFUSED_NOTHING;
      break;
    }
    good = sg_work_list_add(call, works, work);
    if (!good) {
      sg_work_close(work);
    } else if (works->n % ASKED == 0) {
      good = !sg_cancelled(&call->cancel);
    }
  }
  for (size_t i = 0; !good && i < works->n; i++) {
    sg_work_close(works->at[i]);
  }
  sg_meetings_clear(&met);
  return good;
}
