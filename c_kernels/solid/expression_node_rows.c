/* expression_node_rows.c -- see expression_node_rows.h. */
#include "expression_node_rows.h"

/* An operation of which operands are still to come. */
typedef struct level {
  size_t node, operands;
} level;

static bool
read_node(sg_call *call, const sg_expression_reader *reader,
          const sg_expression_node_fact *fact, level *top, size_t *levels)
{
  bool leaf = fact->operation == SG_LEAF;

  if (leaf ? fact->of < 1 || fact->of > reader->leaves
           : fact->of < (fact->operation == SG_DIFFERENCE ? 1 : 0)) {
    return sg_call_domain(call, leaf ? reader->leaf : "operands",
                          reader->argument);
  }
  size_t at = reader->add(reader->to, *levels > 0 ? top[*levels - 1].node : 0,
                          fact->operation, leaf ? fact->of : 0);
  if (at == SIZE_MAX) {
    return sg_call_no_memory(call);
  }
  if (*levels > 0) {
    top[*levels - 1].operands--;
  }
  if (!leaf) {
    top[(*levels)++] = (level){at, (size_t)fact->of};
  }
  while (*levels > 0 && top[*levels - 1].operands == 0) {
    --*levels;
  }
  return true;
}

bool
sg_expression_read(sg_call *call, const sg_expression_reader *reader,
                   const sg_expression_node_fact_list *nodes)
{
  level *top = sg_call_alloc(call, (nodes->n + 1) * sizeof *top);
  size_t levels = 0;

  for (size_t i = 0; top && i < nodes->n; i++) {
    if (i > 0 && levels == 0) {
      return sg_call_domain(call, "expression", reader->argument);
    }
    if (!read_node(call, reader, &nodes->at[i], top, &levels)) {
      return false;
    }
  }
  return top && ((nodes->n > 0 && levels == 0) ||
                 sg_call_domain(call, "expression", reader->argument));
}
