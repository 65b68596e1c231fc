#include "key_table.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

void
sg_key_table_init(sg_key_table *table, unsigned words)
{
  assert(words >= 1 && words <= SG_KEY_WORDS);
  *table = (sg_key_table){words, 0, 0, NULL};
}

void
sg_key_table_clear(sg_key_table *table)
{
  free(table->slot);
  *table = (sg_key_table){table->words, 0, 0, NULL}; /* all 0 may be cleared */
}

void
sg_key_table_empty(sg_key_table *table, size_t most)
{
  if (table->room > most) {
    sg_key_table_clear(table);
  } else if (table->n > 0) {
    memset(table->slot, 0xff,
           table->room * (table->words + 1) * sizeof *table->slot);
    table->n = 0;
  }
}

/* The functions of one key are compiled for each number of words: a loop of a
 * known length is none. */
#define EACH inline __attribute__((always_inline))

static EACH uint32_t
hash_of(const uint32_t *key, unsigned words)
{
  uint64_t h = 0x9e3779b97f4a7c15u;

  for (unsigned i = 0; i < words; i += 2) { /* two words at once */
    uint64_t high = i + 1 < words ? key[i + 1] : 0;

    h = (h ^ (high << 32 | key[i])) * 0xff51afd7ed558ccdu;
    h ^= h >> 32;
  }
  return (uint32_t)(h * 0xc4ceb9fe1a85ec53u >> 32); /* round doubles differ in
                                                       high bits only */
}

static EACH bool
is_key(const uint32_t *slot, const uint32_t *key, unsigned words)
{
  uint32_t differ = 0;

  for (unsigned i = 0; i < words; i++) {
    differ |= slot[i] ^ key[i];
  }
  return differ == 0;
}

static EACH uint32_t *
find_of(const sg_key_table *table, const uint32_t *key, unsigned words)
{
  size_t mask = table->room - 1, stride = words + 1;

  for (size_t i = hash_of(key, words) & mask;; i = (i + 1) & mask) {
    uint32_t *slot = table->slot + i * stride;

    if (slot[words] == SG_NO_KEY || is_key(slot, key, words)) {
      return slot;
    }
  }
}

/* The slot of this key, or the free one where it would stand. */
static uint32_t *
find(const sg_key_table *table, const uint32_t *key)
{
  switch (table->words) {
  case 1:
    return find_of(table, key, 1);
  case 2:
    return find_of(table, key, 2);
  case 3:
    return find_of(table, key, 3);
  case 4:
    return find_of(table, key, 4);
  case 5:
    return find_of(table, key, 5);
  default:
    return find_of(table, key, SG_KEY_WORDS);
  }
}

/* Makes it a table of `room` slots, which are enough. */
static int
grow_to(sg_key_table *table, size_t room)
{
  size_t stride = table->words + 1;
  sg_key_table bigger = {table->words, table->n, room, NULL};

  bigger.slot = malloc(room * stride * sizeof *bigger.slot);
  if (!bigger.slot) {
    return 0;
  }
  memset(bigger.slot, 0xff, room * stride * sizeof *bigger.slot);
  for (size_t i = 0; i < table->room; i++) {
    const uint32_t *old = table->slot + i * stride;

    if (old[table->words] != SG_NO_KEY) {
      memcpy(find(&bigger, old), old, stride * sizeof *old);
    }
  }
  free(table->slot);
  *table = bigger;
  return 1;
}

static int
grow(sg_key_table *table)
{
  return grow_to(table, table->room ? 2 * table->room : 64);
}

bool
sg_key_table_reserve(sg_key_table *table, size_t n)
{
  size_t room = table->room ? table->room : 64;

  while (room < 2 * n) {
    room *= 2;
  }
  return room == table->room || grow_to(table, room);
}

void
sg_key_table_fetch(const sg_key_table *table, const uint32_t *key)
{
  if (table->room) {
    size_t at = hash_of(key, table->words) & (table->room - 1);
    const uint32_t *slot = table->slot + at * (table->words + 1);

    __builtin_prefetch(slot);
    __builtin_prefetch(slot + table->words);
  }
}

uint32_t
sg_key_table_get(const sg_key_table *table, const uint32_t *key)
{
  return table->room ? find(table, key)[table->words] : SG_NO_KEY;
}

uint32_t *
sg_key_table_find(const sg_key_table *table, const uint32_t *key)
{
  uint32_t *number = table->room ? find(table, key) + table->words : NULL;

  return number && *number != SG_NO_KEY ? number : NULL;
}

uint32_t *
sg_key_table_put(sg_key_table *table, const uint32_t *key)
{
  if (2 * (table->n + 1) > table->room && !grow(table)) {
    return NULL;
  }
  uint32_t *slot = find(table, key);

  if (slot[table->words] == SG_NO_KEY) {
    for (unsigned i = 0; i < table->words; i++) {
      slot[i] = key[i];
    }
    table->n++;
  }
  return slot + table->words;
}

bool
sg_key_table_add(sg_key_table *table, const uint32_t *key)
{
  uint32_t *number = sg_key_table_put(table, key);

  if (number) {
    *number = 1;
  }
  return number != NULL;
}
