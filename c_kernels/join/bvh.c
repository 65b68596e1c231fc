#include "bvh.h"
#include "engine/search.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  AXIS_BITS = 18,
  GROUP_BITS = 8,
  LOW_BITS = 3 * AXIS_BITS - 32, /* of a code, beside the 32 that are sorted */
  DIGIT_BITS = 11,
  DIGITS = 3, /* 3 * 11 >= 32 */
  BUCKETS = 1 << DIGIT_BITS,
  SHORT = 24,      /* a run that is sorted by insertion */
  BLOCK = 1 << 14, /* items of a task, at least */
  BLOCKS = 256,    /* tasks, at most */
  PART = 256       /* boxes asked for at a time */
};

/* A tree being built; blocks are the tasks. */
typedef struct grower {
  sg_bvh *tree;
  sg_bvh_boxes *boxes; /* one of these two is null */
  sg_bvh_boxes32 *let_out;
  const void *data;
  const uint32_t *name;
  const unsigned char *kind; /* by name, or null */
  size_t block, blocks;
  sg_bvh_frame frame;
  double cells[3];     /* Morton cells in a unit */
  double corner[3];    /* the low corner of everything, in units */
  sg_box32 *box;       /* [n], in the order given */
  uint64_t *code;      /* [n]: where their centres are */
  uint64_t *from, *to; /* [n]: the high half of a code, above an item */
  uint32_t *start;     /* [blocks][BUCKETS] */
  unsigned shift;      /* of the digit at hand */
  unsigned level;      /* being laid */
  size_t group;        /* boxes of that level in a task */
} grower;

/* ---- boxes ---- */

sg_box
sg_box_none(void)
{
  return (sg_box){{INFINITY, INFINITY, INFINITY},
                  {-INFINITY, -INFINITY, -INFINITY}};
}

void
sg_box_join(sg_box *box, const sg_box *other)
{
  for (int c = 0; c < 3; c++) {
    box->lo[c] = other->lo[c] < box->lo[c] ? other->lo[c] : box->lo[c];
    box->hi[c] = other->hi[c] > box->hi[c] ? other->hi[c] : box->hi[c];
  }
}

bool
sg_box_overlap(const sg_box *a, const sg_box *b, double reach)
{
  for (int c = 0; c < 3; c++) {
    if (a->lo[c] - reach > b->hi[c] || b->lo[c] - reach > a->hi[c]) {
      return false;
    }
  }
  return true;
}

/* Outward by 2^-24 of a unit, which is at least what rounding to float32 takes
 * from a number of at most one unit. */
static float
round_down(double d)
{
  return (float)(d - 0x1p-24);
}

static float
round_up(double d)
{
  return (float)(d + 0x1p-24);
}

static void
put_lane(sg_box4 *group, size_t lane, const sg_box32 *box)
{
  for (int c = 0; c < 3; c++) {
    group->lo[c][lane] = box->lo[c];
    group->hi[c][lane] = box->hi[c];
  }
}

/* The box round a group. */
static sg_box32
box_round(const sg_box4 *group)
{
  sg_box32 box;

  for (int c = 0; c < 3; c++) {
    box.lo[c] = group->lo[c][0];
    box.hi[c] = group->hi[c][0];
    for (int k = 1; k < SG_BVH_WIDTH; k++) {
      float lo = group->lo[c][k], hi = group->hi[c][k];
      box.lo[c] = lo < box.lo[c] ? lo : box.lo[c];
      box.hi[c] = hi > box.hi[c] ? hi : box.hi[c];
    }
  }
  return box;
}

static const sg_box32 nothing = {{INFINITY, INFINITY, INFINITY},
                                 {-INFINITY, -INFINITY, -INFINITY}};

/* Groups that hold so many boxes. */
static size_t
groups_of(size_t count)
{
  return (count + SG_BVH_WIDTH - 1) / SG_BVH_WIDTH;
}

/* ---- the frame ---- */

/* The unit is the power of two above the longest half side. */
sg_bvh_frame
sg_bvh_frame_of(const sg_box *all)
{
  sg_bvh_frame frame;
  double half = DBL_MIN;
  int exponent;

  for (int c = 0; c < 3; c++) {
    double side = 0.5 * all->hi[c] - 0.5 * all->lo[c];

    frame.origin[c] = 0.5 * all->hi[c] + 0.5 * all->lo[c];
    half = fmax(half, side);
  }
  frexp(half, &exponent);
  frame.unit = ldexp(1, exponent > 1022 ? 1022 : exponent);
  return frame;
}

sg_box32
sg_box_let_out(const sg_bvh_frame *frame, const sg_box *box)
{
  double units = 1 / frame->unit; /* exact */
  sg_box32 out;

  for (int c = 0; c < 3; c++) {
    out.lo[c] = round_down((box->lo[c] - frame->origin[c]) * units);
    out.hi[c] = round_up((box->hi[c] - frame->origin[c]) * units);
  }
  return out;
}

/* Frame and Morton cells from the box round everything. */
static void
set_frame(grower *g, const sg_box *all)
{
  sg_bvh *tree = g->tree;

  g->frame = sg_bvh_frame_of(all);
  tree->all = *all;
  tree->unit = g->frame.unit;
  for (int c = 0; c < 3; c++) {
    double side = (0.5 * all->hi[c] - 0.5 * all->lo[c]) / tree->unit;

    tree->origin[c] = g->frame.origin[c];
    g->corner[c] = -side;
    g->cells[c] = side > 0 ? 0.5 * ((1 << AXIS_BITS) - 1) / side : 0;
  }
}

/* The low 18 bits of x, two zeros between each two. */
static uint64_t
spread(uint64_t x)
{
  x &= (1 << AXIS_BITS) - 1;
  x = (x | x << 32) & 0x001f00000000ffff;
  x = (x | x << 16) & 0x001f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  x = (x | x << 2) & 0x1249249249249249;
  return x;
}

/* Where the centre of a box lies, as one number. */
static uint64_t
morton(const grower *g, const sg_box32 *box)
{
  const double most = (1 << AXIS_BITS) - 1;
  uint64_t code = 0;

  for (int c = 0; c < 3; c++) {
    double centre = 0.5 * ((double)box->lo[c] + (double)box->hi[c]);
    double cell = (centre - g->corner[c]) * g->cells[c];

    cell = cell < most ? cell : most;
    code |= spread(cell > 0 ? (uint64_t)cell : 0) << c;
  }
  return code;
}

/* The same, below the group of the item. */
static uint64_t
code_of(const grower *g, size_t i)
{
  uint64_t code = morton(g, &g->box[i]);

  return g->kind ? (uint64_t)g->kind[g->name ? g->name[i] : i]
                           << (3 * AXIS_BITS - GROUP_BITS) |
                       code >> GROUP_BITS
                 : code;
}

/* ---- the tasks ---- */

static size_t
block_end(const grower *g, size_t block)
{
  size_t end = (block + 1) * g->block;

  return end < g->tree->n ? end : g->tree->n;
}

/* Boxes begin .. end - 1, PART at most. */
static void
ask_boxes(const grower *g, size_t begin, size_t end)
{
  sg_box part[PART];

  if (g->let_out) {
    g->let_out(g->data, begin, end, g->box + begin);
    return;
  }
  g->boxes(g->data, begin, end, part);
  for (size_t i = begin; i < end; i++) {
    g->box[i] = sg_box_let_out(&g->frame, &part[i - begin]);
  }
}

/* Asks for the boxes of a block and codes them. */
static void
take_boxes(void *data, size_t block)
{
  grower *g = data;
  size_t end = block_end(g, block);

  for (size_t i = block * g->block; i < end; i++) {
    if ((i - block * g->block) % PART == 0) {
      ask_boxes(g, i, i + PART < end ? i + PART : end);
    }
    g->code[i] = code_of(g, i);
    g->from[i] = g->code[i] >> LOW_BITS << 32 | i;
  }
}

static void
count_digits(void *data, size_t block)
{
  grower *g = data;
  uint32_t *count = g->start + block * BUCKETS;
  size_t end = block_end(g, block);

  memset(count, 0, BUCKETS * sizeof *count);
  for (size_t i = block * g->block; i < end; i++) {
    count[(g->from[i] >> g->shift) % BUCKETS]++;
  }
}

static void
scatter(void *data, size_t block)
{
  grower *g = data;
  uint32_t *start = g->start + block * BUCKETS;
  size_t end = block_end(g, block);

  for (size_t i = block * g->block; i < end; i++) {
    g->to[start[(g->from[i] >> g->shift) % BUCKETS]++] = g->from[i];
  }
}

/* Sorts n items with the same high half by the low one. */
static void
sort_run(const grower *g, const uint64_t *from, uint64_t *to, size_t n)
{
  for (size_t i = 0; i < n; i++) {
    uint64_t item = (uint32_t)from[i];
    uint64_t key = g->code[item] % (1 << LOW_BITS) << 32 | item;
    size_t j = i;

    for (; n <= SHORT && j > 0 && to[j - 1] > key; j--) {
      to[j] = to[j - 1];
    }
    to[j] = key;
  }
  if (n > SHORT) {
    qsort(to, n, sizeof *to, sg_compare_keys);
  }
}

/* Puts the runs that begin in a block in order: what else they are is seen in
 * `from`, which does not change. */
static void
order_runs(void *data, size_t block)
{
  grower *g = data;
  const uint64_t *from = g->from;
  size_t n = g->tree->n, i = block * g->block, end = block_end(g, block);

  while (i > 0 && i < end && from[i] >> 32 == from[i - 1] >> 32) {
    i++;
  }
  while (i < end) {
    size_t last = i + 1;

    while (last < n && from[last] >> 32 == from[i] >> 32) {
      last++;
    }
    sort_run(g, from + i, g->to + i, last - i);
    i = last;
  }
}

/* Puts the boxes of a block in order. */
static void
place_boxes(void *data, size_t block)
{
  grower *g = data;
  size_t end = block_end(g, block);

  for (size_t i = block * g->block; i < end; i++) {
    uint32_t item = (uint32_t)g->from[i];

    g->tree->item[i] = g->name ? g->name[item] : item;
    put_lane(&g->tree->level[0][i / SG_BVH_WIDTH], i % SG_BVH_WIDTH,
             &g->box[item]);
  }
}

/* Lays a part of a level over the one below. */
static void
lay_boxes(void *data, size_t task)
{
  grower *g = data;
  const sg_box4 *below = g->tree->level[g->level - 1];
  sg_box4 *out = g->tree->level[g->level];
  size_t end = (task + 1) * g->group;

  end = end < g->tree->count[g->level] ? end : g->tree->count[g->level];
  for (size_t i = task * g->group; i < end; i++) {
    sg_box32 box = box_round(&below[i]);

    put_lane(&out[i / SG_BVH_WIDTH], i % SG_BVH_WIDTH, &box);
  }
}

/* ---- the whole ---- */

/* Counts of each block and bucket become where it starts. False: all items are
 * in one bucket, and stay where they are. */
static bool
find_starts(grower *g)
{
  uint32_t sum = 0;

  for (size_t k = 0; k < BUCKETS; k++) {
    uint32_t before = sum;

    for (size_t b = 0; b < g->blocks; b++) {
      uint32_t count = g->start[b * BUCKETS + k];
      g->start[b * BUCKETS + k] = sum;
      sum += count;
    }
    if (sum - before == g->tree->n) {
      return false;
    }
  }
  return true;
}

static void
swap_keys(grower *g)
{
  uint64_t *sorted = g->to;

  g->to = g->from;
  g->from = sorted;
}

/* Stable radix sort by the high half of the codes, from the last digit to the
 * first; then by the low half, where that is the same. */
static bool
sort_codes(grower *g, sg_pool *pool, const sg_cancel *cancel)
{
  for (unsigned digit = 0; digit < DIGITS; digit++) {
    g->shift = 32 + digit * DIGIT_BITS;
    if (!sg_pool_run(pool, g->blocks, count_digits, g, cancel)) {
      return false;
    }
    if (find_starts(g)) {
      if (!sg_pool_run(pool, g->blocks, scatter, g, cancel)) {
        return false;
      }
      swap_keys(g);
    }
  }
  if (!sg_pool_run(pool, g->blocks, order_runs, g, cancel)) {
    return false;
  }
  swap_keys(g);
  return true;
}

static bool
lay_levels(grower *g, sg_pool *pool, const sg_cancel *cancel)
{
  g->group = groups_of(g->block) / SG_BVH_WIDTH * SG_BVH_WIDTH;
  for (g->level = 1; g->level < g->tree->levels; g->level++) {
    size_t tasks = (g->tree->count[g->level] + g->group - 1) / g->group;

    if (!sg_pool_run(pool, tasks, lay_boxes, g, cancel)) {
      return false;
    }
  }
  return true;
}

/* Memory for a tree of n boxes; the lanes that no box has are empty. */
static bool
make_room(sg_bvh *tree, size_t n)
{
  size_t total = 0, count = n;

  tree->n = n;
  while (count > 0) {
    tree->count[tree->levels++] = count;
    total += groups_of(count);
    count = count == 1 ? 0 : groups_of(count);
  }
  tree->level[0] =
      aligned_alloc(sizeof(sg_float4), (total + 1) * sizeof *tree->level[0]);
  tree->item = malloc((n + 1) * sizeof *tree->item);
  if (!tree->level[0] || !tree->item) {
    return false;
  }
  for (unsigned k = 0; k < tree->levels; k++) {
    size_t groups = groups_of(tree->count[k]);

    if (k + 1 < tree->levels) {
      tree->level[k + 1] = tree->level[k] + groups;
    }
    for (size_t i = tree->count[k]; i < groups * SG_BVH_WIDTH; i++) {
      put_lane(&tree->level[k][groups - 1], i % SG_BVH_WIDTH, &nothing);
    }
  }
  return true;
}

static bool
grow(grower *g, sg_pool *pool, const sg_cancel *cancel)
{
  size_t n = g->tree->n;
  uint64_t *keys = malloc(3 * (n + 1) * sizeof *keys);
  bool done = false;

  g->block =
      n / BLOCKS < BLOCK ? BLOCK : groups_of(n / BLOCKS + 1) * SG_BVH_WIDTH;
  g->blocks = (n + g->block - 1) / g->block;
  g->box = malloc((n + 1) * sizeof *g->box);
  g->start = malloc((g->blocks + 1) * BUCKETS * sizeof *g->start);
  if (keys && g->box && g->start && !sg_cancelled(cancel)) {
    g->from = keys;
    g->to = keys + n;
    g->code = g->to + n;
    done = sg_pool_run(pool, g->blocks, take_boxes, g, cancel) &&
           sort_codes(g, pool, cancel) &&
           sg_pool_run(pool, g->blocks, place_boxes, g, cancel) &&
           lay_levels(g, pool, cancel);
  }
  free(keys);
  free(g->box);
  free(g->start);
  return done;
}

static sg_bvh *
grow_tree(grower *g, size_t n, const sg_box *all, sg_pool *pool,
          const sg_cancel *cancel)
{
  sg_bvh *tree = calloc(1, sizeof *tree);

  assert(n < UINT32_MAX);
  if (!tree) {
    return NULL;
  }
  if (n == 0) {
    tree->all = sg_box_none();
    tree->unit = 1;
    return tree;
  }
  g->tree = tree;
  set_frame(g, all);
  if (!make_room(tree, n) || !grow(g, pool, cancel)) {
    sg_bvh_close(tree);
    return NULL;
  }
  return tree;
}

sg_bvh *
sg_bvh_grow(size_t n, sg_bvh_boxes *boxes, const void *data,
            const uint32_t *name, const sg_box *all, sg_pool *pool,
            const sg_cancel *cancel)
{
  return grow_tree(&(grower){.boxes = boxes, .data = data, .name = name}, n,
                   all, pool, cancel);
}

sg_bvh *
sg_bvh_grow_grouped(size_t n, sg_bvh_boxes *boxes, const void *data,
                    const uint32_t *name, const unsigned char *group,
                    const sg_box *all, sg_pool *pool, const sg_cancel *cancel)
{
  return grow_tree(
      &(grower){.boxes = boxes, .data = data, .name = name, .kind = group}, n,
      all, pool, cancel);
}

sg_bvh *
sg_bvh_grow_let_out(size_t n, sg_bvh_boxes32 *boxes, const void *data,
                    const uint32_t *name, const sg_box *all, sg_pool *pool,
                    const sg_cancel *cancel)
{
  return grow_tree(&(grower){.let_out = boxes, .data = data, .name = name}, n,
                   all, pool, cancel);
}

static void
copy_boxes(const void *data, size_t begin, size_t end, sg_box *out)
{
  const sg_box *box = data;

  memcpy(out, box + begin, (end - begin) * sizeof *out);
}

sg_bvh *
sg_bvh_open(const sg_box *box, size_t n, const sg_cancel *cancel)
{
  sg_box all = sg_box_none();

  for (size_t i = 0; i < n; i++) {
    sg_box_join(&all, &box[i]);
  }
  return sg_bvh_grow(n, copy_boxes, box, NULL, &all, NULL, cancel);
}

void
sg_bvh_close(sg_bvh *tree)
{
  if (tree) {
    free(tree->level[0]);
    free(tree->item);
    free(tree);
  }
}

size_t
sg_bvh_bytes(const sg_bvh *tree)
{
  size_t groups = 0;

  for (unsigned k = 0; k < tree->levels; k++) {
    groups += groups_of(tree->count[k]);
  }
  return sizeof *tree + groups * sizeof *tree->level[0] +
         tree->n * sizeof *tree->item;
}
