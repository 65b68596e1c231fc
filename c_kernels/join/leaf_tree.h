/* leaf_tree.h -- the tree of what a segment has to be cut: its leaf triangles,
 * or its edges if it is a curve.
 *
 * Layer: kernel. A tree refers to rows of the relations it was made from and
 * copies nothing of them: it is right for every version that shows the same
 * rows. About 38 bytes a triangle: 36 for its box and the boxes above, 2 for
 * the table of vertices.
 */
#ifndef SG_LEAF_TREE_H
#define SG_LEAF_TREE_H

#include "bvh.h"
#include "oriented_box.h"
#include "rows/by_segment.h"

/* Views of v/5, e/5 and t/6, of one version. */
typedef struct sg_leaf_views {
  sg_view v, e, t;
} sg_leaf_views;

typedef struct sg_leaf_tree {
  int32_t s;
  bool curve;          /* edges, not triangles */
  sg_box box;          /* round all its vertices; empty: it has none */
  sg_id_rows vertex;   /* rows of v/5 */
  sg_bvh *boxes;       /* items: rows of t/6, or of e/5 */
  uint32_t begin, end; /* all of them are from row `begin` to before `end` */
} sg_leaf_tree;

/* The trees of n segments (ascending numbers), in out[0 .. n - 1]. A segment
 * without triangles is a curve (and may have no edges either). Edges and
 * triangles with a vertex that is not there are left out.
 *
 * Returns: false: no memory, or the cancellation said stop; out is all null
 * then. Owner:   the caller, each to be closed. */
bool sg_leaf_trees_grow(const sg_leaf_views *views, const int32_t *wanted,
                        size_t n, sg_pool *pool, const sg_cancel *cancel,
                        sg_leaf_tree **out);
void sg_leaf_tree_close(sg_leaf_tree *tree);

/* The boxes round the vertices of n segments (ascending numbers), which is all
 * that is needed to see which of them are near each other. False: no memory,
 * or the cancellation said stop. */
bool sg_leaf_boxes(const sg_view *vertices, const int32_t *wanted, size_t n,
                   sg_pool *pool, const sg_cancel *cancel, sg_box *out);

/* The boxes along their own axes of n segments (ascending numbers) that have
 * vertices. The same. */
bool sg_leaf_oriented_boxes(const sg_view *vertices, const int32_t *wanted,
                            size_t n, sg_pool *pool, const sg_cancel *cancel,
                            sg_oriented_box *out);

size_t sg_leaf_tree_bytes(const sg_leaf_tree *tree);

/* Where the vertices of a tree are, less `from`, by their places in its table:
 * one look in memory where the columns take three, for those who go over all
 * triangles. NaN: no vertex has this place. Null: no memory, or the
 * cancellation said stop. Owner: the caller, free(). */
double (*sg_leaf_points(const sg_leaf_tree *tree, const sg_leaf_views *views,
                        const double from[3], sg_pool *pool,
                        const sg_cancel *cancel))[3];

/* What a row of t/6 or e/5 says. */
typedef struct sg_leaf {
  int32_t id, p; /* of the triangle and its polygon; of the edge, and 0 */
  int32_t v[3];  /* corners; of an edge start and end */
} sg_leaf;

static inline sg_leaf
sg_leaf_at(const sg_leaf_tree *tree, const sg_leaf_views *views, uint32_t row)
{
  const sg_view *view = tree->curve ? &views->e : &views->t;
  sg_leaf leaf = {0};

  if (tree->curve) {
    leaf.id = sg_view_int(view, 1, row);
    leaf.v[0] = sg_view_int(view, 2, row);
    leaf.v[1] = sg_view_int(view, 3, row);
    return leaf;
  }
  leaf.p = sg_view_int(view, 1, row);
  leaf.id = sg_view_int(view, 2, row);
  for (unsigned k = 0; k < 3; k++) {
    leaf.v[k] = sg_view_int(view, 3 + k, row);
  }
  return leaf;
}

/* Where vertex v of the tree's segment is. False: there is none. */
static inline bool
sg_leaf_vertex_at(const sg_leaf_tree *tree, const sg_leaf_views *views,
                  int32_t v, double out[3])
{
  uint32_t row = sg_id_rows_find(&tree->vertex, v);

  if (row == SG_NO_ID_ROW) {
    return false;
  }
  sg_view_point(&views->v, row, out);
  return true;
}

#endif
