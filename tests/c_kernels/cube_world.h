/* cube_world.h -- a world with a unit cube, for tests of the row layer.
 */
#ifndef SG_TEST_CUBE_WORLD_H
#define SG_TEST_CUBE_WORLD_H

#include "engine/store.h"

#include <stdbool.h>

/* Segment s: vertex 1 + x + 2y + 4z, polygons 1..6 of four edges each, every
 * polygon in two triangles; of the k-th cube of the segment, from 0, all ids
 * are after those of the one before. */
static inline bool
add_cube_at(sg_world *world, int32_t s, int32_t k, const double by[3])
{
  static const int32_t face[6][4] = {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5},
                                     {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}};
  int32_t of[24], id[24], vertex[8], triangle[12], from[24], to[24], real[24],
      list[6][5], number[6];
  int32_t polygon[12], corner[3][12];
  double at[3][8];
  const int32_t *lists[6];

  for (int32_t i = 0; i < 24; i++) {
    of[i] = s;
    id[i] = 24 * k + i + 1;
    from[i] = 8 * k + face[i / 4][i % 4];
    to[i] = 8 * k + face[i / 4][(i + 1) % 4];
    real[i] = 1;
    list[i / 4][0] = 4;
    list[i / 4][1 + i % 4] = id[i];
    lists[i / 4] = list[i / 4];
    number[i / 4] = 6 * k + i / 4 + 1;
  }
  for (int32_t i = 0; i < 8; i++) {
    vertex[i] = 8 * k + i + 1;
    for (int c = 0; c < 3; c++) {
      at[c][i] = (i >> c & 1) + by[c];
    }
  }
  for (int32_t i = 0; i < 12; i++) {
    const int32_t *v = face[i / 2];

    triangle[i] = 12 * k + i + 1;
    polygon[i] = 6 * k + i / 2 + 1;
    corner[0][i] = 8 * k + v[0];
    corner[1][i] = 8 * k + v[1 + i % 2];
    corner[2][i] = 8 * k + v[2 + i % 2];
  }
  return sg_world_add_many(world, SG_V, 8,
                           (const void *[]){of, vertex, at[0], at[1], at[2]},
                           NULL) == SG_OK &&
         sg_world_add_many(world, SG_E, 24,
                           (const void *[]){of, id, from, to, real},
                           NULL) == SG_OK &&
         sg_world_add_many(world, SG_P, 6, (const void *[]){of, number, lists},
                           NULL) == SG_OK &&
         sg_world_add_many(world, SG_T, 12,
                           (const void *[]){of, polygon, triangle, corner[0],
                                            corner[1], corner[2]},
                           NULL) == SG_OK;
}

/* Moved along the diagonal. */
static inline bool
add_cube_moved(sg_world *world, int32_t s, int32_t k, double along)
{
  return add_cube_at(world, s, k, (double[3]){along, along, along});
}

static inline bool
add_cube_again(sg_world *world, int32_t s, int32_t k)
{
  return add_cube_moved(world, s, k, 0);
}

static inline bool
add_cube(sg_world *world, int32_t s)
{
  return add_cube_moved(world, s, 0, 0);
}

#endif
