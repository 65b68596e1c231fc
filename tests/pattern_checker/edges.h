/* edges.h -- is every edge of the solid a fold, a seam with its two sides, or a
 * border, and are the pieces connected by folds? */
#ifndef SG_PATTERN_CHECKER_EDGES_H
#define SG_PATTERN_CHECKER_EDGES_H

#include "pattern.h"
#include "shapes.h"

typedef struct edge_faults {
  size_t lost; /* edges of the solid that the pattern has not, or not whole */
  size_t unpaired; /* sides that have no joint and are no border */
  size_t mismatch; /* joints of sides that were not one edge, folds of sides
                    * that lie apart */
  size_t cut;      /* pieces that are not connected, or are by more than one
                    * number */
  size_t loose;    /* sides of no polygon or of two, in two joints */
  real seam;       /* the length of all seams, each once */
  real tree;       /* of the shortest tree of the solid's edges: what a seam
                    * must have where no point is flat */
  real angle;      /* the most an angle moves the narrower side of its joint,
                    * next to the solid's size */
  size_t folds, seams, lines, borders;
} edge_faults;

void check_edges(const pattern *p, edge_faults *out);

/* Sets of items that are connected: each item's way to the first of its set. */
int *sets_of(size_t n);
int set_of(int *sets, int item);
/* False: they were of one set already. */
bool join_sets(int *sets, int a, int b);

#endif
