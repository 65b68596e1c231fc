/* overlap.h -- do polygons of the pattern, or tabs, lie on each other? */
#ifndef SG_PATTERN_CHECKER_OVERLAP_H
#define SG_PATTERN_CHECKER_OVERLAP_H

#include "pattern.h"
#include "shapes.h"

/* What two have in common is as deep as its narrowest width. */
typedef struct overlap_faults {
  real face, tab;     /* the deepest of two polygons; of a tab and any other */
  size_t faces, tabs; /* how many pairs are deeper than what is let be */
} overlap_faults;

/* Finds all pairs; `least` is what is let be. Pairs go to `tell`, if any. */
void check_overlaps(const pattern *p, real least, FILE *tell,
                    overlap_faults *out);

#endif
