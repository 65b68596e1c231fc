#include "edges.h"

#include <math.h>
#include <stdlib.h>

static void *
need(void *memory)
{
  if (!memory) {
    fputs("pattern_checker: no memory\n", stderr);
    exit(2);
  }
  return memory;
}

int *
sets_of(size_t n)
{
  int *sets = need(malloc((n + 1) * sizeof *sets));

  for (size_t i = 0; i <= n; i++) {
    sets[i] = (int)i;
  }
  return sets;
}

int
set_of(int *sets, int item)
{
  while (sets[item] != item) {
    item = sets[item] = sets[sets[item]];
  }
  return item;
}

bool
join_sets(int *sets, int a, int b)
{
  int x = set_of(sets, a), y = set_of(sets, b);

  sets[x] = y;
  return x != y;
}

/* The points a side was between. */
static int
from_of(const pattern *p, const side *s)
{
  return p->spot[s->from].point;
}

static int
to_of(const pattern *p, const side *s)
{
  return p->spot[s->to].point;
}

static real
distance(const pattern *p, int a, int b)
{
  real d[3];

  for (int k = 0; k < 3; k++) {
    d[k] = (real)p->point[b][k] - (real)p->point[a][k];
  }
  return length(d);
}

/* ------------------------------------------------- edges that are not there */

/* A side, or a side turned, by the points it joins. */
typedef struct stretch {
  int from, to, place;
} stretch;

static int
by_ends(const void *a, const void *b)
{
  const stretch *x = a, *y = b;

  return x->from != y->from ? (x->from < y->from ? -1 : 1)
         : x->to != y->to   ? (x->to < y->to ? -1 : 1)
                            : 0;
}

static int
by_edge(const void *a, const void *b)
{
  const stretch *x = a, *y = b;

  return x->place < y->place ? -1 : x->place > y->place;
}

/* True if the n parts of an edge are a way from its start to its end: each
 * point is left as often as it is reached, except for these two. */
static bool
is_whole(const edge *e, const stretch *part, size_t n)
{
  for (size_t i = 0; i < n; i++) {
    int after = part[i].to == e->to, before = part[i].from == e->from;

    for (size_t k = 0; k < n; k++) {
      after += part[k].from == part[i].to;
      before += part[k].to == part[i].from;
    }
    if (after != 1 || before != 1) {
      return false;
    }
  }
  return n > 0;
}

static size_t
lost_edges(const pattern *p)
{
  stretch *part = need(malloc((p->sides + 1) * sizeof *part));
  size_t n = 0, lost = 0, k = 0;

  for (size_t i = 0; i < p->sides; i++) {
    const side *s = &p->side[i];

    if (s->edge != NONE && s->flat != NONE) {
      part[n++] = (stretch){from_of(p, s), to_of(p, s), s->edge};
    }
  }
  qsort(part, n, sizeof *part, by_edge);
  for (size_t i = 0; i < p->edges; i++) {
    const edge *e = &p->edge[i];
    size_t first = k;

    while (k < n && part[k].place == (int)i) {
      k++;
    }
    lost += e->face != NONE && !p->face[e->face].removed &&
            !is_whole(e, part + first, k - first);
  }
  free(part);
  return lost;
}

/* ------------------------------------------------------------- partners */

/* Sides with no joint from one point to another, that others with no joint
 * come back from. */
static void
count_unpaired(const pattern *p, edge_faults *out)
{
  stretch *alone = need(malloc((p->sides + 1) * sizeof *alone));
  size_t n = 0;

  for (size_t i = 0; i < p->sides; i++) {
    const side *s = &p->side[i];

    if (s->flat != NONE && s->joint == NONE) {
      alone[n++] = (stretch){from_of(p, s), to_of(p, s), (int)i};
    }
  }
  qsort(alone, n, sizeof *alone, by_ends);
  for (size_t i = 0; i < n; i++) {
    stretch back = {alone[i].to, alone[i].from, 0};

    if (bsearch(&back, alone, n, sizeof *alone, by_ends)) {
      out->unpaired++;
    } else {
      out->borders++;
    }
  }
  free(alone);
}

static bool
is_match(const pattern *p, const joint *j)
{
  const side *a = &p->side[j->side[0]], *b = &p->side[j->side[1]];

  if (from_of(p, a) != to_of(p, b) || to_of(p, a) != from_of(p, b) ||
      a->flat == NONE || b->flat == NONE || a == b) {
    return false;
  }
  switch (j->kind) {
  case FOLD:
    return a->from == b->to && a->to == b->from && a->flat != b->flat;
  case SEAM:
    return true;
  case LINE:
    return a->flat == b->flat;
  }
  return false;
}

/* How far a polygon reaches from the line of a side, which runs along this unit
 * vector. */
static real
reach(const pattern *p, const flat *f, const side *s, const real along[3])
{
  real most = 0;

  for (size_t i = 0; i < f->count; i++) {
    const side *other = &p->side[p->list[f->first + i]];
    real d[3], n[3];

    for (int k = 0; k < 3; k++) {
      d[k] = (real)p->point[from_of(p, other)][k] - p->point[from_of(p, s)][k];
    }
    cross(d, along, n);
    most = fmaxl(most, length(n));
  }
  return most;
}

/* How far a wrong angle of the joint moves the narrower of its two polygons. */
static real
angle_fault(const pattern *p, const joint *j)
{
  const side *a = &p->side[j->side[0]], *b = &p->side[j->side[1]];
  real na[3], nb[3], n[3], along[3], l, angle, wrong;

  solid_area(p, &p->flat[a->flat], na);
  solid_area(p, &p->flat[b->flat], nb);
  l = distance(p, from_of(p, a), to_of(p, a));
  if (l == 0 || length(na) == 0 || length(nb) == 0) {
    return 0;
  }
  for (int k = 0; k < 3; k++) {
    along[k] =
        ((real)p->point[to_of(p, a)][k] - p->point[from_of(p, a)][k]) / l;
  }
  cross(na, nb, n);
  angle = atan2l(dot(n, along), dot(na, nb));
  wrong = fabsl(angle - (real)j->angle * (acosl(-1) / 180));
  wrong = fminl(wrong, fabsl(2 * acosl(-1) - wrong));
  return wrong * fminl(reach(p, &p->flat[a->flat], a, along),
                       reach(p, &p->flat[b->flat], a, along));
}

static void
check_joints(const pattern *p, edge_faults *out)
{
  for (size_t i = 0; i < p->joints; i++) {
    const joint *j = &p->joint[i];
    const side *a = &p->side[j->side[0]];
    bool matches = is_match(p, j);

    out->mismatch += !matches;
    out->folds += j->kind == FOLD;
    out->seams += j->kind == SEAM;
    out->lines += j->kind == LINE;
    if (j->kind == SEAM) {
      out->seam += distance(p, from_of(p, a), to_of(p, a));
    }
    if (j->kind != LINE && matches) {
      out->angle = fmaxl(out->angle, angle_fault(p, j));
    }
  }
  out->angle /= size_of_solid(p);
}

/* ---------------------------------------------------------------- pieces */

static void
check_pieces(const pattern *p, edge_faults *out)
{
  int *sets = sets_of(p->flats);
  int *first = need(calloc((size_t)p->pieces + 1, sizeof *first));

  for (size_t i = 0; i < p->joints; i++) {
    const joint *j = &p->joint[i];
    int a = p->side[j->side[0]].flat, b = p->side[j->side[1]].flat;

    if (j->kind == FOLD && a != NONE && b != NONE) {
      join_sets(sets, a, b);
      out->cut += p->flat[a].piece != p->flat[b].piece;
    }
  }
  for (size_t i = 0; i < p->flats; i++) {
    int k = p->flat[i].piece, set = set_of(sets, (int)i) + 1;

    if (k < 1 || k > p->pieces || (first[k] && first[k] != set)) {
      out->cut++;
    } else {
      first[k] = set;
    }
  }
  for (int k = 1; k <= p->pieces; k++) {
    out->cut += !first[k];
  }
  free(first);
  free(sets);
}

/* ------------------------------------------------------ the shortest tree */

typedef struct weighed {
  real length;
  int edge;
} weighed;

static int
by_length(const void *a, const void *b)
{
  const weighed *x = a, *y = b;

  return x->length < y->length ? -1 : x->length > y->length;
}

static real
shortest_tree(const pattern *p)
{
  weighed *all = need(malloc((p->edges + 1) * sizeof *all));
  int *sets = sets_of(p->points);
  real sum = 0;

  for (size_t i = 0; i < p->edges; i++) {
    all[i] = (weighed){distance(p, p->edge[i].from, p->edge[i].to), (int)i};
  }
  qsort(all, p->edges, sizeof *all, by_length);
  for (size_t i = 0; i < p->edges; i++) {
    const edge *e = &p->edge[all[i].edge];

    sum += join_sets(sets, e->from, e->to) ? all[i].length : 0;
  }
  free(sets);
  free(all);
  return sum;
}

void
check_edges(const pattern *p, edge_faults *out)
{
  *out = (edge_faults){.loose = p->twice};
  for (size_t i = 0; i < p->sides; i++) {
    out->loose += p->side[i].flat == NONE;
  }
  out->lost = lost_edges(p);
  count_unpaired(p, out);
  check_joints(p, out);
  check_pieces(p, out);
  out->tree = shortest_tree(p);
}
