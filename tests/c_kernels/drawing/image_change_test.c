/* image_change_test.c -- pictures put together, fewer colours, lines on them,
 * without Prolog.
 *
 * covers: image_change_rows
 */
#include "doors/image.h"
#include "drawing/image_change.h"

#include "tests/c_kernels/door_call.h"
#include "tests/check.h"

#include <stdlib.h>
#include <string.h>

static const uint8_t *
dot(const sg_image *image, int32_t x, int32_t y)
{
  return image->dot + image->bytes * (size_t)(y * image->width + x);
}

static bool
is(const uint8_t *at, uint8_t r, uint8_t g, uint8_t b)
{
  return at[0] == r && at[1] == g && at[2] == b;
}

static void
put(sg_image *image)
{
  uint8_t clear[] = {255, 0, 0, 255, 255, 255, 255, 0, 0, 0, 0, 128};
  sg_image part = {.width = 3, .height = 1, .bytes = 4, .dot = clear};

  sg_image_put(image, 2, 1, &part);
  CHECK("what is opaque covers", is(dot(image, 2, 1), 255, 0, 0));
  CHECK("what is clear does not", is(dot(image, 3, 1), 10, 20, 30));
  sg_image_put(image, 3, 3, &part);
  CHECK("the rest is outside",
        is(dot(image, 3, 3), 255, 0, 0) && is(dot(image, 0, 3), 10, 20, 30));
  CHECK("put", sg_door_image_put(&call, image, -2, 0, &part));
  CHECK("half of the light of 10, 20, 30", is(dot(image, 0, 0), 5, 11, 19));
}

static void
colours(sg_image *image)
{
  const sg_colour two[] = {{0, 0, 0}, {255, 0, 0}};

  sg_image_colours(image, 2, two);
  CHECK("the nearest colour",
        is(dot(image, 2, 1), 255, 0, 0) && is(dot(image, 3, 1), 0, 0, 0));
}

static void
doors(void)
{
  sg_rgb paper = {10, 20, 30}, row[4] = {{1, 2, 3}};
  sg_rgb_list short_row = {row, 3, 0}, whole = {row, 4, 0}, none = {0};
  sg_paper_point from_to[] = {{0, 1.5}, {4, 1.5}};
  sg_canvas_line_fact line = {
      .colour = {0, 0, 0}, .width = 1, .points = {from_to, 2, 0}};
  sg_canvas_line_fact_list lines = {&line, 1, 0};
  sg_image *image = NULL;

  CHECK("blank", sg_door_image_blank(&call, 4, 4, &paper, &image) && image &&
                     is(dot(image, 3, 3), 10, 20, 30));
  if (!image) {
    return;
  }
  put(image);
  colours(image);
  CHECK("a row", sg_door_image_row(&call, image, 2, &whole) &&
                     is(dot(image, 0, 2), 1, 2, 3));
  CHECK("a short row", !sg_door_image_row(&call, image, 2, &short_row) &&
                           is_domain("image_row", 3));
  CHECK("no such row", !sg_door_image_row(&call, image, 4, &whole) &&
                           is_domain("image_dot", 2));
  CHECK("no colours",
        !sg_door_image_colours(&call, image, &none) && is_domain("colours", 2));
  CHECK("a line", sg_door_image_lines(&call, image, 1, &lines) &&
                      is(dot(image, 2, 1), 0, 0, 0));
  CHECK("no scale",
        !sg_door_image_lines(&call, image, 0, &lines) && is_domain("scale", 2));
  image->bytes = 4;
  CHECK("clear dots", !sg_door_image_lines(&call, image, 1, &lines) &&
                          is_domain("image_without_alpha", 1));
  sg_image_close(image);
  CHECK("too large", !sg_door_image_blank(&call, 0, 4, &paper, &image));
}

int
main(void)
{
  sg_call_open(&call, NULL, NULL);
  doors();
  sg_call_close(&call);
  return check_report();
}
