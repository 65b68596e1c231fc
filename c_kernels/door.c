/* door.c -- see door.h.
 *
 * Layer: glue.
 */
#include "door.h"

#include <SWI-Stream.h>
#include <stdlib.h>

/* ---- a call ---- */

void
sg_door_open(sg_call *call)
{
  sg_call_open(call, &sg_prolog_cancel, sg_current_world_ex);
}

/* What sg_call_at() says of an argument. */
static int
put_part(term_t t, const sg_refusal *r, term_t list)
{
  int good = PL_put_term(t, list);

  for (size_t i = 1; good && i < r->item; i++) {
    good = PL_get_tail(t, t);
  }
  return good && PL_get_head(t, t) &&
         (r->field == 0 || PL_get_arg((size_t)r->field, t, t));
}

static int
put_culprit(term_t t, const sg_refusal *r, term_t t0)
{
  term_t a = t0 + (term_t)(r->argument - 1);

  return r->argument == 0 ? PL_put_int64(t, r->number)
         : r->item > 0    ? put_part(t, r, a)
         : r->pair
             ? PL_cons_functor(t, PL_new_functor(PL_new_atom("-"), 2), a, a + 1)
             : PL_put_term(t, a);
}

/* error(geometry_error(what(N, ...)), _) */
static int
raise_geometry(const sg_refusal *r)
{
  term_t t = PL_new_term_ref(), number = PL_new_term_refs(4);
  term_t error = PL_new_term_ref();

  for (size_t i = 0; i < r->numbers; i++) {
    if (!PL_put_integer(number + i, r->of[i])) {
      return FALSE;
    }
  }
  return PL_cons_functor_v(t, PL_new_functor(PL_new_atom(r->what), r->numbers),
                           number) &&
         PL_unify_term(error, PL_FUNCTOR_CHARS, "error", 2, PL_FUNCTOR_CHARS,
                       "geometry_error", 1, PL_TERM, t, PL_VARIABLE) &&
         PL_raise_exception(error);
}

static int
raise_refusal(const sg_refusal *r, term_t t0)
{
  term_t culprit = PL_new_term_ref();

  if (!put_culprit(culprit, r, t0)) {
    return FALSE;
  }
  switch (r->how) {
  case SG_REFUSED_NOTHING:
    break;
  case SG_REFUSED_MEMORY:
    return PL_resource_error("memory");
  case SG_REFUSED_RESOURCE:
    return PL_resource_error(r->what);
  case SG_REFUSED_DOMAIN:
    return PL_domain_error(r->what, culprit);
  case SG_REFUSED_EXISTENCE:
    return PL_existence_error(r->what, culprit);
  case SG_REFUSED_PERMISSION:
    return PL_permission_error(r->action, r->what, culprit);
  case SG_REFUSED_REPRESENTATION:
    return PL_representation_error(r->what);
  case SG_REFUSED_GEOMETRY:
    return raise_geometry(r);
  case SG_REFUSED_ROW:
    return sg_raise_status(r->status, r->relation, &r->fault);
  }
  return FALSE;
}

foreign_t
sg_door_close(sg_call *call, term_t t0, int done)
{
  if (!done && !PL_exception(0) && call->refusal.how != SG_REFUSED_NOTHING) {
    raise_refusal(&call->refusal, t0);
  }
  sg_call_close(call);
  return (foreign_t)done;
}

/* ---- many answers ---- */

/* Between two answers. */
typedef struct answers {
  sg_call call;
  size_t n, next;
  bool fresh; /* every answer fits: the outputs are variables, all different */
  max_align_t rows[1]; /* a list of call.h */
} answers;

_Static_assert(sizeof(sg_int_list) <= sizeof(max_align_t),
               "a list fits answers.rows");

static bool
are_fresh(term_t t0, unsigned outputs)
{
  for (unsigned i = 0; outputs >> i != 0; i++) {
    if (!(outputs >> i & 1)) {
      continue;
    }
    if (!PL_is_variable(t0 + i)) {
      return false;
    }
    for (unsigned k = 0; k < i; k++) {
      if (outputs >> k & 1 && PL_compare(t0 + i, t0 + k) == 0) {
        return false;
      }
    }
  }
  return true;
}

/* The first answer from `i` on that fits, which is tried, not kept. The number
 * of rows: there is none, or an exception. */
static size_t
find_answer(const answers *a, term_t t0, size_t i,
            int (*answer)(term_t t0, const void *rows, size_t i))
{
  size_t n = a->n;

  if (a->fresh) {
    return i;
  }
  for (; i < n; i++) {
    fid_t frame = PL_open_foreign_frame();
    int fits = frame && answer(t0, a->rows, i);

    if (!frame || PL_exception(0)) {
      return n;
    }
    PL_discard_foreign_frame(frame);
    if (fits) {
      return i;
    }
    if (!sg_door_goes_on(i)) {
      return n;
    }
  }
  return n;
}

/* Gives the answer in hand, which is `a`->next. 1: the last one, 0: none; -1:
 * more will come. */
static int
give_answer(answers *a, term_t t0,
            int (*answer)(term_t t0, const void *rows, size_t i))
{
  size_t here = a->next, n = a->n;

  /* What comes after is looked for first: it must not see this one's terms. */
  a->next = here < n ? find_answer(a, t0, here + 1, answer) : n;
  if (here >= n || PL_exception(0) || !answer(t0, a->rows, here)) {
    return 0;
  }
  return a->next < n ? -1 : 1;
}

foreign_t
sg_door_answer(term_t t0, unsigned outputs, control_t control,
               int (*ask)(sg_call *call, term_t t0, void *rows, size_t *n),
               int (*answer)(term_t t0, const void *rows, size_t i))
{
  answers first, *a = &first, *kept = NULL;

  if (PL_foreign_control(control) != PL_FIRST_CALL) {
    a = kept = PL_foreign_context_address(control);
  } else {
    first = (answers){.fresh = are_fresh(t0, outputs)};
    sg_door_open(&first.call);
    if (!ask(&first.call, t0, first.rows, &first.n)) {
      return sg_door_close(&first.call, t0, FALSE);
    }
    sg_call_rest(&first.call);
    first.next = find_answer(&first, t0, 0, answer);
  }
  int given =
      PL_foreign_control(control) == PL_PRUNED ? 1 : give_answer(a, t0, answer);

  if (given < 0 && (kept || (kept = malloc(sizeof *kept)))) {
    if (a != kept) {
      *kept = first; /* nothing in the call is asked any more */
    }
    PL_retry_address(kept);
  }
  sg_call_close(&a->call);
  free(kept);
  return given < 0 ? (foreign_t)PL_resource_error("memory") : (foreign_t)given;
}

/* ---- handles ---- */

static void
let_go(sg_handle *handle)
{
  if (atomic_fetch_sub(&handle->users, 1) == 1) {
    handle->type->free(handle->object);
    handle->object = NULL;
  }
}

/* False: it is closed. */
static bool
take(sg_handle *handle)
{
  unsigned users = atomic_load(&handle->users);

  while (users > 0 &&
         !atomic_compare_exchange_weak(&handle->users, &users, users + 1)) {
  }
  if (users > 0 && atomic_load(&handle->closed)) {
    let_go(handle);
    return false;
  }
  return users > 0;
}

static void
shut(sg_handle *handle)
{
  if (!atomic_exchange(&handle->closed, true)) {
    let_go(handle);
  }
}

int
sg_handle_release(atom_t atom)
{
  sg_handle *handle = PL_blob_data(atom, NULL, NULL);

  shut(handle);
  free(handle);
  return TRUE;
}

int
sg_handle_write(IOSTREAM *out, atom_t atom, int flags)
{
  const sg_handle *handle = PL_blob_data(atom, NULL, NULL);

  (void)flags;
  Sfprintf(out, handle->closed ? "<%s>(closed)" : "<%s>(%p)",
           handle->type->blob.name, (const void *)handle);
  return TRUE;
}

/* The handle that t is, open or not. */
static int
find(term_t t, sg_handle_type *type, sg_handle **out)
{
  PL_blob_t *blob;
  void *data;

  if (!PL_get_blob(t, &data, NULL, &blob) || blob != &type->blob) {
    return PL_is_variable(t) ? PL_instantiation_error(t)
                             : PL_type_error(type->blob.name, t);
  }
  *out = data;
  return TRUE;
}

int
sg_handle_get(term_t t, sg_handle_type *type, sg_handle **out)
{
  sg_handle *handle = NULL;

  *out = NULL;
  if (!find(t, type, &handle)) {
    return FALSE;
  }
  if (!take(handle)) {
    return PL_existence_error(type->blob.name, t);
  }
  *out = handle;
  return TRUE;
}

void
sg_handle_done(sg_handle *handle)
{
  if (handle) {
    let_go(handle);
  }
}

static void
end_use(void *handle)
{
  let_go(handle);
}

int
sg_handle_hold(sg_call *call, term_t t, sg_handle_type *type, void **object)
{
  sg_handle *handle;

  if (!sg_handle_get(t, type, &handle)) {
    return FALSE;
  }
  *object = handle->object;
  return sg_call_hold(call, handle, end_use);
}

int
sg_handle_unify(term_t t, sg_handle_type *type, void *object)
{
  sg_handle *handle = malloc(sizeof *handle);

  if (!handle) {
    type->free(object);
    return PL_resource_error("memory");
  }
  handle->object = object;
  handle->type = type;
  atomic_init(&handle->users, 1);
  atomic_init(&handle->closed, false);
  return PL_unify_blob(t, handle, sizeof *handle, &type->blob);
}

int
sg_handle_close(term_t t, sg_handle_type *type)
{
  sg_handle *handle;

  if (!sg_handle_get(t, type, &handle)) {
    return FALSE;
  }
  shut(handle);
  sg_handle_done(handle);
  return TRUE;
}

/* ---- words, terms, lists ---- */

int
sg_door_word(term_t t, const atom_t *word, int n, const char *type)
{
  atom_t name;

  if (!PL_get_atom_ex(t, &name)) {
    return -1;
  }
  for (int k = 0; k < n; k++) {
    if (word[k] == name) {
      return k;
    }
  }
  PL_domain_error(type, t);
  return -1;
}

int
sg_door_functor(term_t t, functor_t functor, const char *type)
{
  return PL_is_functor(t, functor) ||
         (PL_is_variable(t) ? PL_instantiation_error(t)
                            : PL_type_error(type, t));
}

int
sg_door_list_length(term_t list, size_t *n)
{
  switch (PL_skip_list(list, 0, n)) {
  case PL_LIST:
    return TRUE;
  case PL_PARTIAL_LIST:
    return PL_instantiation_error(list);
  default:
    return PL_type_error("list", list);
  }
}
