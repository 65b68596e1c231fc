/* border_rows.c -- the edges of one segment that have no opposite.
 *
 * Layer: rows. What the census of the whole world says of it, at the cost of
 * the segment alone.
 */
#include "doors/world.h"
#include "engine/search.h"
#include "rows/dense_rows.h"
#include "rows/edge_pairs.h"

/* The edges of polygons: their ids, and the places of their vertices. */
typedef struct owned {
  size_t n;
  int32_t *id, *from, *to; /* [n] */
} owned;

static bool
find_owned(sg_call *call, const sg_dense *d, owned *out)
{
  size_t most = d->polygons > 0 ? d->list_begin[d->polygons] : 0;

  out->id = sg_call_alloc(call, most * sizeof *out->id);
  out->from = sg_call_alloc(call, most * sizeof *out->from);
  out->to = sg_call_alloc(call, most * sizeof *out->to);
  if (!out->id || !out->from || !out->to) {
    return false;
  }
  for (size_t i = 0; i < most; i++) {
    int32_t e = d->list[i];
    out->id[i] = d->edge_id[e];
    out->from[i] = d->from[e];
    out->to[i] = d->to[e];
  }
  out->n = most;
  return true;
}

/* Edges that no other one runs along. */
static bool
find_borders(sg_call *call, const sg_dense *d, sg_int_list *out)
{
  owned edges;
  sg_edge_pairs pairs = {0};
  sg_edge_group group = {0};
  bool stopped = false;

  if (!find_owned(call, d, &edges)) {
    return false;
  }
  bool good = sg_edge_pairs_make(edges.n, edges.from, edges.to, d->vertices,
                                 &call->cancel, &pairs, &stopped) ||
              sg_call_ended(call);
  while (good && sg_edge_group_next(&pairs, &group)) {
    good = group.end - group.begin > 1 ||
           sg_int_list_add(call, out,
                           edges.id[sg_edge_group_edge(&pairs, group.begin)]);
  }
  sg_edge_pairs_clear(&pairs);
  if (good && out->n > 0) {
    out->n = sg_sort_ids(out->at, out->n);
  }
  return good;
}

bool
sg_door_segment_borders(sg_call *call, int32_t s, sg_int_list *borders)
{
  sg_dense dense = {0};
  bool good =
      sg_dense_read(call, &s, 1, &dense) && find_borders(call, &dense, borders);

  sg_dense_clear(&dense);
  return good;
}
