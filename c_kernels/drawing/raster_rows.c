/* raster_rows.c -- raster_dots/4 and raster_png/5. A raster is a string with
 * one code a dot, so nothing needs closing.
 */
#include "raster_rows.h"

#include "png.h"
#include "raster.h"

bool
sg_raster_size(sg_call *call, int32_t width, int32_t height)
{
  return sg_raster_size_is_valid(width, height) ||
         sg_call_domain_pair(call, "raster_size", 1);
}

bool
sg_rgb_colour(sg_call *call, const sg_rgb *rgb, sg_colour out)
{
  const int32_t part[3] = {rgb->red, rgb->green, rgb->blue};

  for (int i = 0; i < 3; i++) {
    if (part[i] < 0 || part[i] > UINT8_MAX) {
      return sg_call_domain_of(call, "byte", part[i]);
    }
    out[i] = (uint8_t)part[i];
  }
  return true;
}

/* ---- dots ---- */

static bool
is_far(int32_t x)
{
  return x < -SG_RASTER_FAR || x > SG_RASTER_FAR;
}

static bool
draw_stroke(sg_call *call, sg_raster *raster, const sg_dot_stroke *stroke)
{
  const sg_dot_point_list *points = &stroke->points;
  const sg_pen pen = {.ink = (uint8_t)stroke->ink,
                      .width = stroke->width,
                      .runs = stroke->runs.n,
                      .run = stroke->runs.at};

  if (stroke->ink < 0 || stroke->ink > UINT8_MAX) {
    return sg_call_domain_of(call, "ink", stroke->ink);
  }
  if (!sg_pen_is_valid(&pen)) {
    return sg_call_domain(call, "pen", 3);
  }
  for (size_t i = 0; i < points->n; i++) {
    const sg_dot_point *p = &points->at[i];

    if (is_far(p->x) || is_far(p->y)) {
      return sg_call_domain_of(call, "raster_coordinate",
                               is_far(p->x) ? p->x : p->y);
    }
  }
  return sg_raster_chain(raster, &pen, points->n,
                         (const int32_t(*)[2])points->at, &call->cancel);
}

bool
sg_door_raster_dots(sg_call *call, int32_t width, int32_t height,
                    const sg_dot_stroke_list *strokes, sg_bytes *dots)
{
  sg_raster raster;

  if (!sg_raster_size(call, width, height)) {
    return false;
  }
  if (!sg_raster_open(&raster, width, height)) {
    return sg_call_no_memory(call);
  }
  *dots = (sg_bytes){raster.dot, (size_t)width * (size_t)height};
  if (!sg_call_adopt(call, raster.dot)) {
    return false;
  }
  for (size_t i = 0; i < strokes->n; i++) {
    if (!draw_stroke(call, &raster, &strokes->at[i])) {
      return false;
    }
  }
  return true;
}

/* ---- a file ---- */

static bool
get_palette(sg_call *call, const sg_rgb_list *list, sg_colour palette[256])
{
  if (list->n == 0 || list->n > 256) {
    return sg_call_domain(call, "palette", 4);
  }
  for (size_t i = 0; i < list->n; i++) {
    if (!sg_rgb_colour(call, &list->at[i], palette[i])) {
      return false;
    }
  }
  return true;
}

bool
sg_door_raster_png(sg_call *call, int32_t width, int32_t height,
                   const sg_bytes *dots, const sg_rgb_list *list, sg_bytes *out)
{
  const sg_raster raster = {width, height, (uint8_t *)dots->at};
  sg_colour palette[256];
  uint8_t *file;

  if (!sg_raster_size(call, width, height) ||
      !get_palette(call, list, palette)) {
    return false;
  }
  if (dots->n != (size_t)width * (size_t)height) {
    return sg_call_domain(call, "raster_dots", 3);
  }
  switch (sg_png_write(&raster, list->n, (const sg_colour *)palette,
                       &call->cancel, &file, &out->n)) {
  case SG_PNG_OK:
    out->at = file;
    return sg_call_adopt(call, file);
  case SG_PNG_NO_COLOUR:
    return sg_call_domain(call, "palette", 4);
  case SG_PNG_NO_MEMORY:
  case SG_PNG_STOPPED:
    break;
  }
  return sg_call_ended(call);
}
