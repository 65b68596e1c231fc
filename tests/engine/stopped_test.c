/* stopped_test.c -- what is long in the store is stopped at any question, and
 * leaves a world as it was. */
#include "asked.h"
#include "engine/store.h"
#include "tests/check.h"
#include "tests/stop_later.h"
#include "vertices.h"

#include <stdlib.h>

enum { LOTS = 1 << 17 }; /* rows */

/* A lot of edges is stopped at each question: nothing is added. */
static void
test_stopped(void)
{
  static int32_t s[LOTS], id[LOTS], one[LOTS], none[LOTS];
  const void *const edge[] = {s, id, one, one, none};
  sg_world *world = sg_world_open();
  int left = -1, k = 0;

  CHECK("a vertex", fill_vertices(world, 1, 1, 2));
  for (int32_t i = 0; i < LOTS; i++) {
    s[i] = 1;
    id[i] = i + 1;
    one[i] = i % 2 + 1;
  }
  for (; left < 0 && k < 10000; k = 2 * k + 1) {
    sg_cancel cancel = {stop_later, &left};

    left = k;
    sg_status status =
        sg_world_add_many_or_stop(world, SG_E, LOTS, edge, &cancel, NULL);

    CHECK("stopped, or all", status == (left < 0 ? SG_HALTED : SG_OK) &&
                                 count(world, SG_E) == (left < 0 ? 0 : LOTS));
  }
  CHECK("it was asked between rows", k > LOTS / 1024);
  CHECK("valid", sg_world_is_valid(world));
  sg_world_drop(world);
}

/* A walk through all rows is stopped between pages, and then has no more. */
static void
test_stopped_walk(void)
{
  sg_world *world = sg_world_open();

  CHECK("many", fill_vertices(world, 1, 1, LOTS));
  const sg_version *version = sg_world_version(world);
  size_t n = 0;

  for (int k = 0; n < LOTS && k < 100; k++) {
    int left = k;
    sg_cancel cancel = {stop_later, &left};
    sg_walk walk;

    CHECK("open", sg_walk_open(&walk, version, SG_V, 0, NULL));
    walk.cancel = &cancel;
    for (n = 0; sg_walk_next(&walk) != SG_NO_ROW; n++) {
    }
    CHECK("stopped, or all", left < 0 || n == LOTS);
    CHECK("not at once", k == 0 ? n == 0 : n > 0);
    CHECK("no more", sg_walk_next(&walk) == SG_NO_ROW);
    sg_walk_close(&walk);
  }
  CHECK("all, at last", n == LOTS);
  sg_version_drop(version);
  sg_world_drop(world);
}

int
main(void)
{
  test_stopped();
  test_stopped_walk();
  return check_report();
}
