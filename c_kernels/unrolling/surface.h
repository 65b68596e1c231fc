/* surface.h -- the smooth surfaces that primitives stand for, as equations.
 *
 * Layer: kernel. With E = cos(t)*u + sin(t)*v, the point (t, h) is
 *
 *   cylinder  c + E + h*w
 *   cone      c + (1-h+h*k)*E + h*w
 *   ruled     c + cos(t)*(1-h+h*k)*u + sin(t)*(1-h+h*k2)*v + h*w
 *   sphere    c + cos(h)*E + sin(h)*w
 *   torus     c + (1+k*cos(h))*E + k*sin(h)*w
 *   fan       c + (1-h+h*k)*t*u + h*v: flat, between generators; w is not used
 *   plane     all X with plane . (X, 1) = 0; no parameters
 *
 * u, v, w may be any three vectors that do not lie in a plane (of a fan u and v
 * any two that are not parallel), so right, oblique and elliptic ones are the
 * same. t in radians. Rounded; a surface has
 * no borders here (a cylinder goes on for ever).
 *
 * With `offset` a cylinder or cone is the surface parallel to it, so far
 * outside (negative: within): what the equation gives, moved along the normal,
 * which is the same all along a generator. Its h is again the coordinate along
 * w: (t, h) is where the moved generator has that. It is known where it is
 * nearest to the generator at t, so not beyond its centres of curvature.
 *
 * Source: rules/primitive/primitive_face.pl; parallel surfaces of developable
 * ones: do Carmo, Differential geometry of curves and surfaces, 3-5 (exercise
 * 11).
 */
#ifndef SG_SURFACE_H
#define SG_SURFACE_H

#include <stdbool.h>
#include <stddef.h>

typedef enum sg_surface_kind {
  SG_SURFACE_PLANE,
  SG_SURFACE_CYLINDER,
  SG_SURFACE_CONE,
  SG_SURFACE_RULED,
  SG_SURFACE_SPHERE,
  SG_SURFACE_TORUS,
  SG_SURFACE_FAN
} sg_surface_kind;

enum { SG_SURFACES_MOST = 3 }; /* that sg_surfaces_meet() takes */

typedef struct sg_surface {
  sg_surface_kind kind;
  double c[3], u[3], v[3], w[3];
  double k, k2;
  double offset;        /* of a cylinder or cone, model units; else 0 */
  double plane[4];      /* a plane's, the rest is not used then; or a fan's */
  double inverse[3][3]; /* rows: the coordinates along u, v, w */
} sg_surface;

/* Fills `inverse` (of a plane: makes its normal a unit; of a fan: fills
 * `plane`) from the rest. Returns: false if u, v, w lie in a plane, or the
 * normal is 0.
 */
bool sg_surface_init(sg_surface *surface);

/* How far x is from the surface, to first order, negative inside (below a
 * plane), and the unit normal there, outward. False where there is none, as on
 * an axis. */
bool sg_surface_value(const sg_surface *surface, const double x[3],
                      double *value, double normal[3]);

/* t (-pi..pi) and h of the point of the surface that x is taken to: along the
 * surface's own direction of growing E, at the same h. On the surface it is x.
 * A point on the axis has t = 0. Not for planes, spheres and tori. */
void sg_surface_place(const sg_surface *surface, const double x[3], double *t,
                      double *h);

/* The point (t, h). Not for planes. */
void sg_surface_point(const sg_surface *surface, double t, double h,
                      double out[3]);

/* Of a point (t, h) of a surface with an offset, the h of the point that it was
 * moved from; h itself where there is none. */
double sg_surface_before(const sg_surface *surface, double t, double h);

/* Moves x, by the shortest steps, to where n surfaces (1..SG_SURFACES_MOST)
 * meet: Newton's, with the step of least length. Exact to some roundings of
 * the coordinates; where two of them are nearly tangent, to 1e-10 of them.
 * Returns: false if it does not come to rest within 60 steps, or goes farther
 * than `reach`, or two of them touch there; x is as it was then. */
bool sg_surfaces_meet(const sg_surface *const *surface, size_t n, double reach,
                      double x[3]);

#endif
