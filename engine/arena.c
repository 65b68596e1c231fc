/* arena.c -- blocks aligned to their size, so that a piece finds its block. */
#include "arena.h"

#include <stdlib.h>

enum { BLOCK_BYTES = 1 << 16 };

struct sg_arena_block {
  sg_arena_block *previous, *next;
  size_t bytes;
  uint32_t pieces; /* not yet given back */
  uint32_t used;   /* words of data */
  uint32_t data[];
};

enum {
  BLOCK_WORDS =
      (BLOCK_BYTES - (int)sizeof(sg_arena_block)) / (int)sizeof(uint32_t)
};

static sg_arena_block *
block_open(sg_arena *arena, size_t words)
{
  size_t bytes = sizeof(sg_arena_block) + words * sizeof(uint32_t);
  size_t rounded = (bytes + BLOCK_BYTES - 1) / BLOCK_BYTES * BLOCK_BYTES;
  sg_arena_block *block = aligned_alloc(BLOCK_BYTES, rounded);

  if (!block) {
    return NULL;
  }
  *block = (sg_arena_block){.next = arena->all, .bytes = rounded};
  if (arena->all) {
    arena->all->previous = block;
  }
  arena->all = block;
  arena->bytes += rounded;
  return block;
}

static void
block_close(sg_arena *arena, sg_arena_block *block)
{
  if (block->previous) {
    block->previous->next = block->next;
  } else {
    arena->all = block->next;
  }
  if (block->next) {
    block->next->previous = block->previous;
  }
  arena->bytes -= block->bytes;
  free(block);
}

/* The block from which `words` can be taken; null: no memory. */
static sg_arena_block *
block_with(sg_arena *arena, size_t words)
{
  sg_arena_block *open = arena->open;

  if (words > BLOCK_WORDS) {
    return block_open(arena, words); /* a block of its own */
  }
  if (!open || open->used + words > BLOCK_WORDS) {
    sg_arena_block *fresh = block_open(arena, BLOCK_WORDS);
    if (!fresh) {
      return NULL;
    }
    if (open && open->pieces == 0) {
      block_close(arena, open);
    }
    arena->open = fresh;
  }
  return arena->open;
}

uint32_t *
sg_arena_take(sg_arena *arena, size_t words)
{
  sg_arena_block *block;
  uint32_t *piece;

  if (words >= UINT32_MAX / 2 || !(block = block_with(arena, words))) {
    return NULL;
  }
  piece = block->data + block->used;
  block->used += (uint32_t)words;
  block->pieces++;
  return piece;
}

void
sg_arena_give(sg_arena *arena, const uint32_t *piece)
{
  sg_arena_block *block;

  if (!piece) {
    return;
  }
  block = (sg_arena_block *)((uintptr_t)piece & ~(uintptr_t)(BLOCK_BYTES - 1));
  if (--block->pieces > 0) {
    return;
  }
  if (block == arena->open) {
    block->used = 0;
  } else {
    block_close(arena, block);
  }
}

void
sg_arena_clear(sg_arena *arena)
{
  while (arena->all) {
    block_close(arena, arena->all);
  }
  *arena = (sg_arena){0};
}
