/* thread_pool.h -- several threads at one list of tasks.
 *
 * Layer: kernel. The caller is one of the thread pool: it does tasks too and
 * asks the cancel between them, at least every 10 ms when it waits; the others
 * know neither the cancellation nor anything else outside. Which thread does a
 * task must not matter: tasks write to places of their own, so the result is
 * the same for any number of threads.
 *
 *   sg_pool *thread pool = sg_pool_open(0);
 *   if (!sg_pool_run(thread pool, blocks, do_block, &data, cancel))
 *     ... stopped, and no task is running any more ...
 *   sg_pool_close(thread pool);
 */
#ifndef SG_THREAD_POOL_H
#define SG_THREAD_POOL_H

#include "engine/cancel.h"

#include <stddef.h>

typedef struct sg_pool sg_pool;

/* `threads` with the caller's; 0: as many as this process has processors, at
 * most 16. They start when there is work for two. Null: no memory. One such
 * thread pool that was closed waits, its threads asleep, for the next one who
 * opens it. */
sg_pool *sg_pool_open(unsigned threads);
void sg_pool_close(sg_pool *pool);

/* How many work together; a null thread pool: one. */
unsigned sg_pool_threads(const sg_pool *pool);

typedef void sg_pool_task(void *data, size_t task);

/* Does tasks 0 .. tasks - 1, begun in this order. A null thread pool is the
 * caller alone. False: the cancellation said stop, and some were not done. Not
 * to be called from a task. */
bool sg_pool_run(sg_pool *pool, size_t tasks, sg_pool_task *task, void *data,
                 const sg_cancel *cancel);

/* For long tasks, to be asked every ms or so: true if they should end. On the
 * caller's thread it asks the cancellation. */
bool sg_pool_stopping(void);

#endif
