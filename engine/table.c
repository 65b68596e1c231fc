/* table.c -- pages of cells and their slots. */
#include "table.h"
#include "block.h"
#include "index_hash.h"
#include "list.h"

#include <stdlib.h>
#include <string.h>

static const struct {
  sg_relation relation;
  const char *name;
  uint16_t mask;
  bool members;
} declared[] = {
#define INDEX(ID, name, mask)   {SG_##ID, #name, mask, false},
#define MEMBERS(ID, name, mask) {SG_##ID, #name, mask, true},
#include "relations.def"
};

static void
declare(sg_table *table, const char *name, uint16_t mask, bool members)
{
  table->index[table->indexes++] = (sg_index){
      .name = name, .mask = mask, .members = members, .free = SG_NO_ROW};
}

void
sg_table_init(sg_table *table, sg_relation relation)
{
  *table =
      (sg_table){.relation = relation, .info = &sg_relation_table[relation]};
  if (table->info->key) {
    declare(table, "key", table->info->key, false); /* always the first */
  }
  for (size_t i = 0; i < sizeof(declared) / sizeof(declared[0]); i++) {
    if (declared[i].relation == relation) {
      declare(table, declared[i].name, declared[i].mask, declared[i].members);
    }
  }
}

static size_t
cell_bytes(sg_type type)
{
  switch (type) {
  case SG_INT:
  case SG_ATOM:
    return sizeof(int32_t);
  case SG_FLOAT:
    return sizeof(double);
  case SG_LIST:
  case SG_TERM:
    return sizeof(uint32_t *);
  }
  return 0;
}

/* A page and its columns are one span. Columns begin at different places of the
 * system's pages. */
enum { COLUMN_GAP = 64 };

static size_t
page_bytes(const sg_relation_info *info)
{
  size_t bytes = sizeof(sg_page);

  for (unsigned c = 0; c < info->arity; c++) {
    bytes += SG_PAGE_ROWS * cell_bytes(info->column[c].type) + COLUMN_GAP;
  }
  return bytes;
}

static void
page_close(sg_page *page, const sg_relation_info *info)
{
  free(page->empty);
  sg_span_close(page, page_bytes(info));
}

static sg_page *
page_open(const sg_relation_info *info)
{
  sg_page *page = sg_span_open(page_bytes(info));

  if (!page) {
    return NULL;
  }
  char *cells = (char *)(page + 1);

  *page = (sg_page){0};
  atomic_init(&page->span.first, INT32_MAX);
  atomic_init(&page->span.last, INT32_MIN);
  for (unsigned c = 0; c < info->arity; c++) {
    page->cells[c].i = (void *)cells;
    cells += SG_PAGE_ROWS * cell_bytes(info->column[c].type) + COLUMN_GAP;
  }
  return page;
}

void
sg_table_clear(sg_table *table)
{
  for (unsigned i = 0; i < table->indexes; i++) {
    sg_index_clear(&table->index[i]);
  }
  for (size_t i = 0; i < table->pages; i++) {
    page_close(table->page[i], table->info);
  }
  free(table->page);
  sg_runs_clear(&table->keys);
  sg_arena_clear(&table->arena);
}

static void
set_span(sg_page *page, int32_t first, int32_t last)
{
  atomic_store_explicit(&page->span.first, first, memory_order_relaxed);
  atomic_store_explicit(&page->span.last, last, memory_order_relaxed);
}

void
sg_page_extend(sg_page *page, const int32_t *s, size_t n)
{
  int32_t first = sg_page_first(page), last = sg_page_last(page);

  for (size_t i = 0; i < n; i++) {
    first = s[i] < first ? s[i] : first;
    last = s[i] > last ? s[i] : last;
  }
  set_span(page, first, last);
}

void
sg_page_find_span(sg_page *page)
{
  const int32_t *s = page->cells[0].i;
  int32_t first = INT32_MAX, last = INT32_MIN;

  for (unsigned r = sg_live_next(page->taken, 0); r < SG_PAGE_ROWS;
       r = sg_live_next(page->taken, r + 1)) {
    first = s[r] < first ? s[r] : first;
    last = s[r] > last ? s[r] : last;
  }
  set_span(page, first, last);
}

bool
sg_table_reserve(sg_table *table, size_t n)
{
  size_t need = ((size_t)table->slots + n + SG_PAGE_ROWS - 1) / SG_PAGE_ROWS;

  if (n >= SG_NO_ROW - table->slots) {
    return false; /* row numbers have 32 bits */
  }
  if (!sg_list_need(&table->page, need, &table->page_room,
                    sizeof(*table->page))) {
    return false;
  }
  while (table->pages < need) {
    sg_page *page = page_open(table->info);
    if (!page) {
      return false;
    }
    table->page[table->pages++] = page;
  }
  return true;
}

static size_t
ref_words(sg_type type, const uint32_t *ref)
{
  return type == SG_LIST ? 1 + (size_t)ref[0] : sg_term_length(ref);
}

const uint32_t *
sg_table_keep(sg_table *table, sg_type type, sg_value value)
{
  size_t words = ref_words(type, value.term);
  uint32_t *copy = sg_arena_take(&table->arena, words);

  if (copy) {
    memcpy(copy, value.term, words * sizeof(*copy));
  }
  return copy;
}

void
sg_table_let_go(sg_table *table, sg_type type, const uint32_t *ref)
{
  if (ref) {
    sg_arena_give(&table->arena, ref, ref_words(type, ref));
  }
}

static bool
is_ref(sg_type type)
{
  return type == SG_LIST || type == SG_TERM;
}

static void
give_refs(sg_table *table, const sg_page *page, unsigned place,
          unsigned columns)
{
  for (unsigned c = 0; c < columns; c++) {
    sg_type type = table->info->column[c].type;
    if (is_ref(type)) {
      sg_table_let_go(table, type, page->cells[c].ref[place]);
    }
  }
}

/* Lists and terms into the arena; false: no memory, none is there. */
static bool
write_refs(sg_table *table, sg_page *page, unsigned place, const sg_value *row)
{
  const sg_relation_info *info = table->info;

  for (unsigned c = 0; c < info->arity; c++) {
    sg_type type = info->column[c].type;
    if (!is_ref(type)) {
      continue;
    }
    page->cells[c].ref[place] = sg_table_keep(table, type, row[c]);
    if (!page->cells[c].ref[place]) {
      give_refs(table, page, place, c);
      return false;
    }
  }
  return true;
}

bool
sg_table_write(sg_table *table, sg_row row, const sg_value *value)
{
  const sg_relation_info *info = table->info;
  sg_page *page = sg_table_page(table, row);
  unsigned place = row % SG_PAGE_ROWS;

  if (!write_refs(table, page, place, value)) {
    return false;
  }
  for (unsigned c = 0; c < info->arity; c++) {
    if (info->column[c].type == SG_FLOAT) {
      page->cells[c].f[place] = value[c].f + 0.0; /* no -0.0 */
    } else if (info->column[c].type == SG_INT ||
               info->column[c].type == SG_ATOM) {
      page->cells[c].i[place] = value[c].i;
    }
  }
  if (info->column[0].type == SG_INT) {
    sg_page_extend(page, &value[0].i, 1);
  }
  page->taken[place / 64] |= UINT64_C(1) << place % 64;
  table->written++;
  return true;
}

void
sg_table_vacate(sg_table *table, sg_row row)
{
  sg_page *page = sg_table_page(table, row);
  unsigned place = row % SG_PAGE_ROWS;

  give_refs(table, page, place, table->info->arity);
  page->taken[place / 64] &= ~(UINT64_C(1) << place % 64);
}

sg_index *
sg_table_index(sg_table *table, uint16_t mask, bool members)
{
  for (unsigned i = 0; i < table->indexes; i++) {
    sg_index *index = &table->index[i];
    if (index->mask == mask && index->members == members) {
      return index;
    }
  }
  return NULL;
}

void
sg_table_link(sg_table *table, sg_row row)
{
  for (unsigned i = 0; i < table->indexes; i++) {
    sg_index_link(&table->index[i], table, row);
  }
}

/* A run has the key of this row, which is in none. */
static bool
in_run(const sg_table *table, const sg_map *map, sg_row row)
{
  sg_value key[SG_MAX_COLUMNS];

  sg_page_row(sg_table_page(table, row), table->info, table->info->key,
              row % SG_PAGE_ROWS, key);
  return sg_runs_find(table, map, key) != SG_NO_ROW;
}

bool
sg_table_link_key(sg_table *table, const sg_map *map, sg_row row)
{
  const sg_relation_info *info = table->info;
  sg_index *index = &table->index[0];
  uint64_t hash = sg_index_hash_row(index, table, row);
  uint32_t other = sg_index_first(index, hash);

  if (table->keys.count > 0 && in_run(table, map, row)) {
    return false;
  }
  if (other != SG_NO_ROW) {
    sg_value key[SG_MAX_COLUMNS];
    sg_page_row(sg_table_page(table, row), info, info->key, row % SG_PAGE_ROWS,
                key);
    for (; other != SG_NO_ROW; other = sg_index_next(index, other)) {
      if (sg_map_shows(map, other) &&
          sg_page_match(sg_table_page(table, other), info, info->key,
                        other % SG_PAGE_ROWS, key)) {
        return false;
      }
    }
  }
  sg_index_chain(index, hash, row);
  return true;
}

void
sg_table_unlink(sg_table *table, sg_row row)
{
  for (unsigned i = 0; i < table->indexes; i++) {
    sg_index_unlink(&table->index[i], table, row);
  }
}

sg_row
sg_table_find_run(const sg_table *table, const sg_map *map, const sg_value *row)
{
  return table->keys.count > 0 ? sg_runs_find(table, map, row) : SG_NO_ROW;
}

sg_row
sg_table_find_indexed(sg_table *table, const sg_map *map, const sg_value *row)
{
  const sg_relation_info *info = table->info;
  sg_index *index = &table->index[0];

  for (uint32_t r = sg_index_first(index, sg_index_hash(info, info->key, row));
       r != SG_NO_ROW; r = sg_index_next(index, r)) {
    if (sg_map_shows(map, r) &&
        sg_page_match(sg_table_page(table, r), info, info->key,
                      r % SG_PAGE_ROWS, row)) {
      return r;
    }
  }
  return SG_NO_ROW;
}

sg_row
sg_table_find(sg_table *table, const sg_map *map, const sg_value *row)
{
  sg_row found = sg_table_find_run(table, map, row);

  return found != SG_NO_ROW ? found : sg_table_find_indexed(table, map, row);
}

static bool
value_equal(sg_type type, sg_value a, sg_value b)
{
  switch (type) {
  case SG_INT:
  case SG_ATOM:
    return a.i == b.i;
  case SG_FLOAT:
    return a.f == b.f;
  case SG_LIST:
    return a.list[0] == b.list[0] &&
           memcmp(a.list + 1, b.list + 1,
                  (size_t)a.list[0] * sizeof(a.list[0])) == 0;
  case SG_TERM:
    return sg_term_equal(a.term, b.term);
  }
  return false;
}

bool
sg_page_match(const sg_page *page, const sg_relation_info *info, uint16_t mask,
              unsigned place, const sg_value *row)
{
  for (unsigned m = mask; m; m &= m - 1) {
    unsigned c = (unsigned)__builtin_ctz(m);
    if (!value_equal(info->column[c].type, sg_page_value(page, info, c, place),
                     row[c])) {
      return false;
    }
  }
  return true;
}
