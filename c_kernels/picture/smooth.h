/* smooth.h -- where a surface is smooth: sheets of triangles, and their
 * normals.
 *
 * Layer: kernel. Two triangles are connected smoothly where they alone share a
 * side, run along it in opposite directions, and their faces bend by no more
 * than the crease angle, or not at all if a penetration line runs there, and it
 * is no edge by the terms (known_surface.h), and no crease goes on there
 * (crease.h). A component is a *sheet*.
 *
 * Where polygons are facets of a known surface (known_surface.h), this says how
 * much they bend, and which way they look at a vertex; facets of one surface
 * are connected, even where a penetration line runs.
 *
 * The corners of a sheet's triangles at a vertex that are connected form a
 * *fan*; a vertex on a crease has one for each sheet there, or several. A fan
 * has one normal: the mean of its faces', weighted by their area and by the
 * angle they fill there. If a face leans more than the crease angle from it the
 * vertex is an *apex*, and has none.
 *
 * A sheet is *curved* if it bends along more than one line at a vertex inside
 * it that is no apex. One that is not (a cylinder, a cone, the sides of a
 * prism) is folded along straight lines, and its outline lies on these. Facets
 * of spheres and tori are curved, those of cylinders and cones are not.
 *
 * A curved sheet is *coarse* if, at more than a quarter of the length of its
 * sides, a smooth surface would bulge out between the middles of the triangles
 * there by more than a thousandth of its segment's longest side. Then its
 * outline is that of its triangles. Facets of known surfaces are never coarse.
 *
 * Side k of a triangle runs from its corner k to the next; sides, like corners,
 * are numbered 3 * triangle + k.
 */
#ifndef SG_SMOOTH_H
#define SG_SMOOTH_H

#include "known_surface.h"
#include "rows/dense.h"

#include <stdbool.h>

#define SG_NO_SIDE UINT32_MAX

/* What a crease must exceed its angle by, in degrees, so that the sides of a
 * prism are judged alike. */
#define SG_SMOOTH_OVER 1e-6

enum {
  SG_SIDE_SMOOTH = 1, /* the sheet goes on across it */
  SG_SIDE_CONVEX = 2, /* the triangle across lies below this one, or in it */
  SG_SIDE_FOLD = 4,   /* a polygon that is not flat is folded there, by more
                         than a degree */
  SG_SIDE_CUT = 16,   /* a penetration line runs there */
  SG_SIDE_BULGES = 8, /* it is in a curved sheet of no known surface, and a
                         smooth one would bulge there by more than a
                         ten-thousandth of its segment's longest side */
  SG_SIDE_KNOWN = 32  /* it is smooth and in a curved sheet, and both triangles
                         there stand on known surfaces: with all corners, or
                         by as much as these are sunk; no penetration line
                         that runs through the sheet touches them */
};

typedef struct sg_smooth {
  uint32_t *across; /* [3 * triangles]: the same side of the only other triangle
                       there, or SG_NO_SIDE */
  uint8_t *side;    /* [3 * triangles]: SG_SIDE_... */
  uint32_t *fan;    /* [3 * triangles]: of each corner */
  bool *curved;     /* [triangles]: its sheet is */
  bool *coarse;     /* [triangles]: its sheet is curved, and coarse */
  double (*normal)[3]; /* [fans]: unit, or 0 */
  bool *apex;          /* [fans] */
  double *sunk;        /* [fans]: how far the known surface is above the corner,
                          along the normal, where a penetration line ends in a
                          facet; else 0 */
  size_t fans;
} sg_smooth;

/* A model, and what parts its sheets. */
typedef struct sg_smooth_input {
  const sg_dense *dense;
  const uint32_t (*cut)[2]; /* [cuts] places of the ends of pieces of
                               penetration lines */
  size_t cuts;
  const uint32_t (*crease_on)[2]; /* [creases_on] the same of the edges along
                                     which creases go on (crease.h) */
  size_t creases_on;
  sg_known_surfaces surfaces; /* of the polygons; borrowed */
  double crease;              /* degrees */
} sg_smooth_input;

/* False: stopped by the cancellation, or no memory (then *memory is false);
 * nothing is left to clear. Nothing of the input is kept. Inexact. */
bool sg_smooth_init(sg_smooth *smooth, const sg_smooth_input *input,
                    const sg_cancel *cancel, bool *memory);
void sg_smooth_clear(sg_smooth *smooth);

#endif
