/* roll_curve.h -- curves of space on a surface that is unrolled.
 *
 * Layer: kernel. Rims and penetration lines are where surfaces meet; unrolled
 * they are curves, of which points are taken until chords are near enough.
 */
#ifndef SG_ROLL_CURVE_H
#define SG_ROLL_CURVE_H

#include "roll.h"

typedef struct sg_roll_place {
  double t, h;  /* t within half a turn of near_t, unless it is a fan's */
  double at[2]; /* where it is unrolled */
} sg_roll_place;

typedef struct sg_roll_curve {
  const sg_roll *roll;
  double near_t;                               /* radians */
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
