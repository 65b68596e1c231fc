/* pattern_rows.h -- what a model is: all segments but the patterns made of
 * them.
 *
 * Layer: rows. Drawing, checking and the tolerance of a model leave
 * developments aside.
 */
#ifndef SG_PATTERN_ROWS_H
#define SG_PATTERN_ROWS_H

#include "engine/store.h"

typedef struct sg_model_view {
  sg_view shown; /* what is to be looked at */
  sg_view whole; /* private */
  bool parted;   /* private: there are patterns */
} sg_model_view;

/* The rows of a relation (column 0 is the segment) in a version that are of no
 * segment of kind pattern. False: no memory. Owner: sg_model_view_clear() in
 * any case, before the version is dropped. */
bool sg_model_view_make(const sg_version *version, sg_relation relation,
                        sg_model_view *out);
void sg_model_view_clear(sg_model_view *view);

#endif
