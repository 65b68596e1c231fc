/* check.h -- the harness of the C tests.
 *
 *   int main(void)
 *   {
 *     CHECK("the empty world has no rows", sg_version_count(v, SG_V) == 0);
 *     return check_report();
 *   }
 *
 * A check that holds is silent. One that does not prints where and what; the
 * last line counts both, for tests/run, and the status is 1 if any failed.
 */
#ifndef SG_CHECK_H
#define SG_CHECK_H

#include <stdint.h>
#include <stdio.h>

static unsigned check_passed, check_failed;

#define CHECK(name, expr)                                                      \
  check_note((name), !!(expr), #expr, __FILE__, __LINE__)

static inline int
check_note(const char *name, int holds, const char *expr, const char *file,
           int line)
{
  if (holds) {
    check_passed++;
  } else {
    check_failed++;
    fprintf(stderr, "%s:%d: %s: does not hold: %s\n", file, line, name, expr);
  }
  return holds;
}

/* A random number below n. The same seeds give the same numbers everywhere. */
static inline int
check_below(uint32_t *seed, int n)
{
  *seed = *seed * 1664525u + 1013904223u;
  return (int)((*seed >> 16) % (uint32_t)n);
}

static inline int
check_report(void)
{
  printf("%u passed, %u failed\n", check_passed, check_failed);
  return check_failed != 0;
}

#endif
