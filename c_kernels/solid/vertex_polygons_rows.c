/* vertex_polygons_rows.c -- see vertex_polygons_rows.h. */
#include "vertex_polygons_rows.h"

#include "engine/search.h"

/* The polygons with one of n edges, or of the triangles with a vertex. */
static bool
add_members(sg_call *call, const sg_version *version, sg_relation relation,
            int32_t s, const int32_t *member, size_t n, sg_int_list *out)
{
  sg_walk walk;
  bool good = true;

  if (!sg_walk_open_members(&walk, version, relation, s, member, n)) {
    return sg_call_no_memory(call);
  }
  for (sg_row r; good && (r = sg_walk_next(&walk)) != SG_NO_ROW;) {
    good =
        sg_int_list_add(call, out, sg_version_value(version, relation, r, 1).i);
  }
  sg_walk_close(&walk);
  return good;
}

static bool
add_of_edges(sg_call *call, const sg_version *version, int32_t s, int32_t v,
             sg_int_list *out)
{
  const sg_value from[SG_MAX_COLUMNS] = {[0].i = s, [2].i = v};
  sg_int_list edges = {0};
  sg_walk walk;
  bool good = true;

  if (!sg_walk_open(&walk, version, SG_E, 1 << 0 | 1 << 2, from)) {
    return sg_call_no_memory(call);
  }
  for (sg_row r; good && (r = sg_walk_next(&walk)) != SG_NO_ROW;) {
    good =
        sg_int_list_add(call, &edges, sg_version_value(version, SG_E, r, 1).i);
  }
  sg_walk_close(&walk);
  return good && (edges.n == 0 ||
                  add_members(call, version, SG_P, s, edges.at, edges.n, out));
}

bool
sg_polygons_at(sg_call *call, const sg_version *version, int32_t s, int32_t v,
               sg_int_list *out)
{
  size_t from = out->n;

  if (!add_of_edges(call, version, s, v, out) ||
      (out->n == from && !add_members(call, version, SG_T, s, &v, 1, out))) {
    return false;
  }
  if (out->n > from) {
    out->n = from + sg_sort_ids(out->at + from, out->n - from);
  }
  return true;
}
