/* walk_wait_test.c -- a walk by a column that no index is whole for waits until
 * it is made in steps, between which the caller is asked; whatever the order of
 * things it finds the same rows.
 */
#include "engine/store.h"

#include "tests/check.h"
#include "tests/engine/vertices.h"
#include "tests/stop_later.h"

#include <stdlib.h>

enum { ROWS = 140000, STARTS = 1000 };

static bool
add_edges(sg_world *world, int32_t first, size_t n)
{
  int32_t *cell = malloc(5 * n * sizeof *cell);
  const void *column[5];

  for (size_t i = 0; i < n; i++) {
    cell[i] = 1;
    cell[n + i] = first + (int32_t)i;
    cell[2 * n + i] = 1 + (first + (int32_t)i) % STARTS;
    cell[3 * n + i] = 7;
    cell[4 * n + i] = 1;
  }
  for (int c = 0; c < 5; c++) {
    column[c] = cell + (size_t)c * n;
  }
  bool good = sg_world_add_many(world, SG_E, n, column, NULL) == SG_OK;

  free(cell);
  return good;
}

/* The edges from a vertex are all those that were added, oldest first. */
static bool
finds(sg_walk *walk, const sg_version *version, int32_t start, int32_t last)
{
  int32_t next = start == 1 ? STARTS : start - 1;
  bool good = true;

  for (sg_row r; (r = sg_walk_next(walk)) != SG_NO_ROW; next += STARTS) {
    good = good && sg_version_value(version, SG_E, r, 1).i == next &&
           sg_version_value(version, SG_E, r, 2).i == start;
  }
  sg_walk_close(walk);
  return good && next > last && next - STARTS <= last;
}

/* Asks again and again: how often it waited, and how often what was found was
 * wrong. */
static void
ask(const sg_version *version, int32_t last, int times, int *waited, int *wrong)
{
  const uint16_t mask = 1 << 0 | 1 << 2;

  for (int i = 0; i < times; i++) {
    int32_t start = 1 + i * 37 % STARTS;
    const sg_value row[SG_MAX_COLUMNS] = {{.i = 1}, {.i = 0}, {.i = start}};
    sg_walk walk;
    sg_walk_opening how = sg_walk_try(&walk, version, SG_E, mask, row);

    if (how == SG_WALK_WAITS) {
      int left = 0;
      ++*waited;
      CHECK("it can be stopped",
            !sg_index_ready(version, SG_E, mask,
                            &(sg_cancel){stop_later, &left}));
      CHECK("it is made ready", sg_index_ready(version, SG_E, mask, NULL));
      how = sg_walk_try(&walk, version, SG_E, mask, row);
    }
    CHECK("it opens", how == SG_WALK_OPEN);
    *wrong += !finds(&walk, version, start, last);
  }
}

int
main(void)
{
  sg_world *world = sg_world_open();
  int waited = 0, wrong = 0;

  CHECK("filled",
        fill_vertices(world, 1, 1, STARTS) && add_edges(world, 1, ROWS));
  const sg_version *version = sg_world_version(world);
  ask(version, ROWS, 40, &waited, &wrong);
  CHECK("it waited once", waited == 1);
  CHECK("what is found is right", wrong == 0);
  CHECK("many more", add_edges(world, ROWS + 1, ROWS));
  const sg_version *later = sg_world_version(world);
  ask(later, 2 * ROWS, 40, &waited, &wrong);
  CHECK("for those it waits again", waited == 2);
  CHECK("an older version", wrong == 0);
  ask(version, ROWS, 10, &waited, &wrong);
  CHECK("shows its own, and waits no more", waited == 2 && wrong == 0);
  sg_statistics of;

  sg_world_statistics(world, SG_E, &of);
  CHECK("few were found by looking at all", of.scans < of.lookups);
  sg_version_drop(later);
  sg_version_drop(version);
  CHECK("valid", sg_world_is_valid(world));
  sg_world_drop(world);
  return check_report();
}
