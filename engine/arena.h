/* arena.h -- memory for lists and terms: taken in a row, given back one by one.
 *
 * Layer: store. A piece costs its own bytes and nothing else; a block returns
 * to the system when its last piece is given back.
 */
#ifndef SG_ARENA_H
#define SG_ARENA_H

#include <stddef.h>
#include <stdint.h>

typedef struct sg_arena_block sg_arena_block;

/* All zero is an empty arena. */
typedef struct sg_arena {
  sg_arena_block *all;  /* every block */
  sg_arena_block *open; /* the one that pieces are taken from */
  size_t bytes;         /* of all blocks */
} sg_arena;

/* Returns `words` 32-bit words, or null: no memory. */
uint32_t *sg_arena_take(sg_arena *arena, size_t words);

/* Gives back what sg_arena_take() returned. Null does nothing. */
void sg_arena_give(sg_arena *arena, const uint32_t *piece);

/* Frees every block. */
void sg_arena_clear(sg_arena *arena);

#endif
