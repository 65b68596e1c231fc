/* delaunay.h -- better triangles for a polygon that has been triangulated.
 *
 * Layer: kernel. Over the vertices of a scratch relation (work.h); its edges
 * are used up by then. What may be done is decided exactly, what is better in
 * doubles.
 */
#ifndef SG_DELAUNAY_H
#define SG_DELAUNAY_H

#include "triangulate.h"

/* Makes vertex v, which lies inside or on the border of a triangle, a corner:
 * that triangle, or the two with the edge it is on, are divided. Nothing
 * changes if it lies in none, or where a corner is: n vertices add 2 n
 * triangles at most, wherever they lie. False: no memory. Exact. */
bool sg_triangles_insert(const sg_work *work, sg_triangles *triangles,
                         int32_t v);

/* Turns chords, none that `is_fixed`, until the angles opposite to each add up
 * to no more than two right ones. SG_DONE, SG_STOPPED or SG_NO_SPACE. Then they
 * are settled, unless two triangles have the same side the same way round, or
 * rounding would let it go on: with the same fixed sides nothing is turned. */
sg_outcome sg_triangles_delaunay(const sg_work *work, sg_triangles *triangles,
                                 bool (*is_fixed)(void *data, int32_t a,
                                                  int32_t b),
                                 void *data, const sg_cancel *cancel);

/* Whether a triangle is narrower than rounding allows for: than 2^-30 of its
 * longest side, or than 2 * moved, if its corners were moved by that. Inexact.
 */
bool sg_triangle_is_thin(const double a[3], const double b[3],
                         const double c[3], double moved);

/* A triangle of a polygon can be so thin that rounding has turned it over:
 * where a chord passes a vertex that was meant to lie on it. If there is one
 * among the triangles, chords are turned, none that is an edge (a, b) of
 * edge[], either way. SG_DONE, SG_STOPPED or SG_NO_SPACE. */
sg_outcome sg_triangles_thicken(const sg_work *work, const int32_t (*edge)[2],
                                size_t edges, double moved,
                                sg_triangles *triangles,
                                const sg_cancel *cancel);

#endif
