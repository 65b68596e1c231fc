/* split_rows.c -- cut sets: where pieces cross while they enter, and what is
 * divided by that.
 *
 * Layer: rows. The doors are documented in rules/kernel/penetration.pl.
 */
#include "cut_rows.h"

#include "doors/penetration.h"
#include "polygon/work_rows.h"

/* ---- crossings ---- */

/* Whether a point lies inside both segments (of work handles). */
static bool
is_inside_both(sg_work *work, int32_t x, const int32_t a[2], const int32_t b[2])
{
  return x != SG_WORK_NONE && sg_work_between(work, a[0], a[1], x) &&
         sg_work_between(work, b[0], b[1], x);
}

/* The point in which the work's two segments cross, in its own plane. */
static uint32_t
cross_in_work(sg_cut_handle *handle, sg_work *work, const int32_t a[2],
              const int32_t b[2])
{
  sg_made none = {0};
  sg_point at;

  if (!sg_point_ll(&at, sg_work_axis(work), sg_work_point(work, a[0]),
                   sg_work_point(work, a[1]), sg_work_point(work, b[0]),
                   sg_work_point(work, b[1]))) {
    return SG_NO_KEY;
  }
  uint32_t point = sg_cut_points_at(&handle->set.points, &at, &none);

  sg_point_clear(&at);
  return point;
}

/* Where the triangles that carry piece k and the edge's own piece meet, if the
 * edge is one. */
static uint32_t
cross_by_carriers(sg_cut_handle *handle, int32_t k, const sg_work_edge *edge)
{
  const sg_cut_set *set = &handle->set;
  int64_t l = -edge->label - 1;

  if (l < 0 || (size_t)l >= set->pieces) {
    return SG_NO_KEY;
  }
  sg_made made = sg_cut_set_crossing(set, &set->piece[k], &set->piece[l]);

  return sg_cut_points_find(&handle->set.points, &made);
}

/* The point in which piece k, from a[0] to a[1], crosses an edge of the work:
 * by what carries them if that point is on both, else as the work sees it.
 * SG_WORK_NONE: an exception. */
static int32_t
cross(sg_call *call, sg_cut_handle *handle, sg_work *work, int32_t s, int32_t k,
      const int32_t a[2], const sg_work_edge *edge)
{
  int32_t b[2] = {edge->start, edge->end}, x = SG_WORK_NONE;
  uint32_t point = cross_by_carriers(handle, k, edge);

  if (point != SG_NO_KEY) {
    x = sg_cut_enter_point(call, handle, work, point, s);
  }
  if (!is_inside_both(work, x, a, b)) {
    point = cross_in_work(handle, work, a, b);
    x = point == SG_NO_KEY ? SG_WORK_NONE
                           : sg_cut_enter_point(call, handle, work, point, s);
  }
  if (x == SG_WORK_NONE) {
    sg_call_no_memory(call);
  }
  return x;
}

bool
sg_door_cut_crossing(sg_call *call, sg_cut_handle *handle, sg_work *work,
                     int32_t s, int32_t k, int32_t e, int32_t v1, int32_t v2,
                     int32_t *out)
{
  int32_t a[2];

  if (!sg_work_known(call, work, v1, &a[0]) ||
      !sg_work_known(call, work, v2, &a[1])) {
    return false;
  }
  const sg_work_edge *crossed = sg_work_get(work, e);

  if (!crossed) {
    return sg_call_missing(call, "work_edge", 5);
  }
  if (k < 0 || (size_t)k >= handle->set.pieces) {
    return sg_call_missing(call, "cut_piece", 4);
  }
  sg_work_edge copy = *crossed; /* entering a vertex may move it */
  int32_t x = cross(call, handle, work, s, k, a, &copy);

  if (x == SG_WORK_NONE) {
    return false;
  }
  *out = sg_work_id(work, x);
  return true;
}

/* ---- splits found while entering ---- */

/* The point of a name; model vertices become points when they are asked for. */
static bool
get_point(sg_call *call, sg_cut_handle *handle, int32_t s, int32_t name,
          uint32_t *out)
{
  uint32_t point = sg_cut_points_named(&handle->set.points, s, name);
  uint32_t number = sg_cut_model_fetch(&handle->set.model, s, name);

  if (point == SG_NO_KEY && number != SG_NO_KEY) {
    sg_made made = {1, {{SG_AT_VERTEX, number, 0}}};
    point = sg_cut_points_find(&handle->set.points, &made);
  }
  *out = point;
  return point != SG_NO_KEY || sg_call_missing_id(call, "vertex", name);
}

bool
sg_door_cut_note(sg_call *call, sg_cut_handle *handle, int32_t s, int32_t v1,
                 int32_t v2, int32_t x)
{
  uint32_t a, b, middle;

  return get_point(call, handle, s, v1, &a) &&
         get_point(call, handle, s, v2, &b) &&
         get_point(call, handle, s, x, &middle) &&
         (sg_cut_set_split(&handle->set, a, b, middle) ||
          sg_call_no_memory(call));
}

/* A point of the set in a work: its name there. */
static bool
give_point(sg_call *call, sg_cut_handle *handle, sg_work *work, uint32_t point,
           int32_t s, int32_t *out)
{
  int32_t x = sg_cut_enter_point(call, handle, work, point, s);

  if (x == SG_WORK_NONE) {
    return false;
  }
  *out = sg_work_id(work, x);
  return true;
}

bool
sg_door_cut_between(sg_call *call, sg_cut_handle *handle, sg_work *work,
                    int32_t s, int32_t v1, int32_t v2, int32_t *x)
{
  uint32_t a, b;

  if (!get_point(call, handle, s, v1, &a) ||
      !get_point(call, handle, s, v2, &b)) {
    return false;
  }
  uint32_t middle = sg_cut_set_between(&handle->set, a, b);

  return middle != SG_NO_KEY && give_point(call, handle, work, middle, s, x);
}

/* The point of an edge's end, SG_NO_KEY: it is none. */
static uint32_t
end_of(const sg_cut_handle *handle, const sg_work *work, int32_t s,
       int32_t vertex)
{
  return sg_cut_points_named(&handle->set.points, s, sg_work_id(work, vertex));
}

bool
sg_door_cut_divided(sg_call *call, sg_cut_handle *handle, sg_work *work,
                    int32_t s, sg_id_pair_list *divided)
{
  if (handle->set.late.n == 0) { /* mostly nothing was divided anywhere */
    return true;
  }
  for (int32_t e = sg_work_next(work, 0); e; e = sg_work_next(work, e)) {
    const sg_work_edge *edge = sg_work_get(work, e);
    uint32_t a = end_of(handle, work, s, edge->start);
    uint32_t b = end_of(handle, work, s, edge->end);
    uint32_t middle = a == SG_NO_KEY || b == SG_NO_KEY
                          ? SG_NO_KEY
                          : sg_cut_set_between(&handle->set, a, b);
    sg_id_pair one = {.a = e};

    if (middle != SG_NO_KEY &&
        (!give_point(call, handle, work, middle, s, &one.b) ||
         !sg_id_pair_list_add(call, divided, one))) {
      return false;
    }
  }
  return true;
}
