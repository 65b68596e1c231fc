/* cut_steps_test.c -- two cubes that go through each other, and a curve through
 * one, step by step as the rules ask, through the functions of the doors.
 *
 * covers: cut_enter, cut_model
 */
#include "doors/penetration.h"
#include "doors/work.h"
#include "penetration/cut_rows.h"

#include "tests/c_kernels/cube_world.h"
#include "tests/check.h"

#include <string.h>

enum { FIRST = 1, SECOND = 2, CURVE = 3, TOP = 2 };

static sg_call call;

static sg_cut_handle *
opened(int32_t s1, int32_t s2)
{
  sg_id_pair both[] = {{s1, s2}};
  sg_cut_handle *set = NULL;

  return sg_door_cut_set_open(&call, &(sg_id_pair_list){both, 1, 1}, &set)
             ? set
             : NULL;
}

static bool
is_refused(sg_refused how, const char *what, int argument)
{
  const sg_refusal *r = &call.refusal;
  bool is = r->how == how && !strcmp(r->what, what) && r->argument == argument;

  call.refusal = (sg_refusal){0};
  return is;
}

/* Pair by pair, with what a Boolean and a penetration say of the set. */
static void
enters(sg_cut_handle *set)
{
  sg_cut_candidate_rows all = {0};
  int32_t side1, side2, count, pieces = 0;

  CHECK("said", sg_door_cut_flat_within(&call, set, 0) &&
                    sg_door_cut_of_faces(&call, set) &&
                    sg_door_cut_without_coincident(&call, set) &&
                    sg_door_cut_few_sheets(&call, set) &&
                    sg_door_cut_own_tolerances(&call, set));
  CHECK("candidates", sg_door_cut_candidate(&call, set, &all) && all.n > 0);
  for (size_t i = 0; i < all.n; i++) {
    size_t t1 = all.at[i].t1, t2 = all.at[i].t2;
    CHECK("enter", sg_door_cut_side(&call, set, t1, t2, &side1) &&
                       sg_door_cut_side(&call, set, t2, t1, &side2) &&
                       sg_door_cut_enter(&call, set, t1, t2, &count));
    CHECK("nothing apart", count == 0 || (side1 == 0 && side2 == 0));
    pieces += count;
  }
  CHECK("pieces", pieces >= 6);
  CHECK("seal", sg_door_cut_seal(&call, set));
}

/* Pieces that go on in each other across a chord become one. */
static void
joins(sg_cut_handle *set)
{
  sg_piece_joint_list joints = {0}, after = {0};

  CHECK("joints",
        sg_door_cut_joints(&call, set, SG_JOINT_HOW_STRAIGHT, &joints));
  CHECK("there are", joints.n > 0);
  CHECK("no such point", !sg_door_cut_join(&call, set, 9999));
  call.refusal = (sg_refusal){0};
  for (size_t i = 0; i < joints.n; i++) {
    CHECK("join", sg_door_cut_join(&call, set, joints.at[i].point));
  }
  CHECK("joined already", !sg_door_cut_join(&call, set, joints.at[0].point) &&
                              is_refused(SG_REFUSED_DOMAIN, "joint", 2));
  CHECK("settle", sg_door_cut_settle(&call, set));
  CHECK("again", sg_door_cut_joints(&call, set, SG_JOINT_HOW_STRAIGHT, &after));
  CHECK("there is none", after.n == 0);
}

/* The polygon with the pieces that enter it. */
static sg_work *
entered_work(sg_cut_handle *set, int32_t s, int32_t p)
{
  sg_entering_piece_list pieces = {0};
  sg_work *work = NULL;
  int32_t e;

  CHECK("work", sg_door_cut_work(&call, set, s, p, &work) &&
                    sg_door_cut_entering(&call, set, s, p, &pieces));
  for (size_t i = 0; i < pieces.n; i++) {
    int32_t v1 = pieces.at[i].v1, v2 = pieces.at[i].v2;
    CHECK("pair", sg_door_work_add(&call, work, v1, v2, 1, -1, &e) &&
                      sg_door_work_add(&call, work, v2, v1, 1, -1, &e));
  }
  return work;
}

static size_t
all_edges(const sg_entered_polygon_list *all)
{
  size_t n = 0;

  for (size_t i = 0; i < all->n; i++) {
    n += sg_work_edges(all->at[i].work);
  }
  return n;
}

/* Joints in the polygons that pieces have entered. These cubes were not made to
 * touch, so lines have several vertices in one place: new edges would meet
 * others, and all stays. (penetration_kernels.plt merges some.) */
static void
merges(sg_cut_handle *set)
{
  sg_piece_joint_list joints = {0}, after = {0};
  sg_segment_polygon_list polygons = {0};
  sg_entered_polygon_list entered = {0};

  CHECK("joints",
        sg_door_cut_joints(&call, set, SG_JOINT_HOW_STRAIGHT, &joints) &&
            sg_door_cut_polygons(&call, set, &polygons));
  for (size_t i = 0; i < polygons.n; i++) {
    int32_t s = polygons.at[i].s, p = polygons.at[i].p;
    CHECK("entered",
          sg_entered_polygon_list_add(
              &call, &entered, (sg_entered){s, p, entered_work(set, s, p)}));
  }
  size_t before = all_edges(&entered);

  CHECK("merge", sg_door_cut_merge_near(&call, set, &joints, &entered));
  CHECK("all are left",
        sg_door_cut_joints(&call, set, SG_JOINT_HOW_STRAIGHT, &after) &&
            after.n == joints.n && all_edges(&entered) == before);
  joints.at[0].point = 9999;
  CHECK("no such point",
        !sg_door_cut_merge_near(&call, set, &joints, &entered) &&
            is_refused(SG_REFUSED_EXISTENCE, "cut_point", 2));
  for (size_t i = 0; i < entered.n; i++) {
    sg_work_close(entered.at[i].work);
  }
}

/* The rows of v/5 that are new; the line goes round where they are. */
static void
lines(sg_cut_handle *set)
{
  sg_segment_polygon_list polygons = {0};
  sg_vertex_fact_list vertices = {0};
  sg_edge_split_list splits = {0};
  sg_line_fact_list facts = {0};
  sg_line_chain_list chains = {0};
  int32_t l, v, named = 0;

  CHECK("polygons",
        sg_door_cut_polygons(&call, set, &polygons) && polygons.n == 6);
  CHECK("lines", sg_door_cut_lines(&call, set, &facts) && facts.n == 6);
  CHECK("the first", sg_door_cut_line(&call, set, FIRST, facts.at[0].a1,
                                      facts.at[0].b1, &l) &&
                         l == 1);
  CHECK("no other", !sg_door_cut_line(&call, set, FIRST, 1, 2, &l));
  CHECK("splits", sg_door_cut_split_edges(&call, set, FIRST, &splits));
  CHECK("of the three edges of a corner",
        splits.n == 3 && splits.at[0].on.n == 1);
  CHECK("vertices", sg_door_cut_vertices(&call, set, &vertices));
  for (size_t i = 0; i < vertices.n; i++) {
    const sg_vertex_fact *x = &vertices.at[i];
    CHECK("vertex",
          sg_call_add_row(&call, call.world, SG_V,
                          (const sg_value[SG_MAX_COLUMNS]){{.i = x->s},
                                                           {.i = x->v},
                                                           {.f = x->x},
                                                           {.f = x->y},
                                                           {.f = x->z}}));
    named += sg_door_cut_name(&call, set, i, FIRST, &v);
  }
  CHECK("points have names", named > 0);
  for (size_t i = 0; i < facts.n; i++) {
    const sg_line_fact *x = &facts.at[i];
    CHECK("line",
          sg_call_add_row(&call, call.world, SG_LINE,
                          (const sg_value[SG_MAX_COLUMNS]){{.i = x->l},
                                                           {.i = x->s1},
                                                           {.i = x->p1},
                                                           {.i = x->a1},
                                                           {.i = x->b1},
                                                           {.i = x->s2},
                                                           {.i = x->p2},
                                                           {.i = x->a2},
                                                           {.i = x->b2}}));
  }
  CHECK("chains", sg_door_line_chains(&call, &chains));
  CHECK("one, closed", chains.n == 1 && chains.at[0].lines.n == 6 &&
                           chains.at[0].kind == SG_CHAIN_KIND_CLOSED);
}

/* The upper face, 5-6-8-7, in which two diagonals cross. */
static void
divides(sg_cut_handle *set)
{
  sg_entering_piece_list pieces = {0};
  sg_id_pair_list divided = {0};
  sg_segment_polygon_list late = {0};
  sg_vertex_fact_list vertices = {0};
  sg_work *work = NULL;
  int32_t e, x = 0, again = 0;

  CHECK("no face 99", !sg_door_cut_work(&call, set, FIRST, 99, &work));
  call.refusal = (sg_refusal){0};
  CHECK("face", sg_door_cut_work(&call, set, FIRST, TOP, &work));
  CHECK("pieces",
        sg_door_cut_entering(&call, set, FIRST, TOP, &pieces) && pieces.n == 2);
  CHECK("diagonal", sg_door_work_add(&call, work, 6, 7, 0, false, &e));
  CHECK("no edge 99", !sg_door_cut_crossing(&call, set, work, FIRST,
                                            pieces.at[0].k, 99, 5, 8, &x) &&
                          is_refused(SG_REFUSED_EXISTENCE, "work_edge", 5));
  CHECK("crossing", sg_door_cut_crossing(&call, set, work, FIRST,
                                         pieces.at[0].k, e, 5, 8, &x));
  CHECK("vertices", sg_door_cut_vertices(&call, set, &vertices));
  for (size_t i = 0; i < vertices.n; i++) {
    const sg_vertex_fact *v = &vertices.at[i];
    CHECK("in the middle",
          v->v != x || v->s != FIRST || (v->x == 0.5 && v->y == 0.5));
  }
  CHECK("note", sg_door_cut_note(&call, set, FIRST, 5, 8, x) &&
                    sg_door_cut_note(&call, set, FIRST, 6, 7, x));
  CHECK("between", sg_door_cut_between(&call, set, work, FIRST, 8, 5, &again) &&
                       again == x);
  CHECK("divided", sg_door_cut_divided(&call, set, work, FIRST, &divided));
  CHECK("the diagonal",
        divided.n == 1 && divided.at[0].a == e && divided.at[0].b == x);
  CHECK("so it was", sg_door_cut_was_divided(&call, set));
  CHECK("agree", sg_door_cut_agree(&call, set));
  CHECK("no edge of a face was",
        sg_door_cut_late_polygons(&call, set, &late) && late.n == 0);
  sg_work_close(work);
}

static void
enters_free(sg_cut_handle *set)
{
  sg_work_edge_rows before = {0}, after = {0};
  sg_work *work = NULL;

  CHECK("face", sg_door_cut_work(&call, set, SECOND, 1, &work));
  CHECK("edges", sg_door_work_edge(&call, work, NULL, NULL, NULL, &before));
  CHECK("free", sg_door_cut_enter_free(&call, set, SECOND, 1, work));
  CHECK("more edges",
        sg_door_work_edge(&call, work, NULL, NULL, NULL, &after) &&
            after.n > before.n);
  sg_work_close(work);
}

/* An edge in space through the first cube, up and down. */
static bool
add_curve(sg_world *world)
{
  static const double z[2] = {-1, 2};
  bool good = true;

  for (int32_t v = 1; v <= 2; v++) {
    good = good &&
           sg_call_add_row(&call, world, SG_V,
                           (const sg_value[SG_MAX_COLUMNS]){{.i = CURVE},
                                                            {.i = v},
                                                            {.f = 0.25},
                                                            {.f = 0.5},
                                                            {.f = z[v - 1]}});
  }
  return good && sg_call_add_row(
                     &call, world, SG_E,
                     (const sg_value[SG_MAX_COLUMNS]){
                         {.i = CURVE}, {.i = 1}, {.i = 1}, {.i = 2}, {.i = 1}});
}

static void
curves(void)
{
  sg_cut_handle *set = opened(FIRST, CURVE);
  sg_curve_candidate_rows all = {0};
  int32_t count, points = 0;

  CHECK("candidates",
        set && sg_door_curve_candidate(&call, set, &all) && all.n >= 2);
  for (size_t i = 0; i < all.n; i++) {
    CHECK("enter",
          sg_door_curve_enter(&call, set, all.at[i].e, all.at[i].t, &count));
    points += count;
  }
  CHECK("in and out", points == 2);
  sg_cut_set_let_go(set);
}

int
main(void)
{
  sg_world *world = sg_world_open();
  sg_cut_handle *set;

  sg_call_open(&call, NULL, NULL);
  call.world = world;
  CHECK("two cubes and a curve",
        world && add_cube(world, FIRST) &&
            add_cube_at(world, SECOND, 0, (double[3]){0.25, 0.375, 0.75}) &&
            add_curve(world));
  curves();
  set = opened(FIRST, SECOND);
  enters(set);
  merges(set);
  sg_cut_set_let_go(set);
  set = opened(FIRST, SECOND);
  enters(set);
  joins(set);
  lines(set);
  enters_free(set);
  divides(set);
  sg_cut_set_let_go(set);
  sg_call_close(&call);
  sg_world_let_go(world);
  return check_report();
}
