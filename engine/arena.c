/* arena.c -- blocks aligned to their size, so that a piece finds its block. */
#include "arena.h"
#include "block.h"

#include <stdlib.h>

enum {
  EXACT = 8,    /* sizes of so many words are exact */
  LARGEST = 896 /* words of a piece in a block */
};

/* Pieces given back are a chain: the first word of each says where the next one
 * is. */
struct sg_arena_block {
  sg_arena_block *previous, *next; /* of those with room, or of the full ones */
  unsigned size;                   /* of its pieces, as of size_of() */
  uint32_t words;                  /* of a piece */
  uint32_t pieces;                 /* taken and not yet given back */
  uint32_t used;                   /* words of data that were ever taken */
  uint32_t back;                   /* 1 + where the last one given back is */
  uint32_t data[];
};

enum {
  BLOCK_WORDS =
      (SG_BLOCK_BYTES - (int)sizeof(sg_arena_block)) / (int)sizeof(uint32_t)
};

struct sg_arena_large {
  sg_arena_large *previous, *next;
  uint32_t data[];
};

/* ---- sizes ------------------------------------------------------------- */

/* From 8 words on four sizes to each power of two: 8, 10, 12, 14, 16, 20 ... */
static unsigned
size_of(size_t words)
{
  if (words <= EXACT) {
    return words == 0 ? 0 : (unsigned)words - 1;
  }
  unsigned power = 63 - (unsigned)__builtin_clzll(words - 1);
  unsigned quarter = (unsigned)((words - 1) >> (power - 2)) & 3;

  return EXACT + 4 * (power - 3) + quarter;
}

static uint32_t
words_of(unsigned size)
{
  return size < EXACT ? size + 1
                      : (5 + (size - EXACT) % 4) << (1 + (size - EXACT) / 4);
}

/* ---- blocks ------------------------------------------------------------ */

static void
block_link(sg_arena_block **list, sg_arena_block *block)
{
  block->previous = NULL;
  block->next = *list;
  if (*list) {
    (*list)->previous = block;
  }
  *list = block;
}

static void
block_unlink(sg_arena_block **list, const sg_arena_block *block)
{
  if (block->previous) {
    block->previous->next = block->next;
  } else {
    *list = block->next;
  }
  if (block->next) {
    block->next->previous = block->previous;
  }
}

/* With room; null: no memory. */
static sg_arena_block *
block_open(sg_arena *arena, unsigned size)
{
  sg_arena_block *block = sg_block_take();

  if (!block) {
    return NULL;
  }
  *block = (sg_arena_block){.size = size, .words = words_of(size)};
  block_link(&arena->open[size], block);
  arena->bytes += SG_BLOCK_BYTES;
  return block;
}

static bool
has_room(const sg_arena_block *block)
{
  return block->back > 0 || block->used + block->words <= BLOCK_WORDS;
}

static uint32_t *
piece_take(sg_arena *arena, sg_arena_block *block)
{
  uint32_t *piece = block->data + block->used;

  if (block->back > 0) {
    piece = block->data + block->back - 1;
    block->back = *piece;
  } else {
    block->used += block->words;
  }
  block->pieces++;
  if (!has_room(block)) {
    block_unlink(&arena->open[block->size], block);
    block_link(&arena->full, block);
  }
  return piece;
}

static void
piece_give(sg_arena *arena, sg_arena_block *block, uint32_t *piece)
{
  if (!has_room(block)) {
    block_unlink(&arena->full, block);
    block_link(&arena->open[block->size], block);
  }
  *piece = block->back;
  block->back = (uint32_t)(piece - block->data) + 1;
  if (--block->pieces > 0) {
    return;
  }
  block->used = block->back = 0;
  if (block->previous || block->next) {
    block_unlink(&arena->open[block->size], block);
    arena->bytes -= SG_BLOCK_BYTES;
    sg_block_give(block);
  }
}

/* ---- large pieces ------------------------------------------------------ */

static size_t
large_bytes(size_t words)
{
  return sizeof(sg_arena_large) + words * sizeof(uint32_t);
}

static uint32_t *
large_take(sg_arena *arena, size_t words)
{
  sg_arena_large *large = malloc(large_bytes(words));

  if (!large) {
    return NULL;
  }
  *large = (sg_arena_large){.next = arena->large};
  if (arena->large) {
    arena->large->previous = large;
  }
  arena->large = large;
  arena->bytes += large_bytes(words);
  return large->data;
}

static void
large_give(sg_arena *arena, sg_arena_large *large, size_t words)
{
  if (large->previous) {
    large->previous->next = large->next;
  } else {
    arena->large = large->next;
  }
  if (large->next) {
    large->next->previous = large->previous;
  }
  arena->bytes -= large_bytes(words);
  free(large);
}

/* ---- both -------------------------------------------------------------- */

uint32_t *
sg_arena_take(sg_arena *arena, size_t words)
{
  if (words >= UINT32_MAX / 2) {
    return NULL;
  }
  if (words > LARGEST) {
    return large_take(arena, words);
  }
  unsigned size = size_of(words);
  sg_arena_block *block = arena->open[size];

  if (!block && !(block = block_open(arena, size))) {
    return NULL;
  }
  return piece_take(arena, block);
}

void
sg_arena_give(sg_arena *arena, const uint32_t *piece, size_t words)
{
  uintptr_t at = (uintptr_t)piece;

  if (piece && words > LARGEST) {
    large_give(arena, (sg_arena_large *)(at - sizeof(sg_arena_large)), words);
  } else if (piece) {
    uintptr_t block = at & ~(uintptr_t)(SG_BLOCK_BYTES - 1);
    piece_give(arena, (sg_arena_block *)block, (uint32_t *)at);
  }
}

static void
close_all(sg_arena_block *block)
{
  for (sg_arena_block *next; block; block = next) {
    next = block->next;
    sg_block_give(block);
  }
}

void
sg_arena_clear(sg_arena *arena)
{
  for (unsigned i = 0; i < SG_ARENA_SIZES; i++) {
    close_all(arena->open[i]);
  }
  close_all(arena->full);
  for (sg_arena_large *large = arena->large, *next; large; large = next) {
    next = large->next;
    free(large);
  }
  *arena = (sg_arena){0};
}

/* ---- validity ---------------------------------------------------------- */

static bool
block_is_valid(const sg_arena_block *block)
{
  uint32_t back = 0, places = block->used / block->words;

  for (uint32_t at = block->back; at > 0 && back <= places;
       at = block->data[at - 1]) {
    if ((at - 1) % block->words != 0 || at > block->used) {
      return false;
    }
    back++;
  }
  return block->words == words_of(block->size) &&
         block->pieces + back == places;
}

bool
sg_arena_is_valid(const sg_arena *arena)
{
  bool valid = true;

  for (unsigned i = 0; i < SG_ARENA_SIZES; i++) {
    for (const sg_arena_block *b = arena->open[i]; valid && b; b = b->next) {
      valid = b->size == i && has_room(b) && block_is_valid(b);
    }
  }
  for (const sg_arena_block *b = arena->full; valid && b; b = b->next) {
    valid = !has_room(b) && block_is_valid(b);
  }
  return valid;
}
