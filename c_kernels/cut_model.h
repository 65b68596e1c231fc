/* cut_model.h -- the leaf triangles that are to be cut, and their trees.
 *
 * Layer: kernel. A flat copy of what a penetration needs: vertices, triangles
 * and the edges of curves, by numbers of its own (0, 1, 2, ... in the order
 * of adding), with one tree of boxes for each segment. It does not change
 * while the store behind it does.
 */
#ifndef SG_CUT_MODEL_H
#define SG_CUT_MODEL_H

#include "bvh.h"
#include "key_table.h"

typedef struct sg_leaf_vertex {
  int32_t s, v;
  double at[3];
} sg_leaf_vertex;

typedef struct sg_leaf_triangle {
  int32_t s, p, t;
  uint32_t v[3]; /* vertex numbers, counter-clockwise from outside */
} sg_leaf_triangle;

/* A directed edge of a curve. */
typedef struct sg_leaf_edge {
  int32_t s, e;
  uint32_t v[2];
} sg_leaf_edge;

/* What a tree stands for: `n` triangles or edges, by number. */
typedef struct sg_leaf_segment {
  int32_t s;
  bool curve;
  size_t n, room;
  uint32_t *item;
  sg_bvh *tree;
} sg_leaf_segment;

typedef struct sg_cut_model {
  sg_leaf_vertex *vertex;
  sg_leaf_triangle *triangle;
  sg_leaf_edge *edge;
  sg_leaf_segment *segment;
  size_t vertices, triangles, edges, segments;
  size_t vertex_room, triangle_room, edge_room, segment_room;
  sg_key_table vertex_number;  /* of (s, v) */
  sg_key_table segment_number; /* of s */
} sg_cut_model;

void sg_cut_model_init(sg_cut_model *model);
void sg_cut_model_clear(sg_cut_model *model);

/* Adding. False: no memory. The corners must have been added before; a
 * triangle or edge with an unknown corner is refused by *known = false. */
bool sg_cut_model_vertex(sg_cut_model *model, int32_t s, int32_t v,
                         const double at[3]);
bool sg_cut_model_triangle(sg_cut_model *model, int32_t s, int32_t p, int32_t t,
                           const int32_t v[3], bool *known);
bool sg_cut_model_edge(sg_cut_model *model, int32_t s, int32_t e,
                       const int32_t v[2], bool *known);

/* The number of vertex v of segment s, SG_NO_KEY: none. */
uint32_t sg_cut_model_find(const sg_cut_model *model, int32_t s, int32_t v);

/* Makes the trees, when everything is added. False: no memory or stopped. */
bool sg_cut_model_plant(sg_cut_model *model, const sg_poll *poll);

/* The tree of segment s; null: it has neither triangles nor curve edges. */
const sg_leaf_segment *sg_cut_model_segment(const sg_cut_model *model,
                                            int32_t s);

/* The corners of a triangle, as the cut kernel wants them. */
void sg_cut_model_corners(const sg_cut_model *model, uint32_t triangle,
                          double out[3][3]);

/* A walk over the candidates of two segments: pairs with overlapping boxes,
 * as triangle (or curve edge) numbers of a and of b. */
typedef struct sg_candidate_pairs {
  const sg_leaf_segment *a, *b;
  sg_bvh_pairs pairs;
} sg_candidate_pairs;

void sg_candidate_pairs_init(sg_candidate_pairs *walk, const sg_leaf_segment *a,
                             const sg_leaf_segment *b);
bool sg_candidate_pairs_next(sg_candidate_pairs *walk, uint32_t *a,
                             uint32_t *b);

#endif
