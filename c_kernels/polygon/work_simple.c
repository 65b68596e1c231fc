/* work_simple.c -- polygons whose edges meet in shared vertices only: whether
 * one is such, and what is quicker then. See work_private.h.
 *
 * Layer: kernel. Exact. A line sweeps over the picture and keeps the edges it
 * cuts in order; as long as neighbours do not meet, none do (M. I. Shamos and
 * D. Hoey, Geometric intersection problems, 1976). The order is a tree in
 * which every node also knows its neighbours; the ranks that balance it (a
 * treap) are hashes of the edges' handles.
 */
#include "work_private.h"

#include <stdlib.h>
#include <string.h>

/* By edge handle; 0 is none. */
typedef struct node {
  int32_t left, right, up, before, after;
  uint32_t rank;
} node;

typedef struct sweep {
  sg_work *work;
  int32_t *order; /* [vertices]: which place a vertex has */
  node *node;     /* [edges + 1] */
  int32_t root;
  int32_t before, after; /* of the gap where edges ended last */
  bool orderly;
  bool alike;      /* edges with the same two ends count as one */
  int32_t met[2];  /* edges that meet, which ended it */
  int32_t *around; /* [edges + 1]: see sg_work_windings(), or null */
} sweep;

/* ---- the tree ----------------------------------------------------------- */

/* Hangs `child` where `old` hangs. */
static void
replace(sweep *s, int32_t old, int32_t child)
{
  int32_t up = s->node[old].up;

  if (!up) {
    s->root = child;
  } else if (s->node[up].left == old) {
    s->node[up].left = child;
  } else {
    s->node[up].right = child;
  }
  s->node[child].up = up; /* of none too, which is never read */
}

/* Turns e and the node above it. */
static void
rotate_up(sweep *s, int32_t e)
{
  node *n = s->node;
  int32_t up = n[e].up;

  replace(s, up, e);
  if (n[up].left == e) {
    n[up].left = n[e].right;
    n[n[e].right].up = up;
    n[e].right = up;
  } else {
    n[up].right = n[e].left;
    n[n[e].left].up = up;
    n[e].left = up;
  }
  n[up].up = e;
}

static uint32_t
rank_of(int32_t e)
{
  uint32_t h = (uint32_t)e * 2654435769u;

  h = (h ^ (h >> 16)) * 2246822519u;
  return h ^ (h >> 13);
}

/* A leaf under `up`, between its new neighbours. */
static void
hang(sweep *s, int32_t e, int32_t up, int32_t before, int32_t after)
{
  node *n = s->node;

  n[e] = (node){0, 0, up, before, after, rank_of(e)};
  n[before].after = e;
  n[after].before = e;
  if (!up) {
    s->root = e;
  } else if (up == before) {
    n[up].right = e;
  } else {
    n[up].left = e;
  }
  while (n[e].up && n[e].rank < n[n[e].up].rank) {
    rotate_up(s, e);
  }
}

static void
unhang(sweep *s, int32_t e)
{
  node *n = s->node;

  while (n[e].left && n[e].right) {
    rotate_up(s,
              n[n[e].left].rank < n[n[e].right].rank ? n[e].left : n[e].right);
  }
  replace(s, e, n[e].left ? n[e].left : n[e].right);
  n[n[e].before].after = n[e].after;
  n[n[e].after].before = n[e].before;
}

/* ---- the sweep ---------------------------------------------------------- */

static int32_t
first_end(const sweep *s, int32_t e)
{
  const sg_work_edge *edge = &s->work->edge[e].edge;

  return s->order[edge->start] < s->order[edge->end] ? edge->start : edge->end;
}

static int32_t
last_end(const sweep *s, int32_t e)
{
  const sg_work_edge *edge = &s->work->edge[e].edge;

  return s->order[edge->start] < s->order[edge->end] ? edge->end : edge->start;
}

/* The vertex that both edges have, or SG_WORK_NONE; *x and *y are the others.
 */
static int32_t
shared(const sg_work_edge *a, const sg_work_edge *b, int32_t *x, int32_t *y)
{
  bool at_start = a->start == b->start || a->start == b->end;
  int32_t v = at_start ? a->start : a->end;

  *x = at_start ? a->end : a->start;
  *y = b->start == v ? b->end : b->start;
  return b->start == v || b->end == v ? v : SG_WORK_NONE;
}

static bool
apart(sweep *s, int32_t e, int32_t other)
{
  const sg_work_edge *a = &s->work->edge[e].edge,
                     *b = &s->work->edge[other].edge;
  int32_t x, y;

  if (!e || !other) {
    return true;
  }
  int32_t v = shared(a, b, &x, &y);
  if ((v != SG_WORK_NONE && x != y && sg_work_turn(s->work, v, x, y)) ||
      !sg_work_meets(s->work, a->start, a->end, other)) {
    return true;
  }
  s->met[0] = e;
  s->met[1] = other;
  return false;
}

/* The line reaches the first end of e. False: e meets another edge. */
static bool
begin(sweep *s, int32_t e)
{
  int32_t v = first_end(s, e), up = 0, before = 0, after = 0;

  for (int32_t at = s->root; at;) {
    int32_t a = first_end(s, at), b = last_end(s, at);
    int side = sg_work_turn(s->work, a, b, a == v ? last_end(s, e) : v);
    if (side == 0 || !sg_work_step(s->work, 1)) {
      return false; /* they overlap, or v lies on the other; or it ended */
    }
    up = at;
    *(side > 0 ? &before : &after) = at;
    at = side > 0 ? s->node[at].right : s->node[at].left;
  }
  hang(s, e, up, before, after);
  return apart(s, e, before) && apart(s, e, after);
}

/* The line leaves e: its neighbours become neighbours. */
static bool
end(sweep *s, int32_t e)
{
  unhang(s, e);
  s->before = s->node[e].before;
  s->after = s->node[e].after;
  return apart(s, s->before, s->after);
}

/* Where edges with the same two ends count as one: is it this one? */
static bool
stands_alike(const sweep *s, int32_t e)
{
  const sg_work_edge *edge = &s->work->edge[e].edge;

  return sg_work_pair(s->work, edge->start, edge->end) == e &&
         (first_end(s, e) == edge->start ||
          !sg_work_pair(s->work, edge->end, edge->start));
}

/* Of opposite edges one stands for both; false in *simple: there is an edge
 * twice, or from a vertex to itself. */
static bool
stands(sweep *s, int32_t e, bool *simple)
{
  const sg_work_edge *edge = &s->work->edge[e].edge;
  bool opposite = sg_work_pair(s->work, edge->end, edge->start) != 0;

  if (s->alike) {
    return stands_alike(s, e);
  }
  if (edge->start == edge->end ||
      sg_work_pair(s->work, edge->start, edge->end) != e) {
    *simple = false;
  }
  if (opposite) {
    s->orderly = false;
  }
  return !opposite || first_end(s, e) == edge->start;
}

/* What lies between two neighbours is inside of both or outside of both. */
static void
note_order(sweep *s, int32_t before, int32_t after)
{
  bool left =
      before && first_end(s, before) == s->work->edge[before].edge.start;
  bool right = after && first_end(s, after) != s->work->edge[after].edge.start;

  if (left != right) {
    s->orderly = false;
  }
}

/* After all changes at v. */
static void
note_orders(sweep *s, int32_t v)
{
  int32_t last = 0;
  bool begun = false;

  for (int leaving = 0; leaving < 2; leaving++) {
    int32_t e = 0;
    while (s->orderly && (e = leaving ? sg_work_leaving(s->work, v, e)
                                      : sg_work_entering(s->work, v, e)) != 0) {
      if (first_end(s, e) == v) {
        note_order(s, s->node[e].before, e);
        note_order(s, e, s->node[e].after);
        begun = true;
      } else {
        last = e;
      }
    }
  }
  if (last && !begun && s->orderly) {
    note_order(s, s->before, s->after);
  }
}

/* The edges of v that end there, or those that begin there. */
static bool
each_edge(sweep *s, int32_t v, bool ending)
{
  bool simple = true;

  for (int leaving = 0; leaving < 2; leaving++) {
    int32_t e = 0;
    while (simple && (e = leaving ? sg_work_leaving(s->work, v, e)
                                  : sg_work_entering(s->work, v, e)) != 0) {
      if ((last_end(s, e) == v) == ending && stands(s, e, &simple) && simple) {
        simple = ending ? end(s, e) : begin(s, e);
      }
    }
  }
  return simple;
}

/* How many edges there are from a to b. */
static int32_t
count(const sg_work *work, int32_t a, int32_t b)
{
  int32_t first = sg_work_pair(work, a, b), n = 0;

  for (int32_t e = first; e; e = work->edge[e].pair_younger) {
    n++;
    if (work->edge[e].pair_younger == first) {
      break;
    }
  }
  return n;
}

/* The windings beyond the edges that begin at v, which are side by side, from
 * the one before all of them on. */
static void
note_windings(sweep *s, int32_t v)
{
  int32_t e = 0, around;

  for (int leaving = 0; leaving < 2 && !e; leaving++) {
    e = leaving ? s->work->vertex[v].first_out : s->work->vertex[v].first_in;
    while (e && (first_end(s, e) != v || !stands_alike(s, e))) {
      e = leaving ? s->work->edge[e].out_younger : s->work->edge[e].in_younger;
    }
  }
  while (e && s->node[e].before && first_end(s, s->node[e].before) == v) {
    e = s->node[e].before;
  }
  around = e && s->node[e].before ? s->around[s->node[e].before] : 0;
  for (; e && first_end(s, e) == v; e = s->node[e].after) {
    int32_t end = last_end(s, e);

    around += count(s->work, v, end) - count(s->work, end, v);
    s->around[e] = around;
  }
}

/* Over all vertices, in the order of their places. */
static bool
swept(sweep *s, const int32_t *vertex, int32_t n)
{
  int32_t last = SG_WORK_NONE;

  for (int32_t i = 0; i < n; i++) {
    s->order[vertex[i]] = i;
  }
  for (int32_t i = 0; i < n; i++) {
    int32_t v = vertex[i];
    if (!sg_work_has_edges(s->work, v)) {
      continue;
    }
    if ((last != SG_WORK_NONE && sg_work_place(s->work, last, v) == 0) ||
        !each_edge(s, v, true) || !each_edge(s, v, false)) {
      return false;
    }
    if (s->around) {
      note_windings(s, v);
    } else if (!s->alike) {
      note_orders(s, v);
    }
    last = v;
  }
  return true;
}

static bool
sweeps(sweep *s, const int32_t *vertex, int32_t n)
{
  s->order = malloc(((size_t)s->work->vertices + 1) * sizeof *s->order);
  s->node = malloc(((size_t)s->work->edges + 1) * sizeof *s->node);
  bool simple = s->order && s->node && swept(s, vertex, n);

  free(s->order);
  free(s->node);
  return simple;
}

void
sg_work_note_simple(sg_work *work, const int32_t *vertex, int32_t n)
{
  sweep s = {.work = work, .orderly = true};

  work->simple = sweeps(&s, vertex, n) ? SG_SIMPLE : SG_NOT_SIMPLE;
  work->orderly = s.orderly;
}

void
sg_work_note_crossed(sg_work *work, const int32_t *vertex, int32_t n)
{
  sweep s = {.work = work, .alike = true};

  if (!sweeps(&s, vertex, n) && s.met[0] &&
      sg_work_crosses(work, s.met[0], s.met[1])) {
    memcpy(work->crossed, s.met, sizeof work->crossed);
  }
}

bool
sg_work_windings(sg_work *work, const int32_t *vertex, int32_t n,
                 int32_t *around)
{
  sweep s = {.work = work, .alike = true, .around = around};

  return sweeps(&s, vertex, n);
}

bool
sg_work_all_apart(sg_work *work)
{
  return !work->crossed[0] && sg_work_is_simple(work);
}

bool
sg_work_is_simple(sg_work *work)
{
  if (work->simple == SG_NOT_ASKED) {
    int32_t *vertex = malloc(((size_t)work->vertices + 1) * sizeof *vertex);
    work->simple = SG_NOT_SIMPLE;
    if (vertex) {
      sg_work_note_simple(work, vertex, sg_work_by_place(work, vertex));
    }
    free(vertex);
  }
  return work->simple == SG_SIMPLE;
}

/* ---- places ------------------------------------------------------------- */

static int
by_place(const void *a, const void *b, void *work)
{
  int32_t v = *(const int32_t *)a, w = *(const int32_t *)b;
  int order = sg_work_place(work, v, w);

  return order ? order : (v > w) - (v < w);
}

int32_t
sg_work_by_place(sg_work *work, int32_t *out)
{
  int32_t n = 0;

  for (int32_t v = 0; v < work->vertices; v++) {
    if (sg_work_has_edges(work, v)) {
      out[n++] = v;
    }
  }
  qsort_r(out, (size_t)n, sizeof *out, by_place, work);
  return n;
}

/* ---- what is in a triangle ---------------------------------------------- */

/* Why vertices tell all: in a simple relation an edge that meets the triangle,
 * but begins in none of its corners, cannot leave it again, for two of its
 * sides are edges; so an end of it is in the triangle. In an orderly one, of
 * the vertices in the triangle one farthest from the third side has no edge to
 * farther away, so the inside of the polygon goes more than half round it (or
 * goes half round it and more round another at the same distance): reflex. */

/* Of an orderly relation: v is no corner, a convex or a straight one. It will
 * not be reflex later, when triangles have been taken off. */
static bool
is_convex(const sg_work *work, int32_t v)
{
  int32_t in = work->vertex[v].first_in, out = work->vertex[v].first_out;

  if (!in || !out || work->edge[in].in_younger || work->edge[out].out_younger) {
    return !in && !out;
  }
  return sg_work_turn(work, work->edge[in].edge.start, v,
                      work->edge[out].edge.end) >= 0;
}

/* The grid of all vertices that have edges, or of those that are not convex;
 * built anew when most of it is gone. False: no memory. */
static bool
vertices_ready(sg_work *work, sg_work_grid *grid, bool all)
{
  if (grid->open && grid->expected <= 2 * work->living + SG_WORK_FEW) {
    return true;
  }
  sg_work_grid_segment *segment = sg_work_segments(work);
  sg_work_grid_close(grid);
  bool done = segment && sg_work_grid_open(grid, SG_GRID_OF_ENDS, segment,
                                           work->living, sg_work_error(work));
  free(segment);
  for (int32_t v = 0; done && v < work->vertices; v++) {
    if (all ? sg_work_has_edges(work, v) : !is_convex(work, v)) {
      done = sg_work_grid_add_point(grid, v + 1, work->vertex[v].at);
    }
  }
  return done;
}

bool
sg_work_ends_ready(sg_work *work)
{
  bool open = work->ends.open;
  size_t expected = work->ends.expected;
  bool ready = vertices_ready(work, &work->ends, true);

  if (!open || expected != work->ends.expected) { /* they are others */
    sg_work_places_clear(work);
  }
  return ready;
}

/* v is certainly beside the triangle: a cheap question first. */
static bool
beside(const double at[3][2], const double v[2])
{
  for (int k = 0; k < 2; k++) {
    if ((v[k] < at[0][k] && v[k] < at[1][k] && v[k] < at[2][k]) ||
        (v[k] > at[0][k] && v[k] > at[1][k] && v[k] > at[2][k])) {
      return true;
    }
  }
  return false;
}

/* v is in the closed triangle. */
static bool
covers(const sg_work *work, const int32_t corner[3], int32_t v)
{
  return sg_work_turn(work, corner[0], corner[1], v) >= 0 &&
         sg_work_turn(work, corner[1], corner[2], v) >= 0 &&
         sg_work_turn(work, corner[2], corner[0], v) >= 0;
}

/* From corner i the direction to v goes into the closed triangle. */
static bool
goes_in(const sg_work *work, const int32_t corner[3], int i, int32_t v)
{
  return v != corner[(i + 1) % 3] && v != corner[(i + 2) % 3] &&
         sg_work_turn(work, corner[i], corner[(i + 1) % 3], v) >= 0 &&
         sg_work_turn(work, corner[(i + 2) % 3], corner[i], v) >= 0;
}

static bool
edge_goes_in(sg_work *work, const int32_t corner[3], int i)
{
  for (int32_t e = 0; (e = sg_work_leaving(work, corner[i], e)) != 0 &&
                      sg_work_step(work, 1);) {
    work->looked++;
    if (goes_in(work, corner, i, work->edge[e].edge.end)) {
      return true;
    }
  }
  for (int32_t e = 0; (e = sg_work_entering(work, corner[i], e)) != 0 &&
                      sg_work_step(work, 1);) {
    work->looked++;
    if (goes_in(work, corner, i, work->edge[e].edge.start)) {
      return true;
    }
  }
  return false;
}

bool
sg_work_occupied(sg_work *work, const int32_t corner[3], bool *no_memory)
{
  double at[3][2];
  sg_work_grid_walk walk;

  for (int i = 0; i < 3; i++) {
    at[i][0] = work->vertex[corner[i]].at[0];
    at[i][1] = work->vertex[corner[i]].at[1];
    if (edge_goes_in(work, corner, i)) {
      return true;
    }
  }
  if (!vertices_ready(work, &work->tips, !work->orderly)) {
    *no_memory = true;
    return true;
  }
  sg_work_grid_walk_open(&walk, &work->tips, (const double(*)[2])at, 3);
  for (int32_t v;
       (v = sg_work_grid_walk_next(&walk) - 1) >= 0 && sg_work_step(work, 1);) {
    if (!sg_work_has_edges(work, v)) {
      sg_work_grid_walk_drop(&walk);
      continue;
    }
    if (v == corner[0] || v == corner[1] || v == corner[2] ||
        beside((const double(*)[2])at, work->vertex[v].at)) {
      continue;
    }
    work->looked++;
    if (covers(work, corner, v)) {
      return true;
    } else if (work->orderly && is_convex(work, v)) {
      sg_work_grid_walk_drop(&walk);
    }
  }
  return false;
}
