/* id_set.h -- a set of ids of one segment.
 *
 * Layer: kernel. A row of bits while the ids are close together, else a table.
 *
 *   sg_id_set set;
 *   if (!sg_id_set_make(&set, id, n)) no_memory();
 *   if (sg_id_set_has(&set, 7)) ...
 *   sg_id_set_clear(&set);
 */
#ifndef SG_ID_SET_H
#define SG_ID_SET_H

#include "key_table.h"

#include <stdbool.h>

typedef struct sg_id_set {
  int32_t first;
  size_t span;    /* bits; 0: the table holds them */
  uint64_t *bits; /* [span / 64 + 1] */
  sg_key_table table;
} sg_id_set;

/* Of n ids, in any order. False: no memory; clear it in any case. What is all 0
 * may be cleared too. */
bool sg_id_set_make(sg_id_set *set, const int32_t *id, size_t n);
void sg_id_set_clear(sg_id_set *set);

static inline bool
sg_id_set_has(const sg_id_set *set, int32_t id)
{
  size_t at = (size_t)((int64_t)id - set->first); /* below first: huge */

  if (at < set->span) {
    return (set->bits[at / 64] >> (at % 64)) & 1;
  }
  uint32_t key = (uint32_t)id;

  return set->table.n > 0 && sg_key_table_get(&set->table, &key) != SG_NO_KEY;
}

#endif
