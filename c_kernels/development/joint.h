/* joint.h -- which sides of faces belong together, and how they meet.
 *
 * Layer: kernel. Partners run between the same two vertices, in opposite
 * directions. Where an edge has more than two faces, they are paired by angle
 * round it: each face with the next one towards its inside, so that sheets
 * which only touch there stay apart. A side that is left over is a border.
 * Edges that are not real have no joints.
 */
#ifndef SG_JOINT_H
#define SG_JOINT_H

#include "flat_face.h"

typedef struct sg_joint { /* what joining asks for, in a line of memory */
  uint32_t side[2];       /* that of the lower edge place first */
  uint32_t face[2];       /* of these */
  uint32_t corner[2][2];  /* where each begins and ends */
  int32_t vertex[2];      /* where the first does, in the segment */
  double length;          /* model units */
  double angle;           /* degrees between the normals; > 0: convex */
  bool line;              /* both sides in one face: a penetration line */
  bool flat;              /* the smaller face lies in the plane of the other */
} sg_joint;

#define SG_NO_JOINT UINT32_MAX

typedef struct sg_joints {
  size_t n;
  sg_joint *joint;   /* [n] by the place of the first edge */
  uint32_t *of_side; /* [sides] or SG_NO_JOINT: a border, or not real */
} sg_joints;

/* Inexact except for the pairing, which looks at vertices; where more than two
 * faces meet it looks at angles. Faces without area take the normal of the face
 * at their longest side. `tolerance`: how far a vertex may be off a plane.
 *
 * Returns: false: no memory, or (*stopped) stopped by the cancellation.
 * Owner:   sg_joints_clear() in any case. */
bool sg_joints_make(sg_flat_faces *faces, const sg_dense *dense,
                    double tolerance, const sg_cancel *cancel, sg_joints *out,
                    bool *stopped);
void sg_joints_clear(sg_joints *joints);

#endif
