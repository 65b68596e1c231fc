/* fan.h -- what hangs on one vertex, or lies in one polygon, in a tree of
 * triangles.
 *
 * Layer: kernel. The boxes of n triangles round one vertex all have it, so a
 * join of a tree with itself finds each two of them. Seen from the vertex they
 * are arcs on a sphere, and where those of two nodes are apart, the triangles
 * have nothing in common but the vertex. Inexact, and let out: what is said to
 * be apart is.
 */
#ifndef SG_FAN_H
#define SG_FAN_H

#include "bvh.h"

typedef struct sg_fan_triangle {
  double at[3][3];
  uint32_t name[3]; /* of the corners: equal where they are taken for one */
  int32_t polygon;
} sg_fan_triangle;

/* The triangle whose box is at this place of the tree (0 .. n - 1). */
typedef void sg_fan_read(const void *data, size_t place, sg_fan_triangle *out);

/* Of each node of a tree: a vertex that all triangles below it have, and how
 * they lie round it. */
typedef struct sg_fans sg_fans;

/* *out is null if so few corners are connected that it is not worth it. Corners
 * are one where their names are equal, or if `by_place`, where they are. False:
 * no memory, or stopped. Owner: sg_fans_close() in any case. Cost: linear. */
bool sg_fans_open(const sg_bvh *tree, sg_fan_read *read, const void *data,
                  bool by_place, const sg_cancel *cancel, sg_fans **out);
void sg_fans_close(sg_fans *fans);

/* An sg_bvh_apart: whether no triangle below box a of a level has more in
 * common with one below box b than a vertex that all of them have, except for
 * triangles of one polygon. */
bool sg_fans_apart(const void *fans, unsigned level, size_t a, size_t b);

#endif
