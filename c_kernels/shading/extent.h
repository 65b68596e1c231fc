/* extent.h -- where in its frame something of a scene is seen.
 *
 * Layer: kernel.
 */
#ifndef SG_EXTENT_H
#define SG_EXTENT_H

#include "shading_scene.h"
#include "thread_pool.h"

/* Dots. */
typedef struct sg_shading_extent {
  double x1, y1, x2, y2;
} sg_shading_extent;

/* Round what is seen on the lines in the middle of dots, and on others where a
 * leaf, or what is left of one, is between two of these; y1 and y2 are where it
 * ends above the first and below the last of these, to 1/256 dot; x1 and x2 are
 * those of the lines, 1/256 dot apart, beside the one that reaches farthest: a
 * tip may be between two. Nothing is seen: x1 > x2. */
sg_shading_end sg_shading_extent_of(const sg_shading *scene, sg_pool *pool,
                                    const sg_cancel *cancel,
                                    sg_shading_extent *out);

#endif
