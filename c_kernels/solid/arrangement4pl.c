/* arrangement4pl.c -- arrangements behind a Prolog handle.
 *
 * Layer: glue. The doors are documented in rules/kernel/boolean.pl. An
 * arrangement looks into its cut set, and keeps it from being closed.
 */
#include "arrangement4pl.h"

#include "glue.h"
#include "polygon/work4pl.h"

#include "engine/install.h"

#include <SWI-Stream.h>
#include <stdlib.h>

static functor_t functor_work3, functor_weight3;
static atom_t atom_surface;

/* ---- the handle ---- */

static void
close_handle(sg_arrangement_handle *h)
{
  sg_arrangement_close(h->arrangement);
  h->arrangement = NULL;
  for (size_t i = 0; h->tree && i < h->n; i++) {
    if (h->tree[i]) {
      sg_kept_tree_drop(h->tree[i]);
    }
  }
  free(h->tree);
  free(h->own);
  free(h->knots);
  free(h->s);
  free(h->wanted);
  free(h->surface);
  free(h->weight);
  free(h->origin_at);
  free(h->origin);
  h->tree = NULL;
  h->own = NULL;
  h->knots = NULL;
  h->s = NULL;
  h->wanted = NULL;
  h->surface = NULL;
  h->weight = NULL;
  h->origin_at = NULL;
  h->origin = NULL;
  h->n = 0;
  if (h->set) {
    sg_cut_set_let_go(h->set);
    h->set = NULL;
  }
  if (h->version) {
    sg_leaf_views_clear(&h->views);
    sg_version_drop(h->version);
    sg_world_let_go(h->world);
    h->version = NULL;
  }
}

static int
release_handle(atom_t atom)
{
  sg_arrangement_handle *h = PL_blob_data(atom, NULL, NULL);

  close_handle(h);
  free(h);
  return TRUE;
}

static int
write_handle(IOSTREAM *out, atom_t atom, int flags)
{
  const sg_arrangement_handle *h = PL_blob_data(atom, NULL, NULL);

  (void)flags;
  Sfprintf(out, h->arrangement ? "<arrangement>(%zu)" : "<arrangement>(closed)",
           h->n);
  return TRUE;
}

static PL_blob_t arrangement_blob = {.magic = PL_BLOB_MAGIC,
                                     .flags = PL_BLOB_UNIQUE | PL_BLOB_NOCOPY,
                                     .name = "arrangement",
                                     .release = release_handle,
                                     .write = write_handle};

int
sg_get_arrangement_ex(term_t t, sg_arrangement_handle **out)
{
  PL_blob_t *type;
  void *data;

  if (!PL_get_blob(t, &data, NULL, &type) || type != &arrangement_blob) {
    return PL_type_error("arrangement", t);
  }
  *out = data;
  return (*out)->arrangement || PL_existence_error("arrangement", t);
}

int
sg_get_sealed_ex(term_t t, sg_arrangement_handle **out)
{
  return sg_get_arrangement_ex(t, out) &&
         ((*out)->version || PL_permission_error("select", "arrangement", t));
}

int
sg_get_unsealed_ex(term_t t, sg_arrangement_handle **out)
{
  return sg_get_arrangement_ex(t, out) &&
         (!(*out)->sealing || PL_permission_error("fill", "arrangement", t));
}

/* ---- opening ---- */

/* The leaves, and which of them are wanted. */
static int
get_leaves_ex(term_t segments, term_t wanted, sg_arrangement_handle *h)
{
  int32_t *list = NULL;
  size_t n = 0;
  int good = sg_get_id_set_ex(segments, &h->s, &h->n) &&
             sg_get_id_set_ex(wanted, &list, &n);

  if (good) {
    h->wanted = calloc(h->n + 1, sizeof *h->wanted);
    good = h->wanted || sg_no_memory();
  }
  for (size_t i = 0, k = 0; good && i < n; i++) {
    while (k < h->n && h->s[k] < list[i]) {
      k++;
    }
    if (k < h->n && h->s[k] == list[i]) {
      h->wanted[k] = true;
    } else {
      good = PL_domain_error("segments", wanted);
    }
  }
  free(list);
  return good;
}

/* Reads [weight(S, P, Weight), ...], ascending. */
static int
get_weights_ex(term_t list, sg_arrangement_handle *h)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  term_t arg = PL_new_term_ref();
  size_t length;

  if (PL_skip_list(list, 0, &length) != PL_LIST) {
    return PL_type_error("list", list);
  }
  if (!(h->weight = calloc(length + 1, sizeof *h->weight))) {
    return sg_no_memory();
  }
  for (; h->weights < length; h->weights++) {
    sg_weight *one = &h->weight[h->weights];

    if (!PL_get_list_ex(tail, head, tail)) {
      return FALSE;
    }
    if (!PL_is_functor(head, functor_weight3)) {
      return PL_type_error("weight", head);
    }
    if (!PL_get_arg(1, head, arg) || !sg_get_id_ex(arg, &one->s) ||
        !PL_get_arg(2, head, arg) || !sg_get_id_ex(arg, &one->p) ||
        !PL_get_arg(3, head, arg) || !PL_get_integer_ex(arg, &one->weight)) {
      return FALSE;
    }
  }
  return TRUE;
}

/* Which leaves are surfaces, by segment/3. */
static int
find_surfaces_ex(sg_arrangement_handle *h)
{
  const sg_version *version = h->set->version;

  h->surface = calloc(h->n + 1, sizeof *h->surface);
  for (size_t i = 0; h->surface && i < h->n; i++) {
    sg_value key[SG_MAX_COLUMNS] = {[0].i = h->s[i]};
    sg_row row = sg_version_find(version, SG_SEGMENT, key);

    h->surface[i] =
        row != SG_NO_ROW &&
        sg_symbol_atom(sg_version_value(version, SG_SEGMENT, row, 1).i) ==
            atom_surface;
  }
  return h->surface || sg_no_memory();
}

static int
hold_trees_ex(sg_arrangement_handle *h)
{
  sg_crew *crew = sg_crew_open(0);
  int good;

  h->tree = calloc(h->n + 1, sizeof(sg_kept_tree *));
  h->own = calloc(h->n + 1, sizeof(sg_leaf_tree *));
  h->knots = calloc(h->n + 1, sizeof(sg_knots *));
  good = h->tree && h->own && h->knots && crew
             ? sg_trees_hold_ex(h->set->world, h->set->version, &h->set->views,
                                h->s, h->n, crew, h->tree)
             : sg_no_memory();
  for (size_t i = 0; good && i < h->n; i++) {
    h->own[i] = h->tree[i]->tree;
    good =
        !h->wanted[i] || sg_kept_knots_ex(h->tree[i], h->set->version,
                                          &h->set->views, crew, &h->knots[i]);
  }
  sg_crew_close(crew);
  return good;
}

static atomic_uint_fast64_t opened; /* arrangements, ever */

/* arrangement_open(+Set, +Segments, +Wanted, +Weights, -Arrangement) is det. */
static foreign_t
arrangement_open(term_t set, term_t segments, term_t wanted, term_t weights,
                 term_t out)
{
  sg_arrangement_handle *h = calloc(1, sizeof *h);

  if (!h) {
    return sg_no_memory();
  }
  if (!sg_get_cut_set_ex(set, &h->set)) {
    free(h);
    return FALSE;
  }
  sg_cut_set_keep(h->set);
  int good = get_leaves_ex(segments, wanted, h) && get_weights_ex(weights, h) &&
             find_surfaces_ex(h) && hold_trees_ex(h);

  if (good) {
    h->arrangement = sg_arrangement_open(
        &(sg_leaves){.set = &h->set->set,
                     .views = &h->set->views,
                     .s = h->s,
                     .tree = h->own,
                     .wanted = h->wanted,
                     .surface = h->surface,
                     .n = h->n,
                     .knots = h->knots,
                     .near = (const int32_t(*)[2])h->set->pair,
                     .pairs = h->set->pairs,
                     .weight = h->weight,
                     .weights = h->weights},
        &sg_prolog_poll);
    good = h->arrangement || (PL_exception(0) ? FALSE : sg_no_memory());
  }
  if (!good) {
    close_handle(h);
    free(h);
    return FALSE;
  }
  h->number = atomic_fetch_add(&opened, 1);
  atomic_init(&h->holders, 1);
  return PL_unify_blob(out, h, sizeof *h, &arrangement_blob);
}

static foreign_t
arrangement_hold(term_t t)
{
  sg_arrangement_handle *h;

  if (!sg_get_arrangement_ex(t, &h)) {
    return FALSE;
  }
  atomic_fetch_add(&h->holders, 1);
  return TRUE;
}

static foreign_t
arrangement_drop(term_t t)
{
  sg_arrangement_handle *h;

  if (!sg_get_arrangement_ex(t, &h)) {
    return FALSE;
  }
  if (atomic_fetch_sub(&h->holders, 1) == 1) {
    close_handle(h);
  }
  return TRUE;
}

/* ---- filling ---- */

/* error(geometry_error(polygon_edge(S, P, V1, V2)), _). */
static int
raise_stuck(int32_t s, int32_t p, const sg_work *work, int32_t e)
{
  const sg_work_edge *edge = sg_work_get(work, e);
  term_t t = PL_new_term_ref();

  return PL_unify_term(t, PL_FUNCTOR_CHARS, "error", 2, PL_FUNCTOR_CHARS,
                       "geometry_error", 1, PL_FUNCTOR_CHARS, "polygon_edge", 4,
                       PL_INT, s, PL_INT, p, PL_INT,
                       edge ? sg_work_id(work, edge->start) : 0, PL_INT,
                       edge ? sg_work_id(work, edge->end) : 0, PL_VARIABLE) &&
         PL_raise_exception(t);
}

/* Reads [work(S, P, Work), ...]. Owner: the caller, also of a part. */
static int
get_entered_ex(term_t list, sg_entered **out, size_t *n)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  term_t arg = PL_new_term_ref();
  size_t length;

  if (PL_skip_list(list, 0, &length) != PL_LIST) {
    return PL_type_error("list", list);
  }
  if (!(*out = calloc(length + 1, sizeof **out))) {
    return sg_no_memory();
  }
  for (*n = 0; *n < length; ++*n) {
    sg_entered *one = &(*out)[*n];

    if (!PL_get_list_ex(tail, head, tail)) {
      return FALSE;
    }
    if (!PL_is_functor(head, functor_work3)) {
      return PL_type_error("work", head);
    }
    if (!PL_get_arg(1, head, arg) || !sg_get_id_ex(arg, &one->s) ||
        !PL_get_arg(2, head, arg) || !sg_get_id_ex(arg, &one->p) ||
        !PL_get_arg(3, head, arg) || !sg_get_work_ex(arg, &one->work)) {
      return FALSE;
    }
  }
  return TRUE;
}

static int
take_in_ex(sg_arrangement *a, const sg_entered *polygon, size_t n, double reach)
{
  sg_crew *crew = sg_crew_open(0);
  size_t stuck = 0;
  int32_t edge = 0;
  sg_outcome outcome =
      crew ? sg_arrangement_polygons(a, polygon, n, reach, crew,
                                     &sg_prolog_poll, &stuck, &edge)
           : SG_NO_SPACE;

  sg_crew_close(crew);
  switch (outcome) {
  case SG_DONE:
    return TRUE;
  case SG_STUCK:
    return raise_stuck(polygon[stuck].s, polygon[stuck].p, polygon[stuck].work,
                       edge);
  case SG_STOPPED:
    return FALSE;
  case SG_NO_SPACE:
    break;
  }
  return sg_no_memory();
}

/* arrangement_polygons(+Arrangement, +Works, +Reach) is det. */
static foreign_t
arrangement_polygons(term_t t, term_t works, term_t r)
{
  sg_arrangement_handle *h;
  sg_entered *polygon = NULL;
  double reach;
  size_t n = 0;

  if (!sg_get_unsealed_ex(t, &h) || !sg_get_finite_ex(r, &reach)) {
    return FALSE;
  }
  int good = get_entered_ex(works, &polygon, &n) &&
             take_in_ex(h->arrangement, polygon, n, reach);

  free(polygon);
  return good;
}

static foreign_t
arrangement_seal(term_t t)
{
  sg_arrangement_handle *h;
  sg_crew *crew;

  if (!sg_get_unsealed_ex(t, &h)) {
    return FALSE;
  }
  if (!(crew = sg_crew_open(0))) {
    return sg_no_memory();
  }
  h->sealing = true; /* if that fails it is half done, and good for nothing */
  int good = sg_arrangement_seal(h->arrangement, crew, &sg_prolog_poll);

  sg_crew_close(crew);
  if (!good) {
    return PL_exception(0) ? FALSE : sg_no_memory();
  }
  return sg_make_origins_ex(h) && sg_shed_arrangement_ex(h);
}

static const PL_extension predicates[] = {
    {"arrangement_open", 5, arrangement_open, 0},
    {"arrangement_hold", 1, arrangement_hold, 0},
    {"arrangement_drop", 1, arrangement_drop, 0},
    {"arrangement_polygons", 3, arrangement_polygons, 0},
    {"arrangement_seal", 1, arrangement_seal, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_arrangement(void)
{
  functor_work3 = PL_new_functor(PL_new_atom("work"), 3);
  functor_weight3 = PL_new_functor(PL_new_atom("weight"), 3);
  atom_surface = PL_new_atom("surface");
  PL_register_extensions_in_module("sg_kernel_boolean", predicates);
}
