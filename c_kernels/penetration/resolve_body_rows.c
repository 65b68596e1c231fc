/* resolve_body_rows.c -- segments that are made to touch in themselves: see
 * resolve_rows.h.
 *
 * Layer: rows. resolve.h makes things of different segments touch. For a
 * segment that is paired with itself its bodies stand in: they have numbers
 * below zero, and no vertex, edge or polygon in common.
 */
#include "resolve_rows.h"

#include <stdlib.h>

bool
sg_resolving_bodies(sg_call *call, sg_resolving *job)
{
  const sg_cut_handle *handle = job->handle;
  int32_t below = 0;

  for (size_t i = 0; i < handle->pairs; i++) {
    sg_resolving_part part = {.s = handle->pair[i][0], .below = below};

    if (handle->pair[i][0] != handle->pair[i][1]) {
      continue;
    }
    if (!sg_bodies_find(handle->tree[sg_cut_place_of(handle, part.s)]->tree,
                        &handle->views, &call->cancel, &part.bodies) ||
        !SG_PUSH(job->part, part)) {
      sg_bodies_clear(&part.bodies);
      return sg_call_ended(call);
    }
    below -= (int32_t)part.bodies.n;
  }
  return true;
}

int32_t
sg_resolving_body(const sg_resolving *job, int32_t s, int32_t v)
{
  for (size_t i = 0; i < job->part.n; i++) {
    const sg_resolving_part *part = &job->part.item[i];

    if (part->s == s) {
      return part->below - 1 - (int32_t)sg_bodies_of(&part->bodies, v);
    }
  }
  return s;
}

int32_t
sg_resolving_segment(const sg_resolving *job, int32_t body)
{
  size_t i = job->part.n;

  if (body >= 0) { /* 0: of a crossing, none */
    return body;
  }
  do {
    i--;
  } while (body >= job->part.item[i].below);
  return job->part.item[i].s;
}

void
sg_resolving_name_segments(sg_resolving *job)
{
  for (size_t i = 0; i < job->r.node.n; i++) {
    sg_resolve_node *node = &job->r.node.item[i];

    node->s = sg_resolving_segment(job, node->s);
    for (int k = 0; k < 2 && node->v == 0; k++) {
      node->line[k][0] = sg_resolving_segment(job, node->line[k][0]);
    }
  }
  for (size_t i = 0; i < job->r.place.n; i++) {
    sg_resolve_place *place = &job->r.place.item[i];
    place->s = sg_resolving_segment(job, place->s);
  }
  for (size_t i = 0; i < job->polygon.n; i++) {
    sg_resolved_polygon *polygon = &job->polygon.item[i];
    polygon->s = sg_resolving_segment(job, polygon->s);
  }
}

void
sg_resolving_bodies_clear(sg_resolving *job)
{
  for (size_t i = 0; i < job->part.n; i++) {
    sg_bodies_clear(&job->part.item[i].bodies);
  }
  free(job->part.item);
}
