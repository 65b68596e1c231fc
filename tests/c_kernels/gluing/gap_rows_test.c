/* gap_rows_test.c -- how far cubes and a wire are apart, through the functions
 * of the doors, without Prolog.
 */
#include "doors/gluing.h"

#include "tests/c_kernels/cube_world.h"
#include "tests/c_kernels/door_call.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

enum { FIRST = 1, ABOVE, ASIDE, WIRE, NONE = 99 };

static bool
add_wire(sg_world *world)
{
  const double at[2][3] = {{0.5, 0.5, 1.125}, {0.5, 0.5, 1.375}};
  bool good = true;

  for (int32_t i = 0; i < 2 && good; i++) {
    good = sg_world_add(world, SG_V,
                        (sg_value[]){{.i = WIRE},
                                     {.i = i + 1},
                                     {.f = at[i][0]},
                                     {.f = at[i][1]},
                                     {.f = at[i][2]}},
                        NULL, NULL) == SG_OK;
  }
  return good &&
         sg_world_add(
             world, SG_E,
             (sg_value[]){{.i = WIRE}, {.i = 7}, {.i = 1}, {.i = 2}, {.i = 1}},
             NULL, NULL) == SG_OK;
}

static void
segments(void)
{
  sg_id_pair pair[] = {
      {FIRST, ABOVE}, {FIRST, ASIDE}, {ABOVE, WIRE}, {FIRST, NONE}};
  sg_id_pair_list pairs = {pair, 4, 4};
  sg_segment_gap_list gaps = {0};

  CHECK_DOOR("asked", sg_door_segment_gaps(&call, &pairs, 1, &gaps));
  sg_call_rest(&call);
  CHECK("two are near", gaps.n == 2 && gaps.at[0].distance == 0.5 &&
                            gaps.at[1].distance == 0.125);
  CHECK("top and bottom", gaps.at[0].of1.a == FIRST && gaps.at[0].of1.b == 2 &&
                              gaps.at[0].of2.a == ABOVE &&
                              gaps.at[0].of2.b == 1);
  CHECK("the edge of the wire", gaps.at[1].of2.b == 7);
  CHECK("where",
        gaps.at[1].ends.from.z == 1.5 && gaps.at[1].ends.to.z == 1.375);
  gaps.n = 0;
  CHECK_DOOR("less far", sg_door_segment_gaps(&call, &pairs, 0.25, &gaps));
  CHECK("one", gaps.n == 1);
  sg_call_rest(&call);
  CHECK("no reach", !sg_door_segment_gaps(&call, &pairs, -1, &gaps));
  CHECK("is refused", is_domain("not_less_than_zero", 2));
}

static void
polygons(void)
{
  const sg_id_pair top = {FIRST, 2}, above = {ABOVE, 2}, none = {ABOVE, 77};
  sg_gap_ends ends;
  double gap;

  CHECK_DOOR("asked", sg_door_polygon_gap(&call, &top, &above, &gap, &ends));
  CHECK("a cube and a half",
        gap == 1.5 && ends.from.z == 1 && ends.to.z == 2.5);
  CHECK("no polygon", !sg_door_polygon_gap(&call, &top, &none, &gap, &ends));
  CHECK("is no fault", was_refused(SG_REFUSED_NOTHING));
  sg_call_rest(&call);
}

int
main(void)
{
  sg_call_open(&call, NULL, NULL);
  sg_world *world = call.world = sg_world_open();
  CHECK("cubes", world && add_cube(world, FIRST) &&
                     add_cube_at(world, ABOVE, 0, (double[3]){0, 0, 1.5}) &&
                     add_cube_at(world, ASIDE, 0, (double[3]){9, 0, 0}) &&
                     add_wire(world));
  segments();
  polygons();
  sg_call_close(&call);
  sg_world_let_go(world);
  return check_report();
}
