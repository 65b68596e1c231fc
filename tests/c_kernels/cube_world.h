/* cube_world.h -- a world with a unit cube, for tests of the row layer.
 */
#ifndef SG_TEST_CUBE_WORLD_H
#define SG_TEST_CUBE_WORLD_H

#include "engine/store.h"

#include <stdbool.h>

/* Segment s: vertex 1 + x + 2y + 4z, polygons 1..6 of four edges each, every
 * polygon in two triangles. */
static inline bool
add_cube(sg_world *world, int32_t s)
{
  static const int32_t face[6][4] = {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5},
                                     {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}};
  int32_t of[24], id[24], from[24], to[24], real[24], list[6][5];
  int32_t polygon[12], corner[3][12];
  double at[3][8];
  const int32_t *lists[6];

  for (int32_t i = 0; i < 24; i++) {
    of[i] = s;
    id[i] = i + 1;
    from[i] = face[i / 4][i % 4];
    to[i] = face[i / 4][(i + 1) % 4];
    real[i] = 1;
    list[i / 4][0] = 4;
    list[i / 4][1 + i % 4] = i + 1;
    lists[i / 4] = list[i / 4];
  }
  for (int i = 0; i < 8; i++) {
    for (int k = 0; k < 3; k++) {
      at[k][i] = i >> k & 1;
    }
  }
  for (int i = 0; i < 12; i++) {
    const int32_t *v = face[i / 2];

    polygon[i] = i / 2 + 1;
    corner[0][i] = v[0];
    corner[1][i] = v[1 + i % 2];
    corner[2][i] = v[2 + i % 2];
  }
  return sg_world_add_many(world, SG_V, 8,
                           (const void *[]){of, id, at[0], at[1], at[2]},
                           NULL) == SG_OK &&
         sg_world_add_many(world, SG_E, 24,
                           (const void *[]){of, id, from, to, real},
                           NULL) == SG_OK &&
         sg_world_add_many(world, SG_P, 6, (const void *[]){of, id, lists},
                           NULL) == SG_OK &&
         sg_world_add_many(
             world, SG_T, 12,
             (const void *[]){of, polygon, id, corner[0], corner[1], corner[2]},
             NULL) == SG_OK;
}

#endif
