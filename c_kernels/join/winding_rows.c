/* winding_rows.c -- how often a segment goes round points.
 *
 * Layer: rows.
 */
#include "bvh_join.h"
#include "doors/boolean.h"
#include "tree_rows.h"
#include "winding.h"

#include <math.h>
#include <stdlib.h>

/* The points that are asked for, and what is known of them. */
typedef struct asked {
  size_t n;
  sg_point *point;
  sg_winding *winding;
} asked;

/* ---- points ---- */

static void
set_exact(mpq_ptr out, const sg_exact *number)
{
  if (number->text) {
    mpq_set_str(out, number->text, 10);
  } else {
    mpq_set_d(out, number->number);
  }
}

static bool
set_point(const sg_exact_point *at, sg_point *out)
{
  mpq_t q[3];

  for (int k = 0; k < 3; k++) {
    mpq_init(q[k]);
  }
  set_exact(q[0], &at->x);
  set_exact(q[1], &at->y);
  set_exact(q[2], &at->z);
  bool good = sg_point_set_q(out, q[0], q[1], q[2]);

  for (int k = 0; k < 3; k++) {
    mpq_clear(q[k]);
  }
  return good;
}

/* Clear it in any case. */
static bool
open_asked(sg_call *call, const sg_exact_point_list *points, asked *a)
{
  *a = (asked){.point = sg_call_alloc(call, points->n * sizeof *a->point),
               .winding = sg_call_alloc(call, points->n * sizeof *a->winding)};
  if (!a->point || !a->winding) {
    return false;
  }
  for (; a->n < points->n; a->n++) {
    a->winding[a->n] = (sg_winding){.is = SG_WINDING_TURNS};
    if (!set_point(&points->at[a->n], &a->point[a->n])) {
      return sg_call_no_memory(call);
    }
  }
  return true;
}

static void
clear_asked(asked *a)
{
  for (size_t i = 0; i < a->n; i++) {
    sg_point_clear(&a->point[i]);
  }
}

/* ---- rays ---- */

/* A tree of the rays, each from its point to the far end of the segment. Null:
 * no memory, or the cancellation said stop. Doubles are the nearest to the
 * point. */
static sg_bvh *
plant_rays(sg_call *call, const asked *a, const sg_box *all)
{
  sg_box *box = sg_call_alloc(call, a->n * sizeof *box);

  for (size_t i = 0; box && i < a->n; i++) {
    for (int k = 0; k < 3; k++) {
      double at = a->point[i].p[k];
      box[i].lo[k] = nextafter(at, -INFINITY);
      box[i].hi[k] = nextafter(at, INFINITY);
    }
    box[i].hi[0] = fmax(box[i].hi[0], all->hi[0]);
  }
  return box ? sg_bvh_open(box, a->n, &call->cancel) : NULL;
}

static void
count(asked *a, size_t i, const sg_leaf_tree *tree, const sg_leaf_views *views,
      uint32_t row)
{
  sg_leaf leaf = sg_leaf_at(tree, views, row);
  sg_winding *w = &a->winding[i];
  sg_point corner[3];

  for (int k = 0; k < 3; k++) {
    double at[3] = {0};
    sg_leaf_vertex_at(tree, views, leaf.v[k], at);
    sg_point_set(&corner[k], at);
  }
  w->turns += sg_winding_of(&corner[0], &corner[1], &corner[2], &a->point[i]);
  if (sg_is_on_triangle(&corner[0], &corner[1], &corner[2], &a->point[i])) {
    w->is = SG_WINDING_ON;
  }
}

static bool
count_all(sg_call *call, asked *a, const sg_leaf_tree *tree,
          const sg_leaf_views *views)
{
  sg_bvh *rays = plant_rays(call, a, &tree->box);
  sg_bvh_hits hits = {0};
  bool good = rays != NULL && sg_bvh_join(&(sg_bvh_pair){rays, tree->boxes}, 1,
                                          0, NULL, &call->cancel, &hits);

  for (size_t i = 0; i < hits.n && good; i++) {
    good = !sg_cancel_every(&call->cancel, i);
    count(a, rays->item[hits.hit[i].a], tree, views,
          tree->boxes->item[hits.hit[i].b]);
  }
  free(hits.hit);
  sg_bvh_close(rays);
  return good || sg_call_ended(call);
}

/* ---- the door ---- */

bool
sg_door_windings(sg_call *call, int32_t s, const sg_exact_point_list *points,
                 sg_winding_list *windings)
{
  const sg_version *version = sg_call_version(call);
  sg_leaf_views views = {0};
  sg_kept_tree *kept = NULL;
  asked a = {0};
  bool good = version && open_asked(call, points, &a) &&
              sg_leaf_views_open(call, version, &views) &&
              sg_trees_hold(call, version, &views, &s, 1, &kept);

  if (good && !kept->tree->curve && kept->tree->boxes->n > 0) {
    good = count_all(call, &a, kept->tree, &views);
  }
  *windings = (sg_winding_list){a.winding, a.n, 0};
  sg_kept_tree_drop(kept);
  sg_leaf_views_clear(&views);
  clear_asked(&a);
  return good;
}
