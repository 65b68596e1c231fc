/* boundary_split.c -- edges of a boundary divided at vertices that lie on them
 * (boundary_private.h). */
#include "boundary_private.h"

#include "engine/list.h"
#include "engine/search.h"
#include "rows/key_table.h"

#include <stdlib.h>
#include <string.h>

bool
sg_boundary_note_split(sg_edge_splits *splits, int32_t from, int32_t to,
                       int32_t v)
{
  if (!sg_list_grow(&splits->item, splits->n, &splits->room,
                    sizeof *splits->item)) {
    return false;
  }
  splits->item[splits->n++] =
      (sg_edge_split){from < to ? from : to, from < to ? to : from, v, 0};
  return true;
}

/* By the edge, and along it from its lower vertex. */
SG_ORDER(compare_splits, sg_edge_split,
         SG_BY(low) SG_BY(high) SG_BY(at) SG_BY(v));

/* Sorts them, each once. */
static void
order_splits(const sg_boundary *b, sg_edge_splits *splits)
{
  size_t kept = 0;

  for (size_t i = 0; i < splits->n; i++) {
    sg_edge_split *s = &splits->item[i];
    const double *o = b->at[s->low], *w = b->at[s->high], *p = b->at[s->v];
    s->at = (p[0] - o[0]) * (w[0] - o[0]) + (p[1] - o[1]) * (w[1] - o[1]) +
            (p[2] - o[2]) * (w[2] - o[2]);
  }
  qsort(splits->item, splits->n, sizeof *splits->item, compare_splits);
  for (size_t i = 0; i < splits->n; i++) {
    if (kept == 0 ||
        compare_splits(&splits->item[i], &splits->item[kept - 1]) != 0) {
      splits->item[kept++] = splits->item[i];
    }
  }
  splits->n = kept;
}

/* Where the edges stand, from low and high to the first of the splits. */
static bool
find_splits(const sg_edge_splits *splits, sg_key_table *first)
{
  for (size_t i = 0; i < splits->n; i++) {
    uint32_t key[2] = {(uint32_t)splits->item[i].low,
                       (uint32_t)splits->item[i].high};
    uint32_t *at = sg_key_table_put(first, key);
    if (!at) {
      return false;
    }
    *at = *at == SG_NO_KEY ? (uint32_t)i : *at;
  }
  return true;
}

typedef struct edges {
  int32_t (*edge)[2];
  size_t n, room;
} edges;

static bool
put_edge(edges *out, int32_t from, int32_t to)
{
  if (!sg_list_grow(&out->edge, out->n, &out->room, sizeof *out->edge)) {
    return false;
  }
  out->edge[out->n][0] = from;
  out->edge[out->n++][1] = to;
  return true;
}

/* The pieces of an edge from -> to, whose splits begin at `first`. */
static bool
put_pieces(edges *out, const sg_edge_splits *splits, size_t first, int32_t from,
           int32_t to)
{
  const sg_edge_split *s = splits->item + first;
  size_t n = 1;
  int32_t last = from;

  while (first + n < splits->n && s[n].low == s->low && s[n].high == s->high) {
    n++;
  }
  for (size_t i = 0; i < n; i++) {
    int32_t v = s[from < to ? i : n - 1 - i].v;
    if (!put_edge(out, last, v)) {
      return false;
    }
    last = v;
  }
  return put_edge(out, last, to);
}

/* The edges of all faces; begin[f] becomes where those of face f begin. False:
 * no memory. */
static bool
divide_edges(sg_boundary *b, const sg_edge_splits *splits,
             const sg_key_table *first, edges *out, uint32_t *begin)
{
  for (size_t f = 0; f < b->faces; f++) {
    begin[f] = (uint32_t)out->n;
    for (uint32_t i = b->begin[f]; i < b->begin[f + 1]; i++) {
      int32_t from = b->edge[i][0], to = b->edge[i][1];
      uint32_t key[2] = {(uint32_t)(from < to ? from : to),
                         (uint32_t)(from < to ? to : from)};
      uint32_t at = sg_key_table_get(first, key);
      if (at == SG_NO_KEY ? !put_edge(out, from, to)
                          : !put_pieces(out, splits, at, from, to)) {
        return false;
      }
      b->changed[f] |= at != SG_NO_KEY;
    }
    if (out->n - begin[f] > b->begin[f + 1] - b->begin[f]) {
      out->n =
          begin[f] + sg_edges_cancel(out->edge + begin[f], out->n - begin[f]);
    }
  }
  begin[b->faces] = (uint32_t)out->n;
  return true;
}

bool
sg_boundary_split(sg_boundary *boundary, sg_edge_splits *splits)
{
  sg_key_table first;
  edges out = {0};
  uint32_t *begin = malloc((boundary->faces + 1) * sizeof *begin);

  sg_key_table_init(&first, 2);
  order_splits(boundary, splits);
  bool done = begin && find_splits(splits, &first) &&
              divide_edges(boundary, splits, &first, &out, begin);
  if (done) {
    int32_t(*edge)[2] = boundary->edge;
    uint32_t *old = boundary->begin;
    boundary->edge = out.edge;
    boundary->begin = begin;
    out.edge = edge;
    begin = old;
  }
  free(out.edge);
  free(begin);
  sg_key_table_clear(&first);
  return done;
}
