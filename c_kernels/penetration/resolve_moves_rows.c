/* resolve_moves_rows.c -- how far things move that are made to touch: see
 * resolve_rows.h.
 *
 * Layer: rows.
 */
#include "resolve_rows.h"

#include "doors/penetration.h"

#include <stdlib.h>

/* Of an sg_resolve_trees. */
static const sg_leaf_tree *
tree_of(const void *data, int32_t s, bool *itself)
{
  const sg_resolving *job = data;
  const sg_cut_handle *handle = job->handle;
  *itself = false;
  for (size_t i = 0; i < job->part.n; i++) {
    *itself = *itself || job->part.item[i].s == s;
  }
  return handle->tree[sg_cut_place_of(handle, s)]->tree;
}

bool
sg_resolving_measure(sg_call *call, sg_resolving *job)
{
  const sg_cut_handle *handle = job->handle;
  const sg_resolve_trees trees = {handle->segment, handle->segments, tree_of,
                                  job};
  sg_pool *pool = sg_call_pool(call);

  return pool && (sg_resolve_measure(&job->r, &trees, &handle->views, pool,
                                     &call->cancel, &job->moves) ||
                  sg_call_ended(call));
}

/* The first two segments that have the point; the second is 0 if there is no
 * other. */
static void
segments_at(const sg_resolve *r, uint32_t point, int32_t out[2])
{
  out[0] = out[1] = 0;
  for (size_t i = 0; i < r->place.n && out[1] == 0; i++) {
    if (r->place.item[i].point == point && r->place.item[i].s != out[0]) {
      out[out[0] != 0] = r->place.item[i].s;
    }
  }
}

static void
give_move(const sg_resolving *job, int how, uint32_t point, double move,
          double feature, size_t n, sg_touch_moves *out)
{
  const double *at = job->r.point.item[point].at;
  int32_t s[2];

  segments_at(&job->r, point, s);
  out->is = SG_TOUCH_MOVES_MOVE;
  out->move = (sg_touch_move){how,  {s[0], s[1]}, {at[0], at[1], at[2]},
                              move, feature,      n};
}

void
sg_resolving_moves(const sg_resolving *job, sg_touch_moves *out)
{
  const sg_resolve_moves *moves = &job->moves;
  if (moves->tight > 0) {
    give_move(job, SG_MOVE_HOW_TIGHT, moves->tight_point, moves->move,
              moves->feature, moves->tight, out);
  } else if (moves->farthest > 0) {
    give_move(job, SG_MOVE_HOW_MOVED, moves->point, moves->farthest, 0,
              job->r.point.n, out);
  } else {
    out->is = SG_TOUCH_MOVES_LITTLE;
  }
}
