#include "census_kept_rows.h"

#include "engine/search.h"
#include "engine/store.h"
#include "sort.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

/* What a world keeps: its note SG_NOTE_DEFECTS. */
typedef struct defect_store {
  pthread_mutex_t lock;
  sg_kept_defects *kept[SG_DEFECTS_SORTS]; /* null: none */
} defect_store;

void
sg_kept_defects_drop(sg_kept_defects *kept)
{
  if (kept && atomic_fetch_sub(&kept->holders, 1) == 1) {
    if (kept->clear) {
      kept->clear(kept->more);
    }
    free(kept->found);
    free(kept->order);
    free(kept);
  }
}

static void
close_store(void *note)
{
  defect_store *store = note;

  for (int i = 0; i < SG_DEFECTS_SORTS; i++) {
    sg_kept_defects_drop(store->kept[i]);
  }
  pthread_mutex_destroy(&store->lock);
  free(store);
}

static void
stamps_of(const sg_version *version, uint64_t out[SG_DEFECT_STAMPS])
{
  static const sg_relation of[SG_DEFECT_STAMPS] = {
      SG_SEGMENT, SG_V, SG_E, SG_P, SG_T, SG_PLANE, SG_ORIGIN};

  for (int k = 0; k < SG_DEFECT_STAMPS; k++) {
    out[k] = sg_version_last_stamp(version, of[k]);
  }
}

/* ---- the order ---- */

static int
compare(int64_t a, int64_t b)
{
  return (a > b) - (a < b);
}

/* A defect with its place, to be sorted. */
typedef struct placed {
  sg_found_defect defect;
  uint32_t place;
} placed;

SG_ORDER(by_key, placed,
         SG_BY(defect.kind) SG_BY(defect.s) SG_BY(defect.a) SG_BY(place));

/* found[] and order[]. */
static bool
file_found(sg_call *call, const sg_found_defect_list *found,
           sg_kept_defects *kept)
{
  size_t n = found->n;
  placed *all = sg_call_alloc(call, (n + 1) * sizeof *all);

  kept->found = malloc((n + 1) * sizeof *kept->found);
  kept->order = malloc((n + 1) * sizeof *kept->order);
  if (!all || !kept->found || !kept->order) {
    return sg_call_no_memory(call);
  }
  kept->n = n;
  for (size_t i = 0; i < n; i++) {
    kept->found[i] = found->at[i];
    all[i] = (placed){found->at[i], (uint32_t)i};
  }
  if (sg_sort(all, n, sizeof *all, by_key, &call->cancel) != SG_SORTED) {
    return sg_call_ended(call);
  }
  for (size_t i = 0; i < n; i++) {
    kept->order[i] = all[i].place;
  }
  return true;
}

/* ---- keeping ---- */

static sg_kept_defects *
new_defects(sg_call *call, const uint64_t stamp[SG_DEFECT_STAMPS],
            sg_defect_maker *make)
{
  sg_kept_defects *kept = calloc(1, sizeof *kept);
  sg_found_defect_list found = {0};

  if (!kept) {
    sg_call_no_memory(call);
    return NULL;
  }
  atomic_init(&kept->holders, 1);
  memcpy(kept->stamp, stamp, sizeof kept->stamp);
  if (make(call, kept, &found) && file_found(call, &found, kept)) {
    return kept;
  }
  sg_kept_defects_drop(kept);
  return NULL;
}

static sg_kept_defects *
find_defects(defect_store *store, sg_defects_of by,
             const uint64_t stamp[SG_DEFECT_STAMPS])
{
  sg_kept_defects *found = NULL;

  pthread_mutex_lock(&store->lock);
  sg_kept_defects *kept = store->kept[by];

  if (kept && memcmp(kept->stamp, stamp, sizeof kept->stamp) == 0) {
    found = kept;
    atomic_fetch_add(&found->holders, 1);
  }
  pthread_mutex_unlock(&store->lock);
  return found;
}

static void
keep_defects(defect_store *store, sg_defects_of by, sg_kept_defects *kept)
{
  sg_kept_defects *before;

  atomic_fetch_add(&kept->holders, 1);
  pthread_mutex_lock(&store->lock);
  before = store->kept[by];
  store->kept[by] = kept;
  pthread_mutex_unlock(&store->lock);
  sg_kept_defects_drop(before);
}

sg_kept_defects *
sg_kept_defects_hold(sg_call *call, sg_defects_of by, sg_defect_maker *make)
{
  const sg_version *version = sg_call_version(call);
  defect_store *store =
      version ? sg_world_add_note(sg_call_world(call), SG_NOTE_DEFECTS,
                                  sizeof(defect_store), close_store)
              : NULL;
  uint64_t stamp[SG_DEFECT_STAMPS];
  sg_kept_defects *kept;

  if (!store) {
    if (version) {
      sg_call_no_memory(call);
    }
    return NULL;
  }
  stamps_of(version, stamp);
  kept = find_defects(store, by, stamp);
  if (!kept && (kept = new_defects(call, stamp, make))) {
    keep_defects(store, by, kept);
  }
  return kept;
}

/* ---- asking ---- */

/* The key that is given, in order, and how much of it. */
typedef struct key {
  int64_t of[3];
  int known;
} key;

static int
compare_key(const sg_found_defect *d, const key *k)
{
  const int64_t of[3] = {d->kind, d->s, d->a};
  int order = 0;

  for (int i = 0; order == 0 && i < k->known; i++) {
    order = compare(of[i], k->of[i]);
  }
  return order;
}

SG_ORDER(by_place, size_t, SG_BY_AT(0));

static bool
is_asked(const sg_found_defect *d, const int32_t *s, const int32_t *a)
{
  return (!s || *s == d->s) && (!a || *a == d->a);
}

/* Those with a key of which something is known. */
static bool
ask_order(sg_call *call, const sg_kept_defects *kept, const key *k,
          const int32_t *a, sg_count_list *places)
{
  size_t at;
  bool good = true;

  SG_SEARCH(at, 0, kept->n, compare_key(&kept->found[kept->order[at]], k) < 0);
  for (; good && at < kept->n; at++) {
    const sg_found_defect *d = &kept->found[kept->order[at]];

    if (compare_key(d, k) != 0) {
      break;
    }
    good = !is_asked(d, NULL, a) ||
           sg_count_list_add(call, places, kept->order[at]);
  }
  if (good && places->n > 1) {
    qsort(places->at, places->n, sizeof *places->at, by_place);
  }
  return good;
}

bool
sg_kept_defects_ask(sg_call *call, const sg_kept_defects *kept, const int *kind,
                    const int32_t *s, const int32_t *a, sg_count_list *places)
{
  key k = {{kind ? *kind : 0, s ? *s : 0, a ? *a : 0},
           !kind ? 0
           : !s  ? 1
           : !a  ? 2
                 : 3};
  bool good = true;

  *places = (sg_count_list){0};
  if (k.known > 0) {
    good = ask_order(call, kept, &k, a, places);
  } else {
    for (size_t i = 0; good && i < kept->n; i++) {
      good = !is_asked(&kept->found[i], s, a) ||
             sg_count_list_add(call, places, i);
    }
  }
  return good;
}
