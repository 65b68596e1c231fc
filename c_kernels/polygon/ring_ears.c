#include "ring_ears.h"

#include <stdlib.h>
#include <string.h>

/* Puts the edges in order. False: they are more than one ring, or it has a
 * vertex twice. */
static bool
sort_ring(sg_ring_edge *edge, size_t n)
{
  for (size_t i = 0; i + 1 < n; i++) {
    size_t next = n;
    for (size_t j = 0; j < n; j++) {
      if (edge[j].start == edge[i].end) {
        if (next < n || j <= i) {
          return false;
        }
        next = j;
      }
    }
    if (next == n) {
      return false;
    }
    sg_ring_edge swap = edge[i + 1];
    edge[i + 1] = edge[next];
    edge[next] = swap;
  }
  return edge[n - 1].end == edge[0].start;
}

static double
chord(const sg_ring_edge *a, const sg_ring_edge *b)
{
  double x = b->at[0] - a->at[0], y = b->at[1] - a->at[1];
  double z = b->at[2] - a->at[2];

  return x * x + y * y + z * z;
}

/* The place of the corner between the two that are nearest to each other. */
static size_t
find_ear(const sg_ring_edge *edge, const uint32_t *ring, size_t left)
{
  size_t ear = 0;
  double shortest = chord(&edge[ring[left - 1]], &edge[ring[1]]);

  for (size_t i = 1; i < left; i++) {
    double length = chord(&edge[ring[i - 1]], &edge[ring[(i + 1) % left]]);
    if (length < shortest) {
      shortest = length;
      ear = i;
    }
  }
  return ear;
}

bool
sg_ring_ears(sg_ring_edge *edge, size_t n, int32_t (*triangle)[3],
             bool *is_ring)
{
  uint32_t *ring = malloc(n * sizeof *ring);
  size_t made = 0;

  if (!ring) {
    return false;
  }
  *is_ring = sort_ring(edge, n);
  for (size_t i = 0; i < n; i++) {
    ring[i] = (uint32_t)i;
  }
  for (size_t left = n; *is_ring && left >= 3; left--) {
    size_t ear = find_ear(edge, ring, left);
    triangle[made][0] = edge[ring[(ear + left - 1) % left]].start;
    triangle[made][1] = edge[ring[ear]].start;
    triangle[made++][2] = edge[ring[(ear + 1) % left]].start;
    memmove(&ring[ear], &ring[ear + 1], (left - ear - 1) * sizeof *ring);
  }
  free(ring);
  return true;
}
