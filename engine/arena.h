/* arena.h -- memory for lists and terms, taken and given back one by one.
 *
 * Layer: store. Pieces of about one size stand in blocks of their own, so the
 * hole that a piece leaves fits the next one of its size: lists and terms that
 * come and go need no more room than the most that there were at once, whatever
 * stays between them. A piece of up to 8 words costs its own bytes, a larger
 * one up to a quarter more; the largest are the system's, each alone. A block
 * returns to the system with its last piece, unless it is the only one of its
 * size that has room.
 */
#ifndef SG_ARENA_H
#define SG_ARENA_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { SG_ARENA_SIZES = 35 };

typedef struct sg_arena_block sg_arena_block;
typedef struct sg_arena_large sg_arena_large;

/* All zero is an empty arena. */
typedef struct sg_arena {
  sg_arena_block *open[SG_ARENA_SIZES]; /* by size: blocks that have room */
  sg_arena_block *full;
  sg_arena_large *large;
  size_t bytes; /* of all of them */
} sg_arena;

/* Returns `words` 32-bit words, or null: no memory. */
uint32_t *sg_arena_take(sg_arena *arena, size_t words);

/* Gives back what sg_arena_take() returned for so many words. Null does
 * nothing. */
void sg_arena_give(sg_arena *arena, const uint32_t *piece, size_t words);

/* Frees everything. */
void sg_arena_clear(sg_arena *arena);

/* Every block is where it belongs, and has the pieces that it counts. */
bool sg_arena_is_valid(const sg_arena *arena);

#endif
