/* scan.c -- see scan.h. */
#include "scan.h"

#include "shading_private.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

enum { BAND = 16 }; /* rows of a task */

typedef struct scanning {
  sg_scan *scan;
  const sg_opacities *opacities;
  atomic_bool no_memory;
} scanning;

static bool
keep_line(sg_scan *scan, size_t i, const sg_spans *spans)
{
  size_t size = spans->n * sizeof *spans->span;

  scan->line[i].span = malloc(size + 1);
  if (!scan->line[i].span) {
    return false;
  }
  if (spans->n > 0) {
    memcpy(scan->line[i].span, spans->span, size);
  }
  scan->line[i].n = spans->n;
  return true;
}

static void
do_band(void *data, size_t band)
{
  scanning *all = data;
  sg_scan *scan = all->scan;
  sg_shading_work *work = sg_shading_work_open(scan->scene, all->opacities);
  size_t from = band * BAND * scan->lines, end = from + BAND * scan->lines;
  sg_spans spans = {0};
  bool good = work != NULL;

  end = end < scan->n ? end : scan->n;
  for (size_t i = from; good && i < end && !sg_pool_stopping(); i++) {
    double y = (double)(i / scan->lines) +
               ((double)(i % scan->lines) + 0.5) / scan->lines;
    good = sg_shading_line(scan->scene, work, y, &spans) &&
           keep_line(scan, i, &spans);
  }
  if (!good) {
    atomic_store(&all->no_memory, true);
  }
  free(spans.span);
  sg_shading_work_close(work);
}

sg_shading_end
sg_scan_open(const sg_shading *scene, unsigned lines,
             const sg_opacities *opacities, sg_pool *pool,
             const sg_cancel *cancel, sg_scan **out)
{
  size_t n = (size_t)scene->frame.height * lines;
  sg_scan *scan = malloc(sizeof *scan);
  scanning all = {.scan = scan, .opacities = opacities};
  sg_shading_end end = SG_SHADING_NO_MEMORY;

  atomic_init(&all.no_memory, false);
  if (scan) {
    *scan = (sg_scan){.scene = scene,
                      .serial = scene->serial,
                      .lines = lines,
                      .n = n,
                      .line = calloc(n, sizeof *scan->line)};
    end = !scan->line ? SG_SHADING_NO_MEMORY
          : !sg_pool_run(pool, (n + BAND * lines - 1) / (BAND * lines), do_band,
                         &all, cancel)
              ? SG_SHADING_STOPPED
          : atomic_load(&all.no_memory) ? SG_SHADING_NO_MEMORY
                                        : SG_SHADING_GOOD;
  }
  if (end != SG_SHADING_GOOD) {
    sg_scan_close(scan);
    scan = NULL;
  }
  *out = scan;
  return end;
}

bool
sg_scan_is_of(const sg_scan *scan, const sg_shading *scene, unsigned lines)
{
  return scan->serial == scene->serial && scan->lines == lines;
}

void
sg_scan_close(sg_scan *scan)
{
  if (scan) {
    for (size_t i = 0; scan->line && i < scan->n; i++) {
      free(scan->line[i].span);
    }
    free(scan->line);
    free(scan);
  }
}
