/* scene_private.h -- what scene_model.c and scene_lines.c share while they
 * build a model, and the arithmetic of all files of the scene.
 *
 * Layer: kernel.
 */
#ifndef SG_SCENE_PRIVATE_H
#define SG_SCENE_PRIVATE_H

#include "number/vector.h"
#include "rows/edge_pairs.h"
#include "scene_model.h"

enum { SG_SCENE_ASK = 4096 };

typedef struct sg_scene_builder {
  sg_scene_model *model;
  const sg_scene_cut *cut;
  size_t cuts;
  const sg_cancel *cancel;
  double (
      *normal)[3]; /* [polygons] the sum of its triangles' normals, scaled */
  bool *tangent;   /* [lines] it has two faces, whose surfaces are tangent */
  bool stopped;
} sg_scene_builder;

/* True from the moment when the cancellation says stop; asked now and then. */
static inline bool
sg_scene_stop(sg_scene_builder *b, size_t i)
{
  return i % SG_SCENE_ASK == 0 && (b->stopped |= sg_cancelled(b->cancel));
}

static inline void
sg_cross_at(const double a[3], const double b[3], const double c[3],
            double out[3])
{
  double u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  double w[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};

  out[0] = u[1] * w[2] - u[2] * w[1];
  out[1] = u[2] * w[0] - u[0] * w[2];
  out[2] = u[0] * w[1] - u[1] * w[0];
}

/* The lines of the model, with their uses and bends, its pieces of penetration
 * lines, and which segments are solid. False: no memory, or (b->stopped)
 * stopped by the cancellation. */
bool sg_scene_make_lines(sg_scene_builder *b);

/* The triangles that have the lines of polygons that are not flat, from the
 * uses. False: no memory. */
bool sg_scene_find_bent(sg_scene_builder *b);

/* Which of the segments of kind solid are solid indeed. pairs: of all edges.
 * False: no memory. */
bool sg_scene_find_solids(sg_scene_builder *b, const sg_edge_pairs *pairs);

#endif
