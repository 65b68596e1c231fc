/* runs.c -- rows that need no place in the index of keys: see runs.h. */
#include "list.h"
#include "search.h"
#include "table.h"

#include <stdlib.h>
#include <string.h>

enum {
  AT_ONCE = 64,  /* rows that are compared together */
  SHORTEST = 64, /* rows of a run */
  MOST = 2048    /* runs of a table */
};

void
sg_runs_clear(sg_runs *runs)
{
  free(runs->run);
  *runs = (sg_runs){0};
}

/* The column of the id in a key of a segment and an id; 0: it is another. */
static unsigned
id_column(const sg_table *table)
{
  const sg_relation_info *info = table->info;
  unsigned last = info->key ? 31 - (unsigned)__builtin_clz(info->key) : 0;
  sg_type type = info->column[last].type;

  return last > 0 && info->key == (1u | 1u << last) &&
                 (type == SG_INT || type == SG_TERM)
             ? last
             : 0;
}

/* The id that a key has; 0: none. */
static int32_t
id_of(const sg_table *table, unsigned column, sg_value value)
{
  return table->info->column[column].type == SG_TERM
             ? sg_term_vertex(value.term)
             : value.i;
}

int32_t
sg_runs_id(const sg_table *table, sg_row row)
{
  unsigned column = id_column(table);

  return column == 0
             ? 0
             : id_of(table, column,
                     sg_page_value(sg_table_page(table, row), table->info,
                                   column, row % SG_PAGE_ROWS));
}

/* The first run that is not before (s, row). */
static size_t
place_of(const sg_runs *runs, int32_t s, sg_row row)
{
  const sg_run *run = runs->run;
  size_t at;

  SG_SEARCH(at, 0, runs->count,
            run[at].s < s || (run[at].s == s && run[at].row < row));
  return at;
}

static void
insert(sg_runs *runs, const sg_run *run)
{
  size_t place = place_of(runs, run->s, run->row);

  if (run->n < SHORTEST || runs->count == MOST ||
      !sg_list_grow(&runs->run, runs->count, &runs->room, sizeof(*run))) {
    return; /* without memory the index takes them */
  }
  memmove(&runs->run[place + 1], &runs->run[place],
          (runs->count - place) * sizeof(*run));
  runs->run[place] = *run;
  runs->count++;
}

/* Segment and ids of a page's rows go on from the first. */
static bool
is_run(const int32_t *s, const int32_t *id, size_t n)
{
  uint32_t differ = 0;
  size_t i = 0;

  for (; i + AT_ONCE <= n; i += AT_ONCE) { /* the inner loop: many at once */
    for (uint32_t k = 0; k < AT_ONCE; k++) {
      differ |= (uint32_t)(s[i + k] ^ s[0]);
      differ |= ((uint32_t)id[i + k] - (uint32_t)id[0]) ^ ((uint32_t)i + k);
    }
  }
  for (; i < n; i++) {
    differ |= (uint32_t)(s[i] ^ s[0]);
    differ |= ((uint32_t)id[i] - (uint32_t)id[0]) ^ (uint32_t)i;
  }
  return differ == 0;
}

/* The run under way takes in the next one, or is remembered. */
static void
go_on(sg_runs *runs, sg_run *run, const sg_run *next)
{
  bool on = run->n > 0 && next->n > 0 && run->s == next->s &&
            run->row + run->n == next->row &&
            (int64_t)run->id + run->n == next->id;

  if (on) {
    run->n += next->n;
  } else {
    insert(runs, run);
    *run = *next;
  }
}

/* A page of ids is all one run, or in none. Ids that ascend have to be looked
 * at at both ends only. */
static void
add_ids(sg_runs *runs, const sg_sheet_page *page, bool ascends, unsigned column,
        sg_run *run)
{
  const int32_t *s = page->column[0].i, *id = page->column[column].i;
  sg_run next = {0};

  if (ascends ? id[page->n - 1] - id[0] == (int32_t)page->n - 1
              : is_run(s, id, page->n)) {
    next = (sg_run){s[0], id[0], page->slot, (sg_row)page->n};
  }
  go_on(runs, run, &next);
}

/* The same where the ids are those of terms v(N), one by one. */
static void
add_terms(sg_runs *runs, const sg_sheet_page *page, unsigned column,
          sg_run *run)
{
  const int32_t *s = page->column[0].i;
  int32_t *const *term = page->column[column].list;

  for (size_t i = 0; i < page->n; i++) {
    int32_t id = sg_term_vertex((const uint32_t *)term[i]);
    sg_run next = {s[i], id, page->slot + (sg_row)i, id > 0};

    go_on(runs, run, &next);
  }
}

void
sg_runs_add(sg_table *table, const sg_sheet *sheet)
{
  unsigned column = id_column(table);
  sg_run run = {0};

  for (size_t k = 0; column && k < sheet->pages; k++) {
    const sg_sheet_page *page = &sheet->page[k];
    if (table->info->column[column].type == SG_TERM) {
      add_terms(&table->keys, page, column, &run);
    } else {
      add_ids(&table->keys, page, sheet->ascends, column, &run);
    }
  }
  insert(&table->keys, &run);
}

/* The last run first: others are mostly of rows kept for undo. */
sg_row
sg_runs_find(const sg_table *table, const sg_map *map, const sg_value *key)
{
  const sg_runs *runs = &table->keys;
  unsigned column = id_column(table);

  if (runs->count == 0) {
    return SG_NO_ROW;
  }
  int32_t s = key[0].i, id = id_of(table, column, key[column]);

  for (size_t i = place_of(runs, s, SG_NO_ROW);
       i-- > 0 && runs->run[i].s == s;) {
    const sg_run *run = &runs->run[i];
    int64_t at = (int64_t)id - run->id;
    if (at >= 0 && at < run->n && sg_map_shows(map, run->row + (sg_row)at)) {
      return run->row + (sg_row)at;
    }
  }
  return SG_NO_ROW;
}

void
sg_runs_next(const sg_table *table, sg_row row, sg_row *begin, sg_row *end)
{
  *begin = *end = SG_NO_ROW;
  for (size_t i = 0; i < table->keys.count; i++) {
    const sg_run *run = &table->keys.run[i];
    sg_row from = run->row > row ? run->row : row;
    if (run->row + run->n > row && from < *begin) {
      *begin = from;
      *end = run->row + run->n;
    }
  }
}

size_t
sg_runs_rows(const sg_table *table, sg_row row)
{
  size_t rows = 0;

  for (size_t i = 0; i < table->keys.count; i++) {
    const sg_run *run = &table->keys.run[i];
    sg_row from = run->row > row ? run->row : row;
    rows += run->row + run->n > row ? run->row + run->n - from : 0;
  }
  return rows;
}

/* The end of the rows from `row` on that are all taken, or all not. */
static sg_row
same_until(const sg_table *table, sg_row row, sg_row end)
{
  bool taken = sg_table_taken(table, row);

  while (row < end && sg_table_taken(table, row) == taken) {
    uint64_t word = sg_table_page(table, row)->taken[row % SG_PAGE_ROWS / 64];
    bool same = row % 64 == 0 && word == (taken ? ~UINT64_C(0) : 0);
    row += same ? 64 : 1;
  }
  return row < end ? row : end;
}

/* What is left of a run; true: some of its rows are in none any more. */
static bool
sweep_run(const sg_table *table, const sg_run *run, sg_runs *left)
{
  sg_row end = run->row + run->n;
  bool lost = false;

  for (sg_row row = run->row, next; row < end; row = next) {
    size_t before = left->count;
    next = same_until(table, row, end);
    if (sg_table_taken(table, row)) {
      insert(left, &(sg_run){run->s, run->id + (int32_t)(row - run->row), row,
                             next - row});
      lost = lost || left->count == before;
    }
  }
  return lost;
}

bool
sg_runs_sweep(sg_table *table)
{
  sg_runs left = {0};
  bool lost = false;

  for (size_t i = 0; i < table->keys.count; i++) {
    lost = sweep_run(table, &table->keys.run[i], &left) || lost;
  }
  sg_runs_clear(&table->keys);
  table->keys = left;
  return lost;
}
