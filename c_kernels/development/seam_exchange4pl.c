/* seam_exchange4pl.c -- folds exchanged for a shorter seam, and how short it
 * can be (documented in kernel/pattern.pl).
 *
 * Layer: glue.
 */
#include "development4pl.h"

#include "glue.h"
#include "seam_bound.h"
#include "seam_exchange.h"

#include "engine/install.h"

#include <stdlib.h>
#include <string.h>

static int
stop_ex(bool stopped)
{
  return stopped ? FALSE : sg_no_memory();
}

/* The joints of a list, which are numbered from 1. Owner: the caller, free().
 */
static int
get_joints_ex(term_t list, const sg_development *d, uint32_t **out, size_t *n)
{
  int32_t *id;

  *out = NULL;
  if (!sg_get_ids_ex(list, &id, n)) {
    return FALSE;
  }
  *out = malloc((*n + 1) * sizeof **out);
  bool good = *out != NULL, known = true;

  for (size_t i = 0; good && known && i < *n; i++) {
    known = (size_t)id[i] <= d->joints.n;
    (*out)[i] = (uint32_t)id[i] - 1;
  }
  free(id);
  return good && known ? TRUE
         : good        ? PL_existence_error("joint", list)
                       : sg_no_memory();
}

/* Which joints are in a list. Owner: the caller, free(). */
static int
get_kept_ex(term_t list, const sg_development *d, bool **out)
{
  uint32_t *joint;
  size_t n;

  *out = NULL;
  if (!get_joints_ex(list, d, &joint, &n)) {
    free(joint);
    return FALSE;
  }
  *out = calloc(d->joints.n + 1, sizeof **out);
  for (size_t i = 0; *out && i < n; i++) {
    (*out)[joint[i]] = true;
  }
  free(joint);
  return *out || sg_no_memory();
}

static int
get_objective_ex(term_t t, bool *pieces)
{
  static const char *const name[] = {"seam", "pieces"};
  char *text;

  if (!PL_get_atom_chars(t, &text)) {
    return PL_type_error("atom", t);
  }
  *pieces = strcmp(text, name[1]) == 0;
  return *pieces || strcmp(text, name[0]) == 0 ||
         PL_domain_error("exchange_objective", t);
}

static int
get_input_ex(sg_development *d, term_t objective, term_t effort,
             sg_exchange_input *in)
{
  int64_t most;

  if (!get_objective_ex(objective, &in->pieces) ||
      !PL_get_int64_ex(effort, &most)) {
    return FALSE;
  }
  in->flattening = &d->flattening;
  in->effort = (size_t)most;
  return most >= 0 || PL_domain_error("not_less_than_zero", effort);
}

/* exchange_seams(+Flattening, +Order, +Kept, +Objective, +Effort, -Exchanges)
 * is det. */
static foreign_t
exchange_seams(term_t handle, term_t number, term_t kept_list, term_t objective,
               term_t most, term_t exchanges)
{
  sg_development *d;
  sg_exchange_input in = {0};
  sg_exchange_end end;
  bool *kept, stopped = false;
  int32_t order;

  if (!sg_get_development_ex(handle, &d) || !sg_get_int32_ex(number, &order) ||
      !get_input_ex(d, objective, most, &in)) {
    return FALSE;
  }
  if (order < 0) {
    return PL_domain_error("not_less_than_zero", number);
  }
  if (!get_kept_ex(kept_list, d, &kept)) {
    return FALSE;
  }
  uint32_t *joint = sg_joint_order(&d->flattening, (unsigned)order,
                                   &sg_prolog_poll, &stopped);

  in.order = joint;
  in.kept = kept;
  bool good = joint && sg_seam_exchange(&in, &sg_prolog_poll, &end, &stopped);

  free(joint);
  free(kept);
  return good ? PL_unify_int64(exchanges, (int64_t)end.exchanges)
              : stop_ex(stopped);
}

/* join_folds(+Flattening, +Joints) is det. */
static foreign_t
join_folds(term_t handle, term_t list)
{
  sg_development *d;
  uint32_t *joint;
  size_t n;
  bool stopped = false;

  if (!sg_get_development_ex(handle, &d) ||
      !get_joints_ex(list, d, &joint, &n)) {
    return FALSE;
  }
  d->laid = false;
  bool good = sg_flattening_join_folds(&d->flattening, joint, n,
                                       &sg_prolog_poll, &stopped);

  free(joint);
  return good || stop_ex(stopped);
}

/* seam_length(+Flattening, -Length) is det. */
static foreign_t
seam_length(term_t handle, term_t length)
{
  sg_development *d;

  return sg_get_development_ex(handle, &d) &&
         sg_unify_double(length, sg_seam_length(&d->flattening));
}

/* flattening_bound(+Flattening, -Bound) is det. */
static foreign_t
flattening_bound(term_t handle, term_t out)
{
  static const char *const by[] = {"tree", "forest", "moats"};
  sg_development *d;
  sg_seam_bound b;
  bool stopped;

  if (!sg_get_development_ex(handle, &d)) {
    return FALSE;
  }
  if (!sg_seam_bound_find(&d->flattening, &sg_prolog_poll, &b, &stopped)) {
    return stop_ex(stopped);
  }
  return PL_unify_term(out, PL_FUNCTOR_CHARS, "bound", 3, PL_FLOAT,
                       b.bound + 0.0, PL_CHARS, by[b.by], PL_FLOAT,
                       b.tree + 0.0);
}

static int
get_face_ex(term_t t, const sg_development *d, uint32_t *out)
{
  int32_t p;

  if (!sg_get_id_ex(t, &p)) {
    return FALSE;
  }
  for (*out = 0; *out < d->faces.faces; ++*out) {
    if (sg_development_polygon(d, *out) == p) {
      return TRUE;
    }
  }
  return PL_existence_error("polygon", t);
}

/* fold_path(+Flattening, +P, +Q, -Joints) is det. */
static foreign_t
fold_path(term_t handle, term_t p, term_t q, term_t list)
{
  sg_development *d;
  uint32_t from, to, *path;
  size_t n;
  bool stopped;
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  if (!sg_get_development_ex(handle, &d) || !get_face_ex(p, d, &from) ||
      !get_face_ex(q, d, &to)) {
    return FALSE;
  }
  path = sg_flattening_path(&d->flattening, from, to, &sg_prolog_poll, &n,
                            &stopped);
  if (!path) {
    return stopped ? FALSE : sg_no_memory();
  }
  int good = TRUE;

  for (size_t i = 0; good && i < n; i++) {
    good = PL_unify_list(tail, head, tail) &&
           PL_unify_int64(head, (int64_t)path[i] + 1);
  }
  free(path);
  return good && PL_unify_nil(tail);
}

void
sg_install_seam_exchange(void)
{
  static const PL_extension doors[] = {
      {"exchange_seams", 6, (pl_function_t)exchange_seams, 0},
      {"join_folds", 2, (pl_function_t)join_folds, 0},
      {"seam_length", 2, (pl_function_t)seam_length, 0},
      {"flattening_bound", 2, (pl_function_t)flattening_bound, 0},
      {"fold_path", 4, (pl_function_t)fold_path, 0},
      {NULL, 0, NULL, 0}};

  PL_register_extensions_in_module("sg_kernel_pattern", doors);
}
