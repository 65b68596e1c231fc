/* scan.h -- the spans of all lines of a picture, kept.
 *
 * Layer: kernel. With them a picture of other looks needs no line again.
 */
#ifndef SG_SCAN_H
#define SG_SCAN_H

#include "shading_scene.h"
#include "thread_pool.h"

typedef struct sg_scan {
  const sg_shading *scene; /* whose surfaces the spans name; not owned */
  uint64_t serial;         /* that of the scene */
  unsigned lines;          /* of a dot */
  size_t n;
  struct sg_scan_line {
    sg_span *span;
    size_t n;
  } * line; /* [n], from above */
} sg_scan;

/* All lines of `scene`, `lines` to a dot; `opacities` as for
 * sg_shading_work_open(). GOOD, NO_MEMORY or STOPPED. Owner: sg_scan_close().
 */
sg_shading_end sg_scan_open(const sg_shading *scene, unsigned lines,
                            const sg_opacities *opacities, sg_pool *pool,
                            const sg_cancel *cancel, sg_scan **out);
void sg_scan_close(sg_scan *scan);

/* Whether it is one of this scene. */
bool sg_scan_is_of(const sg_scan *scan, const sg_shading *scene,
                   unsigned lines);

/* Borrowed. */
static inline sg_spans
sg_scan_line(const sg_scan *scan, size_t i)
{
  return (sg_spans){scan->line[i].span, scan->line[i].n, 0};
}

#endif
