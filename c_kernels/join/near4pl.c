/* near4pl.c -- which segments are near each other.
 *
 * Layer: glue. The door is documented in rules/kernel/world.pl.
 */
#include "tree4pl.h"

#include "bvh_join.h"
#include "glue.h"

#include "engine/install.h"

#include <stdlib.h>
#include <string.h>

enum { CROWD = 16 }; /* other boxes */

/* The segments of a version and their boxes. */
typedef struct boxed {
  size_t n;
  int32_t *s; /* ascending */
  sg_box *box;
} boxed;

/* The answers, in order. */
typedef struct near_pairs {
  size_t n, next;
  int32_t pair[][2];
} near_pairs;

static int
compare_ids(const void *x, const void *y)
{
  int32_t a = *(const int32_t *)x, b = *(const int32_t *)y;

  return (a > b) - (a < b);
}

static int
compare_pairs(const void *x, const void *y)
{
  const int32_t *a = x, *b = y;
  int first = compare_ids(&a[0], &b[0]);

  return first ? first : compare_ids(&a[1], &b[1]);
}

/* The ids of a list, each once, ascending; `all`: every id. */
typedef struct wanted {
  int32_t *s;
  size_t n;
  bool all;
} wanted;

static bool
is_wanted(const wanted *of, int32_t s)
{
  return of->all ||
         bsearch(&s, of->s, of->n, sizeof *of->s, compare_ids) != NULL;
}

/* The segments of segment/3 that are wanted. */
static int
list_segments_ex(const sg_version *version, const wanted *of, boxed *out)
{
  size_t n = sg_version_count(version, SG_SEGMENT);
  sg_walk walk;

  out->s = malloc((n + 1) * sizeof *out->s);
  out->box = malloc((n + 1) * sizeof *out->box);
  if (!out->s || !out->box ||
      !sg_walk_open(&walk, version, SG_SEGMENT, 0, NULL)) {
    return sg_no_memory();
  }
  for (sg_row row; (row = sg_walk_next(&walk)) != SG_NO_ROW && out->n < n;) {
    int32_t id = sg_version_value(version, SG_SEGMENT, row, 0).i;

    if (is_wanted(of, id)) {
      out->s[out->n++] = id;
    }
  }
  sg_walk_close(&walk);
  qsort(out->s, out->n, sizeof *out->s, compare_ids);
  return TRUE;
}

/* Boxes: of trees that are kept, else from the vertices. */
static int
find_boxes_ex(const sg_version *version, sg_crew *crew, boxed *out)
{
  int32_t *missing = malloc((out->n + 1) * sizeof *missing);
  sg_box *box = malloc((out->n + 1) * sizeof *box);
  size_t m = 0;
  sg_view vertices = {0};
  int good = missing && box && sg_version_view(version, SG_V, &vertices);

  for (size_t i = 0; i < out->n && good; i++) {
    if (!sg_kept_box(version, out->s[i], &out->box[i])) {
      missing[m++] = out->s[i];
    }
  }
  good = good && (m == 0 || sg_leaf_boxes(&vertices, missing, m, crew,
                                          &sg_prolog_poll, box));
  for (size_t i = 0, k = 0; k < m && good; i++) {
    if (out->s[i] == missing[k]) {
      out->box[i] = box[k++];
    }
  }
  sg_view_clear(&vertices);
  free(missing);
  free(box);
  return good || (PL_exception(0) ? FALSE : sg_no_memory());
}

/* The pairs whose boxes overlap within the reach, as places. */
static int
join_boxes_ex(const boxed *all, double reach, sg_bvh_hits *hits)
{
  sg_bvh *tree = sg_bvh_open(all->box, all->n, &sg_prolog_poll);
  bool good = tree && sg_bvh_join(&(sg_bvh_pair){tree, tree}, 1, reach, NULL,
                                  &sg_prolog_poll, hits);
  size_t n = 0;

  for (size_t k = 0; good && k < hits->n; k++) {
    uint32_t i = tree->item[hits->hit[k].a], j = tree->item[hits->hit[k].b];

    if (sg_box_overlap(&all->box[i], &all->box[j], reach)) {
      hits->hit[n++] = (sg_bvh_hit){0, i < j ? i : j, i < j ? j : i};
    }
  }
  hits->n = n;
  sg_bvh_close(tree);
  return good || (PL_exception(0) ? FALSE : sg_no_memory());
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
drop_apart(sg_bvh_hits *hits, const int64_t *where, const sg_oriented_box *box,
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
static int
drop_apart_ex(const sg_version *version, const boxed *all, double reach,
              sg_crew *crew, sg_bvh_hits *hits)
{
  int64_t *where = malloc((all->n + 1) * sizeof *where);
  int32_t *crowded = malloc((all->n + 1) * sizeof *crowded);
  size_t n = where && crowded ? find_crowded(all, hits, where, crowded) : 0;
  sg_oriented_box *box = malloc((n + 1) * sizeof *box);
  sg_view vertices = {0};
  int good = where && crowded && box;

  if (good && n > 0) {
    good = sg_version_view(version, SG_V, &vertices) &&
           sg_leaf_oriented_boxes(&vertices, crowded, n, crew, &sg_prolog_poll,
                                  box);
    if (good) {
      drop_apart(hits, where, box, 2 * reach); /* reach is along each axis */
    }
    sg_view_clear(&vertices);
  }
  free(where);
  free(crowded);
  free(box);
  return good || (PL_exception(0) ? FALSE : sg_no_memory());
}

static int
put_pairs_ex(const boxed *all, const sg_bvh_hits *hits, near_pairs **out)
{
  near_pairs *pairs =
      malloc(sizeof *pairs + (hits->n + 1) * sizeof pairs->pair[0]);

  if (!pairs) {
    return sg_no_memory();
  }
  pairs->n = hits->n;
  pairs->next = 0;
  for (size_t k = 0; k < hits->n; k++) {
    pairs->pair[k][0] = all->s[hits->hit[k].a];
    pairs->pair[k][1] = all->s[hits->hit[k].b];
  }
  qsort(pairs->pair, pairs->n, sizeof pairs->pair[0], compare_pairs);
  *out = pairs;
  return TRUE;
}

static int
find_near_ex(double reach, const wanted *of, near_pairs **out)
{
  sg_world *world = sg_current_world_ex();
  boxed all = {0};
  sg_bvh_hits hits = {0};

  if (!world) {
    return FALSE;
  }
  const sg_version *version = sg_world_version(world);
  sg_crew *crew = sg_crew_open(0);
  int good = (crew || sg_no_memory()) && list_segments_ex(version, of, &all) &&
             find_boxes_ex(version, crew, &all) &&
             join_boxes_ex(&all, reach, &hits) &&
             drop_apart_ex(version, &all, reach, crew, &hits) &&
             put_pairs_ex(&all, &hits, out);

  sg_crew_close(crew);
  free(hits.hit);
  sg_version_drop(version);
  free(all.s);
  free(all.box);
  return good;
}

/* Gives the pair in hand; the last one leaves no choice point. */
static foreign_t
give_pair(near_pairs *pairs, term_t s1, term_t s2)
{
  bool more = pairs->next + 1 < pairs->n;
  int given = FALSE;

  if (pairs->next < pairs->n) {
    const int32_t *pair = pairs->pair[pairs->next++];
    given = PL_unify_integer(s1, pair[0]) && PL_unify_integer(s2, pair[1]);
  }
  if (given && more) {
    PL_retry_address(pairs);
  }
  free(pairs);
  return given;
}

static int
get_reach_ex(term_t term, double *reach)
{
  return sg_get_finite_ex(term, reach) &&
         (*reach >= 0 || PL_domain_error("not_less_than_zero", term));
}

/* near_segments(+Reach, -S1, -S2) is nondet. */
static foreign_t
near_segments(term_t reach_term, term_t s1, term_t s2, control_t control)
{
  near_pairs *pairs = NULL;
  double reach;

  switch (PL_foreign_control(control)) {
  case PL_PRUNED:
    free(PL_foreign_context_address(control));
    return TRUE;
  case PL_REDO:
    return give_pair(PL_foreign_context_address(control), s1, s2);
  default:
    break;
  }
  if (!get_reach_ex(reach_term, &reach)) {
    return FALSE;
  }
  if (!PL_is_variable(s1) || !PL_is_variable(s2)) {
    return PL_uninstantiation_error(PL_is_variable(s1) ? s2 : s1);
  }
  return find_near_ex(reach, &(wanted){.all = true}, &pairs)
             ? give_pair(pairs, s1, s2)
             : FALSE;
}

/* ---- all at once --------------------------------------------------------- */

/* The pairs both ways round, ascending. */
static int
both_ways_ex(near_pairs *pairs, near_pairs **out)
{
  near_pairs *both =
      malloc(sizeof *both + (2 * pairs->n + 1) * sizeof both->pair[0]);

  if (!both) {
    return sg_no_memory();
  }
  both->n = 2 * pairs->n;
  both->next = 0;
  for (size_t i = 0; i < pairs->n; i++) {
    for (int k = 0; k < 2; k++) {
      both->pair[2 * i + (size_t)k][0] = pairs->pair[i][k];
      both->pair[2 * i + (size_t)k][1] = pairs->pair[i][1 - k];
    }
  }
  qsort(both->pair, both->n, sizeof both->pair[0], compare_pairs);
  *out = both;
  return TRUE;
}

/* The list of what is near s. */
static int
put_others_ex(near_pairs *both, int32_t s, term_t others)
{
  size_t end = both->next;
  term_t other = PL_new_term_ref();

  while (end < both->n && both->pair[end][0] == s) {
    end++;
  }
  int good = PL_put_nil(others);

  for (size_t i = end; i-- > both->next && good;) {
    good = PL_put_integer(other, both->pair[i][1]) &&
           PL_cons_list(others, other, others);
  }
  both->next = end;
  return good;
}

static int
unify_near_ex(const wanted *of, near_pairs *both, term_t list)
{
  functor_t pair = PL_new_functor(PL_new_atom("-"), 2);
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref(),
         others = PL_new_term_ref(), id = PL_new_term_ref();
  int good = TRUE;

  for (size_t i = 0; i < of->n && good; i++) {
    fid_t frame = PL_open_foreign_frame();

    good = frame && put_others_ex(both, of->s[i], others) &&
           PL_put_integer(id, of->s[i]) &&
           PL_cons_functor(id, pair, id, others);
    good = good && PL_unify_list(tail, head, tail) && PL_unify(head, id);
    if (frame) {
      PL_close_foreign_frame(frame);
    }
  }
  return good && PL_unify_nil(tail);
}

/* near_segments_of(+Reach, +Ss, -Near) is det. */
static foreign_t
near_segments_of(term_t reach_term, term_t segments, term_t near)
{
  near_pairs *pairs = NULL, *both = NULL;
  wanted of = {0};
  double reach;

  if (!get_reach_ex(reach_term, &reach) ||
      !sg_get_id_set_ex(segments, &of.s, &of.n)) {
    return FALSE;
  }
  int good = find_near_ex(reach, &of, &pairs) && both_ways_ex(pairs, &both) &&
             unify_near_ex(&of, both, near);

  free(pairs);
  free(both);
  free(of.s);
  return good;
}

static const PL_extension predicates[] = {
    {"near_segments", 3, near_segments, PL_FA_NONDETERMINISTIC},
    {"near_segments_of", 3, near_segments_of, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_near(void)
{
  PL_register_extensions_in_module("sg_kernel_world", predicates);
}
