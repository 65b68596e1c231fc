/* key_table.h -- a hash table from short keys of words to numbers.
 *
 * Layer: kernel. Keys are 1..6 words of 32 bits; nothing is ever deleted. What
 * a caller sees never depends on the order of the table: it only answers.
 *
 *   sg_key_table table;
 *   sg_key_table_init(&table, 2);
 *   uint32_t *number = sg_key_table_put(&table, (uint32_t[2]){s, v});
 *   if (*number == SG_NO_KEY) *number = fresh;   // it was not there
 *   sg_key_table_clear(&table);
 */
#ifndef SG_KEY_TABLE_H
#define SG_KEY_TABLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { SG_KEY_WORDS = 6 };
#define SG_NO_KEY UINT32_MAX

typedef struct sg_key_table {
  unsigned words;
  size_t n, room; /* room: a power of two, or 0 */
  uint32_t *slot; /* [room][words + 1]: the number last; all ones: free */
} sg_key_table;

void sg_key_table_init(sg_key_table *table, unsigned words);
void sg_key_table_clear(sg_key_table *table);

/* Forgets all keys. A table of more than `most` slots gives back its memory. */
void sg_key_table_empty(sg_key_table *table, size_t most);

/* Room for n keys in all, so that it need not grow. False: no memory. */
bool sg_key_table_reserve(sg_key_table *table, size_t n);

/* Has the place of a key read from memory while something else is done: for
 * large tables whose next keys are known. */
void sg_key_table_fetch(const sg_key_table *table, const uint32_t *key);

/* The number of a key, SG_NO_KEY if it is not there. */
uint32_t sg_key_table_get(const sg_key_table *table, const uint32_t *key);

/* Where the number of a key stands, null if it is not there. Valid until the
 * next put. */
uint32_t *sg_key_table_find(const sg_key_table *table, const uint32_t *key);

/* Where the number of a key stands; a new key starts with SG_NO_KEY and must
 * be given another number. Valid until the next put. Null: no memory. */
uint32_t *sg_key_table_put(sg_key_table *table, const uint32_t *key);

/* Puts a key of a set: its number does not matter, and is 1. False: no memory.
 */
bool sg_key_table_add(sg_key_table *table, const uint32_t *key);

#endif
