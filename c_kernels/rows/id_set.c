/* id_set.c -- see id_set.h. */
#include "id_set.h"

#include <stdlib.h>

enum { SPARSE = 256 }; /* more bits than this for an id are too many */

bool
sg_id_set_make(sg_id_set *set, const int32_t *id, size_t n)
{
  int32_t low = INT32_MAX, high = INT32_MIN;
  bool good = true;

  *set = (sg_id_set){.first = 0};
  sg_key_table_init(&set->table, 1);
  for (size_t i = 0; i < n; i++) {
    low = id[i] < low ? id[i] : low;
    high = id[i] > high ? id[i] : high;
  }
  size_t span = n > 0 ? (size_t)((int64_t)high - low + 1) : 0;

  if (span > SPARSE * n + (1 << 16)) {
    for (size_t i = 0; i < n && good; i++) {
      uint32_t key = (uint32_t)id[i];

      good = sg_key_table_add(&set->table, &key);
    }
    return good;
  }
  set->bits = calloc(span / 64 + 1, sizeof *set->bits);
  if (!set->bits) {
    return false;
  }
  set->first = low;
  set->span = span;
  for (size_t i = 0; i < n; i++) {
    size_t at = (size_t)((int64_t)id[i] - low);

    set->bits[at / 64] |= (uint64_t)1 << (at % 64);
  }
  return true;
}

void
sg_id_set_clear(sg_id_set *set)
{
  free(set->bits);
  sg_key_table_clear(&set->table);
  *set = (sg_id_set){.first = 0};
}
