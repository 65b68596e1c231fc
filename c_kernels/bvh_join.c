#include "bvh_join.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  TASKS = 512,       /* pairs of nodes that are enough for all threads */
  SHARE = 16,        /* of them in a task */
  STEPS_ASKED = 4096 /* pairs of nodes between questions */
};

/* Two nodes that overlap. */
typedef struct nodes {
  uint32_t pair;
  uint32_t i, j;
  uint8_t level_i, level_j;
} nodes;

/* When a.lo * unit_a - b.hi * unit_b <= limit in each axis, and the other way
 * round, the boxes overlap. */
typedef struct frames {
  const sg_bvh *a, *b;
  double unit_a, unit_b;
  double limit_a[3], limit_b[3]; /* for a.lo - b.hi, for b.lo - a.hi */
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
  nodes *front; /* [fronts]: what the tasks begin with, in order */
  size_t fronts;
  hit_list *found; /* [tasks] */
} joiner;

/* One task's descent. */
typedef struct descent {
  frames frames;
  uint32_t pair;
  unsigned steps;
  bool stopped;
  hit_list *found;
} descent;

static frames
frames_of(const sg_bvh_pair *pair, double reach)
{
  const sg_bvh *a = pair->a, *b = pair->b;
  frames f = {a, b, a->unit, b->unit, {0}, {0}};

  for (int c = 0; c < 3; c++) {
    double shift = b->origin[c] - a->origin[c];
    /* Rounding, generously: of the boxes, of the shift, of the differences. */
    double slack = ldexp(a->unit + b->unit + fabs(shift), -48);

    f.limit_a[c] = shift + reach + slack;
    f.limit_b[c] = -shift + reach + slack;
  }
  return f;
}

static bool
overlap(const frames *f, const sg_box32 *a, const sg_box32 *b)
{
  bool good = true;

  for (int c = 0; c < 3; c++) {
    good &= ((double)a->lo[c] * f->unit_a - (double)b->hi[c] * f->unit_b <=
             f->limit_a[c]) &
            ((double)b->lo[c] * f->unit_b - (double)a->hi[c] * f->unit_a <=
             f->limit_b[c]);
  }
  return good;
}

static void
add_hit(hit_list *list, sg_bvh_hit hit)
{
  if (list->n == list->room) {
    size_t room = list->room ? 2 * list->room : 256;
    sg_bvh_hit *grown = realloc(list->hit, room * sizeof *grown);

    if (!grown) {
      list->failed = true;
      return;
    }
    list->hit = grown;
    list->room = room;
  }
  list->hit[list->n++] = hit;
}

/* ---- one step down ---- */

/* The nodes below: the higher of the two is opened, or both. */
typedef struct below {
  uint32_t i, i_end, j, j_end;
  uint8_t level_i, level_j;
} below;

static void
open_node(const sg_bvh *tree, uint32_t node, uint8_t *level, uint32_t *begin,
          uint32_t *end)
{
  size_t last = ((size_t)node + 1) * SG_BVH_WIDTH;

  *level = (uint8_t)(*level - 1);
  *begin = node * SG_BVH_WIDTH;
  *end = (uint32_t)(last < tree->count[*level] ? last : tree->count[*level]);
}

static below
below_of(const frames *f, const nodes *at)
{
  below b = {at->i, at->i + 1, at->j, at->j + 1, at->level_i, at->level_j};

  if (at->level_i >= at->level_j) {
    open_node(f->a, at->i, &b.level_i, &b.i, &b.i_end);
  }
  if (at->level_j >= at->level_i) {
    open_node(f->b, at->j, &b.level_j, &b.j, &b.j_end);
  }
  return b;
}

/* In one tree with itself, the nodes from here on are not those before. */
static uint32_t
first_j(const frames *f, const below *b, uint32_t i)
{
  uint32_t from = b->level_i == 0 ? i + 1 : i;

  return f->a == f->b && from > b->j ? from : b->j;
}

/* ---- descending ---- */

static void
descend(descent *d, const nodes *at)
{
  const frames *f = &d->frames;
  below b = below_of(f, at);
  const sg_box32 *of_a = f->a->level[b.level_i], *of_b = f->b->level[b.level_j];

  if (++d->steps % STEPS_ASKED == 0 && sg_crew_stopping()) {
    d->stopped = true;
  }
  for (uint32_t i = b.i; i < b.i_end && !d->stopped; i++) {
    for (uint32_t j = first_j(f, &b, i); j < b.j_end; j++) {
      if (!overlap(f, &of_a[i], &of_b[j])) {
        continue;
      }
      if (b.level_i == 0 && b.level_j == 0) {
        add_hit(d->found, (sg_bvh_hit){d->pair, i, j});
      } else {
        descend(d, &(nodes){d->pair, i, j, b.level_i, b.level_j});
      }
    }
  }
  d->stopped = d->stopped || d->found->failed;
}

static void
do_share(void *data, size_t task)
{
  joiner *join = data;
  descent d = {.found = &join->found[task]};
  size_t end = (task + 1) * SHARE;

  end = end < join->fronts ? end : join->fronts;
  for (size_t k = task * SHARE; k < end && !d.stopped; k++) {
    const nodes *at = &join->front[k];

    d.pair = at->pair;
    d.frames = frames_of(&join->pair[at->pair], join->reach);
    if (at->level_i == 0 && at->level_j == 0) {
      add_hit(d.found, (sg_bvh_hit){at->pair, at->i, at->j});
    } else {
      descend(&d, at);
    }
  }
}

/* ---- the front ---- */

typedef struct node_list {
  size_t n, room;
  nodes *at;
} node_list;

static bool
add_nodes(node_list *list, nodes at)
{
  if (list->n == list->room) {
    size_t room = list->room ? 2 * list->room : 64;
    nodes *grown = realloc(list->at, room * sizeof *grown);

    if (!grown) {
      return false;
    }
    list->at = grown;
    list->room = room;
  }
  list->at[list->n++] = at;
  return true;
}

/* The tops of all pairs of trees. */
static bool
add_tops(const joiner *join, size_t n, node_list *out)
{
  for (size_t k = 0; k < n; k++) {
    const sg_bvh *a = join->pair[k].a, *b = join->pair[k].b;

    if (a->n == 0 || b->n == 0 || (a == b && a->n == 1)) {
      continue;
    }
    frames f = frames_of(&join->pair[k], join->reach);
    uint8_t level_a = (uint8_t)(a->levels - 1);
    uint8_t level_b = (uint8_t)(b->levels - 1);

    if (overlap(&f, a->level[level_a], b->level[level_b]) &&
        !add_nodes(out, (nodes){(uint32_t)k, 0, 0, level_a, level_b})) {
      return false;
    }
  }
  return true;
}

/* What is below, in the same order. */
static bool
open_one(const joiner *join, const nodes *at, node_list *out)
{
  frames f = frames_of(&join->pair[at->pair], join->reach);
  below b = below_of(&f, at);

  for (uint32_t i = b.i; i < b.i_end; i++) {
    for (uint32_t j = first_j(&f, &b, i); j < b.j_end; j++) {
      nodes next = {at->pair, i, j, b.level_i, b.level_j};

      if (overlap(&f, &f.a->level[b.level_i][i], &f.b->level[b.level_j][j]) &&
          !add_nodes(out, next)) {
        return false;
      }
    }
  }
  return true;
}

/* Opens everything once; *grew: something could be opened. */
static bool
open_all(const joiner *join, node_list *list, bool *grew)
{
  node_list next = {0};
  bool good = true;

  *grew = false;
  for (size_t k = 0; k < list->n && good; k++) {
    const nodes *at = &list->at[k];

    if (at->level_i == 0 && at->level_j == 0) {
      good = add_nodes(&next, *at);
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

/* Puts what the tasks found one after another. */
static bool
collect(const joiner *join, size_t tasks, sg_bvh_hits *out)
{
  size_t n = 0;

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
  }
  return true;
}

bool
sg_bvh_join(const sg_bvh_pair *pair, size_t n, double reach, sg_crew *crew,
            const sg_poll *poll, sg_bvh_hits *out)
{
  joiner join = {.pair = pair, .reach = reach};
  node_list front = {0};
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
         sg_crew_run(crew, tasks, do_share, &join, poll) &&
         collect(&join, tasks, out);
  for (size_t k = 0; join.found && k < tasks; k++) {
    free(join.found[k].hit);
  }
  free(join.found);
  free(front.at);
  return good;
}
