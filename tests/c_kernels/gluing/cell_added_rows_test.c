/* cell_added_rows_test.c -- cubes that become operands of a glue, one by one,
 * and one that goes, through the functions of the doors, without Prolog.
 */
#include "doors/boolean.h"
#include "doors/gluing.h"

#include "tests/c_kernels/cube_world.h"
#include "tests/c_kernels/door_call.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

enum { FIRST = 1, BESIDE, ACROSS, MANY, GLUE = 9 };

/* The solid that segment s is; null: refused. */
static sg_solid *
taken(int32_t s)
{
  sg_int_list one = {&s, 1, 1};
  sg_solid *solid = NULL;

  sg_call_rest(&call);
  return sg_door_solid_take(&call, &one, &solid) ? solid : NULL;
}

static void
glue_of_one(void)
{
  sg_solid *solid = taken(FIRST);
  sg_point_loop_fact_list none = {0};
  sg_regions_handle *regions = NULL;
  int32_t first = FIRST;
  sg_int_list one = {&first, 1, 1}, nothing = {0};
  size_t wrong;

  CHECK("taken", solid);
  CHECK_DOOR("written", sg_door_solid_write_cells(&call, solid, GLUE, &none));
  sg_call_rest(&call);
  CHECK_DOOR("opened", sg_door_regions_open(&call, GLUE, &none, &regions));
  CHECK_DOOR("regions", sg_door_regions_written(&call, regions));
  sg_call_rest(&call);
  CHECK_DOOR("contents",
             sg_door_contents_written(&call, GLUE, &one, &nothing, &wrong));
  CHECK("on one side", wrong == 0);
  CHECK("but the outside", nothing.n == 1 && nothing.at[0] == 2);
  sg_call_rest(&call);
  CHECK("inside", rows_of(SG_FROM_R) == 1);
  sg_regions_handle_free(regions);
  sg_solid_free(solid);
}

static bool
added(int32_t s)
{
  sg_solid *solid = taken(s);
  bool is = solid &&
            sg_door_cell_added(&call, GLUE, s, solid, 1e-9, &(sg_int_list){0});

  sg_solid_free(solid);
  sg_call_rest(&call);
  return is;
}

static void
adding(void)
{
  size_t v = rows_of(SG_V), p = rows_of(SG_P);

  CHECK_DOOR("one face is shared", added(BESIDE));
  CHECK("rows", rows_of(SG_V) == v + 4 && rows_of(SG_P) == p + 5);
  CHECK("sources", rows_of(SG_FROM_P) == 12 && rows_of(SG_FROM_V) == 12);
  CHECK("regions", rows_of(SG_REGION) == 3 && rows_of(SG_SIDES) == 11 &&
                       rows_of(SG_FROM_R) == 2);
  CHECK("it crosses both", !added(ACROSS));
  CHECK("not refused", was_refused(SG_REFUSED_NOTHING));
  CHECK("nothing is written",
        rows_of(SG_V) == v + 4 && rows_of(SG_REGION) == 3);
  CHECK("not one solid", !added(MANY));
}

/* How many faces; SIZE_MAX: it was refused. */
static size_t
completed(int32_t s, const sg_id_pair_list *was)
{
  sg_solid *solid = taken(s);
  size_t faces;

  CHECK("taken", solid);
  if (!sg_door_cell_completed(&call, GLUE, s, solid, 1e-9, &(sg_int_list){0},
                              was, &faces)) {
    CHECK("not refused", was_refused(SG_REFUSED_NOTHING));
    faces = SIZE_MAX;
  }
  sg_solid_free(solid);
  sg_call_rest(&call);
  return faces;
}

static void
completing(size_t p, size_t v)
{
  sg_id_pair pair[] = {{1, 21}, {2, 22}, {3, 23}, {4, 23}, {5, 25}, {6, 26}};
  sg_id_pair_list six = {pair, 6, 6}, five = {pair, 5, 5};

  CHECK("two with one number", completed(ACROSS, &six) == SIZE_MAX);
  pair[3].b = 24;
  CHECK("one without", completed(ACROSS, &five) == SIZE_MAX);
  CHECK("nothing is written", rows_of(SG_P) == p && rows_of(SG_V) == v);
  CHECK("nothing is there", completed(ACROSS, &six) == 6 &&
                                rows_of(SG_P) == p + 6 &&
                                rows_of(SG_V) == v + 8);
}

/* The last five polygons are of BESIDE alone; two cubes make three regions. */
static void
leaving(void)
{
  int32_t last[] = {7, 8, 9, 10, 11}, others[] = {1, 2};
  sg_int_list five = {last, 5, 5}, two = {others, 2, 2};
  size_t p = rows_of(SG_P), v = rows_of(SG_V);

  CHECK_DOOR("numbers stay",
             sg_door_regions_joined(&call, GLUE, GLUE, &(sg_int_list){0}));
  sg_call_rest(&call);
  CHECK("rows too", rows_of(SG_REGION) == 3 && rows_of(SG_SIDES) == 11);
  CHECK("inside of FIRST", !sg_door_regions_joined(&call, GLUE, BESIDE, &two));
  CHECK("not refused", was_refused(SG_REFUSED_NOTHING));
  sg_call_rest(&call);
  CHECK("nothing is written",
        rows_of(SG_SIDES) == 11 && rows_of(SG_FROM_R) == 2);
  CHECK("all is there",
        completed(BESIDE, &(sg_id_pair_list){0}) == 0 && rows_of(SG_P) == p);
  CHECK_DOOR("gone", sg_door_regions_joined(&call, GLUE, BESIDE, &five));
  sg_call_rest(&call);
  CHECK("one less", rows_of(SG_REGION) == 2 && rows_of(SG_SIDES) == 6 &&
                        rows_of(SG_FROM_R) == 1);
  completing(p, v);
}

static void
asking(void)
{
  const sg_version *version = sg_world_version(call.world);
  int64_t stamp = (int64_t)sg_segment_stamp(version, BESIDE);
  int32_t all[] = {FIRST, BESIDE, GLUE};
  sg_int_list ss = {all, 3, 3}, newer = {0}, changed = {0};

  sg_version_drop(version);
  CHECK_DOOR("newer", sg_door_newer_segments(&call, &ss, stamp, &newer));
  CHECK("the glue", newer.n == 1 && newer.at[0] == GLUE);
  CHECK_DOOR("changed", sg_door_changed_leaves(&call, &ss, stamp, &changed));
  CHECK("none was made of a primitive", changed.n == 3);
  sg_call_rest(&call);
}

int
main(void)
{
  const double beside[3] = {1, 0, 0}, across[3] = {0.5, 0.5, 0.5};

  sg_call_open(&call, NULL, NULL);
  sg_world *world = call.world = sg_world_open();
  CHECK("cubes", call.world && add_cube(call.world, FIRST) &&
                     add_cube_at(call.world, BESIDE, 0, beside) &&
                     add_cube_at(call.world, ACROSS, 0, across) &&
                     add_cube_at(call.world, MANY, 0, (double[3]){3, 0, 0}) &&
                     add_cube_at(call.world, MANY, 1, (double[3]){5, 0, 0}));
  glue_of_one();
  adding();
  asking();
  leaving();
  sg_call_close(&call);
  sg_world_let_go(world);
  return check_report();
}
