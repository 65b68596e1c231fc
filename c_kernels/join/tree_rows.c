/* tree_rows.c -- see tree_rows.h. */
#include "tree_rows.h"

#include "doors/world.h"
#include "engine/list.h"
#include "engine/search.h"

#include <malloc.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

enum {
  CONTENTS = 4, /* of a segment that are remembered */
  FEW = 64      /* segments */
};

/* What is known of some contents of a segment. */
typedef struct self_entry {
  uint64_t stamp[2]; /* of v/5 and t/6 */
  sg_self_known known;
} self_entry;

/* What is known of a segment. */
typedef struct entry {
  int32_t s;
  sg_kept_tree *kept; /* or null */
  size_t selves;
  self_entry self[CONTENTS]; /* the oldest first */
} entry;

/* What a world keeps: its note SG_NOTE_TREES. */
typedef struct tree_store {
  pthread_mutex_t lock;
  entry *of; /* by segment, ascending */
  size_t n, room;
  size_t stayed; /* when trees of segments that are gone were last looked for */
  size_t grown, found;
} tree_store;

/* ---- life ---- */

void
sg_kept_tree_drop(sg_kept_tree *kept)
{
  if (kept && atomic_fetch_sub(&kept->holders, 1) == 1) {
    sg_leaf_tree_close(kept->tree);
    free(atomic_load(&kept->operand));
    if (atomic_load(&kept->nonmanifold)) {
      sg_nonmanifold_clear(atomic_load(&kept->nonmanifold));
      free(atomic_load(&kept->nonmanifold));
    }
    free(kept);
  }
}

static void
close_store(void *note)
{
  tree_store *store = note;

  for (size_t i = 0; i < store->n; i++) {
    sg_kept_tree_drop(store->of[i].kept);
  }
  free(store->of);
  pthread_mutex_destroy(&store->lock);
  free(store);
}

/* The world's store; null: no memory. */
static tree_store *
store_of(sg_world *world)
{
  return sg_world_add_note(world, SG_NOTE_TREES, sizeof(tree_store),
                           close_store);
}

bool
sg_leaf_views_open(sg_call *call, const sg_version *version, sg_leaf_views *out)
{
  *out = (sg_leaf_views){0};
  return (sg_version_view(version, SG_V, &out->v) &&
          sg_version_view(version, SG_E, &out->e) &&
          sg_version_view(version, SG_T, &out->t)) ||
         sg_call_no_memory(call);
}

void
sg_leaf_views_clear(sg_leaf_views *views)
{
  sg_view_clear(&views->v);
  sg_view_clear(&views->e);
  sg_view_clear(&views->t);
}

/* ---- looking up: all under the lock -------------------------------------- */

/* Where the entry of segment s is, or would be. */
static size_t
place_of(const tree_store *store, int32_t s)
{
  return sg_first_id(store->of, store->n, sizeof *store->of, s);
}

/* Null: there is none. */
static entry *
find_entry(tree_store *store, int32_t s)
{
  size_t place = place_of(store, s);

  return place < store->n && store->of[place].s == s ? &store->of[place] : NULL;
}

/* The same; a new one if there is none. Null: no memory. */
static entry *
make_entry(tree_store *store, int32_t s)
{
  size_t place = place_of(store, s);

  if (place < store->n && store->of[place].s == s) {
    return &store->of[place];
  }
  if (!sg_list_grow(&store->of, store->n, &store->room, sizeof *store->of)) {
    return NULL;
  }
  memmove(store->of + place + 1, store->of + place,
          (store->n++ - place) * sizeof *store->of);
  store->of[place] = (entry){.s = s};
  return &store->of[place];
}

/* ---- trees --------------------------------------------------------------- */

static void
stamps_of(const sg_version *version, int32_t s, uint64_t out[SG_TREE_STAMPS])
{
  static const sg_relation of[SG_TREE_STAMPS] = {SG_V, SG_T, SG_E};

  for (int k = 0; k < SG_TREE_STAMPS; k++) {
    out[k] = sg_version_stamp(version, of[k], s);
  }
}

/* The edges of a segment that has triangles are not in its tree. */
static bool
is_current(const sg_kept_tree *kept, const uint64_t stamp[SG_TREE_STAMPS])
{
  return kept->stamp[0] == stamp[0] && kept->stamp[1] == stamp[1] &&
         (!kept->tree->curve || kept->stamp[2] == stamp[2]);
}

/* The tree of s as `version` shows it, held; null: it is not kept. */
static sg_kept_tree *
find_tree(tree_store *store, const sg_version *version, int32_t s)
{
  uint64_t stamp[SG_TREE_STAMPS];
  sg_kept_tree *found = NULL;

  stamps_of(version, s, stamp);
  pthread_mutex_lock(&store->lock);
  const entry *e = find_entry(store, s);

  if (e && e->kept && is_current(e->kept, stamp)) {
    found = e->kept;
    atomic_fetch_add(&found->holders, 1);
    store->found++;
  }
  pthread_mutex_unlock(&store->lock);
  return found;
}

bool
sg_kept_box(const sg_version *version, int32_t s, sg_box *out)
{
  tree_store *store = sg_world_note(sg_version_world(version), SG_NOTE_TREES);

  if (!store) {
    return false;
  }
  pthread_mutex_lock(&store->lock);
  const entry *e = find_entry(store, s);
  bool found =
      e && e->kept && e->kept->stamp[0] == sg_version_stamp(version, SG_V, s);

  if (found) {
    *out = e->kept->tree->box;
  }
  pthread_mutex_unlock(&store->lock);
  return found;
}

/* Puts a tree in the place of the one that was there. Without memory it is
 * not kept, and grown again the next time. */
static void
keep_tree(tree_store *store, sg_kept_tree *kept)
{
  pthread_mutex_lock(&store->lock);
  entry *e = make_entry(store, kept->s);

  if (e) {
    sg_kept_tree_drop(e->kept);
    e->kept = kept;
    store->grown++;
    atomic_fetch_add(&kept->holders, 1);
  }
  pthread_mutex_unlock(&store->lock);
}

/* Trees of segments that `version` does not have any more go: at once where
 * there are few, else when there may be as many of these as of others. */
static void
forget_gone(tree_store *store, const sg_version *version)
{
  size_t n = 0;

  pthread_mutex_lock(&store->lock);
  if (store->n > FEW && store->n < 2 * store->stayed) {
    pthread_mutex_unlock(&store->lock);
    return;
  }
  for (size_t i = 0; i < store->n; i++) {
    entry *e = &store->of[i];
    sg_value key[SG_MAX_COLUMNS] = {[0].i = e->s};

    if (e->kept && sg_version_find(version, SG_SEGMENT, key) == SG_NO_ROW) {
      sg_kept_tree_drop(e->kept);
      e->kept = NULL;
    }
    if (e->kept || e->selves > 0) {
      store->of[n++] = *e;
    }
  }
  store->n = store->stayed = n;
  pthread_mutex_unlock(&store->lock);
}

/* Wraps a new tree, held once by the caller; null: no memory, it is closed. */
static sg_kept_tree *
wrap_tree(const sg_version *version, sg_leaf_tree *tree)
{
  sg_kept_tree *kept = calloc(1, sizeof *kept);

  if (!kept) {
    sg_leaf_tree_close(tree);
    return NULL;
  }
  atomic_init(&kept->holders, 1);
  kept->s = tree->s;
  kept->tree = tree;
  stamps_of(version, tree->s, kept->stamp);
  return kept;
}

/* Grows the trees that out[] lacks. */
static bool
grow_missing(sg_call *call, tree_store *store, const sg_version *version,
             const sg_leaf_views *views, const int32_t *s, size_t n,
             sg_kept_tree **out)
{
  int32_t *missing = sg_call_alloc(call, n * sizeof *missing);
  sg_leaf_tree **tree = sg_call_alloc(call, n * sizeof(sg_leaf_tree *));
  size_t m = 0;
  bool good = true;

  if (!missing || !tree) {
    return false;
  }
  for (size_t i = 0; i < n; i++) {
    if (!out[i]) {
      missing[m++] = s[i];
    }
  }
  sg_pool *pool = m > 0 ? sg_call_pool(call) : NULL;

  if (m > 0 && (!pool || !sg_leaf_trees_grow(views, missing, m, pool,
                                             &call->cancel, tree))) {
    return sg_call_ended(call);
  }
  for (size_t i = 0, k = 0; i < n; i++) {
    if (!out[i]) {
      out[i] = wrap_tree(version, tree[k++]);
      if (out[i]) {
        keep_tree(store, out[i]);
      }
      good = good && out[i];
    }
  }
  return good || sg_call_no_memory(call);
}

bool
sg_trees_hold(sg_call *call, const sg_version *version,
              const sg_leaf_views *views, const int32_t *s, size_t n,
              sg_kept_tree **out)
{
  tree_store *store = store_of(sg_version_world(version));

  for (size_t i = 0; i < n; i++) {
    out[i] = store ? find_tree(store, version, s[i]) : NULL;
  }
  if (!store) {
    return sg_call_no_memory(call);
  }
  forget_gone(store, version);
  if (grow_missing(call, store, version, views, s, n, out)) {
    return true;
  }
  for (size_t i = 0; i < n; i++) {
    sg_kept_tree_drop(out[i]);
    out[i] = NULL;
  }
  return false;
}

/* ---- whether segments go through themselves ------------------------------ */

static const self_entry *
find_self(tree_store *store, const sg_kept_tree *kept)
{
  const entry *e = find_entry(store, kept->s);

  for (size_t i = 0; e && i < e->selves; i++) {
    if (e->self[i].stamp[0] == kept->stamp[0] &&
        e->self[i].stamp[1] == kept->stamp[1]) {
      return &e->self[i];
    }
  }
  return NULL;
}

sg_self_known
sg_self_known_of(sg_world *world, const sg_kept_tree *kept)
{
  tree_store *store = store_of(world);
  sg_self_known known = SG_SELF_NOT_ASKED;

  if (store) {
    pthread_mutex_lock(&store->lock);
    const self_entry *self = find_self(store, kept);

    known = self ? self->known : known;
    pthread_mutex_unlock(&store->lock);
  }
  return known;
}

void
sg_self_keep(sg_world *world, const sg_kept_tree *kept, sg_self_known known)
{
  tree_store *store = store_of(world);

  if (!store) {
    return;
  }
  pthread_mutex_lock(&store->lock);
  entry *e = find_self(store, kept) ? NULL : make_entry(store, kept->s);

  if (e && e->selves == CONTENTS) { /* the oldest goes */
    memmove(e->self, e->self + 1, --e->selves * sizeof *e->self);
  }
  if (e) {
    e->self[e->selves++] =
        (self_entry){{kept->stamp[0], kept->stamp[1]}, known};
  }
  pthread_mutex_unlock(&store->lock);
}

/* ---- room ---------------------------------------------------------------- */

/* What was asked of contents stays known. What is free between other things
 * goes back to the system too. */
bool
sg_door_trees_dropped(sg_call *call)
{
  sg_world *world = sg_call_world(call);
  tree_store *store = world ? store_of(world) : NULL;

  if (!store) {
    return world ? sg_call_no_memory(call) : false;
  }
  pthread_mutex_lock(&store->lock);
  for (size_t i = 0; i < store->n; i++) {
    sg_kept_tree_drop(store->of[i].kept);
    store->of[i].kept = NULL;
  }
  pthread_mutex_unlock(&store->lock);
  malloc_trim(0);
  return true;
}

/* ---- statistics ---------------------------------------------------------- */

bool
sg_door_tree_statistics(sg_call *call, sg_tree_counts *out)
{
  sg_world *world = sg_call_world(call);
  tree_store *store = world ? store_of(world) : NULL;

  if (!store) {
    return world ? sg_call_no_memory(call) : false;
  }
  pthread_mutex_lock(&store->lock);
  *out = (sg_tree_counts){.grown = store->grown, .found = store->found};
  for (size_t i = 0; i < store->n; i++) {
    const sg_kept_tree *kept = store->of[i].kept;

    if (kept) {
      out->trees++;
      out->leaves += kept->tree->boxes->n;
      out->bytes += sizeof *kept + sg_leaf_tree_bytes(kept->tree);
    }
  }
  pthread_mutex_unlock(&store->lock);
  return true;
}
