/* threads_test.c -- writers and readers at once; run it under
 * ThreadSanitizer too. */
#include "engine/store.h"
#include "tests/check.h"

#include <pthread.h>
#include <stdatomic.h>

enum { READERS = 2, WRITERS = 2, ROWS = 300, ROUNDS = 60 };

static sg_world *world;
static atomic_bool finished;
static atomic_int wrong;

/* A round takes all rows away and puts others in whose X add up to -150. */
static void
write_round(int round)
{
  sg_world_begin(world);
  sg_world_retract_all(world, SG_V);
  for (int v = 1; v <= ROWS; v++) {
    double x = v % 2 ? v + round : -v - round;
    sg_value row[SG_MAX_COLUMNS] = {{.i = 1}, {.i = v}, {.f = x}};
    if (sg_world_add(world, SG_V, row, NULL, NULL) != SG_OK) {
      atomic_fetch_add(&wrong, 1);
    }
  }
  if (round % 3 == 1) {
    sg_world_rollback(world);
  } else {
    sg_world_commit(world);
  }
  if (round % 7 == 6) {
    sg_world_undo(world);
  }
}

static void *
writer(void *unused)
{
  for (int round = 0; round < ROUNDS; round++) {
    write_round(round);
  }
  return unused;
}

static void
note(bool right)
{
  if (!right) {
    atomic_fetch_add(&wrong, 1);
  }
}

/* A version is whole or empty, whatever the writers do meanwhile. */
static void
read_once(void)
{
  const sg_version *version = sg_world_version(world);
  size_t n = sg_version_count(version, SG_V);
  size_t seen = 0;
  double sum = 0;
  sg_walk walk;

  note(n == 0 || n == ROWS);
  note(sg_walk_open(&walk, version, SG_V, 0, NULL));
  for (sg_row row; (row = sg_walk_next(&walk)) != SG_NO_ROW; seen++) {
    sum += sg_version_value(version, SG_V, row, 2).f;
  }
  sg_walk_close(&walk);
  note(seen == n && (n == 0 || sum == -ROWS / 2));
  for (int v = 1; n > 0 && v <= ROWS; v += 37) {
    sg_value key[SG_MAX_COLUMNS] = {{.i = 1}, {.i = v}};
    note(sg_version_find(version, SG_V, key) != SG_NO_ROW);
  }
  sg_version_drop(version);
}

static void *
reader(void *unused)
{
  while (!atomic_load(&finished)) {
    read_once();
  }
  return unused;
}

int
main(void)
{
  pthread_t writers[WRITERS], readers[READERS];

  world = sg_world_open();
  for (int i = 0; i < READERS; i++) {
    pthread_create(&readers[i], NULL, reader, NULL);
  }
  for (int i = 0; i < WRITERS; i++) {
    pthread_create(&writers[i], NULL, writer, NULL);
  }
  for (int i = 0; i < WRITERS; i++) {
    pthread_join(writers[i], NULL);
  }
  atomic_store(&finished, true);
  for (int i = 0; i < READERS; i++) {
    pthread_join(readers[i], NULL);
  }
  CHECK("readers saw whole versions only", atomic_load(&wrong) == 0);
  CHECK("the world is valid", sg_world_is_valid(world));
  sg_world_drop(world);
  return check_report();
}
