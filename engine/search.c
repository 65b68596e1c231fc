/* search.c -- see search.h. */
#include "search.h"

#include <stdlib.h>

int
sg_compare_ids(const void *a, const void *b)
{
  int32_t x = *(const int32_t *)a, y = *(const int32_t *)b;

  return (x > y) - (x < y);
}

int
sg_compare_numbers(const void *a, const void *b)
{
  uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;

  return (x > y) - (x < y);
}

int
sg_compare_keys(const void *a, const void *b)
{
  uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;

  return (x > y) - (x < y);
}

size_t
sg_sort_ids(int32_t *id, size_t n)
{
  size_t kept = 0;

  size_t first = 1; /* that is less than the one before it */

  while (first < n && id[first - 1] <= id[first]) {
    first++;
  }
  if (first < n) {
    qsort(id, n, sizeof *id, sg_compare_ids);
  }
  for (size_t i = 0; i < n; i++) {
    if (kept == 0 || id[kept - 1] != id[i]) {
      id[kept++] = id[i];
    }
  }
  return kept;
}

size_t
sg_find_id(const int32_t *id, size_t n, int32_t wanted)
{
  size_t place = sg_first_id(id, n, sizeof *id, wanted);

  return place < n && id[place] == wanted ? place : SIZE_MAX;
}
