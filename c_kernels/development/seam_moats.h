/* seam_moats.h -- moats round vertices that a seam has to leave.
 *
 * Layer: kernel. Inexact. See seam_bound.h.
 */
#ifndef SG_SEAM_MOATS_H
#define SG_SEAM_MOATS_H

#include "joint.h"

/* Bends that are less are none, and sums that differ by less from a multiple of
 * 4 pi are balanced; radians. */
#define SG_BENT_LEAST 1e-9

typedef struct sg_bent_vertices {
  size_t vertices;
  double *bent; /* [vertices] whole turns less the angles; radians */
  bool *border; /* [vertices] */
} sg_bent_vertices;

/* True: bends of this sum may be all that a part of a seam has at its vertices:
 * it is a multiple of 4 pi. */
bool sg_bends_balance(double sum);

/* The sum of the widths of moats that grow round all unbalanced sets of
 * vertices at once, along the joints that are no lines, until they meet; then
 * the sets are one. Not `on`: only until they first meet, each vertex for
 * itself.
 *
 * Returns: false: no memory, or (*stopped) stopped by the cancellation. */
bool sg_moats_grow(const sg_bent_vertices *of, const sg_joints *joints, bool on,
                   const sg_cancel *cancel, double *width, bool *stopped);

#endif
