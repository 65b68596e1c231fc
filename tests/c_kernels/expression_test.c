/* expression_test.c -- Boolean expressions, of all sets of three segments. */
#include "../../c_kernels/expression.h"
#include "../check.h"

#include <stdlib.h>

/* Adds an operation over leaves 1 .. n. */
static size_t
over(sg_expression *e, sg_operation operation, int32_t n)
{
  size_t at = sg_expression_add(e, operation, 0);

  for (int32_t s = 1; s <= n; s++) {
    sg_expression_add(e, SG_LEAF, s);
  }
  e->node[at].next = e->n;
  return at;
}

/* Whether it holds inside the segments of the bits of `set`. */
static bool
holds(const sg_expression *e, unsigned set)
{
  int32_t in[3];
  size_t n = 0;

  for (int32_t s = 1; s <= 3; s++) {
    if (set >> (s - 1) & 1) {
      in[n++] = s;
    }
  }
  return sg_expression_holds(e, in, n);
}

static void
check_flat(void)
{
  for (unsigned set = 0; set < 8; set++) {
    sg_expression all = {0}, any = {0}, first = {0};

    over(&all, SG_INTERSECTION, 3);
    over(&any, SG_UNION, 3);
    over(&first, SG_DIFFERENCE, 3);
    CHECK("intersection", holds(&all, set) == (set == 7));
    CHECK("union", holds(&any, set) == (set != 0));
    CHECK("difference", holds(&first, set) == (set == 1));
    free(all.node);
    free(any.node);
    free(first.node);
  }
}

/* (1 and 2) less (1 and 2 and 3). */
static void
check_nested(void)
{
  sg_expression e = {0};
  size_t at = sg_expression_add(&e, SG_DIFFERENCE, 0);

  over(&e, SG_INTERSECTION, 2);
  over(&e, SG_INTERSECTION, 3);
  e.node[at].next = e.n;
  for (unsigned set = 0; set < 8; set++) {
    CHECK("nested", holds(&e, set) == (set == 3));
  }
  free(e.node);
}

static void
check_empty(void)
{
  sg_expression none = {0}, any = {0}, all = {0};

  over(&any, SG_UNION, 0);
  over(&all, SG_INTERSECTION, 0);
  CHECK("no expression", !holds(&none, 7));
  CHECK("empty union", !holds(&any, 7));
  CHECK("empty intersection", holds(&all, 0));
  free(any.node);
  free(all.node);
}

int
main(void)
{
  check_flat();
  check_nested();
  check_empty();
  return check_report();
}
