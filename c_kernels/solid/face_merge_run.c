/* face_merge_run.c -- straight runs of edges: see face_merge_private.h.
 *
 * Layer: kernel. A run is a chain of edges through vertices at which no other
 * edge ends, so it has the same faces on its sides all along. It is divided at
 * the vertex farthest from the edge that would replace it, until none is
 * farther than the tolerance. Source: U. Ramer, An iterative procedure for the
 * polygonal approximation of plane curves, 1972.
 */
#include "engine/list.h"
#include "engine/search.h"
#include "face_merge_private.h"

#include <math.h>
#include <stdlib.h>

enum { OFTEN = 1 << 10 }; /* vertices between questions */

/* An edge that replaces others, and the vertex that is kept if there is such an
 * edge already. */
typedef struct shortcut {
  uint32_t low, high, farthest;
} shortcut;

typedef struct runner {
  sg_merge *m;
  uint32_t *vertex; /* [n]: of the run at hand */
  size_t n, room;
  size_t (*open)[2]; /* parts of it that are to be looked at */
  size_t opens, open_room;
  shortcut *shortcut;
  size_t shortcuts, shortcut_room;
  size_t looked; /* at vertices, since the last question */
} runner;

/* ---- growing arrays ----------------------------------------------------- */

static bool
push_vertex(runner *r, uint32_t v)
{
  bool good = sg_list_grow(&r->vertex, r->n, &r->room, sizeof *r->vertex);

  if (good) {
    r->vertex[r->n++] = v;
  }
  return good;
}

static bool
push_open(runner *r, size_t from, size_t to)
{
  bool good = sg_list_grow(&r->open, r->opens, &r->open_room, sizeof *r->open);

  if (good) {
    r->open[r->opens][0] = from;
    r->open[r->opens++][1] = to;
  }
  return good;
}

static bool
push_shortcut(runner *r, uint32_t a, uint32_t b, uint32_t farthest)
{
  bool good = sg_list_grow(&r->shortcut, r->shortcuts, &r->shortcut_room,
                           sizeof *r->shortcut);

  if (good) {
    r->shortcut[r->shortcuts++] =
        (shortcut){a < b ? a : b, a < b ? b : a, farthest};
  }
  return good;
}

/* ---- places ------------------------------------------------------------- */

/* How far v is from the line a-b, squared (from a, if that is no line), and
 * how far along it from a. */
static double
off_line(const sg_merge *m, uint32_t a, uint32_t b, uint32_t v, double *along)
{
  const double *p = sg_merge_at(m, a), *q = sg_merge_at(m, b);
  const double *x = sg_merge_at(m, v);
  double line = 0, product = 0, off = 0;

  for (int k = 0; k < 3; k++) {
    line += (q[k] - p[k]) * (q[k] - p[k]);
    product += (q[k] - p[k]) * (x[k] - p[k]);
  }
  double part = line > 0 ? product / line : 0;
  for (int k = 0; k < 3; k++) {
    double d = x[k] - p[k] - part * (q[k] - p[k]);
    off += d * d;
  }
  *along = part * sqrt(line);
  return off;
}

/* Whether v comes before w in the order of places. */
static bool
is_before(const sg_merge *m, uint32_t v, uint32_t w)
{
  const double *p = sg_merge_at(m, v), *q = sg_merge_at(m, w);

  for (int k = 0; k < 3; k++) {
    if (p[k] != q[k]) {
      return p[k] < q[k];
    }
  }
  return v < w;
}

/* ---- one run ------------------------------------------------------------ */

/* The vertex where the part of a run has to be divided; 0: it is straight, and
 * *farthest the one that is off most. It may turn back by the tolerance, for
 * vertices that are nearer to each other than that have no order. */
static size_t
where_bent(const runner *r, size_t from, size_t to, size_t *farthest)
{
  const sg_merge *m = r->m;
  double most = -1, reached = 0, along, end;
  size_t back = 0;

  off_line(m, r->vertex[from], r->vertex[to], r->vertex[to], &end);
  for (size_t i = from + 1; i < to; i++) {
    double off =
        off_line(m, r->vertex[from], r->vertex[to], r->vertex[i], &along);
    if (!(off <= most)) {
      most = off;
      *farthest = i;
    }
    if (!back &&
        !(along > reached - m->tolerance && along < end + m->tolerance)) {
      back = i;
    }
    reached = along > reached ? along : reached;
  }
  return !(most <= m->tolerance * m->tolerance) ? *farthest : back;
}

/* Keeps the vertices at which r->open is to be divided, drops the others. */
static bool
straighten(runner *r)
{
  while (r->opens > 0) {
    size_t from = r->open[--r->opens][0], to = r->open[r->opens][1];
    size_t farthest = from, bend;
    if (to - from < 2) {
      continue;
    }
    bend = where_bent(r, from, to, &farthest);
    if (bend) {
      r->m->fate[r->vertex[bend]] = SG_KEPT;
      if (!push_open(r, from, bend) || !push_open(r, bend, to)) {
        return false;
      }
      continue;
    }
    for (size_t i = from + 1; i < to; i++) {
      r->m->fate[r->vertex[i]] = SG_DROPPED;
    }
    if (!push_shortcut(r, r->vertex[from], r->vertex[to],
                       r->vertex[farthest])) {
      return false;
    }
  }
  return true;
}

static void
reverse(runner *r)
{
  for (size_t i = 0, j = r->n - 1; i < j; i++, j--) {
    uint32_t kept = r->vertex[i];
    r->vertex[i] = r->vertex[j];
    r->vertex[j] = kept;
  }
}

/* The vertex of a ring that is farthest from its first (`to` 0) or from the
 * line from there to another. */
static size_t
farthest_of_ring(const runner *r, size_t to)
{
  size_t farthest = to == 1 ? 2 : 1;
  double most = -1, along;

  for (size_t i = 1; i + 1 < r->n; i++) {
    double off =
        off_line(r->m, r->vertex[0], r->vertex[to], r->vertex[i], &along);
    if (i != to && off > most) {
      most = off;
      farthest = i;
    }
  }
  return farthest;
}

/* A ring, its first vertex being the last too, keeps three vertices. */
static bool
straighten_ring(runner *r)
{
  if (r->n < 5) { /* a triangle, or less */
    for (size_t i = 0; i < r->n; i++) {
      r->m->fate[r->vertex[i]] = SG_KEPT;
    }
    return true;
  }
  size_t a = farthest_of_ring(r, 0), b = farthest_of_ring(r, a);
  size_t low = a < b ? a : b, high = a < b ? b : a;
  r->m->fate[r->vertex[0]] = SG_KEPT;
  r->m->fate[r->vertex[low]] = SG_KEPT;
  r->m->fate[r->vertex[high]] = SG_KEPT;
  return push_open(r, 0, low) && push_open(r, low, high) &&
         push_open(r, high, r->n - 1) && straighten(r);
}

/* ---- all runs ----------------------------------------------------------- */

static uint32_t
after(const sg_merge *m, uint32_t v, uint32_t before)
{
  return m->adjacent[v][0] == before ? m->adjacent[v][1] : m->adjacent[v][0];
}

/* Lists the run through v from one end to the other, or once round. */
static bool
find_run(runner *r, uint32_t v)
{
  const sg_merge *m = r->m;
  uint32_t end = v, before = m->adjacent[v][1], least = v, next;

  while (m->fate[end] == SG_STRAIGHT) { /* to an end of it */
    next = after(m, end, before);
    before = end;
    end = next;
    if (end == v) {
      break;
    }
    if (m->fate[end] == SG_STRAIGHT && is_before(m, end, least)) {
      least = end;
    }
  }
  r->n = 0;
  if (m->fate[end] == SG_STRAIGHT) { /* a ring */
    end = least;
    before = is_before(m, m->adjacent[end][0], m->adjacent[end][1])
                 ? m->adjacent[end][0]
                 : m->adjacent[end][1];
  }
  uint32_t at = before, from = end;
  if (!push_vertex(r, end)) {
    return false;
  }
  while (at != end && m->fate[at] == SG_STRAIGHT) {
    if (!push_vertex(r, at)) {
      return false;
    }
    next = after(m, at, from);
    from = at;
    at = next;
  }
  return push_vertex(r, at);
}

static bool
do_run(runner *r, uint32_t v)
{
  if (!find_run(r, v)) {
    return false;
  }
  r->looked += r->n;
  r->opens = 0;
  if (r->vertex[0] == r->vertex[r->n - 1]) {
    if (is_before(r->m, r->vertex[r->n - 2], r->vertex[1])) {
      reverse(r);
    }
    return straighten_ring(r);
  }
  if (is_before(r->m, r->vertex[r->n - 1], r->vertex[0])) {
    reverse(r);
  }
  return push_open(r, 0, r->n - 1) && straighten(r);
}

/* There is an edge from a to b already. */
static bool
is_edge(const sg_merge *m, uint32_t a, uint32_t b)
{
  for (uint32_t i = m->first[a]; i < m->first[a + 1]; i++) {
    if (m->leaving[i].to == b && sg_half_is_border(m, m->leaving[i].half)) {
      return true;
    }
  }
  return false;
}

SG_ORDER(compare_shortcuts, shortcut, SG_BY(low) SG_BY(high));

/* Two edges that become one would be an edge of four faces: each of them keeps
 * a vertex. */
static void
keep_apart(runner *r)
{
  shortcut *list = r->shortcut;

  if (r->shortcuts) {
    qsort(list, r->shortcuts, sizeof *list, compare_shortcuts);
  }
  for (size_t i = 0; i < r->shortcuts; i++) {
    bool twice = (i > 0 && compare_shortcuts(&list[i - 1], &list[i]) == 0) ||
                 (i + 1 < r->shortcuts &&
                  compare_shortcuts(&list[i], &list[i + 1]) == 0);
    if (twice || is_edge(r->m, list[i].low, list[i].high) ||
        is_edge(r->m, list[i].high, list[i].low)) {
      r->m->fate[list[i].farthest] = SG_KEPT;
    }
  }
}

static sg_merge_end
do_runs(runner *r)
{
  sg_merge *m = r->m;

  for (uint32_t v = 0; v < m->solid->vertices; v++) {
    if (m->fate[v] == SG_STRAIGHT && !do_run(r, v)) {
      return SG_MERGE_NO_MEMORY;
    }
    if (++r->looked >= OFTEN) {
      r->looked = 0;
      if (sg_cancelled(m->options->cancel)) {
        return SG_MERGE_STOPPED;
      }
    }
  }
  keep_apart(r);
  return SG_MERGE_DONE;
}

sg_merge_end
sg_merge_runs(sg_merge *m)
{
  runner runs = {.m = m};
  sg_merge_end end = do_runs(&runs);

  free(runs.vertex);
  free(runs.open);
  free(runs.shortcut);
  return end;
}
