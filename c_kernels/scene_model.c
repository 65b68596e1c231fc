/* scene_model.c -- see scene_model.h */
#include "scene_private.h"

#include <stdlib.h>

/* The normals of the polygons. False: no memory, or stopped. */
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
  return b->normal != NULL;
}

/* Six times the volume inside the triangles from .. to - 1: of the pyramids
 * over them whose apex is their first corner. */
static double
volume_of(const sg_dense *d, size_t from, size_t to)
{
  const double *apex = from < to ? d->at[d->corner[from][0]] : NULL;
  double volume = 0.0;

  for (size_t i = from; i < to; i++) {
    const int32_t *v = d->corner[i];
    const double *a = d->at[v[0]];
    double n[3], u[3] = {a[0] - apex[0], a[1] - apex[1], a[2] - apex[2]};

    sg_cross_at(a, d->at[v[1]], d->at[v[2]], n);
    volume += sg_dot(u, n);
  }
  return volume;
}

/* A segment of kind solid that has a border or is inside out is none. */
static void
check_solids(sg_scene_builder *b)
{
  sg_scene_model *m = b->model;
  const sg_dense *d = &m->dense;
  size_t s = 0;

  for (size_t i = 0; i < d->segments && !sg_scene_stop(b, 0); i++) {
    size_t from = d->triangle_begin[i], to = d->triangle_begin[i + 1];
    if (from < to && m->solid[i]) {
      m->solid[i] = volume_of(d, from, to) > 0.0;
    }
  }
  for (int pass = 0; pass < 2; pass++, s = 0) {
    for (size_t k = 0; k < m->lines && !sg_scene_stop(b, k); k++) {
      sg_scene_line *line = &m->line[k];
      while (d->segment[s] != line->s) {
        s++;
      }
      if (pass == 0 && line->look.faces == 1) {
        m->solid[s] = false;
      }
      line->look.solid = m->solid[s];
    }
  }
}

sg_scene_model *
sg_scene_model_open(sg_dense *dense, bool *solid, const sg_scene_cut *cut,
                    size_t cuts, const sg_poll *poll, bool *memory)
{
  sg_scene_builder b = {.model = calloc(1, sizeof(sg_scene_model)),
                        .cut = cut,
                        .cuts = cuts,
                        .poll = poll};
  bool done;

  *memory = b.model != NULL;
  if (!b.model) {
    sg_dense_clear(dense);
    free(solid);
    return NULL;
  }
  b.model->dense = *dense;
  b.model->solid = solid;
  *dense = (sg_dense){0};
  done = make_normals(&b) && sg_scene_make_lines(&b);
  if (done) {
    check_solids(&b);
  }
  free(b.normal);
  if (!done || b.stopped) {
    *memory = b.stopped;
    sg_scene_model_close(b.model);
    return NULL;
  }
  return b.model;
}

void
sg_scene_model_close(sg_scene_model *model)
{
  if (model) {
    sg_dense_clear(&model->dense);
    free(model->solid);
    free(model->line);
    free(model->use_begin);
    free(model->use);
    free(model);
  }
}
