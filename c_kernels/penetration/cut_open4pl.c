/* cut_open4pl.c -- cut sets: the segments, their trees, and the candidates.
 *
 * Layer: glue; no predicates of its own. Trees are kept with the world
 * (tree4pl.h). All pairs of segments are joined at once; what comes out is
 * given numbers in the order of the join, so that triangles which nothing comes
 * near are never looked at.
 */
#include "cut4pl.h"
#include "cut_twin.h"

#include "glue.h"
#include "join/bvh_join.h"
#include "join/self_leaf.h"

#include <stdlib.h>
#include <string.h>

enum { ASKED = 1 << 14 }; /* hits between questions */

/* ---- the segments ---- */

static int
want_segment_ex(sg_cut_handle *handle, int32_t s)
{
  uint32_t key = (uint32_t)s;
  uint32_t *next = sg_key_table_put(&handle->next_name, &key);

  if (!next) {
    return sg_no_memory();
  }
  if (*next == SG_NO_KEY) {
    int32_t fresh = sg_fresh_ex(handle->world, SG_V, s);

    if (fresh == 0) {
      return FALSE;
    }
    *next = (uint32_t)fresh;
    handle->segment[handle->segments++] = s;
  }
  return TRUE;
}

/* Reads [S1-S2, ...]. */
static int
get_pairs_ex(term_t list, sg_cut_handle *handle)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  term_t arg = PL_new_term_ref();
  size_t n;

  if (PL_skip_list(list, 0, &n) != PL_LIST) {
    return PL_type_error("list", list);
  }
  handle->pair = malloc((n + 1) * sizeof *handle->pair);
  handle->segment = malloc((2 * n + 1) * sizeof *handle->segment);
  if (!handle->pair || !handle->segment) {
    return sg_no_memory();
  }
  for (size_t i = 0; i < n; i++) {
    if (!PL_get_list_ex(tail, head, tail)) {
      return FALSE;
    }
    if (!PL_is_functor(head, PL_new_functor(PL_new_atom("-"), 2))) {
      return PL_type_error("pair", head);
    }
    for (int k = 0; k < 2; k++) {
      if (!PL_get_arg(k + 1, head, arg) ||
          !sg_get_id_ex(arg, &handle->pair[i][k]) ||
          !want_segment_ex(handle, handle->pair[i][k])) {
        return FALSE;
      }
    }
    if (handle->pair[i][0] == handle->pair[i][1] &&
        !sg_cut_points_set_by_itself(&handle->set.points, handle->pair[i][0])) {
      return sg_no_memory();
    }
    handle->pairs++;
  }
  return TRUE;
}

static int
compare_segments(const void *x, const void *y)
{
  int32_t a = *(const int32_t *)x, b = *(const int32_t *)y;

  return (a > b) - (a < b);
}

size_t
sg_cut_place_of(const sg_cut_handle *handle, int32_t s)
{
  const int32_t *at = bsearch(&s, handle->segment, handle->segments, sizeof s,
                              compare_segments);

  return (size_t)(at - handle->segment);
}

/* An sg_fetch_vertex. */
static bool
fetch_vertex(void *data, int32_t s, int32_t v, double at[3])
{
  sg_cut_handle *handle = data;
  uint32_t key = (uint32_t)s;

  if (sg_key_table_get(&handle->next_name, &key) == SG_NO_KEY) {
    return false;
  }
  return sg_leaf_vertex_at(handle->tree[sg_cut_place_of(handle, s)]->tree,
                           &handle->views, v, at);
}

int
sg_cut_open_ex(sg_cut_handle *handle, term_t pairs)
{
  sg_crew *crew;
  int good;

  if (!get_pairs_ex(pairs, handle) ||
      !sg_leaf_views_ex(handle->version, &handle->views)) {
    return FALSE;
  }
  if (handle->segments > 0) {
    qsort(handle->segment, handle->segments, sizeof *handle->segment,
          compare_segments);
  }
  handle->tree = calloc(handle->segments + 1, sizeof(sg_kept_tree *));
  handle->sharing = calloc(handle->segments + 1, sizeof *handle->sharing);
  if (!handle->tree || !handle->sharing || !(crew = sg_crew_open(0))) {
    return sg_no_memory();
  }
  good =
      sg_trees_hold_ex(handle->world, handle->version, &handle->views,
                       handle->segment, handle->segments, crew, handle->tree);
  sg_crew_close(crew);
  handle->set.model.fetch = fetch_vertex;
  handle->set.model.fetch_data = handle;
  return good;
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
  free(handle->quiet);
  free(handle->own);
  free(handle->sharing);
  sg_leaf_views_clear(&handle->views);
  handle->tree = NULL;
  handle->segment = NULL;
  handle->pair = NULL;
  handle->candidate = NULL;
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

/* Adds a leaf to the model. False: no memory. */
static bool
add_leaf(sg_cut_handle *handle, const sg_leaf_tree *tree, uint32_t row,
         uint32_t *number)
{
  sg_cut_model *model = &handle->set.model;
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
  return true;
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

  if (*number == 0 &&
      !add_leaf(j->handle, tree, tree->boxes->item[at], number)) {
    return false;
  }
  *out = *number;
  return true;
}

/* The box of a leaf, as exact as its corners. */
static sg_box
box_of(const sg_cut_model *model, bool curve, uint32_t number)
{
  const uint32_t *v = curve ? model->edge[number].v : model->triangle[number].v;
  sg_box box = sg_box_none();

  for (int i = 0; i < (curve ? 2 : 3); i++) {
    sg_box_add(&box, model->vertex[v[i]].at);
  }
  return box;
}

/* Makes candidates of hits; those whose exact boxes miss are dropped. */
static int
keep_hits_ex(join *j, const sg_bvh_hits *hits)
{
  sg_cut_handle *handle = j->handle;
  size_t room = handle->candidates + hits->n + 1;
  uint32_t(*grown)[2] = realloc(handle->candidate, room * sizeof *grown);

  if (!grown) {
    return sg_no_memory();
  }
  handle->candidate = grown;
  for (size_t k = 0; k < hits->n; k++) {
    const sg_bvh_hit *hit = &hits->hit[k];
    const size_t *place = j->place[hit->pair];
    const sg_cut_model *model = &handle->set.model;
    uint32_t a, b;

    if (k % ASKED == ASKED - 1 && PL_handle_signals() < 0) {
      return FALSE;
    }
    if (!number_of(j, place[0], hit->a, &a) ||
        !number_of(j, place[1], hit->b, &b)) {
      return sg_no_memory();
    }
    if (a == REFUSED || b == REFUSED) {
      continue;
    }
    sg_box of_a = box_of(model, handle->tree[place[0]]->tree->curve, a - 1);
    sg_box of_b = box_of(model, false, b - 1);

    if (sg_box_overlap(&of_a, &of_b, handle->reach)) {
      grown[handle->candidates][0] = a - 1;
      grown[handle->candidates++][1] = b - 1;
    }
  }
  return TRUE;
}

/* The candidates of segments with themselves: they are never let out. */
static int
join_selves_ex(join *j, sg_crew *crew)
{
  sg_cut_handle *handle = j->handle;
  int good = TRUE;

  for (size_t i = 0; i < handle->pairs && good; i++) {
    size_t at = sg_cut_place_of(handle, handle->pair[i][0]);
    sg_bvh_hits hits;

    if (handle->pair[i][0] != handle->pair[i][1]) {
      continue;
    }
    if (!sg_self_leaf_join(handle->tree[at]->tree, &handle->views,
                           handle->reach, crew, &sg_prolog_poll, &hits)) {
      return PL_exception(0) ? FALSE : sg_no_memory();
    }
    j->place[0][0] = j->place[0][1] = at;
    good = keep_hits_ex(j, &hits); /* all of pair 0 */
    free(hits.hit);
  }
  return good;
}

static int
join_ex(join *j, sg_crew *crew)
{
  for (int curve = 0; curve < 2; curve++) {
    sg_bvh_hits hits;
    int good;

    take_pairs(j, curve);
    if (!sg_bvh_join(j->pair, j->pairs, j->handle->reach, crew, &sg_prolog_poll,
                     &hits)) {
      return PL_exception(0) ? FALSE : sg_no_memory();
    }
    good = keep_hits_ex(j, &hits);
    free(hits.hit);
    if (!good) {
      return FALSE;
    }
    if (!curve && !join_selves_ex(j, crew)) {
      return FALSE;
    }
    if (!curve) {
      j->handle->curve_candidates = j->handle->candidates;
    }
  }
  return TRUE;
}

int
sg_cut_quiet_ex(sg_cut_handle *handle)
{
  if (handle->quiet) {
    return TRUE;
  }
  if (!(handle->quiet = calloc(handle->curve_candidates + 1, 1))) {
    return sg_no_memory();
  }
  sg_sort_end end = sg_cut_find_quiet(
      &handle->set.model, (const uint32_t(*)[2])handle->candidate,
      handle->curve_candidates, handle->quiet, &sg_prolog_poll);
  return end == SG_SORTED || (end == SG_SORT_NO_MEMORY && sg_no_memory());
}

int
sg_cut_join_ex(sg_cut_handle *handle)
{
  join j = {.handle = handle};
  sg_crew *crew;

  if (handle->joined) {
    return TRUE;
  }
  handle->candidates = 0;
  j.place = malloc((handle->pairs + 1) * sizeof *j.place);
  j.pair = malloc((handle->pairs + 1) * sizeof *j.pair);
  j.number = calloc(handle->segments + 1, sizeof(uint32_t *));
  crew = sg_crew_open(0);
  handle->joined = j.place && j.pair && j.number && crew ? join_ex(&j, crew)
                                                         : sg_no_memory();
  sg_crew_close(crew);
  for (size_t i = 0; j.number && i < handle->segments; i++) {
    free(j.number[i]);
  }
  free(j.number);
  free(j.pair);
  free(j.place);
  return handle->joined;
}
