/* sphere_map.h -- how the disks at one vertex lie to each other (NG-2).
 *
 * Layer: kernel. Seen from the vertex, a triangle that has it is an arc of a
 * sphere of directions, shorter than half a circle; a wire is a point. A DISK
 * is what hangs together there by triangles; on the sphere it has one or more
 * CYCLES, borders of what it divides the sphere into. Disks do not cross or
 * touch each other. Then each lies in one zone of any other, and what the
 * cycles of all of them bound together are the zones of the vertex.
 *
 * Exact: orient3d of doubles alone, along arcs from one direction that is in no
 * plane of any of them.
 */
#ifndef SG_SPHERE_MAP_H
#define SG_SPHERE_MAP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The side of a triangle opposite the vertex, `a` to `b` as the triangle runs
 * (counter-clockwise from above); what is on either side is a cycle. */
typedef struct sg_sphere_arc {
  const double *a, *b;
  uint32_t disk, below, above;
} sg_sphere_arc;

typedef struct sg_sphere_map {
  const double *apex;
  size_t disks, cycles, arcs;
  const sg_sphere_arc *arc;   /* [arcs] by disk */
  const uint32_t *first_arc;  /* [disks + 1] */
  const double *const *point; /* [disks] a direction of each disk */
  const uint32_t *any_cycle;  /* [disks] a cycle of each disk */
} sg_sphere_map;

/* zone[c], c < cycles: the lowest cycle of its zone.
 *
 * Returns: false: no memory.
 * Cost:    disks times arcs of those that divide the sphere. */
bool sg_sphere_map_zones(const sg_sphere_map *map, uint32_t *zone);

#endif
