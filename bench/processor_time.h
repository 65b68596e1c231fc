/* processor_time.h -- for peers, before all else: their clock is the processor's
 * time of all threads, as other work may share the machine. */
#include <time.h>
#undef CLOCK_MONOTONIC
#define CLOCK_MONOTONIC CLOCK_PROCESS_CPUTIME_ID
