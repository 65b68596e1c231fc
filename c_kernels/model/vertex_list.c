/* vertex_list.c -- lists of vertices, and borders. */
#include "vertex_list.h"

#include "engine/search.h"

#include <stdlib.h>

SG_ORDER(compare_edges, sg_list_edge, SG_BY(from) SG_BY(to));

bool
sg_vertex_list_edges(const int32_t *v, size_t n, sg_list_edge *out,
                     size_t *edges)
{
  bool jumps = false;

  *edges = 0;
  if (n == 0 || v[0] <= 0) {
    return false;
  }
  for (size_t i = 1; i < n; i++) {
    if (v[i] > 0) {
      out[(*edges)++] = (sg_list_edge){abs(v[i - 1]), v[i]};
    } else if (v[i] == 0 || i + 1 == n || v[i + 1] <= 0) {
      return false;
    }
    jumps = jumps || v[i] < 0;
  }
  if (!jumps && v[n - 1] != v[0]) {
    out[(*edges)++] = (sg_list_edge){v[n - 1], v[0]};
  }
  return true;
}

static bool
find_open(const sg_list_edge *edge, size_t n, int32_t *end, int32_t *what)
{
  for (size_t i = 0; i < n; i++) {
    end[i] = edge[i].to;
  }
  qsort(end, n, sizeof *end, sg_compare_ids);
  for (size_t i = 0; i < n; i++) {
    if (end[i] != edge[i].from) {
      *what = end[i] < edge[i].from ? end[i] : edge[i].from;
      return true;
    }
  }
  return false;
}

sg_border_fault
sg_border_find_fault(sg_list_edge *edge, size_t n, int32_t *scratch,
                     int32_t what[2])
{
  if (n < 3) {
    return SG_BORDER_EDGES;
  }
  for (size_t i = 0; i < n; i++) {
    if (edge[i].from == edge[i].to) {
      what[0] = edge[i].from;
      return SG_BORDER_NO_EDGE;
    }
  }
  qsort(edge, n, sizeof *edge, compare_edges);
  for (size_t i = 1; i < n; i++) {
    if (compare_edges(&edge[i - 1], &edge[i]) == 0) {
      what[0] = edge[i].from;
      what[1] = edge[i].to;
      return SG_BORDER_TWICE;
    }
  }
  return find_open(edge, n, scratch, what) ? SG_BORDER_OPEN : SG_BORDER_GOOD;
}
