/* store.h -- worlds: relations as paged typed columns, with versions.
 *
 * Layer: store. No Prolog, no geometry.
 *
 * A row is never changed after it is written: change = retract + add. A
 * *version* is what a world held at one moment: a reference-counted, two-level
 * directory of pages with their live bitmaps (512 bytes a page). Writing
 * copies only directories and bitmaps that somebody else still holds, so a
 * reader, a snapshot, an open transaction and an undo record are all the same
 * thing: a held version. Rolling back, undo and redo swap versions.
 *
 * A slot is used again only when no held version shows its row (sweep, done
 * when a relation is a quarter dead): then it goes to its page's empty stack,
 * or its page, if nothing else is on it, to the next rows written in bulk.
 *
 * Threads: one writer a world at a time (a lock inside); any number of readers
 * of held versions, in any thread, without a lock.
 */
#ifndef SG_STORE_H
#define SG_STORE_H

#include "cancel.h"
#include "column.h"
#include "sheet.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum sg_relation {
#define RELATION(ID, name, arity, key, doc) SG_##ID,
#include "relations.def"
  SG_RELATIONS,
  SG_NONE = SG_RELATIONS
} sg_relation;

typedef enum sg_type { SG_INT, SG_FLOAT, SG_LIST, SG_ATOM, SG_TERM } sg_type;

typedef struct sg_column_info {
  const char *name;
  sg_type type;
  sg_relation refers; /* SG_NONE, or whose (S, id) it is */
  const char *doc;
} sg_column_info;

typedef struct sg_relation_info {
  const char *name;
  unsigned arity;
  uint16_t key; /* mask of the key's columns, 0: none */
  const char *doc;
  sg_column_info column[SG_MAX_COLUMNS];
  const char *domain[SG_MAX_COLUMNS];   /* its words, or null: any value */
  double most[SG_MAX_COLUMNS];          /* size of a float, or 0: any */
  bool with_sign[SG_MAX_COLUMNS];       /* ids may be negative: */
  sg_relation negative[SG_MAX_COLUMNS]; /* -K is row K of this one */
  bool derived; /* its rows go with what they refer to */
} sg_relation_info;

extern const sg_relation_info sg_relation_table[SG_RELATIONS];

/* The column that holds the ids which sg_world_fresh() makes: V of v, T of t,
 * D of drawn ... SG_MAX_COLUMNS: the relation has none. */
unsigned sg_relation_id_column(sg_relation relation);
/* True if a row of a relation may refer to one of relation `to`. */
bool sg_relation_refers(sg_relation relation, sg_relation to);
/* The column that names the segment in which a column's ids are. */
unsigned sg_relation_segment_column(sg_relation relation, unsigned column);

/* One value of a row. SG_INT, SG_ATOM (a symbol, symbol.h): i. SG_FLOAT: f.
 * SG_LIST: list, its length first. SG_TERM: term, its byte count first, coded
 * as term.h says (equal bytes = equal terms). In arguments the caller owns the
 * arrays; in results the version does, for as long as it is held. */
typedef union sg_value {
  int32_t i;
  double f;
  const int32_t *list;
  const uint32_t *term;
} sg_value;

typedef uint32_t sg_row; /* page * SG_PAGE_ROWS + place */
#define SG_NO_ROW UINT32_MAX

typedef enum sg_status {
  SG_OK,
  SG_NO_MEMORY,
  SG_EXISTS,   /* a live row has this key */
  SG_DANGLING, /* a referred row does not exist; sg_fault says which */
  SG_INVALID,  /* NaN, infinite, an id below 1, a negative count */
  SG_NO_STEP,  /* nothing to commit, roll back, undo or redo */
  SG_HALTED    /* the cancellation said stop: nothing was changed */
} sg_status;

/* Which value of which row was at fault. */
typedef struct sg_fault {
  size_t row; /* of the buffer, 0 for a single row */
  unsigned column;
  sg_relation to; /* of the missing row, for SG_DANGLING: */
  int32_t s, id;
} sg_fault;

/* A row that lives and refers to one that is not there. */
typedef struct sg_breach {
  sg_relation relation, missing;
  sg_row row;
  int32_t s, id; /* of the missing row */
} sg_breach;

typedef struct sg_world sg_world;
typedef struct sg_version sg_version;

/* Life. A world is reference counted: open gives one reference. Versions, and
 * what looks into them, do not hold a world but keep it, since it may keep them
 * itself, in a note: its memory lasts until all have let go. Undo keeps
 * `undo_limit` steps (64 by default, set with sg_world_undo_limit). */
sg_world *sg_world_open(void);
sg_world *sg_world_hold(sg_world *world);
void sg_world_drop(sg_world *world);
sg_world *sg_world_keep(sg_world *world);
void sg_world_let_go(sg_world *world);
/* Nobody will ask for its rows any more: it is empty from now on, without undo,
 * and their memory is free. Unless another one holds or keeps it, or in a
 * transaction: then nothing happens. */
void sg_world_spend(sg_world *world);
/* 1, 2, 3 ... in the order of opening: names a world in messages. */
uint64_t sg_world_number(const sg_world *world);
void sg_world_undo_limit(sg_world *world, unsigned steps);
/* Things that glue keeps with the world, one of each sort, null at first; any
 * thread may read them at any time. `drop` is called with the last one of its
 * sort when the world ends; of the pieces already when nobody holds the world
 * but what keeps it. */
typedef enum sg_note {
  SG_NOTE_RULES,
  SG_NOTE_TREES,
  SG_NOTE_TOLERANCE,
  SG_NOTE_PIECES,
  SG_NOTE_SCENES,
  SG_NOTE_DEFECTS,
  SG_NOTES
} sg_note;
void *sg_world_note(const sg_world *world, sg_note which);
void sg_world_set_note(sg_world *world, sg_note which, void *note,
                       void (*drop)(void *note));
/* The one that is there, made at the first use: zeros that begin with a mutex,
 * initialized. Null: no memory. drop() destroys the mutex and frees it. */
void *sg_world_add_note(sg_world *world, sg_note which, size_t size,
                        void (*drop)(void *note));

/* The version at this moment; drop it when done (from any thread). */
const sg_version *sg_world_version(sg_world *world);
sg_world *sg_version_world(const sg_version *version);
/* A version that shows of n segments (ascending) what this one does in the
 * relations of a mask (bit sg_relation), whose column 0 is a segment, and
 * nothing else: for who looks at few rows for long, and should not keep the
 * others from being used again. Drop it when done. Null: no memory. */
const sg_version *sg_version_narrow(const sg_version *version,
                                    uint64_t relations, const int32_t *s,
                                    size_t n);
void sg_version_drop(const sg_version *version);

/* Changes, each checked against the schema: keys and references. */
sg_status sg_world_add(sg_world *world, sg_relation relation,
                       const sg_value *row, sg_row *out, sg_fault *fault);
/* n rows from column arrays: column[c] is int32_t[n], double[n],
 * const int32_t *[n] or const uint32_t *[n] by type. All or nothing. */
sg_status sg_world_add_many(sg_world *world, sg_relation relation, size_t n,
                            const void *const *column, sg_fault *fault);
/* The same; the cancellation is asked between rows that are checked, without
 * the lock, while this thread has the world claimed. */
sg_status sg_world_add_many_or_stop(sg_world *world, sg_relation relation,
                                    size_t n, const void *const *column,
                                    const sg_cancel *cancel, sg_fault *fault);

/* Many rows that are right by construction: their maker writes the cells in
 * place, with several threads if it likes, and then all are shown at once. Keys
 * and references are not looked at, indexes take the rows in when they are used
 * next (that of keys only those without dense ids, runs.h), so a row costs what
 * writing its cells costs. For rows that a kernel
 * made itself; what a user wrote goes through sg_world_add_many().
 *
 *   sg_append a;
 *   if (sg_append_open(&a, world, SG_V, n)) {
 *     ... fill every cell of a.sheet ...
 *     if (!sg_append_commit(&a)) no_memory();
 *     sg_append_close(&a);
 *   }
 *
 * The maker promises what sg_world_add_many() checks: values within their
 * column's bounds, no -0.0 or NaN, no key that a row or another of these has,
 * no reference to a row that is not there. From opening to closing the world is
 * claimed by this thread, which makes no other change of this relation. */
typedef struct sg_append {
  sg_world *world;
  sg_relation relation;
  sg_sheet sheet;
  bool keyed; /* the store's: whoever writes them enters their keys at once */
  bool shown;
} sg_append;

/* Room for n rows. False: no memory, and it is closed. */
bool sg_append_open(sg_append *append, sg_world *world, sg_relation relation,
                    size_t n);
/* Gives the rows of a page of the sheet lists of length[i] ids in an SG_LIST
 * column, which their first words say; ids are still to be written, by any
 * thread. False: no memory. */
bool sg_append_lists(sg_append *append, size_t page, unsigned column,
                     const int32_t *length);
/* Gives the rows of a page of the sheet copies of term[i] in an SG_TERM column.
 * False: no memory. */
bool sg_append_terms(sg_append *append, size_t page, unsigned column,
                     const uint32_t *const *term);
/* Only the first n rows are wanted. */
void sg_append_shorten(sg_append *append, size_t n);
/* Shows the rows: a change like any other. False: no memory, nothing is
 * shown. */
bool sg_append_commit(sg_append *append);
/* After a commit, or instead of it: nothing is left. */
void sg_append_close(sg_append *append);

/* Some rows of many are exchanged for others: rows `gone` live no more, which
 * all live now, and n new ones do, from column arrays as of
 * sg_world_add_many(), right by construction as those of sg_append. They are
 * written one by one, into slots that are free anywhere. False: no memory, some
 * may be exchanged: roll back. */
bool sg_world_exchange(sg_world *world, sg_relation relation,
                       const sg_row *gone, size_t gones, size_t n,
                       const void *const *column);

/* True if the row lived in the current version, and now does not. */
bool sg_world_retract(sg_world *world, sg_relation relation, sg_row row);
/* False: no memory. */
bool sg_world_retract_all(sg_world *world, sg_relation relation);
/* The same for who adds rows with the same keys again. */
bool sg_world_retract_all_again(sg_world *world, sg_relation relation);
/* All rows with this id in an SG_INT column: one look at the column. False: no
 * memory, some of them may live. */
bool sg_world_retract_with(sg_world *world, sg_relation relation,
                           unsigned column, int32_t id);
/* Whether rows of segment s live: it is their first column. */
bool sg_world_has_of(sg_world *world, sg_relation relation, int32_t s);

/* Whole worlds. A version is whole if every row that a row refers to is there,
 * as relations.def has it. Kernels rely on it, and what they write themselves
 * keeps it so. What a user edits goes through the functions below. Inside a
 * transaction they only remember, with the version, what they may have broken:
 * a version without such marks is whole, at no cost. Making it whole looks at
 * what is marked: rows of derived relations that refer to nothing are dropped;
 * if another row does, that is a breach and everything stays. `cascade`: such
 * rows are dropped too. This thread has the world claimed.
 *
 * sg_world_retract_edit() outside a transaction, or when it cascades, retracts
 * a row only if the world is whole then: SG_DANGLING, the breach says by which
 * row it would not be. SG_NO_STEP: the row does not live. The two for many
 * rows, and sg_world_add_edit(), which adds a row before what it refers to, are
 * for transactions only. */
bool sg_world_is_whole(sg_world *world); /* what this thread sees */
sg_status sg_world_make_whole(sg_world *world, bool cascade, sg_breach *breach);
sg_status sg_world_retract_edit(sg_world *world, sg_relation relation,
                                sg_row row, bool cascade, sg_breach *breach);
bool sg_world_retract_all_edit(sg_world *world, sg_relation relation);
bool sg_world_retract_of_edit(sg_world *world, sg_relation relation, int32_t s);
sg_status sg_world_add_edit(sg_world *world, sg_relation relation,
                            const sg_value *row, sg_row *out, sg_fault *fault);

/* The next id never yet used in relation (column 1, or column 2 of t, or
 * column 0 of segment, line, drawn) of segment s (0 for those three); 0: none
 * is left; -1: no memory. Follows roll-back: the same operation done again
 * gives the same ids. */
int32_t sg_world_fresh(sg_world *world, sg_relation relation, int32_t s);

/* Waits until no other thread has a transaction open or the world claimed,
 * asking `cancel` meanwhile; then this thread alone may write until it releases
 * (claims nest). False: the cancellation said stop. Without a claim, a change
 * simply waits, deaf, until it is its turn. */
bool sg_world_claim(sg_world *world, const sg_cancel *cancel);
void sg_world_release(sg_world *world);

/* Transactions nest. They belong to the thread that began them: others see
 * the world as it was before, and wait with their changes. The outermost commit
 * that changed anything is an undo step and clears the redo steps; one that
 * only made a picture (drawn/7 and what it comes from, with its view), or
 * planes and triangles, is none and leaves them. */
sg_status sg_world_begin(sg_world *world);
sg_status sg_world_commit(sg_world *world);
sg_status sg_world_rollback(sg_world *world);
/* A commit that is no undo step: of a change outside any transaction, which
 * needs one to be taken back if it cannot be. */
sg_status sg_world_commit_change(sg_world *world);
/* How many transactions this thread has open. */
size_t sg_world_depth(sg_world *world);
/* Steps back and forth, outside transactions only. A change outside any
 * transaction is no step of its own, and clears the redo steps. */
sg_status sg_world_undo(sg_world *world);
sg_status sg_world_redo(sg_world *world);

/* Reading a version. */
size_t sg_version_count(const sg_version *version, sg_relation relation);
bool sg_version_live(const sg_version *version, sg_relation relation,
                     sg_row row);
/* Two versions of a world with the same stamp show the same rows, in the same
 * slots, of segment s: what was made from them is still right. Undo brings the
 * old stamp back. 0: there never was one. Only for relations in which
 * sg_world_fresh() makes ids (s is 0 for the three it names). */
uint64_t sg_version_stamp(const sg_version *version, sg_relation relation,
                          int32_t s);

/* The last of those of v/5, e/5 and p/3: what segment_stamp/2 says. */
uint64_t sg_segment_stamp(const sg_version *version, int32_t s);
/* The newest stamp of all segments: the same for the whole relation. */
uint64_t sg_version_last_stamp(const sg_version *version, sg_relation relation);
sg_value sg_version_value(const sg_version *version, sg_relation relation,
                          sg_row row, unsigned column);
/* The columns of a page, which has a row that the version shows: each has the
 * value of a row in its place, row % SG_PAGE_ROWS. They stay as long as the
 * version. */
union sg_cell_array {
  int32_t *i;           /* SG_INT, SG_ATOM */
  double *f;            /* SG_FLOAT */
  const uint32_t **ref; /* SG_LIST, SG_TERM: into the arena */
};
const union sg_cell_array *sg_version_cells(const sg_version *version,
                                            sg_relation relation, size_t page);
/* Several at once: the columns of the mask, each in its place in `out`. */
void sg_version_row(const sg_version *version, sg_relation relation, sg_row row,
                    uint16_t mask, sg_value *out);
/* The row with this key (values in column order, others ignored). */
sg_row sg_version_find(const sg_version *version, sg_relation relation,
                       const sg_value *row);
/* The same, among the rows that are found by counting (runs.h): no index is
 * built. SG_NO_ROW: it is none of these. */
sg_row sg_version_find_counted(const sg_version *version, sg_relation relation,
                               const sg_value *row);
/* A view for kernels, valid while the version is held. False: no memory.
 * sg_view_clear() frees its arrays. */
bool sg_version_view(const sg_version *version, sg_relation relation,
                     sg_view *out);
void sg_view_clear(sg_view *view);

/* A walk over the rows that match the bound columns, in insertion order.
 *
 *   sg_walk walk;
 *   if (sg_walk_open(&walk, version, SG_E, mask, row)) {
 *     for (sg_row r; (r = sg_walk_next(&walk)) != SG_NO_ROW;) ...
 *     sg_walk_close(&walk);
 *   }
 *
 * A bound SG_LIST or SG_TERM matches by content. `member` walks find the rows
 * that have id `member` in a column of a MEMBERS index. The walk does not hold
 * the version: the caller does. */
typedef struct sg_walk sg_walk;
/* Builds the index that a walk by `mask` will look into (0: a member walk) if
 * that would take long, asking the cancellation every few ms, without the lock.
 * False: it said stop. Not needed, except for the cancellation. */
bool sg_index_ready(const sg_version *version, sg_relation relation,
                    uint16_t mask, const sg_cancel *cancel);
bool sg_walk_open(sg_walk *walk, const sg_version *version,
                  sg_relation relation, uint16_t mask, const sg_value *row);
/* As sg_walk_open(); SG_WALK_WAITS: nothing is open, sg_index_ready() comes
 * first. */
typedef enum sg_walk_opening {
  SG_WALK_OPEN,
  SG_WALK_WAITS,
  SG_WALK_NO_MEMORY
} sg_walk_opening;
sg_walk_opening sg_walk_try(sg_walk *walk, const sg_version *version,
                            sg_relation relation, uint16_t mask,
                            const sg_value *row);
bool sg_walk_open_member(sg_walk *walk, const sg_version *version,
                         sg_relation relation, int32_t s, int32_t member);
/* The rows that have one of n such ids, or several: at the cost of one walk
 * where all rows are looked at. */
bool sg_walk_open_members(sg_walk *walk, const sg_version *version,
                          sg_relation relation, int32_t s,
                          const int32_t *member, size_t n);
/* True if there is a row that such a walk finds, or no memory to look. */
bool sg_version_has_member(const sg_version *version, sg_relation relation,
                           int32_t s, int32_t member);
sg_row sg_walk_next(sg_walk *walk);
void sg_walk_rewind(sg_walk *walk);
void sg_walk_close(sg_walk *walk);

/* What a relation costs and how its indexes are used. `bytes` includes by what
 * the version that is seen shows rows; `version_bytes` is by what all do that
 * are held, what several share once. */
typedef struct sg_statistics {
  size_t rows, slots, bytes, index_bytes, version_bytes, versions;
  uint64_t scans, lookups;
} sg_statistics;
void sg_world_statistics(sg_world *world, sg_relation relation,
                         sg_statistics *out);

/* True if every invariant of the world holds; tests call it after each step. */
bool sg_world_is_valid(sg_world *world);

#include "store_private.h" /* struct sg_walk, for callers' stacks */

#endif
