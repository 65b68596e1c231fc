/* contour.h -- outlines of smooth surfaces, inside their triangles.
 *
 * Layer: kernel. The side of a vertex that a surface turns to the eye is told
 * by g = normal . direction to the eye, with the normal of the vertex's fan
 * (smooth.h). Along the sides of a curved sheet's triangles g runs linearly,
 * and the outline goes through its zeros: across a triangle whose corners
 * differ runs one piece. Zero counts as turned to the eye, so that pieces hang
 * together whatever lies where.
 *
 * A side is a chord: at its zero the surface is above it, by a part of the
 * square of its length that is not the same for any two sides, and where the
 * outline runs towards the eye that would be all one sees of it: hooks. So a
 * piece begins and ends in the picture on the surface, which *rises* above the
 * side as a circle does that has the normals of both ends, N1 and N2, at P1 and
 * P2: at z of it by z (1 - z) / 2 (N2 - N1) . (P2 - P1) along the normal, up to
 * the fourth power of the angle. Where a sheet ends at a line in a facet, the
 * surface is above its end, too (sg_smooth.sunk). Not beside a line that runs
 * through the sheet, for outline and line meet on the side; nor on other than
 * known surfaces, whose normals are not known so well.
 *
 * A piece is straight, the surface is not: if it leaves the corner that it
 * parts from the two others outside in the picture, on its right, which lies on
 * the surface, the outline goes by way of that. What hides lines beside it:
 * scene_divided.h.
 *
 * A piece that reaches the end of its sheet (a crease, a border, a penetration
 * line) ends there, at the zero of the side. Where a smooth surface would bulge
 * at its triangle (SG_SIDE_BULGES), it goes to that end of the side at which
 * the triangles themselves turn from the eye: there the line is outermost in
 * the picture. At an apex, which has no normal, it ends in it.
 *
 * What is hidden. Of the surface beside an outline one half is nearer the eye.
 * If g is positive there, the surface bends away from the line of sight; if
 * not, it comes between the outline and the eye, and hides it, if it is the
 * surface of a solid. Which it is changes at a cusp, where the picture of the
 * outline turns back. So it is the picture that tells: a piece has the half
 * with positive g on its left, seen from outside, and the normal is seen across
 * it, on its right where that half is the nearer one. Hence what is not hidden
 * never turns back. To the triangles the line of sight is no tangent: those
 * next to a piece may lie before it. Which these are is a walk from its
 * triangle, over the strip of the picture that the piece sweeps across its
 * direction, on to neighbours as long as they are not yet turned to the eye as
 * a whole or lie outside the piece. They are *adjacent* to it and never
 * hide it.
 *
 * The outline of a coarse sheet runs along the sides of its triangles, between
 * one that is turned to the eye and one that is not: that of the smooth surface
 * would lie visibly inside what is seen of it, and triangles would hide it. So
 * does that of a polygon that is not flat, where its triangles fold.
 *
 * What is seen of a smooth sheet also ends where its triangles turn from the
 * eye. Usually a piece of the outline runs near such a side. If that piece is
 * hidden, or the triangles are too coarse for the bend, none may. Then the side
 * is a *substitute outline*: it is drawn where no other line is near (hide.h).
 * A side is one if a smooth surface would bulge at one of its two triangles; of
 * a solid also only if the surface bends down there, since otherwise the
 * solid's own triangles hide the side.
 *
 * Lines on a smooth surface (creases, penetration lines, borders) are turned to
 * the eye, or from it, as the surface is, not as the triangles are. Where both
 * say the same of a side nothing is told of it, nor where a smooth surface
 * would bulge. Else it has a *facing*, which says what the surface itself hides
 * of the line: the part under whose surface the eye is (g < 0); of a solid, if
 * the other face goes down from the line, only where the eye is under that,
 * too, and if that goes up, all of the line if the eye is under that
 * everywhere; of an open surface only if its triangle runs from the line
 * towards the eye. Adjacent triangles, found as for a piece, do not hide
 * the rest. So what is seen of a line ends where the outline does. If the
 * surface bends towards the line of sight (the half with g < 0 is nearer), the
 * back of an open one is what is seen, and towards and away change places; a
 * solid hides the line on both sides of the outline, with its triangles.
 *
 * Source: Hertzmann & Zorin 2000, Illustrating smooth surfaces, section 3
 * (interpolated contours); cusps, adjacent triangles, substitute outlines and
 * facings are ours.
 */
#ifndef SG_CONTOUR_H
#define SG_CONTOUR_H

#include "smooth.h"
#include "view.h"

/* What the surface adjacent to a line does: hides it or not; or the line is a
 * substitute outline. */
typedef enum sg_contour_visibility {
  SG_CONTOUR_HIDDEN,
  SG_CONTOUR_VISIBLE,
  SG_CONTOUR_SUBSTITUTE
} sg_contour_visibility;

typedef struct sg_contour_input {
  const sg_dense *dense;
  const sg_smooth *smooth;   /* of the same */
  const double (*screen)[3]; /* [vertices], in the picture */
  const bool *solid;         /* [segments]: closed, its outside out */
  sg_eye eye;
  bool central;
} sg_contour_input;

/* A piece from side[0] of triangle t to side[1], or along a side that is both;
 * at: 0 at the vertex of the side that has the smaller number, 1 at the other,
 * in the picture. */
typedef struct sg_contour {
  uint32_t t;
  uint8_t side[2]; /* 0 to 2 */
  double at[2];
  double rise[2][2]; /* from there to the smooth surface, in the picture */
  sg_contour_visibility visibility;
  bool along;   /* it is a side, from end to end */
  int8_t sense; /* -1: the half with g < 0 is the nearer one, else 1 */
  size_t adjacent, adjacents; /* its places in sg_contours.adjacent */
} sg_contour;

/* A line along a side whose surface is turned to the eye otherwise than the
 * triangle is. */
typedef struct sg_facing {
  sg_contour seen; /* the part that the surface does not hide: on one side; it
                      is hidden if there is none */
  double from,
      to; /* the part that it hides, counted as `at`; from == to: none */
} sg_facing;

typedef struct sg_contours {
  sg_contour *piece; /* [n], by triangle */
  sg_facing *facing; /* [facings], by triangle and side */
  uint32_t
      *adjacent; /* [adjacents]: triangles, of each piece in ascending order */
  size_t n, facings, adjacents;
  size_t room, facing_room, adjacent_room;
} sg_contours;

/* False: stopped by the cancellation, or no memory (then *memory is false). The
 * caller calls sg_contours_clear() in any case. Inexact. */
bool sg_contours_find(const sg_contour_input *in, const sg_cancel *cancel,
                      sg_contours *out, bool *memory);
void sg_contours_clear(sg_contours *contours);

#endif
