/* scene_kept_rows.c -- the models of scenes, kept with their world: see
 * scene_rows.h.
 */
#include "scene_rows.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_KEPT = 2 }; /* all segments, and some that were chosen */

/* What a world keeps: its note SG_NOTE_SCENES. */
typedef struct model_store {
  pthread_mutex_t lock;
  sg_kept_model *kept[MOST_KEPT]; /* the newest first; null: none */
} model_store;

void
sg_kept_model_drop(sg_kept_model *kept)
{
  if (kept && atomic_fetch_sub(&kept->holders, 1) == 1) {
    sg_kept_smooth_drop(kept->smooth);
    sg_scene_model_close(kept->model);
    free(kept->chosen.these.at);
    free(kept);
  }
}

static void
close_store(void *note)
{
  model_store *store = note;

  for (int i = 0; i < MOST_KEPT; i++) {
    sg_kept_model_drop(store->kept[i]);
  }
  pthread_mutex_destroy(&store->lock);
  free(store);
}

/* The world's store; null: no memory. */
static model_store *
store_of(sg_world *world)
{
  return sg_world_add_note(world, SG_NOTE_SCENES, sizeof(model_store),
                           close_store);
}

static void
stamps_of(const sg_version *version, uint64_t out[SG_SCENE_STAMPS])
{
  static const sg_relation of[SG_SCENE_STAMPS] = {
      SG_SEGMENT, SG_V, SG_E, SG_P, SG_T, SG_LINE, SG_FROM_P, SG_ORIGIN};

  for (int k = 0; k < SG_SCENE_STAMPS; k++) {
    out[k] = sg_version_last_stamp(version, of[k]);
  }
}

static bool
same_chosen(const sg_chosen_segments *a, const sg_chosen_segments *b)
{
  return a->is == b->is && a->these.n == b->these.n &&
         (a->these.n == 0 ||
          memcmp(a->these.at, b->these.at, a->these.n * sizeof(int32_t)) == 0);
}

/* Its place; or of the one for the same segments, whose rows have changed; or
 * of the oldest. Under the lock. */
static int
place_in(const model_store *store, const sg_chosen_segments *chosen)
{
  int i = 0;

  while (i < MOST_KEPT - 1 && store->kept[i] &&
         !same_chosen(&store->kept[i]->chosen, chosen)) {
    i++;
  }
  return i;
}

/* The kept model at a place becomes the newest. Under the lock. */
static void
put_first(model_store *store, int place, sg_kept_model *kept)
{
  memmove(store->kept + 1, store->kept,
          (size_t)place * sizeof(sg_kept_model *));
  store->kept[0] = kept;
}

/* The model, held; null: it is not kept. */
static sg_kept_model *
find_model(model_store *store, const sg_chosen_segments *chosen,
           const uint64_t stamp[SG_SCENE_STAMPS])
{
  sg_kept_model *found = NULL;

  pthread_mutex_lock(&store->lock);
  int place = place_in(store, chosen);
  sg_kept_model *kept = store->kept[place];

  if (kept && same_chosen(&kept->chosen, chosen) &&
      memcmp(kept->stamp, stamp, sizeof kept->stamp) == 0) {
    found = kept;
    atomic_fetch_add(&found->holders, 1);
    put_first(store, place, kept);
  }
  pthread_mutex_unlock(&store->lock);
  return found;
}

static void
keep_model(model_store *store, sg_kept_model *kept)
{
  pthread_mutex_lock(&store->lock);
  int place = place_in(store, &kept->chosen);

  sg_kept_model_drop(store->kept[place]);
  put_first(store, place, kept);
  atomic_fetch_add(&kept->holders, 1);
  pthread_mutex_unlock(&store->lock);
}

/* A new model, held. */
static sg_kept_model *
new_model(sg_call *call, const sg_chosen_segments *chosen,
          const sg_known_segment_list *known,
          const uint64_t stamp[SG_SCENE_STAMPS])
{
  sg_scene_model *model = sg_scene_model_read(call, chosen, known);
  size_t n = chosen->these.n;
  sg_kept_model *kept = model ? calloc(1, sizeof *kept) : NULL;
  int32_t *s = model ? malloc((n + 1) * sizeof *s) : NULL;

  if (!kept || !s) {
    free(kept);
    free(s);
    if (model) {
      sg_scene_model_close(model);
      sg_call_no_memory(call);
    }
    return NULL;
  }
  for (size_t i = 0; i < n; i++) {
    s[i] = chosen->these.at[i];
  }
  atomic_init(&kept->holders, 1);
  kept->chosen = (sg_chosen_segments){chosen->is, {{s, n, n}}};
  kept->model = model;
  memcpy(kept->stamp, stamp, sizeof kept->stamp);
  return kept;
}

sg_kept_model *
sg_kept_model_hold(sg_call *call, const sg_chosen_segments *chosen,
                   const sg_known_model *known)
{
  const sg_version *version = sg_call_version(call);
  model_store *store = version ? store_of(sg_call_world(call)) : NULL;
  uint64_t stamp[SG_SCENE_STAMPS];
  sg_kept_model *kept;

  if (!store) {
    if (version) {
      sg_call_no_memory(call);
    }
    return NULL;
  }
  stamps_of(version, stamp);
  kept = find_model(store, chosen, stamp);
  if (!kept && known->is != SG_KNOWN_MODEL_KEPT) {
    kept = new_model(call, chosen, &known->segments, stamp);
    if (kept) {
      keep_model(store, kept);
    }
  }
  return kept;
}
