/* resolve_point.c -- making things touch: shared points, where they are in
 * each segment, and the seams between them. See resolve.h. */
#include "engine/search.h"
#include "number/vector.h"
#include "resolve.h"

#include "rows/sort.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define COMPARE(x, y) ((x) < (y) ? -1 : (x) > (y) ? 1 : 0)

/* ---- signals ---- */

enum { ASKED = 1 << 13 }; /* steps between questions */

/* Whether to stop; to be asked at each step of a long loop. */
static bool
is_stopped(sg_resolve *r)
{
  if (++r->steps % ASKED == 0 && sg_cancelled(r->cancel)) {
    r->stopped = true;
  }
  return r->stopped;
}

/* False: no memory, or stopped. */
static bool
sort(sg_resolve *r, void *item, size_t n, size_t size, sg_sort_compare *compare)
{
  sg_sort_end end = sg_sort(item, n, size, compare, r->cancel);

  r->stopped = r->stopped || end == SG_SORT_STOPPED;
  return end == SG_SORTED;
}

#define SORT(r, list, compare)                                                 \
  sort(r, (list).item, (list).n, sizeof *(list).item, compare)

/* ---- clusters of nodes ---- */

static uint32_t
root(const sg_resolve *r, uint32_t node)
{
  while (r->node.item[node].root != node) {
    node = r->node.item[node].root;
  }
  return node;
}

/* Two vertices of one segment do not become one, unless they are in one place
 * already. */
static bool
may_unite(const sg_resolve *r, uint32_t a, uint32_t b)
{
  const sg_resolve_node *node = r->node.item;
  uint32_t i = a;

  do {
    uint32_t j = b;
    do {
      if (node[i].v && node[j].v && node[i].s == node[j].s &&
          memcmp(node[i].at, node[j].at, sizeof node[i].at) != 0) {
        return false;
      }
      j = node[j].next;
    } while (j != b);
    i = node[i].next;
  } while (i != a);
  return true;
}

static void
unite(sg_resolve *r, uint32_t a, uint32_t b)
{
  sg_resolve_node *node = r->node.item;

  a = root(r, a);
  b = root(r, b);
  if (a == b || !may_unite(r, a, b)) {
    return;
  }
  uint32_t next = node[a].next;

  node[a].next = node[b].next;
  node[b].next = next;
  node[a < b ? b : a].root = a < b ? a : b;
}

SG_ORDER(by_apart, struct sg_resolve_join, SG_BY(apart) SG_BY(a) SG_BY(b));

/* Edges first, which have no polygon: p 0. */
SG_ORDER(by_place_on_edge, sg_resolve_touch,
         SG_BY(p) SG_BY(s) SG_BY(v[0]) SG_BY(v[1]) SG_BY(along) SG_BY(node));

static bool
same_edge(const sg_resolve_touch *x, const sg_resolve_touch *y)
{
  return x->p == 0 && y->p == 0 && x->s == y->s && x->v[0] == y->v[0] &&
         x->v[1] == y->v[1];
}

/* Nodes within reach of each other, and next to each other on an edge, are one
 * point. */
static bool
unite_all(sg_resolve *r)
{
  if (!SORT(r, r->join, by_apart)) {
    return false;
  }
  for (size_t i = 0; i < r->join.n && !is_stopped(r); i++) {
    unite(r, r->join.item[i].a, r->join.item[i].b);
  }
  if (r->stopped || !SORT(r, r->touch, by_place_on_edge)) {
    return false;
  }
  for (size_t i = 1; i < r->touch.n && !is_stopped(r); i++) {
    const sg_resolve_touch *x = &r->touch.item[i - 1], *y = x + 1;
    const sg_resolve_node *a = &r->node.item[x->node];
    const sg_resolve_node *b = &r->node.item[y->node];
    if (same_edge(x, y) &&
        sg_distance(a->at, b->at) <= fmax(a->reach, b->reach)) {
      unite(r, x->node, y->node);
    }
  }
  return !r->stopped;
}

/* ---- points ---- */

/* The member that gives the point its place: the vertex that is first by
 * segment and id, or the first crossing. */
static uint32_t
leader(const sg_resolve *r, uint32_t node)
{
  uint32_t best = node;

  for (uint32_t i = r->node.item[node].next; i != node;
       i = r->node.item[i].next) {
    const sg_resolve_node *x = &r->node.item[i], *y = &r->node.item[best];
    bool first = x->s != y->s   ? x->s < y->s
                 : x->v != y->v ? x->v < y->v
                                : i < best;
    if (!x->v != !y->v ? x->v != 0 : first) {
      best = i;
    }
  }
  return best;
}

static bool
make_points(sg_resolve *r)
{
  for (uint32_t i = 0; i < r->node.n && !is_stopped(r); i++) {
    uint32_t first = root(r, i);
    sg_resolve_node *node = &r->node.item[i];

    if (first == i) {
      sg_resolve_point point = {.node = leader(r, i)};
      memcpy(point.at, r->node.item[point.node].at, sizeof point.at);
      node->point = (uint32_t)r->point.n;
      if (!SG_PUSH(r->point, point)) {
        return false;
      }
    }
    node->point = r->node.item[first].point; /* roots have smaller numbers */
    if (node->v &&
        sg_distance(r->point.item[node->point].at, node->at) > 3 * r->reach) {
      r->wide = node;
    }
  }
  return !r->stopped;
}

/* ---- where they are ---- */

sg_resolve_place *
sg_resolve_place_of(const sg_resolve *r, uint32_t point, int32_t s)
{
  uint32_t key[2] = {point, (uint32_t)s};
  uint32_t number = sg_key_table_get(&r->place_number, key);

  return number == SG_NO_KEY ? NULL : &r->place.item[number];
}

/* The first place of a point in a segment stays. */
static bool
add_place(sg_resolve *r, const sg_resolve_place *place)
{
  uint32_t key[2] = {place->point, (uint32_t)place->s};
  uint32_t *number = sg_key_table_put(&r->place_number, key);

  if (!number || *number != SG_NO_KEY) {
    return number != NULL;
  }
  *number = (uint32_t)r->place.n;
  return SG_PUSH(r->place, *place);
}

/* Edges before faces. */
SG_ORDER(by_nearness, sg_resolve_touch,
         SG_BY_FIRST(x->p != 0, y->p != 0) SG_BY(apart) SG_BY(s) SG_BY(v[0])
             SG_BY(v[1]) SG_BY(p) SG_BY(along) SG_BY(node));

/* Vertices, then edges, then faces. */
SG_ORDER(by_segment, sg_resolve_place,
         SG_BY_FIRST(x->v == 0, y->v == 0) SG_BY_FIRST(x->p != 0, y->p != 0)
             SG_BY(s) SG_BY(v) SG_BY(edge[0]) SG_BY(edge[1]) SG_BY(p)
                 SG_BY(along) SG_BY(point));

/* How far along its edge a node is, where its point is now. */
static double
along_now(const sg_resolve *r, const sg_resolve_touch *touch)
{
  const sg_resolve_node *node = &r->node.item[touch->node];
  const double *to = r->point.item[node->point].at;
  double along = touch->along;

  for (int k = 0; k < 3; k++) {
    along += (to[k] - node->at[k]) * touch->step[k];
  }
  return along;
}

/* In each segment a point is the vertex it has there, else on the nearest
 * edge, else in the nearest face. */
static bool
make_places(sg_resolve *r)
{
  for (size_t i = 0; i < r->node.n && !is_stopped(r); i++) {
    const sg_resolve_node *node = &r->node.item[i];
    sg_resolve_place place = {
        .point = node->point, .s = node->s, .v = node->v, .name = node->v};
    if (node->v && !add_place(r, &place)) {
      return false;
    }
  }
  if (r->stopped || !SORT(r, r->touch, by_nearness)) {
    return false;
  }
  for (size_t i = 0; i < r->touch.n && !is_stopped(r); i++) {
    const sg_resolve_touch *t = &r->touch.item[i];
    sg_resolve_place place = {.point = r->node.item[t->node].point,
                              .s = t->s,
                              .edge = {t->v[0], t->v[1]},
                              .p = t->p,
                              .along = along_now(r, t)};
    if (!add_place(r, &place)) {
      return false;
    }
  }
  if (r->stopped || !SORT(r, r->place, by_segment)) {
    return false;
  }
  for (size_t i = 0; i < r->place.n && !is_stopped(r); i++) {
    const sg_resolve_place *place = &r->place.item[i];
    uint32_t key[2] = {place->point, (uint32_t)place->s};
    *sg_key_table_find(&r->place_number, key) = (uint32_t)i;
  }
  return !r->stopped;
}

uint32_t
sg_resolve_point_of(const sg_resolve *r, int32_t s, int32_t v)
{
  uint32_t key[6] = {(uint32_t)s, (uint32_t)v, 0, 0, 0, 0};
  uint32_t number = sg_key_table_get(&r->node_number, key);

  return number == SG_NO_KEY ? SG_NO_KEY : r->node.item[number].point;
}

/* ---- divided edges ---- */

SG_ORDER(by_edge, sg_resolve_split, SG_BY(s) SG_BY(v[0]) SG_BY(v[1]));

const sg_resolve_split *
sg_resolve_split_of(const sg_resolve *r, int32_t s, int32_t v1, int32_t v2)
{
  sg_resolve_split key = {.s = s, .v = {v1 < v2 ? v1 : v2, v1 < v2 ? v2 : v1}};

  return r->split.n == 0 ? NULL
                         : bsearch(&key, r->split.item, r->split.n,
                                   sizeof *r->split.item, by_edge);
}

static bool
make_splits(sg_resolve *r)
{
  size_t i = 0;

  while (i < r->place.n && r->place.item[i].v) {
    i++;
  }
  while (i < r->place.n && r->place.item[i].p == 0) {
    const sg_resolve_place *first = &r->place.item[i];
    sg_resolve_split split = {
        .s = first->s, .v = {first->edge[0], first->edge[1]}, .first = i};

    for (; i < r->place.n; i++, split.n++) {
      const sg_resolve_place *place = &r->place.item[i];
      if (place->p || place->s != split.s || place->edge[0] != split.v[0] ||
          place->edge[1] != split.v[1]) {
        break;
      }
    }
    if (!SG_PUSH(r->split, split)) {
      return false;
    }
  }
  r->first_inside = i;
  return true;
}

/* ---- seams ---- */

/* A piece of an edge between two shared points. */
typedef struct span {
  int32_t s;
  uint32_t a, b; /* a < b */
} span;

typedef struct spans {
  span *item;
  size_t n, room;
  sg_key_table known; /* s, a, b */
} spans;

static bool
add_span(spans *out, int32_t s, uint32_t a, uint32_t b)
{
  if (a == SG_NO_KEY || b == SG_NO_KEY || a == b) {
    return true;
  }
  span piece = {s, a < b ? a : b, a < b ? b : a};
  uint32_t key[3] = {(uint32_t)s, piece.a, piece.b};
  uint32_t *known = sg_key_table_put(&out->known, key);

  if (!known || *known != SG_NO_KEY) {
    return known != NULL;
  }
  *known = 0;
  return SG_PUSH(*out, piece);
}

static bool
has_span(const spans *in, int32_t s, uint32_t a, uint32_t b)
{
  uint32_t key[3] = {(uint32_t)s, a, b};

  return sg_key_table_get(&in->known, key) != SG_NO_KEY;
}

static bool
find_spans(sg_resolve *r, spans *out)
{
  if (!SORT(r, r->edge, by_edge)) {
    return false;
  }
  for (size_t i = 0; i < r->edge.n && !is_stopped(r); i++) {
    const sg_resolve_split *edge = &r->edge.item[i];
    const sg_resolve_split *split =
        sg_resolve_split_of(r, edge->s, edge->v[0], edge->v[1]);
    uint32_t from = sg_resolve_point_of(r, edge->s, edge->v[0]);

    for (size_t k = 0; split && k < split->n; k++) {
      uint32_t to = r->place.item[split->first + k].point;
      if (!add_span(out, edge->s, from, to)) {
        return false;
      }
      from = to;
    }
    if (!add_span(out, edge->s, from,
                  sg_resolve_point_of(r, edge->s, edge->v[1]))) {
      return false;
    }
  }
  return !r->stopped;
}

SG_ORDER(by_near, sg_resolve_near, SG_BY(n) SG_BY(s) SG_BY(p));

SG_ORDER(by_seam, sg_resolve_seam, SG_BY(s) SG_BY(p) SG_BY(a) SG_BY(b));

/* From nodes to points; each once. */
static bool
near_of_points(sg_resolve *r)
{
  size_t n = 0;

  for (size_t i = 0; i < r->near.n; i++) {
    r->near.item[i].n = r->node.item[r->near.item[i].n].point;
  }
  if (!SORT(r, r->near, by_near)) {
    return false;
  }
  for (size_t i = 0; i < r->near.n; i++) {
    if (n == 0 || by_near(&r->near.item[n - 1], &r->near.item[i]) != 0) {
      r->near.item[n++] = r->near.item[i];
    }
  }
  r->near.n = n;
  return true;
}

static size_t
first_near(const sg_resolve *r, uint32_t point)
{
  size_t at;

  SG_SEARCH(at, 0, r->near.n, r->near.item[at].n < point);
  return at;
}

/* A point of segment s may be on polygon p, as far as its place tells. */
static bool
may_be_on(const sg_resolve *r, uint32_t point, int32_t s, int32_t p)
{
  const sg_resolve_place *place = sg_resolve_place_of(r, point, s);

  return place && (place->p == 0 || place->p == p);
}

/* The span enters every polygon of another segment that both ends are near,
 * unless it is an edge of that segment too. */
static bool
add_seams(sg_resolve *r, const spans *all, const span *piece)
{
  size_t i = first_near(r, piece->a), j = first_near(r, piece->b);
  const sg_resolve_near *near = r->near.item;

  while (i < r->near.n && j < r->near.n && near[i].n == piece->a &&
         near[j].n == piece->b) {
    int order = near[i].s != near[j].s ? COMPARE(near[i].s, near[j].s)
                                       : COMPARE(near[i].p, near[j].p);
    sg_resolve_seam seam = {near[i].s, near[i].p, piece->a, piece->b};

    if (order == 0 && seam.s != piece->s &&
        !has_span(all, seam.s, seam.a, seam.b) &&
        may_be_on(r, seam.a, seam.s, seam.p) &&
        may_be_on(r, seam.b, seam.s, seam.p) && !SG_PUSH(r->seam, seam)) {
      return false;
    }
    i += order <= 0;
    j += order >= 0;
  }
  return true;
}

static bool
make_seams(sg_resolve *r)
{
  spans all = {0};
  size_t n = 0;

  sg_key_table_init(&all.known, 3);
  bool done = find_spans(r, &all) && near_of_points(r);

  for (size_t i = 0; i < all.n && done; i++) {
    done = !is_stopped(r) && add_seams(r, &all, &all.item[i]);
  }
  done = done && SORT(r, r->seam, by_seam);
  for (size_t i = 0; i < r->seam.n && done; i++) {
    if (n == 0 || by_seam(&r->seam.item[n - 1], &r->seam.item[i]) != 0) {
      r->seam.item[n++] = r->seam.item[i];
    }
  }
  r->seam.n = done ? n : 0;
  sg_key_table_clear(&all.known);
  free(all.item);
  return done;
}

sg_resolved
sg_resolve_finish(sg_resolve *r)
{
  if (unite_all(r) && make_points(r) && make_places(r) && make_splits(r) &&
      make_seams(r)) {
    return SG_RESOLVED;
  }
  return r->stopped ? SG_RESOLVE_STOPPED : SG_RESOLVE_NO_MEMORY;
}
