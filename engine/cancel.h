/* cancel.h -- how a long kernel asks whether it should stop.
 *
 * Layer: store, and kernels. The glue passes PL_handle_signals() in here;
 * kernels never know Prolog. Ask every 10 ms at most, on the calling thread
 * only.
 */
#ifndef SG_CANCEL_H
#define SG_CANCEL_H

#include <stdbool.h>
#include <stddef.h>

typedef struct sg_cancel {
  bool (*ask)(void *data); /* true: stop, free everything and return */
  void *data;
} sg_cancel;

/* True if the work should stop. A null `cancel` never stops anything. */
static inline bool
sg_cancelled(const sg_cancel *cancel)
{
  return cancel && cancel->ask(cancel->data);
}

/* The same in step i of a loop of many short steps: now and then. */
static inline bool
sg_cancel_every(const sg_cancel *cancel, size_t i)
{
  return i % 4096 == 0 && sg_cancelled(cancel);
}

#endif
