/* operand.h -- whether a segment can be an operand of a Boolean, in two passes.
 *
 * Layer: kernel. What a Boolean must know of every operand each time, so it is
 * fast: about 10 ms for 300,000 triangles. Which edges are wrong, and how, is
 * a join of its own, for segments that are not balanced.
 *
 * A segment is BALANCED when between any two vertices as many half-edges run
 * one way as the other: only then do winding numbers mean something.
 */
#ifndef SG_OPERAND_H
#define SG_OPERAND_H

#include "leaf_tree.h"

typedef struct sg_operand {
  size_t triangles, half_edges;
  bool balanced; /* a fingerprint of 64 bits: wrong once in 2^64 */
  double volume; /* > 0: normals point outward; inexact, always the same */
  double error;  /* what it may be off, at most */
  /* Seen from the middle of its box every triangle looks outward, and there is
   * one in each direction. So, exactly, it does not go through itself, nor lie
   * on itself: what is seen without gaps and folds from a point has one sheet.
   * Requires balanced. False says nothing. */
  bool star;
} sg_operand;

/* Of the segment of a tree. False: no memory, or the cancellation said stop.
 * The same for any thread pool. */
bool sg_operand_see(const sg_leaf_tree *tree, const sg_leaf_views *views,
                    sg_pool *pool, const sg_cancel *cancel, sg_operand *out);

/* The half-edges between two vertices, v[0] < v[1]. */
typedef struct sg_operand_edge {
  int32_t v[2];
  size_t forward, backward; /* from v[0] to v[1], and back */
} sg_operand_edge;

typedef struct sg_operand_edges {
  size_t open;            /* edges of one half-edge */
  size_t unbalanced;      /* of more, not as many one way as the other */
  size_t crowded;         /* balanced, of more than two */
  size_t firsts;          /* how many of the first two sorts are listed */
  sg_operand_edge *first; /* by vertices */
} sg_operand_edges;

/* The edges of segment s that are no pairs; the first `most` that are not
 * balanced are listed. False: no memory, or the cancellation said stop. Owner:
 * free(out->first) in any case. */
bool sg_operand_edges_find(const sg_leaf_views *views, int32_t s, size_t most,
                           const sg_cancel *cancel, sg_operand_edges *out);

#endif
