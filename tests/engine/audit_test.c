/* audit_test.c -- what says whether a world is valid: it is asked by many
 * tests, so here each invariant is broken, and mended again.
 */
#include "asked.h"
#include "engine/world.h"
#include "rows.h"

static rows some;

/* A world of vertices in runs, some of them gone, of two segments; polygons
 * with lists. */
static sg_world *
made_world(void)
{
  sg_world *world = sg_world_open();

  make_rows(&some, SG_V, 1, 1, 3000, (const int32_t[3]){1, 1, 1});
  CHECK("vertices", append(world, &some));
  make_rows(&some, SG_V, 2, 1, 10, (const int32_t[3]){1, 1, 1});
  CHECK("more", add_checked(world, &some));
  make_rows(&some, SG_E, 1, 1, 100, (const int32_t[3]){100, 1, 1});
  CHECK("edges", append(world, &some));
  return world;
}

/* Whether a value that is not as it was is noticed, and nothing once it is as
 * it was again. */
#define NOTICED(what, place, wrong)                                            \
  do {                                                                         \
    __typeof__(place) was = (place);                                           \
    (place) = (wrong);                                                         \
    CHECK(what, !sg_world_is_valid(world));                                    \
    (place) = was;                                                             \
    CHECK(what ", mended", sg_world_is_valid(world));                          \
  } while (0)

static void
test_rows(sg_world *world)
{
  sg_table *table = &world->table[SG_V];
  sg_page *page = table->page[0];
  sg_map *map = world->current->map[SG_V];
  sg_live *live = map->chunk[0]->live[0];

  CHECK("valid", sg_world_is_valid(world));
  NOTICED("a row that is shown is taken", page->taken[1], 0);
  NOTICED("rows are counted", map->rows, map->rows + 1);
  NOTICED("a bitmap is of its page", live->page, table->page[1]);
  NOTICED("slots have pages", table->slots, (sg_row)(1u << 30));
  NOTICED("the span has the segments, first", page->span.first, 2);
  NOTICED("the span has the segments, last", page->span.last, 0);
}

/* Three rows are gone, and their slots on the stack. */
static void
test_empty(sg_world *world)
{
  sg_table *table = &world->table[SG_V];
  sg_page *page = table->page[0];
  sg_map *map = world->current->map[SG_V];
  sg_live *live = map->chunk[0]->live[0];
  uint16_t stack[3] = {5, 4, 3};
  const uint64_t three = 7u << 3;

  CHECK("no slot is empty", page->empties == 0 && table->emptied == 0);
  NOTICED("empty slots are counted", table->emptied, 1);
  page->empty = stack;
  page->empties = 3;
  page->gap = 3;
  table->gap = 3;
  table->emptied = 3;
  CHECK("taken slots are on no stack", !sg_world_is_valid(world));
  page->taken[0] &= ~three;
  CHECK("nor such as are shown", !sg_world_is_valid(world));
  live->word[0] &= ~three;
  map->rows -= 3;
  CHECK("valid", sg_world_is_valid(world));
  NOTICED("the first is on top", stack[0], 2);
  NOTICED("none is there twice", stack[0], 4);
  NOTICED("gaps are no longer", page->gap, 2);
  NOTICED("nor than the table says", table->gap, 2);
  page->taken[0] |= three;
  live->word[0] |= three;
  map->rows += 3;
  page->empty = NULL;
  page->empties = 0;
  page->gap = 0;
  table->gap = 0;
  table->emptied = 0;
  CHECK("as it was", sg_world_is_valid(world));
}

static void
test_keys(sg_world *world)
{
  sg_table *table = &world->table[SG_V];
  sg_run *run = &table->keys.run[0];
  sg_page *page = table->page[0];

  CHECK("a run", table->keys.count > 0 && run->n >= 1000);
  NOTICED("a run has its ids", run->id, run->id + 1);
  NOTICED("a run has its segment", run->s, 2);
  NOTICED("no key twice", page->cells[1].i[7], page->cells[1].i[8]);
  NOTICED("segments are those of the run", page->cells[0].i[7], 2);
}

int
main(void)
{
  sg_world *world = made_world();

  test_rows(world);
  test_empty(world);
  test_keys(world);
  sg_world_drop(world);
  return check_report();
}
