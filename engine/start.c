/* start.c -- starts Prolog with the saved rules, once a process. */
#include "start.h"

#include "install.h"

#include <SWI-Prolog.h>

extern const unsigned char sg_state[], sg_state_end[];

/* Glue makes atoms, so it is installed when Prolog has a heap and no rule is
 * loaded yet. */
static void
install_glue(int argc, char **argv)
{
  (void)argc;
  (void)argv;
  install_sanggwan();
}

bool
sg_start(int argc, char **argv)
{
  PL_initialise_hook(install_glue);
  return PL_set_resource_db_mem(sg_state, (size_t)(sg_state_end - sg_state)) &&
         PL_initialise(argc, argv);
}
