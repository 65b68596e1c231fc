/* self_shape.h -- sizes and places of what two triangles of one segment have in
 * common, in doubles: they name and show what exact signs have found.
 *
 * Layer: kernel, private to self_pair.c. Inexact.
 */
#ifndef SG_SELF_SHAPE_H
#define SG_SELF_SHAPE_H

#include "cut.h"
#include "self_pair.h"

/* To length 1, if it has one. */
void sg_shape_normalise(double v[3]);

/* Not of unit length. */
void sg_shape_normal(const double t[3][3], double out[3]);

/* How far a corner of triangle a is above and below the plane of b. */
typedef struct sg_depth {
  double above, below; /* >= 0 */
} sg_depth;
sg_depth sg_shape_depth(const double a[3][3], const double b[3][3]);

/* Of two triangles in about one plane, how far one would have to move for them
 * not to overlap; 0: they do not. */
double sg_shape_overlap(const double a[3][3], const double b[3][3]);

/* Where an end of a cut of a and b is. */
void sg_shape_end(const double a[3][3], const double b[3][3],
                  const sg_cut_end *end, double out[3]);

/* Whether `at` is within the tolerance of an edge or a vertex that both
 * polygons (places) have. */
bool sg_shape_is_shared(const sg_self_model *model, const int32_t polygon[2],
                        const double at[3]);

#endif
