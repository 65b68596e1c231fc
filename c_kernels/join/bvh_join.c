#include "bvh_join.h"
#include "engine/list.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double FAR = 1e30; /* units; no two boxes that meet are so far */

enum {
  TASKS = 512,          /* pairs of nodes that are enough for all threads */
  SHARE = 16,           /* of them in a task */
  STEPS_ASKED = 1024,   /* pairs of nodes or boxes between questions */
  HITS_ASKED = 1 << 17, /* hits that are copied between questions */
  FEW = 1 << 17,        /* boxes: threads would not be there in time */
  FEW_ASKED = 1 << 11   /* the same, where each hit is asked about */
};

/* A group of nodes of each tree, some of which may overlap. */
typedef struct groups {
  uint32_t pair;
  uint32_t i, j;
  uint8_t level_i, level_j;
} groups;

/* Where boxes of both trees are compared: from the origin of a, in the larger
 * unit. Those of b are let out by the reach and by what rounding may take. */
typedef struct frames {
  const sg_bvh *a, *b;
  float scale_a, scale_b;         /* powers of two, at most 1 */
  float shift_lo[3], shift_hi[3]; /* of b's boxes */
} frames;

/* A growing list of hits. */
typedef struct hit_list {
  size_t n, room;
  sg_bvh_hit *hit;
  bool failed; /* no memory */
} hit_list;

typedef struct joiner {
  const sg_bvh_pair *pair;
  double reach;
  sg_bvh_wants *wants; /* null: all are wanted */
  void *data;
  sg_bvh_apart *apart; /* null, but in one tree with itself */
  const void *fans;
  groups *front; /* [fronts]: what the tasks begin with, in order */
  size_t fronts;
  hit_list *found; /* [tasks] */
} joiner;

/* One task's descent. */
typedef struct descent {
  const joiner *join;
  frames frames;
  uint32_t pair;
  unsigned steps;
  bool stopped;
  hit_list *found;
} descent;

/* As a float, never infinite: only lanes that are empty are. */
static float
bounded(double d)
{
  return d > FAR ? (float)FAR : d < -FAR ? (float)-FAR : (float)d;
}

static frames
frames_of(const sg_bvh_pair *pair, double reach)
{
  const sg_bvh *a = pair->a, *b = pair->b;
  double unit = fmax(a->unit, b->unit);
  frames f = {a, b, (float)(a->unit / unit), (float)(b->unit / unit), {0}, {0}};

  for (int c = 0; c < 3; c++) {
    double shift = (b->origin[c] - a->origin[c]) / unit;
    /* Twice what the float sums of numbers up to 1 + |shift| may lose. */
    double out = reach / unit + ldexp(2 + fabs(shift) + reach / unit, -22);

    f.shift_lo[c] = bounded(shift - out);
    f.shift_hi[c] = bounded(shift + out);
  }
  return f;
}

/* ---- sixteen at once ---- */

typedef int32_t lanes __attribute__((vector_size(16)));

/* Bit l for the l-th lane that is set. */
static inline unsigned
bits_of(lanes all)
{
#ifdef __SSE__
  return (unsigned)__builtin_ia32_movmskps((sg_float4)all);
#else
  return (unsigned)((all[0] & 1) | (all[1] & 2) | (all[2] & 4) | (all[3] & 8));
#endif
}

static inline sg_float4
four(float x)
{
  return (sg_float4){x, x, x, x};
}

/* The boxes of a group of each tree, along one axis, as they are compared. */
typedef struct sides {
  sg_float4 a_lo, a_hi, b_lo, b_hi;
} sides;

static inline sides
sides_of(const frames *f, const sg_box4 *a, const sg_box4 *b, int c)
{
  return (sides){a->lo[c] * f->scale_a, a->hi[c] * f->scale_a,
                 b->lo[c] * f->scale_b + f->shift_lo[c],
                 b->hi[c] * f->scale_b + f->shift_hi[c]};
}

static inline lanes
overlap_along(const sides *s, int k)
{
  return (four(s->a_lo[k]) <= s->b_hi) & (s->b_lo <= four(s->a_hi[k]));
}

/* Which boxes of b overlap box k of a. */
static inline unsigned
overlaps(const sides *x, const sides *y, const sides *z, int k)
{
  return bits_of(overlap_along(x, k) & overlap_along(y, k) &
                 overlap_along(z, k));
}

/* Bit 4 k + l: box k of a group of a and box l of one of b overlap. Lanes are
 * constants, so that all stays in registers. */
static inline unsigned
all_overlaps(const frames *f, const groups *at)
{
  const sg_box4 *a = &f->a->level[at->level_i][at->i];
  const sg_box4 *b = &f->b->level[at->level_j][at->j];
  sides x = sides_of(f, a, b, 0), y = sides_of(f, a, b, 1),
        z = sides_of(f, a, b, 2);

  return overlaps(&x, &y, &z, 0) | overlaps(&x, &y, &z, 1) << 4 |
         overlaps(&x, &y, &z, 2) << 8 | overlaps(&x, &y, &z, 3) << 12;
}

/* In one tree with itself each two come once, and no box with itself: bits of
 * the lanes from which group j goes on. */
static inline unsigned
wanted(const frames *f, const groups *at, int k)
{
  if (f->a != f->b || at->i != at->j) {
    return 15;
  }
  return 15u << (at->level_i == 0 ? k + 1 : k) & 15;
}

/* The groups below lane k of i and lane l of j: of the higher of the two, or of
 * both. */
static inline groups
groups_below(const groups *at, int k, int l)
{
  groups below = *at;

  if (at->level_i >= at->level_j) {
    below.level_i--;
    below.i = at->i * SG_BVH_WIDTH + (uint32_t)k;
  }
  if (at->level_j >= at->level_i) {
    below.level_j--;
    below.j = at->j * SG_BVH_WIDTH + (uint32_t)l;
  }
  return below;
}

static void
add_hit(hit_list *list, sg_bvh_hit hit)
{
  if (!sg_list_grow(&list->hit, list->n, &list->room, sizeof *list->hit)) {
    list->failed = true;
    return;
  }
  list->hit[list->n++] = hit;
}

/* ---- one box ---- */

static bool
meets_below(const sg_bvh *tree, unsigned level, size_t group,
            const sg_box32 *box)
{
  const sg_box4 *four_of = &tree->level[level][group];
  lanes all = four_of->lo[0] <= four(box->hi[0]);

  for (int c = 0; c < 3; c++) {
    all &= (four_of->lo[c] <= four(box->hi[c])) &
           (four(box->lo[c]) <= four_of->hi[c]);
  }
  bool met = level == 0 && bits_of(all) != 0;

  for (unsigned bits = level == 0 ? 0 : bits_of(all); bits && !met;
       bits &= bits - 1) {
    met = meets_below(tree, level - 1,
                      group * SG_BVH_WIDTH + (size_t)__builtin_ctz(bits), box);
  }
  return met;
}

bool
sg_bvh_meets(const sg_bvh *tree, const sg_box *box)
{
  sg_bvh_frame frame = {{tree->origin[0], tree->origin[1], tree->origin[2]},
                        tree->unit};
  sg_box inside = *box;

  if (tree->n == 0 || !sg_box_overlap(&tree->all, box, 0)) {
    return false;
  }
  for (int c = 0; c < 3; c++) { /* no more than a float can hold */
    inside.lo[c] = fmax(inside.lo[c], tree->all.lo[c]);
    inside.hi[c] = fmin(inside.hi[c], tree->all.hi[c]);
  }
  sg_box32 out = sg_box_let_out(&frame, &inside);

  return meets_below(tree, tree->levels - 1, 0, &out);
}

/* ---- descending ---- */

/* A pair that is wanted may be two triangles near each other: exact signs. */
static void
count_step(descent *d)
{
  if (++d->steps % STEPS_ASKED == 0 && sg_pool_stopping()) {
    d->stopped = true;
  }
}

static void
take_hit(descent *d, sg_bvh_hit hit)
{
  count_step(d);
  if (!d->join->wants || d->join->wants(d->join->data, &hit)) {
    add_hit(d->found, hit);
  }
}

static void descend(descent *d, const groups *at);

/* Lane k of group i meets the lanes `bits` of group j. */
static void
go_on(descent *d, const groups *at, int k, unsigned bits)
{
  for (; bits && !d->stopped; bits &= bits - 1) {
    int l = __builtin_ctz(bits);

    if (at->level_i == 0 && at->level_j == 0) {
      take_hit(d, (sg_bvh_hit){d->pair, at->i * SG_BVH_WIDTH + (uint32_t)k,
                               at->j * SG_BVH_WIDTH + (uint32_t)l});
      continue;
    }
    if (d->join->apart && d->join->apart(d->join->fans, at->level_i,
                                         at->i * SG_BVH_WIDTH + (size_t)k,
                                         at->j * SG_BVH_WIDTH + (size_t)l)) {
      continue;
    }
    groups below = groups_below(at, k, l);

    descend(d, &below);
    if (at->level_i > at->level_j) {
      return; /* all of group j are in it */
    }
  }
}

static void
descend(descent *d, const groups *at)
{
  const frames *f = &d->frames;
  unsigned all = all_overlaps(f, at);
  unsigned done = 0; /* lanes of j that were opened with the whole of i */

  count_step(d);
  for (int k = 0; all && !d->stopped; k++, all >>= SG_BVH_WIDTH) {
    unsigned bits = all & wanted(f, at, k) & ~done;

    go_on(d, at, k, bits);
    if (at->level_i < at->level_j) {
      done |= bits;
    }
  }
  d->stopped = d->stopped || d->found->failed;
}

static void
do_share(void *data, size_t task)
{
  joiner *join = data;
  descent d = {.join = join, .found = &join->found[task]};
  size_t end = (task + 1) * SHARE;

  end = end < join->fronts ? end : join->fronts;
  for (size_t k = task * SHARE; k < end && !d.stopped; k++) {
    d.pair = join->front[k].pair;
    d.frames = frames_of(&join->pair[d.pair], join->reach);
    descend(&d, &join->front[k]);
  }
}

/* ---- the front ---- */

typedef struct group_list {
  size_t n, room;
  groups *at;
} group_list;

static bool
add_groups(group_list *list, groups at)
{
  if (!sg_list_grow(&list->at, list->n, &list->room, sizeof *list->at)) {
    return false;
  }
  list->at[list->n++] = at;
  return true;
}

/* The tops of all pairs of trees. */
static bool
add_tops(const joiner *join, size_t n, group_list *out)
{
  for (size_t k = 0; k < n; k++) {
    const sg_bvh *a = join->pair[k].a, *b = join->pair[k].b;

    if (a->n > 0 && b->n > 0 &&
        !add_groups(out, (groups){(uint32_t)k, 0, 0, (uint8_t)(a->levels - 1),
                                  (uint8_t)(b->levels - 1)})) {
      return false;
    }
  }
  return true;
}

/* What is below where both are of one level, in the same order. */
static bool
open_one(const joiner *join, const groups *at, group_list *out)
{
  frames f = frames_of(&join->pair[at->pair], join->reach);
  unsigned all = all_overlaps(&f, at);

  for (int k = 0; all; k++, all >>= SG_BVH_WIDTH) {
    unsigned bits = all & wanted(&f, at, k);

    for (; bits; bits &= bits - 1) {
      if (!add_groups(out, groups_below(at, k, __builtin_ctz(bits)))) {
        return false;
      }
    }
  }
  return true;
}

/* Opens everything once; *grew: something could be opened. */
static bool
open_all(const joiner *join, group_list *list, bool *grew)
{
  group_list next = {0};
  bool good = true;

  *grew = false;
  for (size_t k = 0; k < list->n && good; k++) {
    const groups *at = &list->at[k];

    if (at->level_i == 0 || at->level_i != at->level_j) {
      good = add_groups(&next, *at);
    } else {
      good = open_one(join, at, &next);
      *grew = true;
    }
  }
  free(list->at);
  *list = next;
  return good;
}

/* ---- the whole ---- */

/* Puts what the tasks found one after another. False: no memory, or stopped. */
static bool
collect(const joiner *join, size_t tasks, const sg_cancel *cancel,
        sg_bvh_hits *out)
{
  size_t n = 0, unasked = 0;

  for (size_t k = 0; k < tasks; k++) {
    if (join->found[k].failed) {
      return false;
    }
    n += join->found[k].n;
  }
  if (!(out->hit = malloc((n + 1) * sizeof *out->hit))) {
    return false;
  }
  for (size_t k = 0; k < tasks; k++) {
    if (join->found[k].n > 0) {
      memcpy(out->hit + out->n, join->found[k].hit,
             join->found[k].n * sizeof *out->hit);
      out->n += join->found[k].n;
    }
    if ((unasked += join->found[k].n) >= HITS_ASKED) {
      unasked = 0;
      if (sg_cancelled(cancel)) {
        free(out->hit);
        *out = (sg_bvh_hits){0};
        return false;
      }
    }
  }
  return true;
}

/* Whether the caller alone does the join: it is small. */
static bool
is_small(const joiner *join, size_t n)
{
  size_t boxes = 0, few = join->wants ? FEW_ASKED : FEW;

  for (size_t k = 0; k < n && boxes < few; k++) {
    boxes += join->pair[k].a->n + join->pair[k].b->n;
  }
  return boxes < few;
}

static bool
join_all(joiner join, size_t n, sg_pool *pool, const sg_cancel *cancel,
         sg_bvh_hits *out)
{
  group_list front = {0};
  bool grew = true, good = add_tops(&join, n, &front);

  *out = (sg_bvh_hits){0};
  while (good && grew && front.n > 0 && front.n < TASKS) {
    good = open_all(&join, &front, &grew);
  }
  size_t tasks = (front.n + SHARE - 1) / SHARE;

  join.front = front.at;
  join.fronts = front.n;
  join.found = calloc(tasks + 1, sizeof *join.found);
  good = good && join.found &&
         sg_pool_run(is_small(&join, n) ? NULL : pool, tasks, do_share, &join,
                     cancel) &&
         collect(&join, tasks, cancel, out);
  for (size_t k = 0; join.found && k < tasks; k++) {
    free(join.found[k].hit);
  }
  free(join.found);
  free(front.at);
  return good;
}

bool
sg_bvh_join_wanted(const sg_bvh_pair *pair, size_t n, double reach,
                   sg_bvh_wants *wants, void *data, sg_pool *pool,
                   const sg_cancel *cancel, sg_bvh_hits *out)
{
  joiner join = {.pair = pair, .reach = reach, .wants = wants, .data = data};

  return join_all(join, n, pool, cancel, out);
}

bool
sg_bvh_join_itself(const sg_bvh *tree, double reach, sg_bvh_wants *wants,
                   void *data, sg_bvh_apart *apart, const void *fans,
                   sg_pool *pool, const sg_cancel *cancel, sg_bvh_hits *out)
{
  const sg_bvh_pair pair = {tree, tree};
  joiner join = {.pair = &pair,
                 .reach = reach,
                 .wants = wants,
                 .data = data,
                 .apart = apart,
                 .fans = fans};

  return join_all(join, 1, pool, cancel, out);
}

bool
sg_bvh_join(const sg_bvh_pair *pair, size_t n, double reach, sg_pool *pool,
            const sg_cancel *cancel, sg_bvh_hits *out)
{
  return sg_bvh_join_wanted(pair, n, reach, NULL, NULL, pool, cancel, out);
}
