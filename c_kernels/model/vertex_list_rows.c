/* vertex_list_rows.c -- what is wrong with a list of vertices that a model file
 * has for a segment of the current world.
 *
 * Layer: rows.
 */
#include "vertex_list.h"

#include "call.h"
#include "doors/file.h"

/* The first of n numbers, every stride-th of v, that is no vertex of segment
 * s; 0: none, or see call.h. */
static int32_t
first_missing(sg_call *call, int32_t s, const int32_t *v, size_t n,
              size_t stride)
{
  const sg_version *version = sg_call_version(call);

  for (size_t i = 0; version && i < n; i++) {
    int32_t id = v[i * stride];
    sg_value key[SG_MAX_COLUMNS] = {{.i = s}, {.i = id}};

    if (sg_cancel_every(&call->cancel, i)) {
      return 0;
    }
    if ((i == 0 || id != v[(i - 1) * stride]) &&
        sg_version_find(version, SG_V, key) == SG_NO_ROW) {
      return id;
    }
  }
  return 0;
}

static bool
tell_border(sg_border_fault is, size_t edges, const int32_t what[2],
            sg_vertex_list_fault *fault)
{
  switch (is) {
  case SG_BORDER_GOOD:
    return false;
  case SG_BORDER_EDGES:
    fault->is = SG_VERTEX_LIST_FAULT_EDGES;
    fault->edges.n = edges;
    break;
  case SG_BORDER_NO_EDGE:
    fault->is = SG_VERTEX_LIST_FAULT_NO_EDGE;
    fault->no_edge.v = what[0];
    break;
  case SG_BORDER_TWICE:
    fault->is = SG_VERTEX_LIST_FAULT_TWICE;
    fault->twice.v1 = what[0];
    fault->twice.v2 = what[1];
    break;
  case SG_BORDER_OPEN:
    fault->is = SG_VERTEX_LIST_FAULT_OPEN;
    fault->open.v = what[0];
    break;
  }
  return true;
}

bool
sg_door_vertex_list_fault(sg_call *call, int32_t s, const sg_int_list *vertices,
                          sg_vertex_list_fault *fault)
{
  size_t n = vertices->n, edges;
  int32_t what[2] = {0};
  sg_list_edge *edge = sg_call_alloc(call, (n + 1) * sizeof *edge);
  int32_t *scratch = sg_call_alloc(call, (n + 1) * sizeof *scratch);

  if (!edge || !scratch) {
    return false;
  }
  if (!sg_vertex_list_edges(vertices->at, n, edge, &edges)) {
    fault->is = SG_VERTEX_LIST_FAULT_LIST;
    return true;
  }
  fault->missing.v = first_missing(call, s, &edge->from, edges,
                                   sizeof *edge / sizeof edge->from);
  if (fault->missing.v != 0) {
    fault->is = SG_VERTEX_LIST_FAULT_MISSING;
    return true;
  }
  return call->version && !call->stopped &&
         tell_border(sg_border_find_fault(edge, edges, scratch, what), edges,
                     what, fault);
}

bool
sg_door_chain_fault(sg_call *call, int32_t s, const sg_int_list *vertices,
                    sg_chain_fault *fault)
{
  fault->missing.v = first_missing(call, s, vertices->at, vertices->n, 1);
  fault->is = SG_CHAIN_FAULT_MISSING;
  for (size_t i = 1; fault->missing.v == 0 && i < vertices->n; i++) {
    if (vertices->at[i] == vertices->at[i - 1]) {
      fault->is = SG_CHAIN_FAULT_CHAIN;
      fault->chain.v = vertices->at[i];
      return call->version && !call->stopped;
    }
  }
  return fault->missing.v != 0;
}
