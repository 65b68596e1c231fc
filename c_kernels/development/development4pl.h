/* development4pl.h -- a segment being laid flat, behind a Prolog handle.
 *
 * Layer: glue. Include it before SWI-Prolog.h.
 */
#ifndef SG_DEVELOPMENT4PL_H
#define SG_DEVELOPMENT4PL_H

#include "engine/world4pl.h"

#include "lay.h"

typedef struct sg_development {
  int32_t s; /* the segment; 0: closed */
  sg_dense dense;
  sg_flat_faces faces;
  sg_joints joints;
  sg_flattening flattening;
  sg_layout layout; /* once it is laid out */
  bool laid;
  double tolerance;
} sg_development;

/* The open development that t names: type_error(flattening, t),
 * existence_error(flattening, t) if it is closed. */
int sg_get_development_ex(term_t t, sg_development **out);

/* permission_error(lay, flattening, Flattening) if nothing is laid out yet. */
int sg_development_is_laid_ex(const sg_development *d, term_t handle);

/* The place of the joint that t numbers, from 1: existence_error(joint, t). */
int sg_get_joint_ex(term_t t, const sg_development *d, uint32_t *out);

atom_t sg_joint_state_atom(sg_joint_state state);

/* The id of the polygon of the pattern that a face becomes: that of its
 * polygon, or one after the largest where that is in triangles. */
int32_t sg_development_polygon(const sg_development *d, uint32_t face);

/* The id of the edge that a side is; of a chord one after the largest. */
int32_t sg_development_edge(const sg_development *d, uint32_t side);

#endif
