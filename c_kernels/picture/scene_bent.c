/* scene_bent.c -- which triangles have the lines of polygons that are not flat:
 * such a polygon has no one side, so a line of it lies to the eye as that
 * triangle does (scene_model.h).
 *
 * Layer: kernel.
 */
#include "scene_private.h"

#include <stdlib.h>

#define NO_TRIANGLE (-1)

/* The triangles of the polygons that are not flat, polygon by polygon. */
typedef struct bent {
  uint32_t *begin;   /* [polygons + 2] */
  int32_t *triangle; /* places */
} bent;

/* A counting sort. False: no memory. */
static bool
bent_init(bent *x, const sg_scene_model *m)
{
  const sg_dense *d = &m->dense;

  x->begin = calloc(d->polygons + 2, sizeof *x->begin);
  x->triangle = malloc((d->triangles + 1) * sizeof *x->triangle);
  if (!x->begin || !x->triangle) {
    return false;
  }
  for (size_t i = 0; i < d->triangles; i++) {
    x->begin[d->polygon_of[i] + 2] += !m->flat[d->polygon_of[i]];
  }
  for (size_t p = 2; p < d->polygons + 2; p++) {
    x->begin[p] += x->begin[p - 1];
  }
  for (size_t i = 0; i < d->triangles; i++) {
    if (!m->flat[d->polygon_of[i]]) {
      x->triangle[x->begin[d->polygon_of[i] + 1]++] = (int32_t)i;
    }
  }
  return true;
}

static bool
has_side(const sg_scene_model *m, int32_t triangle, uint32_t a, uint32_t b)
{
  const int32_t *c = m->dense.corner[triangle];

  for (int k = 0; k < 3; k++) {
    uint32_t v = m->same[c[k]], w = m->same[c[(k + 1) % 3]];
    if ((v == a && w == b) || (v == b && w == a)) {
      return true;
    }
  }
  return false;
}

/* The triangle of polygon p that has the line, or NO_TRIANGLE. */
static int32_t
triangle_with(const sg_scene_model *m, const bent *x, int32_t p,
              const sg_model_line *line)
{
  uint32_t a = m->same[line->a], b = m->same[line->b];

  for (uint32_t i = x->begin[p]; i < x->begin[p + 1]; i++) {
    if (has_side(m, x->triangle[i], a, b)) {
      return x->triangle[i];
    }
  }
  return NO_TRIANGLE;
}

static bool
all_flat(const sg_scene_model *m)
{
  for (size_t p = 0; p < m->dense.polygons; p++) {
    if (!m->flat[p]) {
      return false;
    }
  }
  return true;
}

bool
sg_scene_find_bent(sg_scene_builder *b)
{
  sg_scene_model *m = b->model;
  bent x = {0};
  bool done;

  if (all_flat(m)) {
    return true;
  }
  m->use_triangle =
      malloc((m->use_begin[m->lines] + 1) * sizeof *m->use_triangle);
  done = m->use_triangle && bent_init(&x, m);
  for (size_t k = 0; done && k < m->lines && !sg_scene_stop(b, k); k++) {
    for (uint32_t u = m->use_begin[k]; u < m->use_begin[k + 1]; u++) {
      m->use_triangle[u] = triangle_with(m, &x, m->use[u].polygon, &m->line[k]);
    }
  }
  free(x.begin);
  free(x.triangle);
  return done;
}
