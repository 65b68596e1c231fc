/* expression.c -- see expression.h. */
#include "expression.h"
#include "engine/list.h"
#include "engine/search.h"

#include <stdlib.h>

size_t
sg_expression_add(sg_expression *e, size_t parent, sg_operation operation,
                  int32_t s)
{
  if (!sg_list_grow(&e->node, e->n, &e->room, sizeof *e->node)) {
    return SIZE_MAX;
  }
  e->node[e->n] = (sg_expression_node){
      .operation = operation, .s = s, .parent = (uint32_t)parent};
  if (e->n > 0) {
    e->node[e->n].first = e->node[parent].operands++ == 0;
  }
  return e->n++;
}

void
sg_expression_clear(sg_expression *e)
{
  free(e->node);
  free(e->leaf);
  *e = (sg_expression){0};
}

/* ---- what holds ---- */

static bool
value_of(const sg_expression_node *node)
{
  switch (node->operation) {
  case SG_LEAF:
    return node->holds;
  case SG_UNION:
    return node->true_operands > 0;
  case SG_INTERSECTION:
    return node->true_operands == node->operands;
  case SG_DIFFERENCE:
    return node->first_holds && node->true_operands == 0;
  }
  return false;
}

/* An operand of a node has changed to `holds`. */
static void
see_operand(sg_expression_node *node, const sg_expression_node *operand)
{
  if (node->operation == SG_DIFFERENCE && operand->first) {
    node->first_holds = operand->holds;
  } else {
    node->true_operands += operand->holds ? 1U : UINT32_MAX;
  }
}

void
sg_expression_set(sg_expression *e, uint32_t at, bool holds)
{
  while (e->node[at].holds != holds) {
    sg_expression_node *node = &e->node[at];

    node->holds = holds;
    if (at == 0) {
      return;
    }
    see_operand(&e->node[node->parent], node);
    at = node->parent;
    holds = value_of(&e->node[at]);
  }
}

/* ---- leaves ---- */

SG_ORDER(compare_leaves, sg_expression_leaf, SG_BY(s) SG_BY(node));

bool
sg_expression_seal(sg_expression *e)
{
  e->leaf = malloc((e->n + 1) * sizeof *e->leaf);
  if (!e->leaf) {
    return false;
  }
  for (size_t i = e->n; i > 0; i--) { /* operands before what is above them */
    sg_expression_node *node = &e->node[i - 1];

    node->holds = value_of(node);
    if (i > 1 && node->holds) {
      see_operand(&e->node[node->parent], node);
    }
    if (node->operation == SG_LEAF) {
      e->leaf[e->leaves++] = (sg_expression_leaf){node->s, (uint32_t)(i - 1)};
    }
  }
  if (e->leaves > 1) {
    qsort(e->leaf, e->leaves, sizeof *e->leaf, compare_leaves);
  }
  return true;
}

/* All leaves of segment s are `holds` now. */
static void
set_segment(sg_expression *e, int32_t s, bool holds)
{
  size_t low = sg_first_id(e->leaf, e->leaves, sizeof *e->leaf, s);

  for (; low < e->leaves && e->leaf[low].s == s; low++) {
    sg_expression_set(e, e->leaf[low].node, holds);
  }
}

bool
sg_expression_holds(sg_expression *e, const int32_t *s, size_t n)
{
  for (size_t i = 0; i < n; i++) {
    set_segment(e, s[i], true);
  }
  bool holds = e->n > 0 && e->node[0].holds;

  for (size_t i = 0; i < n; i++) {
    set_segment(e, s[i], false);
  }
  return holds;
}
