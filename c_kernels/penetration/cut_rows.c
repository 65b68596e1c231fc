/* cut_rows.c -- cut sets: finding the cuts of leaf triangles.
 *
 * Layer: rows. The doors are documented in rules/kernel/penetration.pl.
 */
#include "cut_rows.h"

#include "doors/penetration.h"

#include <stdlib.h>

enum { ASKED = 1 << 12 }; /* candidates between questions */

/* ---- the handle ---- */

void
sg_cut_set_keep(sg_cut_handle *handle)
{
  atomic_fetch_add(&handle->holders, 1);
}

void
sg_cut_set_let_go(sg_cut_handle *handle)
{
  if (atomic_fetch_sub(&handle->holders, 1) > 1) {
    return;
  }
  sg_cut_set_clear(&handle->set);
  sg_key_table_clear(&handle->next_name);
  sg_key_table_clear(&handle->line_of);
  sg_key_table_clear(&handle->edge_type);
  sg_key_table_clear(&handle->edges_read);
  sg_key_table_clear(&handle->bent);
  free(handle->real);
  free(handle->queue);
  sg_cut_rows_clear(handle);
  sg_cut_open_clear(handle);
  sg_version_drop(handle->version);
  sg_world_let_go(handle->world);
  free(handle);
}

bool
sg_door_cut_set_open(sg_call *call, const sg_id_pair_list *pairs,
                     sg_cut_handle **set)
{
  sg_world *world = sg_call_world(call);
  sg_cut_handle *handle = world ? calloc(1, sizeof *handle) : NULL;

  if (!handle) {
    return world ? sg_call_no_memory(call) : false;
  }
  atomic_init(&handle->holders, 1);
  handle->world = sg_world_keep(world);
  handle->version = sg_world_version(world);
  sg_cut_set_init(&handle->set, sg_cut_is_real_or_fold, handle);
  sg_key_table_init(&handle->next_name, 1);
  sg_key_table_init(&handle->line_of, 3);
  sg_key_table_init(&handle->edge_type, 4);
  sg_key_table_init(&handle->edges_read, 2);
  sg_key_table_init(&handle->bent, 2);
  if (!sg_cut_open(call, handle, pairs)) {
    sg_cut_set_let_go(handle);
    return false;
  }
  *set = handle;
  return true;
}

/* ---- candidates ---- */

bool
sg_door_cut_candidate(sg_call *call, sg_cut_handle *handle,
                      sg_cut_candidate_rows *rows)
{
  if (!sg_cut_join(call, handle)) {
    return false;
  }
  for (size_t i = 0; i < handle->curve_candidates; i++) {
    const uint32_t *pair = handle->candidate[i];

    if (!sg_cut_candidate_rows_add(call, rows,
                                   (sg_cut_candidate_row){pair[0], pair[1]})) {
      return false;
    }
  }
  return true;
}

bool
sg_door_curve_candidate(sg_call *call, sg_cut_handle *handle,
                        sg_curve_candidate_rows *rows)
{
  if (!sg_cut_join(call, handle)) {
    return false;
  }
  for (size_t i = handle->curve_candidates; i < handle->candidates; i++) {
    const uint32_t *pair = handle->candidate[i];

    if (!sg_curve_candidate_rows_add(
            call, rows, (sg_curve_candidate_row){pair[0], pair[1]})) {
      return false;
    }
  }
  return true;
}

/* ---- one pair ---- */

static bool
has_triangle(sg_call *call, const sg_cut_handle *handle, size_t t, int argument)
{
  return t < handle->set.model.triangles ||
         sg_call_missing(call, "cut_triangle", argument);
}

static bool
has_triangles(sg_call *call, const sg_cut_handle *handle, size_t t1, size_t t2)
{
  return has_triangle(call, handle, t1, 2) && has_triangle(call, handle, t2, 3);
}

bool
sg_door_cut_side(sg_call *call, sg_cut_handle *handle, size_t t1, size_t t2,
                 int32_t *side)
{
  double a[3][3], b[3][3];

  if (!has_triangles(call, handle, t1, t2)) {
    return false;
  }
  sg_cut_model_corners(&handle->set.model, (uint32_t)t1, a);
  sg_cut_model_corners(&handle->set.model, (uint32_t)t2, b);
  *side = sg_cut_side((const double(*)[3])a, (const double(*)[3])b);
  return true;
}

bool
sg_door_cut_enter(sg_call *call, sg_cut_handle *handle, size_t t1, size_t t2,
                  int32_t *count)
{
  if (!has_triangles(call, handle, t1, t2)) {
    return false;
  }
  *count = sg_cut_set_enter(&handle->set, (uint32_t)t1, (uint32_t)t2);
  return *count >= 0 || sg_call_no_memory(call);
}

bool
sg_door_cut_without_coincident(sg_call *call, sg_cut_handle *handle)
{
  (void)call;
  handle->without_quiet = true;
  return true;
}

bool
sg_door_cut_few_sheets(sg_call *call, sg_cut_handle *handle)
{
  (void)call;
  handle->few = true;
  return true;
}

/* The join as a whole: what the rule find_cuts_by_rule/1 does pair by pair. */
bool
sg_door_cut_find(sg_call *call, sg_cut_handle *handle)
{
  if (!sg_cut_join(call, handle) ||
      (handle->without_quiet && !sg_cut_quiet(call, handle))) {
    return false;
  }
  for (size_t k = 0; k < handle->curve_candidates; k++) {
    const uint32_t *pair = handle->candidate[k];

    if (!handle->apart[k] && (!handle->without_quiet || !handle->quiet[k]) &&
        sg_cut_set_enter(&handle->set, pair[0], pair[1]) < 0) {
      return sg_call_no_memory(call);
    }
    if (k % ASKED == ASKED - 1 && sg_cancelled(&call->cancel)) {
      return false;
    }
  }
  return true;
}

bool
sg_door_curve_enter(sg_call *call, sg_cut_handle *handle, size_t e, size_t t,
                    int32_t *count)
{
  if (e >= handle->set.model.edges) {
    return sg_call_missing(call, "cut_edge", 2);
  }
  if (!has_triangle(call, handle, t, 3)) {
    return false;
  }
  *count = sg_cut_set_enter_curve(&handle->set, (uint32_t)e, (uint32_t)t);
  return *count >= 0 || sg_call_no_memory(call);
}

bool
sg_door_cut_triangle(sg_call *call, sg_cut_handle *handle, size_t t, int32_t *s,
                     int32_t *p, int32_t *id)
{
  if (!has_triangle(call, handle, t, 2)) {
    return false;
  }
  const sg_leaf_triangle *leaf = &handle->set.model.triangle[t];

  *s = leaf->s;
  *p = leaf->p;
  *id = leaf->t;
  return true;
}

static sg_cut_place
give_place(const sg_cut_model *model, const sg_place *place)
{
  sg_cut_place out = {0};

  switch (place->kind) {
  case SG_AT_VERTEX:
    out.is = SG_CUT_PLACE_VERTEX;
    out.vertex.v = model->vertex[place->a].v;
    break;
  case SG_ON_EDGE:
    out.is = SG_CUT_PLACE_EDGE;
    out.edge.v1 = model->vertex[place->a].v;
    out.edge.v2 = model->vertex[place->b].v;
    break;
  case SG_ON_FACE:
    out.is = SG_CUT_PLACE_FACE;
    out.face.t = model->triangle[place->a].t;
    break;
  }
  return out;
}

static sg_cut_end_places
give_end(const sg_cut_model *model, const uint32_t pair[2],
         const sg_cut_end *end)
{
  sg_place first = sg_place_of(model, pair[0], (int)end->f[0]);
  sg_place second = sg_place_of(model, pair[1], (int)end->f[1]);

  return (sg_cut_end_places){give_place(model, &first),
                             give_place(model, &second)};
}

bool
sg_door_cut_ends(sg_call *call, sg_cut_handle *handle, size_t t1, size_t t2,
                 sg_triangle_cut_list *cuts)
{
  const sg_cut_model *model = &handle->set.model;
  uint32_t t[2] = {(uint32_t)t1, (uint32_t)t2};
  double a[3][3], b[3][3];
  sg_cut cut[SG_CUT_MAX];
  int n;

  if (!has_triangles(call, handle, t1, t2)) {
    return false;
  }
  sg_cut_model_corners(model, t[0], a);
  sg_cut_model_corners(model, t[1], b);
  sg_cut_kind kind =
      sg_cut_triangles((const double(*)[3])a, (const double(*)[3])b, cut, &n);

  for (int i = 0; i < n; i++) {
    const sg_triangle_cut one = {kind, give_end(model, t, &cut[i].end[0]),
                                 give_end(model, t, &cut[i].end[1])};

    if (!sg_triangle_cut_list_add(call, cuts, one)) {
      return false;
    }
  }
  return true;
}
