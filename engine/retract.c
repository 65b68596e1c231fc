/* retract.c -- retracting rows: one, all, those with an id. */
#include "world.h"

#include <stdlib.h>
#include <string.h>

/* ---- one row ------------------------------------------------------------- */

/* True if a version other than the current one shows the row; with many
 * versions the answer is true without a search. */
static bool
shown_elsewhere(const sg_world *world, sg_relation relation, sg_row row)
{
  const sg_map *seen = NULL;
  unsigned n = 0;

  for (const sg_version *v = world->versions; v; v = v->next) {
    if (v == world->current || v->map[relation] == seen) {
      continue;
    }
    seen = v->map[relation];
    if (++n > 100 || sg_map_shows(seen, row)) {
      return true;
    }
  }
  return false;
}

/* Column 0 of a row: its segment, if it is an id. */
static int32_t
first_id(const sg_table *table, sg_row row)
{
  return sg_page_value(sg_table_page(table, row), table->info, 0,
                       row % SG_PAGE_ROWS)
      .i;
}

bool
sg_world_remove(sg_world *world, sg_relation relation, sg_row row)
{
  sg_table *table = &world->table[relation];
  sg_map *map;
  sg_live *live;

  if (!sg_map_shows(world->current->map[relation], row)) {
    return false;
  }
  if (!(map = sg_world_own_map(world, relation)) ||
      !(live = sg_map_own_live(map, sg_table_page(table, row),
                               row / SG_PAGE_ROWS)) ||
      !sg_world_stamp(world, map, relation, first_id(table, row))) {
    return false;
  }
  live->word[row % SG_PAGE_ROWS / 64] &= ~(UINT64_C(1) << row % 64);
  map->rows--;
  if (!shown_elsewhere(world, relation, row)) {
    sg_table_unlink(table, row);
    sg_table_vacate(table, row);
  }
  return true;
}

bool
sg_page_pair(const sg_page *page, sg_relation relation, unsigned place,
             int32_t *s, int32_t *id)
{
  unsigned column = sg_relation_id_column(relation);

  if (column == SG_MAX_COLUMNS || column == 0) {
    return false;
  }
  *s = page->cells[0].i[place];
  *id = page->cells[column].i[place];
  return true;
}

/* `made`: by a kernel, which leaves no row without what it refers to but those
 * of derived relations. */
static bool
retract_one(sg_world *world, sg_relation relation, sg_row row, bool made)
{
  bool done;
  int32_t s, id;

  sg_world_enter(world);
  done = sg_map_shows(world->current->map[relation], row);
  if (done && made &&
      sg_page_pair(sg_table_page(&world->table[relation], row), relation,
                   row % SG_PAGE_ROWS, &s, &id)) {
    done = sg_world_mark_gone(world, relation, SG_MARK_MADE, true, s, id);
  }
  done = done && sg_world_remove(world, relation, row);
  if (done) {
    sg_world_changed(world);
  }
  sg_world_leave(world);
  return done;
}

bool
sg_world_retract(sg_world *world, sg_relation relation, sg_row row)
{
  return retract_one(world, relation, row, true);
}

bool
sg_world_hide(sg_world *world, sg_relation relation, sg_row row)
{
  return retract_one(world, relation, row, false);
}

/* An empty map that remembers the ids used. */
static bool
empty_map(sg_map **map, uint64_t stamp)
{
  sg_map *empty = calloc(1, sizeof(*empty));

  if (!empty) {
    return false;
  }
  empty->holders = 1;
  empty->ids = sg_ids_hold((*map)->ids);
  if (!sg_map_stamp_all(empty, stamp)) {
    sg_map_drop(empty);
    return false;
  }
  sg_map_drop(*map);
  *map = empty;
  return true;
}

static bool
retract_all(sg_world *world, sg_relation relation, bool again)
{
  sg_version *version;
  bool done = true;

  sg_world_enter(world);
  if (world->current->map[relation] &&
      world->current->map[relation]->rows > 0) {
    version = sg_world_own(world);
    done = version &&
           (again || sg_world_mark_gone(world, relation, SG_MARK_MADE_ALL, true,
                                        0, 0)) &&
           empty_map(&version->map[relation], ++world->stamps);
    if (done) {
      /* The version before may be held yet; the next rows are worth a sweep. */
      world->table[relation].written = world->table[relation].slots;
      sg_world_changed(world);
    }
  }
  sg_world_leave(world);
  return done;
}

bool
sg_world_retract_all(sg_world *world, sg_relation relation)
{
  return retract_all(world, relation, false);
}

bool
sg_world_retract_all_again(sg_world *world, sg_relation relation)
{
  return retract_all(world, relation, true);
}

/* ---- retracting many --------------------------------------------------- */

/* Of 64 rows those with an id: mostly all or none. */
static uint64_t
with_id(const int32_t *cell, int32_t id)
{
  int32_t differ = 0;
  uint64_t bits = 0;

  for (unsigned i = 0; i < 64; i++) {
    differ |= cell[i] ^ id;
  }
  if (differ == 0) {
    return UINT64_MAX;
  }
  for (unsigned i = 0; i < 64; i++) {
    bits |= (uint64_t)(cell[i] == id) << i;
  }
  return bits;
}

/* Rows of a page by their bits, `gone`. */
static bool
find_gone(const sg_live *live, unsigned column, int32_t id, uint64_t *gone)
{
  const int32_t *cell = live->page->cells[column].i;
  uint64_t any = 0;

  for (unsigned w = 0; w < SG_LIVE_WORDS; w++) {
    gone[w] = live->word[w] ? live->word[w] & with_id(cell + w * 64, id) : 0;
    any |= gone[w];
  }
  return any != 0;
}

/* A new stamp for each segment that loses rows of a page. */
static bool
stamp_gone(sg_world *world, sg_map *map, sg_relation relation,
           const sg_page *page, const uint64_t *gone)
{
  int32_t stamped = 0;

  for (unsigned r = sg_live_next(gone, 0); r < SG_PAGE_ROWS;
       r = sg_live_next(gone, r + 1)) {
    int32_t s = page->cells[0].i[r];
    if (s != stamped && !sg_world_stamp(world, map, relation, s)) {
      return false;
    }
    stamped = s;
  }
  return true;
}

/* The rows with this id in a column, of one page. Their slots are found by a
 * sweep. */
static bool
hide_rows(sg_world *world, sg_relation relation, size_t number, unsigned column,
          int32_t id, const uint64_t *gone)
{
  sg_page *page = world->table[relation].page[number];
  sg_map *map = sg_world_own_map(world, relation);
  sg_live *live = map ? sg_map_own_live(map, page, number) : NULL;
  uint64_t left = 0;

  if (!live || !(column == 0 ? sg_world_stamp(world, map, relation, id)
                             : stamp_gone(world, map, relation, page, gone))) {
    return false;
  }
  for (unsigned w = 0; w < SG_LIVE_WORDS; w++) {
    live->word[w] &= ~gone[w];
    left |= live->word[w];
    map->rows -= (size_t)__builtin_popcountll(gone[w]);
  }
  if (left == 0) {
    sg_map_empty_page(map, number);
  }
  return true;
}

static bool
retract_with(sg_world *world, sg_relation relation, unsigned column, int32_t id)
{
  size_t pages = world->table[relation].pages;
  bool changed = false, good = true;

  for (size_t i = 0; i < pages && good; i++) {
    const sg_live *live = sg_map_live(world->current->map[relation], i);
    uint64_t gone[SG_LIVE_WORDS];
    bool may = live && (column > 0 || sg_page_may_have(live->page, id));
    if (may && find_gone(live, column, id, gone)) {
      good = hide_rows(world, relation, i, column, id, gone);
      changed = true;
    }
  }
  if (changed) {
    sg_world_changed(world);
  }
  return good;
}

bool
sg_world_retract_with(sg_world *world, sg_relation relation, unsigned column,
                      int32_t id)
{
  bool good;

  sg_world_enter(world);
  good = retract_with(world, relation, column, id);
  sg_world_leave(world);
  return good;
}

static bool
has_of(const sg_world *world, sg_relation relation, int32_t s)
{
  const sg_map *map = world->current->map[relation];
  size_t pages = map ? map->chunks * SG_CHUNK_PAGES : 0;

  for (size_t i = 0; i < pages; i++) {
    const sg_live *live = sg_map_live(map, i);
    if (!live || !sg_page_may_have(live->page, s)) {
      continue;
    }
    for (unsigned r = sg_live_next(live->word, 0); r < SG_PAGE_ROWS;
         r = sg_live_next(live->word, r + 1)) {
      if (live->page->cells[0].i[r] == s) {
        return true;
      }
    }
  }
  return false;
}

bool
sg_world_has_of(sg_world *world, sg_relation relation, int32_t s)
{
  bool has;

  sg_world_enter(world);
  has = has_of(world, relation, s);
  sg_world_leave(world);
  return has;
}
