/* shape_map.c -- see shape_map.h */
#include "shape_map.h"

static size_t
first_corner(const sg_shape_map *map, size_t shape)
{
  return shape > 0 ? map->end[shape - 1] : 0;
}

static sg_flat_box
wide_box(const sg_shape_map *map, size_t shape)
{
  size_t first = first_corner(map, shape);
  sg_flat_box box = sg_flat_box_round(map->at + first, map->end[shape] - first);
  double wide = 0;

  for (int k = 0; k < 2; k++) {
    double side = box.high[k] - box.low[k];
    wide = side > wide ? side : wide;
  }
  for (int k = 0; k < 2; k++) {
    box.low[k] -= map->near * wide;
    box.high[k] += map->near * wide;
  }
  return box;
}

bool
sg_shape_map_make(const double (*at)[2], const size_t *end, size_t shapes,
                  double near, sg_shape_map *out)
{
  *out = (sg_shape_map){.at = at, .end = end, .shapes = shapes, .near = near};
  sg_flat_box all = sg_flat_box_round(at, shapes > 0 ? end[shapes - 1] : 0);
  double size =
      shapes > 0 ? all.high[0] - all.low[0] + all.high[1] - all.low[1] : 0;

  if (!sg_flat_stock_make(shapes, size, &out->stock)) {
    return false;
  }
  for (size_t i = 0; i < shapes; i++) {
    out->stock.box[i] = wide_box(out, i);
  }
  for (size_t i = 0; i < shapes; i++) {
    if (!sg_flat_index_add(&out->index, &out->stock, (uint32_t)i)) {
      return false;
    }
  }
  return true;
}

void
sg_shape_map_clear(sg_shape_map *map)
{
  sg_flat_stock_clear(&map->stock);
}

typedef struct seeker {
  const sg_shape_map *map;
  const double *point;
  uint32_t first;
} seeker;

static bool
has_point(const sg_shape_map *map, size_t shape, const double p[2])
{
  size_t first = first_corner(map, shape), end = map->end[shape];

  for (size_t i = first, last = end - 1; i < end; last = i++) {
    const double *a = map->at[last], *b = map->at[i];
    double dx = b[0] - a[0], dy = b[1] - a[1];

    if (dx * (p[1] - a[1]) - dy * (p[0] - a[0]) <
        -map->near * (dx * dx + dy * dy)) {
      return false;
    }
  }
  return true;
}

static bool
note_shape(void *data, uint32_t item)
{
  seeker *s = data;

  if (item < s->first && has_point(s->map, item, s->point)) {
    s->first = item;
  }
  return false;
}

uint32_t
sg_shape_map_at(sg_shape_map *map, const double point[2])
{
  seeker s = {map, point, SG_NO_ITEM};
  const sg_flat_question question = {
      .box = {{point[0], point[1]}, {point[0], point[1]}}};

  sg_flat_index_near(&map->index, &map->stock, &question, note_shape, &s);
  return s.first;
}
