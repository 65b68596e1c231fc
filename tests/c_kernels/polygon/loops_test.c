/* loops_test.c -- loops of edge sets, and pairs of opposite edges. */
#include "tests/check.h"

#include "polygon/loops.h"
#include "rows/edge_pairs.h"

static sg_loops loops;

/* The number of loops, or -1 - (the number of open ends). */
static int
joined(size_t n, const int32_t *from, const int32_t *to)
{
  if (!sg_loops_make(&loops, n, from, to)) {
    return -1000;
  }
  return loops.open ? -1 - (int)loops.open : (int)loops.loops;
}

static void
test_loops(void)
{
  CHECK("none", joined(0, NULL, NULL) == 0);
  CHECK("in order",
        joined(3, (int32_t[]){1, 2, 3}, (int32_t[]){2, 3, 1}) == 1 &&
            loops.next[2] == 0);
  CHECK("in any order",
        joined(4, (int32_t[]){3, 1, 4, 2}, (int32_t[]){4, 2, 1, 3}) == 1 &&
            loops.next[0] == 2);
  CHECK("two loops, mixed", joined(6, (int32_t[]){1, 5, 2, 6, 3, 7},
                                   (int32_t[]){2, 6, 3, 7, 1, 5}) == 2);
  CHECK("a seam to an island",
        joined(8, (int32_t[]){1, 2, 3, 1, 4, 5, 6, 4},
               (int32_t[]){2, 3, 1, 4, 5, 6, 4, 1}) >= 1);
  CHECK("open", joined(2, (int32_t[]){1, 2}, (int32_t[]){2, 3}) == -2);
  CHECK("open beside a loop",
        joined(4, (int32_t[]){7, 1, 2, 3}, (int32_t[]){8, 2, 3, 1}) == -2 &&
            loops.loops == 1);
  sg_loops_clear(&loops);
}

static void
test_pairs(void)
{
  const int32_t from[] = {0, 1, 0, 2, 1}, to[] = {1, 0, 2, 0, 2};
  sg_edge_pairs pairs;
  sg_edge_group group = {0};
  bool stopped;

  CHECK("made", sg_edge_pairs_make(5, from, to, 3, NULL, &pairs, &stopped));
  CHECK("first", sg_edge_group_next(&pairs, &group) && group.low == 0 &&
                     group.high == 1 && group.forward == 1 && group.end == 2 &&
                     sg_edge_group_edge(&pairs, 1) == 1);
  CHECK("second", sg_edge_group_next(&pairs, &group) && group.high == 2);
  CHECK("third", sg_edge_group_next(&pairs, &group) && group.low == 1 &&
                     group.end - group.begin == 1);
  CHECK("no more", !sg_edge_group_next(&pairs, &group));
  CHECK("a border", !sg_edge_pairs_closed(&pairs));
  sg_edge_pairs_clear(&pairs);
  CHECK("closed", sg_edge_pairs_make(4, from, to, 3, NULL, &pairs, &stopped) &&
                      sg_edge_pairs_closed(&pairs));
  sg_edge_pairs_clear(&pairs);
}

int
main(void)
{
  test_loops();
  test_pairs();
  return check_report();
}
