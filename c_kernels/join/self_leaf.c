#include "self_leaf.h"

#include "fan.h"
#include "oriented_box.h"
#include "polygon/flatness.h"
#include "self_pair.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

enum { BLOCK = 4096 }; /* leaves in a task */

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
  sg_run run;
  sg_bvh *turned; /* null: the tree's own boxes will do */
  double tolerance;
  atomic_bool met;
  sg_bvh_hits hits;
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

/* ---- boxes along needles that run askew ---- */

static void
fill_turned(const void *data, size_t begin, size_t end, sg_box *out)
{
  const joiner *j = data;

  for (size_t i = begin; i < end; i++) {
    out[i - begin] = sg_box_none();
    for (int k = 0; k < 3; k++) {
      double at[3];

      sg_run_turn(&j->run, j->leaf[i].at[k], at);
      sg_box_add(&out[i - begin], at);
    }
  }
}

/* False: no memory, or stopped. */
static bool
grow_turned(joiner *j, sg_crew *crew, const sg_poll *poll)
{
  sg_box all = sg_box_none();
  size_t n = j->tree->boxes->n;

  for (size_t i = 0; i < n; i++) {
    sg_run_add(&j->run, (const double(*)[3])j->leaf[i].at);
  }
  sg_run_end(&j->run);
  if (!j->run.askew) {
    return true;
  }
  for (size_t i = 0; i < n; i++) {
    sg_box box;

    fill_turned(j, i, i + 1, &box);
    sg_box_join(&all, &box);
  }
  j->turned = sg_bvh_grow(n, fill_turned, j, NULL, &all, crew, poll);
  return j->turned != NULL;
}

/* Places in the turned tree as places in the tree. */
static sg_bvh_hit
own_places(const joiner *j, const sg_bvh_hit *hit)
{
  if (!j->turned) {
    return *hit;
  }
  uint32_t a = j->turned->item[hit->a], b = j->turned->item[hit->b];

  return (sg_bvh_hit){0, a < b ? a : b, a < b ? b : a};
}

static int
compare_hits(const void *x, const void *y)
{
  const sg_bvh_hit *a = x, *b = y;

  return a->a != b->a ? (a->a > b->a) - (a->a < b->a)
                      : (a->b > b->b) - (a->b < b->b);
}

static void
take_own_places(joiner *j)
{
  for (size_t i = 0; j->turned && i < j->hits.n; i++) {
    j->hits.hit[i] = own_places(j, &j->hits.hit[i]);
  }
  if (j->turned && j->hits.n > 0) {
    qsort(j->hits.hit, j->hits.n, sizeof *j->hits.hit, compare_hits);
  }
}

/* ---- fans ---- */

/* An sg_fan_read. */
static void
read_triangle(const void *data, size_t place, sg_fan_triangle *out)
{
  const joiner *j = data;
  const leaf *from = &j->leaf[j->turned ? j->turned->item[place] : place];

  memcpy(out->at, from->at, sizeof out->at);
  memcpy(out->name, from->v, sizeof out->name);
  out->polygon = from->p;
}

/* ---- pairs ---- */

/* Whether two leaves may have more in common than they share. */
static bool
may_meet(void *data, const sg_bvh_hit *hit)
{
  const joiner *j = data;
  sg_bvh_hit own = own_places(j, hit);
  const leaf *a = &j->leaf[own.a], *b = &j->leaf[own.b];
  sg_self_two two;

  if (a->p == b->p) {
    return false;
  }
  set_two(a, b, &two);
  return sg_self_may_meet(&two) || (j->reach > 0 && !share_corner(a, b));
}

/* Whether they go through each other; nobody need ask after one that does. */
static bool
goes_through(void *data, const sg_bvh_hit *hit)
{
  joiner *j = data;
  sg_bvh_hit own = own_places(j, hit);
  const leaf *a = &j->leaf[own.a], *b = &j->leaf[own.b];
  sg_self_two two;

  if (a->p == b->p || atomic_load_explicit(&j->met, memory_order_relaxed)) {
    return false;
  }
  set_two(a, b, &two);
  if (sg_self_may_meet(&two) && sg_self_goes_through(&two, j->tolerance)) {
    atomic_store_explicit(&j->met, true, memory_order_relaxed);
  }
  return false;
}

static bool
has_none(const sg_leaf_tree *tree)
{
  return tree->boxes->n == 0 || tree->curve;
}

static bool
read_leaves(joiner *j, sg_crew *crew, const sg_poll *poll)
{
  size_t n = j->tree->boxes->n;

  j->leaf = calloc(n, sizeof *j->leaf);
  return j->leaf && sg_crew_run(crew, blocks(n), read_block, j, poll) &&
         grow_turned(j, crew, poll);
}

/* by_place: what touches in a point only is not wanted. */
static bool
join(joiner *j, sg_bvh_wants *wants, bool by_place, sg_crew *crew,
     const sg_poll *poll)
{
  const sg_bvh *tree = j->turned ? j->turned : j->tree->boxes;
  sg_fans *fans;
  bool done =
      sg_fans_open(tree, read_triangle, j, by_place, &fans) &&
      sg_bvh_join_itself(tree, j->reach, wants, j, fans ? sg_fans_apart : NULL,
                         fans, crew, poll, &j->hits);

  sg_fans_close(fans);
  return done;
}

bool
sg_self_leaf_join(const sg_leaf_tree *tree, const sg_leaf_views *views,
                  double reach, sg_crew *crew, const sg_poll *poll,
                  sg_bvh_hits *out)
{
  joiner j = {.tree = tree, .views = views, .reach = reach};
  bool done = has_none(tree) || (read_leaves(&j, crew, poll) &&
                                 join(&j, may_meet, false, crew, poll));

  take_own_places(&j);
  free(j.leaf);
  sg_bvh_close(j.turned);
  *out = j.hits;
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

bool
sg_self_leaf_meets(const sg_leaf_tree *tree, const sg_leaf_views *views,
                   double grain, sg_crew *crew, const sg_poll *poll, bool *out)
{
  joiner j = {.tree = tree, .views = views};
  bool done = has_none(tree) || read_leaves(&j, crew, poll);

  if (done && j.leaf) {
    j.tolerance = tolerance_of(&j, grain);
    done = join(&j, goes_through, true, crew, poll);
  }
  free(j.leaf);
  free(j.hits.hit);
  sg_bvh_close(j.turned);
  *out = done && atomic_load(&j.met);
  return done;
}
