/* triangulate.c -- a whole polygon into triangles: see triangulate.h. */
#include "triangulate.h"

#include <stdlib.h>

static bool
push(sg_triangles *out, const sg_triangle *t)
{
  if (out->n == out->room) {
    size_t room = out->room ? out->room * 2 : 64;
    sg_triangle *item = realloc(out->item, room * sizeof *item);
    if (!item) {
      return false;
    }
    out->item = item;
    out->room = room;
  }
  out->item[out->n++] = *t;
  return true;
}

/* PL-6 steps 3 to 5 for one edge: the first candidate that can be taken. */
static sg_outcome
one_triangle(sg_work *work, int32_t edge, sg_triangles *out)
{
  const sg_work_edge *row = sg_work_get(work, edge);
  sg_triangle t = {{row->start, row->end, SG_WORK_NONE}};
  sg_candidates walk;
  int taken = 0;

  sg_candidates_open(&walk, work, t.v[0], t.v[1]);
  while (taken == 0 && (t.v[2] = sg_candidates_next(&walk)) >= 0) {
    taken = sg_work_take(work, edge, t.v[2]);
  }
  bool no_memory = walk.no_memory;
  sg_candidates_close(&walk);
  if (no_memory || taken < 0 || (taken && !push(out, &t))) {
    return SG_NO_SPACE;
  }
  return taken ? SG_DONE : SG_STUCK;
}

sg_outcome
sg_work_triangulate(sg_work *work, sg_triangles *out, int32_t *edge,
                    const sg_poll *poll)
{
  while ((*edge = sg_work_next(work, 0)) != 0) { /* steps 2 and 6 */
    if (sg_poll_stop(poll)) {
      return SG_STOPPED;
    }
    sg_outcome outcome = one_triangle(work, *edge, out);
    if (outcome != SG_DONE) {
      return outcome;
    }
  }
  return SG_DONE;
}
