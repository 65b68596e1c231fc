/* coincident_faces.h -- what a solid has in one place it has once.
 *
 * Layer: kernel. Vertices in one place become the first of them. Of faces with
 * one border, turned round or not, that are flat within the tolerance, or have
 * the same triangles, the first stays, and what the others came from are parts
 * of it.
 */
#ifndef SG_COINCIDENT_FACES_H
#define SG_COINCIDENT_FACES_H

#include "engine/cancel.h"
#include "solid.h"

/* What is not used any more stays among the vertices. `tolerance`: model units;
 * 8 units in the last place of the largest coordinate are the least. *doubles:
 * how many faces have gone. Exact but for what is flat. Requires: faces stand
 * in the order of their triangles.
 *
 * Returns: false: no memory, or stopped; the solid is good for nothing.
 * Cost:    n log n of triangles. */
bool sg_coincident_faces(sg_solid *solid, double tolerance,
                         const sg_cancel *cancel, size_t *doubles);

#endif
