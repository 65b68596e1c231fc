/* list.c -- see list.h. */
#include "list.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

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
