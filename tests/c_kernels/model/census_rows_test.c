/* census_rows_test.c -- cubes counted, measured and found defective, through
 * the functions of the doors, without Prolog.
 *
 * covers: census
 */
#include "doors/world.h"

#include "tests/c_kernels/cube_world.h"
#include "tests/check.h"

#include <math.h>

static sg_call call;

static void
counts(void)
{
  sg_census_part_list parts = {0};
  const sg_census_part *p;

  CHECK("census", sg_door_census(&call, &parts) && parts.n == 2);
  p = &parts.at[0];
  CHECK("a cube", p->segment == 1 && p->counts.vertices == 8 &&
                      p->counts.edges == 12 && p->counts.polygons == 6 &&
                      p->counts.triangles == 12);
  CHECK("its size", p->area == 6 && p->volume == 1 && p->length == 0 &&
                        p->box.low[2] == 0 && p->box.high[2] == 1);
  CHECK("its shell", p->shells.n == 1 && p->shells.at[0].euler == 2 &&
                         p->shells.at[0].closed);
  CHECK("nothing is wrong", p->defects.n == 0);
  p = &parts.at[1];
  CHECK("two cubes in one place", p->shells.n == 2 && p->volume == 2);
  CHECK("is wrong", p->defects.n > 0);
}

static void
defects(void)
{
  sg_census_defect_rows rows = {0};
  size_t twins = 0;

  CHECK("defects", sg_door_census_defect(&call, &rows));
  for (size_t i = 0; i < rows.n; i++) {
    CHECK("of the second segment", rows.at[i].s == 2);
    twins += rows.at[i].kind == SG_DEFECT_TWIN;
  }
  CHECK("eight vertices twice", twins == 8);
}

static bool
stop(void *data)
{
  (void)data;
  return true;
}

int
main(void)
{
  static const sg_cancel now = {stop, NULL};
  sg_world *world = sg_world_open();

  sg_call_open(&call, NULL, NULL);
  call.world = world;
  CHECK("cubes", add_cube(world, 1) && add_cube(world, 2) &&
                     add_cube_again(world, 2, 1));
  counts();
  defects();
  sg_call_close(&call);
  sg_call_open(&call, &now, NULL);
  call.world = world;
  CHECK("stopped", !sg_door_census(&call, &(sg_census_part_list){0}) &&
                       call.refusal.how == SG_REFUSED_NOTHING);
  sg_call_close(&call);
  sg_world_let_go(world);
  return check_report();
}
