/* edge_pairs.c -- see edge_pairs.h: a counting sort by the lower vertex, then
 * each bucket by itself. */
#include "edge_pairs.h"

#include "engine/list.h"
#include "engine/search.h"

#include "sort.h"

#include <stdlib.h>

enum { SMALL = 24, DIRECTION_BIT = 32, UPPER_BIT = 33 };

static uint32_t
lower(const int32_t *from, const int32_t *to, size_t i)
{
  return (uint32_t)(from[i] < to[i] ? from[i] : to[i]);
}

static uint64_t
key_of(const int32_t *from, const int32_t *to, size_t i)
{
  bool forward = from[i] <= to[i];
  uint64_t upper = (uint64_t)(forward ? to[i] : from[i]);

  return upper << UPPER_BIT | (uint64_t)!forward << DIRECTION_BIT | i;
}

static sg_sort_end
sort_keys(uint64_t *key, size_t n, const sg_cancel *cancel)
{
  if (n > SMALL) {
    return sg_sort(key, n, sizeof *key, sg_compare_keys, cancel);
  }
  SG_SORT_FEW(uint64_t, key, n, *x > *y);
  return SG_SORTED;
}

/* bucket[v] becomes the begin of the bucket of v; afterwards, having been
 * filled, the begins are one place further on: they are shifted back. False:
 * stopped by the cancellation. */
static bool
fill_buckets(sg_edge_pairs *p, const int32_t *from, const int32_t *to,
             const sg_cancel *cancel)
{
  for (size_t i = 0; i < p->n; i++) {
    if (sg_cancel_every(cancel, i)) {
      return false;
    }
    p->bucket[lower(from, to, i) + 1]++;
  }
  for (size_t v = 0; v < p->vertices; v++) {
    p->bucket[v + 1] += p->bucket[v];
  }
  for (size_t i = 0; i < p->n; i++) {
    if (sg_cancel_every(cancel, i)) {
      return false;
    }
    p->key[p->bucket[lower(from, to, i)]++] = key_of(from, to, i);
  }
  for (size_t v = p->vertices; v > 0; v--) {
    p->bucket[v] = p->bucket[v - 1];
  }
  p->bucket[0] = 0;
  return true;
}

bool
sg_edge_pairs_make(size_t n, const int32_t *from, const int32_t *to,
                   size_t vertices, const sg_cancel *cancel, sg_edge_pairs *out,
                   bool *stopped)
{
  *stopped = false;
  *out = (sg_edge_pairs){.n = n,
                         .key = sg_list_room(n, sizeof *out->key),
                         .bucket = calloc(vertices + 2, sizeof *out->bucket),
                         .vertices = vertices};
  if (!out->key || !out->bucket) {
    return false;
  }
  *stopped = !fill_buckets(out, from, to, cancel);
  sg_sort_end end = SG_SORTED;

  for (size_t v = 0; v < vertices && !*stopped && end == SG_SORTED; v++) {
    end = sort_keys(out->key + out->bucket[v],
                    out->bucket[v + 1] - out->bucket[v], cancel);
    *stopped = end == SG_SORT_STOPPED || sg_cancel_every(cancel, v);
  }
  return !*stopped && end == SG_SORTED;
}

void
sg_edge_pairs_clear(sg_edge_pairs *pairs)
{
  free(pairs->key);
  free(pairs->bucket);
  *pairs = (sg_edge_pairs){0};
}

/* The group that begins at this place of the bucket of group->low. */
static void
take_group(const sg_edge_pairs *pairs, size_t at, sg_edge_group *group)
{
  size_t last = pairs->bucket[group->low + 1];

  group->begin = at;
  group->high = (uint32_t)(pairs->key[at] >> UPPER_BIT);
  group->forward = 0;
  for (; at < last && pairs->key[at] >> UPPER_BIT == group->high; at++) {
    group->forward += !(pairs->key[at] >> DIRECTION_BIT & 1);
  }
  group->end = at;
}

bool
sg_edge_group_next(const sg_edge_pairs *pairs, sg_edge_group *group)
{
  size_t at = group->end;

  if (at == pairs->n) {
    return false;
  }
  while (pairs->bucket[group->low + 1] <= at) {
    group->low++;
  }
  take_group(pairs, at, group);
  return true;
}

bool
sg_edge_group_find(const sg_edge_pairs *pairs, uint32_t v, uint32_t w,
                   sg_edge_group *group)
{
  uint32_t low = v < w ? v : w, high = v < w ? w : v;
  size_t last = pairs->bucket[low + 1], from;

  SG_SEARCH(from, pairs->bucket[low], last,
            pairs->key[from] >> UPPER_BIT < high);
  if (from == last || pairs->key[from] >> UPPER_BIT != high) {
    return false;
  }
  group->low = low;
  take_group(pairs, from, group);
  return true;
}

bool
sg_edge_pairs_closed(const sg_edge_pairs *pairs)
{
  sg_edge_group group = {0};

  while (sg_edge_group_next(pairs, &group)) {
    if (2 * group.forward != group.end - group.begin) {
      return false;
    }
  }
  return true;
}
