/* expression4pl.c -- which components stay for an expression.
 *
 * Layer: glue. The fused kernel of boolean.pl, stays/3: a test holds the two
 * together. The door is documented in rules/kernel/boolean.pl.
 */
#include "arrangement4pl.h"

#include "expression.h"
#include "glue.h"

#include "engine/install.h"

#include <stdlib.h>

static functor_t functor_minus2;
static functor_t functor_of[SG_DIFFERENCE + 1];

/* ---- expressions ---- */

/* An operation of which operands are still to be read. Expressions may be
 * deeper than the stack of C. */
typedef struct level {
  term_t tail, head;
  size_t node;
} level;

typedef struct levels {
  level *item; /* [room]; terms of those above n are used again */
  size_t n, used, room;
} levels;

static int
push_ex(levels *all, term_t t, size_t node)
{
  if (all->n == all->room) {
    size_t room = 2 * all->room + 16;
    level *grown = realloc(all->item, room * sizeof *grown);

    if (!grown) {
      return sg_no_memory();
    }
    all->item = grown;
    all->room = room;
  }
  level *top = &all->item[all->n++];

  if (all->n > all->used) {
    top->tail = PL_new_term_ref();
    top->head = PL_new_term_ref();
    all->used = all->n;
  }
  top->node = node;
  return top->tail && top->head && PL_get_arg(1, t, top->tail);
}

/* Reads t: a leaf, or an operation, whose operands are to be read next. */
static int
get_node_ex(term_t t, size_t parent, sg_expression *out, levels *all)
{
  for (int i = SG_UNION; i <= SG_DIFFERENCE; i++) {
    if (PL_is_functor(t, functor_of[i])) {
      size_t at = sg_expression_add(out, parent, (sg_operation)i, 0);

      return at == SIZE_MAX ? sg_no_memory() : push_ex(all, t, at);
    }
  }
  int32_t s;

  return sg_get_id_ex(t, &s) &&
         (sg_expression_add(out, parent, SG_LEAF, s) != SIZE_MAX ||
          sg_no_memory());
}

static int
get_expression_ex(term_t t, sg_expression *out)
{
  levels all = {0};
  int good = get_node_ex(t, 0, out, &all);

  while (good && all.n > 0) {
    level *top = &all.item[all.n - 1];

    if (PL_get_list(top->tail, top->head, top->tail)) {
      good = get_node_ex(top->head, top->node, out, &all);
      continue;
    }
    const sg_expression_node *node = &out->node[top->node];

    good = PL_get_nil_ex(top->tail) &&
           (node->operation != SG_DIFFERENCE || node->operands > 0 ||
            PL_domain_error("operands", top->tail));
    all.n--;
  }
  free(all.item);
  return good;
}

/* ---- senses ---- */

/* What is asked of all components. */
typedef struct asking {
  sg_expression expression;
  int32_t *open; /* [opens]: surfaces without an inside */
  size_t opens;
  int32_t *in; /* segments a point is inside */
  size_t room;
} asking;

static bool
is_open(const asking *k, int32_t s)
{
  for (size_t i = 0; i < k->opens; i++) {
    if (k->open[i] == s) {
      return true;
    }
  }
  return false;
}

static bool
is_inside(asking *k, const sg_component *c, bool above)
{
  size_t n = 0;

  for (size_t i = 0; i < c->sides; i++) {
    const sg_side *side = &c->side[i];

    if ((above ? side->above : side->below) > 0) {
      k->in[n++] = side->s;
    }
  }
  return sg_expression_holds(&k->expression, k->in, n);
}

/* 1, -1, or 0: it goes. */
static int
sense_of(asking *k, const sg_component *c)
{
  if (c->unknown || c->second) {
    return 0;
  }
  bool below = is_inside(k, c, false), above = is_inside(k, c, true);

  return is_open(k, c->s) ? !below && !above : (int)below - (int)above;
}

static bool
room_for(asking *k, size_t sides)
{
  if (sides >= k->room) {
    int32_t *grown = realloc(k->in, 2 * (sides + 1) * sizeof *grown);

    if (!grown) {
      return false;
    }
    k->in = grown;
    k->room = 2 * (sides + 1);
  }
  return true;
}

enum { ASKED = 256 }; /* components between questions */

static int
unify_senses(term_t list, const sg_pieces *p, asking *k)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  int64_t number = 0;

  for (size_t i = 0; i < p->n; i++) {
    size_t n = sg_arrangement_components(p->of[i].a, p->of[i].s);

    for (size_t c = 0; c < n; c++, number++) {
      sg_component one = sg_arrangement_component(p->of[i].a, p->of[i].s, c);

      if (number % ASKED == ASKED - 1 && PL_handle_signals() < 0) {
        return FALSE;
      }
      if (!room_for(k, one.sides)) {
        return sg_no_memory();
      }
      int sense = sense_of(k, &one);

      if (sense != 0 && (!PL_unify_list(tail, head, tail) ||
                         !PL_unify_term(head, PL_FUNCTOR, functor_minus2,
                                        PL_INT64, number, PL_INT, sense))) {
        return FALSE;
      }
    }
  }
  return PL_unify_nil(tail);
}

/* arrangement_senses(+Pieces, +Expression, +Open, -Senses) is det. */
static foreign_t
arrangement_senses(term_t t, term_t expression, term_t open, term_t senses)
{
  sg_pieces p;
  asking k = {.opens = 0};
  int good =
      sg_get_pieces_ex(t, &p) && get_expression_ex(expression, &k.expression) &&
      (sg_expression_seal(&k.expression) || sg_no_memory()) &&
      sg_get_ids_ex(open, &k.open, &k.opens) && unify_senses(senses, &p, &k);

  sg_expression_clear(&k.expression);
  free(k.open);
  free(k.in);
  sg_pieces_clear(&p);
  return good;
}

static const PL_extension predicates[] = {
    {"arrangement_senses", 4, arrangement_senses, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_expression(void)
{
  functor_minus2 = PL_new_functor(PL_new_atom("-"), 2);
  functor_of[SG_UNION] = PL_new_functor(PL_new_atom("union"), 1);
  functor_of[SG_INTERSECTION] = PL_new_functor(PL_new_atom("intersection"), 1);
  functor_of[SG_DIFFERENCE] = PL_new_functor(PL_new_atom("difference"), 1);
  PL_register_extensions_in_module("sg_kernel_boolean", predicates);
}
