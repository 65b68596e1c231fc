/* exact4pl.c -- what exact decisions cost, as a predicate.
 *
 * Layer: glue. Doors in rules/kernel.pl.
 */
#include "../engine/install.h"

#include "exact.h"

#include <SWI-Prolog.h>

/* exact_fallbacks(-Count) is det. */
static foreign_t
exact_fallbacks(term_t count)
{
  return PL_unify_uint64(count, sg_exact_fallbacks());
}

void
sg_install_exact(void)
{
  static const PL_extension doors[] = {
      {"exact_fallbacks", 1, (pl_function_t)exact_fallbacks, 0},
      {NULL, 0, NULL, 0}};

  PL_register_extensions_in_module("sg_kernel", doors);
}
