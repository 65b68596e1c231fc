/* sort.h -- a stable sort that can be stopped.
 *
 * Layer: kernel. qsort() of a million records cannot be interrupted.
 */
#ifndef SG_SORT_H
#define SG_SORT_H

#include "poll.h"

#include <stddef.h>

typedef enum sg_sort_end {
  SG_SORTED,
  SG_SORT_STOPPED, /* in an order of its own, nothing lost */
  SG_SORT_NO_MEMORY
} sg_sort_end;

typedef int sg_sort_compare(const void *a, const void *b);

/* What is sorted already is only looked at. */
sg_sort_end sg_sort(void *base, size_t n, size_t size, sg_sort_compare *compare,
                    const sg_poll *poll);

#endif
