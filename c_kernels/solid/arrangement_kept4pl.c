/* arrangement_kept4pl.c -- the pieces of leaves, kept with their world.
 *
 * Layer: glue. One term a world, which rules/solid/arrangement.pl understands:
 * it is what was kept last. The door is documented in rules/kernel/boolean.pl.
 */
#include "engine/install.h"
#include "engine/world4pl.h"

#include <pthread.h>
#include <stdlib.h>

/* What a world keeps: its note SG_NOTE_PIECES. */
typedef struct kept {
  pthread_mutex_t lock;
  record_t term; /* null: nothing yet */
} kept;

static void
close_kept(void *note)
{
  kept *k = note;

  if (k->term) {
    PL_erase(k->term);
  }
  pthread_mutex_destroy(&k->lock);
  free(k);
}

/* The world's; null: no memory. */
static kept *
kept_of(sg_world *world)
{
  return sg_world_add_note(world, SG_NOTE_PIECES, sizeof(kept), close_kept);
}

/* pieces_kept(-Kept) is semidet. */
static foreign_t
pieces_kept(term_t t)
{
  sg_world *world = sg_current_world_ex();
  kept *k = world ? kept_of(world) : NULL;
  term_t found = PL_new_term_ref();
  int good = FALSE;

  if (!k) {
    return world ? PL_resource_error("memory") : FALSE;
  }
  pthread_mutex_lock(&k->lock);
  good = k->term && PL_recorded(k->term, found);
  pthread_mutex_unlock(&k->lock);
  return good && PL_unify(t, found);
}

/* keep_pieces(+Kept) is det. */
static foreign_t
keep_pieces(term_t t)
{
  sg_world *world = sg_current_world_ex();
  kept *k = world ? kept_of(world) : NULL;
  record_t fresh = k ? PL_record(t) : NULL;
  record_t old;

  if (!k || !fresh) {
    return world ? PL_resource_error("memory") : FALSE;
  }
  pthread_mutex_lock(&k->lock);
  old = k->term;
  k->term = fresh;
  pthread_mutex_unlock(&k->lock);
  if (old) {
    PL_erase(old);
  }
  return TRUE;
}

static const PL_extension predicates[] = {
    {"pieces_kept", 1, pieces_kept, 0},
    {"keep_pieces", 1, keep_pieces, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_arrangement_kept(void)
{
  PL_register_extensions_in_module("sg_kernel_boolean", predicates);
}
