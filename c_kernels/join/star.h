/* star.h -- which triangles round one vertex meet beyond it.
 *
 * Layer: kernel. Seen from the vertex, its HUB, a triangle is an arc on a
 * sphere: two have more in common than the hub, and an edge from it that both
 * have, just where their arcs have more in common than an end. A sweep round
 * the sphere finds out of all arcs at once, without looking at each two, those
 * that do.
 *
 * Source: M. I. Shamos, D. Hoey, Geometric intersection problems, 1976, on a
 * sphere; what crosses is taken out, and the sweep goes on.
 */
#ifndef SG_STAR_H
#define SG_STAR_H

#include "engine/cancel.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The corners of a triangle beside the hub. */
typedef struct sg_star_arc {
  double at[2][3];
  uint32_t end[2]; /* equal where they are taken for one; these are in one
                      place. Below the number of ends. */
} sg_star_arc;

/* Sets crossed[] of some of n arcs, so that no two of the others have a point
 * in common but ends of one number. Exact. Arcs with both ends in common are
 * one if `equal`, else crossed. The arcs are few that cross if few do: of two
 * that are seen to, both.
 *
 * Returns: false: no memory, or the cancellation said stop.
 * Cost:    n log n, if the order of those at one meridian is moved by words. */
bool sg_star_cross(const double hub[3], const sg_star_arc *arc, size_t n,
                   size_t ends, bool equal, const sg_cancel *cancel,
                   bool *crossed);

#endif
