/* operand4pl.c -- what a Boolean asks of its operands (documented in
 * kernel/boolean.pl).
 *
 * Layer: glue. Answers are kept with the tree of the segment (tree4pl.h).
 */
#include "glue.h"
#include "operand.h"
#include "rows/grain_rows.h"
#include "self_leaf.h"
#include "tree4pl.h"

#include "engine/install.h"

#include <stdlib.h>

/* A segment at hand. */
typedef struct asking {
  sg_world *world;
  const sg_version *version;
  sg_leaf_views views;
  sg_crew *crew;
  sg_kept_tree *kept;
  int32_t s;
} asking;

static int
failed_ex(void)
{
  return PL_exception(0) ? FALSE : sg_no_memory();
}

/* Close it in any case. */
static int
open_ex(term_t s, asking *a)
{
  *a = (asking){.world = sg_current_world_ex()};
  if (!a->world || !sg_get_id_ex(s, &a->s)) {
    return FALSE;
  }
  a->version = sg_world_version(a->world);
  a->crew = sg_crew_open(0);
  return (a->crew || sg_no_memory()) &&
         sg_leaf_views_ex(a->version, &a->views) &&
         sg_trees_hold_ex(a->world, a->version, &a->views, &a->s, 1, a->crew,
                          &a->kept);
}

static void
close_asking(asking *a)
{
  sg_kept_tree_drop(a->kept);
  if (a->version) {
    sg_leaf_views_clear(&a->views);
    sg_version_drop(a->version);
  }
  sg_crew_close(a->crew);
}

/* ---- answers that are kept ------------------------------------------------
 */

/* The operand as this version shows it. It is kept if it is the first; edges
 * that change alone, without vertices and triangles, are rare. */
static int
operand_of_ex(sg_kept_tree *kept, const sg_version *version,
              const sg_leaf_views *views, sg_crew *crew, sg_operand *out)
{
  uint64_t stamp = sg_version_stamp(version, SG_E, kept->s);
  sg_kept_operand *there = atomic_load(&kept->operand), *fresh;

  if (there && there->stamp == stamp) {
    *out = there->operand;
    return TRUE;
  }
  if (!sg_operand_see(kept->tree, views, crew, &sg_prolog_poll, out)) {
    return failed_ex();
  }
  if (!there && (fresh = malloc(sizeof *fresh))) {
    *fresh = (sg_kept_operand){*out, stamp};
    if (!atomic_compare_exchange_strong(&kept->operand, &there, fresh)) {
      free(fresh); /* another thread was first */
    }
  }
  return TRUE;
}

static int
operand_ex(asking *a, sg_operand *out)
{
  return operand_of_ex(a->kept, a->version, &a->views, a->crew, out);
}

int
sg_kept_knots_ex(sg_kept_tree *kept, const sg_version *version,
                 const sg_leaf_views *views, sg_crew *crew,
                 const sg_knots **out)
{
  sg_knots *there = atomic_load(&kept->knots), *fresh;
  sg_operand operand;

  if (!there) {
    if (!operand_of_ex(kept, version, views, crew, &operand)) {
      return FALSE;
    }
    if (!(fresh = calloc(1, sizeof *fresh))) {
      return sg_no_memory();
    }
    if (!operand.star &&
        !sg_knots_find(kept->tree, views, &sg_prolog_poll, fresh)) {
      sg_knots_clear(fresh);
      free(fresh);
      return failed_ex();
    }
    if (atomic_compare_exchange_strong(&kept->knots, &there, fresh)) {
      there = fresh;
    } else { /* another thread was first */
      sg_knots_clear(fresh);
      free(fresh);
    }
  }
  *out = there;
  return TRUE;
}

/* Whether it goes through itself. */
static int
self_ex(asking *a, bool *out)
{
  sg_self_known known = sg_self_known_of(a->world, a->kept);
  sg_operand operand;

  if (known == SG_SELF_NOT_ASKED) {
    if (!operand_ex(a, &operand)) {
      return FALSE;
    }
    *out = false;
    double grain = sg_grain_of(a->version, a->kept->tree->s);
    if (!operand.star && !sg_self_leaf_meets(a->kept->tree, &a->views, grain,
                                             a->crew, &sg_prolog_poll, out)) {
      return failed_ex();
    }
    known = *out ? SG_SELF_MEETS : SG_SELF_APART;
    sg_self_keep(a->world, a->kept, known);
  }
  *out = known == SG_SELF_MEETS;
  return TRUE;
}

/* segment_meets_itself(+S) is semidet. */
static foreign_t
segment_meets_itself(term_t s)
{
  asking a;
  bool meets = false;
  int good = open_ex(s, &a) && self_ex(&a, &meets);

  close_asking(&a);
  return good && meets;
}

/* Asks of all trees in turn, and gives those that do. */
static int
unify_meeting_ex(term_t list, asking *a, const int32_t *s, sg_kept_tree **tree,
                 size_t n)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  for (size_t i = 0; i < n; i++) {
    bool meets = false;

    a->s = s[i];
    a->kept = tree[i];
    if (!self_ex(a, &meets) || (meets && (!PL_unify_list(tail, head, tail) ||
                                          !PL_unify_integer(head, s[i])))) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

/* segments_meeting_themselves(+Segments, -Which) is det. */
static foreign_t
segments_meeting_themselves(term_t segments, term_t which)
{
  asking a = {.world = sg_current_world_ex()};
  sg_kept_tree **tree = NULL;
  int32_t *s = NULL;
  size_t n = 0;

  if (!a.world || !sg_get_id_set_ex(segments, &s, &n)) {
    return FALSE;
  }
  a.version = sg_world_version(a.world);
  a.crew = sg_crew_open(0);
  tree = calloc(n + 1, sizeof(sg_kept_tree *));
  int good = (a.crew && tree) || sg_no_memory();

  good = good && sg_leaf_views_ex(a.version, &a.views) &&
         sg_trees_hold_ex(a.world, a.version, &a.views, s, n, a.crew, tree) &&
         unify_meeting_ex(which, &a, s, tree, n);
  for (size_t i = 0; tree && i < n; i++) {
    if (tree[i]) {
      sg_kept_tree_drop(tree[i]);
    }
  }
  free(tree);
  free(s);
  a.kept = NULL;
  close_asking(&a);
  return good;
}

/* segment_operand(+S, -Operand) is det. */
static foreign_t
segment_operand(term_t s, term_t out)
{
  asking a;
  sg_operand o = {0};
  int good = open_ex(s, &a) && operand_ex(&a, &o);

  close_asking(&a);
  return good &&
         PL_unify_term(out, PL_FUNCTOR_CHARS, "operand", 6, PL_INT64,
                       (int64_t)o.triangles, PL_INT64, (int64_t)o.half_edges,
                       PL_BOOL, (int)o.balanced, PL_FLOAT, o.volume + 0.0,
                       PL_FLOAT, o.error, PL_BOOL, (int)o.star);
}

/* ---- edges ----------------------------------------------------------------
 */

static int
unify_edges(term_t list, const sg_operand_edges *edges)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  for (size_t i = 0; i < edges->firsts; i++) {
    const sg_operand_edge *e = &edges->first[i];

    if (!PL_unify_list(tail, head, tail) ||
        !PL_unify_term(head, PL_FUNCTOR_CHARS, "edge", 4, PL_INT, (int)e->v[0],
                       PL_INT, (int)e->v[1], PL_INT64, (int64_t)e->forward,
                       PL_INT64, (int64_t)e->backward)) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

/* segment_edges(+S, +Most, -Counts, -Edges) is det. */
static foreign_t
segment_edges(term_t s, term_t most, term_t counts, term_t list)
{
  sg_world *world = sg_current_world_ex();
  sg_operand_edges edges = {0};
  sg_leaf_views views = {0};
  int32_t id, limit;

  if (!world || !sg_get_id_ex(s, &id) || !sg_get_int32_ex(most, &limit)) {
    return FALSE;
  }
  const sg_version *version = sg_world_version(world);
  int good = sg_leaf_views_ex(version, &views) &&
             (sg_operand_edges_find(&views, id, limit < 0 ? 0 : (size_t)limit,
                                    &sg_prolog_poll, &edges) ||
              failed_ex());

  good = good &&
         PL_unify_term(counts, PL_FUNCTOR_CHARS, "edges", 3, PL_INT64,
                       (int64_t)edges.open, PL_INT64, (int64_t)edges.unbalanced,
                       PL_INT64, (int64_t)edges.crowded) &&
         unify_edges(list, &edges);
  sg_operand_edges_clear(&edges);
  sg_leaf_views_clear(&views);
  sg_version_drop(version);
  return good;
}

static const PL_extension predicates[] = {
    {"segment_meets_itself", 1, segment_meets_itself, 0},
    {"segments_meeting_themselves", 2, segments_meeting_themselves, 0},
    {"segment_operand", 2, segment_operand, 0},
    {"segment_edges", 4, segment_edges, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_operand(void)
{
  PL_register_extensions_in_module("sg_kernel_boolean", predicates);
}
