/* travel.c -- see travel.h
 *
 * The ends are sorted along a curve that keeps what is near together (Morton),
 * and stand, BLOCK by block, under the leaves of a full binary tree. A node
 * knows the box of its ends, the first of them, and how many are left. There
 * may be millions of ends, so what is kept of each is small.
 */
#include "travel.h"

#include "number/bounds.h"
#include "rows/sort.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

enum { BLOCK = 8, ASK_EVERY = 1024 };

typedef struct node {
  int32_t low[2], high[2];
  uint32_t first; /* no end of it comes before this */
  uint32_t left;  /* ends not yet used */
} node;

/* End 2i is the start of line i, 2i + 1 its end. A point is an end along the
 * curve: its code is above its number. */
typedef struct tree {
  const sg_travel_line *line;
  uint64_t *point; /* [2n] */
  uint32_t *place; /* [2n]: of an end, in point */
  bool *used;      /* [2n], of a point */
  node *node;      /* [2 * leaves]: the children of k are 2k and 2k + 1 */
  size_t points, leaves;
} tree;

typedef struct nearest {
  double to[2], way; /* the square of the way: it is only compared */
  uint32_t end;
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
box_add(node *k, const int32_t low[2], const int32_t high[2])
{
  for (int i = 0; i < 2; i++) {
    k->low[i] = low[i] < k->low[i] ? low[i] : k->low[i];
    k->high[i] = high[i] > k->high[i] ? high[i] : k->high[i];
  }
}

static const node empty = {
    {INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN}, UINT32_MAX, 0};

static const int32_t *
end_at(const tree *t, uint32_t end)
{
  return t->line[end / 2].at[end % 2];
}

static uint32_t
point_end(const tree *t, size_t i)
{
  return (uint32_t)t->point[i];
}

static void
set_codes(tree *t)
{
  node all = empty;
  double wide;

  for (uint32_t i = 0; i < t->points; i++) {
    box_add(&all, end_at(t, i), end_at(t, i));
  }
  wide = sg_larger((double)all.high[0] - all.low[0],
                   (double)all.high[1] - all.low[1]);
  for (uint32_t i = 0; i < t->points; i++) {
    uint64_t cell[2] = {0, 0};
    for (int k = 0; k < 2 && wide > 0.0; k++) {
      cell[k] =
          (uint64_t)(((double)end_at(t, i)[k] - all.low[k]) / wide * 0xffff);
    }
    t->point[i] = (spread(cell[0]) | spread(cell[1]) << 1) << 32 | i;
  }
}

static void
set_nodes(tree *t)
{
  for (size_t k = 0; k < 2 * t->leaves; k++) {
    t->node[k] = empty;
  }
  for (size_t i = 0; i < t->points; i++) {
    node *leaf = &t->node[t->leaves + i / BLOCK];
    uint32_t end = point_end(t, i);

    box_add(leaf, end_at(t, end), end_at(t, end));
    leaf->first = end < leaf->first ? end : leaf->first;
    leaf->left++;
    t->place[end] = (uint32_t)i;
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

/* False: no memory. */
static bool
tree_init(tree *t, const sg_travel_line *line, size_t n)
{
  *t = (tree){.line = line, .points = 2 * n, .leaves = 1};
  while (t->leaves * BLOCK < t->points) {
    t->leaves *= 2;
  }
  t->point = malloc((2 * n + 1) * sizeof *t->point);
  if (!t->point) {
    return false;
  }
  set_codes(t);
  if (!sg_sort_upper(t->point, t->points)) {
    return false;
  }
  t->place = malloc((2 * n + 1) * sizeof *t->place);
  t->used = calloc(2 * n + 1, sizeof *t->used);
  t->node = malloc(2 * t->leaves * sizeof *t->node);
  if (!t->place || !t->used || !t->node) {
    return false;
  }
  set_nodes(t);
  return true;
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
    uint32_t end = point_end(t, i);
    const int32_t *at = end_at(t, end);
    double x = at[0] - q->to[0], y = at[1] - q->to[1];
    double way = x * x + y * y;
    if (!t->used[i] && (way < q->way || (way == q->way && end < q->end))) {
      q->way = way;
      q->end = end;
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
take(tree *t, uint32_t end)
{
  size_t i = t->place[end];

  t->used[i] = true;
  for (size_t k = t->leaves + i / BLOCK; k > 0; k /= 2) {
    t->node[k].left--;
  }
}

/* False: stopped. */
static bool
walk(tree *t, size_t n, const int32_t from[2], int32_t *order,
     const sg_cancel *cancel)
{
  nearest q = {{from[0], from[1]}, 0.0, 0};

  for (size_t i = 0; i < n; i++) {
    if (i % ASK_EVERY == 0 && sg_cancelled(cancel)) {
      return false;
    }
    q.way = DBL_MAX;
    q.end = UINT32_MAX;
    search(t, 1, &q);
    int32_t at = (int32_t)(q.end / 2) + 1;
    order[i] = q.end % 2 ? -at : at;
    for (int k = 0; k < 2; k++) {
      q.to[k] = end_at(t, q.end ^ 1)[k];
    }
    take(t, q.end);
    take(t, q.end ^ 1);
  }
  return true;
}

bool
sg_travel_order(const sg_travel_line *line, size_t n, const int32_t from[2],
                int32_t *order, const sg_cancel *cancel, bool *memory)
{
  tree t;
  bool done;

  *memory = tree_init(&t, line, n);
  done = *memory && walk(&t, n, from, order, cancel);
  tree_clear(&t);
  return done;
}

double
sg_travel_length(const sg_travel_line *line, size_t n, const int32_t from[2],
                 const int32_t *order)
{
  const int32_t *at = from;
  double length = 0.0;

  for (size_t i = 0; i < n; i++) {
    bool back = order && order[i] < 0;
    const sg_travel_line *next =
        &line[order ? (order[i] < 0 ? -order[i] : order[i]) - 1 : (int64_t)i];
    double x = (double)next->at[back][0] - at[0];
    double y = (double)next->at[back][1] - at[1];

    length += sqrt(x * x + y * y);
    at = next->at[!back];
  }
  return length;
}
