/* solid.c -- see solid.h. */
#include "solid.h"

#include "rows/edge_print.h"

#include <stdatomic.h>
#include <stdlib.h>

enum { BLOCK = 1 << 14 }; /* triangles in a task */

void
sg_solid_clear(sg_solid *solid)
{
  free(solid->vertex);
  free(solid->origin);
  free(solid->origin_words);
  free(solid->triangle);
  free(solid->auxiliary);
  free(solid->face);
  free(solid->part);
  *solid = (sg_solid){0};
}

void
sg_solid_free(sg_solid *solid)
{
  if (solid) {
    sg_solid_clear(solid);
    free(solid);
  }
}

typedef struct closing {
  const sg_solid *solid;
  atomic_uint_fast64_t sum; /* wraps: any order gives the same */
} closing;

static void
sum_block(void *data, size_t block)
{
  closing *c = data;
  size_t end = (block + 1) * BLOCK;
  uint64_t sum = 0;

  end = end < c->solid->triangles ? end : c->solid->triangles;
  for (size_t i = block * BLOCK; i < end; i++) {
    const uint32_t *v = c->solid->triangle[i];

    sum += sg_edge_print(v[0], v[1]) + sg_edge_print(v[1], v[2]) +
           sg_edge_print(v[2], v[0]);
  }
  atomic_fetch_add(&c->sum, sum);
}

bool
sg_solid_is_closed(const sg_solid *solid, sg_pool *pool)
{
  closing c = {.solid = solid};

  if (solid->closed) {
    return true;
  }
  atomic_init(&c.sum, 0);
  sg_pool_run(pool, (solid->triangles + BLOCK - 1) / BLOCK, sum_block, &c,
              NULL);
  return (uint64_t)atomic_load(&c.sum) == 0;
}
