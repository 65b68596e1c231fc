#include "crew.h"

#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

enum { MOST_THREADS = 16, WAIT_NS = 5000000 };

/* One call of sg_crew_run(). */
typedef struct call {
  sg_crew_task *task;
  void *data;
  size_t tasks;
  atomic_size_t next;
  atomic_bool stop;
  const sg_poll *poll; /* the caller's only */
} call;

struct sg_crew {
  unsigned asked;            /* for so many threads */
  unsigned threads, started; /* `started` without the caller */
  pid_t process;             /* that they are of: a fork has none */
  pthread_t thread[MOST_THREADS];
  pthread_mutex_t lock;
  pthread_cond_t work, done;
  call call;
  bool busy;        /* with the call: threads may join in */
  uint64_t number;  /* of the call */
  unsigned working; /* threads at it, without the caller */
  bool closing;
};

/* What this thread works at, and whether it may ask the poll. */
static _Thread_local call *at_hand;
static _Thread_local bool is_caller;

static unsigned
processors(void)
{
  cpu_set_t set;
  int n = sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;

  return n < 1 ? 1 : n > MOST_THREADS ? MOST_THREADS : (unsigned)n;
}

/* The one that waits for the next. */
static _Atomic(sg_crew *) idle;

static sg_crew *
crew_new(unsigned threads)
{
  sg_crew *crew = calloc(1, sizeof *crew);
  pthread_condattr_t attributes;

  if (!crew) {
    return NULL;
  }
  crew->process = getpid();
  crew->asked = crew->threads = threads;
  pthread_mutex_init(&crew->lock, NULL);
  pthread_cond_init(&crew->work, NULL);
  pthread_condattr_init(&attributes);
  pthread_condattr_setclock(&attributes, CLOCK_MONOTONIC);
  pthread_cond_init(&crew->done, &attributes);
  pthread_condattr_destroy(&attributes);
  return crew;
}

static void
crew_end(sg_crew *crew)
{
  pthread_mutex_lock(&crew->lock);
  crew->closing = true;
  pthread_cond_broadcast(&crew->work);
  pthread_mutex_unlock(&crew->lock);
  for (unsigned i = 0; i < crew->started; i++) {
    pthread_join(crew->thread[i], NULL);
  }
  pthread_cond_destroy(&crew->work);
  pthread_cond_destroy(&crew->done);
  pthread_mutex_destroy(&crew->lock);
  free(crew);
}

/* The idle crew, if it has so many threads. Its threads are not in a process
 * that was forked: there it is forgotten. */
static sg_crew *
take_idle(unsigned threads)
{
  sg_crew *crew = atomic_exchange(&idle, NULL);

  if (!crew || crew->process != getpid()) {
    return NULL;
  }
  if (crew->asked != threads) {
    crew_end(crew);
    return NULL;
  }
  return crew;
}

/* When the process ends, or the library is unloaded. */
__attribute__((destructor)) static void
end_idle(void)
{
  sg_crew *crew = atomic_exchange(&idle, NULL);

  if (crew && crew->process == getpid()) {
    crew_end(crew);
  }
}

sg_crew *
sg_crew_open(unsigned threads)
{
  unsigned wanted = threads == 0 ? processors() : threads;

  if (wanted > MOST_THREADS) {
    wanted = MOST_THREADS;
  }
  sg_crew *crew = threads == 0 ? take_idle(wanted) : NULL;

  return crew ? crew : crew_new(wanted);
}

void
sg_crew_close(sg_crew *crew)
{
  sg_crew *none = NULL;

  if (crew && (crew->started == 0 || crew->asked != processors() ||
               !atomic_compare_exchange_strong(&idle, &none, crew))) {
    crew_end(crew);
  }
}

unsigned
sg_crew_threads(const sg_crew *crew)
{
  return crew ? crew->threads : 1;
}

/* Takes tasks until there are none or the call is stopped. What a poll runs may
 * have a crew of its own. */
static void
work_at(call *now)
{
  call *outer = at_hand;
  size_t task;

  at_hand = now;
  while (!atomic_load_explicit(&now->stop, memory_order_relaxed) &&
         (task = atomic_fetch_add(&now->next, 1)) < now->tasks) {
    now->task(now->data, task);
    if (is_caller && sg_poll_stop(now->poll)) {
      atomic_store(&now->stop, true);
    }
  }
  at_hand = outer;
}

static void *
work_on(void *data)
{
  sg_crew *crew = data;
  uint64_t seen = 0;

  pthread_mutex_lock(&crew->lock);
  while (!crew->closing) {
    if (!crew->busy || crew->number == seen) {
      pthread_cond_wait(&crew->work, &crew->lock);
      continue;
    }
    seen = crew->number;
    crew->working++;
    pthread_mutex_unlock(&crew->lock);
    work_at(&crew->call);
    pthread_mutex_lock(&crew->lock);
    if (--crew->working == 0) {
      pthread_cond_signal(&crew->done);
    }
  }
  pthread_mutex_unlock(&crew->lock);
  return NULL;
}

/* Signals are for the threads that were there before. Fewer threads than
 * wanted, or none, will do. */
static void
start_threads(sg_crew *crew)
{
  sigset_t all, old;

  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &old);
  while (crew->started + 1 < crew->threads &&
         pthread_create(&crew->thread[crew->started], NULL, work_on, crew) ==
             0) {
    crew->started++;
  }
  crew->threads = crew->started + 1;
  pthread_sigmask(SIG_SETMASK, &old, NULL);
}

/* Waits until no other thread works at the call, asking the poll. */
static void
wait_for_others(sg_crew *crew)
{
  call *now = &crew->call;

  pthread_mutex_lock(&crew->lock);
  crew->busy = false;
  while (crew->working > 0) {
    struct timespec until;

    clock_gettime(CLOCK_MONOTONIC, &until);
    until.tv_nsec += WAIT_NS;
    until.tv_sec += until.tv_nsec / 1000000000;
    until.tv_nsec %= 1000000000;
    pthread_cond_timedwait(&crew->done, &crew->lock, &until);
    if (crew->working > 0 && !atomic_load(&now->stop)) {
      pthread_mutex_unlock(&crew->lock);
      if (sg_poll_stop(now->poll)) {
        atomic_store(&now->stop, true);
      }
      pthread_mutex_lock(&crew->lock);
    }
  }
  pthread_mutex_unlock(&crew->lock);
}

bool
sg_crew_run(sg_crew *crew, size_t tasks, sg_crew_task *task, void *data,
            const sg_poll *poll)
{
  bool together = crew && crew->threads > 1 && tasks > 1;
  call alone = {0};
  call *now = together ? &crew->call : &alone;

  if (together && crew->started == 0) {
    start_threads(crew);
  }
  now->task = task;
  now->data = data;
  now->tasks = tasks;
  now->poll = poll;
  atomic_init(&now->next, 0);
  atomic_init(&now->stop, false);
  if (together) {
    pthread_mutex_lock(&crew->lock);
    crew->busy = true;
    crew->number++;
    pthread_cond_broadcast(&crew->work);
    pthread_mutex_unlock(&crew->lock);
  }
  is_caller = true;
  work_at(now);
  is_caller = at_hand != NULL;
  if (together) {
    wait_for_others(crew);
  }
  return !atomic_load(&now->stop);
}

bool
sg_crew_stopping(void)
{
  if (!at_hand) {
    return false;
  }
  if (is_caller && !atomic_load(&at_hand->stop) &&
      sg_poll_stop(at_hand->poll)) {
    atomic_store(&at_hand->stop, true);
  }
  return atomic_load_explicit(&at_hand->stop, memory_order_relaxed);
}
