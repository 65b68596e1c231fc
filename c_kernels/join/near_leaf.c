#include "near_leaf.h"

#include "apart.h"
#include "engine/search.h"
#include "facing.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

enum { READS = 16 }; /* of leaves, for each pair of them that may be near */

/* A leaf; the last two corners of an edge are one. */
typedef struct placed {
  double corner[3][3];
  sg_apart apart;
  uint32_t of; /* the place of its tree */
} placed;

typedef struct joiner {
  const sg_leaf_tree *const *tree;
  const sg_leaf_views *views;
  double reach;
  bool of_curves;
  placed *leaf; /* [n] */
  size_t n;
  const sg_bvh *all;
  size_t most;
  atomic_size_t near;  /* pairs of leaves */
  atomic_size_t reads; /* leaves read to show that others are apart */
  const sg_cancel *cancel;
} joiner;

/* Too many are near, or it is too much work to show that they are not. */
static bool
is_too_much(joiner *j)
{
  return atomic_load(&j->near) > j->most ||
         atomic_load(&j->reads) / READS > j->most;
}

/* An sg_cancel: so it is, or the caller wants no more. */
static bool
is_enough(void *data)
{
  joiner *j = data;

  return is_too_much(j) || sg_cancelled(j->cancel);
}

static bool
read_leaves(joiner *j, size_t trees, const sg_cancel *cancel)
{
  for (size_t i = 0; i < trees; i++) {
    j->n += j->tree[i]->boxes->n;
  }
  if (!(j->leaf = malloc((j->n + 1) * sizeof *j->leaf))) {
    return false;
  }
  placed *to = j->leaf;

  for (size_t i = 0; i < trees; i++) {
    const sg_leaf_tree *tree = j->tree[i];

    for (size_t k = 0; k < tree->boxes->n; k++, to++) {
      sg_leaf row = sg_leaf_at(tree, j->views, tree->boxes->item[k]);

      to->of = (uint32_t)i;
      for (int c = 0; c < 3; c++) {
        sg_leaf_vertex_at(tree, j->views, row.v[c == 2 && tree->curve ? 1 : c],
                          to->corner[c]);
      }
      sg_apart_make((const double(*)[3])to->corner, j->reach, &to->apart);
      if (sg_cancel_every(cancel, k)) {
        return false;
      }
    }
  }
  return true;
}

/* An sg_facing_read. */
static void
read_corners(const void *data, size_t i, double out[3][3])
{
  memcpy(out, ((const joiner *)data)->leaf[i].corner, sizeof(double[3][3]));
}

/* An sg_bvh_boxes. */
static void
leaf_boxes(const void *data, size_t begin, size_t end, sg_box *out)
{
  const joiner *j = data;

  for (size_t i = begin; i < end; i++) {
    out[i - begin] = j->leaf[i].apart.box;
  }
}

/* Whether the plane of one shows that the other is not near. */
static bool
is_apart(const placed *a, const placed *b)
{
  return sg_apart_by_plane(&a->apart, (const double *const[3]){
                                          b->corner[0],
                                          b->corner[1],
                                          b->corner[2],
                                      });
}

/* An sg_bvh_wants. */
static bool
are_near(void *data, const sg_bvh_hit *hit)
{
  joiner *j = data;
  const placed *a = &j->leaf[j->all->item[hit->a]];
  const placed *b = &j->leaf[j->all->item[hit->b]];

  return a->of != b->of &&
         (j->of_curves || !j->tree[a->of]->curve || !j->tree[b->of]->curve) &&
         !is_apart(a, b) && !is_apart(b, a) &&
         sg_box_overlap(&a->apart.box, &b->apart.box, j->reach) &&
         atomic_fetch_add(&j->near, 1) < j->most;
}

SG_ORDER(by_pair, sg_bvh_hit, SG_BY(a) SG_BY(b));

/* Pairs of leaves become pairs of trees, each once. */
static void
take_trees(const joiner *j, sg_bvh_hits *hits)
{
  size_t n = 0;

  for (size_t i = 0; i < hits->n; i++) {
    sg_bvh_hit *hit = &hits->hit[i];
    uint32_t a = j->leaf[j->all->item[hit->a]].of;
    uint32_t b = j->leaf[j->all->item[hit->b]].of;

    *hit = (sg_bvh_hit){0, a < b ? a : b, a < b ? b : a};
  }
  if (hits->n > 0) {
    qsort(hits->hit, hits->n, sizeof *hits->hit, by_pair);
  }
  for (size_t i = 0; i < hits->n; i++) {
    if (n == 0 || by_pair(&hits->hit[n - 1], &hits->hit[i]) != 0) {
      hits->hit[n++] = hits->hit[i];
    }
  }
  hits->n = n;
}

bool
sg_near_leaves(const sg_leaf_tree *const *tree, size_t n,
               const sg_leaf_views *views, double reach, bool of_curves,
               size_t most, sg_pool *pool, const sg_cancel *cancel,
               sg_bvh_hits *out, bool *more)
{
  joiner j = {.tree = tree,
              .views = views,
              .reach = reach,
              .of_curves = of_curves,
              .most = most,
              .cancel = cancel};
  const sg_cancel enough = {is_enough, &j};
  sg_facing facing = {0};
  sg_box all = sg_box_none();
  sg_bvh *grown = NULL;

  *out = (sg_bvh_hits){0};
  for (size_t i = 0; i < n; i++) {
    sg_box_join(&all, &tree[i]->box);
  }
  bool good = read_leaves(&j, n, cancel) &&
              sg_facing_find(j.n, read_corners, &j, cancel, &facing);

  facing.reads = &j.reads;
  grown = good ? sg_bvh_grow_grouped(j.n, leaf_boxes, &j, NULL, facing.group,
                                     &all, pool, cancel)
               : NULL;
  good = grown &&
         sg_facing_measure(&facing, grown, reach, read_corners, &j, cancel);

  j.all = grown;
  good = good && sg_bvh_join_itself(grown, reach, are_near, &j, sg_facing_apart,
                                    &facing, pool, &enough, out);
  *more = is_too_much(&j);
  if (*more) {
    free(out->hit);
    *out = (sg_bvh_hits){0};
    good = !sg_cancelled(cancel);
  } else if (good) {
    take_trees(&j, out);
  }
  sg_bvh_close(grown);
  sg_facing_clear(&facing);
  free(j.leaf);
  return good;
}
