/* near_rows.c -- which segments are near each other.
 *
 * Layer: rows.
 */
#include "near_leaf.h"

#include "doors/world.h"
#include "engine/search.h"
#include "rows/sort.h"
#include "tree_rows.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  CROWD = 16,    /* other boxes */
  BESIDE = 26,   /* other boxes that one on a grid meets */
  SOME = 64,     /* boxes that are asked how many others there are */
  ALONG = 2,     /* the reach is along each axis: in any other way, that many */
  LEAVES = 64,   /* for each pair of boxes: no more are joined instead, and no
                    more pairs of them taken */
  CURVES = 8,    /* curves are no more than this part: they are asked, too */
  FEATURES = 512 /* reaches, in which what a move is measured beside is */
};

#define ROUNDED 0x1p-40

/* Segments of a version and their boxes. */
typedef struct boxed {
  const sg_version *version;
  double reach;
  size_t n;
  int32_t *s; /* ascending */
  sg_box *box;
  bool to_cut;   /* which may cut each other, not which are near */
  size_t curves; /* so many are called so */
  bool *curve;   /* [n] those of which two are no pair; null: each two may be */
} boxed;

SG_ORDER(compare_pairs, sg_near_segments_row, SG_BY(s1) SG_BY(s2));

static void
sort_pairs(sg_near_segments_rows *pairs)
{
  if (pairs->n > 0) {
    qsort(pairs->at, pairs->n, sizeof *pairs->at, compare_pairs);
  }
}

static bool
is_called_curve(const boxed *all, sg_row of)
{
  return sg_version_value(all->version, SG_SEGMENT, of, 1).i == SG_SYMBOL_CURVE;
}

/* The segments of segment/3 that are wanted; null: all. */
static bool
list_segments(sg_call *call, const sg_int_list *wanted, boxed *out)
{
  size_t n = sg_version_count(out->version, SG_SEGMENT);
  sg_walk walk;

  out->s = sg_call_alloc(call, n * sizeof *out->s);
  out->box = sg_call_alloc(call, n * sizeof *out->box);
  if (!out->s || !out->box ||
      !sg_walk_open(&walk, out->version, SG_SEGMENT, 0, NULL)) {
    return sg_call_no_memory(call);
  }
  for (sg_row row; (row = sg_walk_next(&walk)) != SG_NO_ROW && out->n < n;) {
    int32_t id = sg_version_value(out->version, SG_SEGMENT, row, 0).i;

    if (!wanted || sg_find_id(wanted->at, wanted->n, id) != SIZE_MAX) {
      out->s[out->n++] = id;
      out->curves += is_called_curve(out, row);
    }
  }
  sg_walk_close(&walk);
  out->n = sg_sort_ids(out->s, out->n);
  return true;
}

/* Boxes: of trees that are kept, else from the vertices. */
static bool
find_boxes(sg_call *call, boxed *out)
{
  int32_t *missing = sg_call_alloc(call, out->n * sizeof *missing);
  sg_box *box = sg_call_alloc(call, out->n * sizeof *box);
  sg_pool *pool = sg_call_pool(call);
  size_t m = 0;
  sg_view vertices = {0};

  if (!missing || !box || !pool) {
    return false;
  }
  for (size_t i = 0; i < out->n; i++) {
    if (!sg_kept_box(out->version, out->s[i], &out->box[i])) {
      missing[m++] = out->s[i];
    }
  }
  bool good = m == 0 ||
              (sg_version_view(out->version, SG_V, &vertices) &&
               sg_leaf_boxes(&vertices, missing, m, pool, &call->cancel, box));

  for (size_t i = 0, k = 0; k < m && good; i++) {
    if (out->s[i] == missing[k]) {
      out->box[i] = box[k++];
    }
  }
  sg_view_clear(&vertices);
  return good || sg_call_ended(call);
}

/* A segment of edges alone. */
static bool
is_curve(const boxed *all, int32_t s)
{
  const sg_value key[SG_MAX_COLUMNS] = {[0].i = s};
  bool any =
      !is_called_curve(all, sg_version_find(all->version, SG_SEGMENT, key));

  for (int k = 0; k < 2 && !any; k++) {
    sg_walk walk;

    any = !sg_walk_open(&walk, all->version, k ? SG_T : SG_P, 1, key);
    if (!any) {
      any = sg_walk_next(&walk) != SG_NO_ROW;
      sg_walk_close(&walk);
    }
  }
  return !any;
}

/* If there may be two. */
static bool
find_curves(sg_call *call, boxed *all)
{
  if (all->curves < 2) {
    return true;
  }
  all->curve = sg_call_alloc(call, all->n * sizeof *all->curve);
  for (size_t i = 0; all->curve && i < all->n; i++) {
    all->curve[i] = is_curve(all, all->s[i]);
  }
  return all->curve != NULL;
}

/* Those boxes that are of curves, or are not; the others empty. */
static sg_bvh *
tree_of(sg_call *call, const boxed *all, const sg_box *box, bool curves)
{
  sg_box *of = sg_call_alloc(call, all->n * sizeof *of);

  for (size_t i = 0; of && i < all->n; i++) {
    of[i] = all->curve[i] == curves ? box[i] : sg_box_none();
  }
  return of ? sg_bvh_open(of, all->n, &call->cancel) : NULL;
}

/* The pairs whose boxes overlap within the reach, as places, of those whose
 * other boxes do within another reach. */
static bool
join_boxes(sg_call *call, const boxed *all, const sg_box *other, double reach,
           sg_bvh_hits *hits)
{
  sg_bvh *tree = all->curve ? tree_of(call, all, other, false)
                            : sg_bvh_open(other, all->n, &call->cancel);
  sg_bvh *curves = all->curve ? tree_of(call, all, other, true) : NULL;
  const sg_bvh_pair pair[] = {{tree, tree}, {tree, curves}};
  bool good =
      tree && (curves || !all->curve) &&
      sg_bvh_join(pair, curves ? 2 : 1, reach, NULL, &call->cancel, hits);
  size_t n = 0;

  for (size_t k = 0; good && k < hits->n; k++) {
    const sg_bvh_hit *hit = &hits->hit[k];
    uint32_t i = tree->item[hit->a], j = pair[hit->pair].b->item[hit->b];

    if (sg_box_overlap(&all->box[i], &all->box[j], all->reach)) {
      hits->hit[n++] = (sg_bvh_hit){0, i < j ? i : j, i < j ? j : i};
    }
  }
  hits->n = n;
  sg_bvh_close(tree);
  sg_bvh_close(curves);
  return good || sg_call_ended(call);
}

/* Whether boxes overlap more than CROWD others, on average of some; about how
 * many pairs there are. */
static bool
are_crowded(const boxed *all, double *pairs)
{
  size_t step = all->n / SOME + 1, asked = 0, met = 0;

  for (size_t i = 0; i < all->n; i += step) {
    asked++;
    for (size_t k = 0; k < all->n; k++) {
      met += i != k && sg_box_overlap(&all->box[i], &all->box[k], all->reach);
    }
  }
  *pairs = asked > 0 ? (double)met / (double)asked * (double)all->n / 2 : 0;
  return met > CROWD * asked;
}

/* Whether all polygons that can have triangles have them: what has polygons and
 * no triangle is no curve. */
static bool
are_filled(const boxed *all, sg_kept_tree *const *kept)
{
  bool filled = true;

  for (size_t i = 0; i < all->n && filled; i++) {
    filled = !kept[i]->tree->curve || is_curve(all, all->s[i]);
  }
  return filled;
}

/* The pairs of boxes that have leaves near each other. What touches is made to
 * touch beside what is in FEATURES reaches. *done: this was possible. */
static bool
join_kept(sg_call *call, const boxed *all, sg_kept_tree *const *kept,
          const sg_leaf_views *views, double pairs, sg_bvh_hits *hits,
          bool *done)
{
  const sg_leaf_tree **tree = sg_call_alloc(call, all->n * sizeof *tree);
  size_t n = 0;
  bool more = false;

  if (!tree) {
    return false;
  }
  *done = are_filled(all, kept);
  for (size_t i = 0; i < all->n; i++) {
    tree[i] = kept[i]->tree;
  }
  if (*done &&
      !sg_near_leaves(tree, all->n, views, FEATURES * all->reach, false,
                      (size_t)(LEAVES * pairs), sg_call_pool(call),
                      &call->cancel, hits, &more)) {
    return sg_call_ended(call);
  }
  *done = *done && !more;
  for (size_t k = 0; k < hits->n; k++) {
    const sg_bvh_hit *hit = &hits->hit[k];

    if (sg_box_overlap(&all->box[hit->a], &all->box[hit->b], all->reach)) {
      hits->hit[n++] = *hit;
    }
  }
  hits->n = n;
  return true;
}

static bool
join_leaves(sg_call *call, const boxed *all, double pairs, sg_bvh_hits *hits,
            bool *done)
{
  sg_kept_tree **kept = sg_call_alloc(call, all->n * sizeof(sg_kept_tree *));
  sg_leaf_views views = {0};
  bool good = kept && sg_leaf_views_open(call, all->version, &views) &&
              sg_trees_hold(call, all->version, &views, all->s, all->n, kept);

  if (good) {
    good = join_kept(call, all, kept, &views, pairs, hits, done);
    for (size_t i = 0; i < all->n; i++) {
      sg_kept_tree_drop(kept[i]);
    }
  }
  sg_leaf_views_clear(&views);
  return good;
}

/* Where many boxes overlap: by leaves, if they are not so many that pairs of
 * boxes are less work. */
static bool
join_crowd(sg_call *call, const boxed *all, double pairs, sg_bvh_hits *hits)
{
  bool done = false;

  if (all->to_cut && CURVES * all->curves <= all->n &&
      2 * pairs > BESIDE * (double)all->n &&
      (double)sg_version_count(all->version, SG_T) <= LEAVES * pairs &&
      !join_leaves(call, all, pairs, hits, &done)) {
    return false;
  }
  return done || join_boxes(call, all, all->box, all->reach, hits);
}

/* The axes along which most boxes run, by two of their sides. */
static void
find_run(const sg_oriented_box *box, size_t n, sg_run *run)
{
  for (size_t i = 0; i < n; i++) {
    double corner[3][3];

    memcpy(corner, box[i].corner, sizeof corner);
    sg_run_add(run, (const double(*)[3])corner);
  }
  sg_run_end(run);
}

/* The box of a box along these axes, and what rounding may have taken. */
static sg_box
turned_box(const sg_run *run, const sg_oriented_box *box)
{
  sg_box out = sg_box_none();
  double size = 0;

  for (int c = 0; c < 8; c++) {
    double at[3];

    sg_run_turn(run, box->corner[c], at);
    sg_box_add(&out, at);
    for (int k = 0; k < 3; k++) {
      size = fabs(box->corner[c][k]) > size ? fabs(box->corner[c][k]) : size;
    }
  }
  for (int k = 0; k < 3; k++) {
    out.lo[k] -= ROUNDED * size;
    out.hi[k] += ROUNDED * size;
  }
  return out;
}

/* The same pairs, where many boxes overlap. If most segments run one way askew,
 * of those whose boxes that way overlap: the others are apart. */
static bool
join_askew(sg_call *call, const boxed *all, double pairs, sg_bvh_hits *hits)
{
  int32_t *full = sg_call_alloc(call, all->n * sizeof *full);
  sg_oriented_box *box = sg_call_alloc(call, all->n * sizeof *box);
  sg_box *turned = sg_call_alloc(call, all->n * sizeof *turned);
  sg_view vertices = {0};
  sg_run run = {.askew = false};
  size_t n = 0;

  if (!full || !box || !turned) {
    return false;
  }
  for (size_t i = 0; i < all->n; i++) {
    if (all->box[i].lo[0] <= all->box[i].hi[0]) {
      full[n++] = all->s[i];
    }
  }
  bool good = sg_version_view(all->version, SG_V, &vertices) &&
              sg_leaf_oriented_boxes(&vertices, full, n, sg_call_pool(call),
                                     &call->cancel, box);

  sg_view_clear(&vertices);
  if (!good) {
    return sg_call_ended(call);
  }
  find_run(box, n, &run);
  if (!run.askew) {
    return join_crowd(call, all, pairs, hits);
  }
  for (size_t i = 0, k = 0; i < all->n; i++) {
    bool is_full = k < n && full[k] == all->s[i];

    turned[i] = is_full ? turned_box(&run, &box[k++]) : sg_box_none();
  }
  return join_boxes(call, all, turned, ALONG * all->reach, hits);
}

/* Which segments overlap so many others that it is worth to look at them along
 * their own axes: where[i] is the place of segment i among these, or -1. */
static size_t
find_crowded(const boxed *all, const sg_bvh_hits *hits, int64_t *where,
             int32_t *crowded)
{
  size_t n = 0;

  memset(where, 0, all->n * sizeof *where);
  for (size_t k = 0; k < hits->n; k++) {
    where[hits->hit[k].a]++;
    where[hits->hit[k].b]++;
  }
  for (size_t i = 0; i < all->n; i++) {
    bool is_crowded = where[i] > CROWD;

    where[i] = is_crowded ? (int64_t)n : -1;
    if (is_crowded) {
      crowded[n++] = all->s[i];
    }
  }
  return n;
}

static void
drop_hits(sg_bvh_hits *hits, const int64_t *where, const sg_oriented_box *box,
          double reach)
{
  size_t n = 0;

  for (size_t k = 0; k < hits->n; k++) {
    int64_t i = where[hits->hit[k].a], j = where[hits->hit[k].b];

    if (i < 0 || j < 0 || !sg_oriented_boxes_apart(&box[i], &box[j], reach)) {
      hits->hit[n++] = hits->hit[k];
    }
  }
  hits->n = n;
}

/* Drops pairs of segments that boxes along their own axes show to be apart. */
static bool
drop_apart(sg_call *call, const boxed *all, sg_bvh_hits *hits)
{
  int64_t *where = sg_call_alloc(call, all->n * sizeof *where);
  int32_t *crowded = sg_call_alloc(call, all->n * sizeof *crowded);
  size_t n = where && crowded ? find_crowded(all, hits, where, crowded) : 0;
  sg_oriented_box *box = sg_call_alloc(call, n * sizeof *box);
  sg_view vertices = {0};

  if (!box || n == 0) {
    return where && crowded && box;
  }
  bool good = sg_version_view(all->version, SG_V, &vertices) &&
              sg_leaf_oriented_boxes(&vertices, crowded, n, sg_call_pool(call),
                                     &call->cancel, box);
  if (good) {
    drop_hits(hits, where, box, ALONG * all->reach);
  }
  sg_view_clear(&vertices);
  return good || sg_call_ended(call);
}

/* The pairs of wanted segments (null: of all) that are near each other; or of
 * those that may cut each other. */
static bool
find_near(sg_call *call, double reach, const sg_int_list *wanted, bool to_cut,
          sg_near_segments_rows *out)
{
  boxed all = {
      .version = sg_call_version(call), .reach = reach, .to_cut = to_cut};
  sg_bvh_hits hits = {0};
  double pairs;

  if (reach < 0) {
    return sg_call_domain(call, "not_less_than_zero", 1);
  }
  bool good = all.version && list_segments(call, wanted, &all) &&
              (!to_cut || find_curves(call, &all)) && find_boxes(call, &all) &&
              (are_crowded(&all, &pairs)
                   ? join_askew(call, &all, pairs, &hits)
                   : join_boxes(call, &all, all.box, reach, &hits)) &&
              drop_apart(call, &all, &hits);

  for (size_t k = 0; k < hits.n && good; k++) {
    good = sg_near_segments_rows_add(
        call, out,
        (sg_near_segments_row){all.s[hits.hit[k].a], all.s[hits.hit[k].b]});
  }
  free(hits.hit);
  sort_pairs(out);
  return good;
}

bool
sg_door_near_segments(sg_call *call, double reach, const int32_t *s1,
                      const int32_t *s2, sg_near_segments_rows *rows)
{
  (void)s1;
  (void)s2;
  return find_near(call, reach, NULL, true, rows);
}

bool
sg_door_near_pairs(sg_call *call, double reach, const sg_int_list *ss,
                   sg_id_pair_list *pairs)
{
  sg_near_segments_rows rows = {0};
  bool good = find_near(call, reach, ss, true, &rows);

  for (size_t i = 0; good && i < rows.n; i++) {
    good = sg_id_pair_list_add(call, pairs,
                               (sg_id_pair){rows.at[i].s1, rows.at[i].s2});
  }
  return good;
}

bool
sg_door_near_segments_of(sg_call *call, double reach, const sg_int_list *ss,
                         sg_near_others_list *near)
{
  sg_near_segments_rows pairs = {0};

  if (!find_near(call, reach, ss, false, &pairs)) {
    return false;
  }
  for (size_t i = 0, n = pairs.n; i < n; i++) { /* both ways round */
    const sg_near_segments_row back = {pairs.at[i].s2, pairs.at[i].s1};

    if (!sg_near_segments_rows_add(call, &pairs, back)) {
      return false;
    }
  }
  sort_pairs(&pairs);
  for (size_t i = 0, k = 0; i < ss->n; i++) {
    sg_near_others of = {.s = ss->at[i]};

    for (; k < pairs.n && pairs.at[k].s1 == of.s; k++) {
      if (!sg_int_list_add(call, &of.others, pairs.at[k].s2)) {
        return false;
      }
    }
    if (!sg_near_others_list_add(call, near, of)) {
      return false;
    }
  }
  return true;
}
