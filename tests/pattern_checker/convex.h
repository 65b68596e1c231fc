/* convex.h -- the polygons and tabs of a pattern in convex parts. */
#ifndef SG_PATTERN_CHECKER_CONVEX_H
#define SG_PATTERN_CHECKER_CONVEX_H

#include "pattern.h"
#include "shapes.h"

typedef struct part {
  real (*corner)[2]; /* [count], counter-clockwise */
  size_t count;
  size_t owner; /* a polygon of the pattern; a tab, behind the polygons */
} part;

typedef struct parts {
  part *part;
  size_t n;
  size_t most; /* corners of any two of them together, at most */
} parts;

/* A polygon that is convex is one part; another is divided at the heights of
 * all its corners. Owner: parts_clear(). */
void parts_of_pattern(const pattern *p, parts *out);

void parts_clear(parts *ps);

#endif
