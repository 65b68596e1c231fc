/* by_segment.h -- the rows of some segments, found in one walk of a relation;
 * and rows by id.
 *
 * Layer: kernel.
 */
#ifndef SG_BY_SEGMENT_H
#define SG_BY_SEGMENT_H

#include "engine/cancel.h"
#include "engine/column.h"

#include <stdbool.h>

/* Rows are numbered as in the store: page * SG_PAGE_ROWS + place. Those of
 * wanted[i] are row[begin[i]] .. row[begin[i + 1] - 1], ascending. */
typedef struct sg_segment_rows {
  size_t *begin; /* [n + 1] */
  uint32_t *row;
} sg_segment_rows;

/* The live rows of n segments (ascending numbers); column 0 is the segment.
 *
 * Returns: false: no memory, or the cancellation said stop.
 * Owner:   sg_segment_rows_clear() in any case. */
bool sg_segment_rows_find(const sg_view *view, const int32_t *wanted, size_t n,
                          const sg_cancel *cancel, sg_segment_rows *out);
void sg_segment_rows_clear(sg_segment_rows *rows);

/* The same rows as a view: it shows no others. It is good as long as `view` is,
 * whose columns it has.
 *
 * Returns: false: no memory.
 * Owner:   sg_segment_view_clear() in any case. */
bool sg_segment_view_make(const sg_view *view, const int32_t *wanted, size_t n,
                          sg_view *out);
void sg_segment_view_clear(sg_view *view);

/* The rows of all other segments as a view. */
bool sg_segment_view_without(const sg_view *view, const int32_t *unwanted,
                             size_t n, sg_view *out);

/* The rows of one segment by id: a flat table from the lowest id to the highest
 * when they are close together, else sorted ids. Places are numbers below
 * `places`, ascending with the ids. */
typedef struct sg_id_rows {
  int32_t first; /* the lowest id */
  size_t places;
  uint32_t *row; /* [places]; SG_NO_ID_ROW: no row has this id */
  int32_t *id;   /* [places], ascending; null: the id is first + place */
} sg_id_rows;

#define SG_NO_ID_ROW UINT32_MAX

/* From n rows; column 1 is the id. False: no memory. Owner: the caller. */
bool sg_id_rows_make(const sg_view *view, const uint32_t *row, size_t n,
                     sg_id_rows *out);
void sg_id_rows_clear(sg_id_rows *table);
size_t sg_id_rows_bytes(const sg_id_rows *table);

#define SG_NO_ID_PLACE SIZE_MAX

/* Where ids are sorted. */
size_t sg_id_rows_search(const sg_id_rows *table, int32_t id);

/* The place of an id, SG_NO_ID_PLACE: no row has it. */
static inline size_t
sg_id_rows_place(const sg_id_rows *table, int32_t id)
{
  size_t place = (size_t)((int64_t)id - table->first); /* below first: huge */

  if (table->id) {
    return sg_id_rows_search(table, id);
  }
  return place < table->places && table->row[place] != SG_NO_ID_ROW
             ? place
             : SG_NO_ID_PLACE;
}

/* The place that an id has if it has one: not whether a row has it, of ids that
 * are close together. SG_NO_ID_PLACE: it has none. */
static inline size_t
sg_id_rows_slot(const sg_id_rows *table, int32_t id)
{
  size_t place = (size_t)((int64_t)id - table->first); /* below first: huge */

  if (table->id) {
    return sg_id_rows_search(table, id);
  }
  return place < table->places ? place : SG_NO_ID_PLACE;
}

/* The row of an id, SG_NO_ID_ROW: none. */
static inline uint32_t
sg_id_rows_find(const sg_id_rows *table, int32_t id)
{
  size_t place = sg_id_rows_place(table, id);

  return place == SG_NO_ID_PLACE ? SG_NO_ID_ROW : table->row[place];
}

#endif
