/* flatness.h -- how far off a place may be that is meant to be there.
 *
 * Layer: kernel. Inexact. What is known of a model is where its numbers come
 * from; nothing is guessed from what they are. Doubles are exact up to their
 * last places, which turning and moving rounds: what is nearer than 2^-44 of
 * the farthest coordinate (256 units in the last place), made a power of two
 * (upwards, so that an edit seldom changes it), is one place. A source that was
 * rounded, as float32 or decimals, says how large a unit in its last place is:
 * its grain. What was one place before is less than a grain apart, and what is
 * a grain apart the source can tell apart.
 */
#ifndef SG_FLATNESS_H
#define SG_FLATNESS_H

#include "engine/column.h"

#include <stdbool.h>

typedef struct sg_flatness {
  double low[3], high[3], largest;
  double grain; /* of the coarsest source, model units; 0: doubles */
  bool any;
} sg_flatness;

/* Of all vertices in a view of v/5: init, then every page. */
void sg_flatness_init(sg_flatness *out, double grain);
void sg_flatness_see(sg_flatness *model, const double point[3]);
void sg_flatness_page(sg_flatness *model, const sg_view *v, size_t page);

/* What is nearer is in one place, model units. */
double sg_flatness_touch(const sg_flatness *model);

/* What turning and moving doubles rounds: 2^-48 of the farthest coordinate (16
 * units in the last place). What is moved farther is told. */
double sg_flatness_rounding(const sg_flatness *model);

/* How far apart one place may be by its source: by that, or by the grain. What
 * is farther apart and yet made to touch is a gap of the model. */
double sg_flatness_explained(const sg_flatness *model);

/* The same of n places from a source of this grain. */
double sg_flatness_touch_of(const double (*at)[3], size_t n, double grain);

/* A polygon whose vertices are no farther off its plane is one face: 2^-33 of
 * the model's size, or two grains. This moves nothing. */
double sg_flatness_flat(const sg_flatness *model);

/* One unit in the last place of float32 numbers up to this one. */
double sg_flatness_single(double largest);

/* The longest side of the box. */
double sg_flatness_size(const sg_flatness *model);

/* Makes *model as large, and as coarse, as both. */
void sg_flatness_join(sg_flatness *model, const sg_flatness *other);

#endif
