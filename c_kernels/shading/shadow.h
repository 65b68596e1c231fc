/* shadow.h -- how much of a light comes to a point.
 *
 * Layer: kernel. A scene that is seen from where a light comes: what is behind
 * the first thing seen there has none of it. The walk is that of pictures, so a
 * shadow is that of the solid, whatever its tree. What is see-through takes as
 * much of the light as it is opaque. A tree of boxes gives what may be in the
 * way. Inexact; the same on every machine.
 */
#ifndef SG_SHADOW_H
#define SG_SHADOW_H

#include "join/bvh.h"
#include "shading_scene.h"

typedef struct sg_shadow {
  const sg_shading *scene; /* of a parallel picture, all of it in its frame */
  sg_bvh *tree;            /* null: it has no faces */
  struct sg_shading_item *item;
} sg_shadow;

/* GOOD, NO_MEMORY or STOPPED. Owner: sg_shadow_close(). */
sg_shading_end sg_shadow_open(const sg_shading *scene, const sg_cancel *cancel,
                              sg_shadow *out);
void sg_shadow_close(sg_shadow *shadow);

/* Of the light, in *part, what comes to p, a point of the model from which the
 * light is seen; `work` is one of the shadow's scene. False: no memory. */
bool sg_shadow_part(const sg_shadow *shadow, sg_shading_work *work,
                    const double p[3], uint32_t *part);

/* Dots of its picture to a unit of the model. */
double sg_shadow_scale(const sg_shadow *shadow);

#endif
