/* facing.h -- the ways most triangles face, and how far along these reaches
 * what is below the nodes of a tree.
 *
 * Layer: kernel. Triangles of shells in each other overlap in boxes along x, y
 * and z wherever they are, and so do boxes round a few of them along any way.
 * But each is flat the way it faces. So a tree is grown over groups that face
 * one way, and each of its nodes knows how far it reaches along the ways that
 * most triangles face: nodes that do not overlap along one of these are apart.
 * Small ones are also compared along the way that one of the two faces.
 * Inexact, and let out: what is said to be apart is.
 */
#ifndef SG_FACING_H
#define SG_FACING_H

#include "bvh.h"

#include <stdatomic.h>

enum {
  SG_FACING_AXES = 32,
  SG_FACING_GROUPS = 254,
  SG_FACING_LOW = 3 /* levels whose nodes have a way of their own */
};

/* Where the corners of triangle i are. */
typedef void sg_facing_read(const void *data, size_t i, double out[3][3]);

/* The way the first triangle below a node faces, and how far all reach along
 * it. */
typedef struct sg_facing_own {
  double axis[3], lo, hi;
} sg_facing_own;

typedef struct sg_facing {
  size_t axes;
  double axis[SG_FACING_AXES][3]; /* of length 1 */
  unsigned char *group;           /* [n] of a triangle */
  double reach;
  float *level[SG_BVH_LEVELS];           /* from 1 on: 2 * axes of each node */
  sg_facing_own *own[SG_FACING_LOW + 1]; /* the same */
  const sg_bvh *tree;
  atomic_size_t *reads; /* null, or counts triangles read by sg_facing_apart */
  sg_facing_read *read;
  const void *data;
} sg_facing;

/* The ways most of n triangles face, and the group of each.
 *
 * Returns: false: no memory, or the cancellation said stop.
 * Owner:   sg_facing_clear() in any case.
 * Cost:    linear. */
bool sg_facing_find(size_t n, sg_facing_read *read, const void *data,
                    const sg_cancel *cancel, sg_facing *out);

/* How far the nodes of a tree over these triangles reach. What is no farther
 * apart than `reach` along x, y and z is never said to be apart. The same; tree
 * and data are read until sg_facing_clear(). */
bool sg_facing_measure(sg_facing *facing, const sg_bvh *tree, double reach,
                       sg_facing_read *read, const void *data,
                       const sg_cancel *cancel);
void sg_facing_clear(sg_facing *facing);

/* An sg_bvh_apart: whether all triangles below box a of a level are apart from
 * all below box b. */
bool sg_facing_apart(const void *facing, unsigned level, size_t a, size_t b);

#endif
