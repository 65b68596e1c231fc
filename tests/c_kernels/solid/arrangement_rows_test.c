/* arrangement_rows_test.c -- two cubes that penetrate each other, in pieces and
 * united, through the functions of the doors, without Prolog.
 *
 * covers: arrangement_choice, id_set
 */
#include "doors/boolean.h"
#include "doors/penetration.h"
#include "doors/world.h"
#include "solid/arrangement_rows.h"

#include "tests/c_kernels/cube_world.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

#include <string.h>

enum { FIRST = 1, SECOND = 2 };

static sg_call call;
static int32_t both[] = {FIRST, SECOND};
static const sg_int_list segments = {both, 2, 2};

static bool
was_refused(sg_refused how, size_t item, int field)
{
  bool was = call.refusal.how == how && call.refusal.item == item &&
             call.refusal.field == field;

  call.refusal = (sg_refusal){.how = SG_REFUSED_NOTHING};
  return was;
}

/* Lines that go on straight where a diagonal of a face was crossed are one. */
static bool
joined(sg_cut_handle *set)
{
  sg_piece_joint_list joints = {0};
  bool good = sg_door_cut_joints(&call, set, SG_JOINT_HOW_STRAIGHT, &joints);

  for (size_t i = 0; good && i < joints.n; i++) {
    good = sg_door_cut_join(&call, set, joints.at[i].point);
  }
  return good && sg_door_cut_settle(&call, set);
}

static sg_arrangement_handle *
opened(sg_cut_handle *set)
{
  sg_arrangement_handle *h = NULL;
  int32_t third = 3;

  CHECK("not of these", !sg_door_arrangement_open(
                            &call, set, &segments, &(sg_int_list){&third, 1, 1},
                            &(sg_arrangement_weight_list){0}, &h) &&
                            was_refused(SG_REFUSED_DOMAIN, 0, 0));
  CHECK_DOOR("open",
             sg_door_arrangement_open(&call, set, &segments, &segments,
                                      &(sg_arrangement_weight_list){0}, &h));
  return h;
}

static void
fills(sg_cut_handle *set, sg_arrangement_handle *h,
      const sg_arrangement_piece_list *pieces)
{
  sg_segment_polygon_list polygons = {0};
  sg_component_fact_list none = {0};

  CHECK_DOOR("polygons",
             sg_door_cut_polygons_of(&call, set, &segments, &polygons) &&
                 polygons.n == 6);
  CHECK("not sealed", !sg_door_arrangement_components(&call, pieces, &none) &&
                          was_refused(SG_REFUSED_PERMISSION, 1, 2));
  CHECK_DOOR("fill", sg_door_arrangement_free_polygons(&call, h, &polygons, 0));
  CHECK_DOOR("seal", sg_door_arrangement_seal(&call, h));
  CHECK("once", !sg_door_arrangement_seal(&call, h) &&
                    was_refused(SG_REFUSED_PERMISSION, 0, 0));
}

/* The same of polygons that were entered one by one. */
static void
fills_by_works(sg_cut_handle *set)
{
  sg_arrangement_handle *h = opened(set);
  sg_arrangement_piece piece[] = {{FIRST, h}, {SECOND, h}};
  sg_entered entered[6];
  sg_segment_polygon_list polygons = {0};
  sg_component_fact_list all = {0};
  sg_work_list works = {0};

  CHECK_DOOR("polygons", sg_door_cut_polygons(&call, set, &polygons) &&
                             sg_door_cut_queue(&call, set, &polygons) &&
                             sg_door_cut_enter_queued(&call, set, &works));
  CHECK("all are free", works.n == 6 && polygons.n == 6);
  for (size_t i = 0; i < works.n; i++) {
    entered[i] = (sg_entered){polygons.at[i].s, polygons.at[i].p, works.at[i]};
  }
  CHECK_DOOR("fill",
             sg_door_arrangement_polygons(
                 &call, h, &(sg_entered_polygon_list){entered, 6, 0}, 0));
  CHECK_DOOR("seal", sg_door_arrangement_seal(&call, h));
  CHECK_DOOR("components",
             sg_door_arrangement_components(
                 &call, &(sg_arrangement_piece_list){piece, 2, 0}, &all) &&
                 all.n == 4);
  for (size_t i = 0; i < works.n; i++) {
    sg_work_close(works.at[i]);
  }
  CHECK_DOOR("drop", sg_door_arrangement_drop(&call, h));
  sg_arrangement_handle_free(h);
}

/* A polygon that lacks an edge cannot be triangulated. */
static void
is_stuck(sg_cut_handle *set)
{
  sg_arrangement_handle *h = opened(set);
  sg_work *work = NULL;

  CHECK_DOOR("work", sg_door_cut_work(&call, set, FIRST, 2, &work));
  sg_work_delete(work, sg_work_next(work, 0));
  sg_entered polygon = {FIRST, 2, work};

  CHECK("it is not closed",
        !sg_door_arrangement_polygons(
            &call, h, &(sg_entered_polygon_list){&polygon, 1, 1}, 0) &&
            call.refusal.how == SG_REFUSED_GEOMETRY &&
            !strcmp(call.refusal.what, "polygon_edge") &&
            call.refusal.numbers == 4 && call.refusal.of[0] == FIRST &&
            call.refusal.of[1] == 2 && call.refusal.of[2] > 0);
  call.refusal = (sg_refusal){.how = SG_REFUSED_NOTHING};
  sg_work_close(work);
  sg_arrangement_handle_free(h);
}

static void
components(const sg_arrangement_piece_list *pieces)
{
  sg_component_fact_list all = {0};
  sg_integer_list numbers = {0};
  sg_arrangement_piece other = {3, pieces->at[0].arrangement};

  CHECK_DOOR("components", sg_door_arrangement_components(&call, pieces, &all));
  CHECK("inside and outside of each", all.n == 4);
  for (size_t i = 0; i < all.n; i++) {
    CHECK("each lies on nothing",
          all.at[i].number == i && all.at[i].s == (i < 2 ? FIRST : SECOND) &&
              all.at[i].which == SG_COMPONENT_WHICH_ONLY);
  }
  CHECK_DOOR("one arrangement",
             sg_door_arrangement_numbers(&call, pieces, &numbers) &&
                 numbers.n == 2 && numbers.at[0] == numbers.at[1]);
  CHECK("no piece of it",
        !sg_door_arrangement_numbers(
            &call, &(sg_arrangement_piece_list){&other, 1, 1}, &numbers) &&
            was_refused(SG_REFUSED_EXISTENCE, 1, 0));
}

static void
senses(const sg_arrangement_piece_list *pieces)
{
  sg_expression_node_fact node[] = {
      {SG_UNION, 2}, {SG_LEAF, FIRST}, {SG_LEAF, SECOND}};
  sg_component_sense_list chosen = {0}, wrong = {0};
  sg_solid *solid = NULL;

  for (size_t n = 0; n < 3; n++) {
    CHECK("operands are missing",
          !sg_door_arrangement_senses(
              &call, pieces, &(sg_expression_node_fact_list){node, n, n},
              &(sg_int_list){0}, &chosen) &&
              was_refused(SG_REFUSED_DOMAIN, 0, 0));
  }
  CHECK_DOOR("union",
             sg_door_arrangement_senses(
                 &call, pieces, &(sg_expression_node_fact_list){node, 3, 3},
                 &(sg_int_list){0}, &chosen));
  CHECK("what is outside",
        chosen.n == 2 && !chosen.at[0].reversed && !chosen.at[1].reversed);
  CHECK("wrong",
        sg_component_sense_list_add(&call, &wrong,
                                    (sg_component_sense){4, false}) &&
            !sg_door_arrangement_select(&call, pieces, &wrong, &solid) &&
            was_refused(SG_REFUSED_EXISTENCE, 1, 1));
  CHECK_DOOR("select",
             sg_door_arrangement_select(&call, pieces, &chosen, &solid));
  CHECK_DOOR("six corners were made, seven of each stay",
             sg_door_solid_is_closed(&call, solid) && solid->vertices == 20 &&
                 solid->plain == 14);
  for (size_t i = 0; i < solid->vertices - solid->plain; i++) {
    CHECK("by cuts", solid->origin[i] != NULL);
  }
  sg_solid_free(solid);
}

static void
ends(sg_arrangement_handle *h)
{
  CHECK_DOOR("hold", sg_door_arrangement_hold(&call, h));
  CHECK_DOOR("drop", sg_door_arrangement_drop(&call, h));
  CHECK("still open", h->arrangement != NULL);
  CHECK_DOOR("drop", sg_door_arrangement_drop(&call, h));
  CHECK("closed", !sg_door_arrangement_hold(&call, h) &&
                      was_refused(SG_REFUSED_EXISTENCE, 0, 0));
  sg_arrangement_handle_free(h);
}

int
main(void)
{
  sg_id_pair pair = {FIRST, SECOND};
  sg_world *world = sg_world_open();
  sg_cut_handle *set = NULL;

  sg_call_open(&call, NULL, NULL);
  call.world = world;
  CHECK("two cubes",
        world && add_cube(world, FIRST) &&
            add_cube_moved(world, SECOND, 0, 0.5) &&
            sg_door_fill_triangles(
                &call, &(sg_segments_asked){.is = SG_SEGMENTS_ASKED_ALL},
                SIZE_MAX, &(sg_fault_fact_list){0}));
  sg_call_rest(&call);
  CHECK_DOOR("cuts", sg_door_cut_set_open(
                         &call, &(sg_id_pair_list){&pair, 1, 1}, &set) &&
                         sg_door_cut_find(&call, set) &&
                         sg_door_cut_seal(&call, set) && joined(set));
  fills_by_works(set);
  sg_arrangement_handle *h = opened(set);
  sg_arrangement_piece piece[] = {{FIRST, h}, {SECOND, h}};
  const sg_arrangement_piece_list pieces = {piece, 2, 2};

  fills(set, h, &pieces);
  is_stuck(set);
  sg_cut_set_let_go(set);
  components(&pieces);
  senses(&pieces);
  ends(h);
  sg_call_close(&call);
  sg_world_let_go(world);
  return check_report();
}
