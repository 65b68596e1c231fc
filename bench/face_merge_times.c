/* face_merge_times.c -- how long faces take to merge: face_merge_times RUNS.
 * A sphere and a cube of about 300,000 triangles, one face each: nothing of the
 * one becomes one, the other six faces. Prints the median milliseconds of one
 * and of all processors.
 */
#include "solid/face_merge.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { MOST_RUNS = 99 };

static void *
must(void *memory)
{
  if (!memory) {
    abort();
  }
  return memory;
}

static void
open_solid(sg_solid *out, size_t vertices, size_t triangles)
{
  *out = (sg_solid){
      .vertex = must(malloc(vertices * sizeof *out->vertex)),
      .triangle = must(malloc(triangles * sizeof *out->triangle)),
      .auxiliary = must(calloc(triangles, 1)),
      .face = must(malloc(triangles * sizeof *out->face)),
  };
}

static void
add_vertex(sg_solid *solid, double x, double y, double z)
{
  int32_t v = (int32_t)solid->vertices + 1;

  solid->vertex[solid->vertices++] = (sg_solid_vertex){{x, y, z}, 1, v};
  solid->plain = solid->vertices;
}

static void
add_triangle(sg_solid *solid, uint32_t a, uint32_t b, uint32_t c)
{
  uint32_t t = (uint32_t)solid->triangles++;

  memcpy(solid->triangle[t], (uint32_t[]){a, b, c}, 3 * sizeof a);
  solid->face[solid->faces++] = (sg_solid_face){1, (int32_t)t + 1, false, t, 1};
}

/* Rows from pole to pole, each turned a little, so that no two triangles are
 * flat; except for one belt of flat pairs, if that is wanted. */
static void
make_sphere(sg_solid *out, uint32_t rows, uint32_t columns, bool belt)
{
  open_solid(out, rows * columns + 2, 2 * (rows + 1) * columns);
  for (uint32_t i = 0; i < rows; i++) {
    for (uint32_t j = 0; j < columns; j++) {
      double phi = M_PI * (i + 1) / (rows + 1);
      double turn = 0.5 * (i - (belt && i > rows / 2));
      double theta = 2 * M_PI * (j + turn) / columns;
      add_vertex(out, sin(phi) * cos(theta), sin(phi) * sin(theta), cos(phi));
    }
  }
  add_vertex(out, 0, 0, 1);
  add_vertex(out, 0, 0, -1);
  for (uint32_t j = 0; j < columns; j++) {
    uint32_t k = (j + 1) % columns, last = (rows - 1) * columns;
    add_triangle(out, rows * columns, j, k);
    for (uint32_t i = 0; i + 1 < rows; i++) {
      uint32_t a = i * columns + j, b = i * columns + k;
      add_triangle(out, a, a + columns, b + columns);
      add_triangle(out, a, b + columns, b);
    }
    add_triangle(out, rows * columns + 1, last + k, last + j);
  }
}

/* The corner i, j of a side of the cube, by number. */
static uint32_t
corner(sg_solid *solid, uint32_t *number, uint32_t n, const uint32_t at[3])
{
  uint32_t *v = &number[(at[0] * (n + 1) + at[1]) * (n + 1) + at[2]];

  if (*v == UINT32_MAX) {
    *v = (uint32_t)solid->vertices;
    add_vertex(solid, at[0], at[1], at[2]);
  }
  return *v;
}

static void
make_cube(sg_solid *out, uint32_t n)
{
  size_t nodes = (size_t)(n + 1) * (n + 1) * (n + 1);
  uint32_t *number = must(malloc(nodes * sizeof *number));

  memset(number, 0xff, nodes * sizeof *number);
  open_solid(out, 6 * (size_t)(n + 1) * (n + 1), 12 * (size_t)n * n);
  for (uint32_t i = 0; i < 6 * n * n; i++) {
    uint32_t side = i / n / n, k = side / 2, v[4];
    for (uint32_t c = 0; c < 4; c++) {
      uint32_t at[3];
      at[k] = side % 2 ? n : 0;
      at[(k + 1) % 3] = i / n % n + (c == 1 || c == 2);
      at[(k + 2) % 3] = i % n + (c >= 2);
      v[c] = corner(out, number, n, at);
    }
    add_triangle(out, v[0], v[side % 2 ? 1 : 2], v[side % 2 ? 2 : 1]);
    add_triangle(out, v[0], v[side % 2 ? 2 : 3], v[side % 2 ? 3 : 2]);
  }
  free(number);
}

static double
now(void)
{
  struct timespec t;

  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec * 1e3 + (double)t.tv_nsec * 1e-6;
}

static int
compare(const void *a, const void *b)
{
  double x = *(const double *)a, y = *(const double *)b;

  return (x > y) - (x < y);
}

/* Every two triangles become one face. */
static void
pair_triangles(sg_solid *solid)
{
  solid->faces = (solid->triangles + 1) / 2;
  for (uint32_t f = 0; f < solid->faces; f++) {
    uint32_t n = 2 * f + 1 < solid->triangles ? 2 : 1;
    solid->face[f] = (sg_solid_face){1, (int32_t)f + 1, false, 2 * f, n};
  }
}

enum { SPHERE, BELT, PAIRS, CUBE };

/* Each run has a solid of its own. */
static void
measure(const char *name, int runs, int shape, sg_pool *pool)
{
  double times[MOST_RUNS];
  sg_merge_options options = {.tolerance = 1e-10, .pool = pool};
  sg_merge_counts counts = {0};

  for (int i = 0; i < runs; i++) {
    sg_solid solid;
    if (shape == CUBE) {
      make_cube(&solid, 158);
    } else {
      make_sphere(&solid, 387, 387, shape == BELT);
    }
    if (shape == PAIRS) {
      pair_triangles(&solid);
    }
    double from = now();
    if (sg_face_merge(&solid, &options, &counts) != SG_MERGE_DONE) {
      abort();
    }
    times[i] = now() - from;
    sg_solid_clear(&solid);
  }
  qsort(times, (size_t)runs, sizeof *times, compare);
  printf("%s: %zu triangles, %zu -> %zu faces: %.1f ms (least %.1f)\n", name,
         counts.triangles_before, counts.faces_before, counts.faces_after,
         times[runs / 2], times[0]);
}

int
main(int argc, char **argv)
{
  int runs = argc > 1 ? atoi(argv[1]) : 9;
  sg_pool *pool = sg_pool_open(0);

  runs = runs < 1 ? 1 : runs > MOST_RUNS ? MOST_RUNS : runs;
  measure("sphere, one thread", runs, SPHERE, NULL);
  measure("sphere, all threads", runs, SPHERE, pool);
  measure("sphere with a belt, one thread", runs, BELT, NULL);
  measure("sphere with a belt, all threads", runs, BELT, pool);
  measure("sphere of pairs, one thread", runs, PAIRS, NULL);
  measure("sphere of pairs, all threads", runs, PAIRS, pool);
  measure("cube, one thread", runs, CUBE, NULL);
  measure("cube, all threads", runs, CUBE, pool);
  sg_pool_close(pool);
  return 0;
}
