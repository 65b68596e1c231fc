/* known_surface.h -- the smooth surfaces that facets of primitives stand for,
 * and the faces that their terms name.
 *
 * Layer: kernel. A polygon that a primitive made is a facet of a surface that
 * is known (rules/csg/known_surface.pl): then the surface says which way it
 * looks at a vertex, and by how much two facets bend, not the facets. A surface
 * is placed by any affine map: its normal is the gradient of what is zero on
 * it, mapped by the transpose of the inverse; on which side it lies is told by
 * the facet.
 *
 * In coordinates x, y, h along U, V, W from its centre a surface is
 *
 *   tapered  (x/A)^2 + (y/B)^2 = 1, A = 1-h+h*a, B = 1-h+h*b: cylinders (a, b
 *            are 1), cones (a = b), and what is ruled between two ellipses
 *   sphere   x^2 + y^2 + h^2 = 1
 *   torus    (sqrt(x^2 + y^2) - 1)^2 + h^2 = a^2
 *   bezier   a bicubic Bezier patch (bezier_patch.h), which has its control
 *            points as its frame
 *   bent     a facet that is smooth with others: of a point C, the normal N
 *            there, DX, DY, DZ the normal at p is N + (p - C).x DX + ..
 *   turned   as tapered, one of several that a divided curve was turned into
 *   free     anything: its facets have the normals that they have
 *
 * What stands for no surface may be (a part of) a *named face*. Where two
 * different ones of all these meet and are not tangent is an *edge*, however
 * little they bend. They are tangent where they bend by no more than moving the
 * corners of both polygons by their segment's reach could bend them. Not
 * between surfaces that were turned together, nor along a straight line of a
 * tapered one: there parts of a transition go on in each other, whose facets
 * tell that only as well as they are fine.
 *
 * Source: placed normals: Turkowski 1990, Transformations of surface normal
 * vectors.
 */
#ifndef SG_KNOWN_SURFACE_H
#define SG_KNOWN_SURFACE_H

#include "rows/dense.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Degrees: the most that a bend between facets of one surface counts. A crease
 * angle below shows all facets. */
#define SG_FACET_BEND 1.0

/* Degrees: what bends by no more is flat, if nothing is known of it. */
#define SG_FLAT_BEND 0.01

typedef enum sg_known_surface_kind {
  SG_KNOWN_TAPERED,
  SG_KNOWN_TURNED,
  SG_KNOWN_SPHERE,
  SG_KNOWN_TORUS,
  SG_KNOWN_BEZIER,
  SG_KNOWN_BENT,
  SG_KNOWN_FREE
} sg_known_surface_kind;

typedef struct sg_known_surface {
  sg_known_surface_kind kind;
  double frame[16][3]; /* the centre, U, V and W; or as `kind` says */
  double unit;         /* a power of two that makes U, V, W at most 1 */
  double row[3][3];    /* times unit * (p - centre): the coordinates x, y, h */
  double a, b;
} sg_known_surface;

/* The surfaces of a model. All zero: none is known. */
typedef struct sg_known_surfaces {
  sg_known_surface *surface; /* [n] */
  size_t n;
  int32_t *of;   /* [polygons] the place of its surface; SG_NOT_KNOWN; less: of
                    its named face. Null: nothing is known of any */
  double *reach; /* [segments] how far a vertex may be from where it was meant,
                    of a scene; null elsewhere */
} sg_known_surfaces;

enum { SG_NOT_KNOWN = -1 };

/* How many points and vectors the frame of a kind has. */
static inline int
sg_known_surface_rows(sg_known_surface_kind kind)
{
  return kind == SG_KNOWN_BEZIER ? 16 : kind == SG_KNOWN_BENT ? 5 : 4;
}

/* A frame without volume makes the surface free. frame[rows][3] */
void sg_known_surface_init(sg_known_surface *surface,
                           sg_known_surface_kind kind, const double frame[][3],
                           double a, double b);

/* The surface where an affine map brings it: three rows A, B, C, D, the new x
 * is A*x + B*y + C*z + D. Inexact. */
void sg_known_surface_move(const sg_known_surface *surface,
                           const double map[3][4], sg_known_surface *out);

/* The unit normal at a point on the surface or near it, on the side of
 * `facet`, the normal of a facet there, of any length. False: it has none there
 * (an apex, an axis, a free one), or one so far from the facet's (78 degrees)
 * that this is no facet of it. Inexact. */
bool sg_known_surface_normal(const sg_known_surface *surface, const double p[3],
                             const double facet[3], double out[3]);

/* How far the surface is above a point near it, along the normal there. False:
 * it has none there, as above, or is a patch, a bent or a free one. Inexact, to
 * the square of how far that is. */
bool sg_known_surface_height(const sg_known_surface *surface, const double p[3],
                             const double facet[3], double *height);

/* The coordinates x, y, h of a point of the model, of one that is neither a
 * patch nor free. Inexact. */
void sg_known_surface_place(const sg_known_surface *surface, const double p[3],
                            double out[3]);

/* Whether facets of it are folded along straight lines. */
static inline bool
sg_known_surface_is_tapered(const sg_known_surface *surface)
{
  return surface->kind == SG_KNOWN_TAPERED || surface->kind == SG_KNOWN_TURNED;
}

/* Whether it is known how far it is from a point (sg_known_surface_height()).
 */
static inline bool
sg_known_surface_is_measured(const sg_known_surface *surface)
{
  return sg_known_surface_is_tapered(surface) ||
         surface->kind == SG_KNOWN_SPHERE || surface->kind == SG_KNOWN_TORUS;
}

/* Finds reach[] of these segments. False: no memory. */
bool sg_known_surfaces_find_reach(sg_known_surfaces *surfaces,
                                  const sg_dense *dense);

/* Two polygons that meet from `ends[0]` to `ends[1]`. */
typedef struct sg_facets_meeting {
  const sg_dense *dense;
  int32_t polygon[2];
  const double *normal[2]; /* of any length, both on one side of the sheet */
  const double *ends[2];
  double bend; /* of the polygons, in degrees */
} sg_facets_meeting;

/* The surface of a polygon, less than 0: of none. */
static inline int32_t
sg_known_surface_of(const sg_known_surfaces *surfaces, int32_t polygon)
{
  return surfaces->of ? surfaces->of[polygon] : SG_NOT_KNOWN;
}

/* How two polygons bend where they meet. */
typedef struct sg_bend {
  double degrees;
  bool edge;    /* different surfaces or named faces meet there, not tangent */
  bool tangent; /* a surface and another one, or a named face, meet there and
                   are tangent */
} sg_bend;

/* Degrees by which the surfaces of two polygons bend: not at all if they are
 * one, or one named face, as the walls of a prism that turns; else the larger
 * bend at the ends. What has no known surface is flat. No
 * less than what SG_FACET_BEND leaves of the bend of the polygons. Inexact. */
sg_bend sg_known_surfaces_bend(const sg_known_surfaces *surfaces,
                               const sg_facets_meeting *meeting);

void sg_known_surfaces_clear(sg_known_surfaces *surfaces);

#endif
