/* depth_buffer.c -- see depth_buffer.h. */
#include "depth_buffer.h"

#include "number/vector.h"

#include <math.h>

bool
sg_depth_row(const sg_shading *scene, sg_shading_work *work,
             const double plane[4], int32_t y, sg_spans *spans, float *out)
{
  int32_t width = sg_shading_frame_of(scene)->width;
  double line = y + 0.5;

  for (int32_t x = 0; x < width; x++) {
    out[x] = INFINITY;
  }
  if (!sg_shading_line(scene, work, line, spans)) {
    return false;
  }
  for (size_t i = 0; i < spans->n; i++) {
    int32_t x, end = sg_span_dots(&spans->span[i], &x);

    for (; x < end; x++) {
      double seen[3] = {x + 0.5, line, 0}, normal[3], place[3];
      sg_shading_point(scene, &spans->span[i], seen[0], line, &seen[2], normal);
      sg_shading_place(scene, seen, place);
      out[x] = (float)(sg_dot(plane, place) + plane[3]);
    }
  }
  return true;
}

bool
sg_normal_row(const sg_shading *scene, sg_shading_work *work, int32_t y,
              sg_spans *spans, float (*out)[3])
{
  int32_t width = sg_shading_frame_of(scene)->width;
  double line = y + 0.5;

  for (int32_t x = 0; x < width; x++) {
    out[x][0] = out[x][1] = out[x][2] = 0;
  }
  if (!sg_shading_line(scene, work, line, spans)) {
    return false;
  }
  for (size_t i = 0; i < spans->n; i++) {
    int32_t x, end = sg_span_dots(&spans->span[i], &x);

    for (; x < end; x++) {
      double depth, normal[3];
      sg_shading_point(scene, &spans->span[i], x + 0.5, line, &depth, normal);
      for (int k = 0; k < 3; k++) {
        out[x][k] = (float)normal[k];
      }
    }
  }
  return true;
}
