/* smooth_kept4pl.c -- the smooth sheets of the models of scenes, kept with
 * them: see scene4pl.h.
 */
#include "scene4pl.h"

#include "glue.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

/* Guards what models keep; held for an exchange only. */
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;

/* --------------------------------------------------------------- argument */

int
sg_get_smoothness_ex(term_t t, sg_smoothness *out)
{
  term_t a = PL_new_term_refs(2);
  static functor_t smooth2;

  *out = (sg_smoothness){0};
  if (!smooth2) {
    smooth2 = PL_new_functor(PL_new_atom("smooth"), 2);
  }
  if (!PL_is_functor(t, smooth2)) {
    return PL_type_error("smooth", t);
  }
  return PL_get_arg(1, t, a) && PL_get_arg(2, t, a + 1) &&
         sg_get_finite_ex(a, &out->crease) &&
         sg_get_id_set_ex(a + 1, &out->faceted.s, &out->faceted.n);
}

void
sg_smoothness_clear(sg_smoothness *smoothness)
{
  free(smoothness->faceted.s);
  *smoothness = (sg_smoothness){0};
}

static int
compare_ids(const void *a, const void *b)
{
  int32_t x = *(const int32_t *)a, y = *(const int32_t *)b;

  return (x > y) - (x < y);
}

bool *
sg_smoothness_faceted(const sg_smoothness *smoothness, const sg_dense *d)
{
  const sg_chosen *all = &smoothness->faceted;
  bool *faceted = calloc(d->segments + 1, sizeof *faceted);

  for (size_t s = 0; faceted && all->n > 0 && s < d->segments; s++) {
    faceted[s] = bsearch(&d->segment[s], all->s, all->n, sizeof *all->s,
                         compare_ids) != NULL;
  }
  return faceted;
}

static bool
same_smoothness(const sg_smoothness *a, const sg_smoothness *b)
{
  return a->crease == b->crease && a->faceted.n == b->faceted.n &&
         (a->faceted.n == 0 ||
          memcmp(a->faceted.s, b->faceted.s,
                 a->faceted.n * sizeof *a->faceted.s) == 0);
}

static bool
copy_smoothness(const sg_smoothness *from, sg_smoothness *out)
{
  size_t n = from->faceted.n;

  *out = (sg_smoothness){.crease = from->crease,
                         .faceted.s = malloc((n + 1) * sizeof(int32_t)),
                         .faceted.n = n};
  for (size_t i = 0; out->faceted.s && i < n; i++) {
    out->faceted.s[i] = from->faceted.s[i];
  }
  return out->faceted.s != NULL;
}

/* ------------------------------------------------------------------- kept */

void
sg_kept_smooth_drop(sg_kept_smooth *kept)
{
  if (kept && atomic_fetch_sub(&kept->holders, 1) == 1) {
    sg_smooth_clear(&kept->smooth);
    sg_smoothness_clear(&kept->as);
    free(kept->curved);
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
 * faceted. Null: no memory. */
static int32_t *
surfaces_but(const sg_known_surfaces *surfaces, const sg_dense *d,
             const bool *faceted)
{
  int32_t *of = malloc((d->polygons + 1) * sizeof *of);

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

/* Sheets with the surfaces of `of`. False: stopped, or no memory. */
static bool
find_sheets(sg_kept_smooth *kept, const sg_scene_model *model, int32_t *of,
            bool *memory)
{
  sg_smooth_input in = {.dense = &model->dense,
                        .cut = (const uint32_t(*)[2])model->cut,
                        .cuts = model->cuts,
                        .surfaces = model->surfaces,
                        .crease = kept->as.crease};

  in.surfaces.of = of;
  return sg_smooth_init(&kept->smooth, &in, &sg_prolog_poll, memory);
}

/* False: stopped, or no memory. */
static bool
make_smooth(sg_kept_smooth *kept, const sg_scene_model *model, bool *memory)
{
  const sg_dense *d = &model->dense;
  bool *faceted = sg_smoothness_faceted(&kept->as, d);
  int32_t *of = NULL;
  bool done = faceted != NULL;

  if (done && model->surfaces.of) {
    of = surfaces_but(&model->surfaces, d, faceted);
    done = of != NULL;
  }
  *memory = done;
  done = done && find_sheets(kept, model, of, memory);
  if (done) {
    leave_out(kept, d, faceted);
    done = *memory = find_polygons(kept, d);
  }
  free(faceted);
  free(of);
  return done;
}

/* Null: stopped, or no memory. */
static sg_kept_smooth *
new_smooth(const sg_scene_model *model, const sg_smoothness *as, bool *memory)
{
  sg_kept_smooth *kept = calloc(1, sizeof *kept);

  *memory = kept != NULL;
  if (kept) {
    atomic_init(&kept->holders, 1);
    *memory = copy_smoothness(as, &kept->as);
    if (*memory && make_smooth(kept, model, memory)) {
      return kept;
    }
    sg_kept_smooth_drop(kept);
  }
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
sg_kept_smooth_hold_ex(sg_kept_model *model, const sg_smoothness *as)
{
  sg_kept_smooth *kept = find_smooth(model, as);
  bool memory = true;

  if (!kept) {
    kept = new_smooth(model->model, as, &memory);
    if (kept) {
      keep_smooth(model, kept);
    } else if (!memory) {
      sg_no_memory();
    }
  }
  return kept;
}
