/* smooth_private.h -- what smooth.c and smooth_curved.c share.
 *
 * Layer: kernel.
 */
#ifndef SG_SMOOTH_PRIVATE_H
#define SG_SMOOTH_PRIVATE_H

#include "smooth.h"

#include <math.h>

#define SG_DEGREES (180.0 / acos(-1.0))

enum { SG_SMOOTH_ASK = 4096 };

typedef struct sg_smooth_builder {
  const sg_dense *in;
  const sg_smooth_input *input;
  sg_smooth *out;
  const sg_cancel *cancel;
  sg_known_surfaces known; /* none, if all facets are to be seen */
  double unit;       /* what differences are multiplied by: see unit_of() */
  double (*area)[3]; /* [polygons]: normals, as long as twice the area */
  double *bend;      /* [3 * triangles]: degrees at smooth sides */
  double (*look)[3]; /* [3 * triangles]: the way the surface looks there, as
                        long as the area of the face */
  uint32_t *sheet;   /* [triangles]: another one of it, in the end its root */
  uint32_t *root;    /* [3 * triangles]: the same of corners and fans */
} sg_smooth_builder;

static inline uint32_t
sg_smooth_next(uint32_t corner)
{
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}

static inline uint32_t
sg_smooth_vertex(const sg_smooth_builder *b, uint32_t corner)
{
  return (uint32_t)b->in->corner[corner / 3][corner % 3];
}

static inline const double *
sg_smooth_at(const sg_smooth_builder *b, uint32_t corner)
{
  return b->in->at[sg_smooth_vertex(b, corner)];
}

/* From q to p, times the unit. */
static inline void
sg_smooth_difference(const sg_smooth_builder *b, const double p[3],
                     const double q[3], double out[3])
{
  for (int k = 0; k < 3; k++) {
    out[k] = (p[k] - q[k]) * b->unit;
  }
}

static inline bool
sg_smooth_stop(const sg_smooth_builder *b, size_t i)
{
  return i % SG_SMOOTH_ASK == 0 && sg_cancelled(b->cancel);
}

/* The known surface of a corner, less than 0: none. */
static inline int32_t
sg_smooth_surface(const sg_smooth_builder *b, uint32_t corner)
{
  return sg_known_surface_of(&b->known, b->in->polygon_of[corner / 3]);
}

/* Which sheets are curved, of their roots alone. False: stopped, or no memory.
 */
bool sg_smooth_find_bent(sg_smooth_builder *b, bool *memory);
/* Then: which triangles are of curved sheets, and of coarse ones. */
bool sg_smooth_find_coarse(sg_smooth_builder *b, bool *memory);

#endif
