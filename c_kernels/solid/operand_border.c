/* operand_border.c -- see operand_border.h. */
#include "operand_border.h"

#include "engine/list.h"
#include "engine/search.h"
#include "rows/sort.h"

#include <stdlib.h>

enum { ASK_EVERY = 65536 };

/* A half-edge of a polygon. */
typedef struct half {
  int32_t s, low, high;
  uint32_t polygon; /* a place */
  bool backward;    /* from high to low */
} half;

SG_ORDER(compare_halves, half,
         SG_BY(s) SG_BY(low) SG_BY(high) SG_BY(backward) SG_BY(polygon));

static bool
have_common(const sg_operands_of *of, uint32_t p, uint32_t q)
{
  for (uint32_t i = of->begin[p]; i < of->begin[p + 1]; i++) {
    for (uint32_t k = of->begin[q]; k < of->begin[q + 1]; k++) {
      if (of->operand[i] == of->operand[k]) {
        return true;
      }
    }
  }
  return false;
}

static bool
is_border(const sg_operands_of *of, uint32_t p, uint32_t q)
{
  return of->begin[p] < of->begin[p + 1] && of->begin[q] < of->begin[q + 1] &&
         !have_common(of, p, q);
}

static bool
keep(sg_operand_borders *out, size_t *room, const sg_operand_border *border)
{
  if (!sg_list_grow(&out->item, out->n, &*room, sizeof *out->item)) {
    return false;
  }
  out->item[out->n++] = *border;
  return true;
}

/* Each forward one of the n halves of an edge with each backward one. */
static bool
keep_borders(const sg_dense *d, const sg_operands_of *of, const half *edge,
             size_t n, sg_operand_borders *out, size_t *room)
{
  size_t back = 0;

  while (back < n && !edge[back].backward) {
    back++;
  }
  for (size_t i = 0; i < back; i++) {
    for (size_t k = back; k < n; k++) {
      uint32_t p = edge[i].polygon, q = edge[k].polygon;
      sg_operand_border border = {
          edge->s, edge->low, edge->high, {d->polygon_id[p], d->polygon_id[q]}};

      if (is_border(of, p, q) && !keep(out, room, &border)) {
        return false;
      }
    }
  }
  return true;
}

static bool
is_same_edge(const half *a, const half *b)
{
  return a->s == b->s && a->low == b->low && a->high == b->high;
}

static bool
keep_all(const sg_dense *d, const sg_operands_of *of, const half *edge,
         size_t n, const sg_cancel *cancel, sg_operand_borders *out,
         bool *stopped)
{
  size_t room = 0, asked = 0;

  for (size_t i = 0, end; i < n; i = end) {
    for (end = i + 1; end < n && is_same_edge(&edge[end], &edge[i]);) {
      end++;
    }
    if (i >= asked) {
      asked = i + ASK_EVERY;
      *stopped = sg_cancelled(cancel);
    }
    if (*stopped || !keep_borders(d, of, edge + i, end - i, out, &room)) {
      return false;
    }
  }
  return true;
}

/* Adds the half-edges of polygon p (a place) of segment s. */
static void
list_polygon(const sg_dense *d, int32_t s, uint32_t p, half *edge, size_t *n)
{
  for (size_t k = d->list_begin[p]; k < d->list_begin[p + 1]; k++) {
    int32_t from = d->vertex_id[d->from[d->list[k]]];
    int32_t to = d->vertex_id[d->to[d->list[k]]];
    bool backward = to < from;

    edge[(*n)++] =
        (half){s, backward ? to : from, backward ? from : to, p, backward};
  }
}

static half *
list_halves(const sg_dense *d, size_t *n)
{
  half *edge = malloc((d->list_begin[d->polygons] + 1u) * sizeof *edge);

  *n = 0;
  for (size_t s = 0; edge && s < d->segments; s++) {
    for (uint32_t p = (uint32_t)d->polygon_begin[s];
         p < d->polygon_begin[s + 1]; p++) {
      list_polygon(d, d->segment[s], p, edge, n);
    }
  }
  return edge;
}

bool
sg_operand_borders_find(const sg_dense *dense, const sg_operands_of *of,
                        const sg_cancel *cancel, sg_operand_borders *out,
                        bool *stopped)
{
  size_t n;
  half *edge = list_halves(dense, &n);

  *out = (sg_operand_borders){0};
  *stopped = false;
  sg_sort_end end = edge
                        ? sg_sort(edge, n, sizeof *edge, compare_halves, cancel)
                        : SG_SORT_NO_MEMORY;

  *stopped = end == SG_SORT_STOPPED;
  bool done =
      end == SG_SORTED && keep_all(dense, of, edge, n, cancel, out, stopped);

  free(edge);
  if (!done) {
    free(out->item);
    *out = (sg_operand_borders){0};
  }
  return done;
}
