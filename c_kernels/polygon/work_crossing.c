/* work_crossing.c -- edges that cross, so that no triangle has one of them for
 * a side: see work.h.
 *
 * Layer: kernel. What is crossed is in the way of all triangles of what crosses
 * it, and stays so until one of the two is a side of one.
 */
#include "work_private.h"

#include <math.h>

bool
sg_work_crosses(const sg_work *work, int32_t e, int32_t other)
{
  const sg_work_edge *a = &work->edge[e].edge, *b = &work->edge[other].edge;

  if (sg_work_turn(work, a->start, a->end, b->start) *
              sg_work_turn(work, a->start, a->end, b->end) >=
          0 ||
      sg_work_turn(work, b->start, b->end, a->start) *
              sg_work_turn(work, b->start, b->end, a->end) >=
          0) {
    return false;
  }
  for (int32_t v = 0; v < work->vertices; v++) {
    if (sg_work_has_edges(work, v) && sg_work_near(work, e, v) &&
        sg_work_near(work, other, v) &&
        sg_work_turn(work, a->start, a->end, v) == 0 &&
        sg_work_turn(work, b->start, b->end, v) == 0) {
      return false;
    }
  }
  return true;
}

int32_t
sg_work_crossed(const sg_work *work)
{
  return sg_work_get(work, work->crossed[0]) ? work->crossed[0] : 0;
}

/* How far v is from the line a-b, in the picture. */
static double
distance(const sg_work *work, int32_t a, int32_t b, int32_t v)
{
  const double *p = work->vertex[a].at, *q = work->vertex[b].at,
               *r = work->vertex[v].at;
  double x = q[0] - p[0], y = q[1] - p[1];

  return fabs(x * (r[1] - p[1]) - y * (r[0] - p[0])) / hypot(x, y);
}

bool
sg_work_crossed_by_far(const sg_work *work, double reach)
{
  double far = 64 * reach;

  if (!work->crossed[0]) {
    return false;
  }
  const sg_work_edge *a = &work->edge[work->crossed[0]].edge,
                     *b = &work->edge[work->crossed[1]].edge;
  double start = distance(work, b->start, b->end, a->start);
  double end = distance(work, b->start, b->end, a->end);
  double part = start / (start + end), at[2]; /* where they cross */

  for (int k = 0; k < 2; k++) {
    double p = work->vertex[a->start].at[k], q = work->vertex[a->end].at[k];

    at[k] = p + part * (q - p);
  }
  if (!(fmin(start, end) > far) ||
      !(fmin(distance(work, a->start, a->end, b->start),
             distance(work, a->start, a->end, b->end)) > far)) {
    return false;
  }
  for (int32_t v = 0; v < work->vertices; v++) {
    const double *p = work->vertex[v].at;

    if (sg_work_has_edges(work, v) &&
        !(hypot(p[0] - at[0], p[1] - at[1]) > far)) {
      return false;
    }
  }
  return true;
}
