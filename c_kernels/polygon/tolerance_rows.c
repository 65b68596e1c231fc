/* tolerance_rows.c -- what counts as one place in a model, or in segments. */
#include "doors/world.h"
#include "flatness.h"
#include "rows/by_segment.h"
#include "rows/grain_rows.h"
#include "rows/pattern_rows.h"

#include <math.h>
#include <pthread.h>
#include <stdlib.h>

enum { ASKED = 64 }; /* pages between questions */

/* The last tolerance of a world, and the vertices it is of: its note
 * SG_NOTE_TOLERANCE. */
typedef struct kept_tolerance {
  pthread_mutex_t lock;
  uint64_t stamp; /* 0: none yet */
  double tolerance;
} kept_tolerance;

static void
drop_tolerance(void *note)
{
  kept_tolerance *kept = note;

  pthread_mutex_destroy(&kept->lock);
  free(kept);
}

/* Null: no memory, and nothing is kept. */
static kept_tolerance *
tolerance_of(sg_world *world)
{
  return sg_world_add_note(world, SG_NOTE_TOLERANCE, sizeof(kept_tolerance),
                           drop_tolerance);
}

/* Looks at every vertex but those of patterns. */
static bool
see_model(sg_call *call, const sg_version *version, double *out)
{
  sg_flatness flatness;
  sg_model_view view;
  double grain;
  bool good = sg_model_view_make(version, SG_V, &view) &&
              sg_grain_of_all(version, &grain);

  if (good) {
    sg_flatness_init(&flatness, grain);
  }
  for (size_t i = 0; good && i < view.shown.pages; i++) {
    sg_flatness_page(&flatness, &view.shown, i);
    good = i % ASKED != ASKED - 1 || !sg_cancelled(&call->cancel);
  }
  sg_model_view_clear(&view);
  if (good) {
    *out = sg_flatness_touch(&flatness);
  }
  return good || sg_call_ended(call);
}

/* Another thread may be at it. */
static bool
recall(kept_tolerance *kept, uint64_t stamp, double *out)
{
  pthread_mutex_lock(&kept->lock);
  bool known = stamp != 0 && kept->stamp == stamp;

  *out = kept->tolerance;
  pthread_mutex_unlock(&kept->lock);
  return known;
}

static void
remember(kept_tolerance *kept, uint64_t stamp, double tolerance)
{
  pthread_mutex_lock(&kept->lock);
  kept->stamp = stamp;
  kept->tolerance = tolerance;
  pthread_mutex_unlock(&kept->lock);
}

bool
sg_door_model_tolerance(sg_call *call, double *tolerance)
{
  const sg_version *version = sg_call_version(call);

  if (!version) {
    return false;
  }
  kept_tolerance *kept = tolerance_of(call->world);
  uint64_t stamp = sg_version_last_stamp(version, SG_V);

  if (kept && recall(kept, stamp, tolerance)) {
    return true;
  }
  if (!see_model(call, version, tolerance)) {
    return false;
  }
  if (kept) {
    remember(kept, stamp, *tolerance);
  }
  return true;
}

/* ---- of segments ---- */

enum { SEEN = 1 << 16 }; /* vertices between questions */

/* Segments that are seen, each a task. */
typedef struct seeing {
  const sg_view *view;
  const sg_segment_rows *rows;
  sg_flatness *of; /* [segments] */
} seeing;

static void
see_segment(void *data, size_t i)
{
  const seeing *all = data;
  const sg_column *column = all->view->column;

  for (size_t k = all->rows->begin[i]; k < all->rows->begin[i + 1]; k++) {
    size_t page = all->rows->row[k] / SG_PAGE_ROWS;
    size_t r = all->rows->row[k] % SG_PAGE_ROWS;

    if (k % SEEN == SEEN - 1 && sg_pool_stopping()) {
      return;
    }
    sg_flatness_see(&all->of[i], (const double[3]){column[2].page[page].f[r],
                                                   column[3].page[page].f[r],
                                                   column[4].page[page].f[r]});
  }
}

/* Of the n segments' own vertices, those of `rows`. */
static bool
see_rows(sg_call *call, const sg_view *view, const sg_segment_rows *rows,
         size_t n, sg_flatness *of)
{
  seeing all = {view, rows, of};
  bool many = rows->begin[n] >= SEEN;
  sg_pool *pool = many ? sg_call_pool(call) : NULL;

  return (!many || pool) &&
         (sg_pool_run(pool, n, see_segment, &all, &call->cancel) ||
          sg_call_ended(call));
}

/* One for each segment; null: refused. */
static sg_flatness *
see_segments(sg_call *call, const sg_int_list *ss)
{
  const sg_version *version = sg_call_version(call);
  sg_flatness *of = sg_call_alloc(call, ss->n * sizeof *of);
  sg_segment_rows rows = {0};
  sg_view view = {0};

  for (size_t i = 0; version && of && i < ss->n; i++) {
    sg_flatness_init(&of[i], sg_grain_of(version, ss->at[i]));
  }
  bool good =
      version && of &&
      ((sg_version_view(version, SG_V, &view) &&
        sg_segment_rows_find(&view, ss->at, ss->n, &call->cancel, &rows)) ||
       sg_call_ended(call)) &&
      see_rows(call, &view, &rows, ss->n, of);

  sg_segment_rows_clear(&rows);
  sg_view_clear(&view);
  return good ? of : NULL;
}

bool
sg_door_segments_tolerance(sg_call *call, const sg_int_list *segments,
                           double *tolerance, double *smallest)
{
  sg_flatness all, *of = see_segments(call, segments);
  double least = HUGE_VAL;

  sg_flatness_init(&all, 0);
  for (size_t i = 0; of && i < segments->n; i++) {
    least = fmin(least, sg_flatness_size(&of[i]));
    sg_flatness_join(&all, &of[i]);
  }
  *tolerance = sg_flatness_touch(&all);
  *smallest = segments->n > 0 ? least : 0;
  return of != NULL;
}

bool
sg_door_segment_grain(sg_call *call, int32_t s, double *grain)
{
  const sg_version *version = sg_call_version(call);

  if (version) {
    *grain = sg_grain_of(version, s);
  }
  return version != NULL;
}
