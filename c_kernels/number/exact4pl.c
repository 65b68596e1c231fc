/* exact4pl.c -- what exact decisions cost, as a predicate.
 *
 * Layer: glue. Doors in rules/kernel/world.pl.
 */
#include "engine/install.h"

#include "exact.h"

#include <SWI-Prolog.h>

/* exact_fallbacks(-Count) is det. */
static foreign_t
exact_fallbacks(term_t count)
{
  return PL_unify_uint64(count, sg_exact_fallbacks());
}

/* '$exact_fallbacks'(-Orient2d, -Orient3d, -Turn, -Side, -Along, -Compare) is
 * det: in the order of sg_exact_question. */
static foreign_t
exact_fallbacks_each(term_t counts, int arity, void *control)
{
  (void)control;
  for (int i = 0; i < arity; i++) {
    if (!PL_unify_uint64(counts + i,
                         sg_exact_fallbacks_of((sg_exact_question)i))) {
      return FALSE;
    }
  }
  return TRUE;
}

void
sg_install_exact(void)
{
  static const PL_extension doors[] = {
      {"exact_fallbacks", 1, (pl_function_t)exact_fallbacks, 0},
      {"$exact_fallbacks", SG_EXACT_QUESTIONS,
       (pl_function_t)exact_fallbacks_each, PL_FA_VARARGS},
      {NULL, 0, NULL, 0}};

  PL_register_extensions_in_module("sg_kernel_world", doors);
}
