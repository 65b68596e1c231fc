/* subterm4pl.c -- what stands anywhere in a term, in one pass (documented in
 * rules/kernel/file.pl).
 *
 * Layer: glue. A fact may have millions of elements, and goals of rules would
 * look at each for every question. A term is walked with a stack of its own,
 * so it may be as deep as there is memory; one that is in itself is refused.
 */
#include "install.h"
#include "list.h"
#include "world4pl.h"

#include <math.h>
#include <stdlib.h>

/* A compound, or what is left of a list, whose arguments are walked. Its
 * reference is the walk's `at`, plus its place on the stack. */
typedef struct level {
  size_t next, arity; /* of a list: 0 */
  bool open;          /* a list without an end, and so is its tail */
  bool tail;          /* one that is such a tail */
} level;

typedef enum verdict { GO_ON, FOUND, FAILED } verdict;

typedef struct walk {
  SG_LIST_OF(level) stack;
  SG_LIST_OF(term_t) at; /* references, one more than levels were ever there */
  size_t steps;
  size_t tails; /* of the levels */
  verdict (*look)(const struct walk *w, term_t t, int type);
  const void *data;
} walk;

static bool
is_compound(int type)
{
  return type == PL_TERM || type == PL_LIST_PAIR;
}

/* Whether the last argument taken is the tail of a list without an end. */
static bool
is_open_tail(const walk *w)
{
  const level *l = w->stack.n > 0 ? &w->stack.item[w->stack.n - 1] : NULL;

  return l && l->open && l->next > 2;
}

/* A level for the compound at the reference behind the last one. */
static bool
go_down(walk *w, term_t t, int type)
{
  level l = {.next = 1};
  atom_t name;

  l.tail = type == PL_LIST_PAIR && is_open_tail(w);
  l.open =
      type == PL_LIST_PAIR && (l.tail || PL_skip_list(t, 0, NULL) != PL_LIST);
  if ((type == PL_TERM || l.open) &&
      !PL_get_compound_name_arity(t, &name, &l.arity)) {
    return false;
  }
  if (w->at.n < w->stack.n + 2) {
    term_t fresh = PL_new_term_ref();

    if (!fresh || !SG_PUSH(w->at, fresh)) {
      return fresh && PL_resource_error("memory");
    }
  }
  w->tails += l.tail;
  return SG_PUSH(w->stack, l) || PL_resource_error("memory");
}

/* The next argument of the last level into the reference behind it. */
static bool
next_argument(walk *w, level *l)
{
  term_t own = w->at.item[w->stack.n - 1], to = w->at.item[w->stack.n];

  return l->arity == 0 ? PL_get_list(own, to, own)
                       : l->next <= l->arity && PL_get_arg(l->next++, own, to);
}

/* `look` is asked of each part, from the left; FAILED without an exception:
 * no part was FOUND, or `look` says so. */
static verdict
walk_term(walk *w, term_t t)
{
  verdict found = FAILED;
  term_t own = PL_copy_term_ref(t);
  bool good = own && (SG_PUSH(w->at, own) || PL_resource_error("memory"));
  int type = PL_term_type(t);

  if (good) {
    found = w->look(w, own, type);
    good = found != GO_ON || !is_compound(type) || go_down(w, own, type);
  }
  while (good && found == GO_ON && w->stack.n > 0) {
    level *l = &w->stack.item[w->stack.n - 1];

    if (++w->steps % 262144 == 0 && PL_handle_signals() < 0) {
      good = false;
    } else if (!next_argument(w, l)) {
      w->tails -= w->stack.item[--w->stack.n].tail;
    } else {
      own = w->at.item[w->stack.n];
      type = PL_term_type(own);
      found = w->look(w, own, type);
      good = found != GO_ON || !is_compound(type) || go_down(w, own, type);
    }
  }
  free(w->stack.item);
  free(w->at.item);
  return good ? found : FAILED;
}

static int
acyclic_ex(term_t t)
{
  return PL_is_acyclic(t) || PL_type_error("acyclic_term", t);
}

/* ---- has_part ----------------------------------------------------------- */

enum { MOST_PARTS = 64 };

typedef struct parts {
  size_t n;
  struct {
    atom_t name;
    bool atom;
    size_t arity;
  } of[MOST_PARTS];
} parts;

static verdict
look_for(const walk *w, term_t t, int type)
{
  const parts *p = w->data;
  atom_t name = 0;
  size_t arity = 0;
  bool atom = type == PL_ATOM;

  if (atom ? !PL_get_atom(t, &name)
           : type != PL_TERM || !PL_get_compound_name_arity(t, &name, &arity)) {
    return GO_ON;
  }
  for (size_t i = 0; i < p->n; i++) {
    if (p->of[i].name == name && p->of[i].atom == atom &&
        p->of[i].arity == arity) {
      return FOUND;
    }
  }
  return GO_ON;
}

static int
get_part_ex(term_t t, parts *p)
{
  term_t name = PL_new_term_ref(), arity = PL_new_term_ref();
  atom_t pair;
  size_t n;

  if (p->n == MOST_PARTS) {
    return PL_resource_error("parts");
  }
  p->of[p->n].atom = PL_get_atom(t, &p->of[p->n].name);
  if (!p->of[p->n].atom) {
    if (!PL_get_compound_name_arity(t, &pair, &n) || n != 2 ||
        !PL_get_arg(1, t, name) || !PL_get_arg(2, t, arity) ||
        !PL_get_atom(name, &p->of[p->n].name)) {
      return PL_type_error("part", t);
    }
    if (!PL_get_size_ex(arity, &p->of[p->n].arity)) {
      return FALSE;
    }
  }
  p->n++;
  return TRUE;
}

/* has_part(@Term, +Parts) is semidet. */
static foreign_t
has_part(term_t t, term_t wanted)
{
  parts p = {0};
  walk w = {.look = look_for, .data = &p};
  size_t n;
  atom_t name;
  term_t part = PL_new_term_ref();

  if (!PL_is_compound(t) && !PL_is_atom(t)) {
    return FALSE;
  }
  if (!PL_get_compound_name_arity(wanted, &name, &n)) {
    return PL_type_error("compound", wanted);
  }
  for (size_t i = 1; i <= n; i++) {
    if (!PL_get_arg(i, wanted, part) || !get_part_ex(part, &p)) {
      return FALSE;
    }
  }
  return acyclic_ex(t) && walk_term(&w, t) == FOUND;
}

/* ---- plain_value -------------------------------------------------------- */

static verdict
look_plain(const walk *w, term_t t, int type)
{
  const size_t *depth = w->data;
  double value;

  switch (type) {
  case PL_ATOM:
  case PL_NIL:
  case PL_INTEGER:
    return GO_ON;
  case PL_FLOAT:
    return PL_get_float(t, &value) && isfinite(value) ? GO_ON : FOUND;
  case PL_TERM:
  case PL_LIST_PAIR:
    return w->stack.n < *depth ? GO_ON : FOUND;
  default:
    return FOUND;
  }
}

/* plain_value(@Term, +Depth) is semidet. */
static foreign_t
plain_value(term_t t, term_t most)
{
  size_t depth;
  walk w = {.look = look_plain, .data = &depth};

  if (!PL_get_size_ex(most, &depth) || !acyclic_ex(t)) {
    return FALSE;
  }
  return walk_term(&w, t) != FOUND && !PL_exception(0);
}

/* ---- depth -------------------------------------------------------------- */

static verdict
look_deep(const walk *w, term_t t, int type)
{
  const size_t *depth = w->data;

  (void)t;
  return is_compound(type) && w->stack.n - w->tails >= *depth ? FOUND : GO_ON;
}

bool
sg_is_deeper(term_t t, size_t depth)
{
  walk w = {.look = look_deep, .data = &depth};

  return !PL_is_acyclic(t) || walk_term(&w, t) == FOUND || PL_exception(0);
}

/* ---- id_list ------------------------------------------------------------ */

/* id_list(@List, +Least) is semidet. */
static foreign_t
id_list(term_t list, term_t least)
{
  term_t rest = PL_copy_term_ref(list), item = PL_new_term_ref();
  int64_t id, from;

  if (!PL_get_int64_ex(least, &from) ||
      PL_skip_list(list, 0, NULL) != PL_LIST) {
    return FALSE;
  }
  for (size_t i = 1; PL_get_list(rest, item, rest); i++) {
    if (!PL_is_integer(item) || !PL_get_int64(item, &id) || id == 0 ||
        id < from || id > INT32_MAX ||
        (i % 262144 == 0 && PL_handle_signals() < 0)) {
      return FALSE;
    }
  }
  return TRUE;
}

static const PL_extension predicates[] = {
    {"has_part", 2, has_part, 0},
    {"plain_value", 2, plain_value, 0},
    {"id_list", 2, id_list, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_subterm(void)
{
  PL_register_extensions_in_module("sg_kernel_file", predicates);
}
