/* expression_test.c -- Boolean expressions, of all sets of three segments. */
#include "solid/expression.h"
#include "tests/check.h"

#include <stdlib.h>

/* Adds an operation over leaves 1 .. n. */
static void
over(sg_expression *e, size_t parent, sg_operation operation, int32_t n)
{
  size_t at = sg_expression_add(e, parent, operation, 0);

  for (int32_t s = 1; s <= n; s++) {
    sg_expression_add(e, at, SG_LEAF, s);
  }
}

/* Whether it holds inside the segments of the bits of `set`. */
static bool
holds(sg_expression *e, unsigned set)
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

    over(&all, 0, SG_INTERSECTION, 3);
    over(&any, 0, SG_UNION, 3);
    over(&first, 0, SG_DIFFERENCE, 3);
    CHECK("sealed", sg_expression_seal(&all) && sg_expression_seal(&any) &&
                        sg_expression_seal(&first));
    CHECK("intersection", holds(&all, set) == (set == 7));
    CHECK("union", holds(&any, set) == (set != 0));
    CHECK("difference", holds(&first, set) == (set == 1));
    sg_expression_clear(&all);
    sg_expression_clear(&any);
    sg_expression_clear(&first);
  }
}

/* A leaf that comes twice: 1 or (2 less 1). */
static void
check_twice(void)
{
  sg_expression e = {0};
  size_t at;

  sg_expression_add(&e, 0, SG_UNION, 0);
  sg_expression_add(&e, 0, SG_LEAF, 1);
  at = sg_expression_add(&e, 0, SG_DIFFERENCE, 0);
  sg_expression_add(&e, at, SG_LEAF, 2);
  sg_expression_add(&e, at, SG_LEAF, 1);
  CHECK("sealed", sg_expression_seal(&e));
  for (unsigned set = 0; set < 8; set++) {
    CHECK("twice", holds(&e, set) == ((set & 3) != 0));
  }
  sg_expression_clear(&e);
}

/* (1 and 2) less (1 and 2 and 3). */
static void
check_nested(void)
{
  sg_expression e = {0};
  sg_expression_add(&e, 0, SG_DIFFERENCE, 0);

  over(&e, 0, SG_INTERSECTION, 2);
  over(&e, 0, SG_INTERSECTION, 3);
  CHECK("sealed", sg_expression_seal(&e));
  for (unsigned set = 0; set < 8; set++) {
    CHECK("nested", holds(&e, set) == (set == 3));
  }
  sg_expression_clear(&e);
}

static void
check_empty(void)
{
  sg_expression none = {0}, any = {0}, all = {0};

  over(&any, 0, SG_UNION, 0);
  over(&all, 0, SG_INTERSECTION, 0);
  CHECK("sealed", sg_expression_seal(&none) && sg_expression_seal(&any) &&
                      sg_expression_seal(&all));
  CHECK("no expression", !holds(&none, 7));
  CHECK("empty union", !holds(&any, 7));
  CHECK("empty intersection", holds(&all, 0));
  sg_expression_clear(&none);
  sg_expression_clear(&any);
  sg_expression_clear(&all);
}

int
main(void)
{
  check_flat();
  check_nested();
  check_twice();
  check_empty();
  return check_report();
}
