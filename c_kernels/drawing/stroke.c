/* stroke.c -- see stroke.h */
#include "stroke.h"

#include "engine/list.h"
#include "rows/sort.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The cosine of the sharpest turn of a hidden line (40 degrees), and of a turn
 * that is none (1 degree): straightest/2 of the rule. */
#define SG_TURN     0.766
#define SG_STRAIGHT 0.99985
/* At a node of more ends only those across from each other are paired. */
#define SG_MANY 12

#define NONE UINT32_MAX

enum { ASK_EVERY = 4096, MOST_PARTS = 1 << 30 };

/* Where end `end` is: 2i is the start of part i, 2i + 1 its end. */
typedef struct place {
  int32_t at[2];
  uint32_t end;
} place;

/* An end of the place that is looked at; dx, dy point away from it. The part is
 * of edge e of segment s. */
typedef struct end {
  double dx, dy;
  uint32_t end;
  int32_t s, e;
} end;

typedef struct work {
  const sg_stroke_look *look;
  sg_stroke_part *part;
  size_t n;
  place *places; /* [2n], by place and number */
  SG_LIST_OF(end) ends;
  uint32_t *mate; /* [2n], of an end: another end, or NONE */
  uint8_t *kind;  /* [2n], of an end without a mate: sg_stroke_end */
  bool *used;     /* [n] */
  const sg_cancel *cancel;
  bool memory;
} work;

/* -------------------------------------------------------------- orders */

static int
compare_points(const int32_t a[2], const int32_t b[2])
{
  return a[0] != b[0] ? (a[0] > b[0]) - (a[0] < b[0])
                      : (a[1] > b[1]) - (a[1] < b[1]);
}

static int
compare_numbers(double a, double b)
{
  return (a > b) - (a < b);
}

static int
compare_integers(int64_t a, int64_t b)
{
  return (a > b) - (a < b);
}

/* As Prolog orders the terms of the rule. */
static int
compare_parts(const sg_stroke_part *a, const sg_stroke_part *b)
{
  int order = compare_integers(a->look, b->look);

  order = order ? order : compare_integers(a->s, b->s);
  order = order ? order : compare_integers(a->e, b->e);
  order = order ? order : compare_numbers(a->from, b->from);
  order = order ? order : compare_numbers(a->to, b->to);
  order = order ? order : compare_points(a->a, b->a);
  return order ? order : compare_points(a->b, b->b);
}

static int
compare_places(const sg_stroke_part *a, const sg_stroke_part *b)
{
  int order = compare_integers(a->s, b->s);

  order = order ? order : compare_integers(a->e, b->e);
  order = order ? order : compare_numbers(a->from, b->from);
  return order ? order : compare_parts(a, b);
}

static int
by_edge(const void *a, const void *b)
{
  return compare_places(a, b);
}

/* Of two parts, whichever way they go. */
static int
compare_ends(const sg_stroke_part *a, const sg_stroke_part *b)
{
  bool x = compare_points(a->a, a->b) > 0, y = compare_points(b->a, b->b) > 0;
  int order = compare_points(x ? a->b : a->a, y ? b->b : b->a);

  return order ? order : compare_points(x ? a->a : a->b, y ? b->a : b->b);
}

/* The foremost of those with the same ends comes first. */
static int
by_ends(const void *x, const void *y)
{
  const sg_stroke_part *a = x, *b = y;
  int order = compare_ends(a, b);

  order = order ? order : compare_integers(b->rank, a->rank);
  return order ? order : compare_places(a, b);
}

static int
by_paint(const void *x, const void *y)
{
  const sg_stroke_part *a = x, *b = y;
  int order = compare_integers(a->rank, b->rank);

  order = order ? order : compare_integers(a->look, b->look);
  return order ? order : compare_places(a, b);
}

static bool
sorted(work *w, void *base, size_t n, size_t size, sg_sort_compare *compare)
{
  sg_sort_end how = sg_sort(base, n, size, compare, w->cancel);

  w->memory = how != SG_SORT_NO_MEMORY;
  return how == SG_SORTED;
}

/* -------------------------------------------------- which parts are drawn */

static bool
is_same_group(const sg_stroke_part *a, const sg_stroke_part *b)
{
  return a->look == b->look && a->s == b->s;
}

/* Neighbours of one edge that look alike become one; what has no length goes.
 * Returns how many are left. */
static size_t
join_neighbours(sg_stroke_part *part, size_t n)
{
  size_t out = 0;

  for (size_t i = 0; i < n;) {
    sg_stroke_part whole = part[i++];
    while (i < n && is_same_group(&whole, &part[i]) && whole.e == part[i].e &&
           whole.to == part[i].from) {
      whole.to = part[i].to;
      memcpy(whole.b, part[i++].b, sizeof whole.b);
    }
    if (compare_points(whole.a, whole.b)) {
      part[out++] = whole;
    }
  }
  return out;
}

static size_t
keep_foremost(sg_stroke_part *part, size_t n)
{
  size_t out = 0;

  for (size_t i = 0; i < n; i++) {
    if (!out || compare_ends(&part[out - 1], &part[i])) {
      part[out++] = part[i];
    }
  }
  return out;
}

/* Leaves in w->part what is drawn, in painting order. */
static bool
choose_parts(work *w)
{
  for (size_t i = 0; i < w->n; i++) {
    w->part[i].rank = w->look[w->part[i].look].rank;
  }
  if (!sorted(w, w->part, w->n, sizeof *w->part, by_edge)) {
    return false;
  }
  w->n = join_neighbours(w->part, w->n);
  if (!sorted(w, w->part, w->n, sizeof *w->part, by_ends)) {
    return false;
  }
  w->n = keep_foremost(w->part, w->n);
  return sorted(w, w->part, w->n, sizeof *w->part, by_paint);
}

/* ---------------------------------------------------------------- mates */

/* Two ends that could be mates; bend: the cosine between them, -1 straight. */
typedef struct pair {
  double bend;
  uint32_t a, b;
} pair;

static int
compare_pairs(const void *x, const void *y)
{
  const pair *p = x, *q = y;
  int order = compare_numbers(p->bend, q->bend);

  order = order ? order : (p->a > q->a) - (p->a < q->a);
  return order ? order : (p->b > q->b) - (p->b < q->b);
}

static pair
pair_of(const end *a, const end *b)
{
  return (pair){a->dx * b->dx + a->dy * b->dy, a->end, b->end};
}

static int
by_angle(const void *x, const void *y)
{
  const end *a = x, *b = y;
  int order = compare_numbers(atan2(a->dy, a->dx), atan2(b->dy, b->dx));

  return order ? order : (a->end > b->end) - (a->end < b->end);
}

/* The pairs of m ends of one group at a node; room for SG_MANY squared or m.
 * Reorders the ends if they are many. */
static size_t
node_pairs(end *at, size_t m, pair *out)
{
  size_t n = 0;

  if (m <= SG_MANY) {
    for (size_t i = 0; i < m; i++) {
      for (size_t j = i + 1; j < m; j++) {
        out[n++] = pair_of(&at[i], &at[j]);
      }
    }
  } else {
    qsort(at, m, sizeof *at, by_angle);
    for (; n < m / 2; n++) {
      out[n] = pair_of(&at[n], &at[m / 2 + n]);
    }
  }
  return n;
}

static bool
mate_group(work *w, end *at, size_t m)
{
  bool hidden = w->look[w->part[at->end / 2].look].hidden;
  pair few[SG_MANY * SG_MANY];
  pair *p = m <= SG_MANY ? few : malloc(m * sizeof *p);
  size_t n;

  if (!p) {
    w->memory = false;
    return false;
  }
  n = node_pairs(at, m, p);
  qsort(p, n, sizeof *p, compare_pairs);
  for (size_t i = 0; i < n && (!hidden || -p[i].bend >= SG_TURN); i++) {
    if (w->mate[p[i].a] == NONE && w->mate[p[i].b] == NONE) {
      w->mate[p[i].a] = p[i].b;
      w->mate[p[i].b] = p[i].a;
    }
  }
  if (p != few) {
    free(p);
  }
  return true;
}

static const sg_stroke_part *
part_of(const work *w, const end *a)
{
  return &w->part[a->end / 2];
}

static bool
is_hidden(const work *w, const end *a)
{
  return w->look[part_of(w, a)->look].hidden;
}

/* The end has no mate, but its line goes on. */
static void
mark_cut(work *w, const end *a)
{
  if (w->mate[a->end] == NONE) {
    w->kind[a->end] = SG_END_CUT;
  }
}

static int
by_edge_of_end(const void *x, const void *y)
{
  const end *a = x, *b = y;
  int order = compare_integers(a->s, b->s);

  order = order ? order : compare_integers(a->e, b->e);
  return order ? order : (a->end > b->end) - (a->end < b->end);
}

/* An edge goes on where some of it is visible and some hidden. Reorders the
 * ends. */
static void
same_edges_go_on(work *w, end *at, size_t m)
{
  qsort(at, m, sizeof *at, by_edge_of_end);
  for (size_t i = 0, j; i < m; i = j) {
    size_t hidden = 0;
    for (j = i; j < m && at[j].s == at[i].s && at[j].e == at[i].e; j++) {
      hidden += is_hidden(w, &at[j]);
    }
    for (size_t k = i; k < j && hidden > 0 && hidden < j - i; k++) {
      mark_cut(w, &at[k]);
    }
  }
}

/* The only visible or hidden line of a place goes on as one of the others if
 * that is straight on. */
static bool
goes_straight_on(const work *w, const end *a, const end *b)
{
  const sg_stroke_part *p = part_of(w, a), *q = part_of(w, b);
  bool kin = p->s == q->s && w->look[p->look].role == w->look[q->look].role;

  return is_hidden(w, a) != is_hidden(w, b) &&
         -(a->dx * b->dx + a->dy * b->dy) >= (kin ? SG_TURN : SG_STRAIGHT);
}

/* How the ends of one place end that have no mate. Reorders them. */
static void
node_kinds(work *w, end *at, size_t m)
{
  size_t hidden = 0;

  for (size_t i = 0; i < m; i++) {
    hidden += is_hidden(w, &at[i]);
  }
  if (hidden == 0 || hidden == m) {
    return;
  }
  same_edges_go_on(w, at, m);
  for (size_t i = 0; i < m; i++) {
    bool alone = (is_hidden(w, &at[i]) ? hidden : m - hidden) == 1;
    for (size_t j = 0; alone && j < m; j++) {
      if (goes_straight_on(w, &at[i], &at[j])) {
        mark_cut(w, &at[i]);
      }
    }
  }
}

/* The ends of one place: mates in each group, then how the others end. */
static bool
node(work *w, end *at, size_t m)
{
  for (size_t i = 0, j; i < m; i = j) {
    const sg_stroke_part *part = &w->part[at[i].end / 2];
    for (j = i + 1; j < m && is_same_group(part, &w->part[at[j].end / 2]);
         j++) {
    }
    if (j - i > 1 && !mate_group(w, &at[i], j - i)) {
      return false;
    }
  }
  node_kinds(w, at, m);
  return true;
}

static int
by_place(const void *x, const void *y)
{
  const place *a = x, *b = y;
  int order = compare_points(a->at, b->at);

  return order ? order : (a->end > b->end) - (a->end < b->end);
}

static end
end_of(const work *w, uint32_t e)
{
  const sg_stroke_part *p = &w->part[e / 2];
  double x = (double)p->b[0] - p->a[0], y = (double)p->b[1] - p->a[1];
  double length = e % 2 ? -sqrt(x * x + y * y) : sqrt(x * x + y * y);

  return (end){x / length, y / length, e, p->s, p->e};
}

/* The node of the n places, which are one. */
static bool
node_at(work *w, const place *at, size_t n)
{
  w->ends.n = 0;
  for (size_t i = 0; i < n && w->memory; i++) {
    w->memory = SG_PUSH(w->ends, end_of(w, at[i].end));
  }
  return w->memory && node(w, w->ends.item, n);
}

static bool
sort_places(work *w)
{
  for (size_t i = 0; i < w->n; i++) {
    const sg_stroke_part *p = &w->part[i];
    uint32_t e = 2 * (uint32_t)i;

    w->places[e] = (place){{p->a[0], p->a[1]}, e};
    w->places[e + 1] = (place){{p->b[0], p->b[1]}, e + 1};
    w->mate[e] = w->mate[e + 1] = NONE;
  }
  return sorted(w, w->places, 2 * w->n, sizeof *w->places, by_place);
}

static bool
find_mates(work *w)
{
  if (!sort_places(w)) {
    return false;
  }
  for (size_t i = 0, j, nodes = 0; i < 2 * w->n; i = j) {
    if (nodes++ % ASK_EVERY == 0 && sg_cancelled(w->cancel)) {
      return false;
    }
    for (j = i + 1;
         j < 2 * w->n && !compare_points(w->places[i].at, w->places[j].at);
         j++) {
    }
    if (!node_at(w, &w->places[i], j - i)) {
      return false;
    }
  }
  return true;
}

/* --------------------------------------------------------------- chains */

static const int32_t *
end_point(const work *w, uint32_t e)
{
  const sg_stroke_part *p = &w->part[e / 2];

  return e % 2 ? p->b : p->a;
}

/* The chain that begins with end e. */
static void
chain(work *w, uint32_t e, sg_strokes *out)
{
  sg_stroke *s = &out->item[out->n++];
  uint32_t first = e, last = e;

  s->first = (uint32_t)out->parts;
  for (; e != NONE && !w->used[e / 2]; e = w->mate[last]) {
    w->used[e / 2] = true;
    out->step[out->parts++] =
        e % 2 ? -(int32_t)(e / 2) - 1 : (int32_t)(e / 2) + 1;
    last = e ^ 1;
  }
  s->n = (uint32_t)out->parts - s->first;
  if (compare_points(end_point(w, first), end_point(w, last))) {
    s->start = w->kind[first];
    s->end = w->kind[last];
  } else {
    s->start = s->end = SG_END_RING;
  }
}

/* Chains from every end without a mate, then the rings that are left. */
static void
group_chains(work *w, uint32_t from, uint32_t to, sg_strokes *out)
{
  for (uint32_t e = 2 * from; e < 2 * to; e++) {
    if (!w->used[e / 2] && w->mate[e] == NONE) {
      chain(w, e, out);
    }
  }
  for (uint32_t i = from; i < to; i++) {
    if (!w->used[i]) {
      chain(w, 2 * i, out);
    }
  }
}

static void
all_chains(work *w, sg_strokes *out)
{
  out->n = out->parts = 0;
  out->part = w->part;
  for (size_t i = 0, j; i < w->n; i = j) {
    for (j = i + 1; j < w->n && is_same_group(&w->part[i], &w->part[j]); j++) {
    }
    group_chains(w, (uint32_t)i, (uint32_t)j, out);
  }
}

static bool
find_chains(work *w, sg_strokes *out)
{
  size_t n = w->n;
  bool done;

  w->places = malloc((2 * n + 1) * sizeof *w->places);
  w->mate = malloc((2 * n + 1) * sizeof *w->mate);
  w->kind = calloc(2 * n + 1, sizeof *w->kind);
  w->memory = w->places && w->mate && w->kind;
  done = w->memory && find_mates(w);
  free(w->places);
  w->used = calloc(n + 1, sizeof *w->used);
  out->item = malloc((n + 1) * sizeof *out->item);
  out->step = malloc((n + 1) * sizeof *out->step);
  w->memory = w->memory && w->used && out->item && out->step;
  if (done && w->memory) {
    all_chains(w, out);
  }
  return done && w->memory;
}

bool
sg_strokes_make(sg_stroke_part *part, size_t n, const sg_stroke_look *look,
                const sg_cancel *cancel, sg_strokes *out, bool *memory)
{
  work w = {.look = look,
            .part = part,
            .n = n,
            .cancel = cancel,
            .memory = n <= MOST_PARTS};
  bool done;

  *out = (sg_strokes){0};
  done = w.memory && choose_parts(&w) && find_chains(&w, out);
  if (!done) {
    sg_strokes_clear(out);
  }
  free(w.ends.item);
  free(w.mate);
  free(w.kind);
  free(w.used);
  *memory = w.memory;
  return done;
}

void
sg_strokes_clear(sg_strokes *strokes)
{
  free(strokes->item);
  free(strokes->step);
  *strokes = (sg_strokes){0};
}
