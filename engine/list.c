/* list.c -- see list.h. */
#include "list.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

/* Bytes: of more, whole pages of this size are asked for. */
#define LARGE_PAGE ((size_t)1 << 21)

/* What is large is made of large pages, where the system has them: each small
 * one costs a fault at its first use. */
static void
ask_large_pages(void *memory, size_t bytes)
{
  uintptr_t at = (uintptr_t)memory;
  uintptr_t from = (at + LARGE_PAGE - 1) & ~(LARGE_PAGE - 1);
  uintptr_t to = (at + bytes) & ~(LARGE_PAGE - 1);

#ifdef MADV_HUGEPAGE
  if (from < to) {
    (void)madvise((void *)from, to - from, MADV_HUGEPAGE);
  }
#endif
}

void *
sg_list_room(size_t n, size_t size)
{
  void *room = n < SIZE_MAX / size ? malloc((n + 1) * size) : NULL;

  if (room) {
    ask_large_pages(room, n * size);
  }
  return room;
}

bool
sg_list_widen(void *item, size_t need, size_t *room, size_t size)
{
  size_t more = need > *room * 2 ? need : *room * 2;
  void *old, *grown;

  more = more < 16 ? 16 : more;
  memcpy(&old, item, sizeof old); /* whatever it points to */
  if (more > SIZE_MAX / 2 / size || !(grown = realloc(old, more * size))) {
    return false;
  }
  memcpy(item, &grown, sizeof grown);
  ask_large_pages(grown, more * size);
  *room = more;
  return true;
}

bool
sg_list_widen_zeroed(void *item, size_t need, size_t *room, size_t size)
{
  size_t before = *room;
  char *grown;

  if (!sg_list_widen(item, need, room, size)) {
    return false;
  }
  memcpy(&grown, item, sizeof grown);
  memset(grown + before * size, 0, (*room - before) * size);
  return true;
}

void
sg_list_trim(void *item, size_t n, size_t *room, size_t size)
{
  void *old, *less;

  memcpy(&old, item, sizeof old);
  if (n < *room && (less = realloc(old, (n > 0 ? n : 1) * size))) {
    memcpy(item, &less, sizeof less);
    *room = n;
  }
}
