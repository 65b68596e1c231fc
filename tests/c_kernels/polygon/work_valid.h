/* work_valid.h -- whether the lists of a scratch relation hold together, for
 * tests.
 */
#ifndef WORK_VALID_H
#define WORK_VALID_H

#include "polygon/work_private.h"

static bool
list_is_valid(const sg_work *work, int32_t v)
{
  const sg_work_edge_row *edge = work->edge;
  int32_t before = 0;

  for (int32_t e = work->vertex[v].first_out; e; e = edge[e].out_younger) {
    if (!edge[e].living || edge[e].edge.start != v ||
        edge[e].out_older != before) {
      return false;
    }
    before = e;
  }
  if (before != work->vertex[v].last_out) {
    return false;
  }
  before = 0;
  for (int32_t e = work->vertex[v].first_in; e; e = edge[e].in_younger) {
    if (!edge[e].living || edge[e].edge.end != v ||
        edge[e].in_older != before) {
      return false;
    }
    before = e;
  }
  return before == work->vertex[v].last_in;
}

/* Edges ascend, and each vertex has its own in both of its lists. */
static bool
work_is_valid(const sg_work *work)
{
  size_t n = 0;
  int32_t before = 0;

  for (int32_t e = work->oldest; e; e = work->edge[e].younger) {
    if (!work->edge[e].living || work->edge[e].older != before || e < before) {
      return false;
    }
    before = e;
    n++;
  }
  if (before != work->youngest || n != work->living) {
    return false;
  }
  for (int32_t v = 0; v < work->vertices; v++) {
    if (!list_is_valid(work, v) ||
        sg_work_find(work, work->vertex[v].id) != v) {
      return false;
    }
  }
  return true;
}

#endif
