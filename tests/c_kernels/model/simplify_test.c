/* simplify_test.c -- fewer triangles: closed stays closed, flat stays flat,
 * borders stay where they are, and the work grows as n log n. */
#include "tests/check.h"

#include "model/simplify.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_VERTICES = 70000, MOST_TRIANGLES = 140000 };

static double at[MOST_VERTICES][3];
static int32_t corner[MOST_TRIANGLES][3];
static double weight[MOST_VERTICES];
static size_t vertices, triangles;

static void
triangle(int32_t a, int32_t b, int32_t c)
{
  corner[triangles][0] = a;
  corner[triangles][1] = b;
  corner[triangles++][2] = c;
}

static void
clear(void)
{
  vertices = triangles = 0;
}

static int32_t
vertex(double x, double y, double z)
{
  for (int32_t i = 0; i < (int32_t)vertices && vertices < 3000; i++) {
    if (at[i][0] == x && at[i][1] == y && at[i][2] == z) {
      return i;
    }
  }
  at[vertices][0] = x;
  at[vertices][1] = y;
  at[vertices][2] = z;
  return (int32_t)vertices++;
}

/* n x n squares from o, along u and v, of eighths so that all is exact. */
static void
square(int n, const double o[3], const double u[3], const double v[3])
{
  for (int i = 0; i < n; i++) {
    for (int k = 0; k < n; k++) {
      int32_t c[4];

      for (int m = 0; m < 4; m++) {
        double a = i + (m == 1 || m == 2), b = k + (m > 1), p[3];
        for (int x = 0; x < 3; x++) {
          p[x] = o[x] + a * u[x] + b * v[x];
        }
        c[m] = vertex(p[0], p[1], p[2]);
      }
      triangle(c[0], c[1], c[2]);
      triangle(c[0], c[2], c[3]);
    }
  }
}

/* A cube of n x n squares a side; without its top if `open`. */
static void
cube(int n, bool open)
{
  const double s = 0.125, x[3] = {s, 0, 0}, y[3] = {0, s, 0}, z[3] = {0, 0, s};
  const double o[3] = {0, 0, 0}, a[3] = {n * s, 0, 0}, b[3] = {0, n * s, 0};
  const double c[3] = {0, 0, n * s};

  clear();
  square(n, o, y, x);
  square(n, o, x, z);
  square(n, o, z, y);
  square(n, a, y, z);
  square(n, b, z, x);
  if (!open) {
    square(n, c, x, y);
  }
}

/* A torus of n x n quads: one hole, no border. */
static void
torus(int n)
{
  clear();
  for (int i = 0; i < n; i++) {
    for (int k = 0; k < n; k++) {
      double a = 2 * M_PI * i / n, b = 2 * M_PI * k / n, r = 3 + cos(b);
      double *p = at[vertices++];

      p[0] = r * cos(a), p[1] = r * sin(a), p[2] = sin(b);
    }
  }
  for (int i = 0; i < n; i++) {
    for (int k = 0; k < n; k++) {
      int32_t j = (i + 1) % n, m = (k + 1) % n;

      triangle(i * n + k, j * n + k, j * n + m);
      triangle(i * n + k, j * n + m, i * n + m);
    }
  }
}

static int
compare_pairs(const void *a, const void *b)
{
  const int64_t *x = a, *y = b;

  return (*x > *y) - (*x < *y);
}

/* How many directed edges have no opposite, or are there twice. *edges: all. */
static size_t
loose_edges(const sg_simplified *s, size_t *edges)
{
  size_t n = 3 * s->triangles, loose = 0;
  int64_t *pair = malloc((n + 1) * sizeof *pair);

  for (size_t i = 0; i < n; i++) {
    pair[i] =
        (int64_t)s->corner[i / 3][i % 3] << 32 | s->corner[i / 3][(i + 1) % 3];
  }
  qsort(pair, n, sizeof *pair, compare_pairs);
  for (size_t i = 0; i < n; i++) {
    int64_t back = (pair[i] & INT32_MAX) << 32 | pair[i] >> 32;

    loose += (i > 0 && pair[i] == pair[i - 1]) ||
             !bsearch(&back, pair, n, sizeof *pair, compare_pairs);
  }
  free(pair);
  *edges = n;
  return loose;
}

static double
volume(const sg_simplified *s)
{
  double sum = 0;

  for (size_t t = 0; t < s->triangles; t++) {
    const double *a = s->at[s->corner[t][0]], *b = s->at[s->corner[t][1]];
    const double *c = s->at[s->corner[t][2]];

    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) +
           a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6;
}

static size_t
left_vertices(const sg_simplified *s)
{
  size_t n = 0;

  for (size_t v = 0; v < s->vertices; v++) {
    n += s->into[v] == (int32_t)v;
  }
  return n;
}

static sg_simplified
simplified(size_t most, const sg_cancel *cancel)
{
  const sg_simplify_mesh mesh = {vertices, triangles, at, corner, weight};
  sg_simplified out;
  bool stopped;

  CHECK("it is done", sg_simplify(&mesh, most, cancel, &out, &stopped));
  return out;
}

static void
check_cube(void)
{
  size_t edges;

  cube(8, false);
  sg_simplified s = simplified(12, NULL);
  CHECK("twelve triangles", s.triangles == 12);
  CHECK("eight vertices", left_vertices(&s) == 8);
  CHECK("closed", loose_edges(&s, &edges) == 0);
  CHECK("its volume to the last digit",
        volume(&s) == 1.0); /* its corners, to the last digit */
  sg_simplified_clear(&s);

  s = simplified(1, NULL); /* no closed one has fewer than four */
  CHECK("a tetrahedron or more", s.triangles >= 4 && s.triangles <= 12);
  CHECK("closed still", loose_edges(&s, &edges) == 0);
  sg_simplified_clear(&s);

  s = simplified(100000, NULL);
  CHECK("nothing to do", s.triangles == triangles);
  CHECK("the same triangles",
        memcmp(s.corner, corner, triangles * sizeof *corner) == 0);
  sg_simplified_clear(&s);
}

static void
check_border(void)
{
  size_t edges, on_rim = 0;

  cube(8, true);
  sg_simplified s = simplified(10, NULL);
  CHECK("ten triangles", s.triangles == 10);
  CHECK("the border is four edges", loose_edges(&s, &edges) == 4);
  for (size_t v = 0; v < s.vertices; v++) {
    on_rim += s.into[v] == (int32_t)v && s.at[v][2] == 1.0;
  }
  CHECK("the border keeps its corners", on_rim == 4);
  sg_simplified_clear(&s);
}

/* Where it matters more, more is left. */
static void
check_weight(void)
{
  size_t near = 0, far = 0;

  torus(64);
  for (size_t v = 0; v < vertices; v++) {
    weight[v] = at[v][0] > 0 ? 1000 : 1;
  }
  sg_simplified s = simplified(400, NULL);
  for (size_t v = 0; v < vertices; v++) {
    weight[v] = 1;
    near += s.into[v] == (int32_t)v && s.at[v][0] > 0;
    far += s.into[v] == (int32_t)v && s.at[v][0] < 0;
  }
  CHECK("as many as asked", s.triangles <= 400);
  CHECK("more where it matters", near > 3 * far);
  sg_simplified_clear(&s);
}

/* Two cubes with an edge in common: that is of four triangles, and stays. */
static void
check_crowded(void)
{
  size_t edges;

  cube(2, false);
  size_t one = triangles;
  for (size_t t = 0; t < one; t++) {
    const int32_t *c = corner[t];
    int32_t m[3];

    for (int k = 0; k < 3; k++) {
      m[k] = vertex(at[c[k]][0] + 0.25, at[c[k]][1] + 0.25, at[c[k]][2]);
    }
    triangle(m[0], m[1], m[2]);
  }
  sg_simplified s = simplified(28, NULL);
  CHECK("crowded edge", s.triangles == 28);
  CHECK("its volume", fabs(volume(&s) - 0.03125) < 1e-15);
  CHECK("edges of two cubes",
        loose_edges(&s, &edges) == 4); /* there twice, both ways, in two */
  sg_simplified_clear(&s);
}

static void
check_torus(void)
{
  size_t edges;

  torus(64);
  sg_simplified s = simplified(400, NULL), again = simplified(400, NULL);
  CHECK("as many as asked", s.triangles <= 400 && s.triangles >= 398);
  CHECK("closed torus", loose_edges(&s, &edges) == 0);
  CHECK("a torus still",
        left_vertices(&s) == s.triangles / 2); /* still a torus */
  CHECK("its volume, nearly", fabs(volume(&s) / (6 * M_PI * M_PI) - 1) < 0.05);
  CHECK("the same triangles again",
        memcmp(s.corner, again.corner, s.triangles * sizeof *s.corner) == 0);
  CHECK("the same places again",
        memcmp(s.at, again.at, s.vertices * sizeof *s.at) == 0);
  sg_simplified_clear(&s);
  sg_simplified_clear(&again);
}

static bool
count_asked(void *data)
{
  ++*(size_t *)data;
  return false;
}

static bool
stop_later(void *data)
{
  return ++*(size_t *)data > 3;
}

/* Of each step a heap takes log n. */
static void
check_growth(void)
{
  size_t asked[2] = {0, 0};

  for (int i = 0; i < 2; i++) {
    const sg_cancel count = {count_asked, &asked[i]};

    torus(128 << i);
    sg_simplified s = simplified(400, &count);
    CHECK("as many as asked", s.triangles <= 400);
    sg_simplified_clear(&s);
  }
  CHECK("it asks", asked[0] > 20);
  CHECK("the work grows as n log n",
        asked[1] < 5 * asked[0]); /* of 4 times as many triangles */

  size_t times = 0;
  const sg_cancel stop = {stop_later, &times};
  const sg_simplify_mesh mesh = {vertices, triangles, at, corner, NULL};
  sg_simplified s;
  bool stopped;
  CHECK("it stops", !sg_simplify(&mesh, 400, &stop, &s, &stopped) && stopped);
  sg_simplified_clear(&s);
}

int
main(void)
{
  for (size_t v = 0; v < MOST_VERTICES; v++) {
    weight[v] = 1;
  }
  check_cube();
  check_border();
  check_weight();
  check_crowded();
  check_torus();
  check_growth();
  return check_report();
}
