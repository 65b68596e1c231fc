/* flat_fit.h -- the smallest box round points in a plane.
 *
 * Layer: kernel. Inexact.
 */
#ifndef SG_FLAT_FIT_H
#define SG_FLAT_FIT_H

#include "engine/cancel.h"

/* A unit vector along the longer side of a box. */
typedef struct sg_flat_fit {
  double x, y;
} sg_flat_fit;

/* The box of the least area that holds n points, and has a side of their hull;
 * of those that are equal up to rounding the first, from the leftmost point
 * on, counter-clockwise. (1, 0) if the points lie in a line. Puts the points in
 * another order; `room` is for n + 1 of them. (1, 0) as well if *stopped by the
 * cancel. */
sg_flat_fit sg_flat_fit_find(double (*point)[2], size_t n, double (*room)[2],
                             const sg_cancel *cancel, bool *stopped);

#endif
