/* expression.h -- Boolean expressions over segments.
 *
 * Layer: kernel. True or false of a point, from the segments that it is inside.
 * These are few and the leaves may be many: so what is asked goes up from them,
 * and an expression takes no longer the wider it is.
 */
#ifndef SG_EXPRESSION_H
#define SG_EXPRESSION_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum sg_operation {
  SG_LEAF,
  SG_UNION,
  SG_INTERSECTION,
  SG_DIFFERENCE /* the first without all the others */
} sg_operation;

typedef struct sg_expression_node {
  sg_operation operation;
  int32_t s;       /* of a leaf */
  uint32_t parent; /* the root is its own */
  bool first;      /* the first operand of its parent */
  bool holds;
  uint32_t operands;
  uint32_t true_operands; /* of a difference: but the first */
  bool first_holds;       /* the first operand of a difference */
} sg_expression_node;

typedef struct sg_expression_leaf {
  int32_t s;
  uint32_t node;
} sg_expression_leaf;

typedef struct sg_expression {
  sg_expression_node *node; /* [n]; the root is 0 */
  size_t n, room;
  sg_expression_leaf *leaf; /* [leaves], by segment; once sealed */
  size_t leaves;
} sg_expression;

/* Adds a node below `parent` (the first one: below itself) and returns its
 * number; SIZE_MAX: no memory. */
size_t sg_expression_add(sg_expression *e, size_t parent,
                         sg_operation operation, int32_t s);
/* When all nodes are there. False: no memory. */
bool sg_expression_seal(sg_expression *e);
void sg_expression_clear(sg_expression *e);

/* Node `at`, a leaf, is `holds` now, and so is what is above it. */
void sg_expression_set(sg_expression *e, uint32_t at, bool holds);

/* Whether it holds where just segments s[0 .. n - 1] are; each once. */
bool sg_expression_holds(sg_expression *e, const int32_t *s, size_t n);

#endif
