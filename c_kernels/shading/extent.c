/* extent.c -- see extent.h. */
#include "extent.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>

enum { BAND = 16, HALVINGS = 8 };

typedef struct extents {
  const sg_shading *scene;
  sg_shading_extent *band; /* y1, y2: the first and the last line */
  atomic_bool no_memory;
} extents;

static const sg_shading_extent nothing = {INFINITY, INFINITY, -INFINITY,
                                          -INFINITY};

static void
do_band(void *data, size_t band)
{
  extents *all = data;
  sg_shading_extent *out = &all->band[band];
  int32_t height = sg_shading_frame_of(all->scene)->height;
  int32_t y = (int32_t)band * BAND, end = y + BAND;
  sg_spans spans = {0};
  sg_shading_work *work = sg_shading_work_open(all->scene, NULL);
  bool good = work != NULL;

  *out = nothing;
  end = end < height ? end : height;
  for (; good && y < end && !sg_pool_stopping(); y++) {
    good = sg_shading_line(all->scene, work, y + 0.5, &spans);
    if (good && spans.n > 0) {
      out->x1 = fmin(out->x1, spans.span[0].x1 / 256.0);
      out->x2 = fmax(out->x2, spans.span[spans.n - 1].x2 / 256.0);
      out->y1 = fmin(out->y1, y + 0.5);
      out->y2 = y + 0.5;
    }
  }
  if (!good) {
    atomic_store(&all->no_memory, true);
  }
  free(spans.span);
  if (work) {
    sg_shading_work_close(work);
  }
}

/* Between the line `in`, on which something is seen, and the line `out`. */
static bool
border(const sg_shading *scene, sg_shading_work *work, double in, double out,
       double *at)
{
  sg_spans spans = {0};
  bool good = true;

  for (int i = 0; good && i < HALVINGS; i++) {
    double middle = (in + out) / 2;

    good = sg_shading_line(scene, work, middle, &spans);
    if (spans.n > 0) {
      in = middle;
    } else {
      out = middle;
    }
  }
  free(spans.span);
  *at = out;
  return good;
}

static bool
borders(const sg_shading *scene, sg_shading_extent *out)
{
  int32_t height = sg_shading_frame_of(scene)->height;
  sg_shading_work *work = sg_shading_work_open(scene, NULL);
  bool good = work != NULL;

  good = good && border(scene, work, out->y1, fmax(out->y1 - 1, 0), &out->y1);
  good = good && border(scene, work, out->y2, fmin(out->y2 + 1, height - 0.01),
                        &out->y2);
  if (work) {
    sg_shading_work_close(work);
  }
  return good;
}

sg_shading_end
sg_shading_extent_of(const sg_shading *scene, sg_pool *pool,
                     const sg_cancel *cancel, sg_shading_extent *out)
{
  size_t bands = ((size_t)sg_shading_frame_of(scene)->height + BAND - 1) / BAND;
  extents all = {scene, malloc(bands * sizeof *all.band), false};
  bool ran = all.band && sg_pool_run(pool, bands, do_band, &all, cancel);

  *out = nothing;
  for (size_t i = 0; ran && i < bands; i++) {
    out->x1 = fmin(out->x1, all.band[i].x1);
    out->y1 = fmin(out->y1, all.band[i].y1);
    out->x2 = fmax(out->x2, all.band[i].x2);
    out->y2 = fmax(out->y2, all.band[i].y2);
  }
  bool memory = all.band && !atomic_load(&all.no_memory) &&
                (!ran || out->x1 > out->x2 || borders(scene, out));

  free(all.band);
  return !memory ? SG_SHADING_NO_MEMORY
         : !ran  ? SG_SHADING_STOPPED
                 : SG_SHADING_GOOD;
}
