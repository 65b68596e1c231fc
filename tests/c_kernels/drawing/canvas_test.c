/* canvas_test.c -- smooth lines, and a canvas as a PNG file.
 *
 * What a line covers is held against the area it has, and against the same
 * line drawn otherwise: turned, in pieces, the other way round.
 */
#include "tests/check.h"

#include "drawing/png.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 100 };

static const sg_colour white = {255, 255, 255}, black = {0, 0, 0};

/* How many dots are covered, in whole dots. */
static double
ink(const sg_canvas *c)
{
  double sum = 0;

  for (int32_t i = 0; i < c->width * c->height; i++) {
    sum += (255 - c->dot[i][0]) / 255.0;
  }
  return sum;
}

static double
line_ink(double width, bool round, size_t n, const double (*point)[2])
{
  sg_canvas c;
  sg_brush brush = {width, {0, 0, 0}, round};
  double sum = -1;

  if (sg_canvas_open(&c, SIDE, SIDE, white)) {
    if (sg_canvas_line(&c, &brush, n, point, NULL)) {
      sum = ink(&c);
    }
    sg_canvas_clear(&c);
  }
  return sum;
}

/* A line of length 60 that is turned by `degrees` has its area. */
static bool
area_is_right(double degrees, double width, bool round)
{
  double turn = degrees * acos(-1) / 180;
  double x = 30 * cos(turn), y = 30 * sin(turn);
  double line[2][2] = {{50 - x, 50.3 - y}, {50 + x, 50.3 + y}};
  double area = 60 * width + (round ? acos(-1) * width * width / 4 : 0);
  double sum = line_ink(width, round, 2, (const double(*)[2])line);
  double most = 0.02 * area + 0.5;

  return fabs(sum - area) <= most;
}

static bool
areas_are_right(void)
{
  static const double widths[] = {0.3, 1, 2.5, 9};

  for (int degrees = 0; degrees < 180; degrees += 7) {
    for (int i = 0; i < 4; i++) {
      if (!area_is_right(degrees, widths[i], true) ||
          !area_is_right(degrees, widths[i], false)) {
        return false;
      }
    }
  }
  return true;
}

/* Along a row: dots are covered as far as they are, exactly. */
static bool
row_is_exact(void)
{
  static const double line[2][2] = {{10, 20.25}, {30, 20.25}};
  sg_canvas c;
  sg_brush brush = {1, {0, 0, 0}, false};
  bool ok = sg_canvas_open(&c, 40, 40, white) &&
            sg_canvas_line(&c, &brush, 2, line, NULL);

  for (int32_t x = 0; ok && x < 40; x++) {
    bool in = x >= 10 && x < 30;

    ok = c.dot[19 * 40 + x][0] == (in ? 255 - 64 : 255) &&
         c.dot[20 * 40 + x][0] == (in ? 255 - 191 : 255) &&
         c.dot[21 * 40 + x][0] == 255;
  }
  sg_canvas_clear(&c);
  return ok;
}

/* A corner is covered once, and pieces in line as one. */
static bool
pieces_are_one(void)
{
  static const double line[2][2] = {{11, 13}, {71, 73}};
  static const double pieces[4][2] = {{11, 13}, {21, 23}, {51, 53}, {71, 73}};
  static const double again[3][2] = {{11, 13}, {71, 73}, {11, 13}};
  double whole = line_ink(3, true, 2, line);

  return fabs(line_ink(3, true, 4, pieces) - whole) < 0.5 &&
         fabs(line_ink(3, true, 3, again) - whole) < 0.5;
}

static bool
outside_is_left_out(void)
{
  static const double line[2][2] = {{-500, 50}, {600, 50}};
  static const double away[2][2] = {{-500, -50}, {600, -30}};

  return fabs(line_ink(2, true, 2, line) - 2 * SIDE) < 0.5 &&
         line_ink(2, true, 2, away) == 0;
}

static bool
a_point_is_a_dot(void)
{
  static const double point[1][2] = {{50, 50}};
  static const double twice[2][2] = {{50, 50}, {50, 50}};
  double area = acos(-1) * 4;

  return fabs(line_ink(4, true, 1, point) - area) < 0.5 &&
         fabs(line_ink(4, true, 2, twice) - area) < 0.5;
}

static bool
stop(void *data)
{
  (void)data;
  return true;
}

static bool
poll_stops(void)
{
  static const double line[2][2] = {{1, 1}, {9, 9}};
  sg_cancel cancel = {stop, NULL};
  sg_brush brush = {1, {0, 0, 0}, true};
  sg_canvas c;
  bool ok = sg_canvas_open(&c, 10, 10, black) &&
            !sg_canvas_line(&c, &brush, 2, line, &cancel);

  sg_canvas_clear(&c);
  return ok;
}

/* The file says that it is in colour and how large it is. */
static bool
file_is_png(void)
{
  static const uint8_t start[] = {137, 80, 78, 71, 13, 10, 26, 10, 0, 0,
                                  0,   13, 73, 72, 68, 82, 0,  0,  0, 7,
                                  0,   0,  0,  5,  8,  2,  0,  0,  0};
  static const uint8_t size[] = {0, 0,  0,   9, 'p', 'H', 'Y', 's', 0,
                                 0, 23, 112, 0, 0,   23,  112, 1};
  sg_canvas c;
  uint8_t *bytes = NULL;
  size_t n = 0;
  bool ok = sg_canvas_open(&c, 7, 5, black) &&
            sg_png_write_canvas(&c, 6000, NULL, &bytes, &n) == SG_PNG_OK &&
            n > 60 && !memcmp(bytes, start, sizeof start) &&
            !memcmp(bytes + 33, size, sizeof size) &&
            !memcmp(bytes + n - 8, "IEND", 4);

  free(bytes);
  sg_canvas_clear(&c);
  return ok;
}

static bool
count(void *data)
{
  ++*(int *)data;
  return false;
}

/* One piece that covers a large picture is long work. */
static bool
poll_is_asked(void)
{
  const double line[2][2] = {{0, 1000}, {2000, 1000}};
  const sg_brush brush = {.width = 2000};
  int asked = 0;
  sg_cancel cancel = {count, &asked};
  sg_canvas c;
  bool good = sg_canvas_open(&c, 2000, 2000, white) &&
              sg_canvas_line(&c, &brush, 2, line, &cancel);

  sg_canvas_clear(&c);
  return good && asked > 50;
}

int
main(void)
{
  CHECK("areas are right", areas_are_right());
  CHECK("along a row exact", row_is_exact());
  CHECK("pieces are one line", pieces_are_one());
  CHECK("outside is left out", outside_is_left_out());
  CHECK("a point is a dot", a_point_is_a_dot());
  CHECK("poll stops", poll_stops());
  CHECK("poll is asked within a piece", poll_is_asked());
  CHECK("the file is a PNG", file_is_png());
  return check_report();
}
