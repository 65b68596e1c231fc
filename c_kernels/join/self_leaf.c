#include "self_leaf.h"

#include "polygon/flatness.h"
#include "self_pair.h"

#include <stdlib.h>
#include <string.h>

enum { BLOCK = 4096 }; /* leaves or hits in a task */

/* A leaf at hand: beside its neighbours in Morton order. */
typedef struct leaf {
  double at[3][3];
  int32_t v[3], p;
} leaf;

typedef struct joiner {
  const sg_leaf_tree *tree;
  const sg_leaf_views *views;
  double reach;
  leaf *leaf; /* [n], by place in the tree */
  sg_bvh_hits hits;
  unsigned char *kept; /* [hits] */
} joiner;

static size_t
blocks(size_t n)
{
  return (n + BLOCK - 1) / BLOCK;
}

/* Where block `task` of n ends. */
static size_t
end_of(size_t task, size_t n)
{
  return (task + 1) * BLOCK < n ? (task + 1) * BLOCK : n;
}

static void
read_block(void *data, size_t task)
{
  joiner *j = data;
  const sg_bvh *boxes = j->tree->boxes;

  for (size_t i = task * BLOCK; i < end_of(task, boxes->n); i++) {
    sg_leaf row = sg_leaf_at(j->tree, j->views, boxes->item[i]);
    leaf *out = &j->leaf[i];

    out->p = row.p;
    for (int k = 0; k < 3; k++) {
      out->v[k] = row.v[k];
      sg_leaf_vertex_at(j->tree, j->views, row.v[k], out->at[k]);
    }
  }
}

static void
set_two(const leaf *a, const leaf *b, sg_self_two *out)
{
  memcpy(out->a, a->at, sizeof out->a);
  memcpy(out->b, b->at, sizeof out->b);
  memcpy(out->a_at, a->v, sizeof out->a_at);
  memcpy(out->b_at, b->v, sizeof out->b_at);
}

static bool
share_corner(const leaf *a, const leaf *b)
{
  for (int i = 0; i < 9; i++) {
    if (a->v[i / 3] == b->v[i % 3]) {
      return true;
    }
  }
  return false;
}

static void
test_block(void *data, size_t task)
{
  joiner *j = data;

  for (size_t i = task * BLOCK; i < end_of(task, j->hits.n); i++) {
    const leaf *a = &j->leaf[j->hits.hit[i].a], *b = &j->leaf[j->hits.hit[i].b];
    sg_self_two two;

    if (i % 256 == 0 && sg_crew_stopping()) {
      return;
    }
    if (a->p != b->p) {
      set_two(a, b, &two);
      j->kept[i] =
          sg_self_may_meet(&two) || (j->reach > 0 && !share_corner(a, b));
    }
  }
}

/* Leaves in j->hits those that are kept. */
static bool
run(joiner *j, sg_crew *crew, const sg_poll *poll)
{
  const sg_bvh *boxes = j->tree->boxes;

  if (boxes->n == 0 || j->tree->curve) {
    return true;
  }
  j->leaf = calloc(boxes->n, sizeof *j->leaf);
  if (!j->leaf || !sg_crew_run(crew, blocks(boxes->n), read_block, j, poll) ||
      !sg_bvh_join(&(sg_bvh_pair){boxes, boxes}, 1, j->reach, crew, poll,
                   &j->hits)) {
    return false;
  }
  j->kept = calloc(j->hits.n + 1, 1);
  if (!j->kept || !sg_crew_run(crew, blocks(j->hits.n), test_block, j, poll)) {
    return false;
  }
  size_t n = 0;

  for (size_t i = 0; i < j->hits.n; i++) {
    if (j->kept[i]) {
      j->hits.hit[n++] = j->hits.hit[i];
    }
  }
  j->hits.n = n;
  return true;
}

static void
clear(joiner *j)
{
  free(j->leaf);
  free(j->kept);
  free(j->hits.hit);
}

bool
sg_self_leaf_join(const sg_leaf_tree *tree, const sg_leaf_views *views,
                  double reach, sg_crew *crew, const sg_poll *poll,
                  sg_bvh_hits *out)
{
  joiner j = {.tree = tree, .views = views, .reach = reach};
  bool done = run(&j, crew, poll);

  *out = (sg_bvh_hits){0};
  if (done) {
    *out = j.hits;
    j.hits.hit = NULL;
  }
  clear(&j);
  return done;
}

static double
tolerance_of(const joiner *j, double grain)
{
  sg_flatness flatness;

  sg_flatness_init(&flatness, grain);
  for (size_t i = 0; i < j->tree->boxes->n; i++) {
    for (int k = 0; k < 3; k++) {
      sg_flatness_see(&flatness, j->leaf[i].at[k]);
    }
  }
  return flatness.any ? sg_flatness_flat(&flatness) : 0;
}

/* True when a hit goes through; false also when the poll said stop. */
static bool
any_goes_through(const joiner *j, double grain, const sg_poll *poll,
                 bool *stopped)
{
  double tolerance = j->hits.n > 0 ? tolerance_of(j, grain) : 0;

  *stopped = false;
  for (size_t i = 0; i < j->hits.n && !*stopped; i++) {
    sg_self_two two;

    set_two(&j->leaf[j->hits.hit[i].a], &j->leaf[j->hits.hit[i].b], &two);
    if (sg_self_may_meet(&two) && sg_self_goes_through(&two, tolerance)) {
      return true;
    }
    *stopped = i % BLOCK == BLOCK - 1 && sg_poll_stop(poll);
  }
  return false;
}

bool
sg_self_leaf_meets(const sg_leaf_tree *tree, const sg_leaf_views *views,
                   double grain, sg_crew *crew, const sg_poll *poll, bool *out)
{
  joiner j = {.tree = tree, .views = views};
  bool stopped = false, done = run(&j, crew, poll);

  *out = done && any_goes_through(&j, grain, poll, &stopped);
  clear(&j);
  return done && !stopped;
}
