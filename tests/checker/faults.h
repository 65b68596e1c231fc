/* faults.h -- what is wrong with a mesh, and its measures, for the checker. */
#ifndef SG_CHECKER_FAULTS_H
#define SG_CHECKER_FAULTS_H

#include "soup.h"

#include <stdio.h>

typedef struct faults {
  /* Edges by their uses in both directions. */
  size_t edges;
  size_t open;       /* used an odd number of times */
  size_t unbalanced; /* not as often one way as the other */
  size_t shared;     /* balanced, of more than two triangles */
  size_t pinched;    /* vertices whose triangles are more than one fan */
  size_t zero_area;  /* triangles, exactly */
  /* Pairs of triangles by what they have in common (meeting.h), exactly. */
  size_t meeting[5];
  long euler;        /* vertices - edges + triangles */
  size_t components; /* connected over edges */
  size_t misturned;  /* of them: not the boundary between 0 and 1 */
  double volume, area;
} faults;

void faults_of_edges(faults *f, const soup *s);
/* Prints each pair that has something in common to `out`, unless it is null. */
void faults_of_pairs(faults *f, const soup *s, FILE *out);
void measures_of(faults *f, const soup *s);

/* Requires faults_of_edges() before. Rounded: solid angles. */
void faults_of_turning(faults *f, const soup *s);

#endif
