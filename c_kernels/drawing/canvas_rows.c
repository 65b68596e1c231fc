/* canvas_rows.c -- canvas_png/6. */
#include "png.h"
#include "raster_rows.h"

static bool
is_far(double x)
{
  return !(x >= -SG_RASTER_FAR && x <= SG_RASTER_FAR);
}

/* The points in dots, null: refused. */
static double (*scaled(sg_call *call, const sg_paper_point_list *points,
                       double scale, int argument))[2]
{
  double(*at)[2] = sg_call_alloc(call, points->n * sizeof *at);

  for (size_t i = 0; at && i < points->n; i++) {
    at[i][0] = points->at[i].x * scale;
    at[i][1] = points->at[i].y * scale;
    if (is_far(at[i][0]) || is_far(at[i][1])) {
      sg_call_domain(call, "raster_coordinate", argument);
      return NULL;
    }
  }
  return at;
}

static bool
draw_line(sg_call *call, sg_canvas *canvas, const sg_canvas_line_fact *line,
          double scale, int argument)
{
  sg_brush brush = {.width = line->width * scale, .round = line->round};

  if (!sg_rgb_colour(call, &line->colour, brush.colour)) {
    return false;
  }
  if (!(brush.width > 0 && brush.width <= SG_RASTER_SIDE)) {
    return sg_call_domain(call, "pen_width", argument);
  }
  if (line->points.n == 0) {
    return sg_call_domain(call, "line_of_points", argument);
  }
  double(*at)[2] = scaled(call, &line->points, scale, argument);

  return at && sg_canvas_line(canvas, &brush, line->points.n,
                              (const double(*)[2])at, &call->cancel);
}

bool
sg_canvas_lines(sg_call *call, sg_canvas *canvas,
                const sg_canvas_line_fact_list *lines, double scale,
                int argument)
{
  for (size_t i = 0; i < lines->n; i++) {
    if (!draw_line(call, canvas, &lines->at[i], scale, argument)) {
      return false;
    }
  }
  return true;
}

bool
sg_canvas_scale(sg_call *call, double scale, int argument)
{
  return (scale > 0 && scale <= 1000) ||
         sg_call_domain(call, "scale", argument);
}

bool
sg_door_canvas_png(sg_call *call, int32_t width, int32_t height, double scale,
                   const sg_rgb *paper, const sg_canvas_line_fact_list *lines,
                   sg_bytes *out)
{
  sg_colour blank;
  sg_canvas canvas;
  uint8_t *file = NULL;

  if (!sg_rgb_colour(call, paper, blank) ||
      !sg_raster_size(call, width, height) ||
      !sg_canvas_scale(call, scale, 3)) {
    return false;
  }
  if (!sg_canvas_open(&canvas, width, height, blank)) {
    return sg_call_no_memory(call);
  }
  bool good =
      sg_canvas_lines(call, &canvas, lines, scale, 5) &&
      (sg_png_write_canvas(&canvas, (uint32_t)(scale * 1e6 + 0.5),
                           &call->cancel, &file, &out->n) == SG_PNG_OK ||
       sg_call_ended(call));

  sg_canvas_clear(&canvas);
  out->at = file;
  return good && sg_call_adopt(call, file);
}
