/* exchange.c -- some rows of many are exchanged for others, unchecked. */
#include "world.h"

static sg_value
value_at(const sg_relation_info *info, const void *const *column, unsigned c,
         size_t i)
{
  sg_value value = {0};

  switch (info->column[c].type) {
  case SG_INT:
  case SG_ATOM:
    value.i = ((const int32_t *)column[c])[i];
    break;
  case SG_FLOAT:
    value.f = ((const double *)column[c])[i];
    break;
  case SG_LIST:
    value.list = ((const int32_t *const *)column[c])[i];
    break;
  case SG_TERM:
    value.term = ((const uint32_t *const *)column[c])[i];
    break;
  }
  return value;
}

static bool
is_empty(const sg_live *live)
{
  for (unsigned w = 0; w < SG_LIVE_WORDS; w++) {
    if (live->word[w]) {
      return false;
    }
  }
  return true;
}

/* The first of the rows that are on one page live no more; 0: no memory, else
 * how many they are. */
static size_t
hide_on_page(sg_world *world, sg_map *map, sg_relation relation,
             const sg_row *row, size_t n)
{
  size_t number = row[0] / SG_PAGE_ROWS, i = 0;
  sg_page *page = world->table[relation].page[number];
  sg_live *live = sg_map_own_live(map, page, number);
  int32_t stamped = 0;

  for (; live && i < n && row[i] / SG_PAGE_ROWS == number; i++) {
    unsigned place = row[i] % SG_PAGE_ROWS;
    int32_t s = page->cells[0].i[place];
    if (s != stamped && !sg_world_stamp(world, map, relation, s)) {
      return 0;
    }
    stamped = s;
    live->word[place / 64] &= ~(UINT64_C(1) << place % 64);
    map->rows--;
  }
  if (live && is_empty(live)) {
    sg_map_empty_page(map, number);
  }
  return i;
}

/* Rows live no more; a sweep finds their slots. False: no memory. */
static bool
hide_rows(sg_world *world, sg_relation relation, const sg_row *row, size_t n)
{
  sg_map *map = sg_world_own_map(world, relation);
  size_t done = 0, now = 1;

  while (map && now > 0 && done < n) {
    now = hide_on_page(world, map, relation, row + done, n - done);
    done += now;
  }
  return done == n && map;
}

/* False: no memory. */
static bool
put_rows(sg_world *world, sg_relation relation, size_t n,
         const void *const *column)
{
  sg_table *table = &world->table[relation];
  sg_map *map = sg_world_own_map(world, relation);
  bool good = map != NULL;

  for (size_t i = 0; good && i < n; i++) {
    sg_value value[SG_MAX_COLUMNS] = {{0}};
    for (unsigned c = 0; c < table->info->arity; c++) {
      value[c] = value_at(table->info, column, c, i);
    }
    sg_row slot = sg_table_slot(table);
    good = slot != SG_NO_ROW &&
           sg_world_put_row(world, map, relation, slot, value);
  }
  return good;
}

/* Others may refer to them: pictures, and what a user added by hand. */
static bool
mark_rows(sg_world *world, sg_relation relation, const sg_row *gone, size_t n)
{
  bool good = true;
  int32_t s, id;

  for (size_t i = 0; i < n && good; i++) {
    const sg_page *page = sg_table_page(&world->table[relation], gone[i]);
    good = !sg_page_pair(page, relation, gone[i] % SG_PAGE_ROWS, &s, &id) ||
           sg_world_mark_gone(world, relation, SG_MARK_MADE, false, s, id);
  }
  return good;
}

bool
sg_world_exchange(sg_world *world, sg_relation relation, const sg_row *gone,
                  size_t gones, size_t n, const void *const *column)
{
  bool good = true;

  sg_world_enter(world);
  if (gones + n > 0) {
    sg_world_sweep_if_worth(world, relation, n, true);
    good = mark_rows(world, relation, gone, gones) &&
           hide_rows(world, relation, gone, gones) &&
           put_rows(world, relation, n, column);
    sg_world_changed(world);
  }
  sg_world_leave(world);
  return good;
}
