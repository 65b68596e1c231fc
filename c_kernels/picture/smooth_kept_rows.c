/* smooth_kept_rows.c -- the smooth sheets of the models of scenes, kept with
 * them: see scene_rows.h.
 */
#include "engine/search.h"
#include "scene_rows.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

/* Guards what models keep; held for an exchange only. */
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;

bool *
sg_segments_faceted(sg_call *call, const sg_int_list *of, const sg_dense *d)
{
  bool *faceted = sg_call_alloc(call, d->segments * sizeof *faceted);

  for (size_t s = 0; faceted && s < d->segments; s++) {
    faceted[s] = sg_find_id(of->at, of->n, d->segment[s]) != SIZE_MAX;
  }
  return faceted;
}

static bool
same_smoothness(const sg_smoothness *a, const sg_smoothness *b)
{
  return a->crease == b->crease && a->faceted.n == b->faceted.n &&
         (a->faceted.n == 0 ||
          memcmp(a->faceted.at, b->faceted.at,
                 a->faceted.n * sizeof *a->faceted.at) == 0);
}

static bool
copy_smoothness(const sg_smoothness *from, sg_smoothness *out)
{
  size_t n = from->faceted.n;

  *out = (sg_smoothness){.crease = from->crease,
                         .faceted.at = malloc((n + 1) * sizeof(int32_t)),
                         .faceted.n = n};
  for (size_t i = 0; out->faceted.at && i < n; i++) {
    out->faceted.at[i] = from->faceted.at[i];
  }
  return out->faceted.at != NULL;
}

void
sg_kept_smooth_drop(sg_kept_smooth *kept)
{
  if (kept && atomic_fetch_sub(&kept->holders, 1) == 1) {
    sg_smooth_clear(&kept->smooth);
    free(kept->as.faceted.at);
    free(kept->curved);
    free(kept->creases);
    free(kept);
  }
}

/* No sheet of a segment that is faceted counts as curved. */
static void
leave_out(sg_kept_smooth *kept, const sg_dense *d, const bool *faceted)
{
  for (size_t s = 0; s < d->segments; s++) {
    for (size_t t = d->triangle_begin[s];
         faceted[s] && t < d->triangle_begin[s + 1]; t++) {
      kept->smooth.curved[t] = kept->smooth.coarse[t] = false;
    }
  }
}

/* The surface or named face of each polygon, of none in segments that are
 * faceted. */
static int32_t *
surfaces_but(sg_call *call, const sg_known_surfaces *surfaces,
             const sg_dense *d, const bool *faceted)
{
  int32_t *of = sg_call_alloc(call, d->polygons * sizeof *of);

  for (size_t s = 0; of && s < d->segments; s++) {
    for (size_t p = d->polygon_begin[s]; p < d->polygon_begin[s + 1]; p++) {
      of[p] = faceted[s] ? SG_NOT_KNOWN : surfaces->of[p];
    }
  }
  return of;
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

/* The ends of the edges along which creases go on; memory of the call. */
static uint32_t (*edges_on(sg_call *call, const sg_scene_model *model,
                           const uint8_t *creases, size_t *n))[2]
{
  uint32_t(*ends)[2] = NULL;

  *n = 0;
  for (size_t k = 0; creases && k < model->lines; k++) {
    *n += creases[k] == SG_CREASE_ON;
  }
  if (*n == 0 || !(ends = sg_call_alloc(call, *n * sizeof *ends))) {
    return NULL;
  }
  for (size_t k = 0, i = 0; k < model->lines; k++) {
    if (creases[k] == SG_CREASE_ON) {
      ends[i][0] = model->line[k].a;
      ends[i++][1] = model->line[k].b;
    }
  }
  return ends;
}

/* Sheets with the surfaces of `of`. */
static bool
find_sheets(sg_call *call, sg_kept_smooth *kept, const sg_scene_model *model,
            int32_t *of)
{
  size_t on;
  uint32_t(*crease_on)[2] = edges_on(call, model, kept->creases, &on);
  sg_smooth_input in = {.dense = &model->dense,
                        .cut = (const uint32_t(*)[2])model->cut,
                        .cuts = model->cuts,
                        .crease_on = (const uint32_t(*)[2])crease_on,
                        .creases_on = on,
                        .surfaces = model->surfaces,
                        .crease = kept->as.crease};
  bool memory;

  if (on > 0 && !crease_on) {
    return false;
  }
  in.surfaces.of = of;
  return sg_smooth_init(&kept->smooth, &in, &call->cancel, &memory) ||
         sg_call_ended(call);
}

static bool
make_smooth(sg_call *call, sg_kept_smooth *kept, const sg_scene_model *model)
{
  const sg_dense *d = &model->dense;
  bool *faceted = sg_segments_faceted(call, &kept->as.faceted, d);
  int32_t *of = NULL;
  bool memory;

  if (!faceted ||
      (!sg_creases_find(model, faceted, kept->as.crease, &call->cancel,
                        &kept->creases, &memory) &&
       !sg_call_ended(call)) ||
      (model->surfaces.of &&
       !(of = surfaces_but(call, &model->surfaces, d, faceted))) ||
      !find_sheets(call, kept, model, of)) {
    return false;
  }
  leave_out(kept, d, faceted);
  return find_polygons(kept, d) || sg_call_no_memory(call);
}

static sg_kept_smooth *
new_smooth(sg_call *call, const sg_scene_model *model, const sg_smoothness *as)
{
  sg_kept_smooth *kept = calloc(1, sizeof *kept);

  if (!kept) {
    sg_call_no_memory(call);
    return NULL;
  }
  atomic_init(&kept->holders, 1);
  if ((copy_smoothness(as, &kept->as) || sg_call_no_memory(call)) &&
      make_smooth(call, kept, model)) {
    return kept;
  }
  sg_kept_smooth_drop(kept);
  return NULL;
}

/* What the model keeps, held, if it is what is asked for. */
static sg_kept_smooth *
find_smooth(sg_kept_model *model, const sg_smoothness *as)
{
  sg_kept_smooth *found = NULL;

  pthread_mutex_lock(&lock);
  if (model->smooth && same_smoothness(&model->smooth->as, as)) {
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
sg_kept_smooth_hold(sg_call *call, sg_kept_model *model,
                    const sg_smoothness *as)
{
  sg_kept_smooth *kept = find_smooth(model, as);

  if (!kept && (kept = new_smooth(call, model->model, as))) {
    keep_smooth(model, kept);
  }
  return kept;
}
