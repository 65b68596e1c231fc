/* view.h -- from the model to the picture: PL-11 and PL-12.
 *
 * Layer: kernel. The eye stands at (rho, theta, phi), spherical, in degrees,
 * phi from +z, and looks at the origin. In the picture x runs to the right, y
 * up and z AWAY from the eye: a left-handed system, in which what is
 * counter-clockwise from outside is counter-clockwise when it faces the eye.
 *
 * Source: [PL] section 6.1, 6.2.
 */
#ifndef SG_VIEW_H
#define SG_VIEW_H

#include <stdbool.h>

/* The rows are whole numbers of 2^-30, and so not quite unit and at right
 * angles: what is seen is that matrix times a point, exactly. */
typedef struct sg_eye {
  double row[3][3]; /* right, up, away */
  double rho;       /* model units */
} sg_eye;

/* The smallest and largest distance from the eye, along its line of sight. */
typedef struct sg_range {
  double nearest, farthest; /* the paper's D and F */
} sg_range;

/* Sine and cosine; multiples of 90 degrees are exact, the rest is rounded to
 * 2^-48, so that the same picture comes out on every machine. */
void sg_sine_cosine(double degrees, double *sine, double *cosine);

void sg_eye_init(sg_eye *eye, double theta, double phi, double rho);

/* (Xe, Ye, Ze - rho) of a model point: the eye's coordinates, with depth
 * counted from the origin (the paper's parallel projection). The products
 * with the rows of the eye, rounded once: exact up to 2^-100 of their terms,
 * then the nearest double (where nothing underflows). */
void sg_eye_point(const sg_eye *eye, const double p[3], double out[3]);

/* An empty range, and the range that also holds depth (Ze - rho). */
sg_range sg_range_empty(void);
void sg_range_add(sg_range *range, const sg_eye *eye, double depth);

/* True if everything is in front of the eye: D > 0. */
bool sg_range_is_visible(const sg_range *range);

/* True if the model has no depth worth the name (D = F up to rounding): then
 * every Zs of a central projection is 0. */
bool sg_range_is_flat(const sg_range *range);

/* Central projection of a point of sg_eye_point(), in place, with S = 1: depth
 * 0 at D, 1 at F, linear along lines and planes of the picture.
 * Requires: sg_range_is_visible(range). */
void sg_central_point(const sg_eye *eye, const sg_range *range, double p[3]);

/* What one unit of Zs is in model units, at the nearest point. */
double sg_central_depth(const sg_range *range);

#endif
