/* crease.h -- creases of meshes: where one that fades goes on, and which are
 * none.
 *
 * Layer: kernel. Of a mesh nothing is known but how its faces bend, and a
 * crease is an edge that bends by more than an angle. Where a crease fades, or
 * a mesh is uneven, the bend passes that angle to and fro. So a crease that
 * ends where no other line is goes on (hysteresis along the chain):
 *
 *   - across the edge that bends most and goes on straightest, as long as that
 *     one bends by more than a third of the angle, and clearly more than the
 *     other edges there;
 *   - from there across a few edges that bend less, if they lead to another
 *     line.
 *
 * Creases that hang together, end where no other line is, touch none but
 * themselves, and are all together shorter than 1/100 of the longest side of
 * the model, are specks.
 *
 * Edges by the terms (known_surface.h) are creases anyhow, and never go on.
 */
#ifndef SG_CREASE_H
#define SG_CREASE_H

#include "scene_model.h"

enum {
  SG_CREASE_BENT = 0, /* it is a crease if it bends by more than the angle */
  SG_CREASE_ON = 1,   /* a crease goes on there */
  SG_CREASE_SPECK = 2 /* it bends by more, but is a speck */
};

/* (*as)[lines] of the model, to be freed; null if the angle is so small that
 * every facet is seen. crease: the angle in degrees; faceted: [segments] that
 * are what their facets are. The same for the same model. False: stopped, or no
 * memory (then *memory is false). Inexact. */
bool sg_creases_find(const sg_scene_model *model, const bool *faceted,
                     double crease, const sg_cancel *cancel, uint8_t **as,
                     bool *memory);

#endif
