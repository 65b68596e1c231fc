/* solid_rows_test.c -- a cube as a solid under way, and back as rows, through
 * the functions of the doors, without Prolog: solid_rows.c, solid_write_rows.c,
 * solid_over_rows.c and face_merge_rows.c.
 *
 * covers: append_rows, edge_print, solid_move, solid_old
 * covers: solid_region_rows, solid_take
 */
#include "doors/boolean.h"

#include "tests/c_kernels/cube_world.h"
#include "tests/c_kernels/door_call.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

#include <string.h>

enum { CUBE = 1, WRITTEN = 2, GLUED = 3 };

static sg_solid *
taken(int32_t s)
{
  sg_solid *solid = NULL;

  sg_call_rest(&call); /* it is another version now */
  return sg_door_solid_take(&call, &(sg_int_list){&s, 1, 1}, &solid) ? solid
                                                                     : NULL;
}

/* Moves it along x; mirrored: then through x = 0. */
static bool
moved(sg_solid *solid, double by, bool mirrored, size_t *again)
{
  double row[3][4] = {
      {mirrored ? -1 : 1, 0, 0, by}, {0, 1, 0, 0}, {0, 0, 1, 0}};
  sg_number_list rows[3] = {{row[0], 4, 4}, {row[1], 4, 4}, {row[2], 4, 4}};
  sg_count_list list = {0};
  bool good = sg_door_solid_move(&call, solid,
                                 &(sg_list_number_list){rows, 3, 3}, &list);

  *again = list.n;
  CHECK("no matrix",
        !sg_door_solid_move(&call, solid, &(sg_list_number_list){rows, 2, 2},
                            &list) &&
            was_refused(SG_REFUSED_DOMAIN));
  return good;
}

static void
takes(void)
{
  sg_solid *solid = taken(CUBE);
  size_t again = 9;
  sg_solid_vertex_fact_list points = {0};
  sg_solid_face_fact_list sides = {0};
  sg_solid_part_fact_list parts = {0};

  CHECK("taken", solid);
  CHECK("a cube",
        solid->vertices == 8 && solid->faces == 6 && solid->triangles == 12);
  CHECK_DOOR("closed", sg_door_solid_is_closed(&call, solid));
  CHECK("moved", moved(solid, 2, true, &again) && again == 0);
  CHECK_DOOR("vertices", sg_door_solid_vertices(&call, solid, &points));
  CHECK("the second went to 1, 0, 0",
        points.n == 8 && points.at[1].x == 1 && points.at[1].number == 2 &&
            points.at[1].from.is == SG_SOLID_VERTEX_FROM_OF &&
            points.at[1].from.of.s == CUBE && points.at[1].from.of.v == 2);
  CHECK_DOOR("faces", sg_door_solid_faces(&call, solid, &sides));
  CHECK("of two triangles each",
        sides.n == 6 && !sides.at[5].reversed && sides.at[5].triangles.n == 2);
  CHECK_DOOR("no parts",
             sg_door_solid_parts(&call, solid, &parts) && parts.n == 0);
  sg_solid_free(solid);
}

static void
writes(void)
{
  sg_solid *solid = taken(CUBE);
  size_t again;

  CHECK_DOOR("written", sg_door_solid_write(&call, solid, WRITTEN));
  CHECK("rows", rows_of(SG_V) == 16 && rows_of(SG_P) == 12 &&
                    rows_of(SG_T) == 24 && rows_of(SG_FROM_V) == 8 &&
                    rows_of(SG_FROM_P) == 6);
  CHECK("not twice", !sg_door_solid_write(&call, solid, WRITTEN) &&
                         was_refused(SG_REFUSED_PERMISSION));
  CHECK_DOOR("the same over it",
             sg_door_solid_write_over(&call, solid, WRITTEN));
  CHECK("changes nothing", rows_of(SG_V) == 16 && rows_of(SG_P) == 12);
  CHECK("not over what no solid became",
        !sg_door_solid_write_over(&call, solid, CUBE) &&
            was_refused(SG_REFUSED_NOTHING));
  CHECK("elsewhere", moved(solid, 3, false, &again));
  CHECK("most is new", !sg_door_solid_write_over(&call, solid, WRITTEN) &&
                           was_refused(SG_REFUSED_NOTHING));
  sg_solid_free(solid);
}

static void
regions(void)
{
  int32_t leaf = CUBE;
  sg_region *region = NULL;
  sg_int_list leaves = {0};
  sg_solid *solid = taken(CUBE);

  CHECK_DOOR("region",
             sg_door_solid_region(&call, WRITTEN, &(sg_int_list){&leaf, 1, 1},
                                  &region));
  CHECK_DOOR("its leaves", sg_door_region_leaves(&call, region, &leaves) &&
                               leaves.n == 1 && leaves.at[0] == CUBE);
  CHECK("of another segment",
        !sg_door_solid_write_region(&call, solid, CUBE, region) &&
            was_refused(SG_REFUSED_NOTHING));
  CHECK_DOOR("the same",
             sg_door_solid_write_region(&call, solid, WRITTEN, region));
  CHECK("changes nothing", rows_of(SG_V) == 16 && rows_of(SG_P) == 12);
  sg_region_free(region);
  sg_solid_free(solid);
}

/* The cube and its copy, which are in one place. */
static void
glues(void)
{
  int32_t s[2] = {CUBE, WRITTEN};
  sg_solid *solid = NULL;
  size_t doubles = 0;
  sg_point_loop_fact_list loops = {0};

  sg_call_rest(&call);
  CHECK_DOOR("both",
             sg_door_solid_take(&call, &(sg_int_list){s, 2, 2}, &solid) &&
                 solid->faces == 12 && solid->vertices == 16);
  CHECK_DOOR("one of each",
             sg_door_solid_coincident_faces(&call, solid, 0, &doubles));
  CHECK("the others are parts",
        doubles == 6 && solid->faces == 6 && solid->parts == 6 &&
            solid->part[5].s == WRITTEN && !solid->part[5].reversed);
  CHECK_DOOR(
      "solids in one place are whole",
      sg_door_solid_is_whole(&call, solid, &(sg_int_list){s, 2, 2}, 1e-9));
  CHECK("no solid without faces",
        !sg_door_solid_is_whole(
            &call, solid, &(sg_int_list){(int32_t[]){CUBE, WRITTEN, 99}, 3, 3},
            1e-9));
  CHECK("too coarse",
        !sg_door_solid_is_whole(&call, solid, &(sg_int_list){s, 2, 2}, 1));
  CHECK_DOOR("as cells",
             sg_door_solid_write_cells(&call, solid, GLUED, &loops) &&
                 loops.n == 0);
  CHECK("rows",
        rows_of(SG_V) == 24 && rows_of(SG_P) == 18 && rows_of(SG_FROM_P) == 18);
  CHECK("not twice", !sg_door_solid_write_cells(&call, solid, GLUED, &loops) &&
                         was_refused(SG_REFUSED_PERMISSION));
  sg_solid_free(solid);
}

static void
merges(void)
{
  sg_solid *solid = taken(CUBE);
  sg_merge_tolerance tolerance = {.is = SG_MERGE_TOLERANCE_GIVEN, .given = -1};
  sg_merge_option option[2] = {
      {.is = SG_MERGE_OPTION_ORIGINS, .origins.which = SG_ORIGINS_TOGETHER},
      {.is = SG_MERGE_OPTION_BY_SIZE, .by_size.is = true}};
  const sg_merge_option_list options = {option, 2, 2};
  sg_merge_move move;
  sg_merge_pair_list pairs = {0};

  CHECK("negative",
        !sg_door_solid_merge(&call, solid, &tolerance, &options, &move) &&
            was_refused(SG_REFUSED_DOMAIN));
  tolerance.given = 1e-9;
  CHECK_DOOR("no neighbours",
             sg_door_solid_neighbours(&call, solid, &tolerance, &pairs) &&
                 pairs.n == 0);
  CHECK_DOOR("merged",
             sg_door_solid_merge(&call, solid, &tolerance, &options, &move));
  CHECK("a cube is as it was",
        solid->faces == 6 && move.is == SG_MERGE_MOVE_NONE);
  sg_solid_free(solid);
}

/* An edge row of the cube from one vertex to another, auxiliary. */
static bool
add_auxiliary(int32_t e, int32_t from, int32_t to)
{
  return sg_world_add(
             call.world, SG_E,
             (sg_value[]){
                 {.i = CUBE}, {.i = e}, {.i = from}, {.i = to}, {.i = 0}},
             NULL, NULL) == SG_OK;
}

/* Edge 1 - 3, which is real, has an auxiliary one on it: it stays real. One
 * alone that the other way round is no edge of a face hides none. */
static void
auxiliary(void)
{
  size_t hidden = 0;

  CHECK("begin", sg_world_begin(call.world) == SG_OK);
  CHECK("on a real one", add_auxiliary(90, 1, 3));
  sg_solid *solid = taken(CUBE);

  for (size_t t = 0; t < solid->triangles; t++) {
    hidden += solid->auxiliary[t] != 0;
  }
  CHECK("it is real", solid->triangles == 12 && hidden == 0);
  sg_solid_free(solid);
  CHECK("a diagonal", add_auxiliary(91, 1, 4));
  solid = taken(CUBE);
  hidden = 0;
  for (size_t t = 0; t < solid->triangles; t++) {
    const uint32_t *v = solid->triangle[t];
    for (int k = 0; k < 3; k++) {
      bool is =
          solid->vertex[v[k]].v == 1 && solid->vertex[v[(k + 1) % 3]].v == 4;
      CHECK("the bit of its side", (solid->auxiliary[t] >> k & 1) == is);
      hidden += is;
    }
  }
  CHECK("is the one that is hidden", hidden == 1);
  sg_solid_free(solid);
  sg_call_rest(&call);
  CHECK("as before", sg_world_rollback(call.world) == SG_OK);
}

int
main(void)
{
  sg_call_open(&call, NULL, NULL);
  call.world = sg_world_open();
  CHECK("a cube", call.world && add_cube(call.world, CUBE));
  takes();
  auxiliary();
  writes();
  regions();
  glues();
  merges();
  sg_world *world = call.world;

  sg_call_close(&call);
  sg_world_let_go(world);
  return check_report();
}
