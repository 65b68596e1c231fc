/* bezier_patch.h -- points and normals of a bicubic Bezier patch.
 *
 * Layer: kernel. A patch has 16 control points, four rows of four: u goes along
 * a row, v from row to row, as in rules/primitive/bezier.pl.
 */
#ifndef SG_BEZIER_PATCH_H
#define SG_BEZIER_PATCH_H

#include <stdbool.h>
#include <stddef.h>

/* The four Bernstein polynomials at i / n. */
void sg_bezier_weights(size_t i, size_t n, double weight[4]);

/* The control points of the curve where v has these weights. */
void sg_bezier_row(const double control[16][3], const double weight[4],
                   double row[4][3]);

/* The point of a curve where u has these weights. Inexact; but a border has the
 * same points, to the last bit, in both patches that have it, whichever way it
 * runs there. */
void sg_bezier_point(const double row[4][3], const double weight[4],
                     double out[3]);

/* How much the patch bends where `map` brings it: two triangles for each of
 * n * n cells are no farther from it than bend / (8 * n * n).
 *
 * Source: D. Filip, R. Magedson, R. Markot, Surface algorithms using bounds on
 * derivatives, CAGD 3, 1986. */
double sg_bezier_bend(const double control[16][3], const double map[3][3]);

/* The normal u x v, of any length, where the patch is nearest to p. False: it
 * has none there (a side that is one point). Inexact: the nearest point of a
 * net of five by five, then steps of Gauss and Newton. */
bool sg_bezier_patch_normal(const double control[16][3], const double p[3],
                            double out[3]);

#endif
