/* boolean_rows_test.c -- what Booleans ask and change of rows through the
 * functions of the doors, without Prolog: csg_rows.c, leaf_copy_rows.c,
 * shell_copy_rows.c, sewing_rows.c and operand_border_rows.c.
 */
#include "doors/boolean.h"
#include "engine/term.h"

#include "tests/c_kernels/cube_world.h"
#include "tests/c_kernels/door_call.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

enum { CUBE = 1, TWICE = 2 };

/* ---- csg_rows.c ---- */

/* origin(s, functor(s), s). */
static bool
add_origin(int32_t s, int32_t functor)
{
  sg_term_builder item, origin;

  sg_term_open(&item);
  sg_term_open(&origin);
  sg_term_unary(&item, functor, s);
  sg_term_int(&origin, s);
  sg_status status =
      sg_world_add(call.world, SG_ORIGIN,
                   (sg_value[]){{.i = s},
                                {.term = sg_term_words(&item)},
                                {.term = sg_term_words(&origin)}},
                   NULL, NULL);

  sg_term_close(&item);
  sg_term_close(&origin);
  return status == SG_OK;
}

static void
no_primitives(void)
{
  int64_t asked[] = {CUBE, 7, -1, INT64_MAX};
  sg_int_list kinds = {0}, others = {0};

  CHECK("segments", add_segment(CUBE) && add_segment(TWICE));
  CHECK_DOOR("kinds", sg_door_kept_leaves(
                          &call, &(sg_integer_list){asked, 4, 4}, &kinds));
  CHECK("one each", kinds.n == 4);
  for (size_t i = 0; i < kinds.n; i++) {
    CHECK("other", kinds.at[i] == sg_symbol_find("other", 5));
  }
  CHECK_DOOR("others", sg_door_other_segments(&call, &others));
  CHECK("both", others.n == 2 && others.at[0] == CUBE && others.at[1] == TWICE);
}

static void
origins_of_nodes(void)
{
  sg_node_origin_list found = {0};

  CHECK("origins",
        add_origin(CUBE, SG_SYMBOL_V) && add_origin(CUBE, SG_SYMBOL_NODE));
  sg_call_rest(&call);
  CHECK_DOOR("of nodes", sg_door_node_origins(&call, CUBE, &found));
  CHECK("one", found.n == 1 && sg_term_vertex(found.at[0].item) == 0 &&
                   sg_term_length(found.at[0].origin) == 2);
}

/* ---- operand_border_rows.c ---- */

static void
borders(void)
{
  sg_operand_border_list found = {0};
  int32_t s[] = {CUBE};

  for (int32_t p = 1; p <= 6; p++) {
    CHECK("from", sg_world_add(call.world, SG_FROM_P,
                               (sg_value[]){{.i = CUBE},
                                            {.i = p},
                                            {.i = p <= 3 ? 7 : 8},
                                            {.i = 1},
                                            {.i = 1}},
                               NULL, NULL) == SG_OK);
  }
  sg_call_rest(&call);
  CHECK_DOOR("borders",
             sg_door_operand_borders(&call, &(sg_int_list){s, 1, 1}, &found));
  CHECK("three of the bottom, three of the top, two of the front",
        found.n == 8);
  for (size_t i = 0; i < found.n; i++) {
    CHECK("ascending", found.at[i].low < found.at[i].high &&
                           (i == 0 || found.at[i - 1].low <= found.at[i].low));
  }
}

/* ---- shell_copy_rows.c ---- */

/* In a world of its own. */
static void
copies(void)
{
  sg_world *world = sg_world_open();

  sg_call_open(&call, NULL, NULL);
  call.world = world;
  CHECK("cubes", world && add_cube(world, CUBE) && add_cube(world, TWICE) &&
                     add_cube_again(world, TWICE, 1));
  CHECK("not so many", !sg_door_segment_copies_dropped(&call, CUBE, 1) &&
                           !sg_door_segment_copies_dropped(&call, TWICE, 2));
  CHECK("no segment", !sg_door_segment_copies_dropped(&call, 7, 1));
  CHECK("is no error", call.refusal.how == SG_REFUSED_NOTHING);
  CHECK("something was made of it", add_origin(TWICE, SG_SYMBOL_V));
  sg_call_rest(&call);
  CHECK("so it stays", !sg_door_segment_copies_dropped(&call, TWICE, 1));
  CHECK("twice", add_cube_again(world, CUBE, 1));
  sg_call_rest(&call);
  CHECK_DOOR("dropped", sg_door_segment_copies_dropped(&call, CUBE, 1));
  sg_call_rest(&call);
  CHECK("one is left", rows_of(SG_P) == 18 && rows_of(SG_T) == 36 &&
                           rows_of(SG_E) == 72 && rows_of(SG_V) == 24);
  sg_call_close(&call);
  sg_world_let_go(world);
}

/* ---- leaf_copy_rows.c ---- */

/* In a world of its own: cubes 1, 3, 5 and 6, and two cubes in one place. */
static void
equal_leaves(void)
{
  sg_world *world = sg_world_open();
  int32_t s[] = {1, 2, 3, 5, 6};
  const sg_int_list all = {s, 5, 5}, one = {s, 1, 1};
  sg_id_pair_list found = {0};

  sg_call_open(&call, NULL, NULL);
  call.world = world;
  CHECK("cubes", world && add_cube(world, 1) && add_cube(world, TWICE) &&
                     add_cube_again(world, TWICE, 1) && add_cube(world, 3) &&
                     add_cube(world, 5) && add_cube(world, 6));
  CHECK_DOOR("one",
             sg_door_leaf_copies(&call, &one, 1, &found) && found.n == 0);
  CHECK_DOOR("equal",
             sg_door_leaf_copies(&call, &all, 1, &found) && found.n == 3);
  CHECK("the first", found.n == 3 && found.at[0].a == 3 && found.at[0].b == 1 &&
                         found.at[2].a == 6 && found.at[2].b == 1);
  found = (sg_id_pair_list){0};
  CHECK_DOOR("but two", sg_door_leaf_copies(&call, &all, 2, &found) &&
                            found.n == 2 && found.at[0].a == 5);
  found = (sg_id_pair_list){0};
  CHECK_DOOR("but all",
             sg_door_leaf_copies(&call, &all, 4, &found) && found.n == 0);
  sg_call_close(&call);
  sg_world_let_go(world);
}

/* ---- sewing_rows.c ---- */

static void
sewing(void)
{
  sg_polygon_weight_list weights = {0};

  CHECK("alone", !sg_door_segment_sewn(&call, CUBE, &weights));
  CHECK("is no error", call.refusal.how == SG_REFUSED_NOTHING);
  CHECK_DOOR("twice", sg_door_segment_sewn(&call, TWICE, &weights));
  CHECK("all count twice", weights.n == 6 && weights.at[5].p == 6);
  for (size_t i = 0; i < weights.n; i++) {
    CHECK("all count twice", weights.at[i].weight == 2);
  }
  CHECK("rows", rows_of(SG_P) == 12 && rows_of(SG_T) == 24 &&
                    rows_of(SG_E) == 48 && rows_of(SG_V) == 24);
}

int
main(void)
{
  copies();
  equal_leaves();
  sg_call_open(&call, NULL, NULL);
  call.world = sg_world_open();
  CHECK("cubes", call.world && add_cube(call.world, CUBE) &&
                     add_cube(call.world, TWICE) &&
                     add_cube_again(call.world, TWICE, 1));
  no_primitives();
  origins_of_nodes();
  borders();
  sewing();
  sg_world *world = call.world;

  sg_call_close(&call);
  sg_world_let_go(world);
  return check_report();
}
