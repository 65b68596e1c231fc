/* bvh.h -- a tree of boxes, and the join of two such trees.
 *
 * Layer: kernel. The boxes are put in Morton order of their centres (radix
 * sort: linear time, the same result everywhere) and a complete binary tree is
 * laid over groups of them. Boxes are CLOSED: touching ones overlap.
 *
 *   sg_bvh_pairs pairs;
 *   size_t i, j;
 *   sg_bvh_pairs_init(&pairs, a, b);
 *   while (sg_bvh_pairs_next(&pairs, &i, &j))
 *     use(i, j);                        // box i of a overlaps box j of b
 */
#ifndef SG_BVH_H
#define SG_BVH_H

#include "poll.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct sg_box {
  double lo[3], hi[3]; /* lo <= hi in each axis, or the box is empty */
} sg_box;

/* The box of nothing: joining anything to it gives that thing. */
sg_box sg_box_none(void);

/* Grows `box` so that it holds `point`. */
void sg_box_add(sg_box *box, const double point[3]);

typedef struct sg_bvh sg_bvh;

/* A tree over n boxes (copied). Null: no memory, or the poll said stop.
 * Owner: the caller, until sg_bvh_close(). Requires n < 2^32. */
sg_bvh *sg_bvh_open(const sg_box *box, size_t n, const sg_poll *poll);
void sg_bvh_close(sg_bvh *tree);

/* The box round everything in the tree. */
sg_box sg_bvh_box(const sg_bvh *tree);

enum {
  SG_BVH_GROUP = 4,  /* boxes in a leaf */
  SG_BVH_STACK = 128 /* deeper than any tree of 2^32 boxes needs */
};

/* A walk over the overlapping pairs of two trees (which may be the same one:
 * then each pair comes twice). Holds no memory of its own. */
typedef struct sg_bvh_pairs {
  const sg_bvh *a, *b;
  const sg_poll *poll; /* asked on the way; null after init */
  bool stopped;        /* the poll said stop: there may be more pairs */
  unsigned steps;
  unsigned depth; /* of the stack of node pairs */
  uint32_t stack[SG_BVH_STACK][2];
  uint32_t i, j, i_end, j_begin, j_end; /* the leaf pair in hand */
} sg_bvh_pairs;

void sg_bvh_pairs_init(sg_bvh_pairs *pairs, const sg_bvh *a, const sg_bvh *b);

/* The next overlapping pair, as indexes into the boxes given to
 * sg_bvh_open(). False: no more, or pairs->stopped. The order depends on the
 * boxes only. */
bool sg_bvh_pairs_next(sg_bvh_pairs *pairs, size_t *i, size_t *j);

#endif
