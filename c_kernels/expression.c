/* expression.c -- see expression.h. */
#include "expression.h"

#include <stdlib.h>

size_t
sg_expression_add(sg_expression *e, sg_operation operation, int32_t s)
{
  if (e->n == e->room) {
    size_t room = 2 * e->room + 16;
    sg_expression_node *grown = realloc(e->node, room * sizeof *grown);

    if (!grown) {
      return SIZE_MAX;
    }
    e->node = grown;
    e->room = room;
  }
  e->node[e->n] = (sg_expression_node){operation, s, e->n + 1};
  return e->n++;
}

static bool
is_there(const int32_t *s, size_t n, int32_t wanted)
{
  for (size_t i = 0; i < n && s[i] <= wanted; i++) {
    if (s[i] == wanted) {
      return true;
    }
  }
  return false;
}

static bool
holds(const sg_expression *e, size_t at, const int32_t *s, size_t n)
{
  const sg_expression_node *node = &e->node[at];
  /* What decides when an operand has it: one that holds in a union, one that
   * does not in an intersection; of a difference, the first is asked apart. */
  bool decides = node->operation != SG_INTERSECTION;
  size_t operand = at + 1;

  if (node->operation == SG_LEAF) {
    return is_there(s, n, node->s);
  }
  if (node->operation == SG_DIFFERENCE) {
    if (!holds(e, operand, s, n)) {
      return false;
    }
    operand = e->node[operand].next;
  }
  for (; operand < node->next; operand = e->node[operand].next) {
    if (holds(e, operand, s, n) == decides) {
      return node->operation == SG_UNION;
    }
  }
  return node->operation != SG_UNION;
}

bool
sg_expression_holds(const sg_expression *e, const int32_t *s, size_t n)
{
  return e->n > 0 && holds(e, 0, s, n);
}
