/* poll.h -- how a long kernel asks whether it should stop.
 *
 * Layer: kernel. The glue passes PL_handle_signals() in here; kernels never
 * know Prolog. Ask every 10 ms at most, on the calling thread only.
 */
#ifndef SG_POLL_H
#define SG_POLL_H

#include <stdbool.h>

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

#endif
