/* solid_move.h -- a solid under way, somewhere else.
 *
 * Layer: kernel.
 */
#ifndef SG_SOLID_MOVE_H
#define SG_SOLID_MOVE_H

#include "engine/cancel.h"
#include "solid.h"

typedef enum sg_solid_moved {
  SG_MOVED,
  SG_MOVED_STOPPED, /* the cancellation said stop */
  SG_MOVED_TOO_FAR  /* a coordinate is larger than any that v/5 takes */
} sg_solid_moved;

/* Every vertex goes to row[k] = A B C D: A x + B y + C z + D, as doubles, from
 * left to right; its name stays. If the rows mirror, triangles turn round, so
 * that outside stays outside; faces are not said to be reversed.
 *
 * Of the faces with several triangles some may no longer be covered by them:
 * rounding turned one, or made it flat. They are marked in again[faces], and
 * are to be triangulated again.
 *
 * Places are rounded, what is marked is exact. */
sg_solid_moved sg_solid_move(sg_solid *solid, const double row[3][4],
                             const sg_cancel *cancel, bool *again);

#endif
