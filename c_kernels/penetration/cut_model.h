/* cut_model.h -- the leaf triangles near a cut.
 *
 * Layer: kernel. What a penetration touches and no more: vertices, triangles
 * and the edges of curves, by numbers of its own (0, 1, 2, ... in the order of
 * adding). The rest of the model stays where it is; a vertex that is asked for
 * is fetched from there.
 */
#ifndef SG_CUT_MODEL_H
#define SG_CUT_MODEL_H

#include "rows/key_table.h"

#include <stdbool.h>

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

/* Where vertex v of segment s is. False: there is none. */
typedef bool sg_fetch_vertex(void *data, int32_t s, int32_t v, double at[3]);

typedef struct sg_cut_model {
  sg_leaf_vertex *vertex;
  sg_leaf_triangle *triangle;
  sg_leaf_edge *edge;
  size_t vertices, triangles, edges;
  size_t vertex_room, triangle_room, edge_room;
  sg_key_table vertex_number; /* of (s, v) */
  sg_fetch_vertex *fetch;     /* null: only what was added */
  void *fetch_data;
} sg_cut_model;

void sg_cut_model_init(sg_cut_model *model);
void sg_cut_model_clear(sg_cut_model *model);

/* Adding; corners that are not there yet are fetched. False: no memory. A
 * triangle or edge with an unknown corner is refused by *known = false; else it
 * has the number model->triangles - 1, or model->edges - 1. */
bool sg_cut_model_vertex(sg_cut_model *model, int32_t s, int32_t v,
                         const double at[3]);
bool sg_cut_model_triangle(sg_cut_model *model, int32_t s, int32_t p, int32_t t,
                           const int32_t v[3], bool *known);
bool sg_cut_model_edge(sg_cut_model *model, int32_t s, int32_t e,
                       const int32_t v[2], bool *known);

/* The number of vertex v of segment s; SG_NO_KEY: it was not added. */
uint32_t sg_cut_model_find(const sg_cut_model *model, int32_t s, int32_t v);

/* The same, fetched if it was not; SG_NO_KEY: there is none, or no memory. */
uint32_t sg_cut_model_fetch(sg_cut_model *model, int32_t s, int32_t v);

/* The corners of a triangle, as the cut kernel wants them. */
void sg_cut_model_corners(const sg_cut_model *model, uint32_t triangle,
                          double out[3][3]);

#endif
