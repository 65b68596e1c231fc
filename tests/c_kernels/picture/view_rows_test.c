/* view_rows_test.c -- a cube seen from somewhere, and turned, through the
 * functions of the doors, without Prolog.
 *
 * covers: picture_points
 */
#include "doors/drawing.h"

#include "tests/c_kernels/cube_world.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

#include <math.h>
#include <string.h>

static sg_call call;

/* The coordinates of a vertex in v/5 or screen/5. */
static bool
place(sg_relation relation, int32_t v, double out[3])
{
  const sg_version *version = sg_world_version(call.world);
  sg_value key[SG_MAX_COLUMNS] = {{.i = 1}, {.i = v}};
  sg_row row = sg_version_find(version, relation, key);

  for (unsigned k = 0; k < 3 && row != SG_NO_ROW; k++) {
    out[k] = sg_version_value(version, relation, row, k + 2).f;
  }
  sg_version_drop(version);
  return row != SG_NO_ROW;
}

static bool
is_at(sg_relation relation, int32_t v, double x, double y, double z)
{
  double at[3];

  return place(relation, v, at) && fabs(at[0] - x) < 1e-12 &&
         fabs(at[1] - y) < 1e-12 && fabs(at[2] - z) < 1e-12;
}

static bool
is_domain(const char *what, int argument, int64_t number)
{
  const sg_refusal *r = &call.refusal;
  bool is = r->how == SG_REFUSED_DOMAIN && !strcmp(r->what, what) &&
            r->argument == argument && r->number == number;

  call.refusal = (sg_refusal){.how = SG_REFUSED_NOTHING};
  return is;
}

static void
seen(void)
{
  double near, far, reach, depth, sine, cosine;

  CHECK_DOOR("from above",
             sg_door_fill_screen(&call, -90, 0, 9, SG_PROJECTION_PARALLEL));
  CHECK("x right, y up, z away", is_at(SG_SCREEN, 6, 1, 0, -1));
  CHECK_DOOR("depth", sg_door_view_depth(&call, -90, 0, 9,
                                         SG_PROJECTION_PARALLEL, &depth) &&
                          depth == 1);
  CHECK_DOOR("range", sg_door_view_range(&call, -90, 0, &near, &far, &reach));
  CHECK("of a unit cube", near == -1 && far == 0 && reach == sqrt(3));
  CHECK_DOOR("central",
             sg_door_fill_screen(&call, -90, 0, 9, SG_PROJECTION_CENTRAL));
  CHECK("what is near is larger", !is_at(SG_SCREEN, 6, 1, 0, -1));
  CHECK("in the model",
        !sg_door_fill_screen(&call, -90, 0, 0.5, SG_PROJECTION_CENTRAL) &&
            is_domain("rho", 3, 0));
  CHECK_DOOR("ninety", sg_door_sine_cosine(&call, 90, &sine, &cosine) &&
                           sine == 1 && cosine == 0);
}

static bool
turned(int32_t x, int32_t y, int32_t z, size_t numbers)
{
  int32_t axis[3] = {x, y, z};
  double origin[3] = {0, 0, 0};

  return sg_door_turn_points(&call, &(sg_int_list){axis, 3, 0},
                             &(sg_number_list){origin, numbers, 0});
}

static void
turns(void)
{
  CHECK("twice one axis", !turned(1, 1, 2, 3) && is_domain("axes", 1, 0));
  CHECK("axis 4", !turned(1, 4, 2, 3) && is_domain("axis", 0, 4));
  CHECK("two numbers", !turned(1, 2, 3, 2) && is_domain("origin", 2, 0));
  CHECK("nothing is turned", is_at(SG_V, 2, 1, 0, 0));
  CHECK_DOOR("a quarter", turned(2, -1, 3, 3));
  CHECK("is turned", is_at(SG_V, 2, 0, -1, 0) && is_at(SG_V, 8, 1, -1, 1));
}

/* Rows of all relations that have places, and a plane that passes the origin
 * as far as what is moved. */
static void
turns_planes(void)
{
  const int32_t axis[3] = {3, 1, -2};
  const double origin[3] = {1, 2, 4};
  sg_value plane[6] = {{.i = 1},    {.i = 5}, {.f = 0.5},
                       {.f = 0.25}, {.f = 2}, {.f = -8}};
  sg_value leaf[5] = {{.i = 1}, {.i = 7}, {.f = 3}, {.f = 5}, {.f = 9}};
  const double as[4] = {2, 0.5, -0.25, 0.5 + 0.5 + 8 - 8};
  sg_row row;

  CHECK("begin", sg_world_begin(call.world) == SG_OK);
  CHECK("a plane",
        sg_world_add(call.world, SG_PLANE, plane, NULL, NULL) == SG_OK);
  CHECK("a vertex of a leaf",
        sg_world_add(call.world, SG_LEAF_V, leaf, NULL, NULL) == SG_OK);
  CHECK_DOOR("turned and moved",
             sg_door_turn_points(&call, &(sg_int_list){(int32_t *)axis, 3, 3},
                                 &(sg_number_list){(double *)origin, 3, 3}));
  CHECK("the leaf", is_at(SG_LEAF_V, 7, 5, 2, -3));
  const sg_version *version = sg_world_version(call.world);

  CHECK("the plane",
        (row = sg_version_find(version, SG_PLANE, plane)) != SG_NO_ROW);
  for (unsigned k = 0; k < 4; k++) {
    CHECK("turns", sg_version_value(version, SG_PLANE, row, k + 2).f == as[k]);
  }
  sg_version_drop(version);
  sg_call_rest(&call);
  CHECK("as before", sg_world_rollback(call.world) == SG_OK);
  CHECK("too far", !sg_door_turn_points(
                       &call, &(sg_int_list){(int32_t *)axis, 3, 3},
                       &(sg_number_list){(double[3]){-2e90, 0, 0}, 3, 3}) &&
                       call.refusal.how == SG_REFUSED_REPRESENTATION);
  call.refusal = (sg_refusal){.how = SG_REFUSED_NOTHING};
}

int
main(void)
{
  double near, far, reach;
  sg_world *world = sg_world_open();

  sg_call_open(&call, NULL, NULL);
  call.world = world;
  CHECK("no vertices", !sg_door_view_range(&call, 0, 0, &near, &far, &reach) &&
                           call.refusal.how == SG_REFUSED_NOTHING);
  CHECK("a cube", add_cube(world, 1));
  seen();
  turns_planes();
  turns();
  sg_call_close(&call);
  sg_world_let_go(world);
  return check_report();
}
