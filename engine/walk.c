/* walk.c -- reading a version: values, views, walks over matching rows. */
#include "index_hash.h"
#include "list.h"
#include "search.h"
#include "world.h"

#include <stdlib.h>
#include <string.h>

enum { SOME_ROWS = 1 << 16 }; /* linked into an index between two questions */

/* ---- rows -------------------------------------------------------------- */

size_t
sg_version_count(const sg_version *version, sg_relation relation)
{
  const sg_map *map = version->map[relation];

  return map ? map->rows : 0;
}

bool
sg_version_live(const sg_version *version, sg_relation relation, sg_row row)
{
  return sg_map_shows(version->map[relation], row);
}

sg_value
sg_version_value(const sg_version *version, sg_relation relation, sg_row row,
                 unsigned column)
{
  const sg_live *live = sg_map_live(version->map[relation], row / SG_PAGE_ROWS);

  return sg_page_value(live->page, &sg_relation_table[relation], column,
                       row % SG_PAGE_ROWS);
}

const union sg_cell_array *
sg_version_cells(const sg_version *version, sg_relation relation, size_t page)
{
  return sg_map_live(version->map[relation], page)->page->cells;
}

void
sg_version_row(const sg_version *version, sg_relation relation, sg_row row,
               uint16_t mask, sg_value *out)
{
  const sg_live *live = sg_map_live(version->map[relation], row / SG_PAGE_ROWS);

  sg_page_row(live->page, &sg_relation_table[relation], mask,
              row % SG_PAGE_ROWS, out);
}

/* Without memory for the index of the key: each row is looked at. */
static sg_row
find_among_all(sg_table *table, const sg_map *map, const sg_value *row)
{
  const sg_relation_info *info = table->info;
  sg_row slots = (sg_row)(table->pages * SG_PAGE_ROWS);

  for (sg_row r = 0; map && r < slots; r++) {
    if (sg_map_shows(map, r) &&
        sg_page_match(sg_table_page(table, r), info, info->key,
                      r % SG_PAGE_ROWS, row)) {
      return r;
    }
  }
  return SG_NO_ROW;
}

sg_row
sg_version_find(const sg_version *version, sg_relation relation,
                const sg_value *row)
{
  sg_world *world = version->world;
  sg_table *table = &world->table[relation];
  sg_row found = SG_NO_ROW;

  if (table->info->key == 0) {
    return SG_NO_ROW;
  }
  pthread_mutex_lock(&world->lock);
  table->lookups++;
  found = sg_table_find_run(table, version->map[relation], row);
  if (found == SG_NO_ROW) {
    found = sg_index_build(&table->index[0], table)
                ? sg_table_find_indexed(table, version->map[relation], row)
                : find_among_all(table, version->map[relation], row);
  }
  pthread_mutex_unlock(&world->lock);
  return found;
}

sg_row
sg_version_find_counted(const sg_version *version, sg_relation relation,
                        const sg_value *row)
{
  sg_world *world = version->world;
  sg_table *table = &world->table[relation];
  sg_row found = SG_NO_ROW;

  if (table->info->key != 0) {
    pthread_mutex_lock(&world->lock);
    table->lookups++;
    found = sg_table_find_run(table, version->map[relation], row);
    pthread_mutex_unlock(&world->lock);
  }
  return found;
}

/* ---- views for kernels ------------------------------------------------- */

bool
sg_version_view(const sg_version *version, sg_relation relation, sg_view *out)
{
  static const uint64_t nobody[SG_LIVE_WORDS];
  const sg_relation_info *info = &sg_relation_table[relation];
  const sg_map *map = version->map[relation];
  size_t pages = map ? map->chunks * SG_CHUNK_PAGES : 0;
  const uint64_t **live = malloc((pages + 1) * sizeof(*live));

  *out = (sg_view){.live = live, .none = nobody};
  if (!live || (info->column[0].type == SG_INT &&
                !(out->span = malloc((pages + 1) * sizeof *out->span)))) {
    sg_view_clear(out);
    return false;
  }
  for (unsigned c = 0; c < info->arity; c++) {
    out->column[c].page = calloc(pages + 1, sizeof(sg_cells));
    if (!out->column[c].page) {
      sg_view_clear(out);
      return false;
    }
  }
  for (size_t i = 0; i < pages; i++) {
    const sg_live *page = sg_map_live(map, i);
    live[i] = page ? page->word : nobody;
    if (page && out->span) {
      out->span[i][0] = sg_page_first(page->page);
      out->span[i][1] = sg_page_last(page->page);
    }
    for (unsigned c = 0; page && c < info->arity; c++) {
      ((sg_cells *)out->column[c].page)[i].i = page->page->cells[c].i;
    }
    out->pages = page ? i + 1 : out->pages;
  }
  return true;
}

void
sg_view_clear(sg_view *view)
{
  free((void *)view->live);
  free(view->span);
  for (unsigned c = 0; c < SG_MAX_COLUMNS; c++) {
    free((void *)view->column[c].page);
  }
  *view = (sg_view){0};
}

/* ---- walks ------------------------------------------------------------- */

/* The index that narrows most: the key, else the one with most columns. */
static sg_index *
best_index(sg_table *table, uint16_t mask)
{
  sg_index *best = NULL;

  for (unsigned i = 0; i < table->indexes; i++) {
    sg_index *index = &table->index[i];
    if (index->members || (index->mask & mask) != index->mask) {
      continue;
    }
    if (!best ||
        (best->mask != table->info->key &&
         __builtin_popcount(index->mask) > __builtin_popcount(best->mask))) {
      best = index;
    }
  }
  return best;
}

static sg_row *
gathered_rows(sg_walk *walk)
{
  return walk->rows ? walk->rows : walk->few;
}

static bool
gather_row(sg_walk *walk, sg_row row)
{
  bool few = !walk->rows;

  if (!sg_list_grow(&walk->rows, walk->count, &walk->room, sizeof(row))) {
    return false;
  }
  if (few && walk->rows) {
    memcpy(walk->rows, walk->few, sizeof(walk->few));
  }
  gathered_rows(walk)[walk->count++] = row;
  return true;
}

/* Ascending and without doubles; chains mostly run from new to old. */
static void
order_rows(sg_walk *walk)
{
  sg_row *rows = gathered_rows(walk);
  size_t n = 0;

  for (size_t i = 0, j = walk->count; i + 1 < j; i++) {
    sg_row row = rows[i];
    rows[i] = rows[--j];
    rows[j] = row;
  }
  for (size_t i = 1; i < walk->count; i++) {
    if (rows[i - 1] >= rows[i]) {
      qsort(rows, walk->count, sizeof(*rows), sg_compare_numbers);
      break;
    }
  }
  for (size_t i = 0; i < walk->count; i++) {
    if (n == 0 || rows[n - 1] != rows[i]) {
      rows[n++] = rows[i];
    }
  }
  walk->count = n;
}

/* Gathers the rows of one chain that the version shows and that match. */
static bool
gather(sg_walk *walk, const sg_index *index, uint64_t hash)
{
  const sg_map *map = walk->version->map[walk->relation];

  for (uint32_t at = sg_index_first(index, hash); at != SG_NO_ROW;
       at = sg_index_next(index, at)) {
    sg_row row = sg_index_row(index, at);
    const sg_live *live = sg_map_live(map, row / SG_PAGE_ROWS);
    unsigned place = row % SG_PAGE_ROWS;
    if (live) {
      sg_page_fetch(live->page, walk->info, place);
    }
    if (live && (live->word[place / 64] >> place % 64 & 1) &&
        (!index->members || index->link[at].id == walk->row[1].i) &&
        sg_page_match(live->page, walk->info, walk->mask, place, walk->row)) {
      if (!gather_row(walk, row)) {
        return false;
      }
      if (index->mask == walk->info->key && !index->members) {
        break; /* there is only one */
      }
    }
  }
  if (walk->count > 1) {
    order_rows(walk);
  }
  return true;
}

/* The row with the key that is asked for, if it is in a run. */
static bool
gather_run(sg_walk *walk, const sg_table *table, const sg_index *index)
{
  const sg_map *map = walk->version->map[walk->relation];
  sg_row row = index == &table->index[0] && walk->info->key
                   ? sg_table_find_run(table, map, walk->row)
                   : SG_NO_ROW;

  if (row == SG_NO_ROW) {
    return false;
  }
  walk->gathered = true;
  if (sg_page_match(sg_table_page(table, row), walk->info, walk->mask,
                    row % SG_PAGE_ROWS, walk->row)) {
    walk->few[walk->count++] = row;
  }
  return true;
}

/* False: no row of the segment that is asked for is on the page. */
static bool
may_match(const sg_walk *walk, const sg_page *page)
{
  return !(walk->mask & 1) || walk->info->column[0].type != SG_INT ||
         sg_page_may_have(page, walk->row[0].i);
}

/* Gathers the rows with a member that is asked for: a look at all. */
static bool
gather_members(sg_walk *walk, const sg_table *table, const sg_index *index,
               const int32_t *member, size_t n)
{
  const sg_map *map = walk->version->map[walk->relation];
  size_t pages = map ? map->chunks * SG_CHUNK_PAGES : 0;

  for (size_t page = 0; page < pages; page++) {
    const sg_live *live = sg_map_live(map, page);
    if (!live || !may_match(walk, live->page)) {
      continue;
    }
    for (unsigned place = sg_live_next(live->word, 0); place < SG_PAGE_ROWS;
         place = sg_live_next(live->word, place + 1)) {
      sg_row row = (sg_row)(page * SG_PAGE_ROWS) + place;
      if (sg_index_row_has(index, table, row, walk->row[0].i, member, n) &&
          !gather_row(walk, row)) {
        return false;
      }
    }
  }
  return true;
}

static void
walk_init(sg_walk *walk, const sg_version *version, sg_relation relation,
          uint16_t mask)
{
  walk->version = version;
  walk->relation = relation;
  walk->info = &sg_relation_table[relation];
  walk->mask = mask;
  walk->live = NULL;
  walk->at = 0;
  walk->cancel = NULL;
  walk->stopped = false;
  walk->gathered = false;
  walk->rows = NULL;
  walk->room = SG_WALK_FEW;
  walk->count = walk->given = 0;
}

/* The index of members; null: there is none. */
static sg_index *
member_index(sg_table *table)
{
  sg_index *index = NULL;

  for (unsigned i = 0; i < table->indexes; i++) {
    index = table->index[i].members ? &table->index[i] : index;
  }
  return index;
}

bool
sg_index_ready(const sg_version *version, sg_relation relation, uint16_t mask,
               const sg_cancel *cancel)
{
  sg_world *world = version->world;
  sg_table *table = &world->table[relation];
  const sg_map *map = version->map[relation];
  bool done = !map || map->rows < SOME_ROWS;

  while (!done) {
    pthread_mutex_lock(&world->lock);
    sg_index *index = mask ? best_index(table, mask) : member_index(table);

    done = !index || sg_index_is_whole(index, table) ||
           !sg_index_pays(index, table) ||
           !sg_index_build_some(index, table, SOME_ROWS) ||
           sg_index_is_whole(index, table);
    pthread_mutex_unlock(&world->lock);
    if (!done && sg_cancelled(cancel)) {
      return false;
    }
  }
  return true;
}

/* True: no row of the segment that is asked for was ever there. */
static bool
has_never(const sg_walk *walk)
{
  const sg_map *map = walk->version->map[walk->relation];
  unsigned column = sg_relation_id_column(walk->relation);

  return (walk->mask & 1) && column != SG_MAX_COLUMNS && column != 0 &&
         (!map || !sg_ids_find(map->ids, walk->row[0].i));
}

/* An index of so many rows waits that it is to be made in steps. */
static bool
is_far_behind(const sg_walk *walk, const sg_index *index, const sg_table *table)
{
  const sg_map *map = walk->version->map[walk->relation];

  return map && map->rows >= SOME_ROWS && !sg_index_is_whole(index, table) &&
         sg_index_pays(index, table);
}

static sg_walk_opening
open_walk(sg_walk *walk, const sg_version *version, sg_relation relation,
          uint16_t mask, const sg_value *row, bool at_once)
{
  sg_world *world = version->world;
  sg_table *table = &world->table[relation];
  sg_index *index = best_index(table, mask);
  sg_walk_opening how = SG_WALK_OPEN;

  walk_init(walk, version, relation, mask);
  for (unsigned m = mask; m; m &= m - 1) {
    unsigned c = (unsigned)__builtin_ctz(m);
    walk->row[c] = row[c];
  }
  if (has_never(walk)) {
    walk->gathered = true;
    return how;
  }
  if (!index) {
    walk->live = sg_map_live(version->map[relation], 0);
    atomic_fetch_add_explicit(&table->scans, 1, memory_order_relaxed);
    return how;
  }
  pthread_mutex_lock(&world->lock);
  if (gather_run(walk, table, index)) {
    table->lookups++;
  } else if (!at_once && is_far_behind(walk, index, table)) {
    how = SG_WALK_WAITS;
  } else if (sg_index_pays(index, table) && sg_index_build(index, table)) {
    table->lookups++;
    walk->gathered = true;
    if (!gather(walk, index, sg_index_hash(walk->info, index->mask, row))) {
      how = SG_WALK_NO_MEMORY;
    }
  } else {
    index->searches++;
    atomic_fetch_add_explicit(&table->scans, 1, memory_order_relaxed);
    walk->live = sg_map_live(version->map[relation], 0);
  }
  pthread_mutex_unlock(&world->lock);
  if (how == SG_WALK_NO_MEMORY) {
    sg_walk_close(walk);
  }
  return how;
}

sg_walk_opening
sg_walk_try(sg_walk *walk, const sg_version *version, sg_relation relation,
            uint16_t mask, const sg_value *row)
{
  return open_walk(walk, version, relation, mask, row, false);
}

bool
sg_walk_open(sg_walk *walk, const sg_version *version, sg_relation relation,
             uint16_t mask, const sg_value *row)
{
  return open_walk(walk, version, relation, mask, row, true) == SG_WALK_OPEN;
}

/* The same, by the index. */
static bool
gather_linked(sg_walk *walk, const sg_index *index, const int32_t *member,
              size_t n)
{
  for (size_t i = 0; i < n; i++) {
    walk->row[1].i = member[i];
    if (!gather(walk, index, sg_index_hash_member(walk->row[0].i, member[i]))) {
      return false;
    }
  }
  return true;
}

bool
sg_walk_open_members(sg_walk *walk, const sg_version *version,
                     sg_relation relation, int32_t s, const int32_t *member,
                     size_t n)
{
  sg_world *world = version->world;
  sg_table *table = &world->table[relation];
  sg_index *index = member_index(table);
  bool done;

  if (!index) {
    return false;
  }
  walk_init(walk, version, relation, 0x01);
  walk->row[0].i = s;
  walk->gathered = true;
  pthread_mutex_lock(&world->lock);
  if (sg_index_pays(index, table)) {
    table->lookups++;
    done =
        sg_index_build(index, table) && gather_linked(walk, index, member, n);
  } else {
    index->searches++;
    atomic_fetch_add_explicit(&table->scans, 1, memory_order_relaxed);
    done = gather_members(walk, table, index, member, n);
  }
  pthread_mutex_unlock(&world->lock);
  if (!done) {
    sg_walk_close(walk);
  }
  return done;
}

bool
sg_walk_open_member(sg_walk *walk, const sg_version *version,
                    sg_relation relation, int32_t s, int32_t member)
{
  return sg_walk_open_members(walk, version, relation, s, &member, 1);
}

bool
sg_version_has_member(const sg_version *version, sg_relation relation,
                      int32_t s, int32_t member)
{
  sg_walk walk;
  bool has;

  if (!sg_walk_open_member(&walk, version, relation, s, member)) {
    return true;
  }
  has = walk.count > 0;
  sg_walk_close(&walk);
  return has;
}

/* The last column of ids that is asked for, which few rows have as it is asked;
 * 0: none but the segment. */
static unsigned
telling_column(const sg_walk *walk)
{
  unsigned c = walk->mask ? 31 - (unsigned)__builtin_clz(walk->mask) : 0;

  while (c > 0 &&
         !(walk->mask >> c & 1 && walk->info->column[c].type == SG_INT)) {
    c--;
  }
  return c;
}

enum { AT_ONCE = 64 };

/* The loop takes many at once. */
static bool
any_is(const int32_t *cell, int32_t value)
{
  int32_t any = 0;

  for (unsigned i = 0; i < AT_ONCE; i++) {
    any |= cell[i] == value;
  }
  return any != 0;
}

/* The first live place from `place` on that may match. 64 rows that live are
 * looked at together; of others some may be written meanwhile. */
static unsigned
next_place(const sg_walk *walk, unsigned column, unsigned place)
{
  const uint64_t *word = walk->live->word;
  const int32_t *cell = walk->live->page->cells[column].i;

  for (place = sg_live_next(word, place); place < SG_PAGE_ROWS;
       place = sg_live_next(word, place + AT_ONCE)) {
    if (column == 0 || place % AT_ONCE != 0 ||
        word[place / AT_ONCE] != UINT64_MAX ||
        any_is(cell + place, walk->row[column].i)) {
      return place;
    }
  }
  return SG_PAGE_ROWS;
}

/* It is asked where one of some pages begins. */
static bool
is_stopped(sg_walk *walk)
{
  walk->stopped = walk->stopped || (walk->at % (16 * SG_PAGE_ROWS) == 0 &&
                                    sg_cancelled(walk->cancel));
  return walk->stopped;
}

/* Whether the row at hand is the next one of a walk over all: it lives, and is
 * neither the first of its page nor the last, so nothing else is to be done. */
static bool
is_next(const sg_walk *walk)
{
  unsigned place = walk->at % SG_PAGE_ROWS;

  return walk->mask == 0 && walk->live && place != 0 &&
         place != SG_PAGE_ROWS - 1 &&
         (walk->live->word[place / 64] >> place % 64 & 1);
}

static sg_row
scan_next(sg_walk *walk)
{
  if (is_next(walk)) {
    return walk->at++;
  }
  unsigned column = telling_column(walk);
  const sg_map *map = walk->version->map[walk->relation];
  size_t pages = map ? map->chunks * SG_CHUNK_PAGES : 0;

  for (size_t page = walk->at / SG_PAGE_ROWS; page < pages && !is_stopped(walk);
       walk->live = sg_map_live(map, ++page),
              walk->at = (sg_row)(page * SG_PAGE_ROWS)) {
    unsigned place = walk->at % SG_PAGE_ROWS;
    if (!walk->live || !may_match(walk, walk->live->page)) {
      continue;
    }
    for (place = next_place(walk, column, place); place < SG_PAGE_ROWS;
         place = next_place(walk, column, place + 1)) {
      if (!walk->mask || sg_page_match(walk->live->page, walk->info, walk->mask,
                                       place, walk->row)) {
        sg_row row = (sg_row)(page * SG_PAGE_ROWS) + place;
        walk->at = row + 1;
        if (place == SG_PAGE_ROWS - 1) {
          walk->live = sg_map_live(map, page + 1);
        }
        return row;
      }
    }
  }
  return SG_NO_ROW;
}

sg_row
sg_walk_next(sg_walk *walk)
{
  if (!walk->gathered) {
    return scan_next(walk);
  }
  return walk->given < walk->count ? gathered_rows(walk)[walk->given++]
                                   : SG_NO_ROW;
}

void
sg_walk_rewind(sg_walk *walk)
{
  walk->given = 0;
  walk->at = 0;
  walk->live = sg_map_live(walk->version->map[walk->relation], 0);
}

void
sg_walk_close(sg_walk *walk)
{
  free(walk->rows);
  walk->rows = NULL;
}
