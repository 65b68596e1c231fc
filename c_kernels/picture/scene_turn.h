/* scene_turn.h -- the turns of smooth surfaces (contour.h) in a scene, found by
 * the vertices of a line.
 *
 * Layer: kernel.
 */
#ifndef SG_SCENE_TURN_H
#define SG_SCENE_TURN_H

#include "scene.h"

typedef struct sg_keyed_turn {
  uint64_t key; /* its two vertices: of those that are one point the first */
  const sg_scene_turn *turn;
} sg_keyed_turn;

typedef struct sg_turn_index {
  const uint32_t *same; /* as in sg_scene_model */
  sg_keyed_turn *item;  /* [n] sorted */
  size_t n;
  bool *has; /* [vertices] a turn ends there */
} sg_turn_index;

/* Some of an index, one after another. */
typedef struct sg_turns {
  const sg_keyed_turn *item;
  size_t n;
} sg_turns;

/* Of the turns of the input, which stay the caller's. False: no memory. Owner:
 * the caller, sg_turn_index_clear() in any case. */
bool sg_turn_index_init(sg_turn_index *index, const sg_scene_input *in);
void sg_turn_index_clear(sg_turn_index *index);

/* Those of the line between two vertices. */
sg_turns sg_turn_index_find(const sg_turn_index *index, uint32_t a, uint32_t b);

/* On how many triangles all of them say that the line lies. */
size_t sg_turns_lies(const sg_turns *turns);

/* The part of a line that begins at vertex a which the surface of a turn of it
 * hides. */
sg_scene_fold sg_turn_fold(const sg_turn_index *index,
                           const sg_scene_turn *turn, uint32_t a);

#endif
