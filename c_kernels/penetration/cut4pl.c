/* cut4pl.c -- cut sets: finding the cuts of leaf triangles.
 *
 * Layer: glue. The doors are documented in rules/kernel/penetration.pl.
 */
#include "cut4pl.h"

#include "glue.h"

#include "engine/install.h"

#include <SWI-Stream.h>
#include <stdlib.h>
#include <string.h>

enum { ASKED = 1 << 12 }; /* candidates between questions */

/* ---- the handle ---- */

static void
close_handle(sg_cut_handle *handle)
{
  sg_cut_set_clear(&handle->set);
  sg_key_table_clear(&handle->next_name);
  sg_key_table_clear(&handle->line_of);
  sg_key_table_clear(&handle->edge_type);
  sg_key_table_clear(&handle->edges_read);
  sg_key_table_clear(&handle->bent);
  free(handle->real);
  sg_cut_rows_clear(handle);
  sg_cut_open_clear(handle);
  sg_version_drop(handle->version);
  sg_world_let_go(handle->world);
}

static void
drop_opener(sg_cut_handle *handle)
{
  if (atomic_fetch_sub(&handle->openers, 1) == 1) {
    close_handle(handle);
  }
}

static void
drop_holder(sg_cut_handle *handle)
{
  if (atomic_fetch_sub(&handle->holders, 1) == 1) {
    free(handle);
  }
}

void
sg_cut_set_keep(sg_cut_handle *handle)
{
  atomic_fetch_add(&handle->openers, 1);
  atomic_fetch_add(&handle->holders, 1);
}

void
sg_cut_set_let_go(sg_cut_handle *handle)
{
  drop_opener(handle);
  drop_holder(handle);
}

static void
shut_handle(sg_cut_handle *handle)
{
  if (!atomic_exchange(&handle->shut, true)) {
    drop_opener(handle);
  }
}

static int
release_handle(atom_t atom)
{
  sg_cut_handle *handle = PL_blob_data(atom, NULL, NULL);

  shut_handle(handle);
  drop_holder(handle);
  return TRUE;
}

static int
write_handle(IOSTREAM *out, atom_t atom, int flags)
{
  const sg_cut_handle *handle = PL_blob_data(atom, NULL, NULL);

  (void)flags;
  Sfprintf(out, handle->shut ? "<cut_set>(closed)" : "<cut_set>(%zu)",
           handle->set.pieces);
  return TRUE;
}

static PL_blob_t cut_set_blob = {.magic = PL_BLOB_MAGIC,
                                 .flags = PL_BLOB_UNIQUE | PL_BLOB_NOCOPY,
                                 .name = "cut_set",
                                 .release = release_handle,
                                 .write = write_handle};

int
sg_get_cut_set_ex(term_t t, sg_cut_handle **out)
{
  PL_blob_t *type;
  void *data;

  if (!PL_get_blob(t, &data, NULL, &type) || type != &cut_set_blob) {
    return PL_type_error("cut_set", t);
  }
  *out = data;
  return !(*out)->shut || PL_existence_error("cut_set", t);
}

/* ---- opening and closing ---- */

static foreign_t
cut_set_open(term_t pairs, term_t out)
{
  sg_world *world = sg_current_world_ex();
  sg_cut_handle *handle;

  if (!world) {
    return FALSE;
  }
  if (!(handle = calloc(1, sizeof *handle))) {
    return sg_no_memory();
  }
  atomic_init(&handle->openers, 1);
  atomic_init(&handle->holders, 1);
  handle->world = sg_world_keep(world);
  handle->version = sg_world_version(world);
  sg_cut_set_init(&handle->set, sg_cut_is_real_or_fold, handle);
  sg_key_table_init(&handle->next_name, 1);
  sg_key_table_init(&handle->line_of, 3);
  sg_key_table_init(&handle->edge_type, 4);
  sg_key_table_init(&handle->edges_read, 2);
  sg_key_table_init(&handle->bent, 2);
  if (!sg_cut_open_ex(handle, pairs)) {
    shut_handle(handle);
    drop_holder(handle);
    return FALSE;
  }
  return PL_unify_blob(out, handle, sizeof *handle, &cut_set_blob);
}

static foreign_t
cut_set_close(term_t set)
{
  sg_cut_handle *handle;

  if (!sg_get_cut_set_ex(set, &handle)) {
    return FALSE;
  }
  shut_handle(handle);
  return TRUE;
}

/* ---- candidates ---- */

/* A walk over candidates `next` .. `end` - 1. */
typedef struct candidates {
  sg_cut_handle *handle;
  size_t next, end;
} candidates;

/* Puts the candidates of one sort in hand; FALSE without an exception: there
 * are none. */
static int
first_candidates(term_t set, bool curve, candidates *out)
{
  sg_cut_handle *handle;

  if (!sg_get_cut_set_ex(set, &handle) || !sg_cut_join_ex(handle)) {
    return FALSE;
  }
  *out = (candidates){handle, curve ? handle->curve_candidates : 0,
                      curve ? handle->candidates : handle->curve_candidates};
  return out->next < out->end;
}

/* Gives the candidate in hand; the last one leaves no choice point. */
static foreign_t
give_candidate(candidates *c, term_t first, term_t second)
{
  if (c->handle->shut) {
    return FALSE;
  }
  const uint32_t *pair = c->handle->candidate[c->next++];

  return PL_unify_integer(first, pair[0]) && PL_unify_integer(second, pair[1]);
}

static foreign_t
candidate(term_t set, term_t first, term_t second, control_t control,
          bool curve)
{
  candidates fresh, *c = &fresh;

  if (PL_foreign_control(control) == PL_PRUNED) {
    free(PL_foreign_context_address(control));
    return TRUE;
  }
  if (PL_foreign_control(control) != PL_FIRST_CALL) {
    c = PL_foreign_context_address(control);
  } else if (!first_candidates(set, curve, c)) {
    return FALSE;
  }
  foreign_t given = give_candidate(c, first, second);

  if (given && c->next < c->end) {
    if (c == &fresh) {
      if (!(c = malloc(sizeof *c))) {
        return sg_no_memory();
      }
      *c = fresh;
    }
    PL_retry_address(c);
  }
  if (c != &fresh) {
    free(c);
  }
  return given;
}

static foreign_t
cut_candidate(term_t set, term_t t1, term_t t2, control_t control)
{
  return candidate(set, t1, t2, control, false);
}

static foreign_t
curve_candidate(term_t set, term_t e, term_t t, control_t control)
{
  return candidate(set, e, t, control, true);
}

/* ---- one pair ---- */

static int
get_number_ex(term_t t, size_t limit, const char *type, uint32_t *out)
{
  int64_t i;

  if (!PL_get_int64_ex(t, &i)) {
    return FALSE;
  }
  if (i < 0 || (uint64_t)i >= limit) {
    return PL_existence_error(type, t);
  }
  *out = (uint32_t)i;
  return TRUE;
}

static int
get_triangles_ex(term_t set, term_t t1, term_t t2, sg_cut_handle **handle,
                 uint32_t t[2])
{
  if (!sg_get_cut_set_ex(set, handle)) {
    return FALSE;
  }
  size_t limit = (*handle)->set.model.triangles;

  return get_number_ex(t1, limit, "cut_triangle", &t[0]) &&
         get_number_ex(t2, limit, "cut_triangle", &t[1]);
}

static foreign_t
cut_side(term_t set, term_t t1, term_t t2, term_t side)
{
  sg_cut_handle *handle;
  uint32_t t[2];
  double a[3][3], b[3][3];

  if (!get_triangles_ex(set, t1, t2, &handle, t)) {
    return FALSE;
  }
  sg_cut_model_corners(&handle->set.model, t[0], a);
  sg_cut_model_corners(&handle->set.model, t[1], b);
  return PL_unify_integer(
      side, sg_cut_side((const double(*)[3])a, (const double(*)[3])b));
}

static foreign_t
cut_enter(term_t set, term_t t1, term_t t2, term_t count)
{
  sg_cut_handle *handle;
  uint32_t t[2];

  if (!get_triangles_ex(set, t1, t2, &handle, t)) {
    return FALSE;
  }
  int n = sg_cut_set_enter(&handle->set, t[0], t[1]);

  return n < 0 ? sg_no_memory() : PL_unify_integer(count, n);
}

/* cut_without_twins(+Set) is det. */
static foreign_t
cut_without_twins(term_t set)
{
  sg_cut_handle *handle;

  if (!sg_get_cut_set_ex(set, &handle)) {
    return FALSE;
  }
  handle->without_quiet = true;
  return TRUE;
}

/* The join as a whole: what the rule find_cuts_by_rule/1 does pair by pair. */
static foreign_t
cut_find(term_t set)
{
  sg_cut_handle *handle;

  if (!sg_get_cut_set_ex(set, &handle) || !sg_cut_join_ex(handle) ||
      (handle->without_quiet && !sg_cut_quiet_ex(handle))) {
    return FALSE;
  }
  for (size_t k = 0; k < handle->curve_candidates; k++) {
    const uint32_t *pair = handle->candidate[k];

    if ((!handle->without_quiet || !handle->quiet[k]) &&
        sg_cut_set_enter(&handle->set, pair[0], pair[1]) < 0) {
      return sg_no_memory();
    }
    if (k % ASKED == ASKED - 1 && PL_handle_signals() < 0) {
      return FALSE;
    }
  }
  return TRUE;
}

static foreign_t
curve_enter(term_t set, term_t e, term_t t, term_t count)
{
  sg_cut_handle *handle;
  uint32_t edge = 0, triangle = 0;

  if (!sg_get_cut_set_ex(set, &handle) ||
      !get_number_ex(e, handle->set.model.edges, "cut_edge", &edge) ||
      !get_number_ex(t, handle->set.model.triangles, "cut_triangle",
                     &triangle)) {
    return FALSE;
  }
  int n = sg_cut_set_enter_curve(&handle->set, edge, triangle);

  return n < 0 ? sg_no_memory() : PL_unify_integer(count, n);
}

static foreign_t
cut_triangle(term_t set, term_t t, term_t s, term_t p, term_t id)
{
  sg_cut_handle *handle;
  uint32_t number = 0;

  if (!sg_get_cut_set_ex(set, &handle) ||
      !get_number_ex(t, handle->set.model.triangles, "cut_triangle", &number)) {
    return FALSE;
  }
  const sg_leaf_triangle *leaf = &handle->set.model.triangle[number];

  return PL_unify_integer(s, leaf->s) && PL_unify_integer(p, leaf->p) &&
         PL_unify_integer(id, leaf->t);
}

/* vertex(V), edge(V1,V2) or face(T). */
static int
unify_place(term_t t, const sg_cut_model *model, const sg_place *place)
{
  switch (place->kind) {
  case SG_AT_VERTEX:
    return PL_unify_term(t, PL_FUNCTOR_CHARS, "vertex", 1, PL_INT,
                         model->vertex[place->a].v);
  case SG_ON_EDGE:
    return PL_unify_term(t, PL_FUNCTOR_CHARS, "edge", 2, PL_INT,
                         model->vertex[place->a].v, PL_INT,
                         model->vertex[place->b].v);
  case SG_ON_FACE:
    return PL_unify_term(t, PL_FUNCTOR_CHARS, "face", 1, PL_INT,
                         model->triangle[place->a].t);
  }
  return FALSE;
}

static int
unify_end(term_t t, const sg_cut_model *model, const uint32_t pair[2],
          const sg_cut_end *end)
{
  term_t place = PL_new_term_refs(2);

  for (int k = 0; k < 2; k++) {
    sg_place at = sg_place_of(model, pair[k], (int)end->f[k]);
    if (!unify_place(place + k, model, &at)) {
      return FALSE;
    }
  }
  return PL_unify_term(t, PL_FUNCTOR_CHARS, "-", 2, PL_TERM, place, PL_TERM,
                       place + 1);
}

static foreign_t
cut_ends(term_t set, term_t t1, term_t t2, term_t cuts)
{
  sg_cut_handle *handle;
  uint32_t t[2];
  double a[3][3], b[3][3];
  sg_cut cut[SG_CUT_MAX];
  int n;
  term_t tail = PL_copy_term_ref(cuts), head = PL_new_term_ref();
  term_t end = PL_new_term_refs(2);

  if (!get_triangles_ex(set, t1, t2, &handle, t)) {
    return FALSE;
  }
  const sg_cut_model *model = &handle->set.model;

  sg_cut_model_corners(model, t[0], a);
  sg_cut_model_corners(model, t[1], b);
  sg_cut_kind kind =
      sg_cut_triangles((const double(*)[3])a, (const double(*)[3])b, cut, &n);

  for (int i = 0; i < n; i++) {
    PL_put_variable(end);
    PL_put_variable(end + 1);
    if (!PL_unify_list(tail, head, tail) ||
        !unify_end(end, model, t, &cut[i].end[0]) ||
        !unify_end(end + 1, model, t, &cut[i].end[1]) ||
        !PL_unify_term(head, PL_FUNCTOR_CHARS, "cut", 3, PL_CHARS,
                       kind == SG_CUT_COPLANAR ? "coplanar" : "crossing",
                       PL_TERM, end, PL_TERM, end + 1)) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

static const PL_extension predicates[] = {
    {"cut_set_open", 2, cut_set_open, 0},
    {"cut_set_close", 1, cut_set_close, 0},
    {"cut_without_twins", 1, cut_without_twins, 0},
    {"cut_candidate", 3, cut_candidate, PL_FA_NONDETERMINISTIC},
    {"curve_candidate", 3, curve_candidate, PL_FA_NONDETERMINISTIC},
    {"cut_side", 4, cut_side, 0},
    {"cut_find", 1, cut_find, 0},
    {"cut_enter", 4, cut_enter, 0},
    {"curve_enter", 4, curve_enter, 0},
    {"cut_triangle", 5, cut_triangle, 0},
    {"cut_ends", 4, cut_ends, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_cut(void)
{
  PL_register_extensions_in_module("sg_kernel_penetration", predicates);
}
