/* face_edge.h -- lines in a shaded picture, where other faces begin.
 *
 * Layer: kernel. A place is on such a line if half a dot from it, to the left,
 * to the right, above or below, something else is seen: another face, nothing,
 * or the same face farther away. Faces that go on in each other, in one plane
 * or, of a mesh, nearly so, have no line between them.
 */
#ifndef SG_FACE_EDGE_H
#define SG_FACE_EDGE_H

#include "cover.h"

/* Puts the lines of the row y of dots over the sums of `cover`. False: no
 * memory. */
bool sg_face_edges(sg_dot_row *cover, const sg_shaded *in,
                   sg_shading_work *work, int32_t y);

#endif
