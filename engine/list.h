/* list.h -- THE growing array.
 *
 * Layer: shared by the store and the kernels.
 *
 *   SG_LIST_OF(int32_t) all = {0};
 *   if (!SG_PUSH(all, 7)) no_memory();
 *   use(all.item[0], all.n);
 *   free(all.item);
 *
 * Arrays whose members have other names grow by sg_list_grow().
 */
#ifndef SG_LIST_H
#define SG_LIST_H

#include <stdbool.h>
#include <stddef.h>

#define SG_LIST_OF(type)                                                       \
  struct {                                                                     \
    type *item;                                                                \
    size_t n, room;                                                            \
  }

/* Makes *room `need` or more: `item` is the address of a pointer to that many
 * of `size` bytes. False: no memory, and nothing changed. */
bool sg_list_widen(void *item, size_t need, size_t *room, size_t size);

/* The same for all need, of which most is there already. */
static inline bool
sg_list_need(void *item, size_t need, size_t *room, size_t size)
{
  return need <= *room || sg_list_widen(item, need, room, size);
}

/* The same, and what is new is all zeros. */
bool sg_list_widen_zeroed(void *item, size_t need, size_t *room, size_t size);

static inline bool
sg_list_need_zeroed(void *item, size_t need, size_t *room, size_t size)
{
  return need <= *room || sg_list_widen_zeroed(item, need, room, size);
}

/* Room for n, and one more, at once; null: no memory. Owner: the caller,
 * free(). */
void *sg_list_room(size_t n, size_t size);

/* No more room than n take; without memory for that it stays as it is. */
void sg_list_trim(void *item, size_t n, size_t *room, size_t size);

/* Room for one behind n. */
static inline bool
sg_list_grow(void *item, size_t n, size_t *room, size_t size)
{
  return n < *room || sg_list_widen(item, n + 1, room, size);
}

#define SG_PUSH(list, ...)                                                     \
  (sg_list_grow(&(list).item, (list).n, &(list).room, sizeof *(list).item) &&  \
   ((list).item[(list).n++] = __VA_ARGS__, true))

#endif
