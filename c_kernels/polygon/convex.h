/* convex.h -- convex polygons in a plane: hulls, outlines, overlaps.
 *
 * Layer: kernel. Inexact. Polygons are counter-clockwise; two corners are a
 * line, all corners in one place a point.
 */
#ifndef SG_CONVEX_H
#define SG_CONVEX_H

#include <stdbool.h>
#include <stddef.h>

/* The hull of n points without those on its sides: how many corners it has, in
 * `out`, which has room for n + 1. Puts the points in another order.
 *
 * Source: A. M. Andrew, Another efficient algorithm for convex hulls in two
 * dimensions, 1979. */
size_t sg_convex_hull(double (*point)[2], size_t n, double (*out)[2]);

enum {
  SG_CONVEX_CORNERS = 8, /* of an outline, at most */
  SG_CONVEX_MOST = 32    /* of what one is made of */
};

/* Takes corners away from a convex polygon of n corners (SG_CONVEX_MOST or
 * fewer) until SG_CONVEX_CORNERS
 * are left (or fewer than that were there): sides go, the shortest way round,
 * and those before and after them are made longer until they meet. So it lies
 * inside of what is left up to rounding; a corner that is a corner of the
 * outline stays where it is. How many are left; 0: sides do not meet. */
size_t sg_convex_outline(double (*corner)[2], size_t n);

/* Whether two convex polygons overlap deeper than `depth`: no side of either
 * has all of the other outside, or inside by no more. A sliver across another
 * polygon overlaps it, however thin it is. So what does not overlap a polygon
 * does not overlap a part of it. */
bool sg_convex_overlap(const double (*a)[2], size_t na, const double (*b)[2],
                       size_t nb, double depth);

#endif
