/* stop_later.h -- a cancellation that says stop at a question of its own.
 *
 *   int left = k;
 *   sg_cancel cancel = {stop_later, &left};
 *
 * Questions 0 .. k - 1 are let through, all others are not; `left` is below 0
 * once it has said stop.
 */
#ifndef SG_TEST_STOP_LATER_H
#define SG_TEST_STOP_LATER_H

#include <stdbool.h>

static inline bool
stop_later(void *data)
{
  int *left = data;

  return --*left < 0;
}

#endif
