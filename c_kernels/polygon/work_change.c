/* work_change.c -- changes of several edges at once: taking a triangle off
 * (PL-6 step 4 (3)) and resolving contacts. See work.h.
 *
 * Layer: kernel.
 */
#include "work_private.h"

#include <stdlib.h>

/* ---- taking a triangle off ---------------------------------------------- */

static int
add_auxiliary(sg_work *work, int32_t start, int32_t end)
{
  return sg_work_add(work, start, end, 0, 0) ? 1 : -1;
}

int
sg_work_take(sg_work *work, int32_t edge, int32_t v3)
{
  int32_t v1 = work->edge[edge].edge.start, v2 = work->edge[edge].edge.end;
  int32_t second = sg_work_pair(work, v2, v3);
  int32_t third = sg_work_pair(work, v3, v1);

  if ((!second && sg_work_pair(work, v3, v2)) ||
      (!third && sg_work_pair(work, v1, v3))) {
    return 0; /* (3-5) */
  }
  sg_work_delete(work, edge);
  if (second) {
    sg_work_delete(work, second);
  }
  if (third) {
    sg_work_delete(work, third);
  }
  int done = 1; /* (3-1) */
  if (!second) {
    done = add_auxiliary(work, v3, v2); /* (3-3), (3-4) */
  }
  if (!third && done > 0) {
    done = add_auxiliary(work, v1, v3); /* (3-2), (3-4) */
  }
  return done;
}

/* ---- resolving contacts ------------------------------------------------- */

enum { STEPS_A_SPLIT = 64 }; /* for it needs memory */

bool
sg_work_move_edges(sg_work *work, int32_t from, int32_t to)
{
  int32_t e;

  while ((e = work->vertex[from].first_out) != 0) {
    sg_work_edge old = work->edge[e].edge;
    sg_work_delete(work, e);
    if (!sg_work_add(work, to, old.end, old.et, old.label)) {
      return false;
    }
  }
  while ((e = work->vertex[from].first_in) != 0) {
    sg_work_edge old = work->edge[e].edge;
    sg_work_delete(work, e);
    if (!sg_work_add(work, old.start, to, old.et, old.label)) {
      return false;
    }
  }
  return true;
}

/* `vertex` are those with edges, by place. */
static bool
merge_places(sg_work *work, const int32_t *vertex, int32_t n)
{
  int32_t kept = 0;

  for (int32_t i = 1; i < n; i++) {
    if (sg_work_place(work, vertex[kept], vertex[i])) {
      kept = i;
    } else if (!sg_work_move_edges(work, vertex[i], vertex[kept])) {
      return false;
    }
  }
  return true;
}

/* Splits the edges that v lies inside of. */
static bool
split_at(sg_work *work, int32_t v, sg_meetings *found)
{
  sg_work_scan scan;

  found->n = 0;
  if (!sg_work_scan_open(&scan, work, &v, 1)) {
    return false;
  }
  for (int32_t e; (e = sg_work_scan_next(&scan)) != 0;) {
    const sg_work_edge *edge = &work->edge[e].edge;
    if (edge->start != v && edge->end != v && sg_work_near(work, e, v) &&
        sg_work_between(work, edge->start, edge->end, v) &&
        sg_work_step(work, STEPS_A_SPLIT) &&
        !sg_meetings_push(found, &(sg_meeting){.edge = e})) {
      return false;
    }
  }
  sg_meetings_sort(found);
  for (size_t i = 0; i < found->n && sg_work_step(work, 1); i++) {
    if (!sg_work_split(work, found->item[i].edge, v)) {
      return false;
    }
  }
  return true;
}

/* The middle of an edge, exactly. */
static bool
middle(const sg_work *work, const sg_work_edge *edge, sg_point *out)
{
  const sg_point *end[2] = {&work->vertex[edge->start].point,
                            &work->vertex[edge->end].point};
  mpq_t q[3], x;

  mpq_init(x);
  for (int k = 0; k < 3; k++) {
    mpq_init(q[k]);
    for (int i = 0; i < 2; i++) {
      mpq_t *of_end = sg_point_q(end[i]);
      if (of_end) {
        mpq_set(x, of_end[k]);
      } else {
        mpq_set_d(x, end[i]->p[k]);
      }
      mpq_add(q[k], q[k], x);
    }
    mpq_div_2exp(q[k], q[k], 1);
  }
  bool done = sg_point_set_q(out, q[0], q[1], q[2]);
  mpq_clears(q[0], q[1], q[2], x, NULL);
  return done;
}

/* How often the other edges go round the middle of a pair: 0 outside. */
static bool
winding(const sg_work *work, int32_t edge, int32_t opposite, int *out)
{
  int axis = (work->axis + 2) % 3; /* the ray goes along the other one */
  sg_point m;

  *out = 0;
  if (!middle(work, &work->edge[edge].edge, &m)) {
    return false;
  }
  for (int32_t e = work->oldest; e && sg_work_step(work, 1);
       e = work->edge[e].younger) {
    const sg_point *a = &work->vertex[work->edge[e].edge.start].point;
    const sg_point *b = &work->vertex[work->edge[e].edge.end].point;
    if (e == edge || e == opposite) {
      continue;
    }
    bool a_above = sg_point_compare(axis, a, &m) > 0;
    bool b_above = sg_point_compare(axis, b, &m) > 0;
    if (a_above != b_above &&
        sg_point_turn(work->axis, a, b, &m) == (b_above ? 1 : -1)) {
      *out += work->flip * (b_above ? 1 : -1);
    }
  }
  sg_point_clear(&m);
  return true;
}

static int32_t
opposite_of(const sg_work *work, int32_t e)
{
  return sg_work_pair(work, work->edge[e].edge.end, work->edge[e].edge.start);
}

/* Do only pairs of opposite edges meet in v? Then all of them lie in the
 * polygon, or none does. */
static bool
only_pairs(const sg_work *work, int32_t v)
{
  for (int32_t e = 0; (e = sg_work_leaving(work, v, e)) != 0;) {
    if (!opposite_of(work, e)) {
      return false;
    }
  }
  for (int32_t e = 0; (e = sg_work_entering(work, v, e)) != 0;) {
    if (!opposite_of(work, e)) {
      return false;
    }
  }
  return true;
}

/* The same, where it is known already. */
static bool
winding_of(const sg_work *work, const int32_t *windings, int32_t edge,
           int32_t opposite, int *out)
{
  int32_t stands = edge;

  if (windings && windings[edge] == INT32_MIN) {
    stands = opposite;
  }
  if (windings && windings[stands] != INT32_MIN &&
      work->edge[edge].pair_younger == edge &&
      work->edge[opposite].pair_younger == opposite) {
    *out = windings[stands];
    return true;
  }
  return winding(work, edge, opposite, out);
}

/* The pairs that are connected with `first`, one edge of each, marked as seen
 * by this search; returns how many. `out` has room for all edges. A vertex is
 * looked at once: `done` has those. */
static size_t
connected(sg_work *work, int32_t first, int32_t *out, bool *done)
{
  sg_work_edge_row *edge = work->edge;
  size_t n = 0;

  out[n++] = first;
  edge[first].seen = edge[opposite_of(work, first)].seen = work->search;
  for (size_t i = 0; i < n; i++) {
    int32_t end[2] = {edge[out[i]].edge.start, edge[out[i]].edge.end};
    for (int k = 0; k < 2; k++) {
      bool goes_on = !done[end[k]] && only_pairs(work, end[k]);
      int32_t e = goes_on ? work->vertex[end[k]].first_out : 0;
      done[end[k]] = true;
      for (; e; e = edge[e].out_younger) {
        if (edge[e].seen != work->search) {
          edge[e].seen = edge[opposite_of(work, e)].seen = work->search;
          out[n++] = e;
        }
      }
    }
  }
  return n;
}

/* The windings that sg_work_windings() finds, where there are pairs and edges
 * are many; else null. Owner: the caller, free(). */
static int32_t *
find_windings(sg_work *work, const int32_t *vertex, int32_t n)
{
  int32_t *around = NULL, e = work->oldest;

  while (e && !opposite_of(work, e)) {
    e = work->edge[e].younger;
  }
  if (e && work->pairs.open) {
    around = malloc(((size_t)work->edges + 1) * sizeof *around);
  }
  for (e = 0; around && e <= work->edges; e++) {
    around[e] = INT32_MIN;
  }
  if (around && !sg_work_windings(work, vertex, n, around)) {
    free(around);
    around = NULL;
  }
  return around;
}

/* Deletes the pairs of opposite edges outside all others (the polygon lies on
 * neither side): a spike, or a hole that shares an edge with what is round it.
 */
static bool
drop_outer_pairs(sg_work *work, const int32_t *vertex, int32_t vertices)
{
  int32_t *pair = malloc((work->living + 1) * sizeof *pair);
  bool *seen = calloc((size_t)work->vertices + 1, sizeof *seen);
  int32_t *windings = find_windings(work, vertex, vertices);
  bool done = pair && seen;

  work->search++;
  for (int32_t e = 1; done && e <= work->edges; e++) {
    int32_t opposite;
    int around;
    if (!work->edge[e].living || work->edge[e].seen == work->search ||
        !(opposite = opposite_of(work, e))) {
      continue;
    }
    size_t n = connected(work, e, pair, seen);
    done = winding_of(work, windings, e, opposite, &around);
    for (size_t i = 0; done && around == 0 && i < n; i++) {
      int32_t other = opposite_of(work, pair[i]);
      /* An edge may be there twice: both may find the same opposite. */
      if (other && work->edge[pair[i]].living) {
        sg_work_delete(work, pair[i]);
        sg_work_delete(work, other);
      }
    }
  }
  free(pair);
  free(seen);
  free(windings);
  return done;
}

/* Splits every edge at the vertices inside it, unless none is. */
static bool
split_edges(sg_work *work, const int32_t *vertex, int32_t n)
{
  sg_meetings found = {0};
  bool done = true;

  if (work->living > SG_WORK_FEW) {
    sg_work_note_simple(work, vertex, n);
    if (work->simple == SG_SIMPLE) {
      return true;
    }
    sg_work_note_crossed(work, vertex, n);
  }
  for (int32_t v = 0; done && !work->crossed[0] && v < work->vertices; v++) {
    done = !sg_work_has_edges(work, v) || split_at(work, v, &found);
  }
  sg_meetings_clear(&found);
  if (work->living > SG_WORK_FEW && !work->crossed[0]) {
    sg_work_note_crossed(work, vertex, n);
  }
  work->simple = SG_NOT_ASKED;
  return done;
}

bool
sg_work_resolve(sg_work *work, double reach)
{
  int32_t *vertex = malloc(((size_t)work->vertices + 1) * sizeof *vertex);

  work->crossed[0] = work->crossed[1] = 0;
  bool done = vertex && (reach <= 0 || sg_work_join_near(work, reach));

  int32_t n = 0;
  if (done) {
    n = sg_work_by_place(work, vertex);
    done = merge_places(work, vertex, n) && sg_work_pairs_ready(work) &&
           split_edges(work, vertex, n);
  }
  done = done && (work->crossed[0] || drop_outer_pairs(work, vertex, n));
  free(vertex);
  return done;
}

int32_t
sg_work_unbalanced(const sg_work *work)
{
  for (int32_t v = 0; v < work->vertices; v++) {
    int32_t out = work->vertex[v].first_out, in = work->vertex[v].first_in;
    while (out && in) {
      out = work->edge[out].out_younger;
      in = work->edge[in].in_younger;
    }
    if (out || in) {
      return v;
    }
  }
  return SG_WORK_NONE;
}
