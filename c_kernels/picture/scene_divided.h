/* scene_divided.h -- triangles that an outline on a smooth surface divides.
 *
 * Layer: kernel. In the picture an outline that has risen to a known surface
 * (contour.h) runs beside the triangle that it crosses, as the surface does.
 * What hides lines there is the surface: instead of such a triangle the three
 * are masks that the two ends of the piece divide it into,
 *
 *     A on the side from corner p to q, B on that from r to p:
 *     A B p,  A q r,  A r B   (or A q B,  q r B, if these alone do not fold)
 *
 * which are turned as it is. Neighbours have the same ends; so what hides ends
 * where the outline runs, and what is behind it ends there.
 */
#ifndef SG_SCENE_DIVIDED_H
#define SG_SCENE_DIVIDED_H

#include "scene.h"

typedef struct sg_divided_part {
  uint32_t of;  /* the triangle: its place in the model */
  int32_t v[3]; /* places in sg_scene.at; the first is no vertex of the model */
} sg_divided_part;

typedef struct sg_divided {
  bool *is; /* [triangles] divided; null: none is */
  sg_divided_part *part;
  size_t n;
} sg_divided;

/* The triangles that the added lines of the input divide. False: no memory.
 * Owner: the caller, sg_divided_clear() in any case. */
bool sg_divided_init(sg_divided *divided, const sg_scene_input *in);
void sg_divided_clear(sg_divided *divided);

static inline bool
sg_divided_has(const sg_divided *divided, size_t triangle)
{
  return divided->is && divided->is[triangle];
}

#endif
