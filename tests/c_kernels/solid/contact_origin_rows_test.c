/* contact_origin_rows_test.c -- a cube two vertices of which were made to
 * touch, and a result that has one of them, through the functions of the doors,
 * without Prolog: contact_places_rows.c, contact_origin_rows.c,
 * contact_feature_rows.c.
 *
 * covers: vertex_polygons_rows
 */
#include "doors/boolean.h"
#include "engine/term.h"
#include "solid/contact_places.h"

#include "tests/c_kernels/cube_world.h"
#include "tests/c_kernels/door_call.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

enum { LEAF = 1, RESULT = 3, MOVED = 1, MADE = 8, ALIKE = 21, CUT = 22 };

/* origin(s, Item, Origin); the builders are closed. */
static bool
add_origin(int32_t s, sg_term_builder *item, sg_term_builder *origin)
{
  sg_status status = sg_world_add(call.world, SG_ORIGIN,
                                  (sg_value[]){{.i = s},
                                               {.term = sg_term_words(item)},
                                               {.term = sg_term_words(origin)}},
                                  NULL, NULL);

  sg_term_close(item);
  sg_term_close(origin);
  return status == SG_OK;
}

/* origin(s, v(v), near(ll(a, b))), or without near. */
static bool
add_meeting(int32_t s, int32_t v, bool near, int32_t a, int32_t b)
{
  sg_term_builder item, origin;

  sg_term_open(&item);
  sg_term_open(&origin);
  sg_term_unary(&item, SG_SYMBOL_V, v);
  if (near) {
    sg_term_compound(&origin, SG_SYMBOL_NEAR, 1);
  }
  sg_term_compound(&origin, SG_SYMBOL_LL, 2);
  sg_term_int(&origin, a);
  sg_term_int(&origin, b);
  return add_origin(s, &item, &origin);
}

/* origin(s, e(part), e(whole)). */
static bool
add_part(int32_t s, int32_t part, int32_t whole)
{
  sg_term_builder item, origin;

  sg_term_open(&item);
  sg_term_open(&origin);
  sg_term_unary(&item, SG_SYMBOL_E, part);
  sg_term_unary(&origin, SG_SYMBOL_E, whole);
  return add_origin(s, &item, &origin);
}

static bool
add_row(sg_relation relation, const sg_value *value)
{
  return sg_world_add(call.world, relation, value, NULL, NULL) == SG_OK;
}

/* v(RESULT, v, 0, 0, 0). */
static bool
add_vertex(int32_t v)
{
  return add_row(
      SG_V,
      (sg_value[]){{.i = RESULT}, {.i = v}, {.f = 0}, {.f = 0}, {.f = 0}});
}

/* Whether origin(RESULT, v(v), near(ll(a, b))) is there, and only that. */
static bool
is_named(int32_t v, int32_t a, int32_t b)
{
  const sg_version *version = sg_world_version(call.world);
  sg_term_builder item, wanted;
  sg_value key[SG_MAX_COLUMNS] = {{.i = RESULT}}, found[SG_MAX_COLUMNS];

  sg_term_open(&item);
  sg_term_open(&wanted);
  sg_term_unary(&item, SG_SYMBOL_V, v);
  sg_term_compound(&wanted, SG_SYMBOL_NEAR, 1);
  sg_term_compound(&wanted, SG_SYMBOL_LL, 2);
  sg_term_int(&wanted, a);
  sg_term_int(&wanted, b);
  key[1].term = sg_term_words(&item);
  sg_row row = sg_version_find(version, SG_ORIGIN, key);
  bool is = row != SG_NO_ROW;

  if (is) {
    sg_version_row(version, SG_ORIGIN, row, 1 << 2, found);
    is = sg_term_equal(found[2].term, sg_term_words(&wanted));
  }
  sg_term_close(&item);
  sg_term_close(&wanted);
  sg_version_drop(version);
  return is;
}

/* A call sees the world as it was when it first looked. */
static void
call_again(void)
{
  sg_world *world = call.world;

  sg_call_close(&call);
  sg_call_open(&call, NULL, NULL);
  call.world = world;
}

static void
places(sg_contact_places **contacts)
{
  sg_contact_fact_list facts = {0};

  CHECK("nothing touches", !sg_door_contact_places(&call, LEAF, contacts));
  CHECK("which is no error", call.refusal.how == SG_REFUSED_NOTHING);
  CHECK("a vertex was moved, another was made",
        add_meeting(LEAF, MOVED, true, 5, 6) &&
            add_meeting(LEAF, MADE, true, 7, 8));
  CHECK("the leaf had the first",
        add_row(SG_LEAF_V,
                (sg_value[]){
                    {.i = LEAF}, {.i = MOVED}, {.f = 0}, {.f = 0}, {.f = 0}}));
  CHECK("origins that go round end",
        add_part(LEAF, 7, 8) && add_part(LEAF, 8, 7));
  call_again();
  CHECK_DOOR("both touch", sg_door_contact_places(&call, LEAF, contacts));
  CHECK_DOOR("facts",
             sg_door_contact_facts(&call, *contacts, &facts) && facts.n == 2);
  CHECK("a vertex of the leaf",
        facts.at[0].v == MOVED &&
            facts.at[0].place.feature.is == SG_CONTACT_FEATURE_V &&
            facts.at[0].place.polygons.n == 0);
  CHECK("the first of the three faces at the corner",
        facts.at[1].v == MADE &&
            facts.at[1].place.feature.is == SG_CONTACT_FEATURE_P &&
            facts.at[1].place.feature.p.p == 2 &&
            facts.at[1].place.polygons.n == 3);
}

/* What came from either vertex is named by where edges meet; what a cut made
 * stays. */
static void
origins(sg_contact_places *contacts)
{
  sg_leaf_contacts of = {LEAF, contacts};

  CHECK("vertices of a result",
        add_segment(RESULT) && add_vertex(ALIKE) && add_vertex(CUT));
  CHECK("where they came from",
        add_row(SG_FROM_V,
                (sg_value[]){
                    {.i = RESULT}, {.i = ALIKE}, {.i = LEAF}, {.i = MADE}}) &&
            add_meeting(RESULT, CUT, true, 1, 2));
  CHECK("and an edge", add_part(RESULT, 3, 4));
  CHECK_DOOR(
      "no leaf, no change",
      sg_door_contact_origins(&call, RESULT, &(sg_leaf_contacts_list){0}) &&
          rows_of(SG_FROM_V) == 1);
  CHECK_DOOR("names", sg_door_contact_origins(
                          &call, RESULT, &(sg_leaf_contacts_list){&of, 1, 1}));
  CHECK("where edges meet", is_named(ALIKE, 7, 8));
  CHECK("from no vertex that the leaf has", rows_of(SG_FROM_V) == 0);
  CHECK("another stays", is_named(CUT, 1, 2));
}

int
main(void)
{
  sg_contact_places *contacts = NULL;

  sg_call_open(&call, NULL, NULL);
  call.world = sg_world_open();
  CHECK("a cube",
        call.world && add_segment(LEAF) && add_cube(call.world, LEAF));
  places(&contacts);
  if (contacts) {
    origins(contacts);
    sg_contact_places_free(contacts);
  }
  sg_world *world = call.world;

  sg_call_close(&call);
  sg_world_let_go(world);
  return check_report();
}
