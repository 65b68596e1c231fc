/* solid_border.h -- which half-edges of a face's triangles end the face.
 *
 * Layer: kernel. Without a table of all edges: the triangles of a face stand
 * together, and most faces have few.
 */
#ifndef SG_SOLID_BORDER_H
#define SG_SOLID_BORDER_H

#include "solid.h"

/* Scratch, all zero at first, to be used again for the next face. Owner:
 * sg_border_clear(). */
typedef struct sg_border {
  uint32_t *slot; /* [room] */
  size_t room;
} sg_border;

void sg_border_clear(sg_border *border);

/* Sets out[first .. first + n - 1] of the face's triangles: bit k: the
 * half-edge from corner k to the next has no opposite one in the face; opposite
 * ones are paired one to one. *edges: how many such. Exact.
 *
 * Returns: false: no memory, or sg_pool_stopping() said so (in large faces). */
bool sg_border_find(sg_border *border, const sg_solid *solid, size_t face,
                    uint8_t *out, uint32_t *edges);

#endif
