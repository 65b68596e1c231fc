/* refuse.h -- memory that is refused to what is linked, where a test says so.
 *
 *   CHECK_DOOR("a quarter", sg_door_turn_points(&call, &axes, &origin) &&
 *                             is_at(SG_V, 2, 0, -1, 0));
 *
 * The linker puts the functions of refuse.c in the place of malloc() and the
 * others (Makefile); GMP and the system have theirs, and a checker of leaks
 * stays behind them. A test of doors has an sg_call `call`.
 *
 * In each C test what was not set yet, is free, or is behind the end of an
 * array is no zero and no index, so that who reads it is found out.
 */
#ifndef SG_REFUSE_H
#define SG_REFUSE_H

#include "call.h"
#include "tests/check.h"

#include <stdatomic.h>
#include <stdbool.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

/* Requests that will be had before one is refused; below 0: all. */
void refuse_after(long n);
/* Whether one has been since; from now on all are had. */
bool refuse_no_more(void);

/* How a process ends in which the door was asked. */
enum { REFUSE_SAID, REFUSE_NO_MORE, REFUSE_WRONG };

/* Begins a process in which request n is refused: true in there. */
static inline bool
refused_begin(sg_call *of, long n, pid_t *child)
{
  fflush(NULL);
  *child = fork();
  if (*child != 0) {
    return false;
  }
  of->pool = NULL; /* its threads are not here */
  refuse_after(n);
  return true;
}

/* Ends it: the door did without what was refused, or says that there is no
 * memory. */
static inline void
refused_end(const sg_call *of, bool done)
{
  bool refused = refuse_no_more();
  const sg_refusal *why = &of->refusal;
  bool said = done || why->how == SG_REFUSED_MEMORY ||
              (why->how == SG_REFUSED_ROW && why->status == SG_NO_MEMORY);

  _exit(!refused ? REFUSE_NO_MORE : said ? REFUSE_SAID : REFUSE_WRONG);
}

/* How it ended; a signal is wrong. */
static inline int
refused_how(pid_t child, long n)
{
  int status = 0;

  if (child < 0 || waitpid(child, &status, 0) != child) {
    return REFUSE_NO_MORE; /* there are no processes any more */
  }
  int how = WIFEXITED(status) ? WEXITSTATUS(status) : REFUSE_WRONG;

  if (how > REFUSE_NO_MORE) {
    fprintf(stderr, "request or question %ld: status %#x\n", n, status);
  }
  return how;
}

/* Questions that are answered with "go on" before the first "stop". */
static atomic_long refuse_stop_left;

static inline bool
refuse_stop(void *data)
{
  sg_call *of = data;

  of->stopped = of->stopped || atomic_fetch_sub(&refuse_stop_left, 1) <= 0;
  return of->stopped;
}

/* Begins a process in which question n is answered with "stop". */
static inline bool
stopped_begin(sg_call *of, long n, pid_t *child)
{
  fflush(NULL);
  *child = fork();
  if (*child != 0) {
    return false;
  }
  of->pool = NULL;
  of->cancel = (sg_cancel){refuse_stop, of};
  atomic_store(&refuse_stop_left, n);
  return true;
}

/* Ends it: the door has given no answer, and says that nothing was wrong. */
static inline void
stopped_end(const sg_call *of, bool done)
{
  bool said = !done && of->refusal.how == SG_REFUSED_NOTHING;

  _exit(!of->stopped ? REFUSE_NO_MORE : said ? REFUSE_SAID : REFUSE_WRONG);
}

/* The next request to be refused: of many some, fewer under valgrind. */
static inline long
refused_next(long n)
{
  return n + 1 + n / (getenv("RUN") ? 2 : 16);
}

/* A kernel has one request after the other refused in `expr`: true if it did
 * without or said that there is no memory, and keeps nothing that it took. */
#define CHECK_REFUSED(name, expr)                                              \
  do {                                                                         \
    bool said_ = true, refused_ = true;                                        \
    for (long n_ = 0; said_ && refused_; n_ = refused_next(n_)) {              \
      refuse_after(n_);                                                        \
      said_ = (expr);                                                          \
      refused_ = refuse_no_more();                                             \
    }                                                                          \
    CHECK(name ": without memory it says so", said_);                          \
  } while (0)

/* The door that is asked in `expr` has one request after the other refused, and
 * one question after the other whether to stop answered with yes, each in a
 * process of its own; then it is asked. */
#define CHECK_DOOR(name, expr)                                                 \
  do {                                                                         \
    int how_ = REFUSE_SAID;                                                    \
    for (long n_ = 0; how_ == REFUSE_SAID; n_ = refused_next(n_)) {            \
      pid_t child_;                                                            \
      if (refused_begin(&call, n_, &child_)) {                                 \
        refused_end(&call, (expr));                                            \
      }                                                                        \
      how_ = refused_how(child_, n_);                                          \
    }                                                                          \
    CHECK(name ": without memory it says so", how_ == REFUSE_NO_MORE);         \
    how_ = REFUSE_SAID;                                                        \
    for (long n_ = 0; how_ == REFUSE_SAID; n_ = refused_next(n_)) {            \
      pid_t child_;                                                            \
      if (stopped_begin(&call, n_, &child_)) {                                 \
        stopped_end(&call, (expr));                                            \
      }                                                                        \
      how_ = refused_how(child_, n_);                                          \
    }                                                                          \
    CHECK(name ": it stops when it is told to", how_ == REFUSE_NO_MORE);       \
    CHECK(name, expr);                                                         \
  } while (0)

#endif
