/* resolve_feature.h -- how far making things touch moves them, and whether
 * that is little beside what is near.
 *
 * Layer: kernel. Inexact. A FEATURE of a segment, seen from a shared point, is
 * an edge that is near it, or the distance to another sheet of the segment: a
 * wall, or a gap; or the gap between two segments, one that is closed, except
 * what their sources explain (sg_resolve.explained), or one beside it. A move
 * is TIGHT if it is more than a hundredth of the smallest feature there: then
 * what is made to touch may be other than what was meant.
 */
#ifndef SG_RESOLVE_FEATURE_H
#define SG_RESOLVE_FEATURE_H

#include "join/leaf_tree.h"
#include "resolve.h"

/* The trees of all segments (never of a body). *itself: this one is made to
 * touch in itself. */
typedef struct sg_resolve_trees {
  const int32_t *s; /* [n] */
  size_t n;
  const sg_leaf_tree *(*tree)(const void *data, int32_t s, bool *itself);
  const void *data;
} sg_resolve_trees;

typedef struct sg_resolve_moves {
  double farthest; /* how far the point that moved farthest did; 0: none did
                      farther than doubles are rounded */
  uint32_t point;  /* which it is */
  size_t tight;    /* points with a tight move */
  /* the tightest */
  uint32_t tight_point;
  int32_t tight_segment;
  double move, feature;
} sg_resolve_moves;

/* After sg_resolve_finish(), when segments have their names. False: no memory,
 * or the cancellation said stop. */
bool sg_resolve_measure(const sg_resolve *r, const sg_resolve_trees *trees,
                        const sg_leaf_views *views, sg_pool *pool,
                        const sg_cancel *cancel, sg_resolve_moves *out);

#endif
