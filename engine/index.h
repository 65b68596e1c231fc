/* index.h -- hash indexes: which rows MAY have these values.
 *
 * Layer: store, private. An index holds hints: every taken row of its table,
 * whatever version shows it; the caller checks row and version. Growing
 * rebuilds the heads and moves no row. Ids next to one another share a cache
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

typedef struct sg_index {
  const char *name; /* these three never change: read without a lock */
  uint16_t mask;
  bool members;
  bool built;
  unsigned bits;   /* 2^bits heads */
  uint32_t *head;  /* row or link, SG_NO_ROW: none */
  size_t links;    /* chained at present */
  uint32_t **next; /* row index: [pages][SG_PAGE_ROWS] */
  size_t pages;
  sg_link *link; /* member index: [link_room] */
  size_t link_room;
  size_t link_used; /* links below were used once */
  uint32_t free;    /* first link to use again, SG_NO_ROW: none */
  sg_row linked;    /* of an index half built: rows below are linked */
  uint64_t changes; /* and the table's were then */
} sg_index;

/* Links `rows` more of the taken rows, or begins anew if the table changed
 * since; the last ones make it built. False: no memory, it stays unbuilt. */
bool sg_index_build_some(sg_index *index, const struct sg_table *table,
                         sg_row rows);
/* All of them. */
bool sg_index_build(sg_index *index, const struct sg_table *table);
void sg_index_clear(sg_index *index);

/* Room for every slot of the table, and n links more. False: no memory. */
bool sg_index_reserve(sg_index *index, const struct sg_table *table, size_t n);
/* Links a row that has room, with the hash that is its own. */
void sg_index_chain(sg_index *index, uint64_t hash, sg_row row);
uint64_t sg_index_hash_row(const sg_index *index, const struct sg_table *table,
                           sg_row row);
/* Links one more row, already written. False: no memory. */
bool sg_index_add(sg_index *index, const struct sg_table *table, sg_row row);
/* Unlinks a row, if it is there. */
void sg_index_remove(sg_index *index, const struct sg_table *table, sg_row row);

/* A walk along the chain of some values; SG_NO_ROW ends it.
 *   for (uint32_t at = sg_index_first(index, hash); at != SG_NO_ROW;
 *        at = sg_index_next(index, at)) use(sg_index_row(index, at)); */
uint32_t sg_index_first(const sg_index *index, uint64_t hash);
uint32_t sg_index_next(const sg_index *index, uint32_t at);
sg_row sg_index_row(const sg_index *index, uint32_t at);

uint64_t sg_index_hash(const sg_relation_info *info, uint16_t mask,
                       const sg_value *row);
uint64_t sg_index_hash_member(int32_t s, int32_t member);

size_t sg_index_bytes(const sg_index *index);
/* True if every taken row is chained where it belongs, once. */
bool sg_index_is_valid(const sg_index *index, const struct sg_table *table);

#endif
