#include "bvh.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  AXIS_BITS = 21,
  DIGIT_BITS = 11,
  DIGITS = 6, /* 6 * 11 >= 3 * 21 */
  BUCKETS = 1 << DIGIT_BITS,
  POLL_EVERY = 1 << 16,
  STEPS_ASKED = 1 << 14
};

/* Nodes are numbered as in a heap: the children of k are 2k and 2k + 1, the
 * root is 1, the leaves are leaves .. 2*leaves - 1. Leaf number g holds the
 * items g*GROUP .. of the Morton order. */
struct sg_bvh {
  size_t n;
  uint32_t leaves; /* a power of two */
  sg_box *node;    /* [2 * leaves] */
  sg_box *box;     /* [n], in Morton order */
  uint32_t *item;  /* [n], in Morton order: whose box it is */
};

typedef struct keyed {
  uint64_t code;
  uint32_t item;
} keyed;

sg_box
sg_box_none(void)
{
  return (sg_box){{INFINITY, INFINITY, INFINITY},
                  {-INFINITY, -INFINITY, -INFINITY}};
}

void
sg_box_add(sg_box *box, const double point[3])
{
  for (int c = 0; c < 3; c++) {
    if (point[c] < box->lo[c]) {
      box->lo[c] = point[c];
    }
    if (point[c] > box->hi[c]) {
      box->hi[c] = point[c];
    }
  }
}

static void
join(sg_box *box, const sg_box *other)
{
  for (int c = 0; c < 3; c++) {
    box->lo[c] = other->lo[c] < box->lo[c] ? other->lo[c] : box->lo[c];
    box->hi[c] = other->hi[c] > box->hi[c] ? other->hi[c] : box->hi[c];
  }
}

static bool
overlap(const sg_box *a, const sg_box *b)
{
  return a->lo[0] <= b->hi[0] && b->lo[0] <= a->hi[0] && a->lo[1] <= b->hi[1] &&
         b->lo[1] <= a->hi[1] && a->lo[2] <= b->hi[2] && b->lo[2] <= a->hi[2];
}

/* The low 21 bits of x, two zeros between each two. */
static uint64_t
spread(uint64_t x)
{
  x &= 0x1fffff;
  x = (x | x << 32) & 0x001f00000000ffff;
  x = (x | x << 16) & 0x001f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  x = (x | x << 2) & 0x1249249249249249;
  return x;
}

/* Where the centre of `box` lies in `all`, as one number. Halved before they
 * are added, so that nothing overflows. */
static uint64_t
morton(const sg_box *box, const sg_box *all)
{
  uint64_t code = 0;

  for (int c = 0; c < 3; c++) {
    double width = 0.5 * all->hi[c] - 0.5 * all->lo[c];
    double centre = 0.5 * box->lo[c] + 0.5 * box->hi[c];
    double part = 0.5 * (centre - all->lo[c]) / width;
    double cells = (double)((1 << AXIS_BITS) - 1);
    uint64_t cell = part > 0.0 ? (uint64_t)(fmin(part, 1.0) * cells) : 0;

    code |= spread(cell) << c;
  }
  return code;
}

/* Stable radix sort of `a` by code; `b` is as long and scratch. Returns the
 * one of the two that holds the result. */
static keyed *
sort_codes(keyed *a, keyed *b, size_t n)
{
  for (unsigned digit = 0; digit < DIGITS; digit++) {
    size_t start[BUCKETS + 1] = {0};
    unsigned shift = digit * DIGIT_BITS;

    for (size_t i = 0; i < n; i++) {
      start[(a[i].code >> shift) % BUCKETS + 1]++;
    }
    for (size_t i = 1; i <= BUCKETS; i++) {
      start[i] += start[i - 1];
    }
    for (size_t i = 0; i < n; i++) {
      b[start[(a[i].code >> shift) % BUCKETS]++] = a[i];
    }
    keyed *sorted = b;
    b = a;
    a = sorted;
  }
  return a;
}

static bool
sort_items(sg_bvh *tree, const sg_box *box, const sg_poll *poll)
{
  size_t n = tree->n;
  keyed *keys = malloc(2 * (n + 1) * sizeof *keys);
  sg_box all = sg_box_none();

  if (!keys) {
    return false;
  }
  for (size_t i = 0; i < n; i++) {
    join(&all, &box[i]);
  }
  for (size_t i = 0; i < n; i++) {
    keys[i] = (keyed){morton(&box[i], &all), (uint32_t)i};
    if (i % POLL_EVERY == 0 && sg_poll_stop(poll)) {
      free(keys);
      return false;
    }
  }
  const keyed *sorted = sort_codes(keys, keys + n, n);

  for (size_t i = 0; i < n; i++) {
    tree->item[i] = sorted[i].item;
    tree->box[i] = box[sorted[i].item];
  }
  free(keys);
  return true;
}

static void
fill_nodes(sg_bvh *tree)
{
  for (size_t i = 0; i < 2 * (size_t)tree->leaves; i++) {
    tree->node[i] = sg_box_none();
  }
  for (size_t i = 0; i < tree->n; i++) {
    join(&tree->node[tree->leaves + i / SG_BVH_GROUP], &tree->box[i]);
  }
  for (size_t k = 2 * (size_t)tree->leaves - 1; k > 1; k--) {
    join(&tree->node[k / 2], &tree->node[k]);
  }
}

sg_bvh *
sg_bvh_open(const sg_box *box, size_t n, const sg_poll *poll)
{
  sg_bvh *tree = calloc(1, sizeof *tree);

  assert(n < UINT32_MAX);
  if (!tree) {
    return NULL;
  }
  tree->n = n;
  tree->leaves = 1;
  while ((size_t)tree->leaves * SG_BVH_GROUP < n) {
    tree->leaves *= 2;
  }
  tree->node = malloc(2 * (size_t)tree->leaves * sizeof *tree->node);
  tree->box = malloc((n + 1) * sizeof *tree->box);
  tree->item = malloc((n + 1) * sizeof *tree->item);
  if (!tree->node || !tree->box || !tree->item ||
      !sort_items(tree, box, poll)) {
    sg_bvh_close(tree);
    return NULL;
  }
  fill_nodes(tree);
  return tree;
}

void
sg_bvh_close(sg_bvh *tree)
{
  if (tree) {
    free(tree->node);
    free(tree->box);
    free(tree->item);
    free(tree);
  }
}

sg_box
sg_bvh_box(const sg_bvh *tree)
{
  return tree->node[1];
}

static void
push(sg_bvh_pairs *pairs, uint32_t a, uint32_t b)
{
  if (overlap(&pairs->a->node[a], &pairs->b->node[b])) {
    assert(pairs->depth < SG_BVH_STACK);
    pairs->stack[pairs->depth][0] = a;
    pairs->stack[pairs->depth][1] = b;
    pairs->depth++;
  }
}

void
sg_bvh_pairs_init(sg_bvh_pairs *pairs, const sg_bvh *a, const sg_bvh *b)
{
  pairs->a = a;
  pairs->b = b;
  pairs->poll = NULL;
  pairs->stopped = false;
  pairs->steps = 0;
  pairs->depth = 0;
  pairs->i = pairs->i_end = 0;
  pairs->j = pairs->j_begin = pairs->j_end = 0;
  push(pairs, 1, 1);
}

static uint32_t
group_begin(const sg_bvh *tree, uint32_t leaf)
{
  size_t begin = (size_t)(leaf - tree->leaves) * SG_BVH_GROUP;

  return (uint32_t)(begin < tree->n ? begin : tree->n);
}

/* Goes down from the pair on top of the stack to the next pair of leaves and
 * puts it in hand. The second of two children is pushed first, so that pairs
 * come in Morton order. */
static bool
next_leaves(sg_bvh_pairs *pairs)
{
  while (pairs->depth > 0) {
    if (++pairs->steps % STEPS_ASKED == 0 && sg_poll_stop(pairs->poll)) {
      pairs->stopped = true;
      return false;
    }
    uint32_t a = pairs->stack[--pairs->depth][0];
    uint32_t b = pairs->stack[pairs->depth][1];
    bool a_leaf = a >= pairs->a->leaves;
    bool b_leaf = b >= pairs->b->leaves;

    if (a_leaf && b_leaf) {
      pairs->i = group_begin(pairs->a, a);
      pairs->i_end = group_begin(pairs->a, a + 1);
      pairs->j_begin = group_begin(pairs->b, b);
      pairs->j_end = group_begin(pairs->b, b + 1);
      pairs->j = pairs->j_begin;
      return true;
    }
    if (b_leaf || (!a_leaf && a <= b)) {
      push(pairs, 2 * a + 1, b);
      push(pairs, 2 * a, b);
    } else {
      push(pairs, a, 2 * b + 1);
      push(pairs, a, 2 * b);
    }
  }
  return false;
}

bool
sg_bvh_pairs_next(sg_bvh_pairs *pairs, size_t *i, size_t *j)
{
  do {
    for (; pairs->i < pairs->i_end; pairs->i++, pairs->j = pairs->j_begin) {
      const sg_box *box = &pairs->a->box[pairs->i];

      while (pairs->j < pairs->j_end) {
        uint32_t k = pairs->j++;

        if (overlap(box, &pairs->b->box[k])) {
          *i = pairs->a->item[pairs->i];
          *j = pairs->b->item[k];
          return true;
        }
      }
    }
  } while (next_leaves(pairs));
  return false;
}
