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
