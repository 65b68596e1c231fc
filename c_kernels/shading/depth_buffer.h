/* depth_buffer.h -- how deep what is seen is, and which way it looks, as rows
 * of numbers.
 *
 * Layer: kernel. In the middle of each dot; the front counts.
 */
#ifndef SG_DEPTH_BUFFER_H
#define SG_DEPTH_BUFFER_H

#include "shading_scene.h"

/* Row y, 0 .. height - 1: of each dot how far the place that is seen is behind
 * a plane, depth = plane[0] x + plane[1] y + plane[2] z + plane[3] of the
 * model; INFINITY where nothing is. `spans` is room. False: no memory. */
bool sg_depth_row(const sg_shading *scene, sg_shading_work *work,
                  const double plane[4], int32_t y, sg_spans *spans,
                  float *out);

/* The same of unit normals; zeros where nothing is. out[width][3] */
bool sg_normal_row(const sg_shading *scene, sg_shading_work *work, int32_t y,
                   sg_spans *spans, float (*out)[3]);

#endif
