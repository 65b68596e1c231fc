/* regions.c -- see regions.h. */
#include "regions_private.h"

#include "polygon/flatness.h"

#include <stdlib.h>

bool
sg_regions_no_memory(sg_regions_maker *m)
{
  m->end = SG_REGIONS_NO_MEMORY;
  return false;
}

bool
sg_regions_asked(sg_regions_maker *m)
{
  if (sg_cancelled(m->cancel)) {
    m->end = SG_REGIONS_STOPPED;
  }
  return m->end != SG_REGIONS_STOPPED;
}

static void
clear_maker(sg_regions_maker *m)
{
  free(m->triangle_begin);
  free(m->triangle);
  free(m->polygon);
  free(m->next);
  free(m->before);
  free(m->third);
  free(m->way);
  free(m->loops);
  free(m->is_face);
  free(m->edge_of);
  free(m->wire);
  free(m->low);
  free(m->high);
  free(m->wire_edge);
  free(m->cycle);
  free(m->piece);
  free(m->zone);
  free(m->euler);
  free(m->outer);
  free(m->classes);
  free(m->slit);
  free(m->lone_at);
  free(m->shell);
}

sg_regions_end
sg_regions_make(const sg_dense *dense, const sg_point_loop *point_loop,
                size_t n, const sg_zones_told *told, const sg_cancel *cancel,
                sg_regions *out, size_t *bad)
{
  sg_regions_maker m = {
      .d = dense,
      .point_loop = point_loop,
      .point_loops = n,
      .told = told,
      .cancel = cancel,
      .near = sg_flatness_touch_of(
          (const double(*)[3])dense->at, dense->vertices,
          dense->segments > 0 && dense->grain ? dense->grain[0] : 0),
      .out = out};
  uint32_t outside = SG_NOWHERE;

  *out = (sg_regions){0};
  bool good = sg_regions_corners(&m) && sg_regions_edges(&m) &&
              sg_regions_vertices(&m) && sg_regions_outer(&m) &&
              sg_regions_locate(&m, &outside) && sg_regions_count(&m, outside);

  clear_maker(&m);
  *bad = m.bad;
  return good ? SG_REGIONS_DONE : m.end;
}

void
sg_regions_clear(sg_regions *regions)
{
  free(regions->side);
  free(regions->region);
  free(regions->shell);
  free(regions->wire);
  free(regions->lone_vertex);
  *regions = (sg_regions){0};
}
