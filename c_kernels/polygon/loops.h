/* loops.h -- the closed chains in a set of directed edges.
 *
 * Layer: kernel. A polygon is an unordered SET of directed edges (p/3); its
 * loops are found by joining ends to starts.
 */
#ifndef SG_LOOPS_H
#define SG_LOOPS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct sg_loops {
  size_t room;
  int32_t *next;  /* [n] the edge that follows, or -1: none is left for it */
  int32_t *order; /* private: edges by start */
  size_t loops;   /* closed chains */
  size_t open;    /* edges that nothing follows */
} sg_loops;

/* Joins n edges from[i] -> to[i]. Where several edges leave a vertex, the one
 * that comes next in the arrays is taken first: lists written in order stay in
 * order. False: no memory. `loops` may be used again; start with {0}. */
bool sg_loops_make(sg_loops *loops, size_t n, const int32_t *from,
                   const int32_t *to);
void sg_loops_clear(sg_loops *loops);

#endif
