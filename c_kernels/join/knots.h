/* knots.h -- where the surface of a segment is not one sheet.
 *
 * Layer: kernel. At a plain vertex the triangles go round it once, each edge
 * between two of them. A KNOT is any other: the end of an edge of more than
 * two triangles, a vertex that two sheets have in common, one at a border.
 * What hangs together may change its mind there, about what is inside.
 */
#ifndef SG_KNOTS_H
#define SG_KNOTS_H

#include "leaf_tree.h"

typedef struct sg_knots {
  size_t vertices, edges;
  int32_t *vertex;    /* [vertices]: ids of knots */
  int32_t (*edge)[2]; /* [edges]: ids; from one to the other runs more than one
                         triangle. Both ends are knots */
} sg_knots;

/* Of the triangles of a tree. False: no memory, or the poll said stop. About
 * 60 ns a triangle. Owner: sg_knots_clear() in any case. */
bool sg_knots_find(const sg_leaf_tree *tree, const sg_leaf_views *views,
                   const sg_poll *poll, sg_knots *out);
void sg_knots_clear(sg_knots *knots);

#endif
