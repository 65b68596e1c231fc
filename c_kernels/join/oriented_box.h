/* oriented_box.h -- boxes round points, along their own axes.
 *
 * Layer: kernel. Long thin solids that run askew have boxes along x, y and z
 * which overlap wherever the solids are; these boxes do not. Inexact, except
 * what is said of the answer.
 */
#ifndef SG_ORIENTED_BOX_H
#define SG_ORIENTED_BOX_H

#include <stdbool.h>
#include <stddef.h>

typedef struct sg_oriented_box {
  double axis[3][3];   /* of length 1, the longest way of the points first */
  double corner[8][3]; /* round all points, up to rounding */
} sg_oriented_box;

/* Where point i is. */
typedef void sg_oriented_point(const void *data, size_t i, double out[3]);

/* Requires n > 0. */
void sg_oriented_box_make(size_t n, sg_oriented_point *at, const void *data,
                          sg_oriented_box *out);

/* True if no point in one box is as near as `reach` to one in the other: surely
 * so, whatever was rounded. False says nothing. */
bool sg_oriented_boxes_apart(const sg_oriented_box *a, const sg_oriented_box *b,
                             double reach);

/* The axes along which many triangles run. All zero to begin with. */
typedef struct sg_run {
  double sum[3][3]; /* of what their edges are in each two directions */
  bool askew;       /* set by sg_run_end(): mostly one way, across x, y or z */
  double axis[3][3];
} sg_run;

void sg_run_add(sg_run *run, const double triangle[3][3]);
void sg_run_end(sg_run *run);

/* Where p is along the axes, up to 2^-48 of the size of its coordinates; p
 * itself, if nothing is askew. */
static inline void
sg_run_turn(const sg_run *run, const double p[3], double out[3])
{
  for (int k = 0; k < 3; k++) {
    const double *a = run->axis[k];

    out[k] = run->askew ? a[0] * p[0] + a[1] * p[1] + a[2] * p[2] : p[k];
  }
}

#endif
