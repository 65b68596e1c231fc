/* cell_added.h -- one more solid beside cells: what it shares with them, and
 * whether it is one more cell.
 *
 * Layer: kernel. Where all that a solid and cells have in common are equal
 * features (whole_contacts.h), nothing is cut. If what they share leaves of its
 * surface, a sphere, one part or none, what was round it stays one region or
 * becomes the inside of it: nothing else of the cells changes.
 *
 * Let V, E, F be the vertices, edges and faces that are shared, and C the parts
 * in which they hang together. By both laws the rest of the surface has
 * 1 + C - (V - E + F) parts; they are counted from faces, so this may fail.
 *
 * False or "no" also means that somebody has to look at all of it.
 */
#ifndef SG_CELL_ADDED_H
#define SG_CELL_ADDED_H

#include "solid/solid.h"

typedef enum sg_cell_added_how {
  SG_CELL_NOT,   /* it is not so simple */
  SG_CELL_MORE,  /* what was round it stays one region */
  SG_CELL_FILLS, /* it is all of a region */
} sg_cell_added_how;

/* `both` has the first `near` faces of the cells, of one segment, among them
 * all that come into the box of the solid made larger by `reach`; the other
 * faces are those of solid s, the parts of which are left out. Afterwards it
 * has those faces of s that it does not share, and `part` says of the others
 * which of the first it is. Exact, but when in doubt.
 *
 * Returns: false: no memory, or stopped. */
bool sg_cell_added(sg_solid *both, size_t near, int32_t s, double reach,
                   sg_pool *pool, const sg_cancel *cancel,
                   sg_cell_added_how *how);

#endif
