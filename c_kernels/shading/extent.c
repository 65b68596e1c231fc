/* extent.c -- see extent.h. */
#include "extent.h"

#include "engine/search.h"
#include "shading_private.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>

enum { BAND = 16, HALVINGS = 8 };

/* Of some lines, in 1/256 dot: how far they reach, and which reach farthest. */
typedef struct reached {
  int32_t x1, x2; /* x1 > x2: nothing is seen */
  double left, right;
  double first, last; /* lines on which something is seen */
} reached;

typedef struct extents {
  const sg_shading *scene;
  reached *band;
  atomic_bool no_memory;
} extents;

static const reached nothing = {INT32_MAX, INT32_MIN, 0,
                                0,         INFINITY,  -INFINITY};

static void
reach(reached *all, const reached *more)
{
  if (more->x1 < all->x1) {
    all->x1 = more->x1;
    all->left = more->left;
  }
  if (more->x2 > all->x2) {
    all->x2 = more->x2;
    all->right = more->right;
  }
  all->first = fmin(all->first, more->first);
  all->last = fmax(all->last, more->last);
}

/* Looks at a line; `within`: only beyond what has been reached, and the line is
 * not noted as one where something is seen. */
static bool
look_at(const sg_shading *scene, sg_shading_work *work, double y, bool within,
        sg_spans *spans, reached *all)
{
  const sg_line_part part = {within ? all->x1 : 1, within ? all->x2 : 0, true};
  bool good = sg_shading_line_part(scene, work, y, &part, spans);

  if (good && spans->n > 0) {
    reached line = {spans->span[0].x1,     spans->span[spans->n - 1].x2, y, y,
                    within ? INFINITY : y, within ? -INFINITY : y};
    reach(all, &line);
  }
  return good;
}

/* The lines from y up to, not with, end: the first and the last one that show
 * something as they are, those between as far as they reach farther. */
static bool
look_at_lines(const sg_shading *scene, sg_shading_work *work, int32_t y,
              int32_t end, sg_spans *spans, reached *all)
{
  bool good = true;

  for (; good && y < end && all->x1 > all->x2; y++) {
    good = look_at(scene, work, y + 0.5, false, spans, all);
  }
  double last = all->last;
  for (; good && y < end && all->last == last; end--) {
    good = look_at(scene, work, end - 0.5, false, spans, all);
  }
  for (; good && y < end && !sg_pool_stopping(); y++) {
    good = look_at(scene, work, y + 0.5, true, spans, all);
  }
  return good;
}

static void
do_band(void *data, size_t band)
{
  extents *all = data;
  int32_t height = sg_shading_frame_of(all->scene)->height;
  int32_t y = (int32_t)band * BAND, end = y + BAND;
  sg_spans spans = {0};
  sg_shading_work *work = sg_shading_work_open(all->scene, NULL);

  all->band[band] = nothing;
  end = end < height ? end : height;
  if (!work ||
      !look_at_lines(all->scene, work, y, end, &spans, &all->band[band])) {
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

/* A tip may be between the line that reaches farthest and its neighbours. */
static bool
find_tip(const sg_shading *scene, sg_shading_work *work, const double *tip,
         reached *all)
{
  double height = sg_shading_frame_of(scene)->height - 0.01, step = 0.5;
  sg_spans spans = {0};
  bool good = true;

  for (int i = 0; good && i < HALVINGS; i++, step /= 2) {
    double above = fmax(*tip - step, 0), below = fmin(*tip + step, height);
    good = look_at(scene, work, above, true, &spans, all) &&
           look_at(scene, work, below, true, &spans, all);
  }
  free(spans.span);
  return good;
}

static bool
borders(const sg_shading *scene, reached *all, sg_shading_extent *out)
{
  int32_t height = sg_shading_frame_of(scene)->height;
  sg_shading_work *work = sg_shading_work_open(scene, NULL);
  bool good =
      work && find_tip(scene, work, &all->left, all) &&
      find_tip(scene, work, &all->right, all) &&
      border(scene, work, all->first, fmax(all->first - 1, 0), &out->y1) &&
      border(scene, work, all->last, fmin(all->last + 1, height - 0.01),
             &out->y2);

  out->x1 = all->x1 / 256.0;
  out->x2 = all->x2 / 256.0;
  if (work) {
    sg_shading_work_close(work);
  }
  return good;
}

/* ---- what is thinner than a dot ---- */

SG_ORDER(compare_heights, double, SG_BY_AT(0));

/* Where leaves begin and end, in order. Null: no memory. */
static double *
ends_of_leaves(const sg_shading *s, size_t *n)
{
  size_t leaves = s->leaf.n;
  double *y = malloc((2 * leaves + 1) * sizeof *y);

  *n = 2 * leaves;
  for (size_t i = 0; y && i < leaves; i++) {
    y[2 * i] = INFINITY;
    y[2 * i + 1] = -INFINITY;
  }
  for (size_t i = 0; y && i < s->polygon.n; i++) {
    const sg_shading_polygon *p = &s->polygon.item[i];
    y[2 * p->leaf] = fmin(y[2 * p->leaf], p->y1);
    y[2 * p->leaf + 1] = fmax(y[2 * p->leaf + 1], p->y2);
  }
  for (size_t i = 0; y && i < s->body.n; i++) {
    const sg_shading_body *b = &s->body.item[i];
    y[2 * b->leaf] = fmin(y[2 * b->leaf], b->y1);
    y[2 * b->leaf + 1] = fmax(y[2 * b->leaf + 1], b->y2);
  }
  if (y) {
    qsort(y, *n, sizeof *y, compare_heights);
  }
  return y;
}

/* Whether something may be seen to the left or to the right of all that is. */
static bool
may_be_beside(const sg_shading *s, const reached *all)
{
  double width = sg_shading_frame_of(s)->width;

  return fmax(s->low[0], 0) < all->x1 / 256.0 - 1 ||
         fmin(s->high[0], width) > all->x2 / 256.0 + 1;
}

/* Between two neighbours of where leaves begin and end there may be something
 * through which no line in the middle of dots goes: so one there is looked at,
 * in each quarter of a dot once. */
static bool
look_at_thin(const sg_shading *s, reached *all)
{
  double height = sg_shading_frame_of(s)->height - 0.01, quarter = -1;
  sg_shading_work *work = sg_shading_work_open(s, NULL);
  size_t n = 0;
  double *end = work ? ends_of_leaves(s, &n) : NULL;
  sg_spans spans = {0};
  bool good = end != NULL, beside = may_be_beside(s, all);

  for (size_t i = 0; good && i + 1 < n; i++) {
    double low = fmax(end[i], 0), high = fmin(end[i + 1], height);
    double y = (low + high) / 2;
    bool in = all->first <= y && y <= all->last;

    if (low < high && ceil(low - 0.5) + 0.5 >= high && (!in || beside) &&
        floor(4 * y) > quarter) {
      quarter = floor(4 * y);
      good = look_at(s, work, y, in, &spans, all);
    }
  }
  free(end);
  free(spans.span);
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
  reached most = nothing;

  for (size_t i = 0; ran && i < bands; i++) {
    reach(&most, &all.band[i]);
  }
  *out = (sg_shading_extent){INFINITY, INFINITY, -INFINITY, -INFINITY};
  bool memory = all.band && !atomic_load(&all.no_memory) &&
                (!ran || (look_at_thin(scene, &most) &&
                          (most.x1 > most.x2 || borders(scene, &most, out))));

  free(all.band);
  return !memory ? SG_SHADING_NO_MEMORY
         : !ran  ? SG_SHADING_STOPPED
                 : SG_SHADING_GOOD;
}
