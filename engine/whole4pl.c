/* whole4pl.c -- the gate between edited worlds and kernels, and how edits that
 * would break a world are refused.
 *
 * Layer: glue.
 */
#include "edit4pl.h"

#include <stdlib.h>

/* ---- rows as terms ------------------------------------------------------- */

static int
put_row(term_t t, const sg_version *version, sg_relation relation, sg_row row)
{
  const sg_relation_info *info = &sg_relation_table[relation];
  term_t args = PL_new_term_refs((int)info->arity);

  for (unsigned c = 0; c < info->arity; c++) {
    sg_value value = sg_version_value(version, relation, row, c);

    if (!sg_unify_value(args + (int)c, info->column[c].type, value)) {
      return FALSE;
    }
  }
  return PL_cons_functor_v(
      t, PL_new_functor(PL_new_atom(info->name), info->arity), args);
}

/* v(S, V) */
static int
put_missing(term_t t, const sg_breach *breach)
{
  return PL_unify_term(t, PL_FUNCTOR_CHARS,
                       sg_relation_table[breach->missing].name, 2, PL_INT,
                       (int)breach->s, PL_INT, (int)breach->id);
}

/* ---- refusals ------------------------------------------------------------ */

/* model_error(What(One, Other)) */
static int
raise(const char *what, term_t one, term_t other)
{
  term_t error = PL_new_term_ref(), context = PL_new_term_ref();

  return PL_unify_term(error, PL_FUNCTOR_CHARS, "error", 2, PL_FUNCTOR_CHARS,
                       "model_error", 1, PL_FUNCTOR_CHARS, what, 2, PL_TERM,
                       one, PL_TERM, other, PL_TERM, context) &&
         PL_raise_exception(error);
}

/* A row refers to what is not there. */
static int
raise_not_whole(sg_world *world, const sg_breach *breach)
{
  const sg_version *version = sg_world_version(world);
  term_t row = PL_new_term_ref(), missing = PL_new_term_ref();
  int good = put_row(row, version, breach->relation, breach->row) &&
             put_missing(missing, breach);

  sg_version_drop(version);
  return good && raise("not_whole", row, missing);
}

/* A row is not retracted, since another one refers to it. */
static int
raise_referred(sg_world *world, sg_relation relation, sg_row row,
               const sg_breach *breach)
{
  const sg_version *version = sg_world_version(world);
  term_t fact = PL_new_term_ref(), by = PL_new_term_ref();
  int good = put_row(fact, version, relation, row) &&
             put_row(by, version, breach->relation, breach->row);

  sg_version_drop(version);
  return good && raise("referred", fact, by);
}

/* ---- the gate ------------------------------------------------------------ */

int
sg_make_whole_ex(sg_world *world, bool cascade)
{
  sg_breach breach;
  sg_status status = sg_world_make_whole(world, cascade, &breach);

  return status == SG_DANGLING ? raise_not_whole(world, &breach)
                               : sg_raise_status(status, SG_NONE, NULL);
}

sg_world *
sg_current_world_ex(void)
{
  sg_world *world = sg_edited_world_ex();
  int good;

  if (!world || sg_world_is_whole(world)) {
    return world;
  }
  if (!sg_claim_ex(world)) {
    return NULL;
  }
  good = sg_make_whole_ex(world, false);
  sg_world_release(world);
  return good ? world : NULL;
}

int
sg_retract_edit_ex(sg_world *world, sg_relation relation, sg_row row,
                   bool cascade)
{
  sg_breach breach;
  sg_status status =
      sg_world_retract_edit(world, relation, row, cascade, &breach);

  return status == SG_NO_STEP    ? FALSE
         : status == SG_DANGLING ? raise_referred(world, relation, row, &breach)
                                 : sg_raise_status(status, SG_NONE, NULL);
}
