/* flat_model.h -- small solids for the tests of what is laid flat, and what is
 * asked of a pattern.
 */
#ifndef SG_TEST_FLAT_MODEL_H
#define SG_TEST_FLAT_MODEL_H

#include "tests/check.h"

#include "development/lay.h"
#include "development/measure.h"
#include "development/seam_bound.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROOM = 60000 };

/* ---- models ------------------------------------------------------------- */

typedef struct model {
  sg_dense dense;
  double at[ROOM][3];
  int32_t vertex_id[ROOM], edge_id[ROOM], from[ROOM], to[ROOM], list[ROOM];
  unsigned char real[ROOM];
  int32_t polygon_id[ROOM], triangle_id[ROOM], polygon_of[ROOM];
  int32_t corner[ROOM][3];
  uint32_t list_begin[ROOM];
} model;

static inline model *
new_model(void)
{
  model *m = calloc(1, sizeof *m);

  m->dense = (sg_dense){.segments = 1,
                        .vertex_id = m->vertex_id,
                        .at = m->at,
                        .edge_id = m->edge_id,
                        .from = m->from,
                        .to = m->to,
                        .real = m->real,
                        .polygon_id = m->polygon_id,
                        .list_begin = m->list_begin,
                        .list = m->list,
                        .triangle_id = m->triangle_id,
                        .polygon_of = m->polygon_of,
                        .corner = m->corner};
  return m;
}

static inline int32_t
add_vertex(model *m, double x, double y, double z)
{
  size_t n = m->dense.vertices++;

  memcpy(m->at[n], (double[3]){x, y, z}, sizeof m->at[n]);
  m->vertex_id[n] = (int32_t)n + 1;
  return (int32_t)n;
}

/* A convex polygon, in triangles from its first corner. */
static inline void
add_polygon(model *m, size_t n, const int32_t *v)
{
  sg_dense *d = &m->dense;

  m->polygon_id[d->polygons] = (int32_t)d->polygons + 1;
  for (size_t i = 0; i < n; i++) {
    m->from[d->edges] = v[i];
    m->to[d->edges] = v[(i + 1) % n];
    m->real[d->edges] = 1;
    m->edge_id[d->edges] = (int32_t)d->edges + 1;
    m->list[d->edges] = (int32_t)d->edges;
    d->edges++;
  }
  for (size_t i = 1; i + 1 < n; i++) {
    int32_t *t = m->corner[d->triangles];
    t[0] = v[0];
    t[1] = v[i];
    t[2] = v[i + 1];
    m->polygon_of[d->triangles] = (int32_t)d->polygons;
    m->triangle_id[d->triangles] = (int32_t)d->triangles + 1;
    d->triangles++;
  }
  m->list_begin[++d->polygons] = (uint32_t)d->edges;
}

static inline void
add_box(model *m, const double low[3], const double high[3])
{
  static const int32_t side[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  int32_t v[8];

  for (int k = 0; k < 8; k++) {
    v[k] = add_vertex(m, k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1],
                      k & 4 ? high[2] : low[2]);
  }
  for (int s = 0; s < 6; s++) {
    int32_t corner[4];
    for (int k = 0; k < 4; k++) {
      corner[k] = v[side[s][k]];
    }
    add_polygon(m, 4, corner);
  }
}

/* A torus of triangles, whose unfolding meets itself again and again. */
static inline void
add_torus(model *m, int n, double thick)
{
  const double turn = 2 * acos(-1.0) / n;
  int32_t first = (int32_t)m->dense.vertices;

  for (int i = 0; i < n; i++) {
    for (int j = 0; j < n; j++) {
      double r = 1 + thick * cos(turn * j);
      add_vertex(m, r * cos(turn * i), r * sin(turn * i),
                 thick * sin(turn * j));
    }
  }
  for (int i = 0; i < n; i++) {
    for (int j = 0; j < n; j++) {
      int32_t a = first + i * n + j, b = first + (i + 1) % n * n + j;
      int32_t c = first + (i + 1) % n * n + (j + 1) % n;
      int32_t d = first + i * n + (j + 1) % n;
      add_polygon(m, 3, (int32_t[3]){a, b, c});
      add_polygon(m, 3, (int32_t[3]){a, c, d});
    }
  }
}

/* ---- unfolding ---------------------------------------------------------- */

typedef struct unfolded {
  sg_flat_faces faces;
  sg_joints joints;
  sg_flattening flattening;
  sg_layout layout;
} unfolded;

static inline void
unfold(const model *m, unsigned order, unfolded *out)
{
  bool stopped = false;

  *out = (unfolded){.layout = {0}};
  CHECK("faces",
        sg_flat_faces_make(&m->dense, NULL, 1e-9, NULL, &out->faces, &stopped));
  CHECK("joints", sg_joints_make(&out->faces, &m->dense, 1e-9, NULL,
                                 &out->joints, &stopped));
  CHECK("islands", sg_flattening_make(&m->dense, &out->faces, &out->joints,
                                      NULL, &out->flattening, &stopped));
  uint32_t *js = sg_joint_order(&out->flattening, order, NULL, &stopped);
  CHECK("an order", js != NULL);
  CHECK("joined", sg_flattening_join_all(&out->flattening, js, out->joints.n,
                                         NULL, &stopped));
  free(js);
  const sg_lay_input in = {&out->flattening, 1e-9, SG_NO_FACE};
  CHECK("laid out", sg_lay(&in, NULL, &out->layout, &stopped));
}

static inline void
forget(unfolded *u)
{
  sg_layout_clear(&u->layout);
  sg_flattening_clear(&u->flattening);
  sg_joints_clear(&u->joints);
  sg_flat_faces_clear(&u->faces);
}

static inline void
place_triangle(const unfolded *u, uint32_t t, double out[3][2])
{
  for (int k = 0; k < 3; k++) {
    uint32_t v = u->layout.vertex[u->faces.triangle[t][k]];
    memcpy(out[k], u->layout.at[v], sizeof out[k]);
  }
}

/* How many pairs of triangles overlap. */
static inline size_t
overlaps(const unfolded *u)
{
  size_t n = 0;
  double p[3][2], q[3][2];

  for (uint32_t a = 0; a < u->faces.triangles; a++) {
    place_triangle(u, a, p);
    for (uint32_t b = 0; b < a; b++) {
      place_triangle(u, b, q);
      n += sg_convex_overlap((const double(*)[2])p, 3, (const double(*)[2])q, 3,
                             1.001e-9 * u->flattening.sheet);
    }
  }
  return n;
}

/* The most by which a side differs from its edge. */
static inline double
stretch(const model *m, const unfolded *u)
{
  double most = 0;

  for (uint32_t k = 0; k < u->faces.sides; k++) {
    const double *a = u->layout.at[u->layout.vertex[u->faces.side[k].from]];
    const double *b = u->layout.at[u->layout.vertex[u->faces.side[k].to]];
    const double *p = m->at[sg_flat_side_from(&u->faces, k)];
    const double *q = m->at[sg_flat_side_to(&u->faces, k)];
    double flat = hypot(b[0] - a[0], b[1] - a[1]), square = 0;
    for (int c = 0; c < 3; c++) {
      square += (q[c] - p[c]) * (q[c] - p[c]);
    }
    most = fmax(most, fabs(flat - sqrt(square)));
  }
  return most;
}

static inline sg_measures
measured(const unfolded *u)
{
  sg_measures out;
  bool stopped;

  CHECK("measured",
        sg_measure(&u->flattening, &u->layout, NULL, &out, &stopped));
  return out;
}

static inline sg_seam_bound
bound(const unfolded *u)
{
  sg_seam_bound out;
  bool stopped;

  CHECK("a bound", sg_seam_bound_find(&u->flattening, NULL, &out, &stopped));
  return out;
}

static inline bool
near(double a, double b)
{
  return fabs(a - b) <= 1e-9;
}

#endif
