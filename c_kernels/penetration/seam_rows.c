/* seam_rows.c -- cut sets: putting the cuts into polygons, and what comes out.
 *
 * Layer: rows. The doors are documented in rules/kernel/penetration.pl.
 */
#include "cut_rows.h"

#include "doors/penetration.h"

#include <stdlib.h>

/* ---- names ---- */

int32_t
sg_cut_name(sg_call *call, sg_cut_handle *handle, uint32_t point, int32_t s)
{
  int32_t name = sg_cut_points_name(&handle->set.points, point, s);
  uint32_t key = (uint32_t)s;

  if (name != 0) {
    return name;
  }
  uint32_t *next = sg_key_table_put(&handle->next_name, &key);

  if (!next || *next == SG_NO_KEY ||
      !sg_cut_points_set_name(&handle->set.points, point, s, (int32_t)*next)) {
    sg_call_no_memory(call);
    return 0;
  }
  return (int32_t)(*next)++;
}

/* The smaller of two names, 0: none, if v is one of the point too. */
static int32_t
better_name(const sg_cut_set *set, uint32_t point, int32_t s, int32_t v,
            int32_t best)
{
  return (best == 0 || v < best) &&
                 sg_cut_points_named(&set->points, s, v) == point
             ? v
             : best;
}

/* Of a point with many names there are few in a polygon. */
int32_t
sg_cut_name_in(sg_cut_handle *handle, uint32_t point, int32_t s, int32_t p)
{
  const sg_version *version = handle->version;
  sg_row row = sg_cut_row_of(handle, SG_P, s, p);
  const int32_t *list =
      row == SG_NO_ROW ? NULL : sg_version_value(version, SG_P, row, 2).list;
  int32_t best = 0;

  for (int32_t i = 1; list && i <= list[0]; i++) {
    sg_row at = sg_cut_row_of(handle, SG_E, s, list[i]);

    for (unsigned end = 2; at != SG_NO_ROW && end < 4; end++) {
      best = better_name(&handle->set, point, s,
                         sg_version_value(version, SG_E, at, end).i, best);
    }
  }
  return best != 0 ? best : sg_cut_points_name(&handle->set.points, point, s);
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
static bool
name_all(sg_call *call, sg_cut_handle *handle)
{
  const sg_cut_set *set = &handle->set;

  for (int pass = 0; pass < 2; pass++) {
    for (size_t i = 0; i < set->pieces; i++) {
      const sg_cut_piece *piece = &set->piece[i];

      if (sg_cancel_every(&call->cancel, i)) {
        return false;
      }
      for (int k = 0; piece->live && k < 4; k++) {
        uint32_t end = k < 2 ? piece->a : piece->b;
        if (is_joint(set, end) == (pass == 1) &&
            !sg_cut_name(call, handle, end, piece->s[k % 2])) {
          return false;
        }
      }
    }
  }
  for (size_t i = 0; i < set->edges; i++) {
    if (sg_cancel_every(&call->cancel, i)) {
      return false;
    }
    for (size_t k = 0; k < set->edge[i].n; k++) {
      if (!sg_cut_name(call, handle, set->edge[i].point[k], set->edge[i].s)) {
        return false;
      }
    }
  }
  for (size_t i = 0; i < set->contacts; i++) {
    const sg_cut_contact *contact = &set->contact[i];

    if (sg_cancel_every(&call->cancel, i) ||
        !sg_cut_name(call, handle, contact->point, contact->s[0]) ||
        !sg_cut_name(call, handle, contact->point, contact->s[1])) {
      return false;
    }
  }
  return true;
}

/* ---- sealing ---- */

bool
sg_door_cut_seal(sg_call *call, sg_cut_handle *handle)
{
  return (sg_cut_set_seal(&handle->set, &call->cancel) &&
          sg_cut_set_link(&handle->set, &call->cancel)) ||
         sg_call_ended(call);
}

/* ---- the polygons ---- */

/* Lists the polygons and names the points, once. */
static bool
group(sg_call *call, sg_cut_handle *handle)
{
  if (handle->grouped) {
    return true;
  }
  handle->set.polygons = 0; /* what is left of a call that was stopped */
  handle->grouped = ((sg_cut_add_beside(handle, false, &call->cancel) &&
                      sg_cut_set_group(&handle->set, &call->cancel)) ||
                     sg_call_ended(call)) &&
                    name_all(call, handle);
  return handle->grouped;
}

static bool
list_polygons(sg_call *call, const sg_cut_polygon *polygon, size_t n,
              sg_segment_polygon_list *out)
{
  for (size_t i = 0; i < n; i++) {
    const sg_segment_polygon one = {polygon[i].s, polygon[i].p};

    if (!sg_segment_polygon_list_add(call, out, one)) {
      return false;
    }
  }
  return true;
}

bool
sg_door_cut_polygons(sg_call *call, sg_cut_handle *handle,
                     sg_segment_polygon_list *polygons)
{
  return group(call, handle) && list_polygons(call, handle->set.polygon,
                                              handle->set.polygons, polygons);
}

enum { PIECES_ASKED = 1 << 18 }; /* segments compared between questions */

static bool
is_among(const sg_int_list *s, int32_t one)
{
  for (size_t i = 0; i < s->n; i++) {
    if (s->at[i] == one) {
      return true;
    }
  }
  return false;
}

/* The polygons that carry a piece of one of these segments. False: no memory,
 * or stopped. */
static bool
note_carriers(const sg_cut_set *set, const sg_int_list *s,
              const sg_cancel *cancel, sg_key_table *out)
{
  size_t asked = PIECES_ASKED / (s->n + 1) + 1;

  for (size_t i = 0; i < set->pieces; i++) {
    const sg_cut_piece *piece = &set->piece[i];

    if (i % asked == 0 && sg_cancelled(cancel)) {
      return false;
    }
    if (!piece->live ||
        !(is_among(s, piece->s[0]) || is_among(s, piece->s[1]))) {
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

bool
sg_door_cut_polygons_of(sg_call *call, sg_cut_handle *handle,
                        const sg_int_list *segments,
                        sg_segment_polygon_list *polygons)
{
  sg_key_table carrier;

  if (!group(call, handle)) {
    return false;
  }
  sg_key_table_init(&carrier, 2);
  size_t asked = PIECES_ASKED / (segments->n + 1) + 1;
  bool good = note_carriers(&handle->set, segments, &call->cancel, &carrier) ||
              sg_call_ended(call);

  for (size_t i = 0; i < handle->set.polygons && good; i++) {
    const sg_cut_polygon *polygon = &handle->set.polygon[i];
    uint32_t key[2] = {(uint32_t)polygon->s, (uint32_t)polygon->p};

    if (i % asked == 0 && sg_cancelled(&call->cancel)) {
      good = false;
    } else if (is_among(segments, polygon->s) ||
               sg_key_table_get(&carrier, key) != SG_NO_KEY) {
      good = list_polygons(call, polygon, 1, polygons);
    }
  }
  sg_key_table_clear(&carrier);
  return good;
}

bool
sg_door_cut_entering(sg_call *call, sg_cut_handle *handle, int32_t s, int32_t p,
                     sg_entering_piece_list *pieces)
{
  const sg_cut_set *set = &handle->set;
  const sg_cut_polygon *polygon = sg_cut_set_polygon(set, s, p);

  for (size_t i = 0; polygon && i < polygon->n; i++) {
    uint32_t k = set->entering[polygon->first + i];
    const sg_cut_piece *piece = &set->piece[k];
    const sg_entering_piece one = {(int32_t)k,
                                   sg_cut_name_in(handle, piece->a, s, p),
                                   sg_cut_name_in(handle, piece->b, s, p)};

    if (!sg_entering_piece_list_add(call, pieces, one)) {
      return false;
    }
  }
  return true;
}

/* ---- what was found while entering ---- */

bool
sg_door_cut_agree(sg_call *call, sg_cut_handle *handle)
{
  return ((sg_cut_set_agree(&handle->set, &call->cancel) &&
           sg_cut_set_link(&handle->set, &call->cancel)) ||
          sg_call_ended(call)) &&
         name_all(call, handle);
}

bool
sg_door_cut_was_divided(sg_call *call, sg_cut_handle *handle)
{
  (void)call;
  return handle->set.late.n > 0;
}

bool
sg_door_cut_late_polygons(sg_call *call, sg_cut_handle *handle,
                          sg_segment_polygon_list *polygons)
{
  sg_cut_set *set = &handle->set;
  size_t listed = set->polygons;

  if (set->late.n == 0) { /* mostly nothing was divided anywhere */
    return true;
  }
  bool good =
      (sg_cut_add_beside(handle, true, &call->cancel) || sg_call_ended(call)) &&
      list_polygons(call, set->polygon + listed, set->polygons - listed,
                    polygons);

  set->polygons = listed;
  return good;
}
