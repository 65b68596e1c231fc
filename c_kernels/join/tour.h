/* tour.h -- a walk over points, and the triangles that it passes.
 *
 * Layer: kernel. How often closed triangles go round many points. A ray from
 * each point would meet all that is ahead of it; a walk from one point to the
 * next meets what is between them, and counts that alone. It begins beyond all
 * triangles, where none goes round anything, runs along the axes, and visits
 * points near each other one after another. All of it is shifted by less than
 * anything towards +y, by still less towards +z and by less than that towards
 * -x; so it meets no edge and no corner, and ends on no triangle. Exact.
 */
#ifndef SG_TOUR_H
#define SG_TOUR_H

#include "bvh.h"
#include "number/exact.h"

/* Triangles are items of a tree; `data` is what each function gets first. */
typedef struct sg_tour {
  const sg_bvh *tree;
  void *data;
  void (*corners)(const void *data, uint32_t item, double out[3][3]);
  /* The walk passes a triangle: that goes round so many times more. */
  void (*pass)(void *data, uint32_t item, int turns);
  /* Point i lies on a triangle, which may have no area. */
  void (*on)(void *data, size_t i, uint32_t item);
  /* The walk is at point i; all that it lies on has been said. */
  void (*arrive)(void *data, size_t i);
} sg_tour;

/* Goes to the n points, all inside the tree's box up to rounding. Where
 * triangles are not closed, what has been passed at a point means nothing.
 *
 * Returns: false: no memory, or the cancellation said stop.
 * Cost:    about (points + triangles) log points, if no triangle is near many
 *          of the points. */
bool sg_tour_over(const sg_tour *walk, const sg_point *const *at, size_t n,
                  const sg_cancel *cancel);

#endif
