/* sort.h -- a stable sort that can be stopped; and a fast one of numbers.
 *
 * Layer: kernel. qsort() of a million records cannot be interrupted.
 */
#ifndef SG_SORT_H
#define SG_SORT_H

#include "engine/cancel.h"
#include "engine/search.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum sg_sort_end {
  SG_SORTED,
  SG_SORT_STOPPED, /* in an order of its own, nothing lost */
  SG_SORT_NO_MEMORY
} sg_sort_end;

typedef int sg_sort_compare(const void *a, const void *b);

/* What is sorted already is only looked at. */
sg_sort_end sg_sort(void *base, size_t n, size_t size, sg_sort_compare *compare,
                    const sg_cancel *cancel);

/* A number, and what it is of. */
typedef struct sg_measured {
  double value; /* no NaN */
  uint32_t of;
} sg_measured;

/* Sorts n items by value, equal ones as they stood (-0.0 is 0.0 then). Digit
 * by digit: takes time by n. */
sg_sort_end sg_sort_measured(sg_measured *item, size_t n,
                             const sg_cancel *cancel);

/* Sorts n keys by their upper halves, equal ones as they stood: by three
 * digits. False: no memory. */
bool sg_sort_upper(uint64_t *key, size_t n);

#endif
