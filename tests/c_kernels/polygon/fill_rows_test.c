/* fill_rows_test.c -- planes and triangles of a cube, and what is one place in
 * it, through the functions of the doors, without Prolog.
 *
 * covers: by_segment, grain_rows, keys, pattern_rows
 */
#include "doors/world.h"
#include "engine/term.h"

#include "tests/c_kernels/cube_world.h"
#include "tests/c_kernels/door_call.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

enum { CUBE = 1, OPEN = 2 };

/* A polygon of one edge. */
static bool
add_open(void)
{
  bool good = true;

  for (int32_t v = 1; v <= 2; v++) {
    good =
        good &&
        sg_world_add(
            call.world, SG_V,
            (sg_value[]){{.i = OPEN}, {.i = v}, {.f = v}, {.f = 0}, {.f = 0}},
            NULL, NULL) == SG_OK;
  }
  return good &&
         sg_world_add(
             call.world, SG_E,
             (sg_value[]){{.i = OPEN}, {.i = 1}, {.i = 1}, {.i = 2}, {.i = 1}},
             NULL, NULL) == SG_OK &&
         sg_world_add(call.world, SG_P,
                      (sg_value[]){{.i = OPEN},
                                   {.i = 1},
                                   {.list = (const int32_t[]){1, 1}}},
                      NULL, NULL) == SG_OK;
}

static void
fills(void)
{
  sg_segments_asked asked = {.is = SG_SEGMENTS_ASKED_THESE};
  sg_fault_fact_list faults = {0};

  CHECK_DOOR("nothing",
             sg_door_fill_triangles(&call, &asked, SIZE_MAX, &faults) &&
                 faults.n == 0 && rows_of(SG_PLANE) == 0);
  asked.these = (sg_int_list){(int32_t[]){CUBE}, 1, 1};
  CHECK_DOOR("the cube",
             sg_door_fill_triangles(&call, &asked, SIZE_MAX, &faults) &&
                 faults.n == 0 && rows_of(SG_PLANE) == 6 &&
                 rows_of(SG_T) == 12);
  sg_call_rest(&call);
  asked.is = SG_SEGMENTS_ASKED_ALL;
  CHECK_DOOR("all", sg_door_fill_triangles(&call, &asked, SIZE_MAX, &faults));
  CHECK("one is not closed",
        faults.n == 1 && faults.at[0].s == OPEN && faults.at[0].p == 1 &&
            faults.at[0].what.is == SG_FAULT_WHAT_NOT_CLOSED);
  sg_call_rest(&call);
}

/* The cube has triangles from the beginning, the open polygon never has. */
static void
untriangulated(void)
{
  sg_int_list none = {0}, one = {0};

  CHECK_DOOR("no segments",
             sg_door_untriangulated_segments(&call, &none) && none.n == 0);
  for (int32_t s = CUBE; s <= OPEN + 1; s++) {
    CHECK("segment", add_segment(s));
  }
  sg_call_rest(&call);
  CHECK_DOOR("one of three", sg_door_untriangulated_segments(&call, &one) &&
                                 one.n == 1 && one.at[0] == OPEN);
}

static void
tolerances(void)
{
  double all, again, one = 0, smallest = 0, grain;
  int32_t s[] = {CUBE};
  sg_int_list cube = {s, 1, 1}, none = {0};

  CHECK_DOOR("of the model", sg_door_model_tolerance(&call, &all));
  CHECK_DOOR("it is kept",
             sg_door_model_tolerance(&call, &again) && all == again && all > 0);
  CHECK_DOOR("of the cube",
             sg_door_segments_tolerance(&call, &cube, &one, &smallest) &&
                 one > 0 && one <= all && smallest == 1);
  CHECK_DOOR("of none",
             sg_door_segments_tolerance(&call, &none, &one, &smallest) &&
                 smallest == 0);
  CHECK_DOOR("doubles",
             sg_door_segment_grain(&call, CUBE, &grain) && grain == 0);
}

int
main(void)
{
  sg_call_open(&call, NULL, NULL);
  call.world = sg_world_open();
  CHECK("a cube", call.world && add_cube(call.world, CUBE) && add_open());
  fills();
  untriangulated();
  tolerances();
  sg_world *world = call.world;

  sg_call_close(&call);
  sg_world_let_go(world);
  return check_report();
}
