/* nest_rows_test.c -- shapes on paper and pieces on sheets, through the
 * functions of the doors, without Prolog.
 */
#include "doors/pattern.h"
#include "pattern/flat_shapes.h"

#include "tests/c_kernels/door_call.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

#include <math.h>
#include <string.h>

/* A square from x to x + 10, as high. */
static sg_paper_point_list
square(sg_paper_point at[4], double x)
{
  for (int i = 0; i < 4; i++) {
    at[i] = (sg_paper_point){x + (i == 1 || i == 2 ? 10 : 0), i < 2 ? 0 : 10};
  }
  return (sg_paper_point_list){at, 4, 0};
}

static void
shapes(void)
{
  sg_paper_point a[4], b[4], few[4];
  const sg_paper_point_list one = square(a, 0), other = square(b, 9);
  sg_paper_point_list point = square(few, 0);
  sg_flat_shapes *all = NULL;

  point.n = 1;
  CHECK("no size",
        !sg_door_shapes_open(&call, 0, &all) && is_domain("size", 1));
  CHECK_DOOR("open", sg_door_shapes_open(&call, 10, &all));
  CHECK_DOOR("free", sg_door_shapes_free(&call, all, &one, 0));
  CHECK_DOOR("add", sg_door_shapes_add(&call, all, &one));
  CHECK("overlaps by 1", !sg_door_shapes_free(&call, all, &other, 0.5) &&
                             call.refusal.how == SG_REFUSED_NOTHING);
  CHECK_DOOR("no deeper than 2", sg_door_shapes_free(&call, all, &other, 2));
  CHECK("below 0", !sg_door_shapes_free(&call, all, &other, -1) &&
                       is_domain("not_less_than_zero", 3));
  CHECK("a point", !sg_door_shapes_add(&call, all, &point) &&
                       is_domain("convex_shape", 2));
  sg_flat_shapes_close(all);
}

/* Of so many corners the first ones alone would be a shape, too. */
static void
corners(void)
{
  enum { MOST = SG_FLAT_SHAPE_CORNERS };
  sg_paper_point at[MOST + 1];
  sg_paper_point_list round = {at, MOST, 0};
  sg_flat_shapes *all = NULL;

  for (int i = 0; i <= MOST; i++) {
    double angle = 2 * 3.14159265358979 * i / (MOST + 1);
    at[i] = (sg_paper_point){5 + 4 * cos(angle), 5 + 4 * sin(angle)};
  }
  CHECK_DOOR("open", sg_door_shapes_open(&call, 10, &all));
  CHECK_DOOR("most corners", sg_door_shapes_free(&call, all, &round, 0) &&
                                 sg_door_shapes_add(&call, all, &round));
  round.n = MOST + 1;
  CHECK("one more", !sg_door_shapes_add(&call, all, &round) &&
                        is_domain("convex_shape", 2));
  CHECK("nor asked about", !sg_door_shapes_free(&call, all, &round, 0) &&
                               is_domain("convex_shape", 2));
  sg_flat_shapes_close(all);
}

static bool
nest_also(double width, int32_t gap, bool one, size_t loops, int32_t last,
          sg_nest_place_list *places)
{
  static double upright[] = {0};
  sg_paper_point at[4];
  sg_paper_point_list loop = square(at, 0);
  sg_list_paper_point_list outline[2] = {{&loop, loops, 0}, {&loop, 1, 0}};
  sg_nest_turn turn[2] = {{1, {upright, 1, 0}}, {last, {upright, 1, 0}}};
  const sg_paper_point size = {width, 12};
  sg_nest_outlines *outlines = NULL;
  int64_t work = 0;
  bool ok = sg_door_nest_open(
      &call, &(sg_list_list_paper_point_list){outline, 2, 0}, &outlines);

  ok = ok &&
       sg_door_nest(&call, &size, 0.5, gap, one, outlines,
                    &(sg_nest_turn_list){turn, 2, 0}, places, &work) &&
       work > 0;
  sg_nest_outlines_close(outlines);
  return ok;
}

static bool
nest(double width, int32_t gap, bool one, size_t loops,
     sg_nest_place_list *places)
{
  return nest_also(width, gap, one, loops, 2, places);
}

/* Which of the shapes has a point. */
static void
maps(void)
{
  sg_paper_point a[4], b[4];
  sg_paper_point_list shape[2] = {square(a, 0), square(b, 9)}, none = {a, 0, 0};
  sg_mapped_shapes *map = NULL;
  int32_t i = 0;

  CHECK_DOOR("map",
             sg_door_shape_map_open(
                 &call, &(sg_list_paper_point_list){shape, 2, 0}, 1e-6, &map));
  CHECK_DOOR("first",
             sg_door_shape_at(&call, map, &(sg_paper_point){1, 1}, &i) &&
                 i == 1);
  CHECK_DOOR("both",
             sg_door_shape_at(&call, map, &(sg_paper_point){9.5, 1}, &i) &&
                 i == 1);
  CHECK_DOOR("second",
             sg_door_shape_at(&call, map, &(sg_paper_point){15, 1}, &i) &&
                 i == 2);
  CHECK("none", !sg_door_shape_at(&call, map, &(sg_paper_point){20, 1}, &i) &&
                    call.refusal.how == SG_REFUSED_NOTHING);
  sg_mapped_shapes_close(map);
  CHECK("no corners",
        !sg_door_shape_map_open(&call, &(sg_list_paper_point_list){&none, 1, 0},
                                1e-6, &map) &&
            is_domain("convex_shape", 1));
}

static void
nests(void)
{
  sg_nest_place_list p = {0};

  CHECK_DOOR("beside", nest(30, 1, false, 1, &p) && p.n == 2);
  CHECK("on one sheet", p.at[0].sheet == 1 && p.at[1].sheet == 1 &&
                            p.at[1].by[0] >= p.at[0].by[0] + 10);
  CHECK_DOOR("narrow", nest(12, 1, false, 1, &p) && p.n == 2);
  CHECK("on two", p.at[0].sheet == 1 && p.at[1].sheet == 2);
  CHECK_DOOR("one sheet", nest(12, 1, true, 1, &p));
  CHECK("does not take both", p.at[0].sheet == 1 && p.at[1].sheet == 0);
  CHECK("no outline", !nest(30, 1, false, 0, &p) && is_domain("outline", 1));
  CHECK("no such piece",
        !nest_also(30, 1, false, 1, 3, &p) && is_domain("nest_turn", 6));
  CHECK("no gap", !nest(30, -1, false, 1, &p) && is_domain("gap", 3));
  CHECK("no paper", !nest(-30, 1, false, 1, &p) && is_domain("paper", 1));
}

static void
boxes(void)
{
  sg_paper_point at[4];
  const sg_paper_point_list points = square(at, 3), none = {at, 0, 0};
  double degrees[2] = {0, 45};
  const sg_number_list turns = {degrees, 2, 0};
  sg_paper_point_list sizes = {0};

  CHECK_DOOR("boxes", sg_door_turned_boxes(&call, &points, &turns, &sizes) &&
                          sizes.n == 2);
  CHECK("upright", sizes.at[0].x == 10 && sizes.at[0].y == 10);
  CHECK("on a corner", fabs(sizes.at[1].x - 10 * sqrt(2)) < 1e-9 &&
                           fabs(sizes.at[1].y - 10 * sqrt(2)) < 1e-9);
  CHECK("no points", !sg_door_turned_boxes(&call, &none, &turns, &sizes) &&
                         is_domain("points", 1));
}

int
main(void)
{
  sg_call_open(&call, NULL, NULL);
  shapes();
  corners();
  maps();
  nests();
  boxes();
  sg_call_close(&call);
  return check_report();
}
