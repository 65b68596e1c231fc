/* expression.h -- Boolean expressions over segments.
 *
 * Layer: kernel. True or false of a point, from the segments that it is inside.
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

/* A node; its operands follow it, each with all that is below it. */
typedef struct sg_expression_node {
  sg_operation operation;
  int32_t s;   /* of a leaf */
  size_t next; /* the node after everything below this one */
} sg_expression_node;

typedef struct sg_expression {
  sg_expression_node *node; /* [n]; free(node) */
  size_t n, room;
} sg_expression;

/* Adds a node and returns its number; the caller sets its `next` when its
 * operands are there. SIZE_MAX: no memory. */
size_t sg_expression_add(sg_expression *e, sg_operation operation, int32_t s);

/* Whether it holds where just segments s[0 .. n - 1], ascending, are. */
bool sg_expression_holds(const sg_expression *e, const int32_t *s, size_t n);

#endif
