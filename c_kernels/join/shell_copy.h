/* shell_copy.h -- shells and polygons of one segment that are there several
 * times.
 *
 * Layer: kernel. Two polygons are equal if they have the same edges and
 * triangles, in the same places, the same way round, and as real. A shell is
 * what is connected by edges and polygons. Two are equal if they are so polygon
 * for polygon. A shell that has an edge of no polygon is equal to none.
 *
 * Exact, and the same for any order of rows.
 */
#ifndef SG_SHELL_COPY_H
#define SG_SHELL_COPY_H

#include "rows/dense.h"

#include <stdbool.h>

/* What is known of each polygon of a segment, by its place less that of the
 * first: */
typedef struct sg_shell_copies {
  bool any;         /* some are equal; else nothing else is set */
  uint32_t *kind;   /* equal where shells are equal: the first polygon of the
                       first of them */
  uint32_t *copy;   /* how many equal ones come before its shell */
  uint32_t *copies; /* how many equal ones there are, with its own */
} sg_shell_copies;

/* Of segment s (a place). Equal ones come in the order of their polygons: where
 * those of two are not all in one order, these are not equal here.
 *
 * Returns: false: no memory, or the cancellation said stop.
 * Owner:   sg_shell_copies_clear() in any case.
 * Cost:    n log n of its edges and triangles. */
bool sg_shell_copies_find(const sg_dense *dense, size_t s,
                          const sg_cancel *cancel, sg_shell_copies *out);

/* The same of polygons, each a shell of its own. Those without edges are
 * equal to none. */
bool sg_polygon_copies_find(const sg_dense *dense, size_t s,
                            const sg_cancel *cancel, sg_shell_copies *out);
void sg_shell_copies_clear(sg_shell_copies *copies);

#endif
