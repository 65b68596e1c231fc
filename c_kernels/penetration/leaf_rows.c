/* leaf_rows.c -- polygons as they are before a cut, kept.
 *
 * Layer: rows. The fused kernel of leaf.pl, leaves_kept_by_rule/1: the same
 * rows in the same order; a test holds the two together. The door is documented
 * in rules/kernel/world.pl.
 */
#include "leaf_rows.h"

#include "doors/world.h"
#include "engine/list.h"
#include "rows/key_table.h"

#include <stdlib.h>

enum { ASKED = 512, COLUMNS = 6 }; /* polygons between questions */

/* Rows of leaf_e/5, leaf_p/3 or leaf_t/6, as columns. */
typedef struct leaf_rows {
  size_t n, room;
  int32_t *i[COLUMNS];
  const int32_t **list; /* of leaf_p/3: the version's */
} leaf_rows;

typedef struct keeping {
  const sg_version *version;
  sg_key_table seen; /* segment, edge: in `e`, or kept before */
  leaf_rows e, p, t;
} keeping;

static void
rows_clear(leaf_rows *rows)
{
  for (int c = 0; c < COLUMNS; c++) {
    free(rows->i[c]);
  }
  free(rows->list);
}

static bool
make_room(leaf_rows *rows)
{
  for (int c = 0; c < COLUMNS; c++) {
    size_t room = rows->room; /* of all */

    if (!sg_list_grow(&rows->i[c], rows->n, &room, sizeof *rows->i[c])) {
      return false;
    }
  }
  return sg_list_grow(&rows->list, rows->n, &rows->room, sizeof(int32_t *));
}

/* A row of a relation once more, lists by reference. */
static bool
copy_row(const keeping *k, sg_relation from, sg_row row, leaf_rows *to)
{
  const sg_relation_info *info = &sg_relation_table[from];

  if (!make_room(to)) {
    return false;
  }
  for (unsigned c = 0; c < info->arity; c++) {
    sg_value value = sg_version_value(k->version, from, row, c);
    if (info->column[c].type == SG_LIST) {
      to->list[to->n] = value.list;
    } else {
      to->i[c][to->n] = value.i;
    }
  }
  to->n++;
  return true;
}

static sg_row
find(const keeping *k, sg_relation relation, int32_t s, int32_t id)
{
  return sg_version_find(k->version, relation,
                         (sg_value[SG_MAX_COLUMNS]){{.i = s}, {.i = id}});
}

/* false without an exception: there is no such edge. */
static bool
keep_edge(sg_call *call, keeping *k, int32_t s, int32_t e)
{
  uint32_t *seen =
      sg_key_table_put(&k->seen, (uint32_t[2]){(uint32_t)s, (uint32_t)e});
  sg_row row;

  if (!seen || *seen == 1) {
    return seen || sg_call_no_memory(call);
  }
  *seen = 1;
  if (find(k, SG_LEAF_E, s, e) != SG_NO_ROW) {
    return true;
  }
  row = find(k, SG_E, s, e);
  return row != SG_NO_ROW &&
         (copy_row(k, SG_E, row, &k->e) || sg_call_no_memory(call));
}

static bool
keep_triangles(keeping *k, int32_t s, int32_t p)
{
  const sg_value key[SG_MAX_COLUMNS] = {{.i = s}, {.i = p}};
  sg_walk walk;
  bool good = sg_walk_open(&walk, k->version, SG_T, 0x03, key);

  if (!good) {
    return false;
  }
  for (sg_row row; good && (row = sg_walk_next(&walk)) != SG_NO_ROW;) {
    good = copy_row(k, SG_T, row, &k->t);
  }
  sg_walk_close(&walk);
  return good;
}

/* false without an exception: there is no such polygon, or an edge of it is
 * not there. */
static bool
keep_polygon(sg_call *call, keeping *k, int32_t s, int32_t p)
{
  sg_row row;
  bool good = true;

  if (find(k, SG_LEAF_P, s, p) != SG_NO_ROW) {
    return true;
  }
  if ((row = find(k, SG_P, s, p)) == SG_NO_ROW) {
    return false;
  }
  const int32_t *list = sg_version_value(k->version, SG_P, row, 2).list;

  for (int32_t i = 1; i <= list[0] && good; i++) {
    good = keep_edge(call, k, s, list[i]);
  }
  return good && ((copy_row(k, SG_P, row, &k->p) && keep_triangles(k, s, p)) ||
                  sg_call_no_memory(call));
}

static bool
keep_all(sg_call *call, keeping *k, const sg_segment_polygon_list *polygons)
{
  sg_key_table known; /* polygons of this list */
  bool good = true;

  sg_key_table_init(&known, 2);
  for (size_t i = 0; good && i < polygons->n; i++) {
    int32_t s = polygons->at[i].s, p = polygons->at[i].p;
    uint32_t *there =
        sg_key_table_put(&known, (uint32_t[2]){(uint32_t)s, (uint32_t)p});

    good = there || sg_call_no_memory(call);
    if (good && *there == SG_NO_KEY) {
      *there = 1;
      good = keep_polygon(call, k, s, p);
    }
    good = good && (i % ASKED != ASKED - 1 || !sg_cancelled(&call->cancel));
  }
  sg_key_table_clear(&known);
  return good;
}

static bool
add_rows(sg_call *call, sg_world *world, sg_relation relation,
         const leaf_rows *rows)
{
  const void *column[COLUMNS] = {0};

  for (unsigned c = 0; c < sg_relation_table[relation].arity; c++) {
    bool list = sg_relation_table[relation].column[c].type == SG_LIST;
    column[c] = list ? (const void *)rows->list : (const void *)rows->i[c];
  }
  return sg_call_add_rows(call, world, relation, rows->n, column);
}

bool
sg_leaves_keep(sg_call *call, sg_world *world,
               const sg_segment_polygon_list *polygons)
{
  keeping k = {.version = sg_world_version(world)};

  sg_key_table_init(&k.seen, 2);
  bool good = keep_all(call, &k, polygons) &&
              add_rows(call, world, SG_LEAF_E, &k.e) &&
              add_rows(call, world, SG_LEAF_P, &k.p) &&
              add_rows(call, world, SG_LEAF_T, &k.t);

  sg_key_table_clear(&k.seen);
  rows_clear(&k.e);
  rows_clear(&k.p);
  rows_clear(&k.t);
  sg_version_drop(k.version);
  return good;
}

bool
sg_door_leaves_keep(sg_call *call, const sg_segment_polygon_list *polygons)
{
  sg_world *world = sg_call_claim(call);
  bool good = world && sg_leaves_keep(call, world, polygons);

  if (world) {
    sg_world_release(world);
  }
  return good;
}
