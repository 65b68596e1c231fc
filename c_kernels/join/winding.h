/* winding.h -- how often triangles go round a point.
 *
 * Layer: kernel. A closed surface that is counter-clockwise from outside goes
 * once round the points inside it and not at all round those outside; a hollow
 * takes one off, shells in each other add up, one that is inside out counts
 * -1. Counted along the ray from the point in direction +x, which is shifted
 * by less than anything towards +y and still less towards +z, so that it meets
 * no edge and no corner. Exact.
 *
 * Source: the winding number of a polygon, with W. R. Franklin's half-open
 * edges, taken to triangles by signs alone.
 */
#ifndef SG_WINDING_H
#define SG_WINDING_H

#include "number/exact.h"

/* What triangle a, b, c counts for point p: +1 where the ray leaves through
 * it, -1 where it enters, 0. Of an open surface the sum means nothing. */
int sg_winding_of(const sg_point *a, const sg_point *b, const sg_point *c,
                  const sg_point *p);

/* Whether p lies on the closed triangle (which may have no area). */
bool sg_is_on_triangle(const sg_point *a, const sg_point *b, const sg_point *c,
                       const sg_point *p);

#endif
