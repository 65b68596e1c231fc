/* index.c -- chains of rows and of members, by hash. */
#include "block.h"
#include "index_hash.h"
#include "list.h"
#include "table.h"

#include <stdlib.h>
#include <string.h>

enum { FIRST_BITS = 6, SEARCHED_ROWS = 1 << 16 };

static uint32_t *
head_of(const sg_index *index, uint64_t hash)
{
  uint64_t line = hash >> (64 - (index->bits - SG_NEAR_BITS));

  return &index->head[line << SG_NEAR_BITS |
                      (hash & ((1U << SG_NEAR_BITS) - 1))];
}

uint32_t
sg_index_first(const sg_index *index, uint64_t hash)
{
  return *head_of(index, hash);
}

static uint32_t *
next_of(const sg_index *index, uint32_t at)
{
  return index->members ? &index->link[at].next
                        : &index->next[at / SG_PAGE_ROWS][at % SG_PAGE_ROWS];
}

uint32_t
sg_index_next(const sg_index *index, uint32_t at)
{
  return *next_of(index, at);
}

sg_row
sg_index_row(const sg_index *index, uint32_t at)
{
  return index->members ? index->link[at].row : at;
}

void
sg_index_clear(sg_index *index)
{
  for (size_t i = 0; i < index->pages; i++) {
    sg_block_give(index->next[i]);
  }
  free(index->next);
  free(index->link);
  free(index->head);
  index->next = NULL;
  index->link = NULL;
  index->head = NULL;
  index->bits = 0;
  index->links = index->pages = index->page_room = index->link_room =
      index->link_used = 0;
  index->linked = 0;
  index->lates = 0;
  index->free = SG_NO_ROW;
}

/* ---- the ids of one row in a member index ------------------------------ */

typedef struct members {
  const sg_page *page;
  const sg_relation_info *info;
  unsigned place, columns; /* columns not yet given */
  const int32_t *list;     /* being given */
  int32_t left;
  int32_t s, id;
} members;

static members
members_of(const sg_index *index, const sg_table *table, sg_row row)
{
  sg_page *page = sg_table_page(table, row);

  return (members){.page = page,
                   .info = table->info,
                   .place = row % SG_PAGE_ROWS,
                   .columns = index->mask & ~1U,
                   .s = page->cells[0].i[row % SG_PAGE_ROWS]};
}

static bool
members_next(members *m)
{
  while (m->left == 0) {
    unsigned c;
    if (m->columns == 0) {
      return false;
    }
    c = (unsigned)__builtin_ctz(m->columns);
    m->columns &= m->columns - 1;
    if (m->info->column[c].type != SG_LIST) {
      m->id = m->page->cells[c].i[m->place];
      return true;
    }
    m->list = sg_page_value(m->page, m->info, c, m->place).list;
    m->left = *m->list++;
  }
  m->left--;
  m->id = *m->list++;
  return true;
}

/* ---- adding ------------------------------------------------------------ */

static void remove_row(sg_index *index, const sg_table *table, sg_row row);

static void
chain(const sg_index *index, uint64_t hash, uint32_t at)
{
  uint32_t *head = head_of(index, hash);

  *next_of(index, at) = *head;
  *head = at;
}

static uint64_t
hash_at(const sg_index *index, const sg_table *table, uint32_t at)
{
  if (index->members) {
    const sg_link *link = &index->link[at];
    return sg_index_hash_member(
        sg_table_page(table, link->row)->cells[0].i[link->row % SG_PAGE_ROWS],
        link->id);
  }
  return sg_index_hash_row(index, table, at);
}

/* New heads, with everything chained again. False: no memory. */
static bool
grow(sg_index *index, const sg_table *table, unsigned bits)
{
  size_t heads = (size_t)1 << bits;
  uint32_t *head = malloc(heads * sizeof(*head));
  uint32_t *old = index->head;
  size_t old_heads = old ? (size_t)1 << index->bits : 0;

  if (!head) {
    return false;
  }
  memset(head, 0xff, heads * sizeof(*head));
  index->head = head;
  index->bits = bits;
  for (size_t i = 0; i < old_heads; i++) {
    for (uint32_t at = old[i], next; at != SG_NO_ROW; at = next) {
      next = *next_of(index, at);
      chain(index, hash_at(index, table, at), at);
    }
  }
  free(old);
  return true;
}

/* Heads for `links` links; false: no memory. */
static bool
reserve_heads(sg_index *index, const sg_table *table, size_t links)
{
  unsigned bits = index->head ? index->bits : FIRST_BITS;

  while (((size_t)1 << bits) < links && bits < 31) {
    bits++;
  }
  return (index->head && bits == index->bits) || grow(index, table, bits);
}

_Static_assert(SG_PAGE_ROWS * sizeof(uint32_t) == SG_BLOCK_BYTES,
               "a page has one block of links");

static bool
reserve_next(sg_index *index, size_t pages)
{
  if (!sg_list_need(&index->next, pages, &index->page_room,
                    sizeof(*index->next))) {
    return false;
  }
  while (index->pages < pages) {
    index->next[index->pages] = sg_block_take();
    if (!index->next[index->pages]) {
      return false;
    }
    index->pages++;
  }
  return true;
}

/* A link out of use; SG_NO_ROW: no memory. */
static uint32_t
link_take(sg_index *index)
{
  uint32_t at = index->free;

  if (index->free != SG_NO_ROW) {
    index->free = index->link[at].next;
    return at;
  }
  return index->link_used < SG_NO_ROW &&
                 sg_list_grow(&index->link, index->link_used, &index->link_room,
                              sizeof(*index->link))
             ? (uint32_t)index->link_used++
             : SG_NO_ROW;
}

static bool
add_member(sg_index *index, const sg_table *table, sg_row row, int32_t s,
           int32_t id)
{
  uint32_t at = link_take(index);

  if (at == SG_NO_ROW) {
    return false;
  }
  index->link[at] = (sg_link){.row = row, .id = id};
  if (!reserve_heads(index, table, index->links + 1)) {
    index->link[at].next = index->free;
    index->free = at;
    return false;
  }
  chain(index, sg_index_hash_member(s, id), at);
  index->links++;
  return true;
}

bool
sg_index_reserve(sg_index *index, const sg_table *table, size_t n)
{
  return reserve_next(index, table->slots / SG_PAGE_ROWS + 1) &&
         reserve_heads(index, table, index->links + n);
}

void
sg_index_chain(sg_index *index, uint64_t hash, sg_row row)
{
  chain(index, hash, row);
  index->links++;
}

/* Links one more row, already written. False: no memory. */
static bool
add_row(sg_index *index, const sg_table *table, sg_row row)
{
  if (!index->members) {
    if (!reserve_next(index, row / SG_PAGE_ROWS + 1) ||
        !reserve_heads(index, table, index->links + 1)) {
      return false;
    }
    sg_index_chain(index, sg_index_hash_row(index, table, row), row);
    return true;
  }
  for (members m = members_of(index, table, row); members_next(&m);) {
    if (!add_member(index, table, row, m.s, m.id)) {
      remove_row(index, table, row);
      return false;
    }
  }
  return true;
}

/* Takes the link that *from says out of its chain. */
static void
unchain_at(sg_index *index, uint32_t *from)
{
  uint32_t at = *from;

  *from = *next_of(index, at);
  if (index->members) {
    index->link[at].next = index->free;
    index->free = at;
  }
  index->links--;
}

/* Takes one link of `row` out of a chain; false: there is none. */
static bool
unchain(sg_index *index, uint64_t hash, sg_row row)
{
  uint32_t *from = head_of(index, hash);

  while (*from != SG_NO_ROW && sg_index_row(index, *from) != row) {
    from = next_of(index, *from);
  }
  if (*from == SG_NO_ROW) {
    return false;
  }
  unchain_at(index, from);
  return true;
}

/* Unlinks a row, if it is there. */
static void
remove_row(sg_index *index, const sg_table *table, sg_row row)
{
  if (!index->members) {
    unchain(index, sg_index_hash_row(index, table, row), row);
    return;
  }
  for (members m = members_of(index, table, row); members_next(&m);) {
    unchain(index, sg_index_hash_member(m.s, m.id), row);
  }
}

bool
sg_index_row_has(const sg_index *index, const sg_table *table, sg_row row,
                 int32_t s, const int32_t *member, size_t n)
{
  for (members m = members_of(index, table, row); members_next(&m);) {
    for (size_t i = 0; m.s == s && i < n; i++) {
      if (m.id == member[i]) {
        return true;
      }
    }
  }
  return false;
}

/* ---- rows that come and go --------------------------------------------- */

static bool
is_late(const sg_index *index, sg_row row)
{
  for (unsigned k = 0; k < index->lates; k++) {
    if (row >= index->late[k].begin && row < index->late[k].end) {
      return true;
    }
  }
  return false;
}

void
sg_index_link(sg_index *index, const sg_table *table, sg_row row)
{
  if (!index->head || row > index->linked || is_late(index, row)) {
    return;
  }
  if (!add_row(index, table, row)) {
    sg_index_clear(index);
  } else if (row == index->linked) {
    index->linked++;
  }
}

void
sg_index_unlink(sg_index *index, const sg_table *table, sg_row row)
{
  if (index->head && row < index->linked && !is_late(index, row)) {
    remove_row(index, table, row);
  }
}

void
sg_index_wait(sg_index *index, sg_row first)
{
  unsigned n = 0;

  if (index->linked > first) {
    index->linked = first;
  }
  for (unsigned k = 0; k < index->lates; k++) {
    sg_rows late = index->late[k];
    late.end = late.end < first ? late.end : first;
    if (late.begin < late.end) {
      index->late[n++] = late;
    }
  }
  index->lates = n;
}

/* The union of both; false: there is a row between them. */
static bool
unite(sg_rows *rows, sg_rows with)
{
  if (with.begin > rows->end || with.end < rows->begin) {
    return false;
  }
  rows->begin = with.begin < rows->begin ? with.begin : rows->begin;
  rows->end = with.end > rows->end ? with.end : rows->end;
  return true;
}

/* Rows that were late, and went, may be late again: each is so once. */
void
sg_index_be_late(sg_index *index, sg_row row, size_t n)
{
  sg_rows rows = {row, row + (sg_row)n};
  unsigned left = 0;

  rows.end = rows.end < index->linked ? rows.end : index->linked;
  if (rows.end <= row) {
    return; /* they wait anyway */
  }
  for (unsigned k = 0; k < index->lates; k++) {
    if (!unite(&rows, index->late[k])) {
      index->late[left++] = index->late[k];
    }
  }
  index->lates = left;
  if (left < SG_MOST_LATE) {
    index->late[index->lates++] = rows;
  } else {
    sg_index_clear(index);
  }
}

void
sg_index_catch_up(sg_index *index, const sg_table *table)
{
  index->linked = table->slots;
  index->lates = 0;
}

void
sg_index_sweep(sg_index *index, const sg_table *table)
{
  size_t heads = index->head ? (size_t)1 << index->bits : 0;

  for (size_t i = 0; i < heads; i++) {
    for (uint32_t *from = &index->head[i]; *from != SG_NO_ROW;) {
      if (sg_table_taken(table, sg_index_row(index, *from))) {
        from = next_of(index, *from);
      } else {
        unchain_at(index, from);
      }
    }
  }
}

bool
sg_index_is_whole(const sg_index *index, const sg_table *table)
{
  return index->head && index->linked >= table->slots && index->lates == 0;
}

/* Rows in runs are not in the key's index. */
static bool
leaves_runs_out(const sg_index *index, const sg_table *table)
{
  return index == &table->index[0] && table->keys.count > 0;
}

/* How many rows wait, at most. */
static size_t
waiting(const sg_index *index, const sg_table *table)
{
  size_t rows = table->slots > index->linked ? table->slots - index->linked : 0;

  if (leaves_runs_out(index, table)) {
    rows -= sg_runs_rows(table, index->linked);
  }
  for (unsigned k = 0; k < index->lates; k++) {
    rows += index->late[k].end - index->late[k].begin;
  }
  return rows;
}

bool
sg_index_pays(const sg_index *index, const sg_table *table)
{
  return index->searches >= SG_FEW_SEARCHES ||
         waiting(index, table) < SEARCHED_ROWS;
}

/* The first run that is not before `row`; SG_NO_ROW: none that matters. */
static sg_rows
next_run(const sg_index *index, const sg_table *table, sg_row row)
{
  sg_rows run = {SG_NO_ROW, SG_NO_ROW};

  if (leaves_runs_out(index, table)) {
    sg_runs_next(table, row, &run.begin, &run.end);
  }
  return run;
}

/* Links rows from *row on, and moves it on to `end`, or as far as *left slots
 * go. False: no memory. */
static bool
link_rows(sg_index *index, const sg_table *table, sg_row *row, sg_row end,
          sg_row *left)
{
  sg_rows run = next_run(index, table, *row);

  while (*row<end && * left> 0) {
    --*left;
    if (*row == run.begin) {
      *row = run.end < end ? run.end : end;
      run = next_run(index, table, *row);
      continue;
    }
    if (sg_table_taken(table, *row) && !add_row(index, table, *row)) {
      return false;
    }
    ++*row;
  }
  return true;
}

bool
sg_index_build_some(sg_index *index, const sg_table *table, sg_row rows)
{
  bool good = reserve_heads(index, table, index->links + waiting(index, table));

  while (good && index->lates > 0 && rows > 0) {
    sg_rows *late = &index->late[index->lates - 1];
    good = link_rows(index, table, &late->begin, late->end, &rows);
    index->lates -= late->begin == late->end;
  }
  good = good && link_rows(index, table, &index->linked, table->slots, &rows);
  if (!good) {
    sg_index_clear(index);
  }
  return good;
}

bool
sg_index_build(sg_index *index, const sg_table *table)
{
  return sg_index_is_whole(index, table) ||
         sg_index_build_some(index, table, SG_NO_ROW);
}

size_t
sg_index_bytes(const sg_index *index)
{
  size_t heads = index->head ? (size_t)1 << index->bits : 0;

  return heads * sizeof(uint32_t) +
         index->pages * (sizeof(uint32_t *) + SG_PAGE_ROWS * sizeof(uint32_t)) +
         index->link_room * sizeof(sg_link);
}

/* How often `row` is chained under this hash. */
static size_t
chained(const sg_index *index, uint64_t hash, sg_row row)
{
  size_t n = 0;

  for (uint32_t at = sg_index_first(index, hash); at != SG_NO_ROW;
       at = sg_index_next(index, at)) {
    n += sg_index_row(index, at) == row;
  }
  return n;
}

bool
sg_index_is_valid(const sg_index *index, const sg_table *table)
{
  size_t links = 0;
  sg_rows run = next_run(index, table, 0);

  if (!index->head) {
    return index->linked == 0 && index->links == 0 && index->lates == 0;
  }
  for (sg_row row = 0; row < table->slots && row < index->linked; row++) {
    if (row >= run.end) {
      run = next_run(index, table, row);
    }
    if (!sg_table_taken(table, row) || is_late(index, row) ||
        (row >= run.begin && row < run.end)) {
      continue;
    }
    if (!index->members) {
      links++;
      if (chained(index, sg_index_hash_row(index, table, row), row) != 1) {
        return false;
      }
      continue;
    }
    for (members m = members_of(index, table, row); members_next(&m);) {
      links++;
      if (chained(index, sg_index_hash_member(m.s, m.id), row) == 0) {
        return false;
      }
    }
  }
  return links == index->links;
}
