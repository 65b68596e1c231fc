/* work_meeting.c -- which edges meet a segment: a join of the scratch relation
 * (work.h).
 *
 * Layer: kernel. Exact throughout.
 */
#include "engine/list.h"
#include "engine/search.h"
#include "work_private.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- an edge and a segment ---------------------------------------------- */

/* The pictures' boxes are apart (a strict < of roundings is exact). */
static bool
apart(const double a[2], const double b[2], const double c[2],
      const double d[2])
{
  for (int k = 0; k < 2; k++) {
    if (fmax(a[k], b[k]) < fmin(c[k], d[k]) ||
        fmax(c[k], d[k]) < fmin(a[k], b[k])) {
      return true;
    }
  }
  return false;
}

bool
sg_work_near(const sg_work *work, int32_t edge, int32_t v)
{
  const double *a = work->vertex[work->edge[edge].edge.start].at;
  const double *b = work->vertex[work->edge[edge].edge.end].at;
  const double *c = work->vertex[v].at;

  return !apart(a, b, c, c);
}

static bool
same_place(const sg_work *work, int32_t a, int32_t b)
{
  const sg_point *p = &work->vertex[a].point, *q = &work->vertex[b].point;

  return sg_point_compare((work->axis + 1) % 3, p, q) == 0 &&
         sg_point_compare((work->axis + 2) % 3, p, q) == 0;
}

/* Ends with different ids in one place. */
static unsigned
ends_together(const sg_work *work, int32_t v1, int32_t v2,
              const sg_work_edge *edge)
{
  int32_t end[2] = {v1, v2}, other[2] = {edge->start, edge->end};
  unsigned bits = 0;

  for (int i = 0; i < 2; i++) {
    for (int j = 0; j < 2; j++) {
      if (end[i] != other[j] && same_place(work, end[i], other[j])) {
        bits |= (unsigned)SG_V1_AT_START << (2 * i + j);
      }
    }
  }
  return bits;
}

static bool
at_an_end(const sg_work *work, int32_t v, int32_t a, int32_t b)
{
  return v == a || v == b || same_place(work, v, a) || same_place(work, v, b);
}

/* Both on one line: false if they have no length in common and no end that
 * is not shared. */
static bool
on_one_line(const sg_work *work, int32_t v1, int32_t v2,
            const sg_work_edge *edge, sg_meeting *out)
{
  unsigned in = out->inside;
  bool in1 = in & SG_V1_INSIDE || at_an_end(work, v1, edge->start, edge->end);
  bool in2 = in & SG_V2_INSIDE || at_an_end(work, v2, edge->start, edge->end);
  unsigned inner =
      SG_V1_INSIDE | SG_V2_INSIDE | SG_START_INSIDE | SG_END_INSIDE;

  if (in1 && in2) {
    out->how = SG_CONTAINED;
    return true;
  }
  out->how = in & inner ? SG_OVERLAPS : SG_TOUCHES;
  return in != 0;
}

/* Whether v is between the two others along an axis: mostly a line goes on
 * nearly straight there, and no turn has to be found. */
static bool
goes_on(const sg_work *work, int32_t a, int32_t v, int32_t b)
{
  const double *p = work->vertex[a].at, *q = work->vertex[b].at;
  const double *at = work->vertex[v].at;

  for (int k = 0; k < 2; k++) {
    if ((p[k] < at[k] && at[k] < q[k]) || (p[k] > at[k] && at[k] > q[k])) {
      return true;
    }
  }
  return false;
}

/* Do they share an end, and part there? Then that is all they share. */
static bool
turn_apart(const sg_work *work, int32_t v1, int32_t v2, int32_t a, int32_t b)
{
  if (v1 == a || v1 == b) {
    int32_t other = v1 == a ? b : a;
    return goes_on(work, v2, v1, other) ||
           sg_work_turn(work, v1, v2, other) != 0;
  }
  if (v2 == a || v2 == b) {
    int32_t other = v2 == a ? b : a;
    return goes_on(work, v1, v2, other) ||
           sg_work_turn(work, v1, v2, other) != 0;
  }
  return false;
}

/* False: they do not meet, or only in a shared end. */
static bool
meet(const sg_work *work, int32_t v1, int32_t v2, const sg_work_edge *edge,
     sg_meeting *out)
{
  int32_t a = edge->start, b = edge->end;
  const sg_work_vertex_row *v = work->vertex;

  if (apart(v[v1].at, v[v2].at, v[a].at, v[b].at) ||
      turn_apart(work, v1, v2, a, b)) {
    return false;
  }
  bool shared = v1 == a || v1 == b || v2 == a || v2 == b;
  int side_1 = shared ? 0 : sg_work_turn(work, a, b, v1);
  int side_2 = shared ? 0 : sg_work_turn(work, a, b, v2);
  if (side_1 * side_2 > 0) { /* asked first: a line that goes on nearly straight
                                is on one side of the edges that it passed */
    return false;
  }
  int side_a = shared ? 0 : sg_work_turn(work, v1, v2, a);
  int side_b = shared ? 0 : sg_work_turn(work, v1, v2, b);
  if (side_a * side_b > 0) {
    return false;
  }
  if (side_a && side_b && side_1 && side_2) {
    *out = (sg_meeting){.how = SG_CROSSES};
    return true;
  }
  *out = (sg_meeting){.how = SG_TOUCHES};
  out->inside =
      (side_1 == 0 && sg_work_inside(work, a, b, v1) ? SG_V1_INSIDE : 0u) |
      (side_2 == 0 && sg_work_inside(work, a, b, v2) ? SG_V2_INSIDE : 0u) |
      (side_a == 0 && sg_work_inside(work, v1, v2, a) ? SG_START_INSIDE : 0u) |
      (side_b == 0 && sg_work_inside(work, v1, v2, b) ? SG_END_INSIDE : 0u) |
      ends_together(work, v1, v2, edge);
  if (side_a == 0 && side_b == 0) {
    return on_one_line(work, v1, v2, edge, out);
  }
  return out->inside != 0;
}

bool
sg_work_meets(const sg_work *work, int32_t v1, int32_t v2, int32_t e)
{
  sg_meeting met;

  return meet(work, v1, v2, &work->edge[e].edge, &met);
}

bool
sg_meetings_push(sg_meetings *out, const sg_meeting *met)
{
  if (!sg_list_grow(&out->item, out->n, &out->room, sizeof *out->item)) {
    return false;
  }
  out->item[out->n++] = *met;
  return true;
}

SG_ORDER(by_edge, sg_meeting, SG_BY(edge));

void
sg_meetings_sort(sg_meetings *met)
{
  if (met->n > 1) {
    qsort(met->item, met->n, sizeof *met->item, by_edge);
  }
}

bool
sg_work_meeting(sg_work *work, int32_t v1, int32_t v2, sg_meetings *out)
{
  int32_t corner[2] = {v1, v2};
  sg_work_scan scan;

  out->n = 0;
  if (!sg_work_scan_open(&scan, work, corner, 2)) {
    return false;
  }
  for (int32_t e; (e = sg_work_scan_next(&scan)) != 0;) {
    sg_meeting met;
    if (meet(work, v1, v2, &work->edge[e].edge, &met)) {
      met.edge = e;
      if (!sg_meetings_push(out, &met)) {
        return false;
      }
    }
  }
  sg_meetings_sort(out);
  return true;
}

void
sg_meetings_clear(sg_meetings *met)
{
  free(met->item);
  *met = (sg_meetings){0};
}

int
sg_work_meeting_but(sg_work *work, int32_t v1, int32_t v2, int32_t but)
{
  sg_work_scan scan;

  if (!sg_work_scan_open(&scan, work, (const int32_t[2]){v1, v2}, 2)) {
    return -1;
  }
  for (int32_t e; (e = sg_work_scan_next(&scan)) != 0;) {
    const sg_work_edge *edge = &work->edge[e].edge;
    if (edge->start != but && edge->end != but &&
        sg_work_meets(work, v1, v2, e)) {
      return 1;
    }
  }
  return 0;
}
