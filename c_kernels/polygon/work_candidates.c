/* work_candidates.c -- which third vertices an edge can have: a join of the
 * scratch relation (work.h).
 *
 * Layer: kernel. Exact throughout.
 */
#include "engine/list.h"
#include "engine/search.h"
#include "work_private.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- PL-6 step 4 (II) --------------------------------------------------- */

/* A triangle to the left, counter-clockwise, with its box. */
typedef struct triangle {
  int32_t v[3];
  double low[2], high[2];
} triangle;

static triangle
triangle_of(const sg_work *work, int32_t v1, int32_t v2, int32_t v3)
{
  triangle t = {.v = {v1, v2, v3}};

  for (int k = 0; k < 2; k++) {
    double a = work->vertex[v1].at[k], b = work->vertex[v2].at[k],
           c = work->vertex[v3].at[k];
    t.low[k] = fmin(fmin(a, b), c);
    t.high[k] = fmax(fmax(a, b), c);
  }
  return t;
}

static int
corner_of(const triangle *t, int32_t v)
{
  for (int i = 0; i < 3; i++) {
    if (t->v[i] == v) {
      return i;
    }
  }
  return -1;
}

/* An edge that begins in corner i goes on to `to`: into the closed triangle?
 * It does when `to` is on or between the two sides' directions. */
static bool
enters_from(const sg_work *work, const triangle *t, int i, int32_t to)
{
  return sg_work_turn(work, t->v[i], t->v[(i + 1) % 3], to) >= 0 &&
         sg_work_turn(work, t->v[(i + 2) % 3], t->v[i], to) >= 0;
}

/* Neither end is a corner: convex sets are apart when they are strictly on
 * two sides of a line along one of their sides. */
static bool
meets_triangle(const sg_work *work, const triangle *t, int32_t x, int32_t y)
{
  int sides = 0;

  for (int i = 0; i < 3; i++) {
    int32_t a = t->v[i], b = t->v[(i + 1) % 3];
    if (sg_work_turn(work, a, b, x) < 0 && sg_work_turn(work, a, b, y) < 0) {
      return false;
    }
  }
  for (int i = 0; i < 3; i++) {
    sides += sg_work_turn(work, x, y, t->v[i]);
  }
  return sides != 3 && sides != -3;
}

/* Does an edge meet the closed triangle, other than in a corner that is its
 * own end, or along a side? */
static bool
blocks(const sg_work *work, const triangle *t, int32_t e)
{
  int32_t x = work->edge[e].edge.start, y = work->edge[e].edge.end;
  const double *px = work->vertex[x].at, *py = work->vertex[y].at;

  for (int k = 0; k < 2; k++) {
    if ((px[k] < t->low[k] && py[k] < t->low[k]) ||
        (px[k] > t->high[k] && py[k] > t->high[k])) {
      return false;
    }
  }
  int i = corner_of(t, x), j = corner_of(t, y);
  if (i >= 0) {
    return j < 0 && enters_from(work, t, i, y);
  }
  return j >= 0 ? enters_from(work, t, j, x) : meets_triangle(work, t, x, y);
}

/* ---- candidates --------------------------------------------------------- */

typedef struct sg_near {
  double distance;
  int32_t vertex;
} near;

enum { LEAVING, ENTERING, ANY, AT_END };

void
sg_candidates_open(sg_candidates *walk, sg_work *work, int32_t v1, int32_t v2)
{
  *walk = (sg_candidates){.work = work, .v1 = v1, .v2 = v2, .phase = LEAVING};
}

void
sg_candidates_close(sg_candidates *walk)
{
  free(walk->near);
  walk->near = NULL;
}

typedef struct in_way {
  const sg_work *work;
  const triangle *t;
} in_way;

static bool
edge_blocks(void *data, int32_t e)
{
  const in_way *of = data;

  return blocks(of->work, of->t, e);
}

static void
note_blocker(sg_candidates *walk, int32_t e)
{
  walk->blocker[walk->blocked++ % SG_BLOCKERS] = e;
}

/* No edge is in the way, as the grid or the trees have it. */
static bool
no_edge_blocks(sg_candidates *walk, const triangle *t)
{
  sg_work *work = walk->work;
  sg_work_scan scan;
  int32_t e = 0;

  if (work->living > SG_WORK_FEW && sg_work_looked_far(work)) {
    in_way of = {work, t};

    walk->no_memory |= !sg_work_forest_find(work, t->v, edge_blocks, &of, &e);
  } else if (!sg_work_scan_open(&scan, work, t->v, 3)) {
    walk->no_memory = true;
  } else {
    while ((e = sg_work_scan_next(&scan)) != 0 && !blocks(work, t, e)) {
      work->looked++;
    }
  }
  if (e) {
    note_blocker(walk, e);
  }
  return e == 0 && !walk->no_memory;
}

/* (II): nothing is in the way of the triangle. The edges that were in the way
 * of earlier ones are asked first. */
static bool
is_free(sg_candidates *walk, const int32_t corner[3])
{
  sg_work *work = walk->work;
  triangle t = triangle_of(work, corner[0], corner[1], corner[2]);

  for (int i = 0; i < SG_BLOCKERS && walk->blocker[i]; i++) {
    if (blocks(work, &t, walk->blocker[i])) {
      return false;
    }
  }
  return no_edge_blocks(walk, &t);
}

static bool
any_hub(const sg_work *work, const int32_t corner[3])
{
  return sg_work_is_hub(work, corner[0]) || sg_work_is_hub(work, corner[1]) ||
         sg_work_is_hub(work, corner[2]);
}

/* (I) and (II). In a simple relation it is quicker to see if an ear is free,
 * unless very much hangs on a corner: trees have that by angle. */
static bool
fits(sg_candidates *walk, int32_t v3)
{
  sg_work *work = walk->work;
  int32_t corner[3] = {walk->v1, walk->v2, v3};

  if (sg_work_turn(work, walk->v1, walk->v2, v3) <= 0) {
    return false;
  }
  if (walk->phase != ANY && work->living > SG_WORK_FEW &&
      !(sg_work_looked_far(work) && any_hub(work, corner)) &&
      sg_work_is_simple(work)) {
    if (sg_work_occupied(work, corner, &walk->no_memory)) {
      return false;
    }
  } else if (!is_free(walk, corner)) {
    return false;
  }
  memcpy(work->proven, corner, sizeof corner);
  return true;
}

SG_ORDER(by_distance, near, SG_BY(distance) SG_BY(vertex));

static void
middle(const sg_candidates *walk, double out[2])
{
  const sg_work_vertex_row *v = walk->work->vertex;

  for (int k = 0; k < 2; k++) {
    out[k] = v[walk->v1].at[k] / 2 + v[walk->v2].at[k] / 2;
  }
}

static bool
push_near(sg_candidates *walk, int32_t vertex, const double from[2])
{
  const double *at = walk->work->vertex[vertex].at;

  walk->work->looked++;
  if (!sg_work_step(walk->work, 1)) {
    return false;
  }
  if (!sg_list_grow(&walk->near, walk->n, &walk->room, sizeof *walk->near)) {
    walk->no_memory = true;
    return false;
  }
  walk->near[walk->n++] =
      (near){hypot(at[0] - from[0], at[1] - from[1]), vertex};
  return true;
}

/* The vertices in this cell. */
static bool
collect_cell(sg_candidates *walk, int32_t column, int32_t row,
             const double from[2])
{
  const sg_work_grid *grid = &walk->work->ends;
  size_t cell = (size_t)row * (size_t)grid->cells[0] + (size_t)column;

  for (int32_t i = grid->first[cell]; i; i = grid->entry[i - 1].next) {
    int32_t v = grid->entry[i - 1].number - 1;
    if (sg_work_has_edges(walk->work, v) && !push_near(walk, v, from)) {
      return false;
    }
  }
  return true;
}

/* ---- far rings, by a tree ---- */

typedef struct collecting {
  sg_candidates *walk;
  double from[2];
} collecting;

static bool
collect_nearer(void *data, int32_t v, bool nearer)
{
  collecting *c = data;

  c->walk->n = nearer ? 0 : c->walk->n;
  return push_near(c->walk, v, c->from);
}

/* The edges that hang on an end first or last: one of them is the wall there,
 * mostly. */
static void
add_walls(const sg_work *work, int32_t v, sg_work_ring *of)
{
  const sg_work_vertex_row *row = &work->vertex[v];
  int32_t wall[4] = {row->first_in, row->last_in, row->first_out,
                     row->last_out};

  for (int i = 0; i < 4; i++) {
    if (wall[i]) {
      of->blocker[of->blockers++] = wall[i];
    }
  }
}

/* The vertices of the next ring that has one which may fit; false: there is
 * none, or no memory. */
static bool
collect_far(sg_candidates *walk, const double from[2], const int32_t centre[2])
{
  collecting data = {walk, {from[0], from[1]}};
  sg_work_ring of = {.v1 = walk->v1,
                     .v2 = walk->v2,
                     .centre = {centre[0], centre[1]},
                     .found = collect_nearer,
                     .data = &data};

  add_walls(walk->work, walk->v1, &of);
  add_walls(walk->work, walk->v2, &of);
  for (int i = 0; i < SG_BLOCKERS && walk->blocker[i]; i++) {
    of.blocker[of.blockers++] = walk->blocker[i];
  }
  if (!sg_work_next_ring(walk->work, &of, &walk->ring)) {
    walk->no_memory = true;
  }
  if (walk->no_memory || walk->ring == INT32_MAX) {
    return false;
  }
  walk->ring++;
  return true;
}

/* The vertices of the next ring of cells round the edge's middle; false: no
 * ring touches the grid any more, or no memory. */
static bool
collect_ring(sg_candidates *walk)
{
  const sg_work_grid *grid = &walk->work->ends;
  double from[2];
  int32_t centre[2], r;

  middle(walk, from);
  sg_work_grid_cell(grid, from, centre);
  walk->work->looked++;
  if (sg_work_looked_far(walk->work)) {
    return collect_far(walk, from, centre);
  }
  r = walk->ring++;
  int32_t bottom = centre[1] - r, top = centre[1] + r;
  int32_t left = centre[0] - r, right = centre[0] + r;
  if (bottom < 0 && top >= grid->cells[1] && left < 0 &&
      right >= grid->cells[0]) {
    return false;
  }
  for (int32_t row = bottom < 0 ? 0 : bottom;
       row <= top && row < grid->cells[1]; row++) {
    bool whole = row == bottom || row == top;
    for (int32_t column = left < 0 && whole ? 0 : left; column <= right;
         column += whole || r == 0 ? 1 : 2 * r) {
      if (column >= 0 && column < grid->cells[0] &&
          !collect_cell(walk, column, row, from)) {
        return false;
      }
      if (whole && column >= grid->cells[0]) {
        break;
      }
    }
  }
  return true;
}

/* Is e the edge by which its end `v` is counted? */
static bool
stands_for(const sg_work *work, int32_t e, int32_t v)
{
  const sg_work_vertex_row *row = &work->vertex[v];

  return row->first_out ? row->first_out == e : row->first_in == e;
}

/* All vertices that have edges: when these are few. */
static bool
collect_all(sg_candidates *walk)
{
  const sg_work *work = walk->work;
  double from[2];

  if (walk->ring++) {
    return false;
  }
  middle(walk, from);
  for (int32_t e = work->oldest; e; e = work->edge[e].younger) {
    int32_t end[2] = {work->edge[e].edge.start, work->edge[e].edge.end};
    for (int k = 0; k < 2; k++) {
      if (stands_for(work, e, end[k]) && !push_near(walk, end[k], from)) {
        return false;
      }
    }
  }
  return true;
}

/* The next vertex of any edge, nearest first; SG_WORK_NONE: no more. */
static int32_t
next_of_any(sg_candidates *walk)
{
  bool many = walk->work->living > SG_WORK_FEW;

  if (many && !sg_work_ends_ready(walk->work)) {
    walk->no_memory = true;
    return SG_WORK_NONE;
  }
  while (walk->next == walk->n) {
    walk->next = walk->n = 0;
    if (!(many ? collect_ring(walk) : collect_all(walk))) {
      return SG_WORK_NONE;
    }
    if (walk->n) {
      qsort(walk->near, walk->n, sizeof *walk->near, by_distance);
    }
  }
  return walk->near[walk->next++].vertex;
}

/* The next vertex in the paper's order, each once. */
static int32_t
next_vertex(sg_candidates *walk)
{
  const sg_work *work = walk->work;
  int32_t v1 = walk->v1, v2 = walk->v2;

  while (walk->phase == LEAVING && sg_work_step(work, 1)) {
    walk->edge = sg_work_leaving(work, v2, walk->edge);
    int32_t v = walk->edge ? work->edge[walk->edge].edge.end : 0;
    if (!walk->edge) {
      walk->phase = ENTERING;
    } else if (sg_work_pair(work, v2, v) == walk->edge) { /* not again */
      return v;
    }
  }
  while (walk->phase == ENTERING && sg_work_step(work, 1)) {
    walk->edge = sg_work_entering(work, v1, walk->edge);
    int32_t v = walk->edge ? work->edge[walk->edge].edge.start : 0;
    if (!walk->edge) {
      walk->phase = ANY;
    } else if (!sg_work_pair(work, v2, v) &&
               sg_work_pair(work, v, v1) == walk->edge) {
      return v;
    }
  }
  for (int32_t v;
       sg_work_step(work, 1) && (v = next_of_any(walk)) != SG_WORK_NONE;) {
    if (!sg_work_pair(work, v2, v) && !sg_work_pair(work, v, v1)) {
      return v;
    }
  }
  return SG_WORK_NONE;
}

int32_t
sg_candidates_next(sg_candidates *walk)
{
  if (walk->phase == AT_END) {
    return SG_WORK_NONE;
  }
  for (int32_t v; (v = next_vertex(walk)) != SG_WORK_NONE;) {
    if (v != walk->v1 && v != walk->v2 && fits(walk, v)) {
      return v;
    }
    if (walk->no_memory) {
      break;
    }
  }
  walk->phase = AT_END;
  return SG_WORK_NONE;
}
