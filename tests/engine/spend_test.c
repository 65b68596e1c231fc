/* spend_test.c -- a world that is spent is empty, and has no memory of its
 * rows, unless another one looks at them.
 */
#include "tests/check.h"
#include "vertices.h"

enum { MANY = 9000 };

/* How many vertices it has, and whether number 1 is one of them. */
static bool
has(sg_world *world, size_t n, bool first)
{
  const sg_version *version = sg_world_version(world);
  sg_value key[SG_MAX_COLUMNS] = {[0].i = 1, [1].i = 1};
  bool right = sg_version_count(version, SG_V) == n &&
               (sg_version_find(version, SG_V, key) != SG_NO_ROW) == first;

  sg_version_drop(version);
  return right;
}

static bool
is_whole(sg_world *world)
{
  return has(world, MANY, true);
}

static bool
is_empty(sg_world *world)
{
  return has(world, 0, false);
}

static size_t
bytes_of(sg_world *world)
{
  sg_statistics out;

  sg_world_statistics(world, SG_V, &out);
  return out.bytes;
}

int
main(void)
{
  sg_world *world = sg_world_open();
  size_t before = bytes_of(world);

  CHECK("filled", fill_vertices(world, 1, 1, MANY) && is_whole(world));
  sg_world_hold(world);
  sg_world_spend(world);
  CHECK("another one holds it", is_whole(world));
  sg_world_drop(world);

  const sg_version *version = sg_world_version(world);

  sg_world_spend(world);
  CHECK("another one looks at it", is_whole(world));
  sg_version_drop(version);
  CHECK("a transaction", sg_world_begin(world) == SG_OK);
  sg_world_spend(world);
  CHECK("a transaction is open", is_whole(world));
  CHECK("committed", sg_world_commit(world) == SG_OK);

  sg_world_spend(world);
  CHECK("spent", is_empty(world) && sg_world_is_valid(world));
  CHECK("no bytes", bytes_of(world) == before);
  CHECK("no undo", sg_world_undo(world) != SG_OK && is_empty(world));
  /* Its pages are used again, and what stood there does not show. */
  CHECK("another row", fill_vertices(world, 1, 2, 1) && has(world, 1, false));
  CHECK("valid", sg_world_is_valid(world));
  sg_world_drop(world);
  return check_report();
}
