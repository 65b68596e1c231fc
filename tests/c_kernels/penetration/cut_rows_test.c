/* cut_rows_test.c -- two cubes that go through each other, through the
 * functions of the doors, without Prolog.
 *
 * covers: divided_rows, leaf_rows, polygon_rows, resolve_feature, resolve_rows
 */
#include "doors/penetration.h"
#include "doors/work.h"
#include "doors/world.h"
#include "penetration/cut_rows.h"

#include "engine/symbol.h"
#include "engine/term.h"
#include "tests/c_kernels/cube_world.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"
#include "tests/stop_later.h"

#include <math.h>
#include <string.h>

enum { FIRST = 1, SECOND = 2, THIRD = 3, FOURTH = 4, FIFTH = 5, SIXTH = 6 };

static sg_call call;

static void
pairs(sg_cut_handle *set)
{
  sg_cut_candidate_rows all = {0};
  sg_curve_candidate_rows curves = {0};
  sg_triangle_cut_list cuts = {0};
  int32_t side, count, s, p, t;
  size_t touching = 0, end;

  CHECK_DOOR("candidates", sg_door_cut_candidate(&call, set, &all));
  end = set->set.model.triangles;
  CHECK_DOOR("the last triangle",
             sg_door_cut_side(&call, set, 0, end - 1, &side));
  CHECK("no triangle behind it", !sg_door_cut_side(&call, set, 0, end, &side));
  CHECK("is missing",
        call.refusal.how == SG_REFUSED_EXISTENCE && call.refusal.argument == 3);
  call.refusal = (sg_refusal){0};
  CHECK("nor as the first", !sg_door_cut_enter(&call, set, end, 0, &count));
  CHECK("is missing there",
        call.refusal.how == SG_REFUSED_EXISTENCE && call.refusal.argument == 2);
  call.refusal = (sg_refusal){0};
  CHECK_DOOR("solids have no curves",
             sg_door_curve_candidate(&call, set, &curves) && curves.n == 0);
  for (size_t i = 0; i < all.n; i++) {
    CHECK_DOOR("cuts",
               sg_door_cut_ends(&call, set, all.at[i].t1, all.at[i].t2, &cuts));
    touching += cuts.n > 0;
  }
  CHECK("some are near, fewer touch", touching > 0 && touching <= all.n);
  CHECK_DOOR("triangle",
             sg_door_cut_triangle(&call, set, all.at[0].t1, &s, &p, &t));
  CHECK("of the first", s == FIRST);
}

static void
lines(sg_cut_handle *set)
{
  sg_piece_chain_list chains = {0};
  sg_segment_polygon_list all = {0}, of_none = {0};
  sg_vertex_fact_list vertices = {0};
  sg_line_fact_list facts = {0};
  int32_t segment = 7;
  const sg_int_list none = {&segment, 1, 1};

  CHECK_DOOR("find", sg_door_cut_find(&call, set));
  CHECK_DOOR("seal", sg_door_cut_seal(&call, set));
  CHECK_DOOR("chains", sg_door_cut_chains(&call, set, &chains));
  CHECK("one, closed",
        chains.n == 1 && chains.at[0].kind == SG_CHAIN_KIND_CLOSED);
  CHECK("comes back to its start",
        chains.at[0].points.n == chains.at[0].polygons.n + 1 &&
            chains.at[0].points.at[0].x ==
                chains.at[0].points.at[chains.at[0].polygons.n].x);
  CHECK_DOOR("polygons", sg_door_cut_polygons(&call, set, &all));
  CHECK("three of each", all.n == 6);
  CHECK_DOOR("of another",
             sg_door_cut_polygons_of(&call, set, &none, &of_none));
  CHECK("none", of_none.n == 0);
  CHECK_DOOR("vertices", sg_door_cut_vertices(&call, set, &vertices));
  CHECK("are new", vertices.n >= 12 && vertices.at[0].v > 8);
  CHECK_DOOR("lines", sg_door_cut_lines(&call, set, &facts));
  CHECK("from 1", facts.n == chains.at[0].polygons.n && facts.at[0].l == 1);
}

static size_t
count_of(sg_world *world, sg_relation relation)
{
  const sg_version *version = sg_world_version(world);
  size_t n = sg_version_count(version, relation);

  sg_version_drop(version);
  return n;
}

/* Six polygons enter and are written; only their own rows change. */
static void
writes(sg_world *world, sg_cut_handle *set)
{
  sg_segment_polygon_list polygons = {0};
  sg_work_list works = {0}, more = {0};
  sg_entering_piece_list pieces = {0};
  sg_entered_polygon_list entered = {0};
  size_t written = 0;
  int32_t x;

  CHECK_DOOR("polygons", sg_door_cut_polygons(&call, set, &polygons));
  CHECK_DOOR("queue", sg_door_cut_queue(&call, set, &polygons));
  CHECK_DOOR("enter", sg_door_cut_enter_queued(&call, set, &works));
  CHECK("all are free", works.n == polygons.n && polygons.n > 0);
  CHECK_DOOR("no more",
             sg_door_cut_enter_queued(&call, set, &more) && more.n == 0);
  CHECK("nothing was divided", !sg_door_cut_was_divided(&call, set));
  CHECK_DOOR("entering", sg_door_cut_entering(&call, set, polygons.at[0].s,
                                              polygons.at[0].p, &pieces));
  CHECK("pieces", pieces.n > 0);
  CHECK("nothing between",
        !sg_door_cut_between(&call, set, works.at[0], polygons.at[0].s,
                             pieces.at[0].v1, pieces.at[0].v2, &x));
  CHECK("is no error", call.refusal.how == SG_REFUSED_NOTHING);
  CHECK_DOOR("lines and vertices", sg_door_cut_write_lines(&call, set));
  for (size_t i = 0; i < works.n; i++) {
    CHECK("entered",
          sg_entered_polygon_list_add(
              &call, &entered,
              (sg_entered){polygons.at[i].s, polygons.at[i].p, works.at[i]}));
  }
  CHECK_DOOR("write", sg_door_cut_write(&call, set, &entered, &written));
  CHECK("all", written == works.n);
  for (size_t i = 0; i < works.n; i++) {
    sg_work_close(works.at[i]);
  }
  const sg_version *version = sg_world_version(world);

  CHECK("twelve polygons", sg_version_count(version, SG_P) == 12);
  CHECK("more edges", sg_version_count(version, SG_E) > 48);
  CHECK("more triangles", sg_version_count(version, SG_T) > 24);
  CHECK("lines", sg_version_count(version, SG_LINE) > 0);
  CHECK("vertices", sg_version_count(version, SG_V) > 16);
  CHECK("with origins", sg_version_count(version, SG_ORIGIN) > 0);
  sg_version_drop(version);
}

/* What touches up to rounding: a cube on a cube. */
static void
touches(sg_world *world)
{
  sg_id_pair both[] = {{FIRST, THIRD}};
  const sg_id_pair_list list = {both, 1, 1};
  sg_cut_handle *set = NULL;
  sg_resolution what;
  sg_touch_moves moves;
  sg_vertex_fact_list vertices = {0};
  sg_resolved_fact_list polygons = {0};

  CHECK("a third", add_cube_moved(world, THIRD, 0, -1 - 1e-9));
  CHECK_DOOR("open", sg_door_cut_set_open(&call, &list, &set));
  CHECK("no reach", !sg_door_cut_touch(&call, set, 0, &what, &moves));
  CHECK("is refused",
        call.refusal.how == SG_REFUSED_DOMAIN && call.refusal.argument == 2);
  call.refusal = (sg_refusal){0};
  CHECK_DOOR("resolve", sg_door_cut_resolve(&call, set, 1e-6, &what, &vertices,
                                            &polygons));
  CHECK("one vertex each", what.is == SG_RESOLUTION_CHANGED && vertices.n > 0 &&
                               vertices.at[0].origin);
  CHECK_DOOR("touch", sg_door_cut_touch(&call, set, 1e-6, &what, &moves));
  CHECK("changed", what.is == SG_RESOLUTION_CHANGED);
  CHECK("tight: a gap that no source explains is closed",
        moves.is == SG_TOUCH_MOVES_MOVE &&
            moves.move.how == SG_MOVE_HOW_TIGHT && moves.move.s.s1 == FIRST &&
            moves.move.s.s2 == THIRD);
  sg_cut_set_let_go(set);
}

/* origin(s, s(s), source(grain)) */
static bool
add_grain(sg_world *world, int32_t s, double grain)
{
  sg_term_builder of, source;

  sg_term_open(&of);
  sg_term_unary(&of, SG_SYMBOL_S, s);
  sg_term_open(&source);
  sg_term_compound(&source, SG_SYMBOL_SOURCE, 1);
  sg_term_float(&source, grain);
  sg_status status =
      sg_world_add(world, SG_ORIGIN,
                   (sg_value[]){{.i = s},
                                {.term = sg_term_words(&of)},
                                {.term = sg_term_words(&source)}},
                   NULL, NULL);

  sg_term_close(&of);
  sg_term_close(&source);
  return status == SG_OK;
}

/* Two cubes of one segment, paired with itself: what is closed between them is
 * no gap of the segment. */
static void
touches_itself(sg_world *world)
{
  sg_id_pair itself[] = {{SIXTH, SIXTH}};
  const sg_id_pair_list list = {itself, 1, 1};
  sg_cut_handle *set = NULL;
  sg_resolution what;
  sg_touch_moves moves;

  CHECK("two in one",
        add_cube_at(world, SIXTH, 0, (double[3]){8, 8, 8}) &&
            add_cube_at(world, SIXTH, 1, (double[3]){9 + 1e-9, 8, 8}));
  CHECK("its source is coarser", add_grain(world, SIXTH, 1e-8));
  CHECK_DOOR("open", sg_door_cut_set_open(&call, &list, &set));
  CHECK_DOOR("touch", sg_door_cut_touch(&call, set, 1e-6, &what, &moves) &&
                          what.is == SG_RESOLUTION_CHANGED);
  CHECK("moved, by what the source leaves open",
        moves.is == SG_TOUCH_MOVES_MOVE &&
            moves.move.how == SG_MOVE_HOW_MOVED && moves.move.s.s1 == SIXTH &&
            moves.move.s.s2 == 0 && fabs(moves.move.move - 1e-9) < 1e-14);
  sg_cut_set_let_go(set);
}

/* Where three meet, the first two of them are named. */
static void
touches_three(sg_world *world)
{
  sg_id_pair all[] = {{FIRST, FOURTH}, {FIRST, FIFTH}, {FOURTH, FIFTH}};
  const sg_id_pair_list list = {all, 3, 3};
  const double off = 1 + 1e-9;
  sg_cut_handle *set = NULL;
  sg_resolution what;
  sg_touch_moves moves;

  CHECK("corner to corner",
        add_cube_at(world, FOURTH, 0, (double[3]){-off, off, off}) &&
            add_cube_at(world, FIFTH, 0, (double[3]){-off, off, -off + 1}));
  CHECK("open", sg_door_cut_set_open(&call, &list, &set));
  CHECK("touch", sg_door_cut_touch(&call, set, 1e-6, &what, &moves) &&
                     what.is == SG_RESOLUTION_CHANGED &&
                     moves.is == SG_TOUCH_MOVES_MOVE);
  CHECK("at a corner of all", fabs(moves.move.at.x) < 1e-8 &&
                                  fabs(moves.move.at.y - 1) < 1e-8 &&
                                  fabs(moves.move.at.z - 1) < 1e-8);
  CHECK("the first two", moves.move.s.s1 == FIRST && moves.move.s.s2 == FOURTH);
  sg_cut_set_let_go(set);
}

/* A door that is stopped says no without a refusal; after a rollback the world
 * is as it was. All doors from the cuts to the lines, stopped at question k;
 * *rows: of v, line and origin. True: it was not asked so often. */
static bool
runs(sg_world *world, const sg_id_pair_list *list, int k, size_t rows[3])
{
  int left = k;
  sg_cancel cancel = {stop_later, &left};
  sg_call caller = call;
  sg_cut_handle *set = NULL;
  sg_segment_polygon_list all = {0}, of_one = {0};
  int32_t segment = FIRST;
  const sg_int_list one = {&segment, 1, 1};

  sg_call_open(&call, &cancel, NULL);
  call.world = world;
  CHECK("begin", sg_world_begin(world) == SG_OK);
  bool good = sg_door_cut_set_open(&call, list, &set) &&
              sg_door_cut_find(&call, set) && sg_door_cut_seal(&call, set) &&
              sg_door_cut_settle(&call, set) &&
              sg_door_cut_polygons(&call, set, &all) &&
              sg_door_cut_polygons_of(&call, set, &one, &of_one) &&
              sg_door_cut_write_lines(&call, set);

  CHECK("stopped, or done", good == (left >= 0));
  CHECK("no refusal", call.refusal.how == SG_REFUSED_NOTHING);
  CHECK("polygons", !good || (all.n == 6 && of_one.n == 6));
  sg_call_close(&call);
  if (set) {
    sg_cut_set_let_go(set);
  }
  call = caller;
  for (int i = 0; i < 3; i++) {
    rows[i] = count_of(world, (sg_relation[]){SG_V, SG_LINE, SG_ORIGIN}[i]);
  }
  CHECK("valid", sg_world_is_valid(world));
  CHECK("roll back", sg_world_rollback(world) == SG_OK);
  CHECK("as it was", sg_world_is_valid(world) && count_of(world, SG_V) == 16 &&
                         count_of(world, SG_LINE) == 0 &&
                         count_of(world, SG_ORIGIN) == 0);
  return good;
}

static void
stops(sg_world *world, const sg_id_pair_list *list)
{
  size_t rows[3];
  int k = 0;

  while (k < 1000 && !runs(world, list, k, rows)) {
    CHECK("each relation is whole", rows[1] == 0 && rows[2] <= rows[0]);
    k++;
  }
  CHECK("asks", k > 20 && k < 1000);
  CHECK("then all is written", rows[0] > 16 && rows[1] > 0 && rows[2] > 0);
}

static void
leaves(sg_world *world)
{
  sg_segment_polygon kept[] = {{FIRST, 1}, {FIRST, 1}, {FIRST, 2}};
  sg_segment_polygon gone[] = {{FIRST, 9}};
  const sg_segment_polygon_list two = {kept, 3, 3}, none = {gone, 1, 1};

  CHECK_DOOR("keep", sg_door_leaves_keep(&call, &two));
  const sg_version *version = sg_world_version(world);

  CHECK("each once", sg_version_count(version, SG_LEAF_P) == 2);
  CHECK("edges", sg_version_count(version, SG_LEAF_E) == 8);
  CHECK("triangles", sg_version_count(version, SG_LEAF_T) == 4);
  sg_version_drop(version);
  CHECK("no polygon 9", !sg_door_leaves_keep(&call, &none));
  CHECK("is no error", call.refusal.how == SG_REFUSED_NOTHING);
}

int
main(void)
{
  sg_id_pair both[] = {{FIRST, SECOND}};
  const sg_id_pair_list list = {both, 1, 1};
  sg_world *world = sg_world_open();
  sg_cut_handle *set = NULL;

  sg_call_open(&call, NULL, NULL);
  call.world = world;
  CHECK("two cubes", world && add_cube(world, FIRST) &&
                         add_cube_moved(world, SECOND, 0, 0.5));
  CHECK_DOOR("planes",
             sg_door_fill_triangles(
                 &call, &(sg_segments_asked){.is = SG_SEGMENTS_ASKED_ALL},
                 SIZE_MAX, &(sg_fault_fact_list){0}));
  stops(world, &list);
  CHECK_DOOR("open", sg_door_cut_set_open(&call, &list, &set));
  sg_cut_set_keep(set);
  sg_cut_set_let_go(set); /* as when its handle is closed */
  pairs(set);
  leaves(world);
  lines(set);
  writes(world, set);
  sg_cut_set_let_go(set);
  touches(world);
  sg_call_rest(&call);
  touches_three(world);
  sg_call_rest(&call);
  touches_itself(world);
  sg_call_close(&call);
  sg_world_let_go(world);
  return check_report();
}
