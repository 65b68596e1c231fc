/* unasked.c -- how long a program of ours works without asking whether it is to
 * stop.
 *
 * Loaded before all others (LD_PRELOAD). A kernel asks by PL_handle_signals();
 * Prolog asks by itself. A timer of the main thread's processor time looks
 * every 5 ms which of the two works, and how long since it was asked last: so
 * the load of the machine does not count. At the end the longest time, in
 * milliseconds, and where it was are written to the file UNASKED.
 */
#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

enum { FRAMES = 40, EVERY = 5000000 /* ns */ };

typedef struct range {
  uintptr_t begin, end;
} range;

static pid_t tid;
static double last, longest;
static void *where[FRAMES];
static int frames;
static range ours, prolog;

int PL_handle_signals(void);

static double
now(void)
{
  struct timespec t;

  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int
PL_handle_signals(void)
{
  static int (*real)(void);

  if (!real) {
    *(void **)&real = dlsym(RTLD_NEXT, "PL_handle_signals");
  }
  if (tid && (pid_t)syscall(SYS_gettid) == tid) {
    last = now();
  }
  return real();
}

static bool
is_in(const range *of, const void *at)
{
  return (uintptr_t)at >= of->begin && (uintptr_t)at < of->end;
}

static void
look(int signal)
{
  void *frame[FRAMES];
  int n = backtrace(frame, FRAMES), inmost = 0;
  double unasked = now() - last;

  (void)signal;
  while (inmost < n && !is_in(&ours, frame[inmost]) &&
         !is_in(&prolog, frame[inmost])) {
    inmost++;
  }
  if (inmost == n || is_in(&prolog, frame[inmost])) {
    last = now();
  } else if (unasked > longest) {
    longest = unasked;
    frames = n;
    memcpy(where, frame, sizeof where);
  }
}

static void
add_range(range *of, const char *line, const char *name)
{
  unsigned long begin, end;

  if (strstr(line, name) && sscanf(line, "%lx-%lx", &begin, &end) == 2) {
    of->begin = of->begin ? of->begin : begin;
    of->end = end;
  }
}

__attribute__((constructor)) static void
begin(void)
{
  FILE *maps = getenv("UNASKED") ? fopen("/proc/self/maps", "r") : NULL;
  struct sigaction action = {.sa_handler = look, .sa_flags = SA_RESTART};
  struct sigevent event = {.sigev_notify = SIGEV_THREAD_ID,
                           .sigev_signo = SIGRTMIN + 8};
  struct itimerspec every = {{0, EVERY}, {0, EVERY}};
  char line[4096], self[1024] = "";
  timer_t timer;

  if (!maps || readlink("/proc/self/exe", self, sizeof self - 1) < 0) {
    return;
  }
  while (fgets(line, sizeof line, maps)) {
    add_range(&ours, line, self);
    add_range(&prolog, line, "libswipl");
  }
  fclose(maps);
  backtrace(where, 1); /* it needs memory the first time */
  tid = getpid();
  last = now();
  event._sigev_un._tid = tid;
  sigaction(SIGRTMIN + 8, &action, NULL);
  if (timer_create(CLOCK_THREAD_CPUTIME_ID, &event, &timer) == 0) {
    timer_settime(timer, 0, &every, NULL);
  }
}

__attribute__((destructor)) static void
end(void)
{
  int file = tid && getpid() == tid
                 ? open(getenv("UNASKED"), O_WRONLY | O_CREAT | O_TRUNC, 0600)
                 : -1;

  if (file >= 0) {
    dprintf(file, "%.0f\n", 1e3 * longest);
    backtrace_symbols_fd(where, frames, file);
    close(file);
  }
}
