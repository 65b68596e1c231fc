/* polygon_rows.c -- see polygon_rows.h. */
#include "polygon_rows.h"

#include <string.h>

/* ---- rows ---- */

sg_row
sg_row_now(sg_world *world, sg_relation relation, int32_t s, int32_t id,
           sg_value out[SG_MAX_COLUMNS])
{
  sg_value key[SG_MAX_COLUMNS] = {[0].i = s, [1].i = id};
  const sg_version *version = sg_world_version(world);
  sg_row row = sg_version_find(version, relation, key);

  for (unsigned c = 0;
       out && row != SG_NO_ROW && c < sg_relation_table[relation].arity; c++) {
    out[c] = sg_version_value(version, relation, row, c);
  }
  sg_version_drop(version);
  return row;
}

bool
sg_edge_runs(sg_world *world, int32_t s, int32_t e, int32_t v1, int32_t v2)
{
  sg_value row[SG_MAX_COLUMNS];

  return sg_row_now(world, SG_E, s, e, row) != SG_NO_ROW && row[2].i == v1 &&
         row[3].i == v2;
}

/* ---- origins ---- */

const uint32_t *
sg_unary_term(sg_call *call, int32_t symbol, int32_t id)
{
  sg_term_builder b;

  sg_term_open(&b);
  sg_term_unary(&b, symbol, id);
  return sg_call_term(call, &b);
}

bool
sg_origin_is_there(sg_world *world, int32_t s, const uint32_t *item)
{
  const sg_value key[SG_MAX_COLUMNS] = {[0].i = s, [1].term = item};
  const sg_version *version = sg_world_version(world);
  bool known = sg_version_find(version, SG_ORIGIN, key) != SG_NO_ROW;

  sg_version_drop(version);
  return known;
}

/* ---- edges ---- */

int32_t *
sg_polygon_retract(sg_call *call, sg_world *world, int32_t s, int32_t p)
{
  sg_value value[SG_MAX_COLUMNS];
  sg_row row = sg_row_now(world, SG_P, s, p, value);

  if (row == SG_NO_ROW) {
    return NULL;
  }
  size_t bytes = ((size_t)value[2].list[0] + 1) * sizeof(int32_t);
  int32_t *list = sg_call_alloc(call, bytes);

  if (list) {
    memcpy(list, value[2].list, bytes);
  }
  return list && (sg_world_retract(world, SG_P, row) || sg_call_no_memory(call))
             ? list
             : NULL;
}

bool
sg_edge_is_same(sg_call *call, sg_key_table *same, int32_t e, int32_t v1,
                int32_t v2)
{
  const uint32_t key[3] = {(uint32_t)e, (uint32_t)v1, (uint32_t)v2};
  uint32_t *known = sg_key_table_put(same, key);

  if (known) {
    *known = 1;
  }
  return known || sg_call_no_memory(call);
}

/* Whether a polygon has edge e of segment s. */
static bool
is_used(sg_world *world, int32_t s, int32_t e, sg_cut_handle *set)
{
  if (set && !sg_cut_shares_edges(set, s)) {
    return false;
  }
  const sg_version *version = sg_world_version(world);
  bool used = sg_version_has_member(version, SG_P, s, e);

  sg_version_drop(version);
  return used;
}

bool
sg_edges_drop(sg_call *call, sg_world *world, int32_t s, const int32_t *list,
              const sg_key_table *same, sg_cut_handle *set)
{
  for (int32_t i = 1; i <= list[0]; i++) {
    sg_value value[SG_MAX_COLUMNS];
    sg_row row = sg_row_now(world, SG_E, s, list[i], value);

    if (row == SG_NO_ROW) {
      continue;
    }
    const uint32_t key[3] = {(uint32_t)list[i], (uint32_t)value[2].i,
                             (uint32_t)value[3].i};

    if (sg_key_table_get(same, key) == SG_NO_KEY &&
        !is_used(world, s, list[i], set) &&
        !sg_world_retract(world, SG_E, row)) {
      return sg_call_no_memory(call);
    }
  }
  return true;
}

/* ---- triangles ---- */

/* The rows of t/6 of a polygon, in order. */
static bool
find_triangles(sg_call *call, sg_world *world, int32_t s, int32_t p,
               sg_count_list *out)
{
  const sg_value key[SG_MAX_COLUMNS] = {[0].i = s, [1].i = p};
  const sg_version *version = sg_world_version(world);
  sg_walk walk;
  bool good =
      sg_walk_open(&walk, version, SG_T, 0x03, key) || sg_call_no_memory(call);

  if (good) {
    for (sg_row row; good && (row = sg_walk_next(&walk)) != SG_NO_ROW;) {
      good = sg_count_list_add(call, out, row);
    }
    sg_walk_close(&walk);
  }
  sg_version_drop(version);
  return good;
}

bool
sg_triangles_drop(sg_call *call, sg_world *world, int32_t s, int32_t p)
{
  sg_count_list old = {0};

  if (!find_triangles(call, world, s, p, &old)) {
    return false;
  }
  for (size_t i = 0; i < old.n; i++) {
    if (!sg_world_retract(world, SG_T, (sg_row)old.at[i])) {
      return sg_call_no_memory(call);
    }
  }
  return true;
}
