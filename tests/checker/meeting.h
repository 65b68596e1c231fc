/* meeting.h -- what two triangles have in common, exactly. */
#ifndef SG_CHECKER_MEETING_H
#define SG_CHECKER_MEETING_H

#include <stdbool.h>

/* What they have beside the corners they share, and the edge between two such
 * corners. From harmless to bad. */
typedef enum meeting {
  APART,    /* nothing */
  IN_POINT, /* a point that is not a corner of both */
  IN_LINE,  /* a segment that is in an edge of one of them */
  CROSSING, /* a segment inside both */
  OVERLAP   /* an area: they are in one plane */
} meeting;

/* Requires: no triangle of no area; the first `shared` corners of both are in
 * the same places, no others are. Exact. */
meeting meeting_of(const double *p[3], const double *q[3], int shared);

/* True if the corners are on one line. Exact. */
bool has_no_area(const double *p[3]);

#endif
