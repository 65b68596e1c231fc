/* near_leaf.h -- which segments have leaves near each other.
 *
 * Layer: kernel. Where n segments lie in each other their boxes overlap, each
 * two. One tree over the leaves of all of them finds those that may meet.
 */
#ifndef SG_NEAR_LEAF_H
#define SG_NEAR_LEAF_H

#include "bvh_join.h"
#include "leaf_tree.h"

/* Pairs of the n trees, as places a < b of hits, each once, ascending: those
 * that have leaves which are not farther apart than `reach`, and some that have
 * not. Of two curves (edges) only if `of_curves`. *more: more than `most` pairs
 * of leaves are near each other, as of shells in one place, or to show that
 * they are not is as much work, as of shells beside each other that face every
 * way; *out is empty then.
 *
 * Returns: false: no memory, or the cancellation said stop; *out is empty then.
 * Owner:   out->hit is the caller's, to free().
 * Cost:    as the join of their triangles, n log n if few are near. */
bool sg_near_leaves(const sg_leaf_tree *const *tree, size_t n,
                    const sg_leaf_views *views, double reach, bool of_curves,
                    size_t most, sg_pool *pool, const sg_cancel *cancel,
                    sg_bvh_hits *out, bool *more);

#endif
