/* self_join.h -- which triangles of one segment may meet.
 *
 * Layer: kernel, for what looks for meetings. The join of their boxes
 * with themselves. Where they run askew their boxes are taken along them. A
 * polygon of many triangles that is exactly flat is one thing with one box:
 * what has nothing in common with it but a corner or an edge is not asked about
 * its triangles, nor are these about each other. So a face with n corners and
 * its n neighbours are n pairs.
 */
#ifndef SG_SELF_JOIN_H
#define SG_SELF_JOIN_H

#include "bvh_join.h"
#include "self_pair.h"

#include <stdatomic.h>

/* Triangle i. */
typedef void sg_self_read(const void *data, uint32_t i, sg_fan_triangle *out);
/* As sg_bvh_wants: of triangles i < k. */
typedef bool sg_self_wants(void *data, const sg_fan_triangle *i,
                           const sg_fan_triangle *k);

typedef struct sg_self_joining {
  size_t n;
  sg_self_read *read;
  sg_self_wants *wants;
  void *data;
  bool by_place;      /* corners in one place are one, for what hangs on one
                         vertex (fan.h): what touches in a point is not wanted */
  bool in_polygons;   /* also pairs of one polygon, if it is not exactly flat */
  bool in_faces;      /* with in_polygons, also of those that are: they may
                         lie on themselves */
  bool but_equal;     /* not those that have three corners in common */
  double reach;       /* above 0: also pairs that are no farther apart */
  const sg_bvh *tree; /* over boxes along x, y, z of all: triangle i is at place
                         i; or null */
  const atomic_bool *done;      /* once it is set no more is wanted; or null */
  const unsigned char *changed; /* [n] pairs one of which is; null: all */
} sg_self_joining;

/* The pairs that are wanted, as places a < b of hits. With a tree they come in
 * the order of its join, or if boxes were turned by a and b; without one, in
 * any order that is the same for any thread pool.
 *
 * Returns: false: no memory, or the cancellation said stop; *out is empty then.
 * Owner:   out->hit is the caller's, to free(). */
bool sg_self_join(const sg_self_joining *joining, sg_pool *pool,
                  const sg_cancel *cancel, sg_bvh_hits *out);

#endif
