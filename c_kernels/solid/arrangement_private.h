/* arrangement_private.h -- the inside of arrangement.h.
 *
 * Layer: kernel. Components are found by union of NODES: first one for
 * each vertex of each leaf, by its place in the leaf's table of ids, then one
 * for each polygon that is not cut but has a vertex on another leaf, and one
 * for each cell of those that are cut.
 */
#ifndef SG_ARRANGEMENT_PRIVATE_H
#define SG_ARRANGEMENT_PRIVATE_H

#include "arrangement.h"
#include "rows/disjoint.h"
#include "rows/id_set.h"

/* A leaf. */
typedef struct sg_arranged {
  int32_t s;
  const sg_leaf_tree *tree;
  uint32_t node;       /* of its first vertex */
  const uint32_t *row; /* [rows]: its leaf triangles, rows of t/6 */
  size_t rows;
  uint32_t *component; /* [rows]: of the leaf's, from 0; SG_NO_KEY: of a
                          polygon that is cut */
  sg_id_set cut;       /* polygons */
  bool wanted, surface;
  size_t first_cell, cells;
  sg_made_vertex *made; /* [mades]: those of cells, by name */
  size_t mades;
  int32_t first_made;       /* the name of made[0] */
  size_t first_part, parts; /* its components */
} sg_arranged;

/* A triangle of a cell, corners by name in the leaf. */
typedef struct sg_cell_triangle {
  int32_t v[3];
  uint8_t auxiliary; /* bit k: the edge after corner k */
  uint8_t chord;     /* the same: it is no real edge of the polygon */
} sg_cell_triangle;

/* A piece of a polygon that is cut. */
typedef struct sg_cell {
  uint32_t leaf; /* place */
  int32_t p;
  int axis;                 /* along which its polygon is seen */
  size_t first, n;          /* triangles */
  uint32_t node, component; /* the second: of the leaf's */
} sg_cell;

/* A leaf triangle of a polygon that is cut. */
typedef struct sg_cut_row_of {
  uint32_t leaf;
  int32_t p;
  uint32_t row;
} sg_cut_row_of;

/* A component under way. */
typedef struct sg_part {
  uint32_t leaf;
  bool cut; /* `of` is a cell, else the place of a row */
  size_t of;
  int32_t p;
  uint32_t row; /* the leaf triangle that `at` is inside */
  sg_point at;
  int normal[3]; /* signs of the leaf triangle's normal */
  unsigned tries;
  bool unknown, second, again;
  size_t side, sides;
} sg_part;

struct sg_arrangement {
  sg_leaves leaves;
  sg_arranged *leaf; /* [leaves.n] */
  sg_segment_rows rows;
  uint8_t *touched; /* [vertex_nodes]: on another leaf, or on a line */
  size_t vertex_nodes;
  sg_key_table cut_line;      /* leaf, two points: a line runs there */
  sg_key_table barrier;       /* leaf, two names: as if a line ran there */
  sg_key_table auxiliary;     /* leaf, two names: an edge, and no line */
  sg_key_table has_triangles; /* leaf, polygon: the last of its triangles in the
                                 cut model */
  uint32_t *next_of_polygon;  /* [model.triangles] the one before; SG_NO_KEY:
                                 there is none */
  sg_cell *cell;
  sg_cell_triangle *triangle;
  size_t cells, cell_room, triangles, triangle_room;
  sg_cut_row_of *cut_row; /* by leaf, polygon */
  size_t cut_rows, cut_row_room;
  uint32_t *parent; /* [nodes] */
  size_t nodes, node_room;
  sg_part *part; /* [parts]: the components */
  size_t parts;
  sg_side *side;
  size_t sides, side_room;
};

/* The place of a segment among the leaves; SG_NO_KEY: it is none. */
uint32_t sg_arrangement_leaf(const sg_arrangement *a, int32_t s);

/* The node of vertex v of a leaf; SG_NO_KEY: a cut made it. */
static inline uint32_t
sg_arrangement_node(const sg_arranged *leaf, int32_t v)
{
  size_t place = sg_id_rows_place(&leaf->tree->vertex, v);

  return place == SG_NO_ID_PLACE ? SG_NO_KEY : leaf->node + (uint32_t)place;
}

/* The same of a vertex that is known to be the leaf's own. */
static inline uint32_t
sg_arrangement_own_node(const sg_arranged *leaf, int32_t v)
{
  return leaf->node + (uint32_t)sg_id_rows_slot(&leaf->tree->vertex, v);
}

bool sg_arrangement_is_line(const sg_arrangement *a, uint32_t leaf, int32_t v1,
                            int32_t v2);

/* What a row of t/6 says: the polygon, and the corners. */
static inline int32_t
sg_arranged_polygon(const sg_arrangement *a, uint32_t row)
{
  return sg_view_int(&a->leaves.views->t, 1, row);
}

static inline void
sg_arranged_corners(const sg_arrangement *a, uint32_t row, int32_t v[3])
{
  for (unsigned c = 0; c < 3; c++) {
    v[c] = sg_view_int(&a->leaves.views->t, 3 + c, row);
  }
}

/* A new node, connected with nothing; SG_NO_KEY: no memory. */
uint32_t sg_arrangement_new_node(sg_arrangement *a);
static inline uint32_t
sg_arrangement_root(sg_arrangement *a, uint32_t node)
{
  return sg_disjoint_root(a->parent, node);
}
void sg_arrangement_hang(sg_arrangement *a, uint32_t node, uint32_t other);

/* The vertices that cuts made (arrangement_made.c), after cells are in order.
 * False: no memory, or stopped. */
bool sg_arrangement_find_made(sg_arrangement *a, sg_pool *pool,
                              const sg_cancel *cancel);

/* Components from the nodes (arrangement_part.c). */
bool sg_arrangement_find_auxiliary(sg_arrangement *a, sg_pool *pool,
                                   const sg_cancel *cancel);
bool sg_arrangement_flood(sg_arrangement *a, sg_pool *pool,
                          const sg_cancel *cancel);
bool sg_arrangement_find_parts(sg_arrangement *a, sg_pool *pool,
                               const sg_cancel *cancel);

/* Another point inside a component, by part->tries (arrangement_point.c).
 * False: no memory. */
bool sg_arrangement_point(const sg_arrangement *a, sg_part *part);

#endif
