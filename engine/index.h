/* index.h -- hash indexes: which rows MAY have these values.
 *
 * Layer: store, private. An index holds hints: every taken row of its table
 * below `linked`, whatever version shows it; the caller checks row and version.
 * Rows that are written behind those in bulk wait until the index is used, so
 * that nobody pays for an index that nobody asks; so do rows that are *late*:
 * written in bulk where rows had been before. Growing rebuilds the heads
 * and moves no row. Ids next to one another share a cache
 * line of heads, so that loading and walking in id order is fast.
 *
 * Two kinds. A row index chains rows that agree in the columns of its mask. A
 * member index (polygons by edge) has a link for each id in a row, found by
 * column 0 and that id.
 */
#ifndef SG_INDEX_H
#define SG_INDEX_H

#include "store.h"

struct sg_table;

typedef struct sg_link {
  sg_row row;
  int32_t id;
  uint32_t next;
} sg_link;

/* Rows begin .. end - 1. */
typedef struct sg_rows {
  sg_row begin, end;
} sg_rows;

enum {
  SG_MOST_LATE = 64,
  SG_FEW_SEARCHES = 32 /* looks at all rows that cost what an index costs */
};

typedef struct sg_index {
  const char *name; /* these three never change: read without a lock */
  uint16_t mask;
  bool members;
  sg_row linked; /* the taken rows below that are not late are linked */
  sg_rows late[SG_MOST_LATE]; /* waiting rows below `linked`, disjoint */
  unsigned lates;
  unsigned bits;   /* 2^bits heads */
  uint32_t *head;  /* row or link, SG_NO_ROW: none; null: nothing is linked */
  size_t links;    /* chained at present */
  uint32_t **next; /* row index: [pages][SG_PAGE_ROWS] */
  size_t pages, page_room;
  sg_link *link; /* member index: [link_room] */
  size_t link_room;
  size_t link_used;  /* links below were used once */
  uint32_t free;     /* first link to use again, SG_NO_ROW: none */
  unsigned searches; /* looks at all rows instead */
} sg_index;

/* True if every taken row is linked: it may be asked. */
bool sg_index_is_whole(const sg_index *index, const struct sg_table *table);
/* False: so many rows wait that a look at all rows costs less, as long as it is
 * asked seldom. Who then looks at all rows counts it in `searches`. */
bool sg_index_pays(const sg_index *index, const struct sg_table *table);
/* True if a row that was written has one of these members. */
bool sg_index_row_has(const sg_index *index, const struct sg_table *table,
                      sg_row row, int32_t s, const int32_t *member, size_t n);
/* Links the rows that wait, `rows` slots more. False: no memory, nothing is
 * linked any more. */
bool sg_index_build_some(sg_index *index, const struct sg_table *table,
                         sg_row rows);
/* All of them: it is whole, at no cost if it was. */
bool sg_index_build(sg_index *index, const struct sg_table *table);
void sg_index_clear(sg_index *index);

/* A row was just written; one behind those that wait waits too. Without memory
 * nothing is linked any more. */
void sg_index_link(sg_index *index, const struct sg_table *table, sg_row row);
/* A row is about to be vacated. */
void sg_index_unlink(sg_index *index, const struct sg_table *table, sg_row row);
/* Slots from here on are free, and get new rows, which wait. */
void sg_index_wait(sg_index *index, sg_row first);
/* n free slots from `row` on get new rows, which wait. An index that was not
 * asked for long is forgotten. */
void sg_index_be_late(sg_index *index, sg_row row, size_t n);
/* The rows that wait are now linked one by one, by sg_index_chain(). */
void sg_index_catch_up(sg_index *index, const struct sg_table *table);
/* Rows that are taken no more are unlinked. */
void sg_index_sweep(sg_index *index, const struct sg_table *table);

/* Room for every slot of the table, and n links more. False: no memory. */
bool sg_index_reserve(sg_index *index, const struct sg_table *table, size_t n);
/* Links a row that has room, with the hash that is its own. */
void sg_index_chain(sg_index *index, uint64_t hash, sg_row row);

/* A walk along the chain of some values; SG_NO_ROW ends it.
 *   for (uint32_t at = sg_index_first(index, hash); at != SG_NO_ROW;
 *        at = sg_index_next(index, at)) use(sg_index_row(index, at)); */
uint32_t sg_index_first(const sg_index *index, uint64_t hash);
uint32_t sg_index_next(const sg_index *index, uint32_t at);
sg_row sg_index_row(const sg_index *index, uint32_t at);

size_t sg_index_bytes(const sg_index *index);
/* True if every taken row below `linked` is chained where it belongs, once,
 * and nothing else is. */
bool sg_index_is_valid(const sg_index *index, const struct sg_table *table);

#endif
