/* store.c -- worlds and their versions: life, transactions, undo. */
#include "list.h"
#include "world.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { UNDO_LIMIT = 64 };

/* ---- versions ---------------------------------------------------------- */

static sg_version *
version_new(sg_world *world, const sg_version *from)
{
  sg_version *version = calloc(1, sizeof(*version));

  if (!version) {
    return NULL;
  }
  atomic_init(&version->holders, 1);
  version->world = world;
  for (int r = 0; from && r < SG_RELATIONS; r++) {
    version->map[r] = sg_map_hold(from->map[r]);
  }
  version->marks = from ? sg_marks_hold(from->marks) : NULL;
  version->next = world->versions;
  if (world->versions) {
    world->versions->previous = version;
  }
  world->versions = version;
  return version;
}

static sg_version *
version_hold(sg_version *version)
{
  atomic_fetch_add_explicit(&version->holders, 1, memory_order_relaxed);
  return version;
}

static void
version_empty(sg_version *version)
{
  for (int r = 0; r < SG_RELATIONS; r++) {
    sg_map_drop(version->map[r]);
    version->map[r] = NULL;
  }
  sg_marks_drop(version->marks);
  version->marks = NULL;
}

static void
version_free(sg_version *version)
{
  if (version->previous) {
    version->previous->next = version->next;
  } else {
    version->world->versions = version->next;
  }
  if (version->next) {
    version->next->previous = version->previous;
  }
  version_empty(version);
  free(version);
}

static void
release_version(sg_version *version)
{
  if (atomic_fetch_sub_explicit(&version->holders, 1, memory_order_acq_rel) ==
      1) {
    version_free(version);
  }
}

sg_version *
sg_world_visible(sg_world *world)
{
  bool hidden =
      world->open.count > 0 && !pthread_equal(world->writer, pthread_self());

  return hidden ? world->open.version[0] : world->current;
}

const sg_version *
sg_world_version(sg_world *world)
{
  sg_version *version;

  pthread_mutex_lock(&world->lock);
  version = version_hold(sg_world_visible(world));
  pthread_mutex_unlock(&world->lock);
  sg_world_keep(world);
  return version;
}

sg_world *
sg_version_world(const sg_version *version)
{
  return version->world;
}

void
sg_version_drop(const sg_version *version)
{
  sg_version *held = (sg_version *)version;
  sg_world *world;

  if (!version) {
    return;
  }
  world = held->world;
  if (atomic_fetch_sub_explicit(&held->holders, 1, memory_order_acq_rel) == 1) {
    pthread_mutex_lock(&world->lock);
    version_free(held);
    pthread_mutex_unlock(&world->lock);
  }
  sg_world_let_go(world);
}

/* The maps of a new version; false: no memory. */
static bool
narrow_maps(sg_version *out, const sg_version *from, uint64_t relations,
            const int32_t *s, size_t n)
{
  for (int r = 0; r < SG_RELATIONS; r++) {
    if (from->map[r] && (relations >> r & 1)) {
      out->map[r] = sg_map_narrow(from->map[r], s, n);
      if (!out->map[r]) {
        return false;
      }
    }
  }
  return true;
}

const sg_version *
sg_version_narrow(const sg_version *version, uint64_t relations,
                  const int32_t *s, size_t n)
{
  sg_world *world = version->world;
  sg_version *out;

  pthread_mutex_lock(&world->lock);
  out = version_new(world, NULL);
  if (out && !narrow_maps(out, version, relations, s, n)) {
    version_free(out);
    out = NULL;
  }
  pthread_mutex_unlock(&world->lock);
  if (out) {
    sg_world_keep(world);
  }
  return out;
}

sg_version *
sg_world_own(sg_world *world)
{
  sg_version *old = world->current;
  sg_version *owned;

  if (atomic_load_explicit(&old->holders, memory_order_acquire) == 1) {
    return old;
  }
  if (!(owned = version_new(world, old))) {
    return NULL;
  }
  world->current = owned;
  release_version(old);
  return owned;
}

/* ---- stacks of versions ------------------------------------------------ */

static bool
stack_reserve(sg_stack *stack)
{
  return sg_list_grow(&stack->version, stack->count, &stack->room,
                      sizeof(*stack->version));
}

void
sg_stack_clear(sg_stack *stack)
{
  while (stack->count > 0) {
    release_version(stack->version[--stack->count]);
  }
}

/* Keeps the newest `most` versions. */
static void
stack_limit(sg_stack *stack, size_t most)
{
  size_t extra;

  if (stack->count <= most) {
    return;
  }
  extra = stack->count - most;
  for (size_t i = 0; i < extra; i++) {
    release_version(stack->version[i]);
  }
  memmove(stack->version, stack->version + extra, most * sizeof(sg_version *));
  stack->count = most;
}

/* ---- life -------------------------------------------------------------- */

sg_world *
sg_world_open(void)
{
  static atomic_uint_least64_t opened;
  sg_world *world = calloc(1, sizeof(*world));
  pthread_condattr_t attributes;

  if (!world) {
    return NULL;
  }
  atomic_init(&world->holders, 1);
  atomic_init(&world->keepers, 1);
  world->number = atomic_fetch_add(&opened, 1) + 1;
  pthread_mutex_init(&world->lock, NULL);
  pthread_condattr_init(&attributes);
  pthread_condattr_setclock(&attributes, CLOCK_MONOTONIC);
  pthread_cond_init(&world->turn, &attributes);
  pthread_condattr_destroy(&attributes);
  world->undo_limit = UNDO_LIMIT;
  for (int r = 0; r < SG_RELATIONS; r++) {
    sg_table_init(&world->table[r], (sg_relation)r);
    for (int q = 0; q < SG_RELATIONS; q++) {
      bool refers = sg_relation_refers((sg_relation)q, (sg_relation)r);
      world->referring[r] |= (uint64_t)refers << q;
    }
  }
  if (!(world->current = version_new(world, NULL))) {
    sg_world_drop(world);
    return NULL;
  }
  return world;
}

sg_world *
sg_world_hold(sg_world *world)
{
  atomic_fetch_add_explicit(&world->holders, 1, memory_order_relaxed);
  return world;
}

sg_world *
sg_world_keep(sg_world *world)
{
  atomic_fetch_add_explicit(&world->keepers, 1, memory_order_relaxed);
  return world;
}

static void
drop_note(sg_world *world, sg_note which)
{
  void *note = atomic_exchange(&world->note[which], NULL);

  if (note && world->drop_note[which]) {
    world->drop_note[which](note);
  }
}

/* Pieces keep the world: without this they and it would never end. */
void
sg_world_drop(sg_world *world)
{
  if (world && atomic_fetch_sub_explicit(&world->holders, 1,
                                         memory_order_acq_rel) == 1) {
    drop_note(world, SG_NOTE_PIECES);
    sg_world_let_go(world);
  }
}

static void
clear_tables(sg_world *world)
{
  for (int r = 0; r < SG_RELATIONS; r++) {
    sg_table_clear(&world->table[r]);
  }
}

static void
drop_notes(sg_world *world)
{
  for (int k = 0; k < SG_NOTES; k++) {
    drop_note(world, (sg_note)k);
  }
}

/* Undo is gone, and there is one version, which nobody else sees. */
static bool
is_alone(sg_world *world)
{
  return atomic_load_explicit(&world->keepers, memory_order_acquire) == 1 &&
         world->open.count == 0 && world->versions == world->current &&
         !world->current->next;
}

void
sg_world_spend(sg_world *world)
{
  if (atomic_load_explicit(&world->holders, memory_order_acquire) != 1) {
    return;
  }
  drop_notes(world);
  pthread_mutex_lock(&world->lock);
  if (world->open.count == 0) {
    sg_stack_clear(&world->undo);
    sg_stack_clear(&world->redo);
  }
  if (is_alone(world)) {
    version_empty(world->current);
    clear_tables(world);
    for (int r = 0; r < SG_RELATIONS; r++) {
      sg_table_init(&world->table[r], (sg_relation)r);
    }
  }
  pthread_mutex_unlock(&world->lock);
}

void
sg_world_let_go(sg_world *world)
{
  if (atomic_fetch_sub_explicit(&world->keepers, 1, memory_order_acq_rel) !=
      1) {
    return;
  }
  while (world->versions) {
    version_free(world->versions);
  }
  clear_tables(world);
  free(world->open.version);
  free(world->undo.version);
  free(world->redo.version);
  free(world->changes_at);
  drop_notes(world);
  pthread_cond_destroy(&world->turn);
  pthread_mutex_destroy(&world->lock);
  free(world);
}

uint64_t
sg_world_number(const sg_world *world)
{
  return world->number;
}

void
sg_world_undo_limit(sg_world *world, unsigned steps)
{
  sg_world_enter(world);
  world->undo_limit = steps;
  stack_limit(&world->undo, steps);
  stack_limit(&world->redo, steps);
  sg_world_leave(world);
}

/* ---- one writer at a time ---------------------------------------------- */

static bool
my_turn(const sg_world *world)
{
  return world->writer_depth == 0 ||
         pthread_equal(world->writer, pthread_self());
}

void
sg_world_enter(sg_world *world)
{
  pthread_mutex_lock(&world->lock);
  while (!my_turn(world)) {
    pthread_cond_wait(&world->turn, &world->lock);
  }
}

void
sg_world_leave(sg_world *world)
{
  pthread_mutex_unlock(&world->lock);
}

static void
wait_a_little(sg_world *world)
{
  struct timespec until;

  clock_gettime(CLOCK_MONOTONIC, &until);
  until.tv_nsec += 10 * 1000 * 1000;
  if (until.tv_nsec >= 1000 * 1000 * 1000) {
    until.tv_nsec -= 1000 * 1000 * 1000;
    until.tv_sec++;
  }
  pthread_cond_timedwait(&world->turn, &world->lock, &until);
}

static void
claim(sg_world *world)
{
  world->writer = pthread_self();
  world->writer_depth++;
}

static void
unclaim(sg_world *world)
{
  if (--world->writer_depth == 0) {
    pthread_cond_broadcast(&world->turn);
  }
}

bool
sg_world_claim(sg_world *world, const sg_cancel *cancel)
{
  pthread_mutex_lock(&world->lock);
  while (!my_turn(world)) {
    wait_a_little(world);
    pthread_mutex_unlock(&world->lock);
    if (sg_cancelled(cancel)) {
      return false;
    }
    pthread_mutex_lock(&world->lock);
  }
  claim(world);
  pthread_mutex_unlock(&world->lock);
  return true;
}

void
sg_world_release(sg_world *world)
{
  pthread_mutex_lock(&world->lock);
  unclaim(world);
  pthread_mutex_unlock(&world->lock);
}

/* ---- transactions ------------------------------------------------------ */

static bool
begin_reserve(sg_world *world)
{
  return stack_reserve(&world->open) && stack_reserve(&world->undo) &&
         sg_list_grow(&world->changes_at, world->open.count,
                      &world->changes_room, sizeof(*world->changes_at));
}

sg_status
sg_world_begin(sg_world *world)
{
  sg_status status = SG_NO_MEMORY;

  sg_world_enter(world);
  if (begin_reserve(world)) {
    world->changes_at[world->open.count] = world->changes;
    world->open.version[world->open.count++] = version_hold(world->current);
    claim(world);
    status = SG_OK;
  }
  sg_world_leave(world);
  return status;
}

size_t
sg_world_depth(sg_world *world)
{
  size_t depth;

  pthread_mutex_lock(&world->lock);
  depth = my_turn(world) ? world->open.count : 0;
  pthread_mutex_unlock(&world->lock);
  return depth;
}

/* Whether nothing was changed between two versions but a picture and its view,
 * and what completes polygons: the model is the same. */
static bool
only_drew(const sg_version *before, const sg_version *after)
{
  static const sg_relation made[] = {
      SG_VIEW,           SG_PROJECTION, SG_SCREEN, SG_CONTOUR,
      SG_SURFACE_FACING, SG_DRAWN,      SG_PLANE,  SG_T};
  bool is_made[SG_RELATIONS] = {false};

  for (size_t i = 0; i < sizeof made / sizeof *made; i++) {
    is_made[made[i]] = true;
  }
  for (int r = 0; r < SG_RELATIONS; r++) {
    bool is_there =
        sg_version_count(before, r) > 0 || sg_version_count(after, r) > 0;
    if (!is_made[r] && is_there && before->map[r] != after->map[r]) {
      return false;
    }
  }
  return true;
}

static sg_status
commit(sg_world *world, bool is_step)
{
  sg_status status = SG_NO_STEP;

  sg_world_enter(world);
  if (world->open.count > 0) {
    size_t depth = --world->open.count;
    sg_version *before = world->open.version[depth];
    bool changed = depth == 0 && world->changes != world->changes_at[0];
    bool model = changed && !only_drew(before, world->current);
    if (model && is_step) {
      world->undo.version[world->undo.count++] = before;
      stack_limit(&world->undo, world->undo_limit);
    } else {
      release_version(before);
    }
    if (model) {
      sg_stack_clear(&world->redo);
    }
    unclaim(world);
    status = SG_OK;
  }
  sg_world_leave(world);
  return status;
}

sg_status
sg_world_commit(sg_world *world)
{
  return commit(world, true);
}

sg_status
sg_world_commit_change(sg_world *world)
{
  return commit(world, false);
}

sg_status
sg_world_rollback(sg_world *world)
{
  sg_status status = SG_NO_STEP;

  sg_world_enter(world);
  if (world->open.count > 0) {
    size_t depth = --world->open.count;
    release_version(world->current);
    world->current = world->open.version[depth];
    world->changes = world->changes_at[depth];
    unclaim(world);
    status = SG_OK;
  }
  sg_world_leave(world);
  return status;
}

/* Swaps the current version for the newest of `from`, and puts it on `to`. */
static sg_status
step(sg_world *world, sg_stack *from, sg_stack *to)
{
  sg_status status = SG_NO_STEP;

  sg_world_enter(world);
  if (world->open.count == 0 && from->count > 0) {
    status = SG_NO_MEMORY;
    if (stack_reserve(to)) {
      to->version[to->count++] = world->current;
      world->current = from->version[--from->count];
      world->changes++;
      status = SG_OK;
    }
  }
  sg_world_leave(world);
  return status;
}

sg_status
sg_world_undo(sg_world *world)
{
  return step(world, &world->undo, &world->redo);
}

sg_status
sg_world_redo(sg_world *world)
{
  return step(world, &world->redo, &world->undo);
}

void *
sg_world_note(const sg_world *world, sg_note which)
{
  return atomic_load_explicit(&world->note[which], memory_order_acquire);
}

void
sg_world_set_note(sg_world *world, sg_note which, void *note,
                  void (*drop)(void *note))
{
  world->drop_note[which] = drop;
  atomic_store_explicit(&world->note[which], note, memory_order_release);
}

void *
sg_world_add_note(sg_world *world, sg_note which, size_t size,
                  void (*drop)(void *note))
{
  void *note = sg_world_note(world, which);

  if (note) {
    return note;
  }
  pthread_mutex_lock(&world->lock);
  note = sg_world_note(world, which); /* another thread may have been first */
  if (!note && (note = calloc(1, size))) {
    pthread_mutex_init(note, NULL);
    sg_world_set_note(world, which, note, drop);
  }
  pthread_mutex_unlock(&world->lock);
  return note;
}

uint64_t
sg_version_stamp(const sg_version *version, sg_relation relation, int32_t s)
{
  return sg_map_stamp(version->map[relation], s);
}

uint64_t
sg_segment_stamp(const sg_version *version, int32_t s)
{
  static const sg_relation rows[] = {SG_V, SG_E, SG_P};
  uint64_t last = 0;

  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    uint64_t stamp = sg_version_stamp(version, rows[i], s);
    last = stamp > last ? stamp : last;
  }
  return last;
}

uint64_t
sg_version_last_stamp(const sg_version *version, sg_relation relation)
{
  return sg_map_last_stamp(version->map[relation]);
}
