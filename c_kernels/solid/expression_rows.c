/* expression_rows.c -- which components stay for an expression: the fused
 * kernel of boolean.pl, stays/3. A test holds the two together.
 */
#include "arrangement_rows.h"
#include "expression_node_rows.h"

/* ---- expressions ---- */

static size_t
add_node(void *to, size_t parent, sg_operation operation, int32_t of)
{
  return sg_expression_add(to, parent, operation, of);
}

static bool
read_expression(sg_call *call, const sg_expression_node_fact_list *nodes,
                sg_expression *out)
{
  const sg_expression_reader reader = {.argument = 2,
                                       .leaf = "segment",
                                       .leaves = INT32_MAX,
                                       .add = add_node,
                                       .to = out};

  return sg_expression_read(call, &reader, nodes) &&
         (sg_expression_seal(out) || sg_call_no_memory(call));
}

/* ---- senses ---- */

/* What is asked of all components. */
typedef struct asking {
  sg_expression expression;
  const sg_int_list *open; /* surfaces without an inside */
  sg_int_list in;          /* segments a point is inside */
} asking;

static bool
is_open(const asking *k, int32_t s)
{
  for (size_t i = 0; i < k->open->n; i++) {
    if (k->open->at[i] == s) {
      return true;
    }
  }
  return false;
}

/* There is room for all of its sides. */
static bool
is_inside(asking *k, const sg_component *c, bool above)
{
  k->in.n = 0;
  for (size_t i = 0; i < c->sides; i++) {
    const sg_side *side = &c->side[i];

    if ((above ? side->above : side->below) > 0) {
      k->in.at[k->in.n++] = side->s;
    }
  }
  return sg_expression_holds(&k->expression, k->in.at, k->in.n);
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

/* Room for the segments on one side of a component. */
static bool
make_room(sg_call *call, asking *k, size_t sides)
{
  k->in.n = 0;
  while (k->in.room < sides) {
    k->in.n = k->in.room;
    if (!sg_int_list_add(call, &k->in, 0)) {
      return false;
    }
  }
  return true;
}

static bool
list_senses(sg_call *call, const sg_pieces *p, asking *k,
            sg_component_sense_list *out)
{
  int64_t number = 0;

  for (size_t i = 0; i < p->n; i++) {
    size_t n = sg_arrangement_components(p->of[i].a, p->of[i].s);

    for (size_t c = 0; c < n; c++, number++) {
      sg_component one = sg_arrangement_component(p->of[i].a, p->of[i].s, c);

      if (sg_cancel_every(&call->cancel, (size_t)number) ||
          !make_room(call, k, one.sides)) {
        return false;
      }
      int sense = sense_of(k, &one);

      if (sense != 0 &&
          !sg_component_sense_list_add(
              call, out, (sg_component_sense){number, sense < 0})) {
        return false;
      }
    }
  }
  return true;
}

bool
sg_door_arrangement_senses(sg_call *call,
                           const sg_arrangement_piece_list *pieces,
                           const sg_expression_node_fact_list *expression,
                           const sg_int_list *open,
                           sg_component_sense_list *senses)
{
  sg_pieces p;
  asking k = {.open = open};
  bool good = sg_pieces_take(call, pieces, &p) &&
              read_expression(call, expression, &k.expression) &&
              list_senses(call, &p, &k, senses);

  sg_expression_clear(&k.expression);
  return good;
}
