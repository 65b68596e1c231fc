/* whole_contacts.h -- whether all that meets in a solid is equal features.
 *
 * Layer: kernel. Segments side by side, whose vertices in one place are one and
 * whose coincident faces are one (coincident_faces.h), are already cut if
 * nothing else of them meets: vertices lie on vertices, edges on edges, faces
 * on faces, or they are apart. One join of the boxes of all triangles proves
 * it: exact signs say that two triangles have nothing in common but corners
 * that are one, and the edge between these; and no others of their features are
 * within reach of each other.
 */
#ifndef SG_WHOLE_CONTACTS_H
#define SG_WHOLE_CONTACTS_H

#include "engine/cancel.h"
#include "solid.h"

/* *whole: nothing else meets, no segment has two vertices or two faces in one
 * place, no side is so short that contacts within reach could not be told, and
 * each of the n segments `solids`, ascending, is closed and hangs together: so
 * every face of it bounds it. Requires sg_coincident_faces() to have run, reach
 * >= 0 (model units). False when in doubt.
 *
 * Returns: false: no memory, or stopped.
 * Cost:    n log n of triangles; less if it is not whole. */
bool sg_whole_contacts(const sg_solid *solid, const int32_t *solids, size_t n,
                       double reach, sg_pool *pool, const sg_cancel *cancel,
                       bool *whole);

#endif
