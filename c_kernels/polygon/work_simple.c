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

/* In what is no step (a comparison): asks now and then. False: it has ended. */
static bool
polled(const sg_work *work)
{
  sg_work_guard *guard = work->guard;

  if (!guard) {
    return true;
  }
  if (guard->end == SG_GOES_ON &&
      sg_cancel_every(guard->cancel, ++guard->polled)) {
    guard->end = SG_WAS_STOPPED;
    guard->next = 0;
  }
  return guard->end == SG_GOES_ON;
}

static int
by_place(const void *a, const void *b, void *work)
{
  int32_t v = *(const int32_t *)a, w = *(const int32_t *)b;
  int order = polled(work) ? sg_work_place(work, v, w) : 0;

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
