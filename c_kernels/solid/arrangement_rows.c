/* arrangement_rows.c -- see arrangement_rows.h: opening, filling, sealing. */
#include "arrangement_rows.h"

#include "doors/boolean.h"
#include "doors/penetration.h"

#include <stdlib.h>
#include <string.h>

/* ---- closing ---- */

/* What only sealing needs, or who looks into the pieces. */
static void
close_rows(sg_arrangement_handle *h)
{
  sg_arrangement_close(h->arrangement);
  h->arrangement = NULL;
  for (size_t i = 0; h->tree && i < h->n; i++) {
    if (h->tree[i]) {
      sg_kept_tree_drop(h->tree[i]);
    }
  }
  if (h->set) {
    sg_cut_set_let_go(h->set);
  }
  if (h->version) {
    sg_leaf_views_clear(&h->views);
    sg_version_drop(h->version);
    sg_world_let_go(h->world);
  }
  free(h->tree);
  free(h->own);
  free(h->nonmanifold);
  free(h->s);
  free(h->wanted);
  free(h->surface);
  free(h->weight);
  free(h->origin_at);
  free(h->origin);
}

void
sg_arrangement_handle_free(sg_arrangement_handle *h)
{
  if (h) {
    if (h->arrangement) {
      close_rows(h);
    }
    free(h);
  }
}

/* The first argument is it. */
static bool
is_open(sg_call *call, const sg_arrangement_handle *h)
{
  return h->arrangement || sg_call_missing(call, "arrangement", 1);
}

static bool
is_unsealed(sg_call *call, const sg_arrangement_handle *h)
{
  return is_open(call, h) &&
         (!h->sealing || sg_call_forbidden(call, "fill", "arrangement", 1));
}

bool
sg_door_arrangement_hold(sg_call *call, sg_arrangement_handle *h)
{
  if (!is_open(call, h)) {
    return false;
  }
  atomic_fetch_add(&h->holders, 1);
  return true;
}

bool
sg_door_arrangement_drop(sg_call *call, sg_arrangement_handle *h)
{
  if (!is_open(call, h)) {
    return false;
  }
  if (atomic_fetch_sub(&h->holders, 1) == 1) {
    close_rows(h);
  }
  return true;
}

/* ---- opening ---- */

/* Room for n items, and one, zeroed; null: refused. */
static void *
room_for(sg_call *call, size_t n, size_t size)
{
  void *room = calloc(n + 1, size);

  if (!room) {
    sg_call_no_memory(call);
  }
  return room;
}

static bool
take_leaves(sg_call *call, const sg_int_list *segments,
            const sg_int_list *wanted, sg_arrangement_handle *h)
{
  h->n = segments->n;
  h->s = room_for(call, h->n, sizeof *h->s);
  h->wanted = room_for(call, h->n, sizeof *h->wanted);
  if (!h->s || !h->wanted) {
    return false;
  }
  if (h->n > 0) {
    memcpy(h->s, segments->at, h->n * sizeof *h->s);
  }
  for (size_t i = 0, k = 0; i < wanted->n; i++) {
    while (k < h->n && h->s[k] < wanted->at[i]) {
      k++;
    }
    if (k == h->n || h->s[k] != wanted->at[i]) {
      return sg_call_domain(call, "segments", 3);
    }
    h->wanted[k] = true;
  }
  return true;
}

static bool
take_weights(sg_call *call, const sg_arrangement_weight_list *weights,
             sg_arrangement_handle *h)
{
  h->weight = room_for(call, weights->n, sizeof *h->weight);
  for (size_t i = 0; h->weight && i < weights->n; i++) {
    h->weight[i] = weights->at[i];
  }
  return h->weight != NULL;
}

/* Which leaves are surfaces, by segment/3. */
static bool
find_surfaces(sg_call *call, sg_arrangement_handle *h)
{
  const sg_version *version = h->set->version;

  h->surface = room_for(call, h->n, sizeof *h->surface);
  for (size_t i = 0; h->surface && i < h->n; i++) {
    sg_value key[SG_MAX_COLUMNS] = {[0].i = h->s[i]};
    sg_row row = sg_version_find(version, SG_SEGMENT, key);

    h->surface[i] =
        row != SG_NO_ROW &&
        sg_version_value(version, SG_SEGMENT, row, 1).i == SG_SYMBOL_SURFACE;
  }
  return h->surface != NULL;
}

static bool
hold_trees(sg_call *call, sg_arrangement_handle *h)
{
  const sg_version *version = h->set->version;

  h->own = room_for(call, h->n, sizeof(sg_leaf_tree *));
  h->nonmanifold = room_for(call, h->n, sizeof(sg_nonmanifold *));
  h->tree = room_for(call, h->n, sizeof(sg_kept_tree *));
  bool good = h->tree && h->own && h->nonmanifold &&
              sg_trees_hold(call, version, &h->set->views, h->s, h->n, h->tree);

  for (size_t i = 0; good && i < h->n; i++) {
    h->own[i] = h->tree[i]->tree;
    good = !h->wanted[i] ||
           sg_kept_nonmanifold(call, h->tree[i], version, &h->set->views,
                               &h->nonmanifold[i]);
  }
  return good;
}

static atomic_uint_fast64_t opened; /* arrangements, ever */

static bool
open_rows(sg_call *call, size_t weights, sg_arrangement_handle *h)
{
  h->arrangement =
      sg_arrangement_open(&(sg_leaves){.set = &h->set->set,
                                       .views = &h->set->views,
                                       .s = h->s,
                                       .tree = h->own,
                                       .wanted = h->wanted,
                                       .surface = h->surface,
                                       .n = h->n,
                                       .nonmanifold = h->nonmanifold,
                                       .weight = h->weight,
                                       .weights = weights},
                          &call->cancel);
  h->number = atomic_fetch_add(&opened, 1);
  atomic_init(&h->holders, 1);
  return h->arrangement || sg_call_ended(call);
}

bool
sg_door_arrangement_open(sg_call *call, sg_cut_handle *set,
                         const sg_int_list *segments, const sg_int_list *wanted,
                         const sg_arrangement_weight_list *weights,
                         sg_arrangement_handle **out)
{
  sg_arrangement_handle *h = room_for(call, 0, sizeof *h);

  if (!h) {
    return false;
  }
  sg_cut_set_keep(set);
  h->set = set;
  if (!take_leaves(call, segments, wanted, h) ||
      !take_weights(call, weights, h) || !find_surfaces(call, h) ||
      !hold_trees(call, h) || !open_rows(call, weights->n, h)) {
    close_rows(h);
    free(h);
    return false;
  }
  *out = h;
  return true;
}

/* ---- filling ---- */

/* geometry_error(polygon_edge(S, P, V1, V2)) */
static bool
refuse_stuck(sg_call *call, const sg_entered *polygon, int32_t e)
{
  const sg_work_edge *edge = sg_work_get(polygon->work, e);
  const int32_t at[4] = {polygon->s, polygon->p,
                         edge ? sg_work_id(polygon->work, edge->start) : 0,
                         edge ? sg_work_id(polygon->work, edge->end) : 0};

  return sg_call_geometry(call, "polygon_edge", at, 4);
}

bool
sg_door_arrangement_polygons(sg_call *call, sg_arrangement_handle *h,
                             const sg_entered_polygon_list *works, double reach)
{
  sg_pool *pool;
  size_t stuck = 0;
  int32_t edge = 0;

  if (!is_unsealed(call, h) || !(pool = sg_call_pool(call))) {
    return false;
  }
  sg_outcome outcome =
      sg_arrangement_polygons(h->arrangement, works->at, works->n, reach, pool,
                              &call->cancel, &stuck, &edge);

  return outcome == SG_DONE    ? true
         : outcome == SG_STUCK ? refuse_stuck(call, &works->at[stuck], edge)
                               : sg_call_ended(call);
}

bool
sg_door_arrangement_free_polygons(sg_call *call, sg_arrangement_handle *h,
                                  const sg_segment_polygon_list *polygons,
                                  double reach)
{
  sg_outlines outlines = {0};
  bool good = is_unsealed(call, h);

  for (size_t i = 0; good && i < polygons->n; i++) {
    const sg_segment_polygon *one = &polygons->at[i];

    good = !sg_cancel_every(&call->cancel, i) &&
           sg_cut_outline(call, h->set, one->s, one->p, &outlines);
  }
  sg_pool *pool = good ? sg_call_pool(call) : NULL;
  sg_outcome outcome =
      pool ? sg_arrangement_free_polygons(h->arrangement, &outlines, reach,
                                          pool, &call->cancel)
           : SG_STUCK;

  sg_outlines_clear(&outlines);
  return outcome == SG_DONE || (outcome != SG_STUCK && sg_call_ended(call));
}

/* ---- sealing: pieces are kept for long ---- */

/* The rows of the wanted leaves, and of nothing else. Null: refused. */
static const sg_version *
own_rows(sg_call *call, const sg_arrangement_handle *h)
{
  uint64_t relations = UINT64_C(1) << SG_V | UINT64_C(1) << SG_T;
  sg_int_list s = {0};

  for (size_t i = 0; i < h->n; i++) {
    if (h->wanted[i] && !sg_int_list_add(call, &s, h->s[i])) {
      return NULL;
    }
    relations |= (uint64_t)(h->wanted[i] && h->own[i]->curve) << SG_E;
  }
  const sg_version *own =
      sg_version_narrow(h->set->version, relations, s.at, s.n);

  if (!own) {
    sg_call_no_memory(call);
  }
  return own;
}

/* Lets go of the cut set, of the trees of leaves that are not wanted, and of
 * all rows but those of the others. */
static bool
compact(sg_call *call, sg_arrangement_handle *h)
{
  const sg_version *own = own_rows(call, h);

  if (!own) {
    return false;
  }
  if (!sg_leaf_views_open(call, own, &h->views)) {
    sg_leaf_views_clear(&h->views);
    sg_version_drop(own);
    return false;
  }
  h->version = own;
  h->world = sg_world_keep(h->set->world);
  sg_arrangement_compact(h->arrangement, &h->views);
  sg_cut_set_let_go(h->set);
  h->set = NULL;
  for (size_t i = 0; i < h->n; i++) {
    if (!h->wanted[i]) {
      sg_kept_tree_drop(h->tree[i]);
      h->tree[i] = NULL;
    }
  }
  return true;
}

bool
sg_door_arrangement_seal(sg_call *call, sg_arrangement_handle *h)
{
  sg_pool *pool;

  if (!is_unsealed(call, h) || !(pool = sg_call_pool(call))) {
    return false;
  }
  h->sealing = true; /* if that fails it is half done, and good for nothing */
  return (sg_arrangement_seal(h->arrangement, pool, &call->cancel) ||
          sg_call_ended(call)) &&
         sg_arrangement_make_origins(call, h) && compact(call, h);
}
