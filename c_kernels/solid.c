/* solid.c -- see solid.h. */
#include "solid.h"

#include "edge_print.h"

#include <stdlib.h>

void
sg_solid_clear(sg_solid *solid)
{
  for (size_t i = solid->plain; solid->origin && i < solid->vertices; i++) {
    free(solid->origin[i - solid->plain]);
  }
  free(solid->vertex);
  free(solid->origin);
  free(solid->triangle);
  free(solid->auxiliary);
  free(solid->face);
  free(solid->part);
  *solid = (sg_solid){0};
}

bool
sg_solid_is_closed(const sg_solid *solid)
{
  uint64_t sum = 0;

  for (size_t i = 0; i < solid->triangles; i++) {
    const uint32_t *v = solid->triangle[i];

    sum += sg_edge_print(v[0], v[1]) + sg_edge_print(v[1], v[2]) +
           sg_edge_print(v[2], v[0]);
  }
  return sum == 0;
}
