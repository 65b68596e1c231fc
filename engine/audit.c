/* audit.c -- what a world costs, and whether its invariants hold. */
#include "world.h"

static size_t
table_bytes(const sg_table *table)
{
  const sg_relation_info *info = table->info;
  size_t row = 0;
  size_t bytes = table->page_room * sizeof(sg_page *) + table->arena.bytes;

  for (unsigned c = 0; c < info->arity; c++) {
    row += info->column[c].type == SG_INT || info->column[c].type == SG_ATOM
               ? sizeof(int32_t)
               : sizeof(double);
  }
  for (size_t i = 0; i < table->pages; i++) {
    bytes += sizeof(sg_page) + SG_PAGE_ROWS * row;
    bytes += table->page[i]->empty ? SG_PAGE_ROWS * sizeof(uint16_t) : 0;
  }
  return bytes;
}

/* Bytes of the bitmaps of a map, those held by others too. */
static size_t
map_bytes(const sg_map *map)
{
  size_t bytes = 0;

  if (!map) {
    return 0;
  }
  bytes = sizeof(*map) + map->chunks * sizeof(sg_chunk *);
  for (size_t c = 0; c < map->chunks; c++) {
    if (!map->chunk[c]) {
      continue;
    }
    bytes += sizeof(sg_chunk);
    for (size_t i = 0; i < SG_CHUNK_PAGES; i++) {
      bytes += map->chunk[c]->live[i] ? sizeof(sg_live) : 0;
    }
  }
  return bytes;
}

static size_t
versions_bytes(const sg_world *world, sg_relation relation)
{
  double bytes = 0;

  for (const sg_version *v = world->versions; v; v = v->next) {
    bytes += sg_map_share(v->map[relation]);
  }
  return (size_t)(bytes + 0.5);
}

void
sg_world_statistics(sg_world *world, sg_relation relation, sg_statistics *out)
{
  sg_table *table = &world->table[relation];
  sg_version *seen;

  pthread_mutex_lock(&world->lock);
  seen = sg_world_visible(world);
  *out = (sg_statistics){
      .rows = sg_version_count(seen, relation),
      .slots = table->slots,
      .bytes = table_bytes(table) + map_bytes(seen->map[relation]),
      .version_bytes = versions_bytes(world, relation),
      .scans = atomic_load_explicit(&table->scans, memory_order_relaxed),
      .lookups = table->lookups};
  for (unsigned i = 0; i < table->indexes; i++) {
    out->index_bytes += sg_index_bytes(&table->index[i]);
  }
  for (const sg_version *v = world->versions; v; v = v->next) {
    out->versions++;
  }
  pthread_mutex_unlock(&world->lock);
}

/* ---- validity ---------------------------------------------------------- */

/* What the map shows is taken, and counted right; segments ascend. */
static bool
map_is_valid(const sg_table *table, const sg_map *map)
{
  size_t rows = 0;

  for (size_t i = 0; map && i < map->chunks * SG_CHUNK_PAGES; i++) {
    const sg_live *live = sg_map_live(map, i);
    for (unsigned w = 0; live && w < SG_LIVE_WORDS; w++) {
      if (i >= table->pages || live->page != table->page[i] ||
          live->word[w] & ~live->page->taken[w]) {
        return false;
      }
      rows += (size_t)__builtin_popcountll(live->word[w]);
    }
  }
  return !map || (rows == map->rows && sg_ids_is_valid(map->ids));
}

/* What is on an empty stack is not taken, and the first is on top; its gaps are
 * no longer than it says. */
static bool
stack_is_valid(const sg_table *table, size_t number)
{
  const sg_page *page = table->page[number];
  unsigned in_row = 0;

  for (unsigned e = 0; e < page->empties; e++) {
    sg_row row = (sg_row)(number * SG_PAGE_ROWS + page->empty[e]);
    bool on = e > 0 && page->empty[e - 1] == page->empty[e] + 1;
    in_row = on ? in_row + 1 : 1;
    if (sg_table_taken(table, row) || in_row > page->gap ||
        (e > 0 && page->empty[e - 1] <= page->empty[e])) {
      return false;
    }
  }
  return page->empties == 0 || page->gap <= table->gap;
}

/* Taken rows are of segments that the page says it may have. */
static bool
span_is_valid(const sg_table *table, const sg_page *page)
{
  bool valid = true;

  for (unsigned r = sg_live_next(page->taken, 0);
       valid && table->info->column[0].type == SG_INT && r < SG_PAGE_ROWS;
       r = sg_live_next(page->taken, r + 1)) {
    valid = sg_page_may_have(page, page->cells[0].i[r]);
  }
  return valid;
}

static bool
slots_are_valid(const sg_table *table)
{
  size_t emptied = 0;

  for (size_t i = 0; i < table->pages; i++) {
    const sg_page *page = table->page[i];
    if (!stack_is_valid(table, i) || !span_is_valid(table, page)) {
      return false;
    }
    emptied += page->empties;
  }
  return emptied == table->emptied &&
         table->slots <= table->pages * SG_PAGE_ROWS;
}

/* No two rows of the map have the same key. By an index of its own, which has
 * all of them. */
static bool
keys_are_valid(sg_table *table, const sg_map *map)
{
  const sg_relation_info *info = table->info;
  sg_index kept = table->index[0];
  sg_runs runs = table->keys;
  bool valid = true;

  if (info->key == 0) {
    return true;
  }
  table->index[0] = (sg_index){.mask = info->key, .free = SG_NO_ROW};
  table->keys = (sg_runs){0};
  valid = sg_index_build(&table->index[0], table);
  for (sg_row row = 0; valid && row < table->slots; row++) {
    sg_value value[SG_MAX_COLUMNS];
    if (sg_map_shows(map, row)) {
      sg_page_row(sg_table_page(table, row), info, info->key,
                  row % SG_PAGE_ROWS, value);
      valid = sg_table_find(table, map, value) == row;
    }
  }
  sg_index_clear(&table->index[0]);
  table->index[0] = kept;
  table->keys = runs;
  return valid;
}

static int32_t
segment_at(const sg_table *table, sg_row row)
{
  return sg_table_page(table, row)->cells[0].i[row % SG_PAGE_ROWS];
}

/* The rows of a run that are taken have the keys that it says. */
static bool
runs_are_valid(const sg_table *table)
{
  for (size_t i = 0; i < table->keys.count; i++) {
    const sg_run *run = &table->keys.run[i];
    for (sg_row k = 0; k < run->n; k++) {
      if (sg_table_taken(table, run->row + k) &&
          (segment_at(table, run->row + k) != run->s ||
           sg_runs_id(table, run->row + k) != run->id + (int32_t)k)) {
        return false;
      }
    }
  }
  return true;
}

bool
sg_world_is_valid(sg_world *world)
{
  bool valid = true;

  pthread_mutex_lock(&world->lock);
  for (int r = 0; valid && r < SG_RELATIONS; r++) {
    sg_table *table = &world->table[r];
    valid = slots_are_valid(table) && runs_are_valid(table) &&
            sg_arena_is_valid(&table->arena) &&
            keys_are_valid(table, world->current->map[r]);
    for (const sg_version *v = world->versions; valid && v; v = v->next) {
      valid = map_is_valid(table, v->map[r]);
    }
    for (unsigned i = 0; valid && i < table->indexes; i++) {
      valid = sg_index_is_valid(&table->index[i], table);
    }
  }
  pthread_mutex_unlock(&world->lock);
  return valid;
}
