/* asked.h -- what tests of the store ask of a world as it is now.
 */
#ifndef SG_TEST_ASKED_H
#define SG_TEST_ASKED_H

#include "engine/store.h"

/* SG_NO_ROW: there is none. */
static inline sg_row
find_vertex(sg_world *world, int32_t s, int32_t v)
{
  const sg_version *version = sg_world_version(world);
  sg_value key[SG_MAX_COLUMNS] = {{.i = s}, {.i = v}};
  sg_row row = sg_version_find(version, SG_V, key);

  sg_version_drop(version);
  return row;
}

static inline size_t
count(sg_world *world, sg_relation relation)
{
  const sg_version *version = sg_world_version(world);
  size_t n = sg_version_count(version, relation);

  sg_version_drop(version);
  return n;
}

#endif
