/* picture_points.h -- points of the picture that are nearly in one place are
 * made one.
 *
 * Layer: kernel. What lies behind one another is seen in one place only up to
 * rounding; after this it is in one place.
 */
#ifndef SG_PICTURE_POINTS_H
#define SG_PICTURE_POINTS_H

#include "engine/cancel.h"

#include <stdbool.h>
#include <stddef.h>

/* What counts as one place: this part of the longer side of the picture. */
#define SG_ONE_PLACE 1e-7

/* The longer side of the box round all points; 0: none, or one place. */
double sg_picture_side(const double *x, const double *y, size_t n);

/* Points in order: one that is not farther than `close` from points that stay
 * moves to the first of these; otherwise it stays. x[n], y[n] change in place.
 *
 * Requires: finite coordinates, close >= 0. Linear, whatever the points are.
 * Returns:  false: stopped by the cancellation, or no memory (then *memory is
 * false); the points are moved up to some place. */
bool sg_picture_merge(double *x, double *y, size_t n, double close,
                      const sg_cancel *cancel, bool *memory);

#endif
