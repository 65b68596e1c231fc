/* roll_curve.h -- points and curves of space on a surface that is unrolled.
 *
 * Layer: kernel. A plate is not a surface: what its border is cut by, it meets
 * in one of its faces. So points are given `contact` outside the surface that
 * roll->surface is (negative: within), and go to it along the normal.
 */
#ifndef SG_ROLL_CURVE_H
#define SG_ROLL_CURVE_H

#include "roll.h"

typedef struct sg_roll_place {
  double t, h;  /* t within half a turn of the t it was asked near */
  double at[2]; /* where it is unrolled */
} sg_roll_place;

/* The place of the point x. */
void sg_roll_place_of(const sg_roll *roll, double contact, double near_t,
                      const double x[3], sg_roll_place *out);

typedef struct sg_roll_curve {
  const sg_roll *roll;
  double contact;
  double near_t;
  const sg_surface *surface[SG_SURFACES_MOST]; /* where they meet it runs */
  size_t surfaces;
  double from[3], to[3]; /* its ends, on all of them */
  double reach;          /* how far from its chord it may run */
  double tolerance;      /* how far from the curve chords may run, unrolled */
} sg_roll_curve;

/* Points between the ends of a curve, in order, so that no chord between
 * neighbours (and the ends) is farther than the tolerance from the unrolled
 * curve, as far as three points between each two tell. Where the surfaces do
 * not meet, the chord is taken for the curve.
 * Owner: the caller frees *out. Returns: false if memory ran out. */
bool sg_roll_curve_points(const sg_roll_curve *curve, sg_roll_place **out,
                          size_t *n);

#endif
