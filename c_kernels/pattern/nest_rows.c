/* nest_rows.c -- nest/7 and the shapes on paper. */
#include "doors/pattern.h"
#include "flat_shapes.h"
#include "nest.h"

#include <stdlib.h>
#include <string.h>

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

/* ---- nesting ---- */

/* The loops of a piece one after another. */
static bool
join_loops(sg_call *call, const sg_nest_piece_fact *from, sg_nest_piece *out)
{
  const sg_list_paper_point_list *loops = &from->loops;
  size_t points = 0;

  for (size_t i = 0; i < loops->n; i++) {
    points += loops->at[i].n;
  }
  sg_paper_point *at = sg_call_alloc(call, points * sizeof *at);
  size_t *end = sg_call_alloc(call, loops->n * sizeof *end);

  if (!at || !end) {
    return false;
  }
  *out = (sg_nest_piece){.at = (const double(*)[2])at,
                         .loop_end = end,
                         .loops = loops->n,
                         .degrees = from->degrees.at,
                         .angles = from->degrees.n};
  for (size_t i = 0; i < loops->n; i++) {
    if (loops->at[i].n > 0) {
      memcpy(&at[out->points], loops->at[i].at, loops->at[i].n * sizeof *at);
    }
    end[i] = out->points += loops->at[i].n;
  }
  return points > 0 || sg_call_domain(call, "outline", 5);
}

bool
sg_door_nest(sg_call *call, const sg_paper_point *size, double square,
             int32_t gap, bool one, const sg_nest_piece_fact_list *pieces,
             sg_nest_place_list *places, int64_t *work)
{
  const sg_nest_paper paper = {.width = size->x,
                               .height = size->y,
                               .square = square,
                               .gap = (unsigned)gap,
                               .one = one};
  size_t n = pieces->n;
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

  if (!piece || !place) {
    return false;
  }
  for (size_t i = 0; i < n; i++) {
    if (!join_loops(call, &pieces->at[i], &piece[i])) {
      return false;
    }
  }
  if (!sg_nest(&paper, piece, n, place, &looked, &call->cancel, &memory)) {
    return sg_call_ended(call);
  }
  *places = (sg_nest_place_list){place, n, n};
  *work = (int64_t)looked;
  return true;
}
