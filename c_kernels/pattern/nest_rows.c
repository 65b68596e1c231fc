/* nest_rows.c -- nest/8 and the shapes on paper. */
#include "doors/pattern.h"
#include "flat_shapes.h"
#include "nest.h"
#include "shape_map.h"

#include <math.h>
#include <stdlib.h>

/* ---- shapes ---- */

void
sg_flat_shapes_close(sg_flat_shapes *shapes)
{
  sg_flat_shapes_clear(shapes);
  free(shapes);
}

bool
sg_door_shapes_open(sg_call *call, double size, sg_flat_shapes **out)
{
  if (!(size > 0)) {
    return sg_call_domain(call, "size", 1);
  }
  if (!(*out = malloc(sizeof **out))) {
    return sg_call_no_memory(call);
  }
  sg_flat_shapes_init(*out, size);
  return true;
}

static bool
make_shape(sg_call *call, const sg_paper_point_list *points, double size,
           sg_flat_shape *out)
{
  out->corners = 0;
  for (size_t i = 0; i < points->n && i < SG_FLAT_SHAPE_CORNERS; i++) {
    out->at[i][0] = points->at[i].x;
    out->at[i][1] = points->at[i].y;
    out->corners++;
  }
  return (points->n == out->corners && sg_flat_shape_is_valid(out, size)) ||
         sg_call_domain(call, "convex_shape", 2);
}

bool
sg_door_shapes_add(sg_call *call, sg_flat_shapes *shapes,
                   const sg_paper_point_list *points)
{
  sg_flat_shape shape;

  return make_shape(call, points, shapes->size, &shape) &&
         (sg_flat_shapes_add(shapes, &shape) || sg_call_no_memory(call));
}

bool
sg_door_shapes_free(sg_call *call, sg_flat_shapes *shapes,
                    const sg_paper_point_list *points, double tolerance)
{
  sg_flat_shape shape;

  if (!make_shape(call, points, shapes->size, &shape)) {
    return false;
  }
  return tolerance < 0 ? sg_call_domain(call, "not_less_than_zero", 3)
                       : sg_flat_shapes_free(shapes, &shape, tolerance);
}

/* ---- loops of points ---- */

/* Lists of points, one after another; NULL: no memory. */
typedef struct loops {
  double (*at)[2];
  size_t *end; /* [n] */
  size_t n, points;
} loops;

static bool
join_loops(const sg_paper_point_list *list, size_t n, loops *out)
{
  size_t points = 0;

  for (size_t i = 0; i < n; i++) {
    points += list[i].n;
  }
  *out = (loops){.at = malloc((points + 1) * sizeof *out->at),
                 .end = malloc((n + 1) * sizeof *out->end),
                 .n = n};
  if (!out->at || !out->end) {
    return false;
  }
  for (size_t i = 0; i < n; i++) {
    for (size_t k = 0; k < list[i].n; k++) {
      out->at[out->points][0] = list[i].at[k].x;
      out->at[out->points++][1] = list[i].at[k].y;
    }
    out->end[i] = out->points;
  }
  return true;
}

static void
free_loops(loops *l)
{
  free(l->at);
  free(l->end);
}

/* ---- maps ---- */

struct sg_mapped_shapes {
  loops shapes;
  sg_shape_map map;
};

void
sg_mapped_shapes_close(sg_mapped_shapes *map)
{
  sg_shape_map_clear(&map->map);
  free_loops(&map->shapes);
  free(map);
}

bool
sg_door_shape_map_open(sg_call *call, const sg_list_paper_point_list *shapes,
                       double near, sg_mapped_shapes **out)
{
  for (size_t i = 0; i < shapes->n; i++) {
    if (shapes->at[i].n == 0) {
      return sg_call_domain(call, "convex_shape", 1);
    }
  }
  sg_mapped_shapes *made = calloc(1, sizeof *made);

  if (made &&
      (!join_loops(shapes->at, shapes->n, &made->shapes) ||
       !sg_shape_map_make((const double(*)[2])made->shapes.at, made->shapes.end,
                          shapes->n, near, &made->map))) {
    sg_mapped_shapes_close(made);
    made = NULL;
  }
  *out = made;
  return made || sg_call_no_memory(call);
}

bool
sg_door_shape_at(sg_call *call, sg_mapped_shapes *map,
                 const sg_paper_point *point, int32_t *i)
{
  uint32_t shape =
      sg_shape_map_at(&map->map, (const double[2]){point->x, point->y});

  (void)call;
  *i = (int32_t)(shape + 1);
  return shape != SG_NO_ITEM;
}

/* ---- boxes ---- */

static sg_paper_point
turned_box(const sg_paper_point_list *points, double degrees)
{
  double angle = degrees * 3.14159265358979323846 / 180;
  double c = cos(angle), s = sin(angle);
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};

  for (size_t i = 0; i < points->n; i++) {
    const sg_paper_point *p = &points->at[i];
    const double at[2] = {p->x * c - p->y * s, p->x * s + p->y * c};

    for (int k = 0; k < 2; k++) {
      low[k] = fmin(low[k], at[k]);
      high[k] = fmax(high[k], at[k]);
    }
  }
  return (sg_paper_point){high[0] - low[0], high[1] - low[1]};
}

bool
sg_door_turned_boxes(sg_call *call, const sg_paper_point_list *points,
                     const sg_number_list *degrees, sg_paper_point_list *sizes)
{
  sg_paper_point *at = sg_call_alloc(call, degrees->n * sizeof *at);

  if (points->n == 0) {
    return sg_call_domain(call, "points", 1);
  }
  for (size_t i = 0; at && i < degrees->n; i++) {
    at[i] = turned_box(points, degrees->at[i]);
  }
  *sizes = (sg_paper_point_list){at, degrees->n, degrees->n};
  return at != NULL;
}

/* ---- nesting ---- */

struct sg_nest_outlines {
  loops *piece; /* [n] */
  size_t n;
  sg_nest_masks *masks;
};

void
sg_nest_outlines_close(sg_nest_outlines *nest)
{
  for (size_t i = 0; nest && i < nest->n; i++) {
    free_loops(&nest->piece[i]);
  }
  if (nest) {
    sg_nest_masks_close(nest->masks);
    free(nest->piece);
  }
  free(nest);
}

bool
sg_door_nest_open(sg_call *call, const sg_list_list_paper_point_list *outlines,
                  sg_nest_outlines **out)
{
  sg_nest_outlines *nest = calloc(1, sizeof *nest);
  bool ok = nest != NULL, whole = true;

  if (ok) {
    nest->piece = calloc(outlines->n + 1, sizeof *nest->piece);
    nest->masks = sg_nest_masks_open(outlines->n);
    ok = nest->piece && nest->masks;
  }
  for (size_t i = 0; ok && i < outlines->n; i++) {
    const sg_list_paper_point_list *from = &outlines->at[i];

    nest->n++;
    ok = join_loops(from->at, from->n, &nest->piece[i]);
    whole = whole && nest->piece[i].points > 0;
  }
  if (ok && whole) {
    *out = nest;
    return true;
  }
  sg_nest_outlines_close(nest);
  return ok ? sg_call_domain(call, "outline", 1) : sg_call_no_memory(call);
}

static bool
turned_pieces(sg_call *call, const sg_nest_outlines *nest,
              const sg_nest_turn_list *turns, sg_nest_piece *piece)
{
  for (size_t i = 0; i < turns->n; i++) {
    const sg_nest_turn *turn = &turns->at[i];
    size_t number = (size_t)turn->piece - 1;

    if (number >= nest->n) {
      return sg_call_domain(call, "nest_turn", 6);
    }
    const loops *from = &nest->piece[number];

    piece[i] = (sg_nest_piece){.at = (const double(*)[2])from->at,
                               .points = from->points,
                               .loop_end = from->end,
                               .loops = from->n,
                               .degrees = turn->degrees.at,
                               .angles = turn->degrees.n,
                               .number = number};
  }
  return true;
}

bool
sg_door_nest(sg_call *call, const sg_paper_point *size, double square,
             int32_t gap, bool one, sg_nest_outlines *nest,
             const sg_nest_turn_list *turns, sg_nest_place_list *places,
             int64_t *work)
{
  const sg_nest_paper paper = {.width = size->x,
                               .height = size->y,
                               .square = square,
                               .gap = (unsigned)gap,
                               .one = one};
  size_t n = turns->n;
  uint64_t looked = 0;
  bool memory;

  if (gap < 0 || gap > 100) {
    return sg_call_domain(call, "gap", 3);
  }
  if (!sg_nest_paper_is_valid(&paper)) {
    return sg_call_domain(call, "paper", 1);
  }
  sg_nest_piece *piece = sg_call_alloc(call, n * sizeof *piece);
  sg_nest_place *place = sg_call_alloc(call, n * sizeof *place);

  if (!piece || !place || !turned_pieces(call, nest, turns, piece)) {
    return false;
  }
  if (!sg_nest(&paper, piece, n, nest->masks, place, &looked, &call->cancel,
               &memory)) {
    return sg_call_ended(call);
  }
  *places = (sg_nest_place_list){place, n, n};
  *work = (int64_t)looked;
  return true;
}
