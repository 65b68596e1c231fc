/* winding.c -- how often triangles go round a point: see winding.h. */
#include "winding.h"

/* The turn a, b, p seen from +x, p shifted: never 0 unless a and b are seen
 * in one place. */
static int
shifted_turn(const sg_point *a, const sg_point *b, const sg_point *p)
{
  int turn = sg_point_turn(0, a, b, p);

  if (turn == 0) { /* by the shift in y, to the right of an edge that rises */
    turn = sg_point_compare(2, a, b);
  }
  return turn != 0 ? turn : -sg_point_compare(1, a, b);
}

int
sg_winding_of(const sg_point *a, const sg_point *b, const sg_point *c,
              const sg_point *p)
{
  if (sg_point_turn(0, a, b, c) == 0) {
    return 0;
  }
  int turn = shifted_turn(a, b, p);

  if (shifted_turn(b, c, p) != turn || shifted_turn(c, a, p) != turn) {
    return 0;
  }
  /* Counter-clockwise from +x, p is before it where p is below. */
  return sg_point_orient3d(a, b, c, p) == turn ? turn : 0;
}

/* Whether p is between a and b, all three on one line. */
static bool
is_between(const sg_point *a, const sg_point *b, const sg_point *p)
{
  for (int axis = 0; axis < 3; axis++) {
    if (sg_point_compare(axis, a, p) * sg_point_compare(axis, p, b) < 0) {
      return false;
    }
  }
  return true;
}

static bool
is_on_segment(const sg_point *a, const sg_point *b, const sg_point *p)
{
  for (int axis = 0; axis < 3; axis++) {
    if (sg_point_turn(axis, a, b, p) != 0) {
      return false;
    }
  }
  return is_between(a, b, p);
}

bool
sg_is_on_triangle(const sg_point *a, const sg_point *b, const sg_point *c,
                  const sg_point *p)
{
  if (sg_point_orient3d(a, b, c, p) != 0) {
    return false;
  }
  for (int axis = 0; axis < 3; axis++) {
    int area = sg_point_turn(axis, a, b, c);
    if (area != 0) {
      return sg_point_turn(axis, a, b, p) * area >= 0 &&
             sg_point_turn(axis, b, c, p) * area >= 0 &&
             sg_point_turn(axis, c, a, p) * area >= 0;
    }
  }
  return is_on_segment(a, b, p) || is_on_segment(b, c, p) ||
         is_on_segment(c, a, p);
}
