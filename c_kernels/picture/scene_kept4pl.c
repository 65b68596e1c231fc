/* scene_kept4pl.c -- the models of scenes, kept with their world: see
 * scene4pl.h.
 */
#include "scene4pl.h"

#include "glue.h"

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
    free(kept->chosen.s);
    free(kept);
  }
}

static void
close_store(void *note)
{
  model_store *store = note;

  if (store) {
    for (int i = 0; i < MOST_KEPT; i++) {
      sg_kept_model_drop(store->kept[i]);
    }
    pthread_mutex_destroy(&store->lock);
    free(store);
  }
}

/* The world's store, made at the first use; null: no memory. */
static model_store *
store_of(sg_world *world)
{
  model_store *store = sg_world_note(world, SG_NOTE_SCENES);
  model_store *fresh, *there;

  if (store || !(fresh = calloc(1, sizeof *fresh))) {
    return store;
  }
  pthread_mutex_init(&fresh->lock, NULL);
  there = sg_world_add_note(world, SG_NOTE_SCENES, fresh, close_store);
  if (there != fresh) {
    close_store(fresh); /* another thread was first */
  }
  return there;
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
same_chosen(const sg_chosen *a, const sg_chosen *b)
{
  return a->all == b->all && a->n == b->n &&
         (a->n == 0 || memcmp(a->s, b->s, a->n * sizeof *a->s) == 0);
}

/* Its place; or of the one for the same segments, whose rows have changed; or
 * of the oldest. Under the lock. */
static int
place_in(const model_store *store, const sg_chosen *chosen)
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
find_model(model_store *store, const sg_chosen *chosen,
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

/* A new model, held; null: stopped, or no memory. */
static sg_kept_model *
new_model(const sg_version *version, const sg_chosen *chosen,
          const sg_known *known, const uint64_t stamp[SG_SCENE_STAMPS],
          bool *memory)
{
  sg_kept_model *kept = calloc(1, sizeof *kept);
  int32_t *s = malloc((chosen->n + 1) * sizeof *s);

  *memory = kept && s;
  if (*memory) {
    kept->model =
        sg_scene_model_read(version, chosen, known, &sg_prolog_poll, memory);
  }
  if (!kept || !kept->model) {
    free(kept);
    free(s);
    return NULL;
  }
  for (size_t i = 0; i < chosen->n; i++) {
    s[i] = chosen->s[i];
  }
  atomic_init(&kept->holders, 1);
  kept->chosen = (sg_chosen){chosen->all, s, chosen->n};
  memcpy(kept->stamp, stamp, sizeof kept->stamp);
  return kept;
}

sg_kept_model *
sg_kept_model_hold_ex(sg_world *world, const sg_version *version,
                      const sg_chosen *chosen, const sg_known *known)
{
  model_store *store = store_of(world);
  uint64_t stamp[SG_SCENE_STAMPS];
  sg_kept_model *kept;
  bool memory = store != NULL;

  stamps_of(version, stamp);
  kept = store ? find_model(store, chosen, stamp) : NULL;
  if (store && !kept && !known->kept) {
    kept = new_model(version, chosen, known, stamp, &memory);
    if (kept) {
      keep_model(store, kept);
    }
  }
  if (!memory) {
    sg_no_memory();
  }
  return kept;
}
