/* self_pair.h -- two triangles of one segment: do they meet, and how.
 *
 * Layer: kernel, for what looks for meetings.
 */
#ifndef SG_SELF_PAIR_H
#define SG_SELF_PAIR_H

#include "fan.h"
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

/* Two triangles; corners with one number are one corner. */
typedef struct sg_self_two {
  double a[3][3], b[3][3];
  uint32_t a_at[3], b_at[3];
  int n, shared[3], same[3]; /* shared[k] of a is same[k] of b; set here */
} sg_self_two;

void sg_self_two_of(const sg_fan_triangle *a, const sg_fan_triangle *b,
                    sg_self_two *out);

/* False: they have nothing in common but corners that they share and the edge
 * between them (or one has a corner twice). True: they may have. */
bool sg_self_may_meet(sg_self_two *two);

/* Whether they go through each other or overlap, or one reaches with an edge
 * into the face of the other: each by more than the tolerance. Requires
 * sg_self_may_meet(). */
bool sg_self_goes_through(const sg_self_two *two, double tolerance);

/* Triangle t (a place). */
void sg_self_read_triangle(const sg_self_model *model, int32_t t,
                           sg_fan_triangle *out);

/* True if triangles a and b meet. Sets `kind` and `at`, not `t`. */
bool sg_self_pair(const sg_self_model *model, int32_t a, int32_t b,
                  sg_self_meeting *out, sg_self_edge *edge);

#endif
