/* letter_rows_test.c -- letters as lines, through the functions of the doors.
 */
#include "doors/drawing.h"

#include "tests/c_kernels/door_call.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

static bool
is_at(const sg_sheet_point_list *line, size_t i, int64_t x, int64_t y)
{
  return i < line->n && line->at[i].x == x && line->at[i].y == y;
}

static sg_pen_point
corner(double x, double y)
{
  return (sg_pen_point){.is = SG_PEN_POINT_CORNER, .corner = {x, y}};
}

static void
letters(void)
{
  sg_pen_point bend = {.is = SG_PEN_POINT_C, .c = {4, 0}};
  sg_pen_point stroke[3] = {corner(0, 0), bend, corner(4, 4)};
  sg_pen_point_list strokes = {stroke, 3, 0};
  sg_pen_glyph glyph = {2, {&strokes, 1, 0}};
  const sg_pen_glyph_list glyphs = {&glyph, 1, 0};
  sg_list_sheet_point_list lines = {0};

  CHECK_DOOR("a curve",
             sg_door_letter_lines(&call, &glyphs, 100, 50, 16, &lines) &&
                 lines.n == 1 && lines.at[0].n == 5);
  CHECK("begins", is_at(&lines.at[0], 0, 132, 50));
  CHECK("its middle", is_at(&lines.at[0], 2, 132 + 48, 50 - 16));
  CHECK("ends", is_at(&lines.at[0], 4, 132 + 64, 50 - 64));
  strokes.n = 2;
  CHECK("a curve without an end",
        !sg_door_letter_lines(&call, &glyphs, 100, 50, 16, &lines) &&
            is_domain("stroke", 1));
}

/* Up along y, then turned by a quarter. */
static void
laid(void)
{
  sg_pen_point stroke[2] = {corner(0, 0), corner(1, 0.5)};
  sg_pen_point_list strokes = {stroke, 2, 0};
  sg_pen_glyph glyph = {0, {&strokes, 1, 0}};
  const sg_pen_glyph_list glyphs = {&glyph, 1, 0};
  const sg_sheet_move move = {0, 1, 3, 4, 10, 20};
  sg_list_sheet_point_list out = {0};

  CHECK_DOOR("laid", sg_door_laid_letters(
                         &call, &glyphs, 0, 1000, &(sg_paper_point){1, 2},
                         &(sg_paper_point){0, 1}, &move, 100, &out) &&
                         out.n == 1 && out.at[0].n == 2);
  CHECK("its place", is_at(&out.at[0], 0, 11000, 75000));
  CHECK("along, and beside it", is_at(&out.at[0], 1, 10000, 75500));
  strokes.n = 1;
  stroke[0].is = SG_PEN_POINT_C;
  CHECK("a curve that begins nowhere",
        !sg_door_laid_letters(&call, &glyphs, 0, 1000, &(sg_paper_point){1, 2},
                              &(sg_paper_point){0, 1}, &move, 100, &out) &&
            is_domain("stroke", 1));
}

int
main(void)
{
  sg_call_open(&call, NULL, NULL);
  letters();
  laid();
  sg_call_close(&call);
  return check_report();
}
