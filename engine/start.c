/* start.c -- starts Prolog with the saved rules, once a process. */
#include "start.h"

#include "install.h"

extern const unsigned char sg_state[], sg_state_end[];

bool
sg_start(int argc, char **argv)
{
  install_sanggwan();
  return PL_set_resource_db_mem(sg_state, (size_t)(sg_state_end - sg_state)) &&
         PL_initialise(argc, argv);
}
