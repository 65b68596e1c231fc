/* bezier_patch.h -- the normal of a bicubic Bezier patch at a point of it.
 *
 * Layer: kernel. A patch has 16 control points, four rows of four: u goes along
 * a row, v from row to row, as in rules/primitive/bezier.pl.
 */
#ifndef SG_BEZIER_PATCH_H
#define SG_BEZIER_PATCH_H

#include <stdbool.h>

/* The normal u x v, of any length, where the patch is nearest to p. False: it
 * has none there (a side that is one point). Inexact: the nearest point of a
 * net of five by five, then steps of Gauss and Newton. */
bool sg_bezier_patch_normal(const double control[16][3], const double p[3],
                            double out[3]);

#endif
