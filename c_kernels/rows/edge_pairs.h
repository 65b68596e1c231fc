/* edge_pairs.h -- which directed edges run between the same two vertices.
 *
 * Layer: kernel. All connectivity is found by this join (PL-1): an edge pair is
 * a group of two opposite edges; a group of one is a border.
 */
#ifndef SG_EDGE_PAIRS_H
#define SG_EDGE_PAIRS_H

#include "engine/cancel.h"

#include <stddef.h>
#include <stdint.h>

/* Directed edges sorted by their lower and upper vertex, forward ones (from
 * the lower to the upper) first, then by number. */
typedef struct sg_edge_pairs {
  size_t n;
  uint64_t *key;    /* [n] upper vertex, direction bit, edge number */
  uint32_t *bucket; /* [vertices + 1] by lower vertex */
  size_t vertices;
} sg_edge_pairs;

/* The edges from[i] -> to[i], i < n, with 0 <= from[i], to[i] < vertices.
 *
 * Returns: false: no memory (*stopped false) or stopped by the cancellation.
 * Cost:    n log d, d the most edges at one vertex.
 * Owner:   sg_edge_pairs_clear() in any case.
 */
bool sg_edge_pairs_make(size_t n, const int32_t *from, const int32_t *to,
                        size_t vertices, const sg_cancel *cancel,
                        sg_edge_pairs *out, bool *stopped);
void sg_edge_pairs_clear(sg_edge_pairs *pairs);

/* A walk over the groups, in the order of lower and upper vertex.
 *
 *   sg_edge_group group = {0};
 *   while (sg_edge_group_next(&pairs, &group)) ...
 */
typedef struct sg_edge_group {
  size_t begin, end; /* places in pairs->key */
  size_t forward;    /* edges that run from low to high */
  uint32_t low, high;
} sg_edge_group;

bool sg_edge_group_next(const sg_edge_pairs *pairs, sg_edge_group *group);

/* The group of the edges between two vertices; false: there are none. */
bool sg_edge_group_find(const sg_edge_pairs *pairs, uint32_t v, uint32_t w,
                        sg_edge_group *group);

static inline uint32_t
sg_edge_group_edge(const sg_edge_pairs *pairs, size_t place)
{
  return (uint32_t)pairs->key[place];
}

/* True if every group has as many edges one way as the other. */
bool sg_edge_pairs_closed(const sg_edge_pairs *pairs);

#endif
