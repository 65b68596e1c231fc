/* contour_test.c -- sheets and outlines of grids of triangles whose normals and
 * outlines are known.
 */
#include "picture/contour.h"
#include "tests/check.h"

#include <math.h>
#include <stdlib.h>

#define PI acos(-1.0)

/* One segment, solid, of polygons that are its triangles. */
typedef struct mesh {
  sg_dense dense;
  double (*screen)[3];
  bool solid;
  sg_smooth smooth;
  sg_contours contours;
} mesh;

static void
mesh_init(mesh *m, size_t vertices, size_t triangles)
{
  sg_dense *d = &m->dense;

  *m = (mesh){.solid = true};
  d->segments = 1;
  d->vertices = vertices;
  d->triangles = d->polygons = triangles;
  d->at = malloc(vertices * sizeof *d->at);
  d->corner = malloc(triangles * sizeof *d->corner);
  d->polygon_of = malloc(triangles * sizeof *d->polygon_of);
  d->triangle_begin = calloc(2, sizeof *d->triangle_begin);
  d->triangle_begin[1] = (uint32_t)triangles;
  d->vertex_begin = calloc(2, sizeof *d->vertex_begin);
  d->vertex_begin[1] = (uint32_t)vertices;
  for (size_t t = 0; t < triangles; t++) {
    d->polygon_of[t] = (int32_t)t;
  }
  m->screen = malloc(vertices * sizeof *m->screen);
}

static void
mesh_clear(mesh *m)
{
  sg_smooth_clear(&m->smooth);
  sg_contours_clear(&m->contours);
  free(m->dense.at);
  free(m->dense.corner);
  free(m->dense.polygon_of);
  free(m->dense.triangle_begin);
  free(m->dense.vertex_begin);
  free(m->screen);
}

/* A torus of radii 1 and r, n times n squares, each of two triangles. */
static void
torus_init(mesh *m, int n, double r)
{
  mesh_init(m, (size_t)(n * n), (size_t)(2 * n * n));
  for (int i = 0; i < n; i++) {
    for (int j = 0; j < n; j++) {
      double u = 2 * PI * i / n, v = 2 * PI * j / n, w = 1.0 + r * cos(v);
      double *at = m->dense.at[i * n + j];
      int32_t a = i * n + j, b = (i + 1) % n * n + j;
      int32_t c = (i + 1) % n * n + (j + 1) % n, d = i * n + (j + 1) % n;
      int32_t(*corner)[3] = m->dense.corner + 2 * a;
      at[0] = w * cos(u), at[1] = w * sin(u), at[2] = r * sin(v);
      corner[0][0] = a, corner[0][1] = b, corner[0][2] = c;
      corner[1][0] = a, corner[1][1] = c, corner[1][2] = d;
    }
  }
}

/* A strip round a cylinder of n squares, without caps. */
static void
tube_init(mesh *m, int n)
{
  mesh_init(m, (size_t)(2 * n), (size_t)(2 * n));
  m->solid = false;
  for (int i = 0; i < n; i++) {
    int32_t a = 2 * i, b = 2 * ((i + 1) % n);
    int32_t(*corner)[3] = m->dense.corner + a;
    for (int k = 0; k < 2; k++) {
      double *at = m->dense.at[a + k];
      at[0] = cos(2 * PI * i / n), at[1] = sin(2 * PI * i / n), at[2] = k;
    }
    corner[0][0] = a, corner[0][1] = b, corner[0][2] = b + 1;
    corner[1][0] = a, corner[1][1] = b + 1, corner[1][2] = a + 1;
  }
}

/* False: no memory. */
static bool
look(mesh *m, double crease, double theta, double phi)
{
  sg_smooth_input sheets = {.dense = &m->dense, .crease = crease};
  sg_contour_input in = {.dense = &m->dense,
                         .smooth = &m->smooth,
                         .screen = (const double(*)[3])m->screen,
                         .solid = &m->solid};
  bool memory;

  sg_eye_init(&in.eye, theta, phi, 10.0);
  for (size_t i = 0; i < m->dense.vertices; i++) {
    sg_eye_point(&in.eye, m->dense.at[i], m->screen[i]);
  }
  return sg_smooth_init(&m->smooth, &sheets, NULL, &memory) &&
         sg_contours_find(&in, NULL, &m->contours, &memory);
}

static size_t
count_curved(const mesh *m)
{
  size_t n = 0;

  for (size_t t = 0; t < m->dense.triangles; t++) {
    n += m->smooth.curved[t];
  }
  return n;
}

/* The length of all pieces in the picture. */
static double
total_length(const mesh *m)
{
  double sum = 0.0;

  for (size_t i = 0; i < m->contours.n; i++) {
    const sg_contour *piece = &m->contours.piece[i];
    double at[2][2];
    if (piece->visibility == SG_CONTOUR_SUBSTITUTE) {
      continue;
    }
    for (int end = 0; end < 2; end++) {
      const int32_t *corner = m->dense.corner[piece->t];
      int32_t v = corner[piece->side[end]];
      int32_t w = corner[(piece->side[end] + 1) % 3];
      const double *a = m->screen[v < w ? v : w];
      const double *b = m->screen[v < w ? w : v];
      for (int k = 0; k < 2; k++) {
        at[end][k] = a[k] + piece->at[end] * (b[k] - a[k]);
      }
    }
    sum += hypot(at[1][0] - at[0][0], at[1][1] - at[0][1]);
  }
  return sum;
}

static bool
is_beside_itself(const sg_contours *c)
{
  for (size_t i = 0; i < c->n; i++) {
    bool own = c->piece[i].visibility == SG_CONTOUR_HIDDEN;
    for (size_t k = 0; k < c->piece[i].adjacents; k++) {
      own |= c->adjacent[c->piece[i].adjacent + k] == c->piece[i].t;
    }
    if (!own) {
      return false;
    }
  }
  return true;
}

/* From above the outline is two circles, one in the other. */
static void
test_torus_from_above(void)
{
  mesh m;

  torus_init(&m, 96, 0.4);
  CHECK("torus", look(&m, 30.0, 33.0, 0.0));
  CHECK("one fan at each vertex", m.smooth.fans == m.dense.vertices);
  CHECK("all of it is curved", count_curved(&m) == m.dense.triangles);
  CHECK("two circles",
        fabs(total_length(&m) - 2 * PI * (1.4 + 0.6)) < 0.01 * 4 * PI);
  CHECK("every piece is beside itself", is_beside_itself(&m.contours));
  mesh_clear(&m);
}

/* Pieces across triangles. */
static size_t
count_across(const mesh *m)
{
  size_t n = 0;

  for (size_t i = 0; i < m->contours.n; i++) {
    n += !m->contours.piece[i].along;
  }
  return n;
}

/* Twice as many triangles along each way: twice as many pieces. */
static void
test_growth(void)
{
  mesh coarse, fine;

  torus_init(&coarse, 60, 0.4);
  torus_init(&fine, 120, 0.4);
  CHECK("coarse", look(&coarse, 30.0, 20.0, 65.0));
  CHECK("fine", look(&fine, 30.0, 20.0, 65.0));
  CHECK("pieces grow as the root",
        count_across(&fine) > 18 * count_across(&coarse) / 10 &&
            count_across(&fine) < 22 * count_across(&coarse) / 10);
  CHECK("the length does not",
        fabs(total_length(&fine) / total_length(&coarse) - 1.0) < 0.01);
  mesh_clear(&coarse);
  mesh_clear(&fine);
}

static void
test_folded(void)
{
  mesh m;

  tube_init(&m, 24);
  CHECK("tube", look(&m, 30.0, 20.0, 65.0));
  CHECK("a tube is not curved", count_curved(&m) == 0 && m.contours.n == 0);
  mesh_clear(&m);
  tube_init(&m, 6);
  CHECK("six sides", look(&m, 30.0, 20.0, 65.0));
  CHECK("creases part a vertex", m.smooth.fans == 2 * m.dense.vertices);
  mesh_clear(&m);
}

static bool
says_stop(void *data)
{
  (void)data;
  return true;
}

static void
test_stopped(void)
{
  const sg_cancel cancel = {says_stop, NULL};
  sg_smooth_input sheets;
  mesh m;
  bool memory;

  torus_init(&m, 12, 0.4);
  sheets = (sg_smooth_input){.dense = &m.dense, .crease = 30.0};
  CHECK("stopped",
        !sg_smooth_init(&m.smooth, &sheets, &cancel, &memory) && memory);
  mesh_clear(&m);
}

int
main(void)
{
  test_torus_from_above();
  test_growth();
  test_folded();
  test_stopped();
  return check_report();
}
