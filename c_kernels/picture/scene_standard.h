/* scene_standard.h -- the scale and centre of a picture.
 *
 * Layer: kernel. Source: PL-5.
 */
#ifndef SG_SCENE_STANDARD_H
#define SG_SCENE_STANDARD_H

#include "scene.h"

typedef struct sg_scene_standard {
  double centre[3]; /* of all that has a place, with its depth */
  double side;      /* the longer one of the picture; 0: nothing has a place */
  double scale;     /* a power of two, more than half of the side; or 1 */
  double largest;   /* absolute coordinate */
} sg_scene_standard;

/* That of the vertices that are shown and of the added lines, in units of the
 * picture, depths in those of the model. Inexact. */
sg_scene_standard sg_scene_standard_of(const sg_scene_input *in);

#endif
