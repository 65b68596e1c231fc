/* tree_rows_test.c -- kept trees, and what is kept of operands with them. */
#include "join/tree_rows.h"

#include "doors/boolean.h"
#include "doors/world.h"
#include "tests/c_kernels/cube_world.h"
#include "tests/check.h"
#include "tests/memory/refusals.h"
#include "tests/memory/refuse.h"

#include "engine/symbol.h"
#include "engine/term.h"

#include <string.h>

enum { CUBES = 3 };

static sg_call call;
static const int32_t all[CUBES] = {1, 2, 3};

/* Three cubes, in one place. */
static sg_world *
make_world(void)
{
  sg_world *world = sg_world_open();
  bool good = world != NULL;
  sg_term_builder name;

  sg_term_open(&name);
  sg_term_nil(&name);
  for (int i = 0; i < CUBES && good; i++) {
    const sg_value row[3] = {
        {.i = all[i]}, {.i = SG_SYMBOL_SOLID}, {.term = sg_term_words(&name)}};
    good = sg_world_add(world, SG_SEGMENT, row, NULL, NULL) == SG_OK &&
           add_cube(world, all[i]);
  }
  sg_term_close(&name);
  CHECK("a world", good);
  return world;
}

/* Holds the trees of the first n, and lets them go again; the last of them. */
static const sg_kept_tree *
held(sg_world *world, size_t n)
{
  const sg_version *version = sg_world_version(world);
  sg_kept_tree *tree[CUBES];
  const sg_kept_tree *last = NULL;
  sg_leaf_views views;
  bool good = sg_leaf_views_open(&call, version, &views) &&
              sg_trees_hold(&call, version, &views, all, n, tree);

  CHECK("hold", good);
  for (size_t i = 0; i < n && good; i++) {
    CHECK("of its segment", tree[i]->s == all[i]);
    CHECK("of its triangles", tree[i]->tree->boxes->n == 12);
    last = tree[i];
    sg_kept_tree_drop(tree[i]);
  }
  sg_leaf_views_clear(&views);
  sg_version_drop(version);
  return last;
}

static void
check_counts(const char *name, size_t trees, uint64_t grown, uint64_t found)
{
  sg_tree_counts n;

  CHECK(name, sg_door_tree_statistics(&call, &n));
  CHECK(name, n.trees == trees && n.leaves == 12 * trees);
  CHECK(name, n.grown == grown && n.found == found);
}

/* Moves vertex 8 of segment s away. */
static void
move_vertex(sg_world *world, int32_t s)
{
  const sg_value row[5] = {{.i = s}, {.i = 8}, {.f = 2}, {.f = 2}, {.f = 2}};
  const sg_version *version = sg_world_version(world);
  sg_row old = sg_version_find(version, SG_V, row);

  sg_version_drop(version);
  CHECK("move", sg_world_begin(world) == SG_OK &&
                    sg_world_retract(world, SG_V, old) &&
                    sg_world_add(world, SG_V, row, NULL, NULL) == SG_OK &&
                    sg_world_commit(world) == SG_OK);
}

static void
trees(sg_world *world)
{
  sg_box box;

  const sg_version *version = sg_world_version(world);
  CHECK("no box yet", !sg_kept_box(version, 2, &box));
  sg_version_drop(version);
  const sg_kept_tree *two = held(world, 2);

  check_counts("two are grown", 2, 2, 0);
  CHECK("the same again", held(world, 2) == two);
  check_counts("two are found", 2, 2, 2);
  held(world, 3);
  check_counts("one is grown", 3, 3, 4);
  move_vertex(world, 3);
  held(world, 3);
  check_counts("what changed is grown", 3, 4, 6);
  version = sg_world_version(world);
  CHECK("its box", sg_kept_box(version, 3, &box) && box.hi[0] == 2);
  sg_version_drop(version);
}

static void
gone(sg_world *world)
{
  const sg_value key[3] = {{.i = 2}};
  const sg_version *version = sg_world_version(world);
  sg_row row = sg_version_find(version, SG_SEGMENT, key);

  sg_version_drop(version);
  CHECK("gone", sg_world_retract(world, SG_SEGMENT, row));
  held(world, 1);
  check_counts("its tree is, too", 2, 4, 7);
}

/* As if they had never been there, but for what was counted. */
static void
dropped(sg_world *world)
{
  CHECK_DOOR("dropped", sg_door_trees_dropped(&call));
  check_counts("none is kept", 0, 4, 7);
  held(world, 1);
  check_counts("it is grown again", 1, 5, 7);
}

static void
operands(void)
{
  sg_operand operand;
  sg_operand_edges counts;
  sg_operand_edge_list edges;
  int32_t both[] = {1, 3};
  const sg_int_list segments = {both, 2, 2};
  sg_int_list which = {0};

  CHECK_DOOR("operand", sg_door_segment_operand(&call, 1, &operand));
  CHECK("of a cube", operand.triangles == 12 && operand.half_edges == 24 &&
                         operand.balanced && operand.star);
  CHECK("of volume 1", operand.volume > 0.999 && operand.volume < 1.001);
  CHECK_DOOR("edges", sg_door_segment_edges(&call, 1, 5, &counts, &edges));
  CHECK("all are pairs", counts.open + counts.unbalanced + counts.crowded == 0);
  CHECK("none listed", edges.n == 0);
  CHECK_DOOR("nobody",
             sg_door_segments_meeting_themselves(&call, &segments, &which));
  CHECK("goes through itself", which.n == 0);
  CHECK("nor this one", !sg_door_segment_meets_itself(&call, 3));
  CHECK("refuses nothing", call.refusal.how == SG_REFUSED_NOTHING);
}

/* A vertex put through the opposite side: its faces go through others. */
static void
meets_itself(sg_world *world)
{
  const sg_value row[5] = {
      {.i = 1}, {.i = 8}, {.f = 0.5}, {.f = 0.5}, {.f = -1}};
  const sg_version *version = sg_world_version(world);
  sg_row old = sg_version_find(version, SG_V, row);

  sg_version_drop(version);
  CHECK("through", sg_world_retract(world, SG_V, old) &&
                       sg_world_add(world, SG_V, row, NULL, NULL) == SG_OK);
  sg_call_rest(&call);
  CHECK_DOOR("the other side", sg_door_segment_meets_itself(&call, 1));
  CHECK_DOOR("known", sg_door_segment_meets_itself(&call, 1));
}

/* Of a world without trees, while memory runs out at request n: all or none.
 * True: there was enough. */
static bool
held_or_none(long n)
{
  sg_world *world = make_world();
  const sg_version *version = sg_world_version(world);
  sg_kept_tree *tree[CUBES];
  sg_leaf_views views;
  bool all_held, full = true, none = true;

  memset(tree, 0x5a, sizeof tree);
  sg_call_open(&call, NULL, NULL);
  call.world = world;
  CHECK("views", sg_leaf_views_open(&call, version, &views));
  left = n, living = 0, counting = true;
  all_held = sg_trees_hold(&call, version, &views, all, CUBES, tree);
  left = -1, counting = false;
  for (size_t i = 0; i < CUBES; i++) {
    full &= tree[i] != NULL;
    none &= !tree[i];
    sg_kept_tree_drop(tree[i]);
  }
  CHECK("all or none", all_held ? full : none);
  CHECK("and why", all_held == (call.refusal.how == SG_REFUSED_NOTHING));
  sg_leaf_views_clear(&views);
  sg_version_drop(version);
  sg_call_close(&call);
  sg_world_drop(world);
  return all_held;
}

static void
memory_runs_out(void)
{
  long n = 0;

  while (n < 10000 && !held_or_none(n)) {
    n++;
  }
  CHECK("in the end there is enough", n < 10000);
  CHECK("not at once", n > CUBES || !is_counted());
}

int
main(void)
{
  spare_gmp();
  memory_runs_out();

  sg_world *world = make_world();

  sg_call_open(&call, NULL, NULL);
  call.world = world;
  trees(world);
  gone(world);
  dropped(world);
  operands();
  meets_itself(world);
  sg_call_close(&call);
  sg_world_drop(world);
  return check_report();
}
