/* work_rows_test.c -- a face of a cube as a scratch relation, through the
 * functions of the doors, without Prolog.
 */
#include "doors/work.h"

#include "tests/c_kernels/cube_world.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

#include <string.h>

enum { CUBE = 1 };

static sg_call call;

static bool
is_missing(const char *what, int64_t id)
{
  bool is = call.refusal.how == SG_REFUSED_EXISTENCE &&
            !strcmp(call.refusal.what, what) && call.refusal.number == id;

  call.refusal = (sg_refusal){0};
  return is;
}

/* Face 1 of the cube: edges 1-3, 3-4, 4-2, 2-1. */
static void
edges(sg_work *work)
{
  const int32_t three = 3, one = 1, nine = 9;
  sg_work_edge_rows all = {0}, leaving = {0}, entering = {0}, pair = {0};
  sg_work_edge_rows given = {0}, none = {0};
  int32_t e, v1, v2;

  CHECK_DOOR("all", sg_door_work_edge(&call, work, NULL, NULL, NULL, &all));
  CHECK("four", all.n == 4 && all.at[3].e == 4 && all.at[3].v2 == 1);
  CHECK_DOOR("leaving",
             sg_door_work_edge(&call, work, NULL, &three, NULL, &leaving));
  CHECK("3-4", leaving.n == 1 && leaving.at[0].v2 == 4);
  CHECK_DOOR("entering",
             sg_door_work_edge(&call, work, NULL, NULL, &three, &entering));
  CHECK("1-3", entering.n == 1 && entering.at[0].v1 == 1);
  CHECK_DOOR("pair",
             sg_door_work_edge(&call, work, NULL, &one, &three, &pair) &&
                 pair.n == 1 && pair.at[0].e == 1);
  CHECK_DOOR("given",
             sg_door_work_edge(&call, work, &three, NULL, NULL, &given) &&
                 given.n == 1 && given.at[0].label == 3);
  CHECK("no edge 9", !sg_door_work_edge(&call, work, &nine, NULL, NULL, &none));
  CHECK("no vertex 9",
        !sg_door_work_edge(&call, work, NULL, &nine, NULL, &none));
  CHECK("is no error", call.refusal.how == SG_REFUSED_NOTHING);
  CHECK_DOOR("oldest", sg_door_work_oldest(&call, work, &e, &v1, &v2) &&
                           e == 1 && v1 == 1 && v2 == 3);
}

static void
changes(sg_work *work)
{
  sg_work_meeting_rows met = {0};
  int32_t e, v;

  CHECK("vertex 9", !sg_door_work_add(&call, work, 1, 9, 0, 0, &e) &&
                        is_missing("work_vertex", 9));
  CHECK("a loop", !sg_door_work_add(&call, work, 1, 1, 0, 0, &e) &&
                      call.refusal.how == SG_REFUSED_DOMAIN &&
                      call.refusal.argument == 3);
  call.refusal = (sg_refusal){0};
  CHECK_DOOR("meeting", sg_door_work_meeting(&call, work, 1, 4, &met));
  CHECK("the diagonal meets no edge", met.n == 0);
  CHECK_DOOR("meeting", sg_door_work_meeting(&call, work, 1, 3, &met));
  CHECK("the edge itself",
        met.n == 1 && met.at[0].how == SG_CONTAINED && met.at[0].inside.n == 0);
  CHECK_DOOR("delete", sg_door_work_delete(&call, work, 1));
  CHECK("edge 1", !sg_door_work_delete(&call, work, 1));
  call.refusal = (sg_refusal){0};
  CHECK_DOOR("a gap", sg_door_work_gap(&call, work, &v) && v == 1);
}

/* The diagonal there and back touches only in vertices that are shared. */
static void
resolves(sg_work *work)
{
  sg_work_edge_rows all = {0}, left = {0};
  int32_t e;

  CHECK_DOOR("there and back",
             sg_door_work_add(&call, work, 1, 4, 0, 0, &e) &&
                 sg_door_work_add(&call, work, 4, 1, 0, 0, &e));
  CHECK_DOOR("six", sg_door_work_edge(&call, work, NULL, NULL, NULL, &all) &&
                        all.n == 6);
  CHECK_DOOR("resolve", sg_door_work_resolve(&call, work, 0));
  CHECK_DOOR("nothing changes",
             sg_door_work_edge(&call, work, NULL, NULL, NULL, &left) &&
                 left.n == 6);
}

static void
triangles(sg_work *work)
{
  sg_corners_list found = {0}, kept = {0};
  const sg_id_pair_list none = {0};
  int32_t v3, e, v1, v2;

  CHECK_DOOR("a third vertex",
             sg_door_work_candidate(&call, work, 1, 3, 0, &v3) && v3 == 4);
  CHECK_DOOR("another",
             sg_door_work_candidate(&call, work, 1, 3, 1, &v3) && v3 == 2);
  CHECK("and no more", !sg_door_work_candidate(&call, work, 1, 3, 2, &v3));
  CHECK_DOOR("triangulate", sg_door_work_triangulate(&call, work, &found));
  CHECK("two", found.n == 2 && found.at[0].v[0] == 1);
  CHECK("used up", !sg_door_work_oldest(&call, work, &e, &v1, &v2));
  CHECK_DOOR("thicken",
             sg_door_work_thicken(&call, work, &none, &found, &kept));
  CHECK("none is thin", kept.n == 2 && !memcmp(kept.at[1].v, found.at[1].v,
                                               sizeof kept.at[1].v));
}

int
main(void)
{
  sg_world *world = sg_world_open();
  sg_work *work = NULL;

  sg_call_open(&call, NULL, NULL);
  call.world = world;
  CHECK("a cube", world && add_cube(world, CUBE));
  CHECK("polygon 7", !sg_door_work_open(&call, CUBE, 7, &work));
  CHECK("is missing",
        call.refusal.how == SG_REFUSED_EXISTENCE && call.refusal.argument == 2);
  call.refusal = (sg_refusal){0};
  CHECK_DOOR("open", sg_door_work_open(&call, CUBE, 1, &work));
  edges(work);
  triangles(work);
  sg_work_close(work);
  CHECK_DOOR("again", sg_door_work_open(&call, CUBE, 1, &work));
  changes(work);
  sg_work_close(work);
  CHECK_DOOR("a third time", sg_door_work_open(&call, CUBE, 1, &work));
  resolves(work);
  sg_work_close(work);
  sg_call_close(&call);
  sg_world_let_go(world);
  return check_report();
}
