/* simplify_private.h -- a mesh while edges are contracted.
 *
 * Layer: kernel, private to simplify.c and simplify_open.c.
 */
#ifndef SG_SIMPLIFY_PRIVATE_H
#define SG_SIMPLIFY_PRIVATE_H

#include "engine/list.h"
#include "quadric.h"
#include "simplify.h"

typedef struct sg_simplify_edge {
  double cost;
  int32_t a, b; /* a < b */
  uint32_t stamp;
  int level; /* how often it has waited */
} sg_simplify_edge;

enum { SG_ON_BORDER = 1, SG_HELD = 2 };

/* Corner 3 t + k is vertex k of triangle t; those of a vertex hang together by
 * next. */
typedef struct sg_simplify_work {
  size_t vertices, triangles, left;
  double middle[3], size;
  double (*at)[3];
  int32_t *corner; /* [3 triangles]; -1: the triangle is gone */
  int32_t *next, *first, *last;
  int32_t *across; /* [3 triangles] the corner on the other side of the edge
                      that begins there, -1: none */
  int32_t *into;
  sg_quadric *quadric;
  const double *weight;
  uint32_t *stamp, *seen, round;
  unsigned char *flag;
  SG_LIST_OF(sg_simplify_edge) heap;
  const sg_cancel *cancel;
} sg_simplify_work;

/* The mesh as it comes, its quadrics, and which vertices are held. False: no
 * memory, or stopped. Owner: sg_simplify_close() in any case. */
bool sg_simplify_open(sg_simplify_work *w, const sg_simplify_mesh *mesh);
/* What is left of it. False: no memory. */
bool sg_simplify_result(const sg_simplify_work *w, sg_simplified *out);
/* The places of vertices and what went where are the result's; the rest is
 * freed. */
void sg_simplify_close(sg_simplify_work *w, sg_simplified *out);

/* A point in coordinates about the middle of the mesh, by its size. */
void sg_simplify_local(const sg_simplify_work *w, const double p[3],
                       double out[3]);

/* The ends of the edge that begins at corner c. */
static inline void
sg_simplify_ends(const sg_simplify_work *w, uint32_t c, int32_t *a, int32_t *b)
{
  *a = w->corner[c];
  *b = w->corner[c - c % 3 + (c + 1) % 3];
}

/* How many triangles vertex v has. */
size_t sg_simplify_corners(const sg_simplify_work *w, int32_t v);
/* Twice the area vector of triangle t, with vertex `moved` at `to`; and the sum
 * of the squares of its sides. Of size one. */
void sg_simplify_area(const sg_simplify_work *w, int32_t t, int32_t moved,
                      const double to[3], double n[3], double *squares);

#endif
