/* solid.c -- see solid.h. */
#include "solid.h"

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
