/* apart.h -- triangles that have nothing in common, told cheaply.
 *
 * Layer: kernel. Most pairs of triangles whose boxes overlap are apart by the
 * plane of one of them. What that asks for is made once a triangle.
 */
#ifndef SG_APART_H
#define SG_APART_H

#include "bvh.h"

typedef struct sg_apart {
  sg_box box;     /* of the triangle, exact */
  double from[3]; /* a corner */
  double n[3];    /* across its plane, rounded */
  double limit;   /* what is higher along n is beyond the plane, */
  double slack;   /* and this for each unit that it is away from the corner */
} sg_apart;

/* Of a triangle; `reach` is how near things touch. */
void sg_apart_make(const double corner[3][3], double reach, sg_apart *out);

/* True: the corners of `other` are all on one side of the plane of `of`, each
 * more than four reaches away, whatever rounding does. False says nothing. */
bool sg_apart_by_plane(const sg_apart *of, const double *const other[3]);

#endif
