/* simplify_rows_test.c -- two cubes with fewer triangles, through the functions
 * of the doors, without Prolog. */
#include "doors/file.h"

#include "tests/c_kernels/cube_world.h"
#include "tests/c_kernels/door_call.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

static void
simplify(sg_world *world)
{
  int32_t cubes[] = {1, 2}, first[] = {1, 2}, no[] = {9};
  sg_simplifying *x;
  size_t left = 0;

  CHECK_DOOR("two cubes",
             sg_door_simplified_open(&call, &(sg_int_list){cubes, 2, 0}, &x));
  CHECK("not run yet", !sg_door_simplified_add(&call, x, 1) &&
                           was_refused(SG_REFUSED_EXISTENCE));
  CHECK_DOOR("it runs",
             sg_door_simplified_run(&call, x, 20, &left) && left == 20);
  CHECK_DOOR("again",
             sg_door_simplified_run(&call, x, 20, &left) && left == 20);
  CHECK_DOOR(
      "the first matters",
      sg_door_simplified_weigh(&call, x, 1, &(sg_int_list){first, 2, 0}, 1e6));
  CHECK("no such vertex",
        !sg_door_simplified_weigh(&call, x, 1, &(sg_int_list){no, 1, 0}, 1e6) &&
            was_refused(SG_REFUSED_EXISTENCE));
  CHECK_DOOR("as few as can be",
             sg_door_simplified_run(&call, x, 1, &left) && left == 8);
  CHECK("its rows are there", !sg_door_simplified_add(&call, x, 1) &&
                                  was_refused(SG_REFUSED_PERMISSION));
  sg_call_rest(&call);
  CHECK("all goes", sg_world_retract_all(world, SG_T) &&
                        sg_world_retract_all(world, SG_P) &&
                        sg_world_retract_all(world, SG_E) &&
                        sg_world_retract_all(world, SG_V));
  CHECK_DOOR("added", sg_door_simplified_add(&call, x, 1) &&
                          sg_door_simplified_add(&call, x, 2));
  CHECK("two tetrahedra",
        rows_of(SG_V) == 8 && rows_of(SG_E) == 24 && rows_of(SG_P) == 8);
  sg_simplifying_free(x);
}

int
main(void)
{
  sg_world *world = sg_world_open();

  sg_call_open(&call, NULL, NULL);
  call.world = world;
  CHECK("cubes", add_cube(world, 1) && add_cube_moved(world, 2, 0, 3));
  simplify(world);
  sg_call_close(&call);
  sg_world_let_go(world);
  return check_report();
}
