/* ring_ears.h -- a ring of edges in space into triangles, wherever they are.
 *
 * Layer: kernel. For polygons that are too far from flat to be divided in any
 * picture of them. The triangles end where the ring ends; they may go through
 * each other where the ring leaves them no other way.
 */
#ifndef SG_RING_EARS_H
#define SG_RING_EARS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct sg_ring_edge {
  int32_t start, end; /* ids of vertices */
  const double *at;   /* [3]: where it starts */
} sg_ring_edge;

/* Cuts off ears, the one with the shortest chord first; of equal chords the
 * first in the ring. `edge`: [n], n >= 3, in any order; sorted as the ring
 * goes. *is_ring: they are one ring that meets itself nowhere; then
 * `triangle`, [n], has n - 2 of them, as ids. False: no memory.
 * Cost:    grows with the square of n. */
bool sg_ring_ears(sg_ring_edge *edge, size_t n, int32_t (*triangle)[3],
                  bool *is_ring);

#endif
