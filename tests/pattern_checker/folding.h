/* folding.h -- folded back along its folds, is the pattern the solid again? */
#ifndef SG_PATTERN_CHECKER_FOLDING_H
#define SG_PATTERN_CHECKER_FOLDING_H

#include "pattern.h"
#include "shapes.h"

/* Lays the largest polygon of each piece into its place in the solid, folds
 * all others to it, by the angles alone, longest folds first, and returns the
 * most that a corner is off its place, next to the solid's size. Polygons that
 * no fold reaches are infinitely far off. */
real fold_back(const pattern *p);

#endif
