/* decision4pl.c -- which rule files decide in the current world.
 *
 * Layer: glue. Doors in rules/kernel/world.pl; the meaning is in
 * rules/decision.pl.
 *
 * A decision has a slot. A world that follows rule files keeps a table from
 * slots to the modules of their clauses; most worlds keep none. A table is
 * never changed: a new one takes its place in one step, and the old one stays
 * until the world ends, because another thread may be reading it.
 */
#include "edit4pl.h"

#include "install.h"

#include <SWI-Prolog.h>

#include <pthread.h>
#include <stdlib.h>

enum { SLOTS = 64 };

typedef struct rule_table rule_table;
struct rule_table {
  rule_table *older;
  uint64_t world; /* its number */
  uint64_t taken; /* bit = slot */
  atom_t module[SLOTS];
};

static rule_table *ended; /* the tables of ended worlds */
static pthread_mutex_t ended_lock = PTHREAD_MUTEX_INITIALIZER;

/* The world may end inside the atom garbage collector, where Prolog must not
 * be called: its tables wait for ended_world/1. */
static void
world_ended(void *note)
{
  rule_table *table = note, *last = table;

  while (last->older) {
    last = last->older;
  }
  pthread_mutex_lock(&ended_lock);
  last->older = ended;
  ended = table;
  pthread_mutex_unlock(&ended_lock);
}

static int
get_slot_ex(term_t t, size_t *out)
{
  return PL_get_size_ex(t, out) &&
         (*out < SLOTS || PL_domain_error("decision_slot", t));
}

/* rule_module(+Slot, -Module) is semidet. */
static foreign_t
rule_module(term_t slot_term, term_t module)
{
  const sg_world *world = sg_current_world();
  const rule_table *table = world ? sg_world_note(world, SG_NOTE_RULES) : NULL;
  size_t slot;

  return table && get_slot_ex(slot_term, &slot) && (table->taken >> slot & 1) &&
         PL_unify_atom(module, table->module[slot]);
}

/* The list [Slot-Module, ...] into a table. */
static int
fill_table_ex(term_t pairs, rule_table *table)
{
  term_t tail = PL_copy_term_ref(pairs), head = PL_new_term_ref();
  term_t part = PL_new_term_ref();

  while (PL_get_list_ex(tail, head, tail)) {
    size_t slot;
    atom_t module;

    if (!PL_is_functor(head, PL_new_functor(PL_new_atom("-"), 2))) {
      return PL_type_error("pair", head);
    }
    if (!PL_get_arg(1, head, part) || !get_slot_ex(part, &slot) ||
        !PL_get_arg(2, head, part) || !PL_get_atom_ex(part, &module)) {
      return FALSE;
    }
    table->taken |= UINT64_C(1) << slot;
    table->module[slot] = module;
  }
  return PL_get_nil_ex(tail);
}

static void
register_modules(const rule_table *table, int (*change)(atom_t))
{
  for (size_t slot = 0; slot < SLOTS; slot++) {
    if (table->taken >> slot & 1) {
      change(table->module[slot]);
    }
  }
}

static int
keep_atom(atom_t atom)
{
  PL_register_atom(atom);
  return TRUE;
}

static int
free_atom(atom_t atom)
{
  PL_unregister_atom(atom);
  return TRUE;
}

/* set_rule_modules(+Pairs) is det: all slots of the world in one step. */
static foreign_t
set_rule_modules(term_t pairs)
{
  sg_world *world = sg_edited_world_ex();
  rule_table *table;

  if (!world) {
    return FALSE;
  }
  if (!(table = calloc(1, sizeof *table))) {
    return PL_resource_error("memory");
  }
  table->world = sg_world_number(world);
  if (!fill_table_ex(pairs, table)) {
    free(table);
    return FALSE;
  }
  register_modules(table, keep_atom);
  table->older = sg_world_note(world, SG_NOTE_RULES);
  sg_world_set_note(world, SG_NOTE_RULES, table, world_ended);
  return TRUE;
}

/* world_number(-Number) is det. */
static foreign_t
world_number(term_t number)
{
  const sg_world *world = sg_edited_world_ex();

  return world && PL_unify_uint64(number, sg_world_number(world));
}

/* ended_world(-Number) is semidet: each table of each ended world once. */
static foreign_t
ended_world(term_t number)
{
  rule_table *table;
  uint64_t world;

  pthread_mutex_lock(&ended_lock);
  if ((table = ended)) {
    ended = table->older;
  }
  pthread_mutex_unlock(&ended_lock);
  if (!table) {
    return FALSE;
  }
  world = table->world;
  register_modules(table, free_atom);
  free(table);
  return PL_unify_uint64(number, world);
}

static const PL_extension predicates[] = {
    {"rule_module", 2, rule_module, 0},
    {"set_rule_modules", 1, set_rule_modules, 0},
    {"world_number", 1, world_number, 0},
    {"ended_world", 1, ended_world, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_decision(void)
{
  PL_register_extensions_in_module("sg_kernel_world", predicates);
}
