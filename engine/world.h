/* world.h -- what a world is made of. Layer: store, private. */
#ifndef SG_WORLD_H
#define SG_WORLD_H

#include "table.h"

#include <pthread.h>
#include <stdatomic.h>

/* What an edit may have broken (mark.c): */
typedef enum sg_mark_kind {
  SG_MARK_GONE,     /* row (s, id) was retracted */
  SG_MARK_GONE_OF,  /* all rows of segment s were */
  SG_MARK_GONE_ALL, /* or all rows */
  SG_MARK_MADE,     /* a kernel retracted row (s, id) of what it made: */
  SG_MARK_MADE_ALL, /* or all rows: whatever refers to them goes too */
  SG_MARK_ROW,      /* a row was added before what it refers to */
  SG_MARK_ROWS      /* some rows were */
} sg_mark_kind;

typedef struct sg_mark sg_mark;

struct sg_version {
  atomic_size_t holders;
  sg_world *world;
  sg_version *previous, *next; /* all versions of the world */
  sg_map *map[SG_RELATIONS];
  sg_mark *marks; /* null: it is known to be whole */
};

/* A list of held versions: open transactions, undo steps, redo steps. */
typedef struct sg_stack {
  sg_version **version;
  size_t count, room;
} sg_stack;

struct sg_world {
  atomic_size_t holders; /* by hold */
  atomic_size_t keepers; /* by keep, and all holders together */
  uint64_t number;
  pthread_mutex_t lock;
  pthread_cond_t turn; /* a transaction or claim of another thread ended */
  sg_table table[SG_RELATIONS];
  sg_version *versions; /* every version that is held */
  sg_version *current;
  sg_stack open, undo, redo;
  uint64_t *changes_at; /* `changes` when each open transaction began */
  size_t changes_room;
  uint64_t changes;
  size_t undo_limit;
  pthread_t writer; /* valid while writer_depth > 0 */
  size_t writer_depth;
  uint64_t stamps; /* the last one given out; never goes back */
  uint64_t referring[SG_RELATIONS]; /* relations whose rows refer to this one */
  _Atomic(void *) note[SG_NOTES];
  void (*drop_note[SG_NOTES])(void *note);
};

_Static_assert(SG_RELATIONS <= 64, "sg_world.referring has a bit for each");

/* Takes the lock when no other thread writes; leave releases it. */
void sg_world_enter(sg_world *world);
void sg_world_leave(sg_world *world);

/* The following are called under the lock. */

/* What this thread sees: another thread's open transaction does not show. */
sg_version *sg_world_visible(sg_world *world);
/* The current version, for writing. Null: no memory. */
sg_version *sg_world_own(sg_world *world);
/* One holder of a version less. */
void sg_stack_clear(sg_stack *stack);
/* Makes slots that no version shows empty. */
void sg_world_sweep(sg_world *world, sg_relation relation);
/* Does so when otherwise n rows more, in bulk or each in a slot of its own,
 * would open new pages, if at least a quarter of the slots is dead and enough
 * was written since the last sweep to pay for this one; or if lists and terms
 * take twice as much as then, and some rows are dead. */
void sg_world_sweep_if_worth(sg_world *world, sg_relation relation, size_t n,
                             bool single);

/* Lists of marks are counted by their holders, and never change. */
sg_mark *sg_marks_hold(sg_mark *mark);
void sg_marks_drop(sg_mark *mark);
typedef bool sg_use_mark(void *data, sg_mark_kind kind, sg_relation relation,
                         int32_t s, int32_t id, sg_row row);
/* Calls `use` with each until it says false, which is returned. */
bool sg_marks_each(const sg_mark *mark, sg_use_mark *use, void *data);
/* Marks the current version, in the first case unless no row can refer to the
 * relation; `derived`: none of a derived relation. False: no memory. */
bool sg_world_mark_gone(sg_world *world, sg_relation relation,
                        sg_mark_kind kind, bool derived, int32_t s, int32_t id);
bool sg_world_mark_row(sg_world *world, sg_relation relation, sg_row row);

/* What the current version shows of a relation, for writing. Null: no
 * memory. */
sg_map *sg_world_own_map(sg_world *world, sg_relation relation);
/* Rows of segment s are about to change in an owned map. False: no memory. */
bool sg_world_stamp(sg_world *world, sg_map *map, sg_relation relation,
                    int32_t s);
/* Something was written: counts it and forgets the redo steps. */
void sg_world_changed(sg_world *world);

/* The segment and id by which others may refer to a row; false: they do not. */
bool sg_page_pair(const sg_page *page, sg_relation relation, unsigned place,
                  int32_t *s, int32_t *id);
/* Retracts a row, whatever refers to it. False: it did not live, or no
 * memory. */
bool sg_world_remove(sg_world *world, sg_relation relation, sg_row row);
/* The same without the lock. */
bool sg_world_hide(sg_world *world, sg_relation relation, sg_row row);
/* Writes a row that is right into a slot and shows it, in an owned map. False:
 * no memory. */
bool sg_world_put_row(sg_world *world, sg_map *map, sg_relation relation,
                      sg_row slot, const sg_value *row);
/* sg_append_open(), _commit() and _close() without lock and claim. End it also
 * after a failure. */
bool sg_append_begin(sg_append *append, sg_world *world, sg_relation relation,
                     size_t n);
bool sg_append_show(sg_append *append);
void sg_append_end(sg_append *append);
/* Before the first list or term of a page is made: there are none. */
void sg_append_want_refs(sg_append *append, size_t page);

/* Checks of one value: its type's bounds; that the rows it refers to live. */
bool sg_value_is_valid(const sg_relation_info *info, unsigned column,
                       sg_value value);
sg_status sg_world_check_reference(sg_world *world, sg_relation relation,
                                   unsigned column, int32_t s, sg_value value,
                                   sg_fault *fault);
/* The index of the relation's key, if it has one, is built. False: no
 * memory. */
bool sg_world_key_ready(sg_world *world, sg_relation relation);

#endif
