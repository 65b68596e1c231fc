/* tree4pl.c -- the trees of segments, kept with their world.
 *
 * Layer: glue. The doors are documented in rules/kernel/world.pl.
 */
#include "tree4pl.h"

#include "glue.h"

#include "engine/install.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

enum { CONTENTS = 4 }; /* of a segment that are remembered */

/* What is known of some contents of a segment. */
typedef struct self_entry {
  int32_t s;
  uint64_t stamp[2]; /* of v/5 and t/6 */
  sg_self_known known;
} self_entry;

/* What a world keeps: its note SG_NOTE_TREES. */
typedef struct tree_store {
  pthread_mutex_t lock;
  self_entry *self; /* by segment, then the oldest first */
  size_t selves, self_room;
  sg_kept_tree **kept; /* by segment, ascending */
  size_t n, room;
  uint64_t grown, found;
} tree_store;

/* ---- life ---- */

void
sg_kept_tree_drop(sg_kept_tree *kept)
{
  if (kept && atomic_fetch_sub(&kept->holders, 1) == 1) {
    sg_leaf_tree_close(kept->tree);
    free(atomic_load(&kept->operand));
    if (atomic_load(&kept->knots)) {
      sg_knots_clear(atomic_load(&kept->knots));
      free(atomic_load(&kept->knots));
    }
    free(kept);
  }
}

static void
close_store(void *note)
{
  tree_store *store = note;

  if (store) {
    for (size_t i = 0; i < store->n; i++) {
      sg_kept_tree_drop(store->kept[i]);
    }
    free(store->kept);
    free(store->self);
    pthread_mutex_destroy(&store->lock);
    free(store);
  }
}

/* The world's store, made at the first use; null: no memory. */
static tree_store *
store_of(sg_world *world)
{
  tree_store *store = sg_world_note(world, SG_NOTE_TREES);
  tree_store *fresh, *there;

  if (store || !(fresh = calloc(1, sizeof *fresh))) {
    return store;
  }
  pthread_mutex_init(&fresh->lock, NULL);
  there = sg_world_add_note(world, SG_NOTE_TREES, fresh, close_store);
  if (there != fresh) {
    close_store(fresh); /* another thread was first */
  }
  return there;
}

int
sg_leaf_views_ex(const sg_version *version, sg_leaf_views *out)
{
  memset(out, 0, sizeof *out);
  if (sg_version_view(version, SG_V, &out->v) &&
      sg_version_view(version, SG_E, &out->e) &&
      sg_version_view(version, SG_T, &out->t)) {
    return TRUE;
  }
  sg_leaf_views_clear(out);
  return sg_no_memory();
}

void
sg_leaf_views_clear(sg_leaf_views *views)
{
  sg_view_clear(&views->v);
  sg_view_clear(&views->e);
  sg_view_clear(&views->t);
}

/* ---- looking up ---- */

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

/* Where the tree of segment s is, or would be. Under the lock. */
static size_t
place_of(const tree_store *store, int32_t s)
{
  size_t low = 0, high = store->n;

  while (low < high) {
    size_t middle = (low + high) / 2;
    if (store->kept[middle]->s < s) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

static bool
is_at(const tree_store *store, size_t place, int32_t s)
{
  return place < store->n && store->kept[place]->s == s;
}

/* The tree of s as `version` shows it, held; null: it is not kept. */
static sg_kept_tree *
find_tree(tree_store *store, const sg_version *version, int32_t s)
{
  uint64_t stamp[SG_TREE_STAMPS];
  sg_kept_tree *found = NULL;

  stamps_of(version, s, stamp);
  pthread_mutex_lock(&store->lock);
  size_t place = place_of(store, s);

  if (is_at(store, place, s) && is_current(store->kept[place], stamp)) {
    found = store->kept[place];
    atomic_fetch_add(&found->holders, 1);
    store->found++;
  }
  pthread_mutex_unlock(&store->lock);
  return found;
}

bool
sg_kept_box(sg_world *world, const sg_version *version, int32_t s, sg_box *out)
{
  tree_store *store = sg_world_note(world, SG_NOTE_TREES);
  bool found = false;

  if (!store) {
    return false;
  }
  pthread_mutex_lock(&store->lock);
  size_t place = place_of(store, s);

  if (is_at(store, place, s) &&
      store->kept[place]->stamp[0] == sg_version_stamp(version, SG_V, s)) {
    *out = store->kept[place]->tree->box;
    found = true;
  }
  pthread_mutex_unlock(&store->lock);
  return found;
}

/* ---- keeping ---- */

/* Puts a tree in the place of the one that was there. Without memory it is
 * not kept, and grown again the next time. */
static void
keep_tree(tree_store *store, sg_kept_tree *kept)
{
  pthread_mutex_lock(&store->lock);
  size_t place = place_of(store, kept->s);
  bool there = is_at(store, place, kept->s);

  if (!there && store->n == store->room) {
    size_t room = store->room ? 2 * store->room : 8;
    sg_kept_tree **more = realloc(store->kept, room * sizeof *more);

    if (!more) {
      pthread_mutex_unlock(&store->lock);
      return;
    }
    store->kept = more;
    store->room = room;
  }
  if (there) {
    sg_kept_tree_drop(store->kept[place]);
  } else {
    memmove(store->kept + place + 1, store->kept + place,
            (store->n - place) * sizeof(sg_kept_tree *));
    store->n++;
  }
  store->kept[place] = kept;
  store->grown++;
  atomic_fetch_add(&kept->holders, 1);
  pthread_mutex_unlock(&store->lock);
}

/* Trees of segments that `version` does not have any more go. */
static void
forget_gone(tree_store *store, const sg_version *version)
{
  size_t n = 0;

  pthread_mutex_lock(&store->lock);
  for (size_t i = 0; i < store->n; i++) {
    sg_value key[SG_MAX_COLUMNS] = {[0].i = store->kept[i]->s};

    if (sg_version_find(version, SG_SEGMENT, key) == SG_NO_ROW) {
      sg_kept_tree_drop(store->kept[i]);
    } else {
      store->kept[n++] = store->kept[i];
    }
  }
  store->n = n;
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
static int
grow_missing_ex(tree_store *store, const sg_version *version,
                const sg_leaf_views *views, const int32_t *s, size_t n,
                sg_crew *crew, sg_kept_tree **out)
{
  int32_t *missing = malloc((n + 1) * sizeof *missing);
  sg_leaf_tree **tree = malloc((n + 1) * sizeof(sg_leaf_tree *));
  size_t m = 0;
  int good = missing && tree;

  for (size_t i = 0; i < n && good; i++) {
    if (!out[i]) {
      missing[m++] = s[i];
    }
  }
  good = good && (m == 0 || sg_leaf_trees_grow(views, missing, m, crew,
                                               &sg_prolog_poll, tree));
  for (size_t i = 0, k = 0; i < n && good; i++) {
    if (!out[i]) {
      out[i] = wrap_tree(version, tree[k++]);
      if (out[i]) {
        keep_tree(store, out[i]);
      }
    }
  }
  for (size_t i = 0; i < n && good; i++) {
    good = out[i] != NULL;
  }
  free(missing);
  free(tree);
  return good || (PL_exception(0) ? FALSE : sg_no_memory());
}

int
sg_trees_hold_ex(sg_world *world, const sg_version *version,
                 const sg_leaf_views *views, const int32_t *s, size_t n,
                 sg_crew *crew, sg_kept_tree **out)
{
  tree_store *store = store_of(world);

  if (!store) {
    return sg_no_memory();
  }
  for (size_t i = 0; i < n; i++) {
    out[i] = find_tree(store, version, s[i]);
  }
  forget_gone(store, version);
  if (grow_missing_ex(store, version, views, s, n, crew, out)) {
    return TRUE;
  }
  for (size_t i = 0; i < n; i++) {
    sg_kept_tree_drop(out[i]);
    out[i] = NULL;
  }
  return FALSE;
}

/* ---- whether segments go through themselves ---- */

/* Where the entries of segment s begin, or would. Under the lock. */
static size_t
selves_of(const tree_store *store, int32_t s)
{
  size_t low = 0, high = store->selves;

  while (low < high) {
    size_t middle = (low + high) / 2;
    if (store->self[middle].s < s) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

static const self_entry *
find_self(const tree_store *store, const sg_kept_tree *kept)
{
  for (size_t i = selves_of(store, kept->s);
       i < store->selves && store->self[i].s == kept->s; i++) {
    const self_entry *entry = &store->self[i];

    if (entry->stamp[0] == kept->stamp[0] &&
        entry->stamp[1] == kept->stamp[1]) {
      return entry;
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
    const self_entry *entry = find_self(store, kept);

    known = entry ? entry->known : known;
    pthread_mutex_unlock(&store->lock);
  }
  return known;
}

/* Makes room for one more entry of s, its newest; SIZE_MAX: no memory. */
static size_t
new_self(tree_store *store, int32_t s)
{
  size_t first = selves_of(store, s), end = first;

  while (end < store->selves && store->self[end].s == s) {
    end++;
  }
  if (end - first == CONTENTS) { /* the oldest goes */
    memmove(store->self + first, store->self + first + 1,
            (CONTENTS - 1) * sizeof *store->self);
    return end - 1;
  }
  if (store->selves == store->self_room) {
    size_t room = 2 * store->self_room + 16;
    self_entry *more = realloc(store->self, room * sizeof *more);

    if (!more) {
      return SIZE_MAX;
    }
    store->self = more;
    store->self_room = room;
  }
  memmove(store->self + end + 1, store->self + end,
          (store->selves - end) * sizeof *store->self);
  store->selves++;
  return end;
}

void
sg_self_keep(sg_world *world, const sg_kept_tree *kept, sg_self_known known)
{
  tree_store *store = store_of(world);

  if (!store) {
    return;
  }
  pthread_mutex_lock(&store->lock);
  if (!find_self(store, kept)) {
    size_t place = new_self(store, kept->s);

    if (place != SIZE_MAX) {
      store->self[place] =
          (self_entry){kept->s, {kept->stamp[0], kept->stamp[1]}, known};
    }
  }
  pthread_mutex_unlock(&store->lock);
}

/* ---- statistics ---- */

/* '$tree_statistics'(-Trees, -Leaves, -Bytes, -Grown, -Found) is det. */
static foreign_t
tree_statistics(term_t args, int count, void *control)
{
  sg_world *world = sg_current_world_ex();
  tree_store *store = world ? store_of(world) : NULL;
  size_t leaves = 0, bytes = 0;

  (void)count;
  (void)control;
  if (!store) {
    return world ? sg_no_memory() : FALSE;
  }
  pthread_mutex_lock(&store->lock);
  for (size_t i = 0; i < store->n; i++) {
    leaves += store->kept[i]->tree->boxes->n;
    bytes += sizeof *store->kept[i] + sg_leaf_tree_bytes(store->kept[i]->tree);
  }
  size_t n = store->n;
  uint64_t grown = store->grown, found = store->found;

  pthread_mutex_unlock(&store->lock);
  return PL_unify_uint64(args, n) && PL_unify_uint64(args + 1, leaves) &&
         PL_unify_uint64(args + 2, bytes) && PL_unify_uint64(args + 3, grown) &&
         PL_unify_uint64(args + 4, found);
}

static const PL_extension predicates[] = {
    {"$tree_statistics", 5, tree_statistics, PL_FA_VARARGS},
    {NULL, 0, NULL, 0},
};

void
sg_install_tree(void)
{
  PL_register_extensions_in_module("sg_kernel_world", predicates);
}
