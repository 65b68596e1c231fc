/* vertex_polygons_rows.c -- see vertex_polygons_rows.h. */
#include "vertex_polygons_rows.h"

#include "engine/search.h"

/* The polygons with an edge, or of the triangles with a vertex. */
static bool
add_members(sg_call *call, const sg_version *version, sg_relation relation,
            int32_t s, int32_t member, sg_int_list *out)
{
  sg_walk walk;
  bool good = true;

  if (!sg_walk_open_member(&walk, version, relation, s, member)) {
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
  sg_walk walk;
  bool good = true;

  if (!sg_walk_open(&walk, version, SG_E, 1 << 0 | 1 << 2, from)) {
    return sg_call_no_memory(call);
  }
  for (sg_row r; good && (r = sg_walk_next(&walk)) != SG_NO_ROW;) {
    int32_t e = sg_version_value(version, SG_E, r, 1).i;

    good = add_members(call, version, SG_P, s, e, out);
  }
  sg_walk_close(&walk);
  return good;
}

bool
sg_polygons_at(sg_call *call, const sg_version *version, int32_t s, int32_t v,
               sg_int_list *out)
{
  size_t from = out->n;

  if (!add_of_edges(call, version, s, v, out) ||
      (out->n == from && !add_members(call, version, SG_T, s, v, out))) {
    return false;
  }
  if (out->n > from) {
    out->n = from + sg_sort_ids(out->at + from, out->n - from);
  }
  return true;
}
