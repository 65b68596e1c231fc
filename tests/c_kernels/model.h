/* model.h -- small models for the tests of pictures: polygons are entered as
 * corner lists and become the arrays of a scene.
 */
#ifndef SG_TEST_MODEL_H
#define SG_TEST_MODEL_H

#include "../../c_kernels/scene.h"
#include "../../c_kernels/view.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MODEL_MOST = 60000 };

typedef struct model {
  sg_scene_segment segment[64];
  sg_scene_vertex vertex[MODEL_MOST];
  sg_scene_triangle triangle[MODEL_MOST];
  sg_scene_edge edge[MODEL_MOST];
  sg_scene_use use[MODEL_MOST];
  sg_scene_cut cut[MODEL_MOST];
  sg_scene_input in;
  int32_t s, v, p; /* the last ids given; e and t run through */
} model;

static inline model *
model_new(void)
{
  model *m = calloc(1, sizeof *m);

  m->in = (sg_scene_input){.segment = m->segment,
                           .vertex = m->vertex,
                           .triangle = m->triangle,
                           .edge = m->edge,
                           .use = m->use,
                           .cut = m->cut,
                           .depth = 1.0,
                           .tolerance = 1e-9};
  return m;
}

static inline void
model_segment(model *m, bool solid)
{
  m->segment[m->in.segments++] = (sg_scene_segment){++m->s, 0, solid};
  m->v = 0;
}

static inline int32_t
model_vertex(model *m, double x, double y, double z)
{
  m->vertex[m->in.vertices++] =
      (sg_scene_vertex){m->s, ++m->v, {x, y, z}, {0, 0, 0}};
  return m->v;
}

static inline void
model_edge(model *m, int32_t a, int32_t b)
{
  m->edge[m->in.edges] =
      (sg_scene_edge){m->s, (int32_t)m->in.edges + 1, a, b, true};
  m->in.edges++;
}

/* A convex polygon. */
static inline void
model_polygon(model *m, int n, const int32_t *v)
{
  m->p++;
  for (int i = 0; i < n; i++) {
    model_edge(m, v[i], v[(i + 1) % n]);
    m->use[m->in.uses++] = (sg_scene_use){m->s, (int32_t)m->in.edges, m->p};
    if (i >= 2) {
      m->triangle[m->in.triangles] = (sg_scene_triangle){
          m->s, m->p, (int32_t)m->in.triangles + 1, {v[0], v[i - 1], v[i]}};
      m->in.triangles++;
    }
  }
}

/* Eight corners: i & 1 at high x, & 2 high y, & 4 high z. */
static inline void
model_hexahedron(model *m, double c[8][3])
{
  static const int32_t face[6][4] = {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5},
                                     {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}};

  for (int i = 0; i < 8; i++) {
    model_vertex(m, c[i][0], c[i][1], c[i][2]);
  }
  for (int i = 0; i < 6; i++) {
    model_polygon(m, 4, face[i]);
  }
}

static inline void
model_box(model *m, double x, double y, double z, double dx, double dy,
          double dz)
{
  double c[8][3];

  model_segment(m, true);
  for (int i = 0; i < 8; i++) {
    c[i][0] = x + (i & 1 ? dx : 0);
    c[i][1] = y + (i & 2 ? dy : 0);
    c[i][2] = z + (i & 4 ? dz : 0);
  }
  model_hexahedron(m, c);
}

/* A surface of quadrangles z = f(x, y) over n x n cells of [-1,1]^2. */
static inline void
model_sheet(model *m, int n, double (*f)(double, double))
{
  model_segment(m, false);
  for (int j = 0; j <= n; j++) {
    for (int i = 0; i <= n; i++) {
      double x = 2.0 * i / n - 1, y = 2.0 * j / n - 1;
      model_vertex(m, x, y, f(x, y));
    }
  }
  for (int j = 0; j < n; j++) {
    for (int i = 0; i < n; i++) {
      int32_t a = j * (n + 1) + i + 1, b = a + n + 1;
      model_polygon(m, 3, (int32_t[]){a, a + 1, b + 1});
      model_polygon(m, 3, (int32_t[]){a, b + 1, b});
    }
  }
}

/* Fills the screen columns; central when range is given. */
static inline void
model_project(model *m, double theta, double phi, double rho, bool central)
{
  sg_range range = sg_range_empty();
  sg_eye eye;

  sg_eye_init(&eye, theta, phi, rho);
  for (size_t i = 0; i < m->in.vertices; i++) {
    sg_eye_point(&eye, m->vertex[i].model, m->vertex[i].screen);
    sg_range_add(&range, &eye, m->vertex[i].screen[2]);
  }
  for (size_t i = 0; central && i < m->in.vertices; i++) {
    sg_central_point(&eye, &range, m->vertex[i].screen);
  }
  m->in.depth = central ? sg_central_depth(&range) : 1.0;
}

#endif
