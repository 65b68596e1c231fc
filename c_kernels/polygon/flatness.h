/* flatness.h -- how far off its plane a polygon may be and still be one face.
 *
 * Layer: kernel. Inexact. The tolerance is the larger of 2^-33 of the model's
 * size, made a power of two (upwards, so that an edit seldom changes it), and 4
 * units in the last place of its source. What the source
 * was is seen from the coordinates: they are all single precision numbers, or
 * all decimals with a few places; but not if all are whole, or have so few bits
 * that they may be exact.
 */
#ifndef SG_FLATNESS_H
#define SG_FLATNESS_H

#include "column.h"

#include <stdbool.h>

typedef struct sg_flatness {
  double low[3], high[3], largest;
  bool any;
  bool single; /* all are single precision numbers */
  bool fine;   /* and some have so many bits that it is no chance */
  int places;  /* decimal places, or more than SG_PLACES: not decimals */
} sg_flatness;

enum { SG_PLACES = 9 };

/* Of all vertices in a view of v/5: init, then every page. */
void sg_flatness_init(sg_flatness *out);
void sg_flatness_see(sg_flatness *model, const double point[3]);
void sg_flatness_page(sg_flatness *model, const sg_view *v, size_t page);
double sg_flatness_tolerance(const sg_flatness *model); /* model units */

/* The longest side of the box. */
double sg_flatness_size(const sg_flatness *model);

/* The two parts of it: from the size, and from the source. */
double sg_flatness_of_size(const sg_flatness *model);
double sg_flatness_of_source(const sg_flatness *model);

/* Makes *model as large as both; sources are not joined. */
void sg_flatness_enlarge(sg_flatness *model, const sg_flatness *other);

#endif
