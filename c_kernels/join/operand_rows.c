/* operand_rows.c -- what a Boolean asks of its operands.
 *
 * Layer: rows. Answers are kept with the tree of the segment (tree_rows.h).
 */
#include "doors/boolean.h"
#include "rows/grain_rows.h"
#include "self_leaf.h"
#include "tree_rows.h"

#include <stdlib.h>

/* Segments at hand. */
typedef struct asking {
  sg_call *call;
  const sg_version *version;
  sg_leaf_views views;
  size_t n;
  sg_kept_tree **tree; /* [n], held, or null */
} asking;

/* Close it in any case. */
static bool
open_asking(sg_call *call, const int32_t *s, size_t n, asking *a)
{
  *a = (asking){.call = call, .version = sg_call_version(call)};
  return a->version && sg_leaf_views_open(call, a->version, &a->views) &&
         (a->tree = sg_call_alloc(call, n * sizeof(sg_kept_tree *))) &&
         sg_trees_hold(call, a->version, &a->views, s, n, a->tree) &&
         (a->n = n, true);
}

static void
close_asking(asking *a)
{
  for (size_t i = 0; i < a->n; i++) {
    sg_kept_tree_drop(a->tree[i]);
  }
  sg_leaf_views_clear(&a->views);
}

/* ---- answers that are kept ------------------------------------------------
 */

/* What a kept tree is as an operand (operand_rows.c). It is kept if it is the
 * first; edges that change alone, without vertices and triangles, are rare. */
static bool
operand_of(sg_call *call, sg_kept_tree *kept, const sg_version *version,
           const sg_leaf_views *views, sg_operand *out)
{
  uint64_t stamp = sg_version_stamp(version, SG_E, kept->s);
  sg_kept_operand *there = atomic_load(&kept->operand), *fresh;

  if (there && there->stamp == stamp) {
    *out = there->operand;
    return true;
  }
  sg_pool *pool = sg_call_pool(call);

  if (!pool || !sg_operand_see(kept->tree, views, pool, &call->cancel, out)) {
    return sg_call_ended(call);
  }
  if (!there && (fresh = malloc(sizeof *fresh))) {
    *fresh = (sg_kept_operand){*out, stamp};
    if (!atomic_compare_exchange_strong(&kept->operand, &there, fresh)) {
      free(fresh); /* another thread was first */
    }
  }
  return true;
}

/* The non-manifold parts of a tree; none where it is seen to be one sheet.
 * Null: refused. */
static sg_nonmanifold *
make_nonmanifold(sg_call *call, sg_kept_tree *kept, const sg_version *version,
                 const sg_leaf_views *views)
{
  sg_nonmanifold *fresh = NULL;
  sg_operand operand;

  if (!operand_of(call, kept, version, views, &operand)) {
    return NULL;
  }
  if (!(fresh = calloc(1, sizeof *fresh)) ||
      (!operand.star &&
       !sg_nonmanifold_find(kept->tree, views, &call->cancel, fresh))) {
    sg_call_ended(call);
    if (fresh) {
      sg_nonmanifold_clear(fresh);
    }
    free(fresh);
    return NULL;
  }
  return fresh;
}

bool
sg_kept_nonmanifold(sg_call *call, sg_kept_tree *kept,
                    const sg_version *version, const sg_leaf_views *views,
                    const sg_nonmanifold **out)
{
  sg_nonmanifold *there = atomic_load(&kept->nonmanifold), *fresh;

  if (!there) {
    if (!(fresh = make_nonmanifold(call, kept, version, views))) {
      return false;
    }
    if (atomic_compare_exchange_strong(&kept->nonmanifold, &there, fresh)) {
      there = fresh;
    } else { /* another thread was first */
      sg_nonmanifold_clear(fresh);
      free(fresh);
    }
  }
  *out = there;
  return true;
}

/* Whether the i-th goes through itself. */
static bool
find_self(asking *a, size_t i, bool *out)
{
  sg_world *world = sg_version_world(a->version);
  sg_kept_tree *kept = a->tree[i];
  sg_self_known known = sg_self_known_of(world, kept);
  sg_operand operand;

  if (known == SG_SELF_NOT_ASKED) {
    if (!operand_of(a->call, kept, a->version, &a->views, &operand)) {
      return false;
    }
    *out = false;
    if (!operand.star) {
      double grain = sg_grain_of(a->version, kept->s);
      sg_pool *pool = sg_call_pool(a->call);

      if (!pool || !sg_self_leaf_meets(kept->tree, &a->views, grain, pool,
                                       &a->call->cancel, out)) {
        return sg_call_ended(a->call);
      }
    }
    known = *out ? SG_SELF_MEETS : SG_SELF_APART;
    sg_self_keep(world, kept, known);
  }
  *out = known == SG_SELF_MEETS;
  return true;
}

/* ---- doors --------------------------------------------------------------- */

bool
sg_door_segment_meets_itself(sg_call *call, int32_t s)
{
  asking a;
  bool meets = false;
  bool good = open_asking(call, &s, 1, &a) && find_self(&a, 0, &meets);

  close_asking(&a);
  return good && meets;
}

bool
sg_door_segments_meeting_themselves(sg_call *call, const sg_int_list *segments,
                                    sg_int_list *which)
{
  asking a;
  bool good = open_asking(call, segments->at, segments->n, &a);

  for (size_t i = 0; i < segments->n && good; i++) {
    bool meets = false;

    good = find_self(&a, i, &meets) &&
           (!meets || sg_int_list_add(call, which, segments->at[i]));
  }
  close_asking(&a);
  return good;
}

bool
sg_door_segment_operand(sg_call *call, int32_t s, sg_operand *operand)
{
  asking a;
  bool good = open_asking(call, &s, 1, &a) &&
              operand_of(call, a.tree[0], a.version, &a.views, operand);

  close_asking(&a);
  return good;
}

bool
sg_door_segment_edges(sg_call *call, int32_t s, int32_t most,
                      sg_operand_edges *counts, sg_operand_edge_list *edges)
{
  const sg_version *version = sg_call_version(call);
  sg_leaf_views views = {0};
  bool good = version && sg_leaf_views_open(call, version, &views) &&
              (sg_operand_edges_find(&views, s, most < 0 ? 0 : (size_t)most,
                                     &call->cancel, counts) ||
               sg_call_ended(call));

  sg_leaf_views_clear(&views);
  *edges = (sg_operand_edge_list){counts->first, counts->firsts, 0};
  return sg_call_adopt(call, counts->first) && good;
}
