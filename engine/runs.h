/* runs.h -- rows that need no place in the index of keys.
 *
 * Layer: store, private. What is appended in bulk mostly has dense ids: row
 * r + i of a segment has id + i, or says something of vertex id + i. Such a run
 * is remembered by its ends, and its rows are found by counting. The key's
 * index holds the other rows only, so that a model of millions of rows is asked
 * at once, without an index being built.
 *
 * Only for keys of a segment and an id, or a term: the id of v(N) is N. A run
 * says what was written; if a row lives still is the version's to say. Slots
 * are used again only after a sweep, which looks at the runs too
 * (sg_runs_sweep()).
 */
#ifndef SG_RUNS_H
#define SG_RUNS_H

#include "store.h"

struct sg_table;
struct sg_map;

/* Row `row` + i has the key (s, id + i), for i below n. */
typedef struct sg_run {
  int32_t s, id;
  sg_row row, n;
} sg_run;

typedef struct sg_runs {
  sg_run *run; /* [count], by s, then row */
  size_t count, room;
} sg_runs;

void sg_runs_clear(sg_runs *runs);

/* Remembers the runs among rows that were just written, those of one sheet.
 * Short ones, and those for which there is no room, are left to the index. */
void sg_runs_add(struct sg_table *table, const sg_sheet *sheet);
/* The id in the key of a row; 0: none. */
int32_t sg_runs_id(const struct sg_table *table, sg_row row);
/* The row of a key that is in a run and that the map shows, SG_NO_ROW: none.
 * key: by columns; others are ignored. */
sg_row sg_runs_find(const struct sg_table *table, const struct sg_map *map,
                    const sg_value *key);
/* The first row from `row` on that is in a run, and the first behind the run;
 * SG_NO_ROW for both: there is none. */
void sg_runs_next(const struct sg_table *table, sg_row row, sg_row *begin,
                  sg_row *end);
/* Rows from `row` on that are in runs. */
size_t sg_runs_rows(const struct sg_table *table, sg_row row);
/* Before slots that are not taken are used again: forgets those of the runs.
 * True if other rows are in no run any more. */
bool sg_runs_sweep(struct sg_table *table);

#endif
