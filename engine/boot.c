/* boot.c -- Prolog with our glue in it, used once: to compile the rules and
 * write them as carried.S puts them into the program.
 *
 * Layer: engine.
 */
#include "install.h"

/* Glue makes atoms, so it is installed when Prolog has a heap and no rule is
 * loaded yet. */
static void
install_glue(int argc, char **argv)
{
  (void)argc;
  (void)argv;
  install_sanggwan();
}

int
main(int argc, char **argv)
{
  PL_initialise_hook(install_glue);
  if (!PL_initialise(argc, argv)) {
    PL_halt(1);
  }
  PL_halt(PL_toplevel() ? 0 : 1);
}
