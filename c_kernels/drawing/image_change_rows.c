/* image_change_rows.c -- pictures put together, their colours, lines on them.
 */
#include "doors/image.h"

#include "image_change.h"
#include "raster_rows.h"

#include <stdlib.h>

static bool
without_alpha(sg_call *call, const sg_image *image)
{
  return image->bytes == 3 || sg_call_domain(call, "image_without_alpha", 1);
}

bool
sg_door_image_blank(sg_call *call, int32_t width, int32_t height,
                    const sg_rgb *rgb, sg_image **out)
{
  sg_colour colour;

  if (!sg_raster_size(call, width, height) ||
      !sg_rgb_colour(call, rgb, colour)) {
    return false;
  }
  *out = sg_image_blank(width, height, colour);
  return *out || sg_call_no_memory(call);
}

bool
sg_door_image_put(sg_call *call, sg_image *image, int32_t x, int32_t y,
                  sg_image *part)
{
  if (!without_alpha(call, image)) {
    return false;
  }
  sg_image_put(image, x, y, part);
  return true;
}

bool
sg_door_image_colours(sg_call *call, sg_image *image, const sg_rgb_list *list)
{
  sg_colour *colour = sg_call_alloc(call, (list->n + 1) * sizeof *colour);

  if (!without_alpha(call, image) || !colour) {
    return false;
  }
  if (list->n < 1 || list->n > 256) {
    return sg_call_domain(call, "colours", 2);
  }
  for (size_t i = 0; i < list->n; i++) {
    if (!sg_rgb_colour(call, &list->at[i], colour[i])) {
      return false;
    }
  }
  sg_image_colours(image, list->n, (const sg_colour *)colour);
  return true;
}

bool
sg_door_image_row(sg_call *call, sg_image *image, size_t y,
                  const sg_rgb_list *dots)
{
  if (!without_alpha(call, image)) {
    return false;
  }
  if (y >= (size_t)image->height) {
    return sg_call_domain(call, "image_dot", 2);
  }
  if (dots->n != (size_t)image->width) {
    return sg_call_domain(call, "image_row", 3);
  }
  for (size_t x = 0; x < dots->n; x++) {
    uint8_t *dot = image->dot + 3 * (y * (size_t)image->width + x);
    if (!sg_rgb_colour(call, &dots->at[x], dot)) {
      return false;
    }
  }
  return true;
}

bool
sg_door_image_lines(sg_call *call, sg_image *image, double scale,
                    const sg_canvas_line_fact_list *lines)
{
  sg_canvas canvas = {.width = image->width,
                      .height = image->height,
                      .dot = (sg_colour *)(void *)image->dot};

  if (!without_alpha(call, image) || !sg_canvas_scale(call, scale, 2)) {
    return false;
  }
  canvas.cover = calloc((size_t)image->width, (size_t)image->height);
  if (!canvas.cover) {
    return sg_call_no_memory(call);
  }
  bool good = sg_canvas_lines(call, &canvas, lines, scale, 3);

  free(canvas.cover);
  return good;
}
