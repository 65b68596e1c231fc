/* scene_facing.h -- the facings of smooth surfaces (contour.h) in a scene,
 * found by the vertices of a line.
 *
 * Layer: kernel.
 */
#ifndef SG_SCENE_FACING_H
#define SG_SCENE_FACING_H

#include "scene.h"

typedef struct sg_keyed_facing {
  uint64_t key; /* its two vertices: of those that are one point the first */
  const sg_scene_facing *facing;
} sg_keyed_facing;

typedef struct sg_facing_index {
  const uint32_t *same;  /* as in sg_scene_model */
  sg_keyed_facing *item; /* [n] sorted */
  size_t n;
  bool *has; /* [vertices] a facing ends there */
} sg_facing_index;

/* Some of an index, one after another. */
typedef struct sg_facings {
  const sg_keyed_facing *item;
  size_t n;
} sg_facings;

/* Of the facings of the input, which stay the caller's. False: no memory.
 * Owner: the caller, sg_facing_index_clear() in any case. */
bool sg_facing_index_init(sg_facing_index *index, const sg_scene_input *in);
void sg_facing_index_clear(sg_facing_index *index);

/* Those of the line between two vertices. */
sg_facings sg_facing_index_find(const sg_facing_index *index, uint32_t a,
                                uint32_t b);

/* On how many triangles all of them say that the line lies. */
size_t sg_facings_lies(const sg_facings *facings);

/* The part of a line that begins at vertex a which the surface of a facing of
 * it hides. */
sg_scene_fold sg_facing_fold(const sg_facing_index *index,
                             const sg_scene_facing *facing, uint32_t a);

#endif
