#include "thread_pool.h"

#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

enum { MOST_THREADS = 16, WAIT_NS = 5000000 };

/* One call of sg_pool_run(). */
typedef struct call {
  sg_pool_task *task;
  void *data;
  size_t tasks;
  atomic_size_t next;
  atomic_bool stop;
  const sg_cancel *cancel; /* the caller's only */
} call;

struct sg_pool {
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

/* What this thread works at, and whether it may ask the cancellation. */
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
static _Atomic(sg_pool *) idle;

static sg_pool *
pool_new(unsigned threads)
{
  sg_pool *pool = calloc(1, sizeof *pool);
  pthread_condattr_t attributes;

  if (!pool) {
    return NULL;
  }
  pool->process = getpid();
  pool->asked = pool->threads = threads;
  pthread_mutex_init(&pool->lock, NULL);
  pthread_cond_init(&pool->work, NULL);
  pthread_condattr_init(&attributes);
  pthread_condattr_setclock(&attributes, CLOCK_MONOTONIC);
  pthread_cond_init(&pool->done, &attributes);
  pthread_condattr_destroy(&attributes);
  return pool;
}

static void
pool_end(sg_pool *pool)
{
  pthread_mutex_lock(&pool->lock);
  pool->closing = true;
  pthread_cond_broadcast(&pool->work);
  pthread_mutex_unlock(&pool->lock);
  for (unsigned i = 0; i < pool->started; i++) {
    pthread_join(pool->thread[i], NULL);
  }
  pthread_cond_destroy(&pool->work);
  pthread_cond_destroy(&pool->done);
  pthread_mutex_destroy(&pool->lock);
  free(pool);
}

/* The idle thread pool, if it has so many threads. Its threads are not in a
 * process that was forked: there it is forgotten. */
static sg_pool *
take_idle(unsigned threads)
{
  sg_pool *pool = atomic_exchange(&idle, NULL);

  if (!pool || pool->process != getpid()) {
    return NULL;
  }
  if (pool->asked != threads) {
    pool_end(pool);
    return NULL;
  }
  return pool;
}

/* When the process ends, or the library is unloaded. */
__attribute__((destructor)) static void
end_idle(void)
{
  sg_pool *pool = atomic_exchange(&idle, NULL);

  if (pool && pool->process == getpid()) {
    pool_end(pool);
  }
}

sg_pool *
sg_pool_open(unsigned threads)
{
  unsigned wanted = threads == 0 ? processors() : threads;

  if (wanted > MOST_THREADS) {
    wanted = MOST_THREADS;
  }
  sg_pool *pool = threads == 0 ? take_idle(wanted) : NULL;

  return pool ? pool : pool_new(wanted);
}

void
sg_pool_close(sg_pool *pool)
{
  sg_pool *none = NULL;

  if (pool && (pool->started == 0 || pool->asked != processors() ||
               !atomic_compare_exchange_strong(&idle, &none, pool))) {
    pool_end(pool);
  }
}

unsigned
sg_pool_threads(const sg_pool *pool)
{
  return pool ? pool->threads : 1;
}

/* Takes tasks until there are none or the call is stopped. What a cancellation
 * runs may have a thread pool of its own. */
static void
work_at(call *now)
{
  call *outer = at_hand;
  size_t task;

  at_hand = now;
  while (!atomic_load_explicit(&now->stop, memory_order_relaxed) &&
         (task = atomic_fetch_add(&now->next, 1)) < now->tasks) {
    now->task(now->data, task);
    if (is_caller && sg_cancelled(now->cancel)) {
      atomic_store(&now->stop, true);
    }
  }
  at_hand = outer;
}

static void *
work_on(void *data)
{
  sg_pool *pool = data;
  uint64_t seen = 0;

  pthread_mutex_lock(&pool->lock);
  while (!pool->closing) {
    if (!pool->busy || pool->number == seen) {
      pthread_cond_wait(&pool->work, &pool->lock);
      continue;
    }
    seen = pool->number;
    pool->working++;
    pthread_mutex_unlock(&pool->lock);
    work_at(&pool->call);
    pthread_mutex_lock(&pool->lock);
    if (--pool->working == 0) {
      pthread_cond_signal(&pool->done);
    }
  }
  pthread_mutex_unlock(&pool->lock);
  return NULL;
}

/* Signals are for the threads that were there before. Fewer threads than
 * wanted, or none, will do. */
static void
start_threads(sg_pool *pool)
{
  sigset_t all, old;

  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &old);
  while (pool->started + 1 < pool->threads &&
         pthread_create(&pool->thread[pool->started], NULL, work_on, pool) ==
             0) {
    pool->started++;
  }
  pool->threads = pool->started + 1;
  pthread_sigmask(SIG_SETMASK, &old, NULL);
}

/* Waits until no other thread works at the call, asking the cancellation. */
static void
wait_for_others(sg_pool *pool)
{
  call *now = &pool->call;

  pthread_mutex_lock(&pool->lock);
  pool->busy = false;
  while (pool->working > 0) {
    struct timespec until;

    clock_gettime(CLOCK_MONOTONIC, &until);
    until.tv_nsec += WAIT_NS;
    until.tv_sec += until.tv_nsec / 1000000000;
    until.tv_nsec %= 1000000000;
    pthread_cond_timedwait(&pool->done, &pool->lock, &until);
    if (pool->working > 0 && !atomic_load(&now->stop)) {
      pthread_mutex_unlock(&pool->lock);
      if (sg_cancelled(now->cancel)) {
        atomic_store(&now->stop, true);
      }
      pthread_mutex_lock(&pool->lock);
    }
  }
  pthread_mutex_unlock(&pool->lock);
}

bool
sg_pool_run(sg_pool *pool, size_t tasks, sg_pool_task *task, void *data,
            const sg_cancel *cancel)
{
  bool together = pool && pool->threads > 1 && tasks > 1;
  call alone = {0};
  call *now = together ? &pool->call : &alone;

  if (together && pool->started == 0) {
    start_threads(pool);
  }
  now->task = task;
  now->data = data;
  now->tasks = tasks;
  now->cancel = cancel;
  atomic_init(&now->next, 0);
  atomic_init(&now->stop, false);
  if (together) {
    pthread_mutex_lock(&pool->lock);
    pool->busy = true;
    pool->number++;
    pthread_cond_broadcast(&pool->work);
    pthread_mutex_unlock(&pool->lock);
  }
  is_caller = true;
  work_at(now);
  is_caller = at_hand != NULL;
  if (together) {
    wait_for_others(pool);
  }
  return !atomic_load(&now->stop);
}

bool
sg_pool_stopping(void)
{
  if (!at_hand) {
    return false;
  }
  if (is_caller && !atomic_load(&at_hand->stop) &&
      sg_cancelled(at_hand->cancel)) {
    atomic_store(&at_hand->stop, true);
  }
  return atomic_load_explicit(&at_hand->stop, memory_order_relaxed);
}
