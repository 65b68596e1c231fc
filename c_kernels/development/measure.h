/* measure.h -- how good a development is.
 *
 * Layer: kernel. Inexact.
 */
#ifndef SG_MEASURE_H
#define SG_MEASURE_H

#include "lay.h"

typedef struct sg_measures {
  double seam;    /* length of all seams, each once; model units */
  double longest; /* weld: seams end to end between vertices where not just two
                     seams meet */
  double area;    /* of the pieces */
  double sheet;   /* of the box round all pieces, as they lie */
} sg_measures;

/* What lies as in `layout`. False: no memory, or (*stopped) stopped. */
bool sg_measure(const sg_flattening *flattening, const sg_layout *layout,
                const sg_cancel *cancel, sg_measures *out, bool *stopped);

#endif
