/* travel.c -- see travel.h
 *
 * The ends are sorted along a curve that keeps what is near together (Morton),
 * and stand, BLOCK by block, under the leaves of a full binary tree. A node
 * knows the box of its ends, the first of them, and how many are left.
 */
#include "travel.h"

#include "number/bounds.h"
#include "rows/sort.h"

#include <float.h>
#include <stdlib.h>

enum { BLOCK = 8, ASK_EVERY = 1024 };

typedef struct point {
  double at[2];
  uint64_t code;
  size_t end; /* 2i is the start of line i, 2i + 1 its end */
} point;

typedef struct node {
  double low[2], high[2];
  size_t first; /* no end of it comes before this */
  size_t left;  /* ends not yet used */
} node;

typedef struct tree {
  point *point;  /* [2n], along the curve */
  size_t *place; /* [2n]: of an end, in point */
  bool *used;    /* [2n], of a point */
  node *node;    /* [2 * leaves]: the children of k are 2k and 2k + 1 */
  size_t points, leaves;
} tree;

typedef struct nearest {
  double to[2], way; /* the square of the way: it is only compared */
  size_t end;
} nearest;

/* -------------------------------------------------------------- building */

/* The bits of x, each followed by a zero. */
static uint64_t
spread(uint64_t x)
{
  static const uint64_t mask[] = {
      UINT64_C(0x0000ffff0000ffff), UINT64_C(0x00ff00ff00ff00ff),
      UINT64_C(0x0f0f0f0f0f0f0f0f), UINT64_C(0x3333333333333333),
      UINT64_C(0x5555555555555555)};

  for (unsigned k = 0; k < 5; k++) {
    x = (x | x << (16 >> k)) & mask[k];
  }
  return x;
}

static void
box_add(node *k, const double low[2], const double high[2])
{
  for (int i = 0; i < 2; i++) {
    k->low[i] = sg_smaller(k->low[i], low[i]);
    k->high[i] = sg_larger(k->high[i], high[i]);
  }
}

static const node empty = {
    {DBL_MAX, DBL_MAX}, {-DBL_MAX, -DBL_MAX}, SIZE_MAX, 0};

static void
set_codes(tree *t)
{
  node all = empty;
  double wide;

  for (size_t i = 0; i < t->points; i++) {
    box_add(&all, t->point[i].at, t->point[i].at);
  }
  wide = sg_larger(all.high[0] - all.low[0], all.high[1] - all.low[1]);
  for (size_t i = 0; i < t->points; i++) {
    uint64_t cell[2] = {0, 0};
    for (int k = 0; k < 2 && wide > 0.0; k++) {
      cell[k] = (uint64_t)((t->point[i].at[k] - all.low[k]) / wide * 0xffff);
    }
    t->point[i].code = spread(cell[0]) | spread(cell[1]) << 1;
  }
}

static int
compare_codes(const void *a, const void *b)
{
  const point *x = a, *y = b;

  if (x->code != y->code) {
    return x->code < y->code ? -1 : 1;
  }
  return (x->end > y->end) - (x->end < y->end);
}

static void
set_nodes(tree *t)
{
  for (size_t k = 0; k < 2 * t->leaves; k++) {
    t->node[k] = empty;
  }
  for (size_t i = 0; i < t->points; i++) {
    node *leaf = &t->node[t->leaves + i / BLOCK];
    box_add(leaf, t->point[i].at, t->point[i].at);
    leaf->first = t->point[i].end < leaf->first ? t->point[i].end : leaf->first;
    leaf->left++;
    t->place[t->point[i].end] = i;
  }
  for (size_t k = t->leaves - 1; k > 0; k--) {
    for (size_t child = 2 * k; child <= 2 * k + 1; child++) {
      box_add(&t->node[k], t->node[child].low, t->node[child].high);
      t->node[k].left += t->node[child].left;
      t->node[k].first = t->node[child].first < t->node[k].first
                             ? t->node[child].first
                             : t->node[k].first;
    }
  }
}

static bool
tree_init(tree *t, const sg_travel_line *line, size_t n,
          const sg_cancel *cancel, bool *memory)
{
  sg_sort_end end;

  *t = (tree){.points = 2 * n, .leaves = 1};
  while (t->leaves * BLOCK < t->points) {
    t->leaves *= 2;
  }
  t->point = malloc((2 * n + 1) * sizeof *t->point);
  t->place = malloc((2 * n + 1) * sizeof *t->place);
  t->used = calloc(2 * n + 1, sizeof *t->used);
  t->node = malloc(2 * t->leaves * sizeof *t->node);
  *memory = t->point && t->place && t->used && t->node;
  if (!*memory) {
    return false;
  }
  for (size_t i = 0; i < t->points; i++) {
    const int64_t *at = line[i / 2].at[i % 2];
    t->point[i] = (point){{(double)at[0], (double)at[1]}, 0, i};
  }
  set_codes(t);
  end = sg_sort(t->point, t->points, sizeof *t->point, compare_codes, cancel);
  *memory = end != SG_SORT_NO_MEMORY;
  if (end == SG_SORTED) {
    set_nodes(t);
  }
  return end == SG_SORTED;
}

static void
tree_clear(tree *t)
{
  free(t->point);
  free(t->place);
  free(t->used);
  free(t->node);
}

/* ------------------------------------------------------------- searching */

static double
way_to_box(const nearest *q, const node *k)
{
  double way = 0.0;

  for (int i = 0; i < 2; i++) {
    double d =
        sg_larger(sg_larger(k->low[i] - q->to[i], 0.0), q->to[i] - k->high[i]);
    way += d * d;
  }
  return way;
}

static void
search_leaf(const tree *t, size_t leaf, nearest *q)
{
  size_t i = (leaf - t->leaves) * BLOCK;

  for (size_t stop = i + BLOCK; i < stop && i < t->points; i++) {
    const point *p = &t->point[i];
    double x = p->at[0] - q->to[0], y = p->at[1] - q->to[1];
    double way = x * x + y * y;
    if (!t->used[i] && (way < q->way || (way == q->way && p->end < q->end))) {
      q->way = way;
      q->end = p->end;
    }
  }
}

/* Whether an end of node k may be nearer than the one that was found, or
 * equally near and before it. Many may be in one place. */
static bool
may_have(const tree *t, size_t k, const nearest *q)
{
  const node *of = &t->node[k];
  double way = of->left ? way_to_box(q, of) : DBL_MAX;

  return of->left && (way < q->way || (way == q->way && of->first < q->end));
}

static void
search(const tree *t, size_t k, nearest *q)
{
  if (!may_have(t, k, q)) {
    return;
  }
  if (k >= t->leaves) {
    search_leaf(t, k, q);
    return;
  }
  size_t near = 2 * k, far = 2 * k + 1;
  if (way_to_box(q, &t->node[far]) < way_to_box(q, &t->node[near])) {
    near = far;
    far = 2 * k;
  }
  search(t, near, q);
  search(t, far, q);
}

static void
take(tree *t, size_t end)
{
  size_t i = t->place[end];

  t->used[i] = true;
  for (size_t k = t->leaves + i / BLOCK; k > 0; k /= 2) {
    t->node[k].left--;
  }
}

bool
sg_travel_order(const sg_travel_line *line, size_t n, const int64_t from[2],
                int64_t *order, const sg_cancel *cancel, bool *memory)
{
  nearest q = {{(double)from[0], (double)from[1]}, 0.0, 0};
  tree t;
  bool going = tree_init(&t, line, n, cancel, memory);

  for (size_t i = 0; going && i < n; i++) {
    if (i % ASK_EVERY == 0 && sg_cancelled(cancel)) {
      going = false;
      break;
    }
    q.way = DBL_MAX;
    q.end = SIZE_MAX;
    search(&t, 1, &q);
    size_t at = q.end / 2, other = q.end ^ 1;
    order[i] = q.end % 2 ? -(int64_t)at - 1 : (int64_t)at + 1;
    for (int k = 0; k < 2; k++) {
      q.to[k] = (double)line[at].at[other % 2][k];
    }
    take(&t, q.end);
    take(&t, other);
  }
  tree_clear(&t);
  return going;
}
