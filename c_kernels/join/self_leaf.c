#include "self_leaf.h"

#include "polygon/flatness.h"
#include "rows/places.h"
#include "self_sheet.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

enum { BLOCK = 4096 }; /* leaves in a task */

typedef struct joiner {
  const sg_leaf_tree *tree;
  const sg_leaf_views *views;
  double reach;
  sg_fan_triangle *leaf; /* [n], by place in the tree */
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
    sg_fan_triangle *out = &j->leaf[i];

    out->polygon = row.p;
    for (int k = 0; k < 3; k++) {
      out->name[k] = (uint32_t)row.v[k];
      sg_leaf_vertex_at(j->tree, j->views, row.v[k], out->at[k]);
    }
  }
}

static void
read_leaf(const void *data, uint32_t i, sg_fan_triangle *out)
{
  *out = ((const joiner *)data)->leaf[i];
}

static bool
share_corner(const sg_fan_triangle *a, const sg_fan_triangle *b)
{
  for (int i = 0; i < 9; i++) {
    if (a->name[i / 3] == b->name[i % 3]) {
      return true;
    }
  }
  return false;
}

/* Whether two leaves may have more in common than they share. */
static bool
may_meet(void *data, const sg_fan_triangle *a, const sg_fan_triangle *b)
{
  const joiner *j = data;
  sg_self_two two;

  if (a->polygon == b->polygon) {
    return false;
  }
  sg_self_two_of(a, b, &two);
  return sg_self_may_meet(&two) || (j->reach > 0 && !share_corner(a, b));
}

/* Whether they go through each other; nobody need ask after one that does. */
static bool
goes_through(void *data, const sg_fan_triangle *a, const sg_fan_triangle *b)
{
  joiner *j = data;
  sg_self_two two;

  if (a->polygon == b->polygon ||
      atomic_load_explicit(&j->met, memory_order_relaxed)) {
    return false;
  }
  sg_self_two_of(a, b, &two);
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
read_leaves(joiner *j, sg_pool *pool, const sg_cancel *cancel)
{
  size_t n = j->tree->boxes->n;

  j->leaf = calloc(n, sizeof *j->leaf);
  return j->leaf && sg_pool_run(pool, blocks(n), read_block, j, cancel);
}

static bool
join(joiner *j, sg_self_wants *wants, bool by_place, bool but_equal,
     sg_pool *pool, const sg_cancel *cancel)
{
  const sg_self_joining joining = {.n = j->tree->boxes->n,
                                   .read = read_leaf,
                                   .wants = wants,
                                   .data = j,
                                   .by_place = by_place,
                                   .but_equal = but_equal,
                                   .reach = j->reach,
                                   .tree = j->tree->boxes,
                                   .done = &j->met};

  return sg_self_join(&joining, pool, cancel, &j->hits);
}

bool
sg_self_leaf_join(const sg_leaf_tree *tree, const sg_leaf_views *views,
                  double reach, sg_pool *pool, const sg_cancel *cancel,
                  sg_bvh_hits *out)
{
  joiner j = {.tree = tree, .views = views, .reach = reach};
  bool done =
      has_none(tree) || (read_leaves(&j, pool, cancel) &&
                         join(&j, may_meet, false, false, pool, cancel));

  free(j.leaf);
  *out = j.hits;
  return done;
}

/* Equal for corners in one place, of three for each leaf. Null: no memory, or
 * stopped. */
static uint32_t *
places_of(const joiner *j, const sg_cancel *cancel)
{
  size_t n = j->tree->boxes->n;
  double(*at)[3] = malloc((3 * n + 1) * sizeof *at);
  uint32_t *place;

  for (size_t i = 0; at && i < 3 * n; i++) {
    memcpy(at[i], j->leaf[i / 3].at[i % 3], sizeof at[i]);
  }
  place = at ? sg_places_of((const double(*)[3])at, 3 * n, cancel) : NULL;
  free(at);
  return place;
}

/* The join of what has more in common than places, and what connects the rest.
 */
static bool
join_few(joiner *j, const uint32_t *place, sg_pool *pool,
         const sg_cancel *cancel)
{
  size_t n = j->tree->boxes->n;
  sg_fan_triangle *named = j->leaf;
  bool good = (j->leaf = malloc(n * sizeof *j->leaf)) != NULL;

  for (size_t i = 0; good && i < n; i++) {
    j->leaf[i] = named[i];
    memcpy(j->leaf[i].name, &place[3 * i], sizeof j->leaf[i].name);
  }
  good = good && join(j, may_meet, true, true, pool, cancel);
  free(j->leaf);
  j->leaf = named;
  return good &&
         sg_self_sheets_add(named, n, place, may_meet, j, cancel, &j->hits);
}

bool
sg_self_leaf_join_few(const sg_leaf_tree *tree, const sg_leaf_views *views,
                      sg_pool *pool, const sg_cancel *cancel, sg_bvh_hits *out)
{
  joiner j = {.tree = tree, .views = views};
  uint32_t *place = NULL;
  bool done = has_none(tree), many = false;

  if (!done && read_leaves(&j, pool, cancel)) {
    place = places_of(&j, cancel);
    done =
        place &&
        sg_self_sheets_are_many(j.leaf, tree->boxes->n, place, cancel, &many) &&
        (many ? join_few(&j, place, pool, cancel)
              : join(&j, may_meet, false, false, pool, cancel));
  }
  if (!done) {
    free(j.hits.hit);
    j.hits = (sg_bvh_hits){0};
  }
  free(place);
  free(j.leaf);
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
                   double grain, sg_pool *pool, const sg_cancel *cancel,
                   bool *out)
{
  joiner j = {.tree = tree, .views = views};
  bool done = has_none(tree) || read_leaves(&j, pool, cancel);

  if (done && j.leaf) {
    j.tolerance = tolerance_of(&j, grain);
    done = join(&j, goes_through, true, false, pool, cancel);
  }
  free(j.leaf);
  free(j.hits.hit);
  *out = done && atomic_load(&j.met);
  return done;
}
