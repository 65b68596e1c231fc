/* signals.h -- signals that end the program: for the command line alone; a
 * host's signals are its own.
 *
 * Layer: engine, beside main.c. The handlers only say that there was a signal.
 * A thread hears that and tells Prolog's main thread, which ends what it does
 * at its next cancel; no handler of Prolog runs in the middle of anything.
 * Where the work does not end in time, or there is a second signal, the thread
 * removes the files that are under way and ends the process. A process that
 * holds a gigabyte or more is given no time: the system needs it to free the
 * memory.
 */
#ifndef SG_SIGNALS_H
#define SG_SIGNALS_H

#include <stdbool.h>

/* Notes which signals are ignored (as by nohup): they stay so. To be called
 * before Prolog starts. */
void sg_signals_note(void);

typedef enum sg_signals_of {
  SG_SIGNALS_OF_VERB, /* all end the program */
  SG_SIGNALS_OF_REPL, /* SIGINT ends what Prolog does, and the program goes on
                       */
  SG_SIGNALS_OF_BATCH /* the same; and it has folders and processes to remove,
                         which take as long as they take */
} sg_signals_of;

/* From now on signals end the program; `words`, which must live as long as the
 * process, is said where Prolog did not come to say it. */
bool sg_signals_start(const char *words, sg_signals_of of);

/* Prolog has done all: `status`, with the number of the signal that ended it,
 * if one did. If `said` is false, a signal came before Prolog could say that.
 * From now on a signal ends the process at once, as it would without a handler.
 */
int sg_signals_end(int status, bool said);

#endif
