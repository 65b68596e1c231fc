/* flat_shapes.c -- see flat_shapes.h */
#include "flat_shapes.h"
#include "engine/list.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* So many times its size a shape may be away from the origin. */
#define FAR 1e9

/* ---- two shapes ---- */

static void
project(const sg_flat_shape *shape, const double axis[2], double range[2])
{
  range[0] = INFINITY;
  range[1] = -INFINITY;
  for (unsigned i = 0; i < shape->corners; i++) {
    double x = axis[0] * shape->at[i][0] + axis[1] * shape->at[i][1];

    range[0] = x < range[0] ? x : range[0];
    range[1] = x > range[1] ? x : range[1];
  }
}

/* The least way along a normal of one of a's sides that parts a and b. */
static double
depth_by_sides_of(const sg_flat_shape *a, const sg_flat_shape *b)
{
  double least = INFINITY;

  for (unsigned i = 0; i < a->corners; i++) {
    const double *p = a->at[i], *q = a->at[(i + 1) % a->corners];
    double axis[2] = {q[1] - p[1], p[0] - q[0]};
    double length = hypot(axis[0], axis[1]);
    double ra[2], rb[2];

    if (!(length > 0.0)) {
      continue;
    }
    axis[0] /= length;
    axis[1] /= length;
    project(a, axis, ra);
    project(b, axis, rb);
    least = fmin(least, fmin(ra[1] - rb[0], rb[1] - ra[0]));
  }
  return least;
}

double
sg_flat_shape_depth(const sg_flat_shape *a, const sg_flat_shape *b)
{
  return fmin(depth_by_sides_of(a, b), depth_by_sides_of(b, a));
}

bool
sg_flat_shape_is_valid(const sg_flat_shape *shape, double size)
{
  if (shape->corners < 2 || shape->corners > SG_FLAT_SHAPE_CORNERS) {
    return false;
  }
  for (unsigned i = 0; i < shape->corners; i++) {
    for (int k = 0; k < 2; k++) {
      if (!(fabs(shape->at[i][k]) <= FAR * size)) {
        return false;
      }
    }
  }
  return true;
}

/* ---- many ---- */

void
sg_flat_shapes_init(sg_flat_shapes *shapes, double size)
{
  *shapes = (sg_flat_shapes){.size = size};
}

void
sg_flat_shapes_clear(sg_flat_shapes *shapes)
{
  free(shapes->shape);
  sg_flat_stock_clear(&shapes->stock);
  *shapes = (sg_flat_shapes){.size = shapes->size};
}

/* Counter-clockwise. */
static sg_flat_shape
turned_round(const sg_flat_shape *shape)
{
  sg_flat_shape out = *shape;
  double area = 0;

  for (unsigned i = 1; i + 1 < shape->corners; i++) {
    const double *p = shape->at[0], *q = shape->at[i], *r = shape->at[i + 1];
    area += (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  }
  for (unsigned i = 0; area < 0 && i < shape->corners; i++) {
    memcpy(out.at[i], shape->at[shape->corners - 1 - i], sizeof out.at[i]);
  }
  return out;
}

static bool
have_room(sg_flat_shapes *shapes)
{
  return sg_list_grow(&shapes->shape, shapes->n, &shapes->room,
                      sizeof *shapes->shape) &&
         (shapes->stock.box
              ? sg_flat_stock_reserve(&shapes->stock, shapes->room)
              : sg_flat_stock_make(shapes->room, shapes->size, &shapes->stock));
}

bool
sg_flat_shapes_add(sg_flat_shapes *shapes, const sg_flat_shape *shape)
{
  if (shapes->n == SG_NO_ITEM || !have_room(shapes)) {
    return false;
  }
  uint32_t item = (uint32_t)shapes->n++;

  shapes->shape[item] = turned_round(shape);
  shapes->stock.box[item] =
      sg_flat_box_round((const double(*)[2])shape->at, shape->corners);
  return sg_flat_index_add(&shapes->index, &shapes->stock, item);
}

static size_t
corners_of(const void *data, uint32_t item, double out[][2])
{
  const sg_flat_shape *shape = &((const sg_flat_shapes *)data)->shape[item];

  memcpy(out, shape->at, shape->corners * sizeof *out);
  return shape->corners;
}

/* A shape that wants room. */
typedef struct newcomer {
  const sg_flat_shapes *shapes;
  const sg_flat_shape *shape;
  double tolerance;
} newcomer;

static bool
is_in_the_way(void *data, uint32_t item)
{
  const newcomer *of = data;

  return sg_flat_shape_depth(of->shape, &of->shapes->shape[item]) >
         of->tolerance;
}

bool
sg_flat_shapes_free(sg_flat_shapes *shapes, const sg_flat_shape *shape,
                    double tolerance)
{
  const sg_flat_shape turned = turned_round(shape);
  newcomer of = {shapes, &turned, tolerance};
  const sg_flat_question question = {
      .box = sg_flat_box_round((const double(*)[2])turned.at, turned.corners),
      .corner = (const double(*)[2])turned.at,
      .corners = turned.corners,
      .depth = tolerance,
      .corners_of = corners_of,
      .items = shapes};

  return !sg_flat_index_near(&shapes->index, &shapes->stock, &question,
                             is_in_the_way, &of);
}
