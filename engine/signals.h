/* signals.h -- signals that end the program: for the command line alone; a
 * host's signals are its own.
 *
 * Layer: engine, beside main.c. The handlers only say that there was a signal.
 * A thread hears that and tells Prolog's main thread, which ends what it does
 * at its next cancel; no handler of Prolog runs in the middle of anything.
 * Where the work does not end in time, the thread removes the files that are
 * under way and ends the process. A process that holds a gigabyte or more is
 * given no time: the system needs it to free the memory.
 */
#ifndef SG_SIGNALS_H
#define SG_SIGNALS_H

#include <stdbool.h>

/* Notes which signals are ignored (as by nohup): they stay so. To be called
 * before Prolog starts. */
void sg_signals_note(void);

/* From now on signals end the program; `words`, which must live as long as the
 * process, is said where Prolog did not come to say it. If `interrupts_goals`,
 * SIGINT ends what Prolog does, and the program goes on. */
bool sg_signals_start(const char *words, bool interrupts_goals);

/* Prolog has said what there is to say: `status` with the number of the signal
 * that ended it, if one did. */
int sg_signals_status(int status);

#endif
