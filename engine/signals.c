#include "signals.h"

#include "atomic_file.h"

#include <SWI-Prolog.h>

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>
#include <sys/poll.h>
#include <sys/resource.h>
#include <unistd.h>

/* How long the work may take to end, of the 0.2 s that are promised; less, as
 * the system takes its part of them to free the memory. */
enum { PATIENCE_MS = 120, FREE_GIGABYTE_MS = 120, GIGABYTE_KB = 1 << 20 };
enum { MAIN_THREAD = 1, AFTER_SIGNAL = 128 };

/* All that would end a process without a trace, but SIGKILL; SIGUSR2 is how
 * Prolog wakes a thread that waits. */
static const int endings[] = {
    SIGHUP,    SIGINT,    SIGQUIT, SIGTERM, SIGUSR1, SIGALRM,
    SIGVTALRM, SIGSTKFLT, SIGPROF, SIGXCPU, SIGIO,   SIGPWR,
};

enum { ENDINGS = sizeof(endings) / sizeof(*endings) };

static bool ignored[ENDINGS];
static int wake[2] = {-1, -1};
static const char *said;
static atomic_bool is_said;
static sg_signals_of signals_of;
static atomic_int received; /* what is to end the process */
static pthread_mutex_t raising = PTHREAD_MUTEX_INITIALIZER;
static bool over; /* Prolog is not to be told any more */

static bool
is_ignored(int signal)
{
  struct sigaction now;

  return sigaction(signal, NULL, &now) == 0 && now.sa_handler == SIG_IGN;
}

void
sg_signals_note(void)
{
  for (int i = 0; i < ENDINGS; i++) {
    ignored[i] = is_ignored(endings[i]);
  }
}

static void
heard(int signal)
{
  unsigned char number = (unsigned char)signal;
  int old = errno;

  if (write(wake[1], &number, 1) != 1) {
    /* The pipe is full of signals: enough of them. */
  }
  errno = old;
}

/* Ends the process; what was under way vanishes. */
static _Noreturn void
end_now(int signal)
{
  sg_atomic_end();
  if (!atomic_load(&is_said) && write(2, said, strlen(said)) < 0) {
    /* Nobody listens. */
  }
  _exit(AFTER_SIGNAL + signal);
}

/* Prolog wakes its thread by SIGUSR2, for which it has no handler at its end.
 */
static void
tell_prolog(int signal)
{
  pthread_mutex_lock(&raising);
  if (!over) {
    PL_thread_raise(MAIN_THREAD, signal == SIGINT ? SIGINT : SIGTERM);
  }
  pthread_mutex_unlock(&raising);
}

/* Milliseconds; below 0: no end. */
static int
patience(void)
{
  struct rusage used;
  long ms = PATIENCE_MS;

  if (signals_of == SG_SIGNALS_OF_BATCH) {
    return -1;
  }
  if (getrusage(RUSAGE_SELF, &used) == 0) {
    ms -= used.ru_maxrss * FREE_GIGABYTE_MS / GIGABYTE_KB;
  }
  return ms > 0 ? (int)ms : 0;
}

static void *
listen(void *data)
{
  struct pollfd waiting = {wake[0], POLLIN, 0};
  unsigned char number;
  int last = 0;

  (void)data;
  for (;;) {
    int n = poll(&waiting, 1, last ? patience() : -1);
    if (n == 0) {
      end_now(last);
    }
    if (n < 0 || read(wake[0], &number, 1) != 1) {
      continue;
    }
    if (number != SIGINT || signals_of == SG_SIGNALS_OF_VERB) {
      if (last) {
        end_now(last); /* asked twice */
      }
      last = number;
      atomic_store(&received, last);
    }
    tell_prolog(number);
  }
}

static bool
start_thread(void)
{
  sigset_t all, old;
  pthread_t thread;
  bool started;

  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &old);
  started = pthread_create(&thread, NULL, listen, NULL) == 0;
  pthread_sigmask(SIG_SETMASK, &old, NULL);
  return started && pthread_detach(thread) == 0;
}

bool
sg_signals_start(const char *words, sg_signals_of of)
{
  struct sigaction action = {0};

  said = words;
  signals_of = of;
  if (pipe2(wake, O_CLOEXEC | O_NONBLOCK) != 0 || !start_thread()) {
    return false;
  }
  sigemptyset(&action.sa_mask);
  for (int i = 0; i < ENDINGS; i++) {
    action.sa_handler = ignored[i] ? SIG_IGN : heard;
    sigaction(endings[i], &action, NULL);
  }
  action.sa_handler = SIG_IGN; /* a file too large is an error of writing */
  sigaction(SIGXFSZ, &action, NULL);
  return true;
}

/* What is raised later is not heard; what was is forgotten. */
static void
stop_listening(void)
{
  struct sigaction action = {.sa_handler = SIG_DFL};

  pthread_mutex_lock(&raising);
  over = true;
  pthread_mutex_unlock(&raising);
  sigemptyset(&action.sa_mask);
  for (int i = 0; i < ENDINGS; i++) {
    if (!ignored[i]) {
      sigaction(endings[i], &action, NULL);
    }
  }
  PL_handle_signals();
  PL_clear_exception();
}

int
sg_signals_end(int status, bool is_all_said)
{
  stop_listening();

  int signal = atomic_load(&received);
  if (!is_all_said && signal) {
    fputs(said, stderr);
    status = AFTER_SIGNAL + SIGTERM;
  }
  atomic_store(&is_said, true);
  return signal && status == AFTER_SIGNAL + SIGTERM ? AFTER_SIGNAL + signal
                                                    : status;
}
