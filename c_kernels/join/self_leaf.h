/* self_leaf.h -- the join of a leaf tree with itself.
 *
 * Layer: kernel. What self_cut.h does for reports, for the triangles of a tree
 * that is there, and by their vertices: two vertices in one place are two
 * here. Triangles of one polygon are not compared: seen along its normal they
 * cover it, so they cannot go through each other.
 */
#ifndef SG_SELF_LEAF_H
#define SG_SELF_LEAF_H

#include "bvh_join.h"
#include "leaf_tree.h"

/* Pairs of leaves (places in the tree) that may have more in common than the
 * corners and the edge they share: what is left out has not, exactly. With a
 * reach above 0 also pairs that share no corner and whose boxes are not farther
 * apart than that. In the order of the join, the same for any thread pool.
 *
 * Returns: false: no memory, or the cancellation said stop; *out is empty then.
 * Owner:   out->hit is the caller's, to free(). */
bool sg_self_leaf_join(const sg_leaf_tree *tree, const sg_leaf_views *views,
                       double reach, sg_pool *pool, const sg_cancel *cancel,
                       sg_bvh_hits *out);

/* The same without reach, for those who need not know all sheets that touch
 * each other there: where many have an edge or a vertex in one place, and no
 * more in common, each is in a pair with a few of them only (self_sheet.h). So
 * n sheets on one edge are about n pairs, and connected as they are by all
 * pairs. The order is the same for any thread pool. */
bool sg_self_leaf_join_few(const sg_leaf_tree *tree, const sg_leaf_views *views,
                           sg_pool *pool, const sg_cancel *cancel,
                           sg_bvh_hits *out);

/* Whether the segment goes through itself or lies on itself, by more than the
 * tolerance of its source (flatness.h), whose grain is given. What only touches
 * in points does not.
 *
 * Returns: false: no memory, or the cancellation said stop.
 * Cost:    as the join; it ends at the first such pair. */
bool sg_self_leaf_meets(const sg_leaf_tree *tree, const sg_leaf_views *views,
                        double grain, sg_pool *pool, const sg_cancel *cancel,
                        bool *out);

#endif
