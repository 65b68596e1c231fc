/* table.h -- one relation of a world: pages of cells, slots, versions' maps.
 *
 * Layer: store, private to store.c, table.c, version.c, index.c and walk.c.
 *
 *   table   what is written once and shared by all versions of a world:
 *           pages of cells, the empty stacks, the arena, the indexes
 *   map     what one version shows of a table: a two-level directory of live
 *           bitmaps. Maps, chunks and bitmaps are counted by their holders
 *           and copied when written while somebody else holds them.
 *
 * A slot is *taken* from when a row is written until no version shows it
 * (sg_table_sweep()). Everything here is done under the world's lock, except
 * reading through the map of a held version.
 */
#ifndef SG_TABLE_H
#define SG_TABLE_H

#include "arena.h"
#include "ids.h"
#include "index.h"
#include "runs.h"
#include "store.h"
#include "term.h"

#include <stdatomic.h>

enum { SG_CHUNK_PAGES = 64, SG_MAX_INDEXES = 6 };

/* All taken rows of a page are of segments from `first` to `last`, if column 0
 * says segments: who looks for one passes other pages by. Read without the
 * lock: a row that a held version shows is taken. */
typedef struct sg_span {
  atomic_int_least32_t first, last; /* first > last: none */
} sg_span;

typedef struct sg_page {
  union sg_cell_array cells[SG_MAX_COLUMNS];
  uint64_t taken[SG_LIVE_WORDS];
  uint16_t *empty; /* the empty stack: null, or places below `slots`, the first
                      on top */
  unsigned empties;
  unsigned gap; /* of these no more stand in a row */
  bool vacant;  /* no slot was taken at the last sweep, nor since: for many */
  sg_span span;
} sg_page;

typedef struct sg_live {
  uint32_t holders;
  sg_page *page;
  uint64_t word[SG_LIVE_WORDS];
} sg_live;

typedef struct sg_chunk {
  uint32_t holders;
  sg_live *live[SG_CHUNK_PAGES]; /* null: no row of the page lives */
} sg_chunk;

typedef struct sg_map {
  uint32_t holders;
  size_t rows;
  size_t chunks;
  sg_chunk **chunk; /* [chunks], null: no row lives there */
  sg_ids *ids;
} sg_map;

typedef struct sg_table {
  sg_relation relation;
  const sg_relation_info *info;
  sg_page **page; /* [pages], of room page_room */
  size_t pages, page_room;
  sg_row slots;          /* all slots ever written lie below */
  size_t emptied;        /* slots on empty stacks */
  size_t open;           /* no page before this one has an empty slot */
  size_t gap;            /* no page has more of them in a row */
  size_t vacant;         /* pages that are vacant, all of them below `slots` */
  size_t next_vacant;    /* no page before this one is vacant */
  sg_row rest, rest_end; /* free slots of the last page that was vacant */
  size_t written;        /* rows since the last sweep */
  sg_runs keys;          /* rows that the key's index does not have */
  sg_arena arena;
  size_t swept_bytes; /* of the arena, after the last sweep */
  sg_index index[SG_MAX_INDEXES];
  unsigned indexes;
  atomic_uint_least64_t scans;
  uint64_t lookups;
} sg_table;

/* What a version shows. `map` may be null: nothing. */
const sg_live *sg_map_live(const sg_map *map, size_t page);
bool sg_map_shows(const sg_map *map, sg_row row);
sg_map *sg_map_hold(sg_map *map);
void sg_map_drop(sg_map *map);
/* The same map, for writing: *map itself when nobody else holds it, else a
 * copy that takes its place. Null: no memory, *map is as it was. */
sg_map *sg_map_own(sg_map **map);
/* The bitmap of a page in an owned map, for writing. Null: no memory. */
sg_live *sg_map_own_live(sg_map *map, sg_page *page, size_t number);
/* No row of a page lives any more, whose bitmap is owned: it goes. */
void sg_map_empty_page(sg_map *map, size_t number);
/* What the map shows of n segments (ascending), and no more. Null: no
 * memory. */
sg_map *sg_map_narrow(const sg_map *map, const int32_t *s, size_t n);
int32_t sg_map_last_id(const sg_map *map, int32_t s);
bool sg_map_used_id(sg_map *map, int32_t s, int32_t id); /* false: no memory */
/* The stamp of a segment's rows, 0: none. Changing rows of a segment in an
 * owned map gives them a new one, changing all rows gives all one. False: no
 * memory. */
uint64_t sg_map_stamp(const sg_map *map, int32_t s);
uint64_t sg_map_last_stamp(const sg_map *map); /* the newest */
bool sg_map_set_stamp(sg_map *map, int32_t s, uint64_t stamp);
bool sg_map_stamp_all(sg_map *map, uint64_t stamp);
/* The bytes of one holder of the map, as of sg_ids_share(). */
double sg_map_share(const sg_map *map);

/* Cells. */
static inline sg_value
sg_page_value(const sg_page *page, const sg_relation_info *info,
              unsigned column, unsigned place)
{
  sg_value value = {0};

  switch (info->column[column].type) {
  case SG_INT:
  case SG_ATOM:
    value.i = page->cells[column].i[place];
    break;
  case SG_FLOAT:
    value.f = page->cells[column].f[place];
    break;
  case SG_LIST:
  case SG_TERM:
    value.term = page->cells[column].ref[place];
    break;
  }
  return value;
}

/* Fetches the cells of a row at once: they lie far apart. */
static inline void
sg_page_fetch(const sg_page *page, const sg_relation_info *info, unsigned place)
{
  for (unsigned c = 0; c < info->arity; c++) {
    bool small =
        info->column[c].type == SG_INT || info->column[c].type == SG_ATOM;

    __builtin_prefetch((const char *)page->cells[c].i +
                       place * (small ? sizeof(int32_t) : sizeof(double)));
  }
}

static inline int32_t
sg_page_first(const sg_page *page)
{
  return atomic_load_explicit(&page->span.first, memory_order_relaxed);
}

static inline int32_t
sg_page_last(const sg_page *page)
{
  return atomic_load_explicit(&page->span.last, memory_order_relaxed);
}

/* False: no row of a segment is on the page. */
static inline bool
sg_page_may_have(const sg_page *page, int32_t s)
{
  return sg_page_first(page) <= s && s <= sg_page_last(page);
}

/* Rows of n segments are about to be taken. */
void sg_page_extend(sg_page *page, const int32_t *s, size_t n);
/* After rows were vacated: as the others have it. */
void sg_page_find_span(sg_page *page);

static inline void
sg_page_row(const sg_page *page, const sg_relation_info *info, uint16_t mask,
            unsigned place, sg_value *out)
{
  for (unsigned m = mask; m; m &= m - 1) {
    unsigned c = (unsigned)__builtin_ctz(m);
    out[c] = sg_page_value(page, info, c, place);
  }
}

/* The row at this place is equal to `row` in the columns of the mask. */
bool sg_page_match(const sg_page *page, const sg_relation_info *info,
                   uint16_t mask, unsigned place, const sg_value *row);

static inline sg_page *
sg_table_page(const sg_table *table, sg_row row)
{
  return table->page[row / SG_PAGE_ROWS];
}

static inline bool
sg_table_taken(const sg_table *table, sg_row row)
{
  return row < table->slots &&
         (sg_table_page(table, row)->taken[row % SG_PAGE_ROWS / 64] >>
              row % 64 &
          1);
}

/* Segments are looked for in whole pages, dead rows and all: before one of a
 * fresh page lives, column 0 is made zero except rows place .. place + n - 1,
 * which are written. */
void sg_page_show(sg_page *page, size_t place, size_t n);

void sg_table_init(sg_table *table, sg_relation relation);
void sg_table_clear(sg_table *table);

/* A slot for one row: from an empty stack, a vacant page, or the end.
 * SG_NO_ROW: no memory. */
sg_row sg_table_slot(sg_table *table);
/* Room for n rows at the end; slots do not grow. */
bool sg_table_reserve(sg_table *table, size_t n);
/* Free slots of vacant pages, for rows that are written many at a time, below
 * the end: first the rest of a page, then whole ones, ascending. */
size_t sg_table_vacancies(const sg_table *table);
/* The first of them; and the first on the next page behind those of `row`'s.
 * There are enough. */
sg_row sg_table_vacancy(const sg_table *table);
sg_row sg_table_next_vacancy(const sg_table *table, sg_row row);
/* n free slots in a row among those for single rows, all on one page: the first
 * of them. SG_NO_ROW: there are none. */
sg_row sg_table_gap(sg_table *table, size_t n);
/* n rows are written from `row` on, on one page: vacancies, a gap, or the
 * end. */
void sg_table_fill(sg_table *table, sg_row row, size_t n);
/* Writes the cells of a row and takes the slot. False: no memory. */
bool sg_table_write(sg_table *table, sg_row row, const sg_value *value);
/* A copy of a list or term in the table's arena. Null: no memory. */
const uint32_t *sg_table_keep(sg_table *table, sg_type type, sg_value value);
/* Gives back such a copy, as long as it was made. Null does nothing. */
void sg_table_let_go(sg_table *table, sg_type type, const uint32_t *ref);
/* Gives the slot's memory back; the slot stays out of use until a sweep. */
void sg_table_vacate(sg_table *table, sg_row row);
/* Slots that none of the maps shows become empty. */
void sg_table_sweep(sg_table *table, sg_map *const *map, size_t maps);

/* The first index with exactly this mask, null: none. */
sg_index *sg_table_index(sg_table *table, uint16_t mask, bool members);
/* Links or unlinks a row in every index that was asked before. One for which
 * there is no memory is cleared, and built again when it is used. */
void sg_table_link(sg_table *table, sg_row row);
void sg_table_unlink(sg_table *table, sg_row row);
/* Links a row in the key's index, in which there is room. False: the map
 * shows another row with this key, nothing was done. */
bool sg_table_link_key(sg_table *table, const sg_map *map, sg_row row);

/* The live row that has row's values in the key's columns: if it is in a run;
 * if it is in the key's index, which is whole; in either. */
sg_row sg_table_find_run(const sg_table *table, const sg_map *map,
                         const sg_value *row);
sg_row sg_table_find_indexed(sg_table *table, const sg_map *map,
                             const sg_value *row);
sg_row sg_table_find(sg_table *table, const sg_map *map, const sg_value *row);

#endif
