/* development_rows.h -- a segment being laid flat: what a handle of
 * flattening_open/4 owns.
 *
 * Layer: rows. Its doors are documented in rules/kernel/pattern.pl.
 */
#ifndef SG_DEVELOPMENT_ROWS_H
#define SG_DEVELOPMENT_ROWS_H

#include "call.h"
#include "lay.h"

typedef struct sg_development {
  int32_t s; /* the segment */
  sg_dense dense;
  sg_flat_faces faces;
  sg_joints joints;
  sg_flattening flattening;
  sg_layout layout; /* once it is laid out */
  bool laid;
  double tolerance;
} sg_development;

/* Null: nothing. */
void sg_development_free(sg_development *d);

/* permission_error(lay, flattening, Flattening), the first argument, if nothing
 * is laid out yet. */
bool sg_development_is_laid(sg_call *call, const sg_development *d);

/* The place of joint j, from 1: existence_error(joint, j), argument `argument`.
 */
bool sg_development_joint(sg_call *call, const sg_development *d, int32_t j,
                          int argument, uint32_t *out);

/* The joints that are joined on the way between two faces. */
bool sg_development_path(sg_call *call, sg_development *d, uint32_t from,
                         uint32_t to, sg_int_list *joints);

/* The id of the polygon of the pattern that a face becomes: that of its
 * polygon, or one after the largest where that is in triangles. */
int32_t sg_development_polygon(const sg_development *d, uint32_t face);

/* The id of the edge that a side is; of a chord one after the largest. */
int32_t sg_development_edge(const sg_development *d, uint32_t side);

#endif
