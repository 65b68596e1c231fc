/* winding4pl.c -- how often a segment goes round points, as a predicate.
 *
 * Layer: glue. The door is documented in rules/kernel/boolean.pl.
 */
#include "tree4pl.h"

#include "bvh_join.h"
#include "glue.h"
#include "winding.h"

#include "engine/install.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The points that are asked for, and what is known of them. */
typedef struct asked {
  size_t n;
  sg_point *point;
  int *turns;
  bool *on;
} asked;

static atom_t atom_on;

/* ---- points ---- */

/* A number of any sort that has an exact value. */
static int
get_exact_ex(term_t t, mpq_t out)
{
  double d;

  if (PL_is_rational(t)) { /* as text: PL_get_mpq() of 9.0.4 fails */
    char *text, *bar;

    int good;
    PL_STRINGS_MARK();
    good = PL_get_chars(t, &text, CVT_RATIONAL | CVT_INTEGER | CVT_EXCEPTION);
    if (good && (bar = strchr(text, 'r'))) {
      *bar = '/';
    }
    good = good &&
           (mpq_set_str(out, text, 10) == 0 || PL_type_error("rational", t));
    PL_STRINGS_RELEASE();
    return good;
  }
  if (!sg_get_finite_ex(t, &d)) {
    return FALSE;
  }
  mpq_set_d(out, d);
  return TRUE;
}

/* point(X, Y, Z). */
static int
get_point_ex(term_t t, sg_point *out)
{
  term_t arg = PL_new_term_ref();
  mpq_t q[3];
  int good = PL_is_functor(t, PL_new_functor(PL_new_atom("point"), 3)) ||
             PL_type_error("point", t);

  for (int k = 0; k < 3; k++) {
    mpq_init(q[k]);
  }
  for (int k = 0; k < 3 && good; k++) {
    good = PL_get_arg(k + 1, t, arg) && get_exact_ex(arg, q[k]);
  }
  good = good && (sg_point_set_q(out, q[0], q[1], q[2]) || sg_no_memory());
  for (int k = 0; k < 3; k++) {
    mpq_clear(q[k]);
  }
  return good;
}

static int
get_points_ex(term_t list, asked *out)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  size_t n;

  if (PL_skip_list(list, 0, &n) != PL_LIST) {
    return PL_type_error("list", list);
  }
  out->point = calloc(n + 1, sizeof *out->point);
  out->turns = calloc(n + 1, sizeof *out->turns);
  out->on = calloc(n + 1, sizeof *out->on);
  if (!out->point || !out->turns || !out->on) {
    return sg_no_memory();
  }
  for (; out->n < n; out->n++) {
    if (!PL_get_list_ex(tail, head, tail) ||
        !get_point_ex(head, &out->point[out->n])) {
      return FALSE;
    }
  }
  return TRUE;
}

static void
clear_asked(asked *a)
{
  for (size_t i = 0; i < a->n; i++) {
    sg_point_clear(&a->point[i]);
  }
  free(a->point);
  free(a->turns);
  free(a->on);
}

/* ---- rays ---- */

/* A tree of the rays, each from its point to the far end of the segment. Null:
 * no memory, or the poll said stop. Doubles are the nearest to the point. */
static sg_bvh *
plant_rays(const asked *a, const sg_box *all)
{
  sg_box *box = malloc((a->n + 1) * sizeof *box);
  sg_bvh *tree = NULL;

  for (size_t i = 0; box && i < a->n; i++) {
    for (int k = 0; k < 3; k++) {
      double at = a->point[i].p[k];
      box[i].lo[k] = nextafter(at, -INFINITY);
      box[i].hi[k] = nextafter(at, INFINITY);
    }
    box[i].hi[0] = fmax(box[i].hi[0], all->hi[0]);
  }
  if (box) {
    tree = sg_bvh_open(box, a->n, &sg_prolog_poll);
  }
  free(box);
  return tree;
}

static void
count(asked *a, size_t i, const sg_leaf_tree *tree, const sg_leaf_views *views,
      uint32_t row)
{
  sg_leaf leaf = sg_leaf_at(tree, views, row);
  sg_point corner[3];

  for (int k = 0; k < 3; k++) {
    double at[3] = {0};
    sg_leaf_vertex_at(tree, views, leaf.v[k], at);
    sg_point_set(&corner[k], at);
  }
  a->turns[i] +=
      sg_winding_of(&corner[0], &corner[1], &corner[2], &a->point[i]);
  a->on[i] = a->on[i] || sg_is_on_triangle(&corner[0], &corner[1], &corner[2],
                                           &a->point[i]);
}

static int
count_all_ex(asked *a, const sg_leaf_tree *tree, const sg_leaf_views *views)
{
  sg_bvh *rays = plant_rays(a, &tree->box);
  sg_bvh_hits hits = {0};
  int good = rays != NULL && sg_bvh_join(&(sg_bvh_pair){rays, tree->boxes}, 1,
                                         0, NULL, &sg_prolog_poll, &hits);

  for (size_t i = 0; i < hits.n && good; i++) {
    if (i % 4096 == 4095 && PL_handle_signals() < 0) {
      good = FALSE;
    }
    count(a, rays->item[hits.hit[i].a], tree, views,
          tree->boxes->item[hits.hit[i].b]);
  }
  free(hits.hit);
  sg_bvh_close(rays);
  return good || PL_exception(0) ? good : sg_no_memory();
}

/* ---- the door ---- */

static int
unify_windings(term_t list, const asked *a)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  for (size_t i = 0; i < a->n; i++) {
    if (!PL_unify_list(tail, head, tail) ||
        !(a->on[i] ? PL_unify_atom(head, atom_on)
                   : PL_unify_integer(head, a->turns[i]))) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

static int
windings_ex(sg_world *world, const sg_version *version, int32_t s, asked *a)
{
  sg_leaf_views views;
  sg_kept_tree *kept;
  int good;

  if (!sg_leaf_views_ex(version, &views)) {
    return FALSE;
  }
  good = sg_trees_hold_ex(world, version, &views, &s, 1, NULL, &kept);
  if (good) {
    good = kept->tree->curve || kept->tree->boxes->n == 0 ||
           count_all_ex(a, kept->tree, &views);
    sg_kept_tree_drop(kept);
  }
  sg_leaf_views_clear(&views);
  return good;
}

/* windings(+S, +Points, -Windings) is det. */
static foreign_t
windings(term_t s, term_t points, term_t list)
{
  sg_world *world = sg_current_world_ex();
  asked a = {0};
  int32_t segment;

  if (!world || !sg_get_id_ex(s, &segment)) {
    return FALSE;
  }
  const sg_version *version = sg_world_version(world);
  int good = get_points_ex(points, &a) &&
             windings_ex(world, version, segment, &a) &&
             unify_windings(list, &a);

  clear_asked(&a);
  sg_version_drop(version);
  return good;
}

void
sg_install_winding(void)
{
  static const PL_extension doors[] = {
      {"windings", 3, (pl_function_t)windings, 0}, {NULL, 0, NULL, 0}};

  atom_on = PL_new_atom("on");
  PL_register_extensions_in_module("sg_kernel_boolean", doors);
}
