/* scene_divided.c -- see scene_divided.h */
#include "scene_divided.h"

#include <stdlib.h>

static bool
divides(const sg_scene_added *added)
{
  return added->side[0] != added->side[1];
}

static void
push(sg_divided *divided, uint32_t of, int32_t a, int32_t b, int32_t c)
{
  divided->part[divided->n++] = (sg_divided_part){of, {a, b, c}};
}

static const double *
place_of(const sg_scene_input *in, int32_t at)
{
  size_t vertices = in->model->dense.vertices, i = (size_t)at;

  return i < vertices
             ? in->screen[i]
             : in->added[(i - vertices) / 2].screen[(i - vertices) % 2];
}

/* Twice the area in the picture: positive if they run counter-clockwise. */
static double
area(const double a[3], const double b[3], const double c[3])
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* True if a b c and a c d are turned the same way. */
static bool
turn_alike(const sg_scene_input *in, int32_t a, int32_t b, int32_t c, int32_t d)
{
  const double *p = place_of(in, a), *q = place_of(in, b), *r = place_of(in, c),
               *s = place_of(in, d);

  return (area(p, q, r) > 0.0) == (area(p, r, s) > 0.0);
}

/* The parts of a triangle from the ends of the i-th added line. */
static void
divide(sg_divided *divided, const sg_scene_input *in, size_t i)
{
  const sg_scene_added *added = &in->added[i];
  const sg_scene_model *m = in->model;
  uint32_t of = (uint32_t)added->divides;
  int32_t end = (int32_t)(m->dense.vertices + 2 * i);
  bool first = added->side[0] == (added->side[1] + 1) % 3;
  int32_t a = first ? end : end + 1, b = first ? end + 1 : end;
  int32_t corner[3]; /* p, q, r */

  for (int k = 0; k < 3; k++) {
    int32_t v = m->dense.corner[of][(added->side[first ? 0 : 1] + k) % 3];
    corner[k] = (int32_t)m->same[v];
  }
  push(divided, of, a, b, corner[0]);
  if (!turn_alike(in, a, corner[1], corner[2], b) &&
      turn_alike(in, b, a, corner[1], corner[2])) {
    push(divided, of, b, a, corner[1]);
    push(divided, of, b, corner[1], corner[2]);
  } else {
    push(divided, of, a, corner[1], corner[2]);
    push(divided, of, a, corner[2], b);
  }
  divided->is[of] = true;
}

bool
sg_divided_init(sg_divided *divided, const sg_scene_input *in)
{
  size_t n = 0;

  *divided = (sg_divided){0};
  for (size_t i = 0; i < in->addeds; i++) {
    n += divides(&in->added[i]);
  }
  if (n == 0) {
    return true;
  }
  divided->is = calloc(in->model->dense.triangles, sizeof *divided->is);
  divided->part = malloc(3 * n * sizeof *divided->part);
  if (!divided->is || !divided->part) {
    return false;
  }
  for (size_t i = 0; i < in->addeds; i++) {
    if (divides(&in->added[i])) {
      divide(divided, in, i);
    }
  }
  return true;
}

void
sg_divided_clear(sg_divided *divided)
{
  free(divided->is);
  free(divided->part);
  *divided = (sg_divided){0};
}
