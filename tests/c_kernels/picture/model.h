/* model.h -- small models for the tests of pictures: polygons are entered as
 * corner lists and become the arrays of a scene.
 */
#ifndef SG_TEST_MODEL_H
#define SG_TEST_MODEL_H

#include "picture/scene.h"
#include "picture/view.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MODEL_MOST = 60000 };

typedef struct model_corner {
  int32_t s, v;
  double model[3], screen[3];
} model_corner;

typedef struct model_triangle {
  int32_t s, p, t;
  int32_t v[3];
} model_triangle;

typedef struct model_side {
  int32_t s, e, v1, v2;
  bool real;
  int32_t p; /* 0: of no polygon */
} model_side;

/* Segments 1, 2, ...; vertices begin with 1 in each, polygons, edges and
 * triangles run through. */
typedef struct model {
  bool solid[64]; /* by segment */
  model_corner vertex[MODEL_MOST];
  model_triangle triangle[MODEL_MOST];
  model_side edge[MODEL_MOST];
  sg_scene_cut cut[MODEL_MOST]; /* of places: the order of model_vertex() */
  size_t vertices, triangles, edges, cuts;
  double depth;
  int32_t s, v, p; /* the last ids given */
} model;

static inline model *
model_new(void)
{
  model *m = calloc(1, sizeof *m);

  m->depth = 1.0;
  return m;
}

static inline void
model_segment(model *m, bool solid)
{
  m->solid[++m->s] = solid;
  m->v = 0;
}

static inline int32_t
model_vertex(model *m, double x, double y, double z)
{
  m->vertex[m->vertices++] = (model_corner){m->s, ++m->v, {x, y, z}, {0, 0, 0}};
  return m->v;
}

static inline void
model_edge(model *m, int32_t a, int32_t b)
{
  m->edge[m->edges] = (model_side){m->s, (int32_t)m->edges + 1, a, b, true, 0};
  m->edges++;
}

/* A convex polygon. */
static inline void
model_polygon(model *m, int n, const int32_t *v)
{
  m->p++;
  for (int i = 0; i < n; i++) {
    model_edge(m, v[i], v[(i + 1) % n]);
    m->edge[m->edges - 1].p = m->p;
    if (i >= 2) {
      m->triangle[m->triangles] = (model_triangle){
          m->s, m->p, (int32_t)m->triangles + 1, {v[0], v[i - 1], v[i]}};
      m->triangles++;
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
  for (size_t i = 0; i < m->vertices; i++) {
    sg_eye_point(&eye, m->vertex[i].model, m->vertex[i].screen);
    sg_range_add(&range, &eye, m->vertex[i].screen[2]);
  }
  for (size_t i = 0; central && i < m->vertices; i++) {
    sg_central_point(&eye, &range, m->vertex[i].screen);
  }
  m->depth = central ? sg_central_depth(&range) : 1.0;
}

/* Where the things of each segment begin, from the segment of each. */
static inline uint32_t *
model_begins(const model *m, const int32_t *s, size_t size, size_t n)
{
  uint32_t *begin = calloc((size_t)m->s + 1, sizeof *begin);

  for (size_t i = 0; i < n; i++) {
    begin[*(const int32_t *)((const char *)s + i * size)]++;
  }
  for (int32_t i = 0; i < m->s; i++) {
    begin[i + 1] += begin[i];
  }
  return begin;
}

static inline int32_t
model_place(const sg_dense *d, int32_t s, int32_t v)
{
  return (int32_t)d->vertex_begin[s - 1] + v - 1;
}

static inline void
model_dense_vertices(const model *m, sg_dense *d)
{
  d->vertex_id = malloc((m->vertices + 1) * sizeof *d->vertex_id);
  d->at = malloc((m->vertices + 1) * sizeof *d->at);
  d->vertex_begin =
      model_begins(m, &m->vertex[0].s, sizeof m->vertex[0], m->vertices);
  for (; d->vertices < m->vertices; d->vertices++) {
    d->vertex_id[d->vertices] = m->vertex[d->vertices].v;
    memcpy(d->at[d->vertices], m->vertex[d->vertices].model, sizeof d->at[0]);
  }
}

/* Edges, and the lists of the polygons, which have them one after another. */
static inline void
model_dense_edges(const model *m, sg_dense *d)
{
  d->edge_id = malloc((m->edges + 1) * sizeof *d->edge_id);
  d->from = malloc((m->edges + 1) * sizeof *d->from);
  d->to = malloc((m->edges + 1) * sizeof *d->to);
  d->real = malloc(m->edges + 1);
  d->list = malloc((m->edges + 1) * sizeof *d->list);
  d->list_begin = calloc((size_t)m->p + 2, sizeof *d->list_begin);
  d->polygon_id = malloc(((size_t)m->p + 1) * sizeof *d->polygon_id);
  d->edge_begin = model_begins(m, &m->edge[0].s, sizeof m->edge[0], m->edges);
  for (; d->polygons < (size_t)m->p; d->polygons++) {
    d->polygon_id[d->polygons] = (int32_t)d->polygons + 1;
  }
  for (size_t i = 0, listed = 0; i < m->edges; i++, d->edges++) {
    const model_side *e = &m->edge[i];
    d->edge_id[i] = e->e;
    d->from[i] = model_place(d, e->s, e->v1);
    d->to[i] = model_place(d, e->s, e->v2);
    d->real[i] = e->real;
    if (e->p) {
      d->list[listed++] = (int32_t)i;
      d->list_begin[e->p] = (uint32_t)listed;
    }
  }
}

static inline void
model_dense_triangles(const model *m, sg_dense *d)
{
  d->triangle_id = malloc((m->triangles + 1) * sizeof *d->triangle_id);
  d->polygon_of = malloc((m->triangles + 1) * sizeof *d->polygon_of);
  d->corner = malloc((m->triangles + 1) * sizeof *d->corner);
  d->triangle_begin =
      model_begins(m, &m->triangle[0].s, sizeof m->triangle[0], m->triangles);
  for (size_t i = 0; i < m->triangles; i++, d->triangles++) {
    const model_triangle *t = &m->triangle[i];
    d->triangle_id[i] = t->t;
    d->polygon_of[i] = t->p - 1;
    for (int k = 0; k < 3; k++) {
      d->corner[i][k] = model_place(d, t->s, t->v[k]);
    }
  }
}

/* Where the polygons of each segment begin; they are numbered one segment after
 * another. */
static inline uint32_t *
model_polygon_begins(const model *m)
{
  uint32_t *begin = calloc((size_t)m->s + 1, sizeof *begin);

  for (size_t i = 0; i < m->edges; i++) {
    const model_side *e = &m->edge[i];
    if (e->p > 0 && begin[e->s] < (uint32_t)e->p) {
      begin[e->s] = (uint32_t)e->p;
    }
  }
  for (int32_t s = 1; s <= m->s; s++) {
    begin[s] = begin[s] > begin[s - 1] ? begin[s] : begin[s - 1];
  }
  return begin;
}

/* What no eye changes; null: stopped. */
static inline sg_scene_model *
model_scene_model(const model *m, const sg_cancel *cancel)
{
  sg_dense d = {.segments = (size_t)m->s};
  bool *solid = malloc((size_t)m->s + 1);
  bool memory;

  d.segment = malloc(((size_t)m->s + 1) * sizeof *d.segment);
  d.polygon_begin = model_polygon_begins(m);
  for (int32_t s = 1; s <= m->s; s++) {
    d.segment[s - 1] = s;
    solid[s - 1] = m->solid[s];
  }
  model_dense_vertices(m, &d);
  model_dense_edges(m, &d);
  model_dense_triangles(m, &d);
  return sg_scene_model_open(&d, NULL, solid, m->cut, m->cuts, cancel, &memory);
}

/* What is seen of it as it is projected, or (not null) only the lines of a
 * drawing; null: stopped. *model_seen is to be closed after it, in any case. */
static inline sg_scene *
model_scene_of(const model *m, const sg_lines_drawn *only,
               const sg_cancel *cancel, sg_scene_model **model_seen)
{
  sg_scene_model *seen = model_scene_model(m, cancel);
  double(*screen)[3] = malloc((m->vertices + 1) * sizeof *screen);
  sg_scene_input in = {.model = seen,
                       .screen = (const double(*)[3])screen,
                       .only = only,
                       .depth = m->depth,
                       .tolerance = 1e-9};
  bool memory;
  sg_scene *scene;

  for (size_t i = 0; i < m->vertices; i++) {
    memcpy(screen[i], m->vertex[i].screen, sizeof *screen);
  }
  scene = seen ? sg_scene_open(&in, cancel, &memory) : NULL;
  *model_seen = seen;
  free(screen);
  return scene;
}

static inline sg_scene *
model_scene(const model *m, const sg_cancel *cancel,
            sg_scene_model **model_seen)
{
  return model_scene_of(m, NULL, cancel, model_seen);
}

#endif
