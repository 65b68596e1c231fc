/* boot.c -- Prolog with our glue in it, used once: to compile the rules and
 * save the state that state.S puts into the program.
 *
 * Layer: engine.
 */
#include "install.h"

int
main(int argc, char **argv)
{
  install_sanggwan();
  if (!PL_initialise(argc, argv)) {
    PL_halt(1);
  }
  PL_halt(PL_toplevel() ? 0 : 1);
}
