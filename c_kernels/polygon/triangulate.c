/* triangulate.c -- a whole polygon into triangles: see triangulate.h. */
#include "triangulate.h"

#include "delaunay.h"
#include "engine/list.h"

#include <stdlib.h>

static bool
push(sg_triangles *out, const sg_triangle *t)
{
  if (!sg_list_grow(&out->item, out->n, &out->room, sizeof *out->item)) {
    return false;
  }
  out->item[out->n++] = *t;
  out->settled = false;
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

/* The edges, start and end, by handle; null: no memory. */
static int32_t (*note_edges(const sg_work *work, size_t *n))[2]
{
  int32_t(*edge)[2] = malloc((sg_work_edges(work) + 1) * sizeof *edge);

  *n = 0;
  for (int32_t e = 0; edge && (e = sg_work_next(work, e));) {
    const sg_work_edge *row = sg_work_get(work, e);

    edge[*n][0] = row->start;
    edge[(*n)++][1] = row->end;
  }
  return edge;
}

sg_outcome
sg_work_outcome(const sg_work *work)
{
  switch (sg_work_ended(work)) {
  case SG_WAS_STOPPED:
    return SG_STOPPED;
  case SG_TOOK_TOO_MUCH:
    return SG_TOO_MUCH;
  case SG_GOES_ON:
    break;
  }
  return SG_NO_SPACE;
}

static sg_outcome
take_all(sg_work *work, sg_triangles *out, int32_t *edge,
         const sg_cancel *cancel)
{
  if ((*edge = sg_work_crossed(work)) != 0) {
    return SG_STUCK;
  }
  if (!sg_work_pairs_ready(work)) {
    return SG_NO_SPACE;
  }
  while ((*edge = sg_work_next(work, 0)) != 0) { /* steps 2 and 6 */
    if (sg_cancelled(cancel)) {
      return SG_STOPPED;
    }
    sg_outcome outcome = one_triangle(work, *edge, out);
    if (sg_work_ended(work) != SG_GOES_ON) {
      return sg_work_outcome(work);
    }
    if (outcome != SG_DONE) {
      return outcome;
    }
  }
  return SG_DONE;
}

/* The work has a guard: that of the caller, or this one. */
static bool
guard_begins(sg_work *work, sg_work_guard *guard, const sg_cancel *cancel)
{
  bool guarded = sg_work_is_guarded(work);

  *guard = (sg_work_guard){.cancel = cancel, .most = SIZE_MAX};
  if (!guarded) {
    sg_work_guard_by(work, guard);
  }
  return !guarded;
}

static void
guard_ends(sg_work *work, bool begun)
{
  if (begun) {
    sg_work_guard_by(work, NULL);
  }
}

/* One triangle may take long, too. */
static sg_outcome
take_all_guarded(sg_work *work, sg_triangles *out, int32_t *edge,
                 const sg_cancel *cancel)
{
  sg_work_guard guard;
  bool begun = guard_begins(work, &guard, cancel);
  sg_outcome outcome = take_all(work, out, edge, cancel);

  guard_ends(work, begun);
  return outcome;
}

sg_outcome
sg_work_resolve_asking(sg_work *work, double reach, const sg_cancel *cancel)
{
  sg_work_guard guard;
  bool begun = guard_begins(work, &guard, cancel);
  bool done = sg_work_resolve(work, reach);
  sg_outcome outcome = done && sg_work_ended(work) == SG_GOES_ON
                           ? SG_DONE
                           : sg_work_outcome(work);

  guard_ends(work, begun);
  return outcome;
}

sg_outcome
sg_work_triangulate_moved(sg_work *work, double moved, sg_triangles *out,
                          int32_t *edge, const sg_cancel *cancel)
{
  size_t before = out->n, edges;
  int32_t(*of)[2] = note_edges(work, &edges);

  if (!of) {
    return SG_NO_SPACE;
  }
  sg_outcome outcome = take_all_guarded(work, out, edge, cancel);

  if (outcome == SG_DONE) {
    sg_triangles fresh = {.item = out->item ? out->item + before : NULL,
                          .n = out->n - before,
                          .room = out->n - before};

    outcome = sg_triangles_thicken(work, (const int32_t(*)[2])of, edges, moved,
                                   &fresh, cancel);
    out->settled = before == 0 && fresh.settled;
  }
  free(of);
  return outcome;
}

sg_outcome
sg_work_triangulate(sg_work *work, sg_triangles *out, int32_t *edge,
                    const sg_cancel *cancel)
{
  return sg_work_triangulate_moved(work, 0, out, edge, cancel);
}
