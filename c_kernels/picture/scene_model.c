/* scene_model.c -- see scene_model.h */
#include "number/bounds.h"
#include "scene_private.h"

#include <stdlib.h>

/* A polygon is flat if it is no thicker than this part of the model. */
#define FLAT 1e-7

/* Brings the largest coordinate between 1/2 and 1, by a power of two: products
 * of such normals neither overflow nor vanish. */
static void
scale_normal(double n[3])
{
  int exponent;

  frexp(sg_larger(fabs(n[0]), sg_larger(fabs(n[1]), fabs(n[2]))), &exponent);
  double scale = ldexp(1.0, -exponent);
  bool is_exact = isnormal(scale);

  for (int k = 0; k < 3; k++) {
    n[k] = is_exact ? n[k] * scale : ldexp(n[k], -exponent);
  }
}

/* The normals of the polygons, scaled. False: no memory, or stopped. */
static bool
make_normals(sg_scene_builder *b)
{
  const sg_dense *d = &b->model->dense;

  b->normal = calloc(d->polygons + 1, sizeof *b->normal);
  for (size_t i = 0; b->normal && i < d->triangles; i++) {
    const int32_t *v = d->corner[i];
    double n[3];

    if (sg_scene_stop(b, i)) {
      return false;
    }
    sg_cross_at(d->at[v[0]], d->at[v[1]], d->at[v[2]], n);
    for (int k = 0; k < 3; k++) {
      b->normal[d->polygon_of[i]][k] += n[k];
    }
  }
  for (size_t p = 0; b->normal && p < d->polygons; p++) {
    scale_normal(b->normal[p]);
  }
  return b->normal != NULL;
}

double
sg_scene_size(const sg_scene_model *model)
{
  const sg_dense *d = &model->dense;
  double half = 0.0;

  for (int k = 0; k < 3; k++) {
    double low = INFINITY, high = -INFINITY;
    for (size_t i = 0; i < d->vertices; i++) {
      low = sg_smaller(low, d->at[i][k]);
      high = sg_larger(high, d->at[i][k]);
    }
    half = sg_larger(half, (high - low) / 2);
  }
  return half;
}

/* Whether no edge of a polygon ends farther than `most` from the plane through
 * one of its corners. One without area has no plane. */
static bool
is_flat(const sg_dense *d, size_t p, const double normal[3], double most)
{
  const int32_t *edge = d->list + d->list_begin[p];
  size_t n = d->list_begin[p + 1] - d->list_begin[p];
  double size = sg_length(normal);

  for (size_t i = 0; i < n; i++) {
    const double *a = d->at[d->from[edge[0]]];
    const double *c = d->at[d->from[edge[i]]], *e = d->at[d->to[edge[i]]];
    double u[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    double w[3] = {e[0] - a[0], e[1] - a[1], e[2] - a[2]};
    if (fabs(sg_dot(normal, u)) > most * size ||
        fabs(sg_dot(normal, w)) > most * size) {
      return false;
    }
  }
  return size > 0.0;
}

/* Which polygons are flat. False: no memory, or stopped. */
static bool
find_flat(sg_scene_builder *b)
{
  sg_scene_model *m = b->model;
  const sg_dense *d = &m->dense;
  double most = FLAT * sg_scene_size(m);

  m->flat = malloc(d->polygons + 1);
  for (size_t p = 0; m->flat && p < d->polygons; p++) {
    if (sg_scene_stop(b, p)) {
      return false;
    }
    m->flat[p] = is_flat(d, p, b->normal[p], most);
  }
  return m->flat != NULL;
}

/* The lines know whether their segment is solid. */
static void
tell_lines(sg_scene_builder *b)
{
  sg_scene_model *m = b->model;
  size_t s = 0;

  for (size_t k = 0; k < m->lines && !sg_scene_stop(b, k); k++) {
    sg_model_line *line = &m->line[k];
    while (m->dense.segment[s] != line->s) {
      s++;
    }
    line->solid = m->solid[s];
  }
}

sg_scene_model *
sg_scene_model_open(sg_dense *dense, sg_known_surfaces *surfaces, bool *solid,
                    const sg_scene_cut *cut, size_t cuts,
                    const sg_cancel *cancel, bool *memory)
{
  sg_known_surfaces none = {0};
  sg_scene_builder b = {.model = calloc(1, sizeof(sg_scene_model)),
                        .cut = cut,
                        .cuts = cuts,
                        .cancel = cancel};
  bool done;

  *memory = b.model != NULL;
  surfaces = surfaces ? surfaces : &none;
  if (!b.model) {
    sg_dense_clear(dense);
    sg_known_surfaces_clear(surfaces);
    free(solid);
    return NULL;
  }
  b.model->dense = *dense;
  b.model->surfaces = *surfaces;
  b.model->solid = solid;
  *dense = (sg_dense){0};
  *surfaces = (sg_known_surfaces){0};
  done = make_normals(&b) && find_flat(&b) &&
         (!b.model->surfaces.of ||
          sg_known_surfaces_find_reach(&b.model->surfaces, &b.model->dense)) &&
         sg_scene_make_lines(&b);
  if (done) {
    tell_lines(&b);
  }
  free(b.normal);
  free(b.tangent);
  if (!done || b.stopped) {
    *memory = b.stopped;
    sg_scene_model_close(b.model);
    return NULL;
  }
  return b.model;
}

double
sg_scene_bend(const sg_scene_model *m, const bool *faceted, size_t k)
{
  const sg_model_line *line = &m->line[k];

  return faceted && m->facet_bend &&
                 faceted[sg_dense_segment_of(&m->dense, m->dense.vertex_begin,
                                             line->a)]
             ? m->facet_bend[k]
             : line->bend;
}

static bool
has_user(const uint32_t *begin, const sg_scene_use *use, uint32_t line,
         int32_t polygon)
{
  for (uint32_t i = begin[line]; i < begin[line + 1]; i++) {
    if (use[i].polygon == polygon) {
      return true;
    }
  }
  return false;
}

bool
sg_scene_lies_on(const sg_scene_model *m, uint32_t line, int32_t polygon)
{
  return m->flat[polygon] &&
         (has_user(m->use_begin, m->use, line, polygon) ||
          (m->copy_begin && has_user(m->copy_begin, m->copy, line, polygon)));
}

void
sg_scene_model_close(sg_scene_model *model)
{
  if (model) {
    sg_dense_clear(&model->dense);
    sg_known_surfaces_clear(&model->surfaces);
    free(model->facet_bend);
    free(model->solid);
    free(model->flat);
    free(model->same);
    free(model->cut);
    free(model->copy_begin);
    free(model->copy);
    free(model->line);
    free(model->use_begin);
    free(model->use);
    free(model->use_triangle);
    free(model);
  }
}
