/* loops.c -- see loops.h. Edges in loop order, the common case, need no
 * search; others are sorted by their start. */
#include "loops.h"
#include "engine/list.h"
#include "engine/search.h"

#include <stdlib.h>

static bool
make_room(sg_loops *loops, size_t n)
{
  size_t room = loops->room; /* of both; order: two of each */

  return sg_list_need(&loops->next, n, &room, sizeof *loops->next) &&
         sg_list_need(&loops->order, n, &loops->room, 2 * sizeof *loops->order);
}

/* First every edge takes the one behind it in the arrays if that starts where
 * it ends; true if this joined all but the ends of runs, and each run closes on
 * its own first edge. */
static bool
join_in_order(sg_loops *loops, size_t n, const int32_t *from, const int32_t *to)
{
  size_t first = 0;

  for (size_t i = 0; i < n; i++) {
    if (i + 1 < n && from[i + 1] == to[i] && to[i] != from[first]) {
      loops->next[i] = (int32_t)i + 1;
    } else if (to[i] == from[first]) {
      loops->next[i] = (int32_t)first;
      loops->loops++;
      first = i + 1;
    } else {
      return false;
    }
  }
  return true;
}

/* A pair of start and edge, for sorting. */
typedef struct start {
  int32_t from, edge;
} start;

SG_ORDER(compare, start, SG_BY(from) SG_BY(edge));

/* An edge that starts at `vertex` and follows none yet; edge after + 1 if it is
 * one of them. -1: none. Taken edges are marked by a negative number. */
static int32_t
take(start *starts, size_t n, int32_t vertex, int32_t after)
{
  size_t low = sg_first_id(starts, n, sizeof *starts, vertex);
  start *found = NULL;

  for (; low < n && starts[low].from == vertex; low++) {
    if (starts[low].edge >= 0 && (!found || starts[low].edge == after + 1)) {
      found = &starts[low];
    }
  }
  if (!found) {
    return -1;
  }
  int32_t edge = found->edge;
  found->edge = -1 - edge;
  return edge;
}

/* Counts closed chains and open ends. `next` leads to each edge at most once,
 * so a walk ends at an open end or where it began; -2 - x marks edges walked.
 */
static void
count_loops(sg_loops *loops, size_t n)
{
  for (size_t i = 0; i < n; i++) {
    int32_t at = (int32_t)i;
    loops->open += loops->next[i] == -1;
    while (loops->next[at] >= 0) {
      int32_t after = loops->next[at];
      loops->next[at] = -2 - after;
      at = after;
      loops->loops += at == (int32_t)i;
    }
  }
  for (size_t i = 0; i < n; i++) {
    if (loops->next[i] < -1) {
      loops->next[i] = -2 - loops->next[i];
    }
  }
}

bool
sg_loops_make(sg_loops *loops, size_t n, const int32_t *from, const int32_t *to)
{
  loops->loops = loops->open = 0;
  if (!make_room(loops, n)) {
    return false;
  }
  if (join_in_order(loops, n, from, to)) {
    return true;
  }
  start *starts = (start *)(void *)loops->order;
  for (size_t i = 0; i < n; i++) {
    starts[i] = (start){from[i], (int32_t)i};
  }
  qsort(starts, n, sizeof *starts, compare);
  for (size_t i = 0; i < n; i++) {
    loops->next[i] = take(starts, n, to[i], (int32_t)i);
  }
  loops->loops = 0;
  count_loops(loops, n);
  return true;
}

void
sg_loops_clear(sg_loops *loops)
{
  free(loops->next);
  free(loops->order);
  *loops = (sg_loops){0};
}
