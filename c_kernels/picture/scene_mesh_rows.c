/* scene_mesh_rows.c -- a model for who turns it himself: scene_mesh/5. */
#include "scene_rows.h"

#include <math.h>
#include <string.h>

/* Words of four octets, the lowest first. */
static uint8_t *
put_word(uint8_t *out, uint32_t word)
{
  for (int k = 0; k < 4; k++) {
    *out++ = (uint8_t)(word >> 8 * k);
  }
  return out;
}

static uint8_t *
put_float(uint8_t *out, double x)
{
  float near = (float)x;
  uint32_t word;

  memcpy(&word, &near, sizeof word);
  return put_word(out, word);
}

static sg_xyz
middle_of(const sg_dense *dense)
{
  sg_xyz out = {{0}};

  for (int k = 0; k < 3 && dense->vertices > 0; k++) {
    double low = dense->at[0][k], high = low;

    for (size_t i = 1; i < dense->vertices; i++) {
      low = fmin(low, dense->at[i][k]);
      high = fmax(high, dense->at[i][k]);
    }
    out.at[k] = 0.5 * low + 0.5 * high;
  }
  return out;
}

/* Is a line drawn from wherever it is seen? The others only where they are
 * outlines (rules/picture/role.pl). */
static bool
is_sharp(const sg_look *look, double crease)
{
  return look->cut || look->faces < 2 || look->edge ||
         (look->bend > crease && !look->speck);
}

static uint8_t *
put_lines(uint8_t *out, const sg_scene *scene, double crease, bool sharp)
{
  for (size_t i = 0; i < scene->lines; i++) {
    const sg_scene_line *line = &scene->line[i];

    if (line->number != UINT32_MAX && is_sharp(&line->look, crease) == sharp) {
      out = put_word(put_word(out, line->a), line->b);
    }
  }
  return out;
}

static sg_mesh_counts
count(const sg_scene *scene, double crease)
{
  const sg_dense *dense = &scene->model->dense;
  sg_mesh_counts out = {.vertices = dense->vertices,
                        .triangles = dense->triangles};

  for (size_t i = 0; i < scene->lines; i++) {
    const sg_scene_line *line = &scene->line[i];

    out.lines += line->number != UINT32_MAX;
    out.sharp += line->number != UINT32_MAX && is_sharp(&line->look, crease);
  }
  return out;
}

bool
sg_door_scene_mesh(sg_call *call, sg_scene_index *index, double crease,
                   sg_xyz *middle, sg_mesh_counts *counts, sg_bytes *octets)
{
  const sg_scene *scene = index->scene;
  const sg_dense *dense = &scene->model->dense;

  *middle = middle_of(dense);
  *counts = count(scene, crease);
  size_t words = 3 * (counts->vertices + counts->triangles) + 2 * counts->lines;
  uint8_t *at = sg_call_alloc(call, 4 * words), *out = at;

  if (!at) {
    return false;
  }
  for (size_t i = 0; i < dense->vertices; i++) {
    for (int k = 0; k < 3; k++) {
      out = put_float(out, dense->at[i][k] - middle->at[k]);
    }
  }
  for (size_t i = 0; i < dense->triangles; i++) {
    for (int k = 0; k < 3; k++) {
      out = put_word(out, (uint32_t)dense->corner[i][k]);
    }
  }
  out = put_lines(out, scene, crease, true);
  out = put_lines(out, scene, crease, false);
  *octets = (sg_bytes){at, 4 * words};
  return true;
}
