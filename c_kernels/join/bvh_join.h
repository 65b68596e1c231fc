/* bvh_join.h -- the join of trees of boxes: what overlaps what.
 *
 * Layer: kernel. Any number of pairs of trees at once, descended together by
 * several threads. The order of the hits depends on the trees alone: pairs of
 * trees in the order given, then boxes in Morton order.
 */
#ifndef SG_BVH_JOIN_H
#define SG_BVH_JOIN_H

#include "bvh.h"

/* Two trees, or one with itself: then each two boxes come once, and none with
 * itself. */
typedef struct sg_bvh_pair {
  const sg_bvh *a, *b;
} sg_bvh_pair;

/* Boxes that overlap: at place a and b of the trees of pair `pair`. The box
 * itself is item[a], item[b]. */
typedef struct sg_bvh_hit {
  uint32_t pair, a, b;
} sg_bvh_hit;

typedef struct sg_bvh_hits {
  size_t n;
  sg_bvh_hit *hit;
} sg_bvh_hits;

/* All hits of n pairs of trees: boxes that overlap, or are not farther apart
 * than `reach` along each axis, and a few that nearly do.
 *
 * Returns: false: no memory, or the cancellation said stop; *out is empty then.
 * Owner:   out->hit is the caller's, to free().
 * Requires n < 2^32, reach >= 0. */
bool sg_bvh_join(const sg_bvh_pair *pair, size_t n, double reach, sg_pool *pool,
                 const sg_cancel *cancel, sg_bvh_hits *out);

/* Whether any box of a tree overlaps this one; also true of some that nearly
 * do. */
bool sg_bvh_meets(const sg_bvh *tree, const sg_box *box);

/* Whether a hit is wanted. Called by any thread of the thread pool, several at
 * a time; the answer may depend on the hit alone. */
typedef bool sg_bvh_wants(void *data, const sg_bvh_hit *hit);

/* The same, except for those that nobody wants: they take no memory. */
bool sg_bvh_join_wanted(const sg_bvh_pair *pair, size_t n, double reach,
                        sg_bvh_wants *wants, void *data, sg_pool *pool,
                        const sg_cancel *cancel, sg_bvh_hits *out);

/* Whether nothing is wanted of what is below boxes a and b of a level (1 or
 * more) of a tree that is joined with itself. As sg_bvh_wants. */
typedef bool sg_bvh_apart(const void *data, unsigned level, size_t a, size_t b);

/* One tree with itself, the same; `apart`, with data of its own, may be null.
 */
bool sg_bvh_join_itself(const sg_bvh *tree, double reach, sg_bvh_wants *wants,
                        void *data, sg_bvh_apart *apart, const void *fans,
                        sg_pool *pool, const sg_cancel *cancel,
                        sg_bvh_hits *out);

#endif
