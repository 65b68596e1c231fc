/* gap_rows.c -- where segments are nearest to each other. */
#include "doors/gluing.h"
#include "engine/list.h"
#include "engine/search.h"
#include "gap.h"
#include "join/near_leaf.h"
#include "join/tree_rows.h"
#include "rows/append_rows.h"
#include "rows/sort.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The least reach that is tried first, as a part of all; then so much more. */
#define FIRST_PART (1.0 / 1024)

enum {
  MORE = 4,
  CROWD = 16, /* pairs for each segment: of more, leaves are joined first */
  LEAVES = 64 /* of these, for each pair, no more */
};

/* The nearest pieces of a pair of segments that were found. */
typedef struct nearest {
  uint32_t tree[2];
  sg_leaf leaf[2];
  sg_gap gap;
} nearest;

typedef struct joining {
  sg_leaf_views views;
  int32_t *s; /* ascending */
  size_t n;
  sg_kept_tree **tree; /* [n], held */
  size_t pairs;
  nearest *nearest; /* [pairs] */
  bool *far;        /* [pairs] farther apart than all that is asked */
  sg_bvh_pair *wanted;
  uint32_t *which; /* of which pair wanted[i] is */
  double reach;
} joining;

static void
list_segments(const sg_id_pair_list *pairs, joining *j)
{
  for (size_t i = 0; i < pairs->n; i++) {
    j->s[j->n++] = pairs->at[i].a;
    j->s[j->n++] = pairs->at[i].b;
  }
  j->n = sg_sort_ids(j->s, j->n);
}

/* False: `close_joining` all the same. */
static bool
open_joining(sg_call *call, const sg_id_pair_list *pairs, joining *j)
{
  const sg_version *version = sg_call_version(call);
  size_t n = pairs->n;

  j->s = sg_call_alloc(call, (2 * n + 1) * sizeof *j->s);
  j->nearest = sg_call_alloc(call, (n + 1) * sizeof *j->nearest);
  j->far = sg_call_alloc(call, (n + 1) * sizeof *j->far);
  j->wanted = sg_call_alloc(call, (n + 1) * sizeof *j->wanted);
  j->which = sg_call_alloc(call, (n + 1) * sizeof *j->which);
  if (!version || !j->s || !j->nearest || !j->far || !j->wanted || !j->which) {
    return false;
  }
  list_segments(pairs, j);
  sg_kept_tree **tree = sg_call_alloc(call, (j->n + 1) * sizeof *tree);

  if (!tree || !sg_leaf_views_open(call, version, &j->views) ||
      !sg_trees_hold(call, version, &j->views, j->s, j->n, tree)) {
    return false;
  }
  j->tree = tree;
  j->pairs = n;
  for (size_t i = 0; i < n; i++) {
    j->nearest[i] =
        (nearest){.tree = {(uint32_t)sg_find_id(j->s, j->n, pairs->at[i].a),
                           (uint32_t)sg_find_id(j->s, j->n, pairs->at[i].b)},
                  .gap.apart = INFINITY};
  }
  return true;
}

static void
close_joining(joining *j)
{
  for (size_t i = 0; j->tree && i < j->n; i++) {
    sg_kept_tree_drop(j->tree[i]);
  }
  sg_leaf_views_clear(&j->views);
}

/* Whether a pair of trees is among ascending hits, or is one tree. */
static bool
is_among(const sg_bvh_hits *hits, const uint32_t tree[2])
{
  uint32_t a = tree[tree[1] < tree[0]], b = tree[tree[0] <= tree[1]];
  const sg_bvh_hit *hit = hits->hit;
  size_t at;

  SG_SEARCH(at, 0, hits->n, hit[at].a < a || (hit[at].a == a && hit[at].b < b));
  return a == b || (at < hits->n && hit[at].a == a && hit[at].b == b);
}

/* Notes which pairs are far. Where each segment is in many, as of segments that
 * lie in each other, by one tree of their leaves. */
static bool
find_far(sg_call *call, joining *j, double reach)
{
  const sg_leaf_tree **tree = sg_call_alloc(call, (j->n + 1) * sizeof *tree);
  sg_bvh_hits hits = {0};
  bool more = false;

  memset(j->far, 0, j->pairs * sizeof *j->far);
  if (!tree || j->pairs <= CROWD * j->n) {
    return tree != NULL;
  }
  for (size_t i = 0; i < j->n; i++) {
    tree[i] = j->tree[i]->tree;
  }
  if (!sg_near_leaves(tree, j->n, &j->views, reach, true, LEAVES * j->pairs,
                      sg_call_pool(call), &call->cancel, &hits, &more)) {
    return sg_call_ended(call);
  }
  for (size_t i = 0; i < j->pairs && !more; i++) {
    j->far[i] = !is_among(&hits, j->nearest[i].tree);
  }
  free(hits.hit);
  return true;
}

static sg_leaf
read_piece(const joining *j, uint32_t which, uint32_t place, sg_gap_piece *out)
{
  const sg_leaf_tree *tree = j->tree[which]->tree;
  sg_leaf leaf = sg_leaf_at(tree, &j->views, tree->boxes->item[place]);

  *out = (sg_gap_piece){.corners = tree->curve ? 2 : 3};
  for (int k = 0; k < out->corners; k++) {
    sg_leaf_vertex_at(tree, &j->views, leaf.v[k], out->at[k]);
  }
  return leaf;
}

static nearest
nearest_of(const joining *j, const sg_bvh_hit *hit)
{
  nearest of = j->nearest[j->which[hit->pair]];
  sg_gap_piece piece[2];

  of.leaf[0] = read_piece(j, of.tree[0], hit->a, &piece[0]);
  of.leaf[1] = read_piece(j, of.tree[1], hit->b, &piece[1]);
  of.gap = sg_gap_between(&piece[0], &piece[1]);
  return of;
}

static bool
is_within(void *data, const sg_bvh_hit *hit)
{
  const joining *j = data;

  return nearest_of(j, hit).gap.apart <= j->reach;
}

/* Of those that are as near, the first pieces by their numbers. */
SG_ORDER(compare_nearest, nearest,
         SG_BY(gap.apart) SG_BY(leaf[0].p) SG_BY(leaf[0].id) SG_BY(leaf[1].p)
             SG_BY(leaf[1].id));

/* Of the pairs that have none yet, what is nearest within the reach. */
static bool
join_some(sg_call *call, joining *j)
{
  sg_bvh_hits hits = {0};
  size_t n = 0;

  for (size_t i = 0; i < j->pairs; i++) {
    const nearest *of = &j->nearest[i];
    const sg_bvh *a = j->tree[of->tree[0]]->tree->boxes;
    const sg_bvh *b = j->tree[of->tree[1]]->tree->boxes;

    if (!j->far[i] && isinf(of->gap.apart) && a->n > 0 && b->n > 0) {
      j->which[n] = (uint32_t)i;
      j->wanted[n++] = (sg_bvh_pair){a, b};
    }
  }
  if (n > 0 && !sg_bvh_join_wanted(j->wanted, n, j->reach, is_within, j,
                                   sg_call_pool(call), &call->cancel, &hits)) {
    return sg_call_ended(call);
  }
  for (size_t i = 0; i < hits.n; i++) {
    nearest one = nearest_of(j, &hits.hit[i]);
    nearest *best = &j->nearest[j->which[hits.hit[i].pair]];

    if (isinf(best->gap.apart) || compare_nearest(&one, best) < 0) {
      *best = one;
    }
  }
  free(hits.hit);
  return true;
}

static int32_t
item_of(const sg_leaf *leaf)
{
  return leaf->p > 0 ? leaf->p : leaf->id;
}

static sg_gap_ends
ends_of(const sg_gap *gap)
{
  sg_space_point end[2];

  for (int k = 0; k < 2; k++) {
    const double *at = gap->end[k];

    end[k] = (sg_space_point){at[0] + 0.0, at[1] + 0.0, at[2] + 0.0};
  }
  return (sg_gap_ends){end[0], end[1]};
}

bool
sg_door_segment_gaps(sg_call *call, const sg_id_pair_list *pairs, double reach,
                     sg_segment_gap_list *gaps)
{
  joining j = {.reach = reach * FIRST_PART};

  if (reach < 0) {
    return sg_call_domain(call, "not_less_than_zero", 2);
  }
  bool good = open_joining(call, pairs, &j) && find_far(call, &j, reach);

  for (bool last = false; good && !last; j.reach *= MORE) {
    last = j.reach >= reach;
    j.reach = last ? reach : j.reach;
    good = join_some(call, &j);
  }
  for (size_t i = 0; good && i < j.pairs; i++) {
    const nearest *of = &j.nearest[i];
    const sg_segment_gap gap = {.of1 = {pairs->at[i].a, item_of(&of->leaf[0])},
                                .of2 = {pairs->at[i].b, item_of(&of->leaf[1])},
                                .distance = of->gap.apart,
                                .ends = ends_of(&of->gap)};

    good = isinf(of->gap.apart) || sg_segment_gap_list_add(call, gaps, gap);
  }
  close_joining(&j);
  return good;
}

/* ---- two polygons ---- */

typedef SG_LIST_OF(sg_gap_piece) pieces;

static bool
read_corners(const sg_version *version, int32_t s, sg_row triangle,
             sg_gap_piece *out)
{
  out->corners = 3;
  for (unsigned k = 0; k < 3; k++) {
    int32_t v = sg_version_value(version, SG_T, triangle, 3 + k).i;
    const sg_value key[SG_MAX_COLUMNS] = {[0].i = s, [1].i = v};
    sg_row row = sg_version_find(version, SG_V, key);

    for (unsigned c = 0; row != SG_NO_ROW && c < 3; c++) {
      out->at[k][c] = sg_version_value(version, SG_V, row, 2 + c).f;
    }
    if (row == SG_NO_ROW) {
      return false;
    }
  }
  return true;
}

/* The triangles of a polygon; free() its items in any case. */
static bool
read_polygon(sg_call *call, const sg_version *version, const sg_id_pair *facet,
             pieces *out)
{
  sg_segment_rows rows = {0};
  bool good = sg_rows_of_segment(call, version, SG_T, facet->a, &rows) &&
              (sg_list_need(&out->item, rows.begin[1] + 1, &out->room,
                            sizeof(sg_gap_piece)) ||
               sg_call_no_memory(call));

  for (size_t i = 0; good && i < rows.begin[1]; i++) {
    if (sg_version_value(version, SG_T, rows.row[i], 1).i == facet->b &&
        read_corners(version, facet->a, rows.row[i], &out->item[out->n])) {
      out->n++;
    }
  }
  sg_segment_rows_clear(&rows);
  return good;
}

bool
sg_door_polygon_gap(sg_call *call, const sg_id_pair *facet1,
                    const sg_id_pair *facet2, double *gap, sg_gap_ends *ends)
{
  const sg_version *version = sg_call_version(call);
  sg_gap least = {.apart = INFINITY};
  pieces a = {0}, b = {0};
  bool good = version && read_polygon(call, version, facet1, &a) &&
              read_polygon(call, version, facet2, &b);

  for (size_t i = 0; good && i < a.n * b.n; i++) {
    sg_gap one = sg_gap_between(&a.item[i / b.n], &b.item[i % b.n]);

    least = one.apart < least.apart ? one : least;
    good = !sg_cancel_every(&call->cancel, i) || sg_call_ended(call);
  }
  free(a.item);
  free(b.item);
  *gap = least.apart;
  *ends = ends_of(&least);
  return good && isfinite(least.apart);
}
