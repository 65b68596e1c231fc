/* shaded_sphere.h -- a scene of one sphere, seen along -z in the model.
 */
#ifndef SG_TEST_SHADED_SPHERE_H
#define SG_TEST_SHADED_SPHERE_H

#include "shading/shading_scene.h"

#include <stddef.h>

/* Leaf 1 of the root 1; x to the right, y up, z to the eye. Null: failed. */
static inline sg_shading *
sphere_scene(int32_t width, int32_t height, double x, double y, double r)
{
  const sg_shading_frame frame = {
      .matrix = {{1, 0, 0, 0}, {0, -1, 0, height}, {0, 0, -1, 0}, {0, 0, 0, 1}},
      .width = width,
      .height = height,
      .tolerance = 1e-9};
  const sg_shading_piece ball = {
      .sphere = true,
      .frame = {{x, height - y, 0}, {r, 0, 0}, {0, r, 0}, {0, 0, r}},
      .low_face = -1,
      .high_face = -1,
      .face = 1};
  sg_shading *scene = sg_shading_open(&frame);

  if (scene && (sg_shading_add_leaf(scene, 1) == UINT32_MAX ||
                sg_shading_add_piece(scene, &ball) != SG_SHADING_GOOD ||
                !sg_shading_add_root(scene, 1) ||
                sg_shading_add_node(scene, 0, SG_LEAF, 0) == SIZE_MAX ||
                sg_shading_seal(scene, NULL) != SG_SHADING_GOOD)) {
    sg_shading_close(scene);
    scene = NULL;
  }
  return scene;
}

#endif
