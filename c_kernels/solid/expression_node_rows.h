/* expression_node_rows.h -- expressions from rows: each operation before its
 * operands.
 *
 * Layer: rows.
 */
#ifndef SG_EXPRESSION_NODE_ROWS_H
#define SG_EXPRESSION_NODE_ROWS_H

#include "doors/boolean.h"
#include "expression.h"

typedef struct sg_expression_reader {
  int argument;     /* of the call: it is refused */
  const char *leaf; /* what a leaf that is refused should have been */
  int32_t leaves;   /* a leaf is 1 .. leaves */
  /* Adds a node below the node `parent`, 0 for the first, and returns its
   * number; SIZE_MAX: no memory. */
  size_t (*add)(void *to, size_t parent, sg_operation operation, int32_t of);
  void *to;
} sg_expression_reader;

/* False: refused. */
bool sg_expression_read(sg_call *call, const sg_expression_reader *reader,
                        const sg_expression_node_fact_list *nodes);

#endif
