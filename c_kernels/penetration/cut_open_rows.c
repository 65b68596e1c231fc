/* cut_open_rows.c -- cut sets: the segments, their trees, and the candidates.
 *
 * Layer: rows. Trees are kept with the world (tree_rows.h). All
 * pairs of segments are joined at once; what comes out is given numbers in the
 * order of the join, so that triangles which nothing comes near are never
 * looked at.
 */
#include "cut_coincident.h"
#include "cut_rows.h"

#include "doors/penetration.h"
#include "engine/list.h"
#include "engine/search.h"
#include "join/apart.h"
#include "join/bvh_join.h"
#include "join/self_leaf.h"

#include <stdlib.h>
#include <string.h>

enum { ASKED = 1 << 14 }; /* hits between questions */

/* ---- the segments ---- */

static bool
want_segment(sg_call *call, sg_cut_handle *handle, int32_t s)
{
  uint32_t key = (uint32_t)s;
  uint32_t *next = sg_key_table_put(&handle->next_name, &key);

  if (!next) {
    return sg_call_no_memory(call);
  }
  if (*next == SG_NO_KEY) {
    int32_t fresh = sg_call_fresh(call, handle->world, SG_V, s);

    if (fresh == 0) {
      return false;
    }
    *next = (uint32_t)fresh;
    handle->segment[handle->segments++] = s;
  }
  return true;
}

static bool
note_pairs(sg_call *call, sg_cut_handle *handle, const sg_id_pair_list *pairs)
{
  size_t n = pairs->n;

  handle->pair = malloc((n + 1) * sizeof *handle->pair);
  handle->segment = malloc((2 * n + 1) * sizeof *handle->segment);
  if (!handle->pair || !handle->segment) {
    return sg_call_no_memory(call);
  }
  for (; handle->pairs < n; handle->pairs++) {
    int32_t *s = handle->pair[handle->pairs];

    s[0] = pairs->at[handle->pairs].a;
    s[1] = pairs->at[handle->pairs].b;
    if (!want_segment(call, handle, s[0]) ||
        !want_segment(call, handle, s[1])) {
      return false;
    }
    if (s[0] == s[1] &&
        !sg_cut_points_set_by_itself(&handle->set.points, s[0])) {
      return sg_call_no_memory(call);
    }
  }
  return true;
}

size_t
sg_cut_place_of(const sg_cut_handle *handle, int32_t s)
{
  return sg_find_id(handle->segment, handle->segments, s);
}

/* An sg_fetch_vertex. */
static bool
fetch_vertex(void *data, int32_t s, int32_t v, double at[3])
{
  const sg_cut_handle *handle = data;
  size_t place = sg_cut_place_of(handle, s);

  return place != SIZE_MAX &&
         sg_leaf_vertex_at(handle->tree[place]->tree, &handle->views, v, at);
}

bool
sg_cut_open(sg_call *call, sg_cut_handle *handle, const sg_id_pair_list *pairs)
{
  if (!note_pairs(call, handle, pairs) ||
      !sg_leaf_views_open(call, handle->version, &handle->views)) {
    return false;
  }
  handle->segments = sg_sort_ids(handle->segment, handle->segments);
  handle->tree = calloc(handle->segments + 1, sizeof(sg_kept_tree *));
  handle->sharing = calloc(handle->segments + 1, sizeof *handle->sharing);
  if (!handle->tree || !handle->sharing) {
    return sg_call_no_memory(call);
  }
  handle->set.model.fetch = fetch_vertex;
  handle->set.model.fetch_data = handle;
  return sg_trees_hold(call, handle->version, &handle->views, handle->segment,
                       handle->segments, handle->tree);
}

void
sg_cut_open_clear(sg_cut_handle *handle)
{
  for (size_t i = 0; handle->tree && i < handle->segments; i++) {
    sg_kept_tree_drop(handle->tree[i]);
  }
  free(handle->tree);
  free(handle->segment);
  free(handle->pair);
  free(handle->candidate);
  free(handle->apart);
  free(handle->quiet);
  free(handle->own);
  free(handle->sharing);
  sg_leaf_views_clear(&handle->views);
  handle->tree = NULL;
  handle->segment = NULL;
  handle->pair = NULL;
  handle->candidate = NULL;
  handle->apart = NULL;
  handle->own = NULL;
  handle->sharing = NULL;
  handle->segments = handle->pairs = 0;
  handle->candidates = handle->curve_candidates = 0;
}

/* ---- the join ---- */

/* One join under way: pairs of triangles, then curve edges with triangles. */
typedef struct join {
  sg_cut_handle *handle;
  size_t (*place)[2]; /* [pairs]: of the segments of a pair of trees */
  sg_bvh_pair *pair;
  size_t pairs;
  uint32_t **number; /* [segments][leaves], from 1; 0: none yet; null: none */
  sg_apart *apart;   /* [aparts], of triangles by number */
  size_t aparts, apart_room;
} join;

/* A leaf without one of its corners. */
static const uint32_t REFUSED = UINT32_MAX;

/* The pairs of trees of one sort, of two segments. A curve comes first, else
 * the smaller segment. */
static void
take_pairs(join *j, bool curve)
{
  const sg_cut_handle *handle = j->handle;

  j->pairs = 0;
  for (size_t i = 0; i < handle->pairs; i++) {
    size_t a = sg_cut_place_of(handle, handle->pair[i][0]);
    size_t b = sg_cut_place_of(handle, handle->pair[i][1]);
    const sg_leaf_tree *of_a = handle->tree[a]->tree;
    const sg_leaf_tree *of_b = handle->tree[b]->tree;

    if (a == b || (of_a->curve && of_b->curve) ||
        (of_a->curve || of_b->curve) != curve) {
      continue;
    }
    bool swap = curve ? of_b->curve : b < a;

    j->place[j->pairs][0] = swap ? b : a;
    j->place[j->pairs][1] = swap ? a : b;
    j->pair[j->pairs++] = swap ? (sg_bvh_pair){of_b->boxes, of_a->boxes}
                               : (sg_bvh_pair){of_a->boxes, of_b->boxes};
  }
}

/* Of the triangle that came last. False: no memory. */
static bool
add_apart(join *j)
{
  const sg_cut_model *model = &j->handle->set.model;
  double corner[3][3];

  if (!sg_list_grow(&j->apart, j->aparts, &j->apart_room, sizeof *j->apart)) {
    return false;
  }
  sg_cut_model_corners(model, (uint32_t)model->triangles - 1, corner);
  sg_apart_make((const double(*)[3])corner, j->handle->reach,
                &j->apart[j->aparts++]);
  return true;
}

/* Adds a leaf to the model. False: no memory. */
static bool
add_leaf(join *j, const sg_leaf_tree *tree, uint32_t row, uint32_t *number)
{
  const sg_cut_handle *handle = j->handle;
  sg_cut_model *model = &j->handle->set.model;
  sg_leaf leaf = sg_leaf_at(tree, &handle->views, row);
  bool known;

  if (!(tree->curve ? sg_cut_model_edge(model, tree->s, leaf.id, leaf.v, &known)
                    : sg_cut_model_triangle(model, tree->s, leaf.p, leaf.id,
                                            leaf.v, &known))) {
    return false;
  }
  *number = !known        ? REFUSED
            : tree->curve ? (uint32_t)model->edges
                          : (uint32_t)model->triangles;
  return tree->curve || !known || add_apart(j);
}

/* The number in the model of the leaf at `at` of the tree of segment `place`,
 * from 1. False: no memory. */
static bool
number_of(join *j, size_t place, uint32_t at, uint32_t *out)
{
  const sg_leaf_tree *tree = j->handle->tree[place]->tree;

  if (!j->number[place]) {
    /* Pages that nothing comes near are never touched. */
    j->number[place] = calloc(tree->boxes->n, sizeof **j->number);
    if (!j->number[place]) {
      return false;
    }
  }
  uint32_t *number = &j->number[place][at];

  if (*number == 0 && !add_leaf(j, tree, tree->boxes->item[at], number)) {
    return false;
  }
  *out = *number;
  return true;
}

/* The box of an edge. */
static sg_box
edge_box(const sg_cut_model *model, uint32_t number)
{
  const uint32_t *v = model->edge[number].v;
  sg_box box = sg_box_none();

  for (int i = 0; i < 2; i++) {
    sg_box_add(&box, model->vertex[v[i]].at);
  }
  return box;
}

/* Two triangles have nothing in common, and nothing that could touch. */
static bool
are_apart(const join *j, uint32_t a, uint32_t b)
{
  const sg_cut_model *model = &j->handle->set.model;
  const uint32_t *v = model->triangle[a].v, *w = model->triangle[b].v;
  const sg_leaf_vertex *at = model->vertex;

  return sg_apart_by_plane(
             &j->apart[a],
             (const double *const[3]){at[w[0]].at, at[w[1]].at, at[w[2]].at}) ||
         sg_apart_by_plane(
             &j->apart[b],
             (const double *const[3]){at[v[0]].at, at[v[1]].at, at[v[2]].at});
}

/* All corners of triangle a are corners of b. */
static bool
are_twins(const sg_cut_model *model, uint32_t a, uint32_t b)
{
  for (int i = 0; i < 3; i++) {
    const double *p = model->vertex[model->triangle[a].v[i]].at;
    bool is = false;

    for (int k = 0; k < 3 && !is; k++) {
      const double *q = model->vertex[model->triangle[b].v[k]].at;

      is = p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
    }
    if (!is) {
      return false;
    }
  }
  return true;
}

/* A hit whose exact boxes overlap is a candidate. */
static void
keep_hit(join *j, bool curve, uint32_t a, uint32_t b)
{
  sg_cut_handle *handle = j->handle;
  sg_box of_edge;
  const sg_box *box = &of_edge;

  if (curve) {
    of_edge = edge_box(&handle->set.model, a);
  } else {
    box = &j->apart[a].box;
  }
  if (sg_box_overlap(box, &j->apart[b].box, handle->reach)) {
    if (!curve) {
      bool apart = are_apart(j, a, b);

      handle->apart[handle->candidates] = apart;
      handle->twins = handle->twins || /* which are not apart */
                      (!apart && are_twins(&handle->set.model, a, b));
    }
    handle->candidate[handle->candidates][0] = a;
    handle->candidate[handle->candidates++][1] = b;
  }
}

/* Makes candidates of hits; those whose exact boxes miss are dropped. */
static bool
keep_hits(sg_call *call, join *j, const sg_bvh_hits *hits)
{
  sg_cut_handle *handle = j->handle;
  size_t room = handle->candidates, apart_room = room;

  if (!sg_list_need(&handle->candidate, handle->candidates + hits->n, &room,
                    sizeof *handle->candidate) ||
      !sg_list_need(&handle->apart, handle->candidates + hits->n, &apart_room,
                    sizeof *handle->apart)) {
    return sg_call_no_memory(call);
  }
  for (size_t k = 0; k < hits->n; k++) {
    const sg_bvh_hit *hit = &hits->hit[k];
    const size_t *place = j->place[hit->pair];
    uint32_t a, b;

    if (k % ASKED == ASKED - 1 && sg_cancelled(&call->cancel)) {
      return false;
    }
    if (!number_of(j, place[0], hit->a, &a) ||
        !number_of(j, place[1], hit->b, &b)) {
      return sg_call_no_memory(call);
    }
    if (a != REFUSED && b != REFUSED) {
      keep_hit(j, handle->tree[place[0]]->tree->curve, a - 1, b - 1);
    }
  }
  return true;
}

/* The candidates of segments with themselves: they are never let out. */
static bool
join_selves(sg_call *call, join *j, sg_pool *pool)
{
  sg_cut_handle *handle = j->handle;
  bool good = true;

  for (size_t i = 0; i < handle->pairs && good; i++) {
    size_t at = sg_cut_place_of(handle, handle->pair[i][0]);
    sg_bvh_hits hits;

    if (handle->pair[i][0] != handle->pair[i][1]) {
      continue;
    }
    const sg_leaf_tree *tree = handle->tree[at]->tree;

    if (!(handle->few && !(handle->reach > 0)
              ? sg_self_leaf_join_few(tree, &handle->views, pool, &call->cancel,
                                      &hits)
              : sg_self_leaf_join(tree, &handle->views, handle->reach, pool,
                                  &call->cancel, &hits))) {
      return sg_call_ended(call);
    }
    j->place[0][0] = j->place[0][1] = at;
    good = keep_hits(call, j, &hits); /* all of pair 0 */
    free(hits.hit);
  }
  return good;
}

static bool
join_all(sg_call *call, join *j, sg_pool *pool)
{
  for (int curve = 0; curve < 2; curve++) {
    sg_bvh_hits hits;
    bool good;

    take_pairs(j, curve);
    if (!sg_bvh_join(j->pair, j->pairs, j->handle->reach, pool, &call->cancel,
                     &hits)) {
      return sg_call_ended(call);
    }
    good = keep_hits(call, j, &hits);
    free(hits.hit);
    if (!good) {
      return false;
    }
    if (!curve && !join_selves(call, j, pool)) {
      return false;
    }
    if (!curve) {
      j->handle->curve_candidates = j->handle->candidates;
    }
  }
  return true;
}

bool
sg_cut_quiet(sg_call *call, sg_cut_handle *handle)
{
  if (handle->quiet) {
    return true;
  }
  if (!(handle->quiet = calloc(handle->curve_candidates + 1, 1))) {
    return sg_call_no_memory(call);
  }
  if (!handle->twins) {
    return true;
  }
  sg_sort_end end = sg_cut_find_quiet(
      &handle->set.model, (const uint32_t(*)[2])handle->candidate,
      handle->curve_candidates, handle->quiet, &call->cancel);
  return end == SG_SORTED ||
         (end == SG_SORT_NO_MEMORY && sg_call_no_memory(call));
}

bool
sg_cut_join(sg_call *call, sg_cut_handle *handle)
{
  join j = {.handle = handle};
  sg_pool *pool = handle->joined ? NULL : sg_call_pool(call);

  if (handle->joined) {
    return true;
  }
  handle->candidates = 0;
  j.place = malloc((handle->pairs + 1) * sizeof *j.place);
  j.pair = malloc((handle->pairs + 1) * sizeof *j.pair);
  j.number = calloc(handle->segments + 1, sizeof(uint32_t *));
  handle->joined = j.place && j.pair && j.number && pool
                       ? join_all(call, &j, pool)
                       : sg_call_no_memory(call);
  for (size_t i = 0; j.number && i < handle->segments; i++) {
    free(j.number[i]);
  }
  free(j.number);
  free(j.apart);
  free(j.pair);
  free(j.place);
  return handle->joined;
}
