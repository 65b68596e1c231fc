/* tree_rows.h -- the trees of segments, kept with their world.
 *
 * Layer: rows. A tree is kept until its segment's rows have changed, and the
 * next call wants the new ones. A version of another time has other stamps
 * (sg_version_stamp()), so it never sees a tree that is not its own; undo
 * brings back the stamps, and with them the tree if it is still there.
 */
#ifndef SG_TREE_ROWS_H
#define SG_TREE_ROWS_H

#include "call.h"
#include "leaf_tree.h"
#include "nonmanifold.h"
#include "operand.h"

#include <stdatomic.h>

enum { SG_TREE_STAMPS = 3 };

/* Whether a segment goes through itself (self_leaf.h), once that was asked.
 * Known for the last few contents of each segment: an operation may change it
 * for its own time, and another tree takes the place of its tree. */
typedef enum sg_self_known {
  SG_SELF_NOT_ASKED,
  SG_SELF_APART,
  SG_SELF_MEETS
} sg_self_known;

/* What was seen of it as an operand, under this stamp of e/5. */
typedef struct sg_kept_operand {
  sg_operand operand;
  uint64_t stamp;
} sg_kept_operand;

/* A tree and what it was made from: stamps of v/5, t/6 and e/5. */
typedef struct sg_kept_tree {
  atomic_size_t holders;
  int32_t s;
  uint64_t stamp[SG_TREE_STAMPS];
  sg_leaf_tree *tree;
  _Atomic(sg_kept_operand *) operand;    /* null: not asked yet */
  _Atomic(sg_nonmanifold *) nonmanifold; /* the same */
} sg_kept_tree;

/* The trees of n segments (ascending numbers) as `version` shows them, kept
 * ones and new ones; each out[i] is held and to be dropped. The views are of
 * the same version. False: nothing is held, each
 * out[i] is null. */
bool sg_trees_hold(sg_call *call, const sg_version *version,
                   const sg_leaf_views *views, const int32_t *s, size_t n,
                   sg_kept_tree **out);
void sg_kept_tree_drop(sg_kept_tree *kept);

sg_self_known sg_self_known_of(sg_world *world, const sg_kept_tree *kept);
/* Without memory it is not known. */
void sg_self_keep(sg_world *world, const sg_kept_tree *kept,
                  sg_self_known known);

/* Where its surface is not one sheet; good as long as the tree is held. */
bool sg_kept_nonmanifold(sg_call *call, sg_kept_tree *kept,
                         const sg_version *version, const sg_leaf_views *views,
                         const sg_nonmanifold **out);

/* The box round the vertices of segment s, if its tree is kept. */
bool sg_kept_box(const sg_version *version, int32_t s, sg_box *out);

/* Views of one version; clear them, also after a failure. */
bool sg_leaf_views_open(sg_call *call, const sg_version *version,
                        sg_leaf_views *out);
void sg_leaf_views_clear(sg_leaf_views *views);

#endif
