/* thread_pool_test.c -- tasks are done once each, by whoever; thread pools that
 * wait for the next; who asks the cancellation; and what several threads may
 * ask at the same time. */
#include "number/exact.h"
#include "tests/check.h"
#include "thread_pool.h"

#include <limits.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { TASKS = 1000, POINTS = 64, ASKERS = 8 };

static void
count(void *data, size_t task)
{
  atomic_fetch_add(&((atomic_int *)data)[task], 1);
}

/* All tasks are done, each once. */
static bool
does_all(sg_pool *pool)
{
  atomic_int *done = calloc(TASKS, sizeof *done);
  bool all = done && sg_pool_run(pool, TASKS, count, done, NULL);

  for (size_t i = 0; i < TASKS && all; i++) {
    all = atomic_load(&done[i]) == 1;
  }
  free(done);
  return all;
}

static void
test_tasks(void)
{
  sg_pool *four = sg_pool_open(4), *any = sg_pool_open(0);

  CHECK("alone", does_all(NULL) && sg_pool_threads(NULL) == 1);
  CHECK("four", does_all(four) && does_all(four));
  CHECK("as many as there are", does_all(any) && sg_pool_threads(any) > 0);
  sg_pool_close(four);
  sg_pool_close(any);
}

static void
test_waiting(void)
{
  sg_pool *first = sg_pool_open(0);
  bool good = does_all(first);

  sg_pool_close(first);
  for (int i = 0; i < 100 && good; i++) {
    sg_pool *one = sg_pool_open(0), *other = sg_pool_open(0);

    good = one != other && does_all(one) && does_all(other);
    sg_pool_close(one);
    sg_pool_close(other);
  }
  CHECK("closed and opened again, two at a time", good);
}

/* A fork has the memory of the thread pool that waits, and none of its threads.
 */
static void
test_fork(void)
{
  sg_pool *before = sg_pool_open(0);
  int status = 1;

  CHECK("before", does_all(before));
  sg_pool_close(before);
  pid_t child = fork();
  if (child == 0) {
    sg_pool *pool = sg_pool_open(0);
    bool good = does_all(pool) && does_all(pool);

    sg_pool_close(pool);
    _exit(good ? 0 : 1);
  }
  CHECK("in a fork", waitpid(child, &status, 0) == child && status == 0);
}

/* ---- who asks the cancellation ---- */

typedef struct asked {
  pthread_t caller;
  atomic_int begun;   /* tasks */
  atomic_int strange; /* questions on another thread */
  atomic_int questions;
  int most;   /* of them, then it says stop */
  bool inner; /* what is asked has tasks of its own */
} asked;

static bool
say_stop(void *data)
{
  asked *a = data;
  atomic_int done[3] = {0};

  if (!pthread_equal(pthread_self(), a->caller)) {
    atomic_fetch_add(&a->strange, 1);
  }
  if (a->inner) {
    sg_pool_run(NULL, 3, count, done, NULL);
  }
  return atomic_fetch_add(&a->questions, 1) + 1 >= a->most;
}

/* False after ten seconds. */
static bool
in_time(time_t begin)
{
  return time(NULL) < begin + 10;
}

/* Ends when each of four threads has one. */
static void
meet(void *data, size_t task)
{
  asked *a = data;
  time_t begin = time(NULL);

  (void)task;
  atomic_fetch_add(&a->begun, 1);
  while (atomic_load(&a->begun) < 4 && in_time(begin)) {
    sg_pool_stopping();
  }
}

/* The caller's ends when there are two, the other one when it is to stop. */
static void
wait_for_stop(void *data, size_t task)
{
  asked *a = data;
  time_t begin = time(NULL);
  bool caller = pthread_equal(pthread_self(), a->caller);

  (void)task;
  atomic_fetch_add(&a->begun, 1);
  while (in_time(begin) &&
         (caller ? atomic_load(&a->begun) < 2 : !sg_pool_stopping())) {
  }
}

static void
work_until_stop(void *data, size_t task)
{
  time_t begin = time(NULL);

  (void)data;
  (void)task;
  while (in_time(begin) && !sg_pool_stopping()) {
  }
}

static void
begin(void *data, size_t task)
{
  (void)task;
  atomic_fetch_add(&((asked *)data)->begun, 1);
}

static void
test_cancel(void)
{
  sg_pool *four = sg_pool_open(4), *two = sg_pool_open(2);
  asked a = {.caller = pthread_self(), .most = INT_MAX};
  sg_cancel cancel = {say_stop, &a};

  CHECK("asked on the caller's thread only",
        sg_pool_run(four, 4, meet, &a, &cancel) && a.begun == 4 &&
            a.strange == 0 && a.questions > 0);
  for (int inner = 0; inner < 2; inner++) {
    a = (asked){.caller = pthread_self(), .most = 3, .inner = inner};
    CHECK("asked after each task",
          !sg_pool_run(NULL, TASKS, begin, &a, &cancel) && a.begun == 3);
  }
  time_t start = time(NULL);
  a = (asked){.caller = pthread_self(), .most = 3};
  CHECK("asked while others work",
        !sg_pool_run(two, 2, wait_for_stop, &a, &cancel) && a.strange == 0 &&
            in_time(start));
  a = (asked){.caller = pthread_self(), .most = 3};
  CHECK("asked within a task",
        !sg_pool_run(NULL, 1, work_until_stop, &a, &cancel) &&
            a.questions >= 3 && in_time(start));
  CHECK("no task, no stop", !sg_pool_stopping());
  sg_pool_close(four);
  sg_pool_close(two);
}

/* ---- points that several ask for ---- */

typedef struct asking {
  sg_point point[ASKERS][POINTS]; /* copies of the same */
  mpq_t *q[ASKERS][POINTS];
} asking;

static void
ask(void *data, size_t asker)
{
  asking *a = data;

  for (int i = 0; i < POINTS; i++) {
    a->q[asker][i] = sg_point_q(&a->point[asker][i]);
  }
}

static bool
make_points(asking *a)
{
  const double at[4][3] = {{0, 0, 0}, {3, 1, 0}, {1, 2, 0}, {2, -1, 0}};
  sg_point end[4];

  for (int i = 0; i < POINTS; i++) {
    for (int k = 0; k < 4; k++) {
      const double moved[3] = {at[k][0] + 0.1 * k, at[k][1] + 0.01 * i, 0};
      sg_point_set(&end[k], moved);
    }
    if (!sg_point_ll(&a->point[0][i], 2, &end[0], &end[1], &end[2], &end[3])) {
      return false;
    }
    for (int k = 1; k < ASKERS; k++) {
      sg_point_copy(&a->point[k][i], &a->point[0][i]);
    }
  }
  return true;
}

/* All see the same numbers, which round to the place of the point. */
static bool
agree(const asking *a, int i)
{
  bool same = true;

  for (int k = 0; k < ASKERS; k++) {
    same = same && a->q[k][i] && a->q[k][i] == a->q[0][i];
  }
  for (int c = 0; c < 2 && same; c++) {
    double error = mpq_get_d(a->q[0][i][c]) - a->point[0][i].p[c];
    same = error < 1e-15 && error > -1e-15;
  }
  return same;
}

static void
test_points(void)
{
  sg_pool *pool = sg_pool_open(4);
  size_t good = 0;

  for (int round = 0; round < 20; round++) {
    asking *a = calloc(1, sizeof *a);

    if (a && make_points(a) && sg_pool_run(pool, ASKERS, ask, a, NULL)) {
      for (int i = 0; i < POINTS; i++) {
        good += agree(a, i);
      }
    }
    for (int i = 0; a && i < ASKERS * POINTS; i++) {
      sg_point_clear(&a->point[i / POINTS][i % POINTS]);
    }
    free(a);
  }
  CHECK("rationals of shared points, asked by several", good == 20 * POINTS);
  sg_pool_close(pool);
}

int
main(void)
{
  test_tasks();
  test_waiting();
  test_fork();
  test_cancel();
  test_points();
  return check_report();
}
