/* regions_rows_test.c -- regions of space through the functions of the doors,
 * without Prolog: two cubes of a segment that share a face, and a wire in the
 * second.
 */
#include "doors/boolean.h"
#include "doors/gluing.h"

#include "tests/c_kernels/cube_world.h"
#include "tests/c_kernels/door_call.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

#include <math.h>

enum { CUBES = 1, CORNERS = 2, WIRE = 901, LONE = 99 };

static bool
add_vertex(int32_t v, double x)
{
  return sg_world_add(
             call.world, SG_V,
             (sg_value[]){
                 {.i = CUBES}, {.i = v}, {.f = x}, {.f = 0.5}, {.f = 1.5}},
             NULL, NULL) == SG_OK;
}

static bool
add_wire(void)
{
  return add_vertex(91, 0.25) && add_vertex(92, 0.75) && add_vertex(LONE, 7) &&
         sg_world_add(
             call.world, SG_E,
             (sg_value[]){
                 {.i = CUBES}, {.i = WIRE}, {.i = 91}, {.i = 92}, {.i = 1}},
             NULL, NULL) == SG_OK;
}

static void
welding(void)
{
  size_t doubles = 9;

  CHECK_DOOR("welded", sg_door_segment_welded(&call, CUBES, &doubles));
  CHECK("the face between them", doubles == 1);
  sg_call_rest(&call);
  CHECK("rows", rows_of(SG_V) == 12 + 3 && rows_of(SG_P) == 11 &&
                    rows_of(SG_E) == 44 + 1 && rows_of(SG_T) == 22);
  CHECK_DOOR("again", sg_door_segment_welded(&call, CUBES, &doubles));
  CHECK("nothing is left to do", doubles == 0 && rows_of(SG_V) == 15);
  sg_call_rest(&call);
}

static void
asking(sg_regions_handle *regions)
{
  sg_regions counts;
  sg_region_fact_list list = {0};
  sg_region_neighbours_fact_list between = {0};
  sg_region_item_list wires = {0}, lone = {0};

  CHECK_DOOR("counted", sg_door_regions_counted(&call, regions, &counts));
  CHECK("counts", counts.vertices == 15 && counts.edges == 21 &&
                      counts.faces == 11 && counts.loops == 11 &&
                      counts.parts == 3 && counts.regions == 3 &&
                      counts.shells == 5 && counts.genus == 0);
  CHECK_DOOR("listed", sg_door_regions_listed(&call, regions, &list));
  CHECK("a cell", list.n == 3 && list.at[0].role == SG_REGION_CELL &&
                      list.at[0].faces == 6 &&
                      fabs(list.at[0].volume - 1) < 1e-12 &&
                      fabs(list.at[0].area - 6) < 1e-12);
  CHECK("with the wire", list.at[1].wires == 1 && list.at[1].shells == 2);
  CHECK("outside", list.at[2].role == SG_REGION_OUTSIDE &&
                       list.at[2].lone == 1 && list.at[2].faces == 10);
  CHECK_DOOR("neighbours",
             sg_door_regions_neighbours(&call, regions, &between));
  CHECK("three pairs", between.n == 3 && between.at[0].r1 == 1 &&
                           between.at[0].r2 == 2 && between.at[0].faces == 1 &&
                           fabs(between.at[0].area - 1) < 1e-12 &&
                           between.at[2].faces == 5);
  CHECK_DOOR("items", sg_door_regions_items(&call, regions, &wires, &lone));
  CHECK("the wire",
        wires.n == 1 && wires.at[0].id == WIRE && wires.at[0].region == 2);
  CHECK("the vertex",
        lone.n == 1 && lone.at[0].id == LONE && lone.at[0].region == 3);
}

static void
opening(void)
{
  sg_point_loop_fact loop = {LONE, 77};
  sg_point_loop_fact_list one = {&loop, 1, 1}, none = {0};
  sg_regions_handle *regions = NULL;

  CHECK("no such polygon", !sg_door_regions_open(&call, CUBES, &one, &regions));
  CHECK("refused", !was_refused(SG_REFUSED_NOTHING));
  loop.p = 1;
  CHECK("not inside", !sg_door_regions_open(&call, CUBES, &one, &regions));
  CHECK("refused", was_refused(SG_REFUSED_GEOMETRY));
  sg_call_rest(&call);
  CHECK_DOOR("opened", sg_door_regions_open(&call, CUBES, &none, &regions));
  asking(regions);
  CHECK_DOOR("written", sg_door_regions_written(&call, regions));
  sg_call_rest(&call);
  CHECK("rows", rows_of(SG_REGION) == 3 && rows_of(SG_SIDES) == 11);
  sg_regions_handle_free(regions);
}

/* How many shells two cubes with a vertex in common have, if that is told. */
static size_t
told_shells(sg_zone_meeting_fact_list *meetings, bool *twisted)
{
  sg_point_loop_fact_list none = {0};
  sg_regions_handle *regions = NULL;
  sg_regions counts = {0};

  if (sg_door_regions_told(&call, CORNERS, &none, meetings, &regions)) {
    sg_door_regions_counted(&call, regions, &counts);
    sg_regions_handle_free(regions);
  }
  *twisted = counts.twisted > 0;
  sg_call_rest(&call);
  return counts.shells;
}

static void
telling(void)
{
  sg_zone_meeting_fact meeting = {8, 7, true, 25, true};
  sg_zone_meeting_fact_list one = {&meeting, 1, 1}, none = {0};
  size_t doubles;
  bool twisted;

  CHECK("cubes",
        add_cube(call.world, CORNERS) &&
            add_cube_at(call.world, CORNERS, 1, (double[3]){1, 1, 1}) &&
            add_segment(CORNERS));
  CHECK_DOOR("welded", sg_door_segment_welded(&call, CORNERS, &doubles));
  sg_call_rest(&call);
  CHECK("outside they meet", told_shells(&one, &twisted) == 3 && !twisted);
  CHECK("told nothing", told_shells(&none, &twisted) == 4 && !twisted);
  meeting.above1 = false;
  CHECK("through a face", told_shells(&one, &twisted) == 3 && twisted);
  meeting.e2 = 4711;
  CHECK("no such edge", told_shells(&one, &twisted) == 0);
}

int
main(void)
{
  sg_world *world = sg_world_open();

  sg_call_open(&call, NULL, NULL);
  call.world = world;
  CHECK("cubes", world && add_cube(world, CUBES) &&
                     add_cube_at(world, CUBES, 1, (double[3]){0, 0, 1}) &&
                     add_segment(CUBES) && add_wire());
  welding();
  opening();
  telling();
  sg_call_close(&call);
  sg_world_let_go(world);
  return check_report();
}
