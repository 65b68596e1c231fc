/* vertices.h -- many vertices at once, for the tests of the store. */
#ifndef SG_TEST_VERTICES_H
#define SG_TEST_VERTICES_H

#include "engine/store.h"

#include <stdlib.h>

/* n vertices of segment s, from id `first` on, on a line. False: refused. */
static inline bool
fill_vertices(sg_world *world, int32_t s, int32_t first, size_t n)
{
  int32_t *ids = malloc(2 * n * sizeof(*ids));
  double *x = malloc(n * sizeof(*x));
  const void *column[5] = {ids, ids + n, x, x, x};
  sg_status status;

  for (size_t i = 0; i < n; i++) {
    ids[i] = s;
    ids[n + i] = first + (int32_t)i;
    x[i] = (double)i;
  }
  status = sg_world_add_many(world, SG_V, n, column, NULL);
  free(ids);
  free(x);
  return status == SG_OK;
}

#endif
