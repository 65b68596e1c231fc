/* ids.h -- arrays of ids in order.
 *
 * Layer: kernel.
 */
#ifndef SG_IDS_H
#define SG_IDS_H

#include <stddef.h>
#include <stdint.h>

/* Ascending, for qsort() and bsearch(). */
int sg_compare_ids(const void *a, const void *b);
/* Sorts n ids and keeps each once; how many are left. */
size_t sg_sort_ids(int32_t *id, size_t n);
/* The place of an id among n ascending ones; SIZE_MAX: it has none. */
size_t sg_find_id(const int32_t *id, size_t n, int32_t wanted);

#endif
