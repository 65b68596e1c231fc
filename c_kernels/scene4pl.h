/* scene4pl.h -- the arrays of a scene, read from one version of a world.
 *
 * Layer: glue.
 */
#ifndef SG_SCENE4PL_H
#define SG_SCENE4PL_H

#include "../engine/store.h"
#include "scene.h"

/* Which segments take part: all when `all`, else the sorted ids. */
typedef struct sg_chosen {
  bool all;
  int32_t *s;
  size_t n;
} sg_chosen;

bool sg_is_chosen(const sg_chosen *chosen, int32_t s);

/* Fills the arrays of `in` from the chosen segments. False: stopped by the
 * poll, or no memory (then *memory is false). The caller calls
 * sg_scene_input_clear() in any case. */
bool sg_scene_input_read(sg_scene_input *in, const sg_version *version,
                         const sg_chosen *chosen, const sg_poll *poll,
                         bool *memory);
void sg_scene_input_clear(sg_scene_input *in);

#endif
