/* sweep.c -- slots that no version shows are used again.
 *
 * Layer: store, private. A page on which some rows are left has an empty stack,
 * one without any is vacant (slots.c).
 */
#include "table.h"

#include <stdlib.h>
#include <string.h>

static bool
has_refs(const sg_table *table)
{
  for (unsigned c = 0; c < table->info->arity; c++) {
    sg_type type = table->info->column[c].type;
    if (type == SG_LIST || type == SG_TERM) {
      return true;
    }
  }
  return false;
}

/* The taken rows of a page that no map shows. */
typedef struct unseen {
  const sg_live *last; /* the bitmap that was looked at last */
  uint64_t word[SG_LIVE_WORDS];
} unseen;

/* Versions that follow one another mostly have the same bitmap. */
static void
see_page(unseen *page, const sg_live *live)
{
  for (unsigned w = 0; live != page->last && w < SG_LIVE_WORDS; w++) {
    page->word[w] &= ~live->word[w];
  }
  page->last = live;
}

/* The same chunk in the map before was looked at with that. */
static void
see_map(unseen *page, const sg_map *map, const sg_map *before)
{
  for (size_t c = 0; c < map->chunks; c++) {
    const sg_chunk *chunk = map->chunk[c];
    if (!chunk || (before && c < before->chunks && before->chunk[c] == chunk)) {
      continue;
    }
    for (size_t i = 0; i < SG_CHUNK_PAGES; i++) {
      if (chunk->live[i]) {
        see_page(&page[c * SG_CHUNK_PAGES + i], chunk->live[i]);
      }
    }
  }
}

/* Of all pages. Null: no memory. */
static unseen *
find_unseen(const sg_table *table, sg_map *const *map, size_t maps)
{
  unseen *page = malloc((table->pages + 1) * sizeof *page);

  for (size_t i = 0; page && i < table->pages; i++) {
    page[i].last = NULL;
    memcpy(page[i].word, table->page[i]->taken, sizeof page[i].word);
  }
  for (size_t m = 0; page && m < maps; m++) {
    if (map[m]) {
      see_map(page, map[m], m > 0 ? map[m - 1] : NULL);
    }
  }
  return page;
}

/* Vacates what no map shows; false: that is nothing. */
static bool
sweep_page(sg_table *table, size_t number, const uint64_t *gone)
{
  sg_page *page = table->page[number];
  bool refs = has_refs(table);
  bool vacated = false;

  for (unsigned w = 0; w < SG_LIVE_WORDS; w++) {
    for (uint64_t left = gone[w]; refs && left; left &= left - 1) {
      sg_table_vacate(table, (sg_row)(number * SG_PAGE_ROWS + w * 64) +
                                 (sg_row)__builtin_ctzll(left));
    }
    page->taken[w] &= ~gone[w];
    vacated = vacated || gone[w];
  }
  if (vacated && table->info->column[0].type == SG_INT) {
    sg_page_find_span(page);
  }
  return vacated;
}

static bool
has_taken(const sg_page *page)
{
  for (unsigned w = 0; w < SG_LIVE_WORDS; w++) {
    if (page->taken[w]) {
      return true;
    }
  }
  return false;
}

/* The last taken row and all before it stay slots, the rest is new again. */
static void
trim_slots(sg_table *table)
{
  while (table->slots > 0 && !sg_table_taken(table, table->slots - 1)) {
    sg_row last = table->slots - 1;
    bool none =
        table->page[last / SG_PAGE_ROWS]->taken[last % SG_PAGE_ROWS / 64] == 0;
    table->slots = none ? last / 64 * 64 : last;
  }
}

/* Puts every slot that is not taken on its page's stack, the first on top; a
 * page without any is vacant. */
static void
stack_page(sg_table *table, size_t number)
{
  sg_page *page = table->page[number];
  size_t first = number * SG_PAGE_ROWS;
  unsigned end = 0, in_row = 0;

  page->empties = page->gap = 0;
  page->vacant = first < table->slots && !has_taken(page);
  if (page->vacant) {
    table->vacant++;
    return;
  }
  if (first < table->slots) {
    size_t left = table->slots - first;
    end = left < SG_PAGE_ROWS ? (unsigned)left : SG_PAGE_ROWS;
  }
  for (unsigned place = end; place-- > 0;) {
    if (page->taken[place / 64] >> place % 64 & 1) {
      in_row = 0;
      continue;
    }
    if (!page->empty) {
      page->empty = malloc(SG_PAGE_ROWS * sizeof(*page->empty));
      if (!page->empty) {
        return; /* these slots wait for the next sweep */
      }
    }
    page->empty[page->empties++] = (uint16_t)place;
    table->emptied++;
    page->gap = ++in_row > page->gap ? in_row : page->gap;
  }
}

void
sg_table_sweep(sg_table *table, sg_map *const *map, size_t maps)
{
  unseen *gone = find_unseen(table, map, maps);
  bool vacated = false;

  for (size_t i = 0; gone && i < table->pages; i++) {
    vacated = sweep_page(table, i, gone[i].word) || vacated;
  }
  free(gone);
  if (sg_runs_sweep(table)) {
    sg_index_clear(&table->index[0]);
  }
  for (unsigned i = 0; vacated && i < table->indexes; i++) {
    sg_index_sweep(&table->index[i], table);
  }
  trim_slots(table);
  for (unsigned i = 0; i < table->indexes; i++) {
    sg_index_wait(&table->index[i], table->slots);
  }
  table->emptied = table->open = table->gap = 0;
  table->vacant = table->next_vacant = 0;
  table->rest = table->rest_end = 0;
  for (size_t i = 0; i < table->pages; i++) {
    stack_page(table, i);
    if (table->page[i]->gap > table->gap) {
      table->gap = table->page[i]->gap;
    }
  }
  table->written = 0;
  table->swept_bytes = table->arena.bytes;
}
