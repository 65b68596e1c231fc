/* work_pair.c -- edges by their two ends: see work.h.
 *
 * Layer: kernel. A few edges are looked for at a vertex. Where a polygon has
 * many, a vertex may have most of them, and the same two ends may have many
 * edges: then a table has the oldest one for each two ends.
 */
#include "work_private.h"

static const uint32_t *
key_of(const sg_work_edge *edge, uint32_t key[2])
{
  key[0] = (uint32_t)edge->start;
  key[1] = (uint32_t)edge->end;
  return key;
}

bool
sg_work_pairs_add(sg_work *work, int32_t e)
{
  sg_work_edge_row *edge = work->edge;
  uint32_t key[2];
  uint32_t *first =
      sg_key_table_put(&work->pairs.first, key_of(&edge[e].edge, key));

  if (!first) {
    return false;
  }
  if (*first == SG_NO_KEY || *first == 0) {
    *first = (uint32_t)e;
    edge[e].pair_older = edge[e].pair_younger = e;
    return true;
  }
  int32_t oldest = (int32_t)*first, youngest = edge[oldest].pair_older;

  edge[e].pair_older = youngest;
  edge[e].pair_younger = oldest;
  edge[youngest].pair_younger = edge[oldest].pair_older = e;
  return true;
}

void
sg_work_pairs_drop(sg_work *work, int32_t e)
{
  sg_work_edge_row *edge = work->edge;
  uint32_t key[2];
  int32_t older = edge[e].pair_older, younger = edge[e].pair_younger;
  uint32_t *first =
      sg_key_table_find(&work->pairs.first, key_of(&edge[e].edge, key));

  edge[older].pair_younger = younger;
  edge[younger].pair_older = older;
  if (*first == (uint32_t)e) {
    *first = younger == e ? 0 : (uint32_t)younger;
  }
}

bool
sg_work_pairs_ready(sg_work *work)
{
  if (work->pairs.open || work->living <= SG_WORK_FEW) {
    return true;
  }
  sg_key_table_init(&work->pairs.first, 2);
  work->pairs.open = sg_key_table_reserve(&work->pairs.first, work->living);
  for (int32_t e = work->oldest; work->pairs.open && e;
       e = work->edge[e].younger) {
    work->pairs.open = sg_work_pairs_add(work, e);
  }
  if (!work->pairs.open) {
    sg_work_pairs_clear(work);
  }
  return work->pairs.open;
}

void
sg_work_pairs_clear(sg_work *work)
{
  if (work->pairs.first.words) {
    sg_key_table_clear(&work->pairs.first);
  }
  work->pairs.open = false;
}

/* Looks in both lists at once: the shorter one ends the search. */
int32_t
sg_work_pair(const sg_work *work, int32_t start, int32_t end)
{
  int32_t out = work->vertex[start].first_out;
  int32_t in = work->vertex[end].first_in;

  if (work->pairs.open) {
    uint32_t first = sg_key_table_get(
        &work->pairs.first, (uint32_t[2]){(uint32_t)start, (uint32_t)end});

    return first == SG_NO_KEY ? 0 : (int32_t)first;
  }
  while (out && in) {
    if (work->edge[out].edge.end == end) {
      return out;
    }
    if (work->edge[in].edge.start == start) {
      return in;
    }
    out = work->edge[out].out_younger;
    in = work->edge[in].in_younger;
  }
  return 0;
}
