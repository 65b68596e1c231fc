/* keys.h -- sorted arrays of records that begin with (segment, id).
 *
 * Layer: kernel. Ids are mostly dense, so a find tries the place that the last
 * one predicts before it searches.
 */
#ifndef SG_KEYS_H
#define SG_KEYS_H

#include "engine/search.h"

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#define SG_NOWHERE SIZE_MAX

typedef struct sg_keys {
  const void *base;
  size_t size, n;
  size_t place; /* of the last find */
} sg_keys;

static inline int64_t
sg_key_of(const void *record)
{
  int32_t k[2];

  memcpy(k, record, sizeof k);
  return (int64_t)k[0] * ((int64_t)1 << 32) + k[1];
}

static inline int
sg_key_compare(const void *a, const void *b)
{
  int64_t x = sg_key_of(a), y = sg_key_of(b);

  return (x > y) - (x < y);
}

static inline const void *
sg_keys_at(const sg_keys *keys, size_t i)
{
  return (const char *)keys->base + i * keys->size;
}

/* The first record with this key, or SG_NOWHERE. */
static inline size_t
sg_keys_find(sg_keys *keys, int32_t s, int32_t id)
{
  int32_t pair[2] = {s, id};
  int64_t key = sg_key_of(pair);
  size_t at;

  if (keys->place < keys->n) {
    int64_t step = key - sg_key_of(sg_keys_at(keys, keys->place));
    int64_t guess = (int64_t)keys->place + step;
    if (guess >= 0 && (uint64_t)guess < keys->n &&
        sg_key_of(sg_keys_at(keys, (size_t)guess)) == key &&
        (guess == 0 || sg_key_of(sg_keys_at(keys, (size_t)guess - 1)) != key)) {
      return keys->place = (size_t)guess;
    }
  }
  SG_SEARCH(at, 0, keys->n, sg_key_of(sg_keys_at(keys, at)) < key);
  if (at == keys->n || sg_key_of(sg_keys_at(keys, at)) != key) {
    return SG_NOWHERE;
  }
  return keys->place = at;
}

#endif
