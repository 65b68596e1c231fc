/* star.c -- see star.h.
 *
 * The sphere turns about a pole that is in no plane of an arc. An arc runs from
 * its START to its STOP, which come in this order round the pole, less than
 * half a turn apart. It is above another one that is nearer to the pole.
 */
#include "star.h"

#include "engine/search.h"
#include "number/exact.h"
#include "number/vector.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ASK_EVERY = 1024 };

/* An end of arcs: starts[begin .. begin + starts - 1] begin there. */
typedef struct node {
  const double *at; /* null: none that matters */
  uint32_t end;
  int half; /* of the turn from the first meridian: 0 or 1 */
  size_t begin, starts;
} node;

/* Arc a starts at an end. */
typedef struct start {
  uint32_t end, other, a;
} start;

typedef struct sweep {
  const double *hub;
  double pole[3], first[3];
  const sg_star_arc *arc;
  size_t n, ends;
  bool *crossed;
  unsigned char *from; /* [n] which of its ends it starts at */
  node *node;          /* [ends] by turn, once they are in order */
  start *starts;       /* [begun] by end, equal arcs once */
  size_t begun;
  uint32_t *same;   /* [n] the first arc that has its ends */
  uint32_t *active; /* [n] from below to above, at the meridian at hand */
  size_t actives;
} sweep;

/* ---- the sphere ---- */

/* > 0: b comes after a round the pole, by less than half a turn. */
static int
turn(const sweep *s, const double a[3], const double b[3])
{
  return sg_orient3d(s->hub, s->pole, a, b);
}

static const double *
start_of(const sweep *s, uint32_t a)
{
  return s->arc[a].at[s->from[a]];
}

static const double *
stop_of(const sweep *s, uint32_t a)
{
  return s->arc[a].at[!s->from[a]];
}

static uint32_t
stops_at(const sweep *s, uint32_t a)
{
  return s->arc[a].end[!s->from[a]];
}

/* > 0: p is above the great circle of an arc. */
static int
above(const sweep *s, uint32_t a, const double p[3])
{
  return sg_orient3d(s->hub, start_of(s, a), stop_of(s, a), p);
}

/* Whether arcs may have more in common than one end that both have. */
static bool
cross(const sweep *s, uint32_t a, uint32_t b)
{
  const sg_star_arc *x = &s->arc[a], *y = &s->arc[b];

  for (int i = 0; i < 2; i++) {
    for (int k = 0; k < 2; k++) {
      if (x->end[i] == y->end[k]) {
        return x->end[!i] == y->end[!k] || above(s, a, y->at[!k]) == 0;
      }
    }
  }
  int c = above(s, a, start_of(s, b)), d = above(s, a, stop_of(s, b));
  int e = above(s, b, start_of(s, a)), f = above(s, b, stop_of(s, a));

  return c * d <= 0 && e * f <= 0 && (c != e || c * d * e * f == 0);
}

/* ---- what is active ---- */

static void
take_out(sweep *s, size_t k)
{
  s->actives--;
  memmove(&s->active[k], &s->active[k + 1],
          (s->actives - k) * sizeof *s->active);
}

/* Takes out what is active beside each other and crosses, from places k - 1 and
 * k to end - 1 and end. */
static void
part(sweep *s, size_t k, size_t end)
{
  while (k <= end && k < s->actives) {
    if (k == 0 || !cross(s, s->active[k - 1], s->active[k])) {
      k++;
      continue;
    }
    s->crossed[s->active[k - 1]] = s->crossed[s->active[k]] = true;
    take_out(s, k);
    take_out(s, --k);
    end = end > k + 2 ? end - 2 : k;
  }
}

/* The first active arc that p is not above. */
static size_t
find_place(const sweep *s, const double p[3])
{
  size_t k;

  SG_SEARCH(k, 0, s->actives, above(s, s->active[k], p) > 0);
  return k;
}

/* Puts an arc among active ones that start where it does, from k to end - 1. */
static void
put_in(sweep *s, uint32_t a, size_t k, size_t end)
{
  const double *stop = stop_of(s, a);
  size_t to;

  SG_SEARCH(to, k, end, above(s, s->active[to], stop) > 0);
  memmove(&s->active[to + 1], &s->active[to],
          (s->actives++ - to) * sizeof *s->active);
  s->active[to] = a;
}

/* The sweep comes to a node: what stops there goes, what starts there comes. */
static void
pass(sweep *s, const node *at)
{
  size_t k = find_place(s, at->at), end = k;

  while (k < s->actives && above(s, s->active[k], at->at) == 0) {
    uint32_t a = s->active[k];

    s->crossed[a] = s->crossed[a] || stops_at(s, a) != at->end;
    take_out(s, k);
  }
  for (size_t i = at->begin; i < at->begin + at->starts; i++) {
    if (!s->crossed[s->starts[i].a]) {
      put_in(s, s->starts[i].a, k, end++);
    }
  }
  part(s, k, end);
}

/* ---- in order ---- */

SG_ORDER(by_end, start, SG_BY(end) SG_BY(other) SG_BY(a));

static int
by_turn(const void *x, const void *y, void *data)
{
  const node *a = x, *b = y;
  const sweep *s = data;
  int order = (a->at == NULL) - (b->at == NULL);

  order = order ? order : a->half - b->half;
  order = order || !a->at ? order : -turn(s, a->at, b->at);
  return order ? order : (a->end > b->end) - (a->end < b->end);
}

/* A direction that is hardly ever in a plane of what is there. */
static void
look(const sweep *s, const double way[3], double out[3])
{
  double size = 0;

  for (size_t i = 0; i < s->n; i++) {
    for (int k = 0; k < 3; k++) {
      size = fmax(size, fabs(s->arc[i].at[0][k] - s->hub[k]));
    }
  }
  for (int k = 0; k < 3; k++) {
    out[k] = s->hub[k] + size * way[k];
  }
}

/* Which way arcs run. Those that run to the pole, or have no length, are
 * crossed; equal ones only if they are not to be one. */
static void
direct(sweep *s, bool equal)
{
  for (uint32_t a = 0; a < s->n; a++) {
    const sg_star_arc *x = &s->arc[a];
    int way = turn(s, x->at[0], x->at[1]);

    s->from[a] = way < 0;
    s->crossed[a] = way == 0;
    s->starts[a] = (start){x->end[s->from[a]], x->end[!s->from[a]], a};
  }
  qsort(s->starts, s->n, sizeof *s->starts, by_end);
  for (size_t i = 0; i < s->n; i++) {
    start x = s->starts[i], *last = &s->starts[s->begun - (s->begun > 0)];
    bool known = i > 0 && x.end == last->end && x.other == last->other;

    s->same[x.a] = known ? last->a : x.a;
    s->crossed[last->a] = s->crossed[last->a] || (known && !equal);
    s->starts[s->begun] = x;
    s->begun += !known;
  }
}

static void
find_nodes(sweep *s)
{
  for (uint32_t i = 0; i < s->ends; i++) {
    s->node[i] = (node){.end = i};
  }
  for (size_t i = 0; i < 2 * s->n; i++) {
    const sg_star_arc *x = &s->arc[i / 2];
    s->node[x->end[i % 2]].at = x->at[i % 2];
  }
  for (size_t i = s->begun; i-- > 0;) {
    node *of = &s->node[s->starts[i].end];
    of->begin = i;
    of->starts++;
  }
  for (size_t i = 0; i < s->ends; i++) {
    node *of = &s->node[i];
    int side = of->at ? turn(s, s->first, of->at) : 0;

    of->half = side < 0;
    of->at = side == 0 ? NULL : of->at;
  }
}

/* Arcs with an end that is seen in the direction of another end, or nowhere,
 * are crossed. `lone`: [ends] of no such end. */
static void
keep_lone(sweep *s, const bool *lone)
{
  for (size_t a = 0; a < s->n; a++) {
    s->crossed[a] =
        s->crossed[a] || !lone[s->arc[a].end[0]] || !lone[s->arc[a].end[1]];
  }
}

static bool
at_one_meridian(const sweep *s, size_t i, size_t k)
{
  const node *x = &s->node[i], *y = &s->node[k];

  return x->half == y->half && turn(s, x->at, y->at) == 0;
}

/* Whether nodes at one meridian, which are no more than two, are in different
 * directions. */
static bool
are_two(const sweep *s, size_t begin, size_t end)
{
  return end - begin == 1 ||
         (end - begin == 2 && sg_orient3d(s->hub, s->first, s->node[begin].at,
                                          s->node[begin + 1].at) != 0);
}

static bool
order_nodes(sweep *s)
{
  bool *lone = calloc(s->ends + 1, sizeof *lone);

  if (!lone) {
    return false;
  }
  qsort_r(s->node, s->ends, sizeof *s->node, by_turn, s);
  while (s->ends > 0 && !s->node[s->ends - 1].at) {
    s->ends--;
  }
  for (size_t i = 0; i < s->ends; i++) {
    lone[s->node[i].end] = true;
  }
  for (size_t i = 0, end; i < s->ends; i = end) {
    for (end = i + 1; end < s->ends && at_one_meridian(s, i, end); end++) {
    }
    for (size_t k = i; k < end && !are_two(s, i, end); k++) {
      lone[s->node[k].end] = false;
    }
  }
  keep_lone(s, lone);
  free(lone);
  return true;
}

/* ---- the whole ---- */

/* Round once, and on until all has stopped that was active at the end of that.
 */
static bool
go_round(sweep *s, const sg_cancel *cancel)
{
  for (size_t i = 0; i < 2 * s->ends; i++) {
    const node *at = &s->node[i % s->ends];

    if (i >= s->ends && at->half == 1) {
      break; /* an arc is less than half of a turn */
    }
    if (i % ASK_EVERY == 0 && sg_cancelled(cancel)) {
      return false;
    }
    pass(s, at);
  }
  return true;
}

bool
sg_star_cross(const double hub[3], const sg_star_arc *arc, size_t n,
              size_t ends, bool equal, const sg_cancel *cancel, bool *crossed)
{
  sweep s = {.hub = hub,
             .arc = arc,
             .n = n,
             .ends = ends,
             .crossed = crossed,
             .from = malloc(n + 1),
             .node = malloc((ends + 1) * sizeof *s.node),
             .starts = malloc((n + 1) * sizeof *s.starts),
             .same = malloc((n + 1) * sizeof *s.same),
             .active = malloc((n + 1) * sizeof *s.active)};
  bool good = s.from && s.node && s.starts && s.same && s.active;

  if (good) {
    memset(crossed, 0, n * sizeof *crossed);
    look(&s, (double[3]){0.3717, 0.5923, 0.7141}, s.pole);
    look(&s, (double[3]){0.6113, -0.7309, 0.2937}, s.first);
    direct(&s, equal);
    find_nodes(&s);
    good = order_nodes(&s) && go_round(&s, cancel);
    for (size_t a = 0; a < n; a++) {
      crossed[a] = crossed[s.same[a]];
    }
  }
  free(s.from);
  free(s.node);
  free(s.starts);
  free(s.same);
  free(s.active);
  return good;
}
