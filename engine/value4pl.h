/* value4pl.h -- arguments of relations as values of columns.
 *
 * Layer: glue.
 */
#ifndef SG_VALUE4PL_H
#define SG_VALUE4PL_H

#include "world4pl.h"

/* What an argument of a call says about its column. */
typedef enum sg_bound {
  SG_OPEN,    /* nothing: a variable */
  SG_BOUND,   /* *out is the value */
  SG_PARTIAL, /* something: unification must tell */
  SG_NOWHERE  /* no row has it */
} sg_bound;

/* For asking: never raises. *owned, if set, is to be freed after *out. */
sg_bound sg_bound_value(term_t t, sg_type type, sg_value *out, void **owned);

/* For adding: raises what is wrong with argument t for column c. *owned, if
 * set, is to be freed in either case. */
int sg_get_value_ex(term_t t, const sg_relation_info *info, unsigned c,
                    sg_value *out, void **owned);

/* The relation of a fact, and references to its arguments with `last` after
 * them (0: nothing). A module qualifier is dropped. */
int sg_get_fact_ex(term_t t, term_t last, sg_relation *relation, term_t *args);

#endif
