/* travel_rows.c -- travel_order/3. */
#include "stroke_rows.h"
#include "travel.h"

bool
sg_door_travel_order(sg_call *call, const sg_sheet_point *start,
                     const sg_travelled_stroke_list *strokes,
                     sg_integer_list *out)
{
  size_t n = strokes->n;
  sg_travel_line *line = sg_call_alloc(call, n * sizeof *line);
  int64_t *order = sg_call_alloc(call, n * sizeof *order), from[2];
  bool memory;

  if (!line || !order || !sg_sheet_point_at(call, start, from)) {
    return false;
  }
  for (size_t i = 0; i < n; i++) {
    const sg_sheet_point_list *points = &strokes->at[i].points;

    if (points->n == 0) {
      return sg_call_domain(call, "stroke", 2);
    }
    if (!sg_sheet_point_at(call, &points->at[0], line[i].at[0]) ||
        !sg_sheet_point_at(call, &points->at[points->n - 1], line[i].at[1])) {
      return false;
    }
  }
  if (!sg_travel_order(line, n, from, order, &call->cancel, &memory)) {
    return sg_call_ended(call);
  }
  *out = (sg_integer_list){order, n, n};
  return true;
}
