/* cut.h -- what two triangles have in common, as pairs of features.
 *
 * Layer: kernel. Exact: decided by sg_orient3d() and turns of the input
 * doubles alone, no tolerance, no constructed point.
 *
 * A *feature* is the smallest part of a triangle that holds a point: corner i,
 * edge i (from corner i to corner i + 1) or the face. An end of a cut is the
 * pair (feature of the first, feature of the second triangle) that holds it;
 * neighbouring triangles see the same end under the same corner or edge, so
 * ends are compared by what they are, never by where they are.
 */
#ifndef SG_CUT_H
#define SG_CUT_H

#include <stdbool.h>
#include <stdint.h>

typedef enum sg_feature {
  SG_CORNER_0,
  SG_CORNER_1,
  SG_CORNER_2,
  SG_EDGE_0,
  SG_EDGE_1,
  SG_EDGE_2,
  SG_FACE
} sg_feature;

/* The edge 0..2 on whose closure both features lie; -1: there is none. Two
 * equal corners lie on two edges: the one that starts there is given. */
int sg_feature_edge(sg_feature f, sg_feature g);

/* One end: f[0] of the first triangle, f[1] of the second. */
typedef struct sg_cut_end {
  sg_feature f[2];
} sg_cut_end;

/* A common piece: a segment, or a point when both ends are the same. */
typedef struct sg_cut {
  sg_cut_end end[2];
} sg_cut;

bool sg_cut_is_point(const sg_cut *cut);

/* The edge 0..2 of triangle `which` (0 or 1) that the piece lies along; -1:
 * it runs through the face, or is a point. */
int sg_cut_along(const sg_cut *cut, int which);

typedef enum sg_cut_kind {
  SG_CUT_NONE,     /* nothing in common (or a triangle has no area) */
  SG_CUT_CROSSING, /* planes differ: one piece */
  SG_CUT_COPLANAR  /* one plane: the borders of each inside the other */
} sg_cut_kind;

enum { SG_CUT_MAX = 6 };

/* What triangles a and b have in common.
 *
 * Planes that differ: out[0], a segment (in the direction normal(a) x
 * normal(b)) or a point. One plane: the closed edges of a clipped by b, then
 * those of b clipped by a that do not run along an edge of a, each a segment
 * in its edge's direction; only if there is none, the single common point.
 * Returns the kind and sets *n. Exact. */
sg_cut_kind sg_cut_triangles(const double a[3][3], const double b[3][3],
                             sg_cut out[SG_CUT_MAX], int *n);

/* Whether triangle a lies wholly above (1) or below (-1) the plane of b; 0:
 * neither, it touches or crosses it. The first test of a pair. Exact. */
int sg_cut_side(const double a[3][3], const double b[3][3]);

/* What the segment from u to w has in common with triangle b. Of an end,
 * f[0] is SG_CORNER_0 for u, SG_CORNER_1 for w, SG_EDGE_0 between them. A
 * segment in the plane of b gives the part inside b. SG_CUT_NONE: nothing
 * (or b has no area, or u = w). Exact. */
sg_cut_kind sg_cut_segment(const double u[3], const double w[3],
                           const double b[3][3], sg_cut *out);

/* An axis along which triangle a is seen with area, or -1. Exact. */
int sg_cut_axis(const double a[3][3]);

#endif
