/* block.c -- blocks stand in slabs, which are the system's.
 *
 * A slab begins at a multiple of its size, so a block finds it; its first block
 * is its head. It returns to the system with its last block, unless it is the
 * only one that has room.
 */
#include "block.h"

#include <pthread.h>
#include <stdint.h>
#include <sys/mman.h>

enum { SLAB_BYTES = 1 << 20, SLAB_BLOCKS = SLAB_BYTES / SG_BLOCK_BYTES };

typedef struct slab slab;
struct slab {
  slab *previous, *next; /* of those that have room */
  void *back;            /* blocks given back: each begins with the next */
  unsigned used;         /* blocks that were ever taken, and the head */
  unsigned taken;        /* and not given back */
};

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static slab *open_slabs;

/* Null: no memory. */
static void *
from_system(size_t bytes)
{
  void *at = mmap(NULL, bytes, PROT_READ | PROT_WRITE,
                  MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);

  return at == MAP_FAILED ? NULL : at;
}

/* Spans that were closed last, for the next world: the system would clear each
 * of their pages again. */
enum { SPARE = 32 };
typedef struct spare_span {
  void *span; /* null: none */
  size_t bytes;
} spare_span;
static spare_span spare[SPARE];
static unsigned oldest;

void *
sg_span_open(size_t bytes)
{
  void *span = NULL;

  pthread_mutex_lock(&lock);
  for (unsigned i = 0; !span && i < SPARE; i++) {
    if (spare[i].span && spare[i].bytes == bytes) {
      span = spare[i].span;
      spare[i].span = NULL;
    }
  }
  pthread_mutex_unlock(&lock);
  return span ? span : from_system(bytes);
}

void
sg_span_close(void *span, size_t bytes)
{
  pthread_mutex_lock(&lock);
  spare_span old = spare[oldest];

  spare[oldest] = (spare_span){span, bytes};
  oldest = (oldest + 1) % SPARE;
  pthread_mutex_unlock(&lock);
  if (old.span) {
    munmap(old.span, old.bytes);
  }
}

static void
slab_link(slab *s)
{
  s->previous = NULL;
  s->next = open_slabs;
  if (open_slabs) {
    open_slabs->previous = s;
  }
  open_slabs = s;
}

static void
slab_unlink(slab *s)
{
  if (s->previous) {
    s->previous->next = s->next;
  } else {
    open_slabs = s->next;
  }
  if (s->next) {
    s->next->previous = s->previous;
  }
}

/* The middle of a span that has one at the right place; null: no memory. */
static slab *
slab_open(void)
{
  char *span = from_system(2 * SLAB_BYTES);

  if (!span) {
    return NULL;
  }
  size_t before = -(uintptr_t)span % SLAB_BYTES;
  slab *s = (slab *)(void *)(span + before);

  if (before > 0) {
    munmap(span, before);
  }
  munmap(span + before + SLAB_BYTES, SLAB_BYTES - before);
  s->used = 1;
  slab_link(s);
  return s;
}

static void *
block_of(slab *s)
{
  void *block = s->back;

  if (block) {
    s->back = *(void **)block;
  } else {
    block = (char *)s + (size_t)SG_BLOCK_BYTES * s->used++;
  }
  s->taken++;
  if (!s->back && s->used == SLAB_BLOCKS) {
    slab_unlink(s);
  }
  return block;
}

void *
sg_block_take(void)
{
  slab *s;
  void *block;

  pthread_mutex_lock(&lock);
  s = open_slabs ? open_slabs : slab_open();
  block = s ? block_of(s) : NULL;
  pthread_mutex_unlock(&lock);
  return block;
}

void
sg_block_give(void *block)
{
  slab *s = (slab *)(void *)((char *)block - (uintptr_t)block % SLAB_BYTES);

  pthread_mutex_lock(&lock);
  if (!s->back && s->used == SLAB_BLOCKS) {
    slab_link(s);
  }
  *(void **)block = s->back;
  s->back = block;
  if (--s->taken == 0 && (s->previous || s->next)) {
    slab_unlink(s);
    munmap(s, SLAB_BYTES);
  }
  pthread_mutex_unlock(&lock);
}
