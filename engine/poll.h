/* poll.h -- how a long kernel asks whether it should stop.
 *
 * Layer: store, and kernels. The glue passes PL_handle_signals() in here;
 * kernels never know Prolog. Ask every 10 ms at most, on the calling thread
 * only.
 */
#ifndef SG_POLL_H
#define SG_POLL_H

#include <stdbool.h>
#include <stddef.h>

typedef struct sg_poll {
  bool (*ask)(void *data); /* true: stop, free everything and return */
  void *data;
} sg_poll;

/* True if the work should stop. A null `poll` never stops anything. */
static inline bool
sg_poll_stop(const sg_poll *poll)
{
  return poll && poll->ask(poll->data);
}

/* The same in step i of a loop of many short steps: now and then. */
static inline bool
sg_poll_every(const sg_poll *poll, size_t i)
{
  return i % 4096 == 0 && sg_poll_stop(poll);
}

#endif
