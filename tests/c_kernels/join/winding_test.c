/* winding_test.c -- points of a grid against boxes on it, alone, in each other,
 * hollow and inside out, where most rays meet edges and corners.
 */
#include "join/winding.h"
#include "tests/check.h"

#include <stdlib.h>

enum { BOXES = 4, SIDE = 5 };

typedef struct box {
  double lo[3], hi[3];
  int way; /* 1, or -1: inside out */
} box;

static box
random_box(void)
{
  box b;

  for (int k = 0; k < 3; k++) {
    int a = rand() % SIDE, c = rand() % (SIDE - 1);
    c += c >= a;
    b.lo[k] = a < c ? a : c;
    b.hi[k] = a < c ? c : a;
  }
  b.way = rand() % 4 ? 1 : -1;
  return b;
}

/* Corner i of a box: bit k of i is the end along axis k. */
static void
corner(const box *b, int i, sg_point *out)
{
  double at[3];

  for (int k = 0; k < 3; k++) {
    at[k] = i >> k & 1 ? b->hi[k] : b->lo[k];
  }
  sg_point_set(out, at);
}

/* The box's 12 triangles: what they count, and whether the point is on one. */
static int
count(const box *b, const sg_point *p, bool *on)
{
  static const int face[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                 {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  int turns = 0;

  for (int f = 0; f < 6; f++) {
    for (int half = 0; half < 2; half++) {
      sg_point v[3];
      int way[3] = {0, half + 1, half + 2};

      for (int k = 0; k < 3; k++) {
        corner(b, face[f][way[k]], &v[k]);
      }
      turns += b->way > 0 ? sg_winding_of(&v[0], &v[1], &v[2], p)
                          : sg_winding_of(&v[0], &v[2], &v[1], p);
      *on = *on || sg_is_on_triangle(&v[0], &v[1], &v[2], p);
    }
  }
  return turns;
}

/* 1 inside, 0 on the border, -1 outside. */
static int
where(const box *b, const double at[3])
{
  bool border = false;

  for (int k = 0; k < 3; k++) {
    if (at[k] < b->lo[k] || at[k] > b->hi[k]) {
      return -1;
    }
    border = border || at[k] == b->lo[k] || at[k] == b->hi[k];
  }
  return border ? 0 : 1;
}

static bool
is_right(void)
{
  box b[BOXES];
  double at[3];
  sg_point p;
  int turns = 0, wanted = 0;
  bool on = false, border = false;

  for (int i = 0; i < BOXES; i++) {
    b[i] = random_box();
  }
  for (int k = 0; k < 3; k++) {
    at[k] = rand() % (4 * SIDE) / 4.0;
  }
  sg_point_set(&p, at);
  for (int i = 0; i < BOXES; i++) {
    turns += count(&b[i], &p, &on);
    wanted += where(&b[i], at) > 0 ? b[i].way : 0;
    border = border || where(&b[i], at) == 0;
  }
  return on == border && (on || turns == wanted);
}

/* ---- triangles without area ---- */

/* Three points on one line through the grid, and one near it: on the needle if
 * it is one of the places between its ends. */
static bool
needle_is_right(int *on)
{
  double from[3] = {0}, way[3] = {0};
  sg_point v[3], p;
  int t[3], lo, hi, place = rand() % 7;
  bool beside;

  while (way[0] == 0 && way[1] == 0 && way[2] == 0) {
    for (int k = 0; k < 3; k++) {
      from[k] = rand() % 3;
      way[k] = rand() % 3 - 1;
    }
  }
  for (int i = 0; i < 3; i++) {
    t[i] = rand() % 5 + 1;
    sg_point_set(&v[i], (const double[3]){from[0] + t[i] * way[0],
                                          from[1] + t[i] * way[1],
                                          from[2] + t[i] * way[2]});
  }
  lo = t[0] < t[1] ? t[0] : t[1];
  hi = t[0] < t[1] ? t[1] : t[0];
  lo = t[2] < lo ? t[2] : lo;
  hi = t[2] > hi ? t[2] : hi;
  beside = rand() % 4 == 0;
  double at[3];
  for (int k = 0; k < 3; k++) {
    at[k] = from[k] + place * way[k];
  }
  for (int k = 0; beside && k < 3;
       k++) { /* along an axis that it runs across */
    if (way[k] == 0 || way[(k + 1) % 3] != 0 || way[(k + 2) % 3] != 0) {
      at[k] += 0.5;
      break;
    }
  }
  sg_point_set(&p, at);
  bool wanted = !beside && place >= lo && place <= hi;

  *on += wanted;
  return sg_is_on_triangle(&v[0], &v[1], &v[2], &p) == wanted &&
         sg_winding_of(&v[0], &v[1], &v[2], &p) == 0;
}

static void
test_needles(void)
{
  bool right = true;
  int on = 0;

  for (int i = 0; i < 20000; i++) {
    right = needle_is_right(&on) && right;
  }
  CHECK("needles", right);
  CHECK("many points on them", on > 4000);
}

int
main(void)
{
  bool right = true;
  sg_point v[4];

  srand(1988);
  for (int i = 0; i < 100000; i++) {
    right = is_right() && right;
  }
  CHECK("boxes on a grid", right);
  test_needles();
  for (int i = 0; i < 4; i++) {
    sg_point_set(&v[i], (const double[3]){i, 2 * i, 3 * i});
  }
  CHECK("on a needle", sg_is_on_triangle(&v[0], &v[1], &v[3], &v[2]));
  CHECK("beyond a needle", !sg_is_on_triangle(&v[0], &v[1], &v[2], &v[3]));
  CHECK("a needle counts nothing",
        sg_winding_of(&v[0], &v[1], &v[3], &v[2]) == 0);
  return check_report();
}
