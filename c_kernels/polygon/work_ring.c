/* work_ring.c -- the nearest vertices that may be the third one of an edge: see
 * work_private.h.
 *
 * Layer: kernel. A tree of vertices. What is left out certainly makes no
 * triangle with the edge: it is not on its left, or behind an edge that was in
 * the way of other vertices. Who asks decides exactly.
 */
#include "work_private.h"

#include <stdlib.h>
#include <string.h>

/* All vertices of the grid of ends. False: no memory. */
static bool
plant_ends(sg_work *work)
{
  size_t n = 0;
  int32_t *number = malloc(((size_t)work->vertices + 1) * sizeof *number);
  sg_work_box *box = malloc(((size_t)work->vertices + 1) * sizeof *box);

  if (!number || !box) {
    free(number);
    free(box);
    return false;
  }
  work->rounded = false;
  for (int32_t v = 0; v < work->vertices; v++) {
    const double *at = work->vertex[v].at;

    if (sg_work_has_edges(work, v)) {
      box[n] = (sg_work_box){{at[0], at[1]}, {at[0], at[1]}, {0}, {0}};
      sg_work_grid_cell(&work->ends, at, box[n].first);
      memcpy(box[n].last, box[n].first, sizeof box[n].last);
      number[n++] = v;
      work->rounded = work->rounded || work->vertex[v].point.exactly;
    }
  }
  work->planted = sg_work_tree_open(&work->places, number, box, NULL, n, false);
  if (!work->planted) {
    sg_work_tree_close(&work->places);
  }
  return work->planted;
}

void
sg_work_places_clear(sg_work *work)
{
  sg_work_tree_close(&work->places);
  work->planted = false;
}

/* ---- what is behind an edge --------------------------------------------- */

/* What is right of all lines, from[i] to to[i], has an edge before it. */
typedef struct shadow {
  const double *from[3], *to[3];
  int lines;
} shadow;

enum { SHADOWS = 2 * SG_WORK_BLOCKERS };

typedef struct ring_search {
  const sg_work *work;
  const sg_work_ring *ring;
  shadow shadow[SHADOWS];
  int shadows;
  int32_t from, best;
} ring_search;

static void
add_line(const sg_work *work, shadow *of, int32_t from, int32_t to)
{
  of->from[of->lines] = work->vertex[from].at;
  of->to[of->lines++] = work->vertex[to].at;
}

/* An edge x-y crosses what is seen from v, beyond it. */
static void
add_beyond(ring_search *s, int32_t v, int32_t x, int32_t y)
{
  int turn = sg_work_turn(s->work, v, x, y);
  shadow *of = &s->shadow[s->shadows];

  if (turn != 0) {
    *of = (shadow){.lines = 0};
    add_line(s->work, of, turn > 0 ? x : y, v);
    add_line(s->work, of, v, turn > 0 ? y : x);
    add_line(s->work, of, turn > 0 ? x : y, turn > 0 ? y : x);
    s->shadows++;
  }
}

/* An edge from an end of v1-v2 to `to` goes into each triangle that lies round
 * it. */
static void
add_beside(ring_search *s, int32_t at, int32_t to)
{
  const sg_work_ring *ring = s->ring;
  shadow *of = &s->shadow[s->shadows];

  if (sg_work_turn(s->work, ring->v1, ring->v2, to) > 0) {
    *of = (shadow){.lines = 0};
    add_line(s->work, of, at == ring->v1 ? to : at, at == ring->v1 ? at : to);
    s->shadows++;
  }
}

static void
add_shadows(ring_search *s, int32_t e)
{
  const sg_work_edge *edge = &s->work->edge[e].edge;
  int32_t x = edge->start, y = edge->end, end[2] = {s->ring->v1, s->ring->v2};

  for (int i = 0; i < 2; i++) {
    int32_t v = end[i];

    if (v != x && v != y) {
      add_beyond(s, v, x, y);
    } else if (end[!i] != x && end[!i] != y) {
      add_beside(s, v, v == x ? y : x);
    }
  }
}

static bool
is_in_shadow(const ring_search *s, const sg_work_box *box)
{
  for (int i = 0; i < s->shadows; i++) {
    const shadow *of = &s->shadow[i];
    int line = 0;

    while (line < of->lines &&
           sg_work_right_of(of->from[line], of->to[line], box)) {
      line++;
    }
    if (line == of->lines) {
      return true;
    }
  }
  return false;
}

/* ---- rings -------------------------------------------------------------- */

static int32_t
farther(int32_t a, int32_t b)
{
  return a > b ? a : b;
}

/* No vertex there is left of v1-v2. */
static bool
is_on_right(const ring_search *s, const sg_work_box *box)
{
  const double *p = s->work->vertex[s->ring->v1].at;
  const double *q = s->work->vertex[s->ring->v2].at;
  const double corner[2] = {q[1] > p[1] ? box->low[0] : box->high[0],
                            q[0] > p[0] ? box->high[1] : box->low[1]};

  return s->work->rounded ? sg_work_right_of(p, q, box)
                          : sg_orient2d(p, q, corner) <= 0;
}

/* The first ring that a box is in. */
static int32_t
first_ring(const void *data, const sg_work_box *box)
{
  const int32_t *centre = ((const ring_search *)data)->ring->centre;
  int32_t nearest = 0;

  for (int k = 0; k < 2; k++) {
    nearest = farther(
        nearest, farther(box->first[k] - centre[k], centre[k] - box->last[k]));
  }
  return nearest;
}

static int32_t
last_ring(const ring_search *s, const sg_work_box *box)
{
  const int32_t *centre = s->ring->centre;
  int32_t farthest = 0;

  for (int k = 0; k < 2; k++) {
    farthest = farther(
        farthest, farther(centre[k] - box->first[k], box->last[k] - centre[k]));
  }
  return farthest;
}

/* No vertex there can be a third one; or none is in the rings asked for. */
static bool
is_no_ring(const void *data, const sg_work_box *box)
{
  const ring_search *s = data;

  return !sg_work_step(s->work, 1) || first_ring(s, box) > s->best ||
         last_ring(s, box) < s->from || is_on_right(s, box) ||
         is_in_shadow(s, box);
}

static bool
note_ring(void *data, int32_t v)
{
  ring_search *s = data;
  const sg_work_ring *of = s->ring;
  int32_t cell[2];

  if (sg_work_has_edges(s->work, v) && v != of->v1 && v != of->v2) {
    sg_work_grid_cell(&s->work->ends, s->work->vertex[v].at, cell);
    int32_t x = abs(cell[0] - of->centre[0]), y = abs(cell[1] - of->centre[1]);
    int32_t ring = farther(x, y);

    if (ring >= s->from && ring <= s->best) {
      bool nearer = ring < s->best;

      s->best = ring;
      return !of->found(of->data, v, nearer);
    }
  }
  return false;
}

bool
sg_work_next_ring(sg_work *work, const sg_work_ring *of, int32_t *ring)
{
  if (!work->planted && !plant_ends(work)) {
    return false;
  }
  ring_search s = {.work = work, .ring = of, .from = *ring, .best = INT32_MAX};

  for (int i = 0; i < of->blockers; i++) {
    add_shadows(&s, of->blocker[i]);
  }
  sg_work_tree_go(&(sg_work_tree_walk){.tree = &work->places,
                                       .far = first_ring,
                                       .skips = is_no_ring,
                                       .ends = note_ring,
                                       .data = &s,
                                       .none = SG_WORK_NONE});
  *ring = s.best;
  return true;
}
