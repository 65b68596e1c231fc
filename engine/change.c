/* change.c -- adding and retracting rows, checked against the schema. */
#include "world.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- checks ------------------------------------------------------------ */

bool
sg_value_is_valid(const sg_relation_info *info, unsigned column, sg_value value)
{
  switch (info->column[column].type) {
  case SG_INT:
    return value.i >= 1 || info->domain[column] || /* glue knows its words */
           (info->with_sign[column] && value.i != 0 && value.i != INT32_MIN);
  case SG_ATOM:
    return value.i >= 0;
  case SG_FLOAT:
    return info->most[column] > 0 ? fabs(value.f) <= info->most[column]
                                  : isfinite(value.f);
  case SG_LIST:
    for (int32_t i = 1; i <= value.list[0]; i++) {
      if (value.list[i] < 1) {
        return false;
      }
    }
    return value.list[0] >= 0;
  case SG_TERM:
    return value.term != NULL;
  }
  return false;
}

bool
sg_world_key_ready(sg_world *world, sg_relation relation)
{
  sg_table *table = &world->table[relation];

  return table->info->key == 0 || sg_index_build(&table->index[0], table);
}

/* True if row (s, id) of a relation whose key is two ids lives. */
static bool
refers(sg_world *world, sg_relation relation, int32_t s, int32_t id)
{
  sg_value key[SG_MAX_COLUMNS] = {{.i = s}};

  key[sg_relation_id_column(relation)].i = id;
  return sg_table_find(&world->table[relation], world->current->map[relation],
                       key) != SG_NO_ROW;
}

sg_status
sg_world_check_reference(sg_world *world, sg_relation relation, unsigned column,
                         int32_t s, sg_value value, sg_fault *fault)
{
  const sg_relation_info *info = &sg_relation_table[relation];
  bool list = info->column[column].type == SG_LIST;
  bool negative = !list && info->with_sign[column] && value.i < 0;
  sg_relation to =
      negative ? info->negative[column] : info->column[column].refers;
  const int32_t one = negative ? -value.i : value.i;
  const int32_t *id = list ? value.list + 1 : &one;
  int32_t n = list ? value.list[0] : 1;

  if (!sg_index_build(&world->table[to].index[0], &world->table[to])) {
    return SG_NO_MEMORY;
  }
  for (int32_t i = 0; i < n; i++) {
    if (!refers(world, to, s, id[i])) {
      *fault = (sg_fault){.column = column, .to = to, .s = s, .id = id[i]};
      return SG_DANGLING;
    }
  }
  return SG_OK;
}

static sg_status
check_references(sg_world *world, sg_relation relation, const sg_value *row,
                 sg_fault *fault)
{
  const sg_relation_info *info = &sg_relation_table[relation];

  for (unsigned c = 0; c < info->arity; c++) {
    unsigned in = sg_relation_segment_column(relation, c);
    sg_status status = SG_OK;
    if (info->column[c].refers != SG_NONE) {
      status = sg_world_check_reference(world, relation, c, row[in].i, row[c],
                                        fault);
    }
    if (status != SG_OK) {
      return status;
    }
  }
  return SG_OK;
}

static sg_status
check_values(const sg_relation_info *info, const sg_value *row, sg_fault *fault)
{
  for (unsigned c = 0; c < info->arity; c++) {
    if (!sg_value_is_valid(info, c, row[c])) {
      *fault = (sg_fault){.column = c};
      return SG_INVALID;
    }
  }
  return SG_OK;
}

static sg_status
check_key(sg_world *world, sg_relation relation, const sg_value *row,
          sg_fault *fault)
{
  sg_table *table = &world->table[relation];

  if (table->info->key == 0) {
    return SG_OK;
  }
  if (!sg_index_build(&table->index[0], table)) {
    return SG_NO_MEMORY;
  }
  if (sg_table_find(table, world->current->map[relation], row) != SG_NO_ROW) {
    *fault = (sg_fault){0};
    return SG_EXISTS;
  }
  return SG_OK;
}

/* Everything that can be wrong with a row, but no memory. `early`: null, or
 * true is put there if a row that it refers to is not there yet. */
static sg_status
check_row(sg_world *world, sg_relation relation, const sg_value *row,
          bool *early, sg_fault *fault)
{
  sg_status status = check_values(&sg_relation_table[relation], row, fault);

  if (status == SG_OK) {
    status = check_references(world, relation, row, fault);
  }
  if (status == SG_DANGLING && early) {
    *early = true;
    status = SG_OK;
  }
  return status == SG_OK ? check_key(world, relation, row, fault) : status;
}

/* ---- slots ------------------------------------------------------------- */

enum {
  LEAST_SLOTS = 8 * SG_PAGE_ROWS, /* to be swept for rows in bulk */
  LEAST_BYTES = 1 << 20           /* of lists and terms, to be swept for them */
};

/* Slots for n rows without a new page; rows in bulk want them in a row. */
static bool
has_room(sg_table *table, size_t n, bool single)
{
  size_t end = (SG_PAGE_ROWS - table->slots % SG_PAGE_ROWS) % SG_PAGE_ROWS;
  size_t vacancies = sg_table_vacancies(table);

  return single ? table->emptied + vacancies + end >= n
                : vacancies >= n || end >= n ||
                      sg_table_gap(table, n) != SG_NO_ROW;
}

/* For n rows more, of which `dead` slots may have room. */
static bool
wants_slots(sg_table *table, size_t dead, size_t n, bool single)
{
  return !has_room(table, n, single) && table->written >= table->slots / 8 &&
         dead >= table->slots / 4 && table->slots >= (single ? 1 : LEAST_SLOTS);
}

/* Dead rows may be few and have long lists or terms. */
static bool
wants_bytes(const sg_table *table)
{
  return table->arena.bytes > 2 * table->swept_bytes + LEAST_BYTES;
}

void
sg_world_sweep_if_worth(sg_world *world, sg_relation relation, size_t n,
                        bool single)
{
  sg_table *table = &world->table[relation];
  const sg_map *map = world->current->map[relation];
  size_t rows = map ? map->rows : 0;
  size_t dead = table->slots > rows ? table->slots - rows : 0;

  if (dead > 0 && (wants_bytes(table) || wants_slots(table, dead, n, single))) {
    sg_world_sweep(world, relation);
  }
}

void
sg_world_sweep(sg_world *world, sg_relation relation)
{
  size_t versions = 0;
  size_t n = 0;
  sg_map **map;

  for (sg_version *v = world->versions; v; v = v->next) {
    versions++;
  }
  if (!(map = malloc(versions * sizeof(sg_map *)))) {
    return; /* a sweep can wait */
  }
  for (sg_version *v = world->versions; v; v = v->next) {
    if (n == 0 || map[n - 1] != v->map[relation]) {
      map[n++] = v->map[relation];
    }
  }
  sg_table_sweep(&world->table[relation], map, n);
  free(map);
}

sg_map *
sg_world_own_map(sg_world *world, sg_relation relation)
{
  sg_version *version = sg_world_own(world);

  return version ? sg_map_own(&version->map[relation]) : NULL;
}

void
sg_world_changed(sg_world *world)
{
  world->changes++;
  if (world->open.count == 0) {
    sg_stack_clear(&world->redo);
  }
}

/* ---- adding ------------------------------------------------------------ */

bool
sg_world_stamp(sg_world *world, sg_map *map, sg_relation relation, int32_t s)
{
  unsigned column = sg_relation_id_column(relation);

  return column == SG_MAX_COLUMNS ||
         sg_map_set_stamp(map, column == 0 ? 0 : s, ++world->stamps);
}

static bool
used_ids(sg_map *map, sg_relation relation, const sg_value *row)
{
  unsigned column = sg_relation_id_column(relation);

  return column == SG_MAX_COLUMNS ||
         sg_map_used_id(map, column == 0 ? 0 : row[0].i, row[column].i);
}

bool
sg_world_put_row(sg_world *world, sg_map *map, sg_relation relation,
                 sg_row slot, const sg_value *row)
{
  sg_table *table = &world->table[relation];
  sg_live *live =
      sg_map_own_live(map, sg_table_page(table, slot), slot / SG_PAGE_ROWS);

  if (!live || !used_ids(map, relation, row) ||
      !sg_world_stamp(world, map, relation, row[0].i) ||
      !sg_table_write(table, slot, row)) {
    return false;
  }
  sg_table_link(table, slot);
  live->word[slot % SG_PAGE_ROWS / 64] |= UINT64_C(1) << slot % 64;
  map->rows++;
  return true;
}

/* `early`: null, or whether the row came before one that it refers to. */
static sg_status
add(sg_world *world, sg_relation relation, const sg_value *row, bool *early,
    sg_row *out, sg_fault *fault)
{
  sg_status status = check_row(world, relation, row, early, fault);
  sg_map *map;
  sg_row slot;

  if (status != SG_OK) {
    return status;
  }
  if (!(map = sg_world_own_map(world, relation))) {
    return SG_NO_MEMORY;
  }
  sg_world_sweep_if_worth(world, relation, 1, true);
  slot = sg_table_slot(&world->table[relation]);
  if (slot == SG_NO_ROW || !sg_world_put_row(world, map, relation, slot, row)) {
    return SG_NO_MEMORY; /* the slot is found again by a sweep */
  }
  *out = slot;
  return SG_OK;
}

sg_status
sg_world_add(sg_world *world, sg_relation relation, const sg_value *row,
             sg_row *out, sg_fault *fault)
{
  sg_row unused_row;
  sg_fault unused_fault;
  sg_status status;

  sg_world_enter(world);
  status = add(world, relation, row, NULL, out ? out : &unused_row,
               fault ? fault : &unused_fault);
  if (status == SG_OK) {
    sg_world_changed(world);
  }
  sg_world_leave(world);
  return status;
}

sg_status
sg_world_add_edit(sg_world *world, sg_relation relation, const sg_value *row,
                  sg_row *out, sg_fault *fault)
{
  bool early = false;
  sg_status status;

  sg_world_enter(world);
  status = add(world, relation, row, &early, out, fault);
  if (status == SG_OK && early && !sg_world_mark_row(world, relation, *out)) {
    sg_world_remove(world, relation, *out);
    status = SG_NO_MEMORY;
  }
  if (status == SG_OK) {
    sg_world_changed(world);
  }
  sg_world_leave(world);
  return status;
}

/* ---- ids ---------------------------------------------------------------- */

int32_t
sg_world_fresh(sg_world *world, sg_relation relation, int32_t s)
{
  int32_t id = -1;
  sg_map *map;

  if (sg_relation_id_column(relation) == SG_MAX_COLUMNS) {
    return 0;
  }
  sg_world_enter(world);
  map = sg_world_own_map(world, relation);
  int32_t last = map ? sg_map_last_id(map, s) : 0;
  if (last == INT32_MAX) {
    id = 0;
  } else if (map && sg_map_used_id(map, s, last + 1)) {
    id = last + 1;
  }
  sg_world_leave(world);
  return id;
}
