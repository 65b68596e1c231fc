/* shell_copy.h -- shells of one segment that are there several times.
 *
 * Layer: kernel. A shell is what is connected by edges and polygons. Two are
 * equal if they have polygon for polygon the same edges and triangles, in the
 * same places, the same way round, and as real. A shell that has an edge of no
 * polygon is equal to none.
 *
 * Exact, and the same for any order of rows.
 */
#ifndef SG_SHELL_COPY_H
#define SG_SHELL_COPY_H

#include "rows/dense.h"

#include <stdbool.h>

typedef struct sg_shell_copies {
  bool any;   /* else nothing else is set */
  bool *gone; /* [vertices]: of a shell that has `most` equal ones before it,
                 by the smallest polygon */
} sg_shell_copies;

/* Of a segment that is alone in `dense`; most > 0.
 *
 * Returns: false: no memory, or the cancellation said stop.
 * Owner:   sg_shell_copies_clear() in any case.
 * Cost:    n log n of its edges and triangles. */
bool sg_shell_copies_find(const sg_dense *dense, size_t most,
                          const sg_cancel *cancel, sg_shell_copies *out);
void sg_shell_copies_clear(sg_shell_copies *copies);

#endif
