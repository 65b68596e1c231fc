/* host.h -- what engine.c and question.c share; sanggwan.h is public, this not.
 *
 * Layer: engine. Nothing here leaves a Prolog exception pending.
 */
#ifndef SG_HOST_H
#define SG_HOST_H

#include "sanggwan.h"

#include <SWI-Prolog.h>

struct sanggwan_world {
  atom_t handle;
  char *message, *warnings; /* by PL_malloc(), or null: "" */
  sanggwan_query *queries;  /* those open, a list */
};

/* Sets the message of calls without a world; returns status. */
sanggwan_status sg_host_refuse(sanggwan_status status, const char *why);
/* Sets the world's message, and no warnings; returns status. */
sanggwan_status sg_host_complain(sanggwan_world *world, sanggwan_status status,
                                 const char *why);

/* Null: this thread may call Prolog; otherwise why not. */
const char *sg_host_obstacle(void);
/* Opens a frame for a call with this world, 0: not possible, *status says. */
fid_t sg_host_enter(sanggwan_world *world, sanggwan_status *status);
/* Calls embedded(World, What, Status, Text, Warnings). What keeps its bindings;
 * the caller has a frame open. */
sanggwan_status sg_host_ask(sanggwan_world *world, term_t what);

/* PL_get_nchars() with these flags, UTF-8, by PL_malloc(): without the scratch
 * buffers that Prolog would keep until the outermost C function returns. */
bool sg_host_text(term_t t, unsigned flags, char **out);
/* The text of an atom or string into *to, by PL_malloc(); null: no memory. What
 * was there is freed. */
void sg_host_take_text(term_t t, char **to);

#endif
