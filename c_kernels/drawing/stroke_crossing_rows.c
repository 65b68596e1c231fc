/* stroke_crossing_rows.c -- stroke_crossings/2. */
#include "stroke_crossing.h"
#include "stroke_rows.h"

#include <stdlib.h>

/* Sets the points of a stroke; false: refused. */
static bool
read_points(sg_call *call, const sg_sheet_point_list *points,
            sg_crossing_stroke *out)
{
  int64_t(*at)[2] = sg_call_alloc(call, (points->n + 1) * sizeof *at);

  for (size_t i = 0; at && i < points->n; i++) {
    int32_t point[2];

    if (!sg_sheet_point_at(call, &points->at[i], point)) {
      return false;
    }
    at[i][0] = point[0];
    at[i][1] = point[1];
  }
  *out = (sg_crossing_stroke){(const int64_t(*)[2])at, points->n};
  return at != NULL;
}

bool
sg_door_stroke_crossings(sg_call *call, const sg_travelled_stroke_list *strokes,
                         sg_stroke_mark_list *out)
{
  sg_crossing_stroke *stroke =
      sg_call_alloc(call, (strokes->n + 1) * sizeof *stroke);
  sg_stroke_marks marks = {0};

  if (!stroke) {
    return false;
  }
  for (size_t i = 0; i < strokes->n; i++) {
    if (!read_points(call, &strokes->at[i].points, &stroke[i])) {
      return false;
    }
  }
  bool good = sg_stroke_crossings(stroke, strokes->n, &call->cancel, &marks) ||
              sg_call_ended(call);
  for (size_t i = 0; good && i < marks.n; i++) {
    good = sg_stroke_mark_list_add(call, out, marks.item[i]);
  }
  free(marks.item);
  return good;
}
