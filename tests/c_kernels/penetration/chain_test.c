/* chain_test.c -- lines end to end: the order, ends, loops, branch points. */
#include "tests/check.h"

#include "penetration/chain.h"

#include <string.h>

/* Whether the chains of n lines have these steps, 0 after each chain. */
static bool
steps_are(const sg_chain_line *line, size_t n, const int32_t *wanted,
          const char *kinds)
{
  sg_chains chains;
  bool same = sg_chains_make(line, n, &chains) && chains.n == strlen(kinds);

  for (size_t i = 0; same && i < chains.n; i++) {
    const sg_chain *chain = &chains.item[i];

    same = chain->closed == (kinds[i] == 'c');
    for (size_t k = 0; same && k < chain->n; k++) {
      same = chains.step[chain->first + k] == *wanted++;
    }
    same = same && *wanted++ == 0;
  }
  sg_chains_clear(&chains);
  return same;
}

/* A line between vertices of one name. */
#define LINE(group, a, b)                                                      \
  {                                                                            \
    (group), {{(a), 0}},                                                       \
    {                                                                          \
      {                                                                        \
        (b), 0                                                                 \
      }                                                                        \
    }                                                                          \
  }

int
main(void)
{
  const sg_chain_line loop[] = {LINE(0, 7, 8), LINE(0, 9, 8), LINE(0, 7, 9)};
  const sg_chain_line run[] = {LINE(0, 2, 3), LINE(0, 2, 1), LINE(0, 4, 3)};
  const sg_chain_line fork[] = {LINE(0, 1, 2), LINE(0, 2, 3), LINE(0, 2, 4),
                                LINE(0, 5, 4)};
  const sg_chain_line lasso[] = {LINE(0, 1, 2), LINE(0, 2, 3), LINE(0, 3, 4),
                                 LINE(0, 4, 2)};
  const sg_chain_line two[] = {LINE(0, 1, 2), LINE(0, 2, 1), LINE(1, 1, 2)};
  const sg_chain_line gap[] = {LINE(0, 1, 2), {0, {{2, 3}}, {{4, 0}}}};
  const sg_chain_line dot[] = {LINE(0, 1, 1)};

  CHECK("nothing", steps_are(NULL, 0, NULL, ""));
  CHECK("a loop starts at its smallest line, in its direction",
        steps_are(loop, 3, (int32_t[]){1, -2, -3, 0}, "c"));
  CHECK("a run starts at the end whose line is smaller",
        steps_are(run, 3, (int32_t[]){-2, 1, -3, 0}, "o"));
  CHECK("branch points are ends",
        steps_are(fork, 4, (int32_t[]){1, 0, 2, 0, 3, -4, 0}, "ooo"));
  CHECK("a loop through a branch point is closed",
        steps_are(lasso, 4, (int32_t[]){1, 0, 2, 3, 4, 0}, "oc"));
  CHECK("groups do not mix",
        steps_are(two, 3, (int32_t[]){1, 2, 0, 3, 0}, "co"));
  CHECK("both names make a vertex",
        steps_are(gap, 2, (int32_t[]){1, 0, 2, 0}, "oo"));
  CHECK("a point", steps_are(dot, 1, (int32_t[]){1, 0}, "c"));
  return check_report();
}
