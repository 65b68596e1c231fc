/* change4pl.c -- adding facts, and rows by their number.
 *
 * Layer: glue. Doors in rules/store.pl.
 */
#include "edit4pl.h"
#include "value4pl.h"

#include "install.h"

#include <stdlib.h>

/* ---- adding ------------------------------------------------------------ */

/* `early`: in a transaction it may come before what it refers to. */
static int
add_row_ex(sg_world *world, sg_relation relation, const sg_value *row,
           bool early, sg_row *out, term_t fact)
{
  sg_fault fault;
  sg_status status;

  if (!sg_claim_ex(world)) {
    return FALSE;
  }
  status = sg_world_add(world, relation, row, out, &fault);
  if (status == SG_DANGLING && early && sg_world_depth(world) > 0) {
    status = sg_world_add_edit(world, relation, row, out, &fault);
  }
  sg_world_release(world);
  return status == SG_EXISTS ? PL_permission_error("assert", "fact", fact)
                             : sg_raise_status(status, relation, &fault);
}

static int
add_fact_ex(term_t fact, bool early, sg_row *out)
{
  sg_world *world = sg_edited_world_ex();
  sg_relation relation;
  const sg_relation_info *info;
  sg_value row[SG_MAX_COLUMNS];
  void *owned[SG_MAX_COLUMNS] = {0};
  term_t args;
  int done = TRUE;

  if (!world || !sg_get_fact_ex(fact, 0, &relation, &args)) {
    return FALSE;
  }
  info = &sg_relation_table[relation];
  for (unsigned c = 0; done && c < info->arity; c++) {
    done = sg_get_value_ex(args + c, info, c, &row[c], &owned[c]);
  }
  done = done && add_row_ex(world, relation, row, early, out, fact);
  for (unsigned c = 0; c < info->arity; c++) {
    free(owned[c]);
  }
  return done;
}

/* assert_fact(+Fact) is det. */
static foreign_t
assert_fact(term_t fact)
{
  sg_row row;

  return add_fact_ex(fact, true, &row);
}

/* assert_after(+Fact) is det. */
static foreign_t
assert_after(term_t fact)
{
  sg_row row;

  return add_fact_ex(fact, false, &row);
}

/* assert_fact(+Fact, -Row) is det. */
static foreign_t
assert_fact_row(term_t fact, term_t out)
{
  sg_row row;

  return add_fact_ex(fact, true, &row) && PL_unify_int64(out, row);
}

/* ---- rows by number ---------------------------------------------------- */

static int
get_row_ex(term_t name, term_t row_term, sg_relation *relation, sg_row *row)
{
  int64_t number;

  if (!sg_get_relation_ex(name, relation) ||
      !PL_get_int64_ex(row_term, &number)) {
    return FALSE;
  }
  if (number < 0 || number >= SG_NO_ROW) {
    return FALSE; /* no row has this number */
  }
  *row = (sg_row)number;
  return TRUE;
}

/* '$retract_row'(+Relation, +Row, +Cascade) is semidet. */
static foreign_t
retract_row(term_t name, term_t row_term, term_t cascade_term)
{
  sg_world *world = sg_edited_world_ex();
  sg_relation relation;
  sg_row row;
  int done, cascade;

  if (!world || !get_row_ex(name, row_term, &relation, &row) ||
      !PL_get_bool_ex(cascade_term, &cascade) || !sg_claim_ex(world)) {
    return FALSE;
  }
  done = sg_retract_edit_ex(world, relation, row, cascade);
  sg_world_release(world);
  return done;
}

/* ---- installing -------------------------------------------------------- */

static const PL_extension predicates[] = {
    {"assert_fact", 1, assert_fact, 0},
    {"assert_after", 1, assert_after, 0},
    {"assert_fact", 2, assert_fact_row, 0},
    {"$retract_row", 3, retract_row, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_change(void)
{
  PL_register_extensions_in_module("sg_store", predicates);
}
