/* smooth_kept4pl.c -- the smooth sheets of the models of scenes, kept with
 * them: see scene4pl.h.
 */
#include "scene4pl.h"

#include "glue.h"

#include <pthread.h>
#include <stdlib.h>

/* Guards what models keep; held for an exchange only. */
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;

void
sg_kept_smooth_drop(sg_kept_smooth *kept)
{
  if (kept && atomic_fetch_sub(&kept->holders, 1) == 1) {
    sg_smooth_clear(&kept->smooth);
    free(kept->curved);
    free(kept);
  }
}

/* Which polygons lie in curved sheets. */
static bool
find_polygons(sg_kept_smooth *kept, const sg_dense *d)
{
  kept->curved = calloc(d->polygons + 1, sizeof *kept->curved);
  for (size_t t = 0; kept->curved && t < d->triangles; t++) {
    kept->curved[d->polygon_of[t]] |= kept->smooth.curved[t];
  }
  return kept->curved != NULL;
}

/* The ends of the pieces of penetration lines, to be freed. Null: no memory. */
static uint32_t (*cuts_of(const sg_scene_model *model, size_t *n))[2]
{
  uint32_t(*cut)[2] = malloc((model->lines + 1) * sizeof *cut);

  *n = 0;
  for (size_t k = 0; cut && k < model->lines; k++) {
    if (model->line[k].look.cut) {
      cut[*n][0] = model->line[k].a;
      cut[(*n)++][1] = model->line[k].b;
    }
  }
  return cut;
}

/* False: stopped, or no memory. */
static bool
make_smooth(sg_kept_smooth *kept, const sg_scene_model *model, bool *memory)
{
  sg_smooth_input in = {.dense = &model->dense, .crease = kept->crease};
  uint32_t(*cut)[2] = cuts_of(model, &in.cuts);
  bool done;

  in.cut = (const uint32_t(*)[2])cut;
  *memory = cut != NULL;
  done = cut && sg_smooth_init(&kept->smooth, &in, &sg_prolog_poll, memory);
  free(cut);
  return done && (*memory = find_polygons(kept, &model->dense));
}

/* Null: stopped, or no memory. */
static sg_kept_smooth *
new_smooth(const sg_scene_model *model, double crease, bool *memory)
{
  sg_kept_smooth *kept = calloc(1, sizeof *kept);

  *memory = kept != NULL;
  if (kept) {
    atomic_init(&kept->holders, 1);
    kept->crease = crease;
    if (make_smooth(kept, model, memory)) {
      return kept;
    }
    sg_kept_smooth_drop(kept);
  }
  return NULL;
}

/* What the model keeps, held, if it is for this crease. */
static sg_kept_smooth *
find_smooth(sg_kept_model *model, double crease)
{
  sg_kept_smooth *found = NULL;

  pthread_mutex_lock(&lock);
  if (model->smooth && model->smooth->crease == crease) {
    found = model->smooth;
    atomic_fetch_add(&found->holders, 1);
  }
  pthread_mutex_unlock(&lock);
  return found;
}

static void
keep_smooth(sg_kept_model *model, sg_kept_smooth *kept)
{
  sg_kept_smooth *before;

  atomic_fetch_add(&kept->holders, 1);
  pthread_mutex_lock(&lock);
  before = model->smooth;
  model->smooth = kept;
  pthread_mutex_unlock(&lock);
  sg_kept_smooth_drop(before);
}

sg_kept_smooth *
sg_kept_smooth_hold_ex(sg_kept_model *model, double crease)
{
  sg_kept_smooth *kept = find_smooth(model, crease);
  bool memory = true;

  if (!kept) {
    kept = new_smooth(model->model, crease, &memory);
    if (kept) {
      keep_smooth(model, kept);
    } else if (!memory) {
      sg_no_memory();
    }
  }
  return kept;
}
