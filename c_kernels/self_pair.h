/* self_pair.h -- two triangles of one segment: do they meet, and how.
 *
 * Layer: kernel, private to self_cut.c.
 */
#ifndef SG_SELF_PAIR_H
#define SG_SELF_PAIR_H

#include "self_cut.h"

typedef struct sg_self_model {
  const sg_dense *d;
  uint32_t first;        /* the segment's first vertex */
  const uint32_t *place; /* [its vertices]: equal where they are in one place */
  double tolerance;
} sg_self_model;

/* What a meeting along an edge says about the one on its other side: edge
 * u < w (places) of a triangle lies in the face of triangle `face`, the rest
 * of it on this side. face < 0: no such thing. */
typedef struct sg_self_edge {
  int32_t face;
  uint32_t u, w;
  int side;
} sg_self_edge;

/* True if triangles a and b meet. Sets `kind` and `at`, not `t`. */
bool sg_self_pair(const sg_self_model *model, int32_t a, int32_t b,
                  sg_self_meeting *out, sg_self_edge *edge);

#endif
