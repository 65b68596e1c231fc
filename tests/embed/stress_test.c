/* stress_test.c -- threads of a host attach, open, share, ask, cut, draw, close
 * and end, all at once, for STRESS_SECONDS (3). Each has the drawing that one
 * thread alone has. A crash leaves a core file where the system says
 * (/proc/sys/kernel/core_pattern); its place is printed first. */
#include "engine/sanggwan.h"
#include "tests/check.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

enum { THREADS = 6, LIVES = 3, MODELS = 3, NAME = 200 };

static const char *const model[MODELS] = {
    "facts/two_cubes.pl", "facts/figures/fig13.pl", "facts/pipe_tee.pl"};

static char folder[] = "/tmp/sanggwan_stress_XXXXXX";
static sanggwan_world *shared;
static atomic_uint faults, lives, drawings;

static void
must(bool holds, const char *what, const sanggwan_world *world)
{
  if (!holds) {
    atomic_fetch_add(&faults, 1);
    fprintf(stderr, "%s: %s\n", what, sanggwan_message(world));
  }
}

/* The file of a drawing: the reference of a model, or a thread's own. */
static void
name_drawing(char *name, const char *who, int number)
{
  snprintf(name, NAME, "%s/%s%d.svg", folder, who, number);
}

static char *
content(const char *name)
{
  FILE *file = fopen(name, "r");
  char *text = NULL;
  size_t n = 0;

  if (file && getdelim(&text, &n, '\0', file) < 0) {
    free(text);
    text = NULL;
  }
  if (file) {
    fclose(file);
  }
  return text;
}

static void
draw(sanggwan_world *world, int which, const char *file)
{
  must(sanggwan_load(world, model[which]) == SANGGWAN_DONE, "load", world);
  must(sanggwan_draw(world, file, "view(iso)") == SANGGWAN_DONE, "draw", world);
}

static void
draw_and_compare(sanggwan_world *world, int thread, int which)
{
  char file[NAME], reference[NAME];

  name_drawing(file, "own", thread);
  name_drawing(reference, "alone", which);
  draw(world, which, file);
  char *a = content(file), *b = content(reference);
  must(a && b && strcmp(a, b) == 0, "another drawing", world);
  free(a);
  free(b);
  atomic_fetch_add(&drawings, 1);
}

/* A question over a world that others change; some are left to close. */
static void
ask_shared(int life)
{
  sanggwan_world *world = sanggwan_share(shared);
  sanggwan_query *q =
      sanggwan_ask(world, "vertex_exact(1, V, X, Y, Z), B is 3**500*V");

  for (int i = 0; i < 5 + life; i++) {
    if (sanggwan_next(q) != SANGGWAN_DONE) {
      break;
    }
  }
  must(sanggwan_run(world, "facts_transaction(( fresh_id(segment, 0, S), "
                           "assert_fact(segment(S, solid, thread)), "
                           "retract_fact(segment(S, solid, thread)) ))") ==
           SANGGWAN_DONE,
       "change", world);
  if (life % 2) {
    sanggwan_query_close(q);
  }
  sanggwan_close(world);
}

static void *
live(void *data)
{
  int thread = *(const int *)data;

  must(sanggwan_attach() == SANGGWAN_DONE, "attach", NULL);
  for (int life = 0; life < LIVES; life++) {
    sanggwan_world *world = sanggwan_open();
    must(world != NULL, "open", NULL);
    draw_and_compare(world, thread, (thread + life) % MODELS);
    ask_shared(life);
    must(sanggwan_ask(world, "v(S, V, X, _, _)") != NULL, "ask", world);
    sanggwan_close(world);
  }
  sanggwan_detach();
  atomic_fetch_add(&lives, 1);
  return NULL;
}

static void
generation(void)
{
  pthread_t thread[THREADS];
  int number[THREADS];

  for (int i = 0; i < THREADS; i++) {
    number[i] = i;
    must(pthread_create(&thread[i], NULL, live, &number[i]) == 0, "thread",
         NULL);
  }
  for (int i = 0; i < THREADS; i++) {
    pthread_join(thread[i], NULL);
  }
}

static void
references(void)
{
  char file[NAME];

  for (int i = 0; i < MODELS; i++) {
    sanggwan_world *world = sanggwan_open();
    name_drawing(file, "alone", i);
    draw(world, i, file);
    sanggwan_close(world);
  }
}

static void
keep_core(void)
{
  struct rlimit core;
  char *pattern = content("/proc/sys/kernel/core_pattern");

  if (getrlimit(RLIMIT_CORE, &core) == 0) {
    core.rlim_cur = core.rlim_max;
    setrlimit(RLIMIT_CORE, &core);
  }
  printf("a core file would go by the pattern %s", pattern ? pattern : "?\n");
  fflush(stdout);
  free(pattern);
}

static void
clear(void)
{
  char file[NAME];

  for (int i = 0; i < THREADS; i++) {
    name_drawing(file, "own", i);
    unlink(file);
    name_drawing(file, "alone", i);
    unlink(file);
  }
  rmdir(folder);
}

int
main(void)
{
  const char *text = getenv("STRESS_SECONDS");
  long seconds = text ? atol(text) : 3;
  time_t end = time(NULL) + seconds;

  keep_core();
  CHECK("a folder", mkdtemp(folder) != NULL);
  CHECK("it starts", sanggwan_start() == SANGGWAN_DONE);
  references();
  shared = sanggwan_open();
  CHECK("shared", sanggwan_load(shared, model[0]) == SANGGWAN_DONE &&
                      sanggwan_run(shared, "penetrate") == SANGGWAN_DONE);
  do {
    generation();
  } while (time(NULL) < end);
  sanggwan_close(shared);
  clear();
  CHECK("no thread found anything wrong", atomic_load(&faults) == 0);
  printf("counted: %u threads lived and ended, %u drawings\n",
         atomic_load(&lives), atomic_load(&drawings));
  return check_report();
}
