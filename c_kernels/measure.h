/* measure.h -- how good a development is.
 *
 * Layer: kernel. Inexact.
 *
 * No pattern can have less seam than the *tree*, the minimum spanning tree of
 * the vertices over the edges, if every vertex inside is pointed (its angles
 * sum to less than a whole turn): then each must be on a seam, and seams that
 * do not hang together, or with the border, would go round a hole of a piece,
 * inside of which the angles would have to sum to whole turns. Elsewhere, where
 * a vertex is flat or a saddle, seams may pass it by, and nothing is proven.
 */
#ifndef SG_MEASURE_H
#define SG_MEASURE_H

#include "lay.h"

typedef struct sg_measures {
  double seam;    /* length of all seams, each once; model units */
  double longest; /* weld: seams end to end between vertices where not just two
                     seams meet */
  double area;    /* of the pieces */
  double boxes;   /* of the boxes round the pieces */
  double tree;    /* see above; borders are one vertex */
  bool pointed;   /* whether the tree is a lower bound */
} sg_measures;

/* What lies as in `layout`. False: no memory, or (*stopped) stopped. */
bool sg_measure(const sg_flattening *flattening, const sg_layout *layout,
                const sg_poll *poll, sg_measures *out, bool *stopped);

#endif
