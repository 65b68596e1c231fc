/* ids.h -- arrays of ids in order.
 *
 * Layer: kernel.
 */
#ifndef SG_IDS_H
#define SG_IDS_H

#include <stddef.h>
#include <stdint.h>

/* The place of the first of n records of `size` bytes whose id, with which each
 * begins, is not less than this one. The records ascend by it. */
static inline size_t
sg_first_id(const void *record, size_t n, size_t size, int32_t id)
{
  size_t low = 0, high = n;

  while (low < high) {
    size_t middle = (low + high) / 2;
    const void *at = (const char *)record + middle * size;

    if (*(const int32_t *)at < id) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

/* Ascending, for qsort() and bsearch(). */
int sg_compare_ids(const void *a, const void *b);
/* Sorts n ids and keeps each once; how many are left. */
size_t sg_sort_ids(int32_t *id, size_t n);
/* The place of an id among n ascending ones; SIZE_MAX: it has none. */
size_t sg_find_id(const int32_t *id, size_t n, int32_t wanted);

#endif
