/* gmp4pl.c -- the memory of Prolog's large numbers, when they grow.
 *
 * Layer: glue.
 *
 * Prolog keeps the numbers of one arithmetic expression in 8 kB of its stack,
 * as far as they fit. Since 9.2.3 a number that grows at the end of these may
 * be written one word past it ("stack smashing detected", or worse). So numbers
 * grow by Prolog's other two functions, which are right: there is a larger one,
 * and the old one goes.
 */
#include "install.h"

#include <gmp.h>
#include <string.h>

static void *(*give)(size_t);
static void (*take)(void *, size_t);

static void *
grow(void *old, size_t had, size_t wanted)
{
  void *new = give(wanted);

  if (new) {
    memcpy(new, old, had < wanted ? had : wanted);
    take(old, had);
  }
  return new;
}

void
sg_install_gmp(void)
{
  void *(*prolog)(void *, size_t, size_t);

  mp_get_memory_functions(&give, &prolog, &take);
  mp_set_memory_functions(give, grow, take);
}
