/* crew.h -- several threads at one list of tasks.
 *
 * Layer: kernel. The caller is one of the crew: it does tasks too and asks the
 * poll between them, at least every 10 ms when it waits; the others know
 * neither the poll nor anything else outside. Which thread does a task must not
 * matter: tasks write to places of their own, so the result is the same for any
 * number of threads.
 *
 *   sg_crew *crew = sg_crew_open(0);
 *   if (!sg_crew_run(crew, blocks, do_block, &data, poll))
 *     ... stopped, and no task is running any more ...
 *   sg_crew_close(crew);
 */
#ifndef SG_CREW_H
#define SG_CREW_H

#include "engine/poll.h"

#include <stddef.h>

typedef struct sg_crew sg_crew;

/* `threads` with the caller's; 0: as many as this process has processors, at
 * most 16. They start when there is work for two. Null: no memory. One such
 * crew that was closed waits, its threads asleep, for the next one who opens
 * it. */
sg_crew *sg_crew_open(unsigned threads);
void sg_crew_close(sg_crew *crew);

/* How many work together; a null crew: one. */
unsigned sg_crew_threads(const sg_crew *crew);

typedef void sg_crew_task(void *data, size_t task);

/* Does tasks 0 .. tasks - 1, begun in this order. A null crew is the caller
 * alone. False: the poll said stop, and some were not done. Not to be called
 * from a task. */
bool sg_crew_run(sg_crew *crew, size_t tasks, sg_crew_task *task, void *data,
                 const sg_poll *poll);

/* For long tasks, to be asked every ms or so: true if they should end. On the
 * caller's thread it asks the poll. */
bool sg_crew_stopping(void);

#endif
