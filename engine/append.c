/* append.c -- rows that their maker writes in place. */
#include "world.h"

#include <stdlib.h>
#include <string.h>

static sg_table *
table_of(const sg_append *a)
{
  return &a->world->table[a->relation];
}

static bool
is_ref(const sg_table *table, unsigned c)
{
  sg_type type = table->info->column[c].type;

  return type == SG_LIST || type == SG_TERM;
}

/* ---- room -------------------------------------------------------------- */

/* The cells of out->n rows from `first` on, all on one page of the table; no
 * lists yet. */
static void
lay_out(const sg_table *table, sg_row first, sg_sheet_page *out)
{
  const sg_page *page = sg_table_page(table, first);
  unsigned place = first % SG_PAGE_ROWS;

  out->slot = first;
  out->refs = false;
  for (unsigned c = 0; c < table->info->arity; c++) {
    if (table->info->column[c].type == SG_FLOAT) {
      out->column[c].f = page->cells[c].f + place;
    } else if (is_ref(table, c)) {
      out->column[c].list = (int32_t **)(page->cells[c].ref + place);
    } else {
      out->column[c].i = page->cells[c].i + place;
    }
  }
}

/* The slot of the first of n rows: in the rest of a page that was vacant, a gap
 * or vacant pages, if they hold all of the rows, else at the end. */
static sg_row
first_slot(sg_table *table, size_t n)
{
  size_t rest = table->rest_end - table->rest;
  sg_row gap = n > rest ? sg_table_gap(table, n) : SG_NO_ROW;

  if (gap != SG_NO_ROW) {
    return gap;
  }
  return sg_table_vacancies(table) >= n ? sg_table_vacancy(table)
                                        : table->slots;
}

/* Only the first part may begin within a page. */
bool
sg_append_begin(sg_append *a, sg_world *world, sg_relation relation, size_t n)
{
  sg_table *table = &world->table[relation];
  sg_sheet *sheet = &a->sheet;

  *a = (sg_append){.world = world, .relation = relation};
  sg_world_sweep_if_worth(world, relation, n, false);
  sg_row row = first_slot(table, n);
  bool again = row < table->slots;

  sheet->place = row % SG_PAGE_ROWS;
  sheet->page = malloc((n / SG_PAGE_ROWS + 2) * sizeof(*sheet->page));
  if (!sheet->page || !(again || sg_table_reserve(table, n))) {
    return false;
  }
  while (sheet->rows < n) {
    sg_sheet_page *page = &sheet->page[sheet->pages++];
    size_t room = SG_PAGE_ROWS - row % SG_PAGE_ROWS;
    page->from = sheet->rows;
    page->n = n - page->from < room ? n - page->from : room;
    lay_out(table, row, page);
    sheet->rows += page->n;
    row = again && sheet->rows < n ? sg_table_next_vacancy(table, row)
                                   : row + (sg_row)page->n;
  }
  return true;
}

void
sg_append_end(sg_append *a)
{
  if (!a->shown) {
    sg_append_shorten(a, 0);
  }
  free(a->sheet.page);
  a->sheet.page = NULL;
}

void
sg_append_shorten(sg_append *a, size_t n)
{
  sg_table *table = table_of(a);
  sg_sheet *sheet = &a->sheet;

  for (; sheet->rows > n; sheet->pages--) {
    sg_sheet_page *page = &sheet->page[sheet->pages - 1];
    size_t keep = n > page->from ? n - page->from : 0;
    for (unsigned c = 0; c < table->info->arity; c++) {
      for (size_t i = keep; page->refs && is_ref(table, c) && i < page->n;
           i++) {
        sg_table_let_go(table, table->info->column[c].type,
                        (uint32_t *)page->column[c].list[i]);
      }
    }
    page->n = keep;
    sheet->rows = page->from + keep;
    if (keep > 0) {
      break;
    }
  }
}

void
sg_append_want_refs(sg_append *a, size_t number)
{
  const sg_relation_info *info = table_of(a)->info;
  sg_sheet_page *page = &a->sheet.page[number];

  for (unsigned c = 0; c < info->arity && !page->refs; c++) {
    if (is_ref(table_of(a), c)) {
      memset(page->column[c].list, 0, page->n * sizeof(int32_t *));
    }
  }
  page->refs = true;
}

/* ---- showing ----------------------------------------------------------- */

/* Makes `count` bits from `place` on 1. */
static void
set_bits(uint64_t *word, size_t place, size_t count)
{
  while (count > 0) {
    size_t bit = place % 64;
    size_t n = 64 - bit < count ? 64 - bit : count;
    uint64_t ones = n == 64 ? ~UINT64_C(0) : (UINT64_C(1) << n) - 1;
    word[place / 64] |= ones << bit;
    place += n;
    count -= n;
  }
}

/* The bitmaps of the rows' pages, to be written. False: no memory. */
static bool
own_pages(const sg_append *a, sg_map *map)
{
  for (size_t k = 0; k < a->sheet.pages; k++) {
    sg_row row = a->sheet.page[k].slot;
    if (!sg_map_own_live(map, sg_table_page(table_of(a), row),
                         row / SG_PAGE_ROWS)) {
      return false;
    }
  }
  return true;
}

enum { AT_ONCE = 64 };

/* Of 64 rows; the loop takes many at once. */
static bool
are_all_of(const int32_t *s, int32_t of)
{
  int32_t differ = 0;

  for (unsigned i = 0; i < AT_ONCE; i++) {
    differ |= s[i] ^ of;
  }
  return differ == 0;
}

static int32_t
largest(const int32_t *id)
{
  int32_t last = id[0];

  for (unsigned i = 0; i < AT_ONCE; i++) {
    last = id[i] > last ? id[i] : last;
  }
  return last;
}

/* The largest id of rows `from` .. of a page that are of the segment of the
 * first of them; *next: the first row behind them. */
static int32_t
last_id(const int32_t *s, const int32_t *id, size_t from, size_t n,
        size_t *next)
{
  int32_t last = id[from];
  size_t i = from;

  for (; i + AT_ONCE <= n && (!s || are_all_of(s + i, s[from])); i += AT_ONCE) {
    int32_t of = largest(id + i);
    last = of > last ? of : last;
  }
  for (; i < n && (!s || s[i] == s[from]); i++) {
    last = id[i] > last ? id[i] : last;
  }
  *next = i;
  return last;
}

/* The same where ids ascend and are of one segment. */
static bool
note_last_id(const sg_append *a, sg_map *map, unsigned column)
{
  const sg_sheet_page *page = &a->sheet.page[a->sheet.pages - 1];
  int32_t s = column == 0 ? 0 : page->column[0].i[page->n - 1];

  return sg_map_used_id(map, s, page->column[column].i[page->n - 1]) &&
         sg_world_stamp(a->world, map, a->relation, s);
}

/* Stamps, and notes the largest id of, each run of rows of one segment. */
static bool
note_ids(const sg_append *a, sg_map *map)
{
  unsigned column = sg_relation_id_column(a->relation);
  int32_t stamped = -1;

  if (column != SG_MAX_COLUMNS && a->sheet.ascends && a->sheet.rows > 0) {
    return note_last_id(a, map, column);
  }
  for (size_t k = 0; column != SG_MAX_COLUMNS && k < a->sheet.pages; k++) {
    const sg_sheet_page *page = &a->sheet.page[k];
    const int32_t *s = column == 0 ? NULL : page->column[0].i;
    for (size_t i = 0; i < page->n;) {
      int32_t of = s ? s[i] : 0;
      int32_t last = last_id(s, page->column[column].i, i, page->n, &i);
      if (!sg_map_used_id(map, of, last) ||
          (of != stamped && !sg_world_stamp(a->world, map, a->relation, of))) {
        return false;
      }
      stamped = of;
    }
  }
  return true;
}

/* Indexes have not seen n rows from `row` on, on one page; except for the first
 * if that is to have their keys at once. */
static void
keep_from_indexes(sg_table *table, sg_row row, size_t n, bool keyed)
{
  for (unsigned i = keyed && table->info->key; i < table->indexes; i++) {
    if (row >= table->slots) {
      sg_index_wait(&table->index[i], row);
    } else {
      sg_index_be_late(&table->index[i], row, n);
    }
  }
}

bool
sg_append_show(sg_append *a)
{
  sg_table *table = table_of(a);
  sg_sheet *sheet = &a->sheet;
  sg_map *map = sg_world_own_map(a->world, a->relation);

  if (!map || !own_pages(a, map) || !note_ids(a, map)) {
    return false;
  }
  for (size_t k = 0; k < sheet->pages; k++) {
    sg_row row = sheet->page[k].slot;
    size_t n = sheet->page[k].n;
    sg_page *page = sg_table_page(table, row);
    sg_live *live = sg_map_own_live(map, page, row / SG_PAGE_ROWS);
    if (table->info->column[0].type == SG_INT) {
      sg_page_extend(page, sheet->page[k].column[0].i, n);
    }
    set_bits(page->taken, row % SG_PAGE_ROWS, n);
    set_bits(live->word, row % SG_PAGE_ROWS, n);
    keep_from_indexes(table, row, n, a->keyed);
    sg_table_fill(table, row, n);
  }
  map->rows += sheet->rows;
  table->written += sheet->rows;
  return a->shown = true; /* the rows are the table's now */
}

/* ---- for everybody ----------------------------------------------------- */

bool
sg_append_open(sg_append *a, sg_world *world, sg_relation relation, size_t n)
{
  bool good;

  sg_world_claim(world, NULL);
  sg_world_enter(world);
  good = sg_append_begin(a, world, relation, n);
  sg_world_leave(world);
  if (!good) {
    sg_append_close(a);
  }
  return good;
}

bool
sg_append_lists(sg_append *a, size_t page, unsigned column,
                const int32_t *length)
{
  sg_sheet_page *of = &a->sheet.page[page];
  sg_table *table = table_of(a);
  bool good = true;

  sg_world_enter(a->world);
  sg_append_want_refs(a, page);
  for (size_t i = 0; good && i < of->n; i++) {
    uint32_t *list = sg_arena_take(&table->arena, 1 + (size_t)length[i]);
    good = list != NULL;
    if (good) {
      *list = (uint32_t)length[i];
    }
    of->column[column].list[i] = (int32_t *)list;
  }
  sg_world_leave(a->world);
  return good;
}

bool
sg_append_terms(sg_append *a, size_t page, unsigned column,
                const uint32_t *const *term)
{
  sg_sheet_page *of = &a->sheet.page[page];
  bool good = true;

  sg_world_enter(a->world);
  sg_append_want_refs(a, page);
  for (size_t i = 0; good && i < of->n; i++) {
    const uint32_t *copy =
        sg_table_keep(table_of(a), SG_TERM, (sg_value){.term = term[i]});
    good = copy != NULL;
    of->column[column].list[i] = (int32_t *)copy;
  }
  sg_world_leave(a->world);
  return good;
}

bool
sg_append_commit(sg_append *a)
{
  bool good = true;

  sg_world_enter(a->world);
  if (a->sheet.rows > 0 && (good = sg_append_show(a))) {
    sg_runs_add(table_of(a), &a->sheet);
    sg_world_changed(a->world);
  }
  sg_world_leave(a->world);
  return good;
}

void
sg_append_close(sg_append *a)
{
  sg_world_enter(a->world);
  sg_append_end(a);
  sg_world_leave(a->world);
  sg_world_release(a->world);
}
