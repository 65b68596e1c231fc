/* join_rows_test.c -- what is near, inside, through itself and sound: the row
 * layer of the joins.
 */
#include "doors/boolean.h"
#include "doors/work.h"
#include "doors/world.h"
#include "tests/c_kernels/cube_world.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

#include "engine/symbol.h"
#include "engine/term.h"

#include <math.h>
#include <string.h>

static sg_call call;

static bool
add_segment(sg_world *world, int32_t s)
{
  sg_term_builder name;

  sg_term_open(&name);
  sg_term_nil(&name);
  const sg_value row[3] = {
      {.i = s}, {.i = SG_SYMBOL_SOLID}, {.term = sg_term_words(&name)}};
  bool good = sg_world_add(world, SG_SEGMENT, row, NULL, NULL) == SG_OK;

  sg_term_close(&name);
  return good && add_cube(world, s);
}

/* No answer, for this reason; the call goes on. */
static bool
refused(sg_refused how, const char *what)
{
  bool is = call.refusal.how == how && !strcmp(call.refusal.what, what);

  call.refusal = (sg_refusal){0};
  return is;
}

static void
near(void)
{
  int32_t ids[] = {1, 3, 9};
  const sg_int_list some = {ids, 3, 3};
  sg_near_segments_rows rows = {0};
  sg_near_others_list of = {0};
  sg_id_pair_list pairs = {0};

  CHECK_DOOR("near", sg_door_near_segments(&call, 0, NULL, NULL, &rows));
  CHECK("three pairs", rows.n == 3);
  CHECK("ascending", rows.at[0].s1 == 1 && rows.at[0].s2 == 2 &&
                         rows.at[2].s1 == 2 && rows.at[2].s2 == 3);
  rows.n = 0;
  CHECK("no reach", !sg_door_near_segments(&call, -1, NULL, NULL, &rows));
  CHECK("is refused", refused(SG_REFUSED_DOMAIN, "not_less_than_zero"));
  CHECK_DOOR("of some", sg_door_near_segments_of(&call, 0, &some, &of));
  CHECK("one each", of.n == 3 && of.at[0].others.n == 1 &&
                        of.at[0].others.at[0] == 3 &&
                        of.at[1].others.at[0] == 1);
  CHECK("9 is no segment", of.at[2].s == 9 && of.at[2].others.n == 0);
  CHECK_DOOR("pairs of some", sg_door_near_pairs(&call, 0, &some, &pairs));
  CHECK("one", pairs.n == 1 && pairs.at[0].a == 1 && pairs.at[0].b == 3);
}

static sg_exact_point
point(double x, double y, double z)
{
  return (sg_exact_point){{NULL, x}, {NULL, y}, {NULL, z}};
}

static void
windings(void)
{
  sg_exact_point at[] = {point(0.5, 0.5, 0.5),
                         point(2, 0.5, 0.5),
                         point(-1, 0.5, 0.5),
                         point(1, 0.5, 0.5),
                         {{"1/3", 0}, {"1/3", 0}, {NULL, 0}},
                         {{"1/3", 0}, {"1/3", 0}, {"1/9", 0}}};
  const sg_exact_point_list points = {at, 6, 6}, none = {0};
  sg_winding_list w = {0};

  CHECK_DOOR("windings", sg_door_windings(&call, 1, &points, &w) && w.n == 6);
  CHECK("inside", w.at[0].is == SG_WINDING_TURNS && w.at[0].turns == 1);
  CHECK("outside", w.at[1].is == SG_WINDING_TURNS && w.at[1].turns == 0);
  CHECK("outside", w.at[2].is == SG_WINDING_TURNS && w.at[2].turns == 0);
  CHECK("on it", w.at[3].is == SG_WINDING_ON && w.at[4].is == SG_WINDING_ON);
  CHECK("exactly", w.at[5].is == SG_WINDING_TURNS && w.at[5].turns == 1);
  CHECK_DOOR("of none", sg_door_windings(&call, 1, &none, &w) && w.n == 0);
  CHECK_DOOR("of no segment", sg_door_windings(&call, 77, &points, &w));
  CHECK("are 0", w.n == 6 && w.at[0].turns == 0);
}

static void
itself(void)
{
  sg_self_segment_list segments = {0}, one = {0};

  CHECK_DOOR("itself", sg_door_self_meetings(&call, 5, &segments));
  CHECK_DOOR("one alone", sg_door_segment_meetings(&call, 1, 5, &one) &&
                              one.n == 1 && one.at[0].s == 1);
  CHECK("all segments", segments.n == 3 && segments.at[1].s == 2);
  CHECK("cubes do not", segments.at[0].counts.n == 0);
}

/* Of two cubes that go through each other, each polygon alone as of all. */
static void
itself_one_by_one(void)
{
  const double at[2][3] = {{50, 0, 0}, {50.5, 0.5, 0.5}};
  const sg_self_kind through = SG_SELF_PENETRATION, over = SG_SELF_OVERLAP;
  const int32_t s = 9;
  sg_self_meeting_rows all = {0}, none = {0};
  size_t n = 0;

  sg_world_begin(call.world);
  CHECK("two", add_cube_at(call.world, s, 0, at[0]) &&
                   add_cube_at(call.world, s, 1, at[1]) &&
                   sg_world_commit(call.world) == SG_OK);
  sg_call_rest(&call);
  CHECK_DOOR("meet", sg_door_self_meeting(&call, NULL, NULL, NULL, &all) &&
                         all.n > 3 && all.at[0].s == s);
  for (int32_t p = 1; p <= 12; p++) {
    sg_self_meeting_rows some = {0};

    CHECK_DOOR("one", sg_door_self_meeting(&call, &through, &s, &p, &some));
    for (size_t i = 0; i < some.n; i++) {
      CHECK("its own", some.at[i].p1 == p && some.at[i].kind == through);
    }
    n += some.n;
  }
  CHECK("are all", n == all.n);
  CHECK_DOOR("none lies on another",
             sg_door_self_meeting(&call, &over, NULL, NULL, &none) &&
                 none.n == 0);
  CHECK("as before", sg_world_undo(call.world) == SG_OK);
  sg_call_rest(&call);
}

static void
outline(void)
{
  sg_paper_point square[] = {{0, 0}, {9, 0}, {9, 9}, {0, 9}},
                 hole[] = {{1, 1}, {2, 1}, {2, 2}},
                 over[] = {{1, 1}, {12, 1}, {2, 2}};
  sg_paper_point_list loop[] = {{square, 4, 4}, {hole, 3, 3}};
  sg_list_paper_point_list loops = {loop, 2, 2};

  CHECK_DOOR("sound", sg_door_loops_are_sound(&call, &loops));
  loop[1].at = over;
  CHECK("not sound", !sg_door_loops_are_sound(&call, &loops));
  CHECK("nothing refused", call.refusal.how == SG_REFUSED_NOTHING);
  loop[1].n = 2;
  CHECK("no loop", !sg_door_loops_are_sound(&call, &loops));
  CHECK("is refused", refused(SG_REFUSED_DOMAIN, "loop"));
  loops.n = 0;
  CHECK("no loops", !sg_door_loops_are_sound(&call, &loops));
  CHECK("is refused", refused(SG_REFUSED_DOMAIN, "loops"));
}

int
main(void)
{
  sg_world *world = sg_world_open();

  sg_call_open(&call, NULL, NULL);
  call.world = world;
  CHECK("a world", world && add_segment(world, 3) && add_segment(world, 1) &&
                       add_segment(world, 2));
  near();
  windings();
  itself();
  itself_one_by_one();
  outline();
  sg_call_close(&call);
  sg_world_drop(world);
  return check_report();
}
