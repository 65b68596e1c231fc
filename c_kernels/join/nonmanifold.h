/* nonmanifold.h -- where the surface of a segment is not one sheet.
 *
 * Layer: kernel. At a plain vertex the triangles go round it once, each edge
 * between two of them. A NON-MANIFOLD vertex is any other: the end of an edge
 * of more than two triangles, a vertex that two sheets have in common, one at a
 * border. What is connected may change its mind there, about what is inside.
 */
#ifndef SG_NONMANIFOLD_H
#define SG_NONMANIFOLD_H

#include "leaf_tree.h"

typedef struct sg_nonmanifold {
  size_t vertices, edges;
  int32_t *vertex;    /* [vertices]: ids of non-manifold vertices */
  int32_t (*edge)[2]; /* [edges]: ids; from one to the other runs more than one
                         triangle. Both ends are such vertices */
} sg_nonmanifold;

/* Of the triangles of a tree. False: no memory, or the cancellation said stop.
 * About 60 ns a triangle. Owner: sg_nonmanifold_clear() in any case. */
bool sg_nonmanifold_find(const sg_leaf_tree *tree, const sg_leaf_views *views,
                         const sg_cancel *cancel, sg_nonmanifold *out);
void sg_nonmanifold_clear(sg_nonmanifold *nonmanifold);

#endif
