/* roll.h -- cylinders and cones unrolled, as they truly are: not their facets.
 *
 * Layer: kernel. Of a surface with parameters t (radians) and h, seen from
 * outside (of one whose u, v, w are left-handed, from inside):
 *
 *   cylinder  x = the length of its section at right angles to the axis, from
 *                 `start` to t; y = what the point is along the axis, from c
 *   cone      x + iy = r * exp(i*angle): r = the distance from the apex, angle
 *                 = what the generators turn through from `start` to t; that
 *                 is seen from outside if k < 1 (the apex is above)
 *   fan       x along u, y at right angles to it, towards v; from c
 *
 * Right, oblique and elliptic ones are the same. The lengths and angles are
 * integrals; panels are halved until the whole turn does not change, which is
 * good to 1e-13 of it unless the section is flatter than 1 to 1000.
 *
 * A layer `layer` outside the surface (negative: within) is unrolled instead,
 * each point carried there along the normal. Along a generator the normal
 * stays as it is, so generators stay straight, and keep their lengths: with
 * the normal turning by psi about the generator, a cylinder is layer * psi
 * wider; of a cone the apex moves by layer * psi across the generator.
 *
 * A surface that is itself parallel to one (its `offset`) is unrolled as that,
 * with a layer farther out.
 *
 * Results are multiples of 2^-47 of the size, so that they do not hang on the
 * last bit of the machine's sine.
 *
 * Source: the metric of a developable surface, dr^2 + r^2 dphi^2 (do Carmo,
 * Differential geometry of curves and surfaces, 3-5 and 4-2); the layer ours.
 */
#ifndef SG_ROLL_H
#define SG_ROLL_H

#include "surface.h"

typedef struct sg_roll {
  sg_surface surface; /* a cylinder, a fan, or a cone with k other than 1 */
  double layer;       /* model units, along the outward normal; from
                         sg_roll_open() on, of what the surface is parallel to */
  double start;       /* t, radians */
  /* The rest is made by sg_roll_open(). */
  double axis[3];      /* cylinder: unit; cone: from the apex to c; fan: unit,
                          along y */
  double across[2][3]; /* cylinder: u and v less what is along the axis; fan:
                          unit, along x */
  double volume; /* of u, v and axis, positive: how fast the normal turns */
  double grid;   /* results are multiples of it */
  size_t panels;
  double *sum;       /* [panels+1] x or angle at their ends */
  double (*apex)[2]; /* [panels+1] where the apex is there; null: at 0, 0 */
} sg_roll;

/* Takes `surface`, `layer` and `start`, makes the rest. sg_roll_clear() frees.
 * Returns: false if memory ran out, or the surface cannot be unrolled. */
bool sg_roll_open(sg_roll *roll);
void sg_roll_clear(sg_roll *roll);

/* Where (t, h) is laid. t is at most about a turn from the start. */
void sg_roll_at(const sg_roll *roll, double t, double h, double out[2]);

#endif
