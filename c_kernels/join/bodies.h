/* bodies.h -- the components of a segment, connected by vertices.
 *
 * Layer: kernel. A BODY is a largest set of leaf triangles that go from one to
 * the other over corners they share: a shell, or shells that have a vertex in
 * common.
 */
#ifndef SG_BODIES_H
#define SG_BODIES_H

#include "leaf_tree.h"

typedef struct sg_bodies {
  const sg_id_rows *vertex; /* of the tree */
  size_t n;
  uint32_t *of; /* [places of the tree's vertices] the body, from 0; by the
                   lowest vertices. One of no triangle is a body alone */
} sg_bodies;

/* The bodies of the triangles of a tree, which must stay.
 *
 * Returns: false: no memory, or the cancellation said stop.
 * Owner:   sg_bodies_clear() in any case. */
bool sg_bodies_find(const sg_leaf_tree *tree, const sg_leaf_views *views,
                    const sg_cancel *cancel, sg_bodies *out);
void sg_bodies_clear(sg_bodies *bodies);

/* The body of vertex v (an id), which is one of the tree's. */
static inline uint32_t
sg_bodies_of(const sg_bodies *bodies, int32_t v)
{
  return bodies->of[sg_id_rows_place(bodies->vertex, v)];
}

#endif
