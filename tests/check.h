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

static inline int
check_report(void)
{
  printf("%u passed, %u failed\n", check_passed, check_failed);
  return check_failed != 0;
}

#endif
