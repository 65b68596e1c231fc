/* arrangement4pl.c -- arrangements behind a Prolog handle.
 *
 * Layer: glue. The doors are documented in rules/kernel.pl. An arrangement
 * looks into its cut set, so it is good for nothing once that is closed.
 */
#include "cut4pl.h"

#include "arrangement.h"
#include "glue.h"
#include "solid4pl.h"
#include "work4pl.h"

#include "../engine/install.h"

#include <SWI-Stream.h>
#include <stdlib.h>
#include <string.h>

typedef struct handle {
  sg_arrangement *arrangement; /* null: closed */
  sg_cut_handle *set;
  atom_t set_atom;          /* registered: it lives as long as this */
  int32_t *s;               /* [n]: the leaves */
  sg_kept_tree **tree;      /* [n], held */
  const sg_leaf_tree **own; /* [n]: the same, as the kernel wants them */
  size_t n;
} handle;

static functor_t functor_component6, functor_side3, functor_point3,
    functor_minus2;
static atom_t atom_only, atom_second, atom_unknown;

/* ---- the handle ---- */

static void
close_handle(handle *h)
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
  free(h->s);
  h->tree = NULL;
  h->own = NULL;
  h->s = NULL;
  h->n = 0;
  if (h->set_atom) {
    PL_unregister_atom(h->set_atom);
    h->set_atom = 0;
  }
}

static int
release_handle(atom_t atom)
{
  handle *h = PL_blob_data(atom, NULL, NULL);

  close_handle(h);
  free(h);
  return TRUE;
}

static int
write_handle(IOSTREAM *out, atom_t atom, int flags)
{
  const handle *h = PL_blob_data(atom, NULL, NULL);

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

static int
get_handle_ex(term_t t, handle **out)
{
  PL_blob_t *type;
  void *data;

  if (!PL_get_blob(t, &data, NULL, &type) || type != &arrangement_blob) {
    return PL_type_error("arrangement", t);
  }
  *out = data;
  return ((*out)->arrangement && !(*out)->set->closed) ||
         PL_existence_error("arrangement", t);
}

/* ---- opening ---- */

static int
compare_segments(const void *x, const void *y)
{
  int32_t a = *(const int32_t *)x, b = *(const int32_t *)y;

  return (a > b) - (a < b);
}

/* Reads the segments, each once, ascending. */
static int
get_segments_ex(term_t list, handle *h)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  size_t n, kept = 0;

  if (PL_skip_list(list, 0, &n) != PL_LIST) {
    return PL_type_error("list", list);
  }
  if (!(h->s = malloc((n + 1) * sizeof *h->s))) {
    return sg_no_memory();
  }
  for (size_t i = 0; i < n; i++) {
    if (!PL_get_list_ex(tail, head, tail) || !sg_get_id_ex(head, &h->s[i])) {
      return FALSE;
    }
  }
  qsort(h->s, n, sizeof *h->s, compare_segments);
  for (size_t i = 0; i < n; i++) {
    if (i == 0 || h->s[i] != h->s[i - 1]) {
      h->s[kept++] = h->s[i];
    }
  }
  h->n = kept;
  return TRUE;
}

static int
hold_trees_ex(handle *h)
{
  sg_crew *crew = sg_crew_open(0);
  int good;

  h->tree = calloc(h->n + 1, sizeof(sg_kept_tree *));
  h->own = calloc(h->n + 1, sizeof(sg_leaf_tree *));
  good = h->tree && h->own && crew
             ? sg_trees_hold_ex(h->set->world, h->set->version, &h->set->views,
                                h->s, h->n, crew, h->tree)
             : sg_no_memory();
  sg_crew_close(crew);
  for (size_t i = 0; good && i < h->n; i++) {
    h->own[i] = h->tree[i]->tree;
  }
  return good;
}

static foreign_t
arrangement_open(term_t set, term_t segments, term_t out)
{
  handle *h = calloc(1, sizeof *h);

  if (!h) {
    return sg_no_memory();
  }
  if (!sg_get_cut_set_ex(set, &h->set) || !PL_get_atom(set, &h->set_atom)) {
    free(h);
    return FALSE;
  }
  PL_register_atom(h->set_atom);
  int good = get_segments_ex(segments, h) && hold_trees_ex(h);

  if (good) {
    h->arrangement = sg_arrangement_open(
        &(sg_leaves){.set = &h->set->set,
                     .views = &h->set->views,
                     .s = h->s,
                     .tree = h->own,
                     .n = h->n,
                     .near = (const int32_t(*)[2])h->set->pair,
                     .pairs = h->set->pairs});
    good = h->arrangement || sg_no_memory();
  }
  if (!good) {
    close_handle(h);
    free(h);
    return FALSE;
  }
  return PL_unify_blob(out, h, sizeof *h, &arrangement_blob);
}

static foreign_t
arrangement_close(term_t t)
{
  handle *h;

  if (!get_handle_ex(t, &h)) {
    return FALSE;
  }
  close_handle(h);
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

/* arrangement_polygon(+Arrangement, +S, +P, +Work, +Reach) is det. */
static foreign_t
arrangement_polygon(term_t t, term_t s, term_t p, term_t w, term_t r)
{
  handle *h;
  int32_t segment, polygon, edge;
  sg_work *work;
  double reach;

  if (!get_handle_ex(t, &h) || !sg_get_id_ex(s, &segment) ||
      !sg_get_id_ex(p, &polygon) || !sg_get_work_ex(w, &work) ||
      !sg_get_finite_ex(r, &reach)) {
    return FALSE;
  }
  switch (sg_arrangement_polygon(h->arrangement, segment, polygon, work, reach,
                                 &edge, &sg_prolog_poll)) {
  case SG_DONE:
    return TRUE;
  case SG_STUCK:
    return raise_stuck(segment, polygon, work, edge);
  case SG_STOPPED:
    return FALSE;
  case SG_NO_SPACE:
    break;
  }
  return sg_no_memory();
}

static foreign_t
arrangement_seal(term_t t)
{
  handle *h;
  sg_crew *crew;

  if (!get_handle_ex(t, &h)) {
    return FALSE;
  }
  if (!(crew = sg_crew_open(0))) {
    return sg_no_memory();
  }
  int good = sg_arrangement_seal(h->arrangement, crew, &sg_prolog_poll);

  sg_crew_close(crew);
  return good || (PL_exception(0) ? FALSE : sg_no_memory());
}

/* ---- components ---- */

static int
put_sides(term_t list, const sg_component *c)
{
  term_t one = PL_new_term_ref();

  PL_put_nil(list);
  for (size_t i = c->sides; i > 0; i--) {
    const sg_side *side = &c->side[i - 1];

    PL_put_variable(one);
    if (!PL_unify_term(one, PL_FUNCTOR, functor_side3, PL_INT, side->s, PL_INT,
                       side->below, PL_INT, side->above) ||
        !PL_cons_list(list, one, list)) {
      return FALSE;
    }
  }
  return TRUE;
}

/* component(C, S, P, point(X, Y, Z), Sides, Which) */
static int
unify_component(term_t t, size_t number, const sg_component *c)
{
  term_t sides = PL_new_term_ref();

  return put_sides(sides, c) &&
         PL_unify_term(t, PL_FUNCTOR, functor_component6, PL_INT64,
                       (int64_t)number, PL_INT, c->s, PL_INT, c->p, PL_FUNCTOR,
                       functor_point3, PL_FLOAT, c->at->p[0], PL_FLOAT,
                       c->at->p[1], PL_FLOAT, c->at->p[2], PL_TERM, sides,
                       PL_ATOM,
                       c->unknown  ? atom_unknown
                       : c->second ? atom_second
                                   : atom_only);
}

static foreign_t
arrangement_components(term_t t, term_t list)
{
  handle *h;
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  if (!get_handle_ex(t, &h)) {
    return FALSE;
  }
  size_t n = sg_arrangement_components(h->arrangement);

  for (size_t i = 0; i < n; i++) {
    sg_component c = sg_arrangement_component(h->arrangement, i);
    fid_t frame = PL_open_foreign_frame();
    int good = frame && PL_unify_list(tail, head, tail) &&
               unify_component(head, i, &c);

    PL_close_foreign_frame(frame);
    if (!good) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

/* ---- choosing ---- */

/* Reads [C-Sense, ...] into sense[]. */
static int
get_senses_ex(term_t list, size_t n, int8_t *sense)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  term_t arg = PL_new_term_ref();

  while (PL_get_list_ex(list, head, tail)) {
    int64_t c;
    int turn;

    list = tail;
    if (!PL_is_functor(head, functor_minus2) || !PL_get_arg(1, head, arg) ||
        !PL_get_int64_ex(arg, &c)) {
      return PL_exception(0) ? FALSE : PL_type_error("pair", head);
    }
    if (c < 0 || (uint64_t)c >= n) {
      return PL_existence_error("component", arg);
    }
    if (!PL_get_arg(2, head, arg) || !PL_get_integer_ex(arg, &turn)) {
      return FALSE;
    }
    if (turn != 1 && turn != -1) {
      return PL_domain_error("sense", arg);
    }
    sense[c] = (int8_t)turn;
  }
  return PL_exception(0) ? FALSE : PL_get_nil_ex(list);
}

static int
give_origins_ex(handle *h, sg_solid *solid, const uint32_t *point_of)
{
  size_t made = solid->vertices - solid->plain;

  solid->origin = calloc(made + 1, sizeof *solid->origin);
  if (!solid->origin) {
    return sg_no_memory();
  }
  for (size_t i = 0; i < made; i++) {
    fid_t frame = PL_open_foreign_frame();
    term_t t = PL_new_term_ref();
    int good = frame && sg_unify_origin(t, &h->set->set.points, point_of[i]) &&
               sg_get_term_ex(t, &solid->origin[i]);

    PL_discard_foreign_frame(frame);
    if (!good) {
      return FALSE;
    }
  }
  return TRUE;
}

static foreign_t
arrangement_select(term_t t, term_t senses, term_t out)
{
  handle *h;
  sg_solid solid = {0};
  uint32_t *point_of = NULL;

  if (!get_handle_ex(t, &h)) {
    return FALSE;
  }
  size_t n = sg_arrangement_components(h->arrangement);
  int8_t *sense = calloc(n + 1, 1);
  int good = sense ? get_senses_ex(senses, n, sense) : sg_no_memory();

  if (good && !sg_arrangement_select(h->arrangement, sense, &sg_prolog_poll,
                                     &solid, &point_of)) {
    good = PL_exception(0) ? FALSE : sg_no_memory();
  }
  good = good && give_origins_ex(h, &solid, point_of);
  free(sense);
  free(point_of);
  if (!good) {
    sg_solid_clear(&solid);
    return FALSE;
  }
  return sg_unify_solid(out, &solid);
}

static const PL_extension predicates[] = {
    {"arrangement_open", 3, arrangement_open, 0},
    {"arrangement_close", 1, arrangement_close, 0},
    {"arrangement_polygon", 5, arrangement_polygon, 0},
    {"arrangement_seal", 1, arrangement_seal, 0},
    {"arrangement_components", 2, arrangement_components, 0},
    {"arrangement_select", 3, arrangement_select, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_arrangement(void)
{
  functor_component6 = PL_new_functor(PL_new_atom("component"), 6);
  functor_side3 = PL_new_functor(PL_new_atom("side"), 3);
  functor_point3 = PL_new_functor(PL_new_atom("point"), 3);
  functor_minus2 = PL_new_functor(PL_new_atom("-"), 2);
  atom_only = PL_new_atom("only");
  atom_second = PL_new_atom("second");
  atom_unknown = PL_new_atom("unknown");
  PL_register_extensions_in_module("sg_kernel", predicates);
}
