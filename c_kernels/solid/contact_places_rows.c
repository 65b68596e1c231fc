/* contact_places_rows.c -- where a leaf was made to touch.
 *
 * Layer: rows. The doors are documented in rules/kernel/boolean.pl.
 */
#include "contact_places.h"
#include "doors/boolean.h"
#include "vertex_polygons_rows.h"

#include <stdlib.h>
#include <string.h>

void
sg_contact_places_free(sg_contact_places *places)
{
  free(places->place.item);
  free(places->polygon.item);
  free(places->word.item);
  sg_key_table_clear(&places->number);
  free(places);
}

const sg_contact_place *
sg_contact_places_find(const sg_contact_places *places, int32_t v)
{
  uint32_t number = sg_key_table_get(&places->number, &(uint32_t){(uint32_t)v});

  return number == SG_NO_KEY ? NULL : &places->place.item[number];
}

/* A leaf that is looked at. */
typedef struct leaf {
  const sg_version *version;
  int32_t s;
  sg_key_table whole; /* E: the edge that it is a part of */
  sg_int_list polygons;
  sg_contact_places *out;
} leaf;

/* ---- what its origins say ----------------------------------------------- */

/* N of name(N); 0: it is another term. */
static int32_t
number_in(const uint32_t *term, int32_t name)
{
  int32_t n = 0;

  return sg_node_is(term + 1, name, 1) &&
                 sg_node_int(sg_node_arguments(term + 1), &n)
             ? n
             : 0;
}

static bool
note_part(leaf *l, int32_t e, int32_t of)
{
  uint32_t *whole = sg_key_table_put(&l->whole, &(uint32_t){(uint32_t)e});

  if (whole) {
    *whole = (uint32_t)of;
  }
  return whole != NULL;
}

/* Notes that the origin of v is near(of). */
static bool
note_place(leaf *l, int32_t v, const uint32_t *of)
{
  sg_contact_places *out = l->out;
  size_t n = (size_t)(sg_node_after(of) - of);
  sg_contact_place place = {.v = v, .origin = out->word.n};
  bool good = SG_PUSH(out->word, (uint32_t)(n * sizeof *of));

  for (size_t i = 0; i < n && good; i++) {
    good = SG_PUSH(out->word, of[i]);
  }
  return good && SG_PUSH(out->place, place);
}

static bool
see_origin(leaf *l, sg_row row)
{
  sg_value value[SG_MAX_COLUMNS];

  sg_version_row(l->version, SG_ORIGIN, row, 1 << 1 | 1 << 2, value);
  const uint32_t *item = value[1].term, *origin = value[2].term;
  int32_t v = number_in(item, SG_SYMBOL_V), e = number_in(item, SG_SYMBOL_E);
  int32_t of = e ? number_in(origin, SG_SYMBOL_E) : 0;

  if (v && sg_node_is(origin + 1, SG_SYMBOL_NEAR, 1)) {
    return note_place(l, v, sg_node_arguments(origin + 1));
  }
  return !of || note_part(l, e, of);
}

static bool
see_origins(sg_call *call, leaf *l)
{
  const sg_value of[SG_MAX_COLUMNS] = {[0].i = l->s};
  sg_walk walk;
  size_t n = 0;
  bool good = sg_walk_open(&walk, l->version, SG_ORIGIN, 1 << 0, of);

  if (!good) {
    return sg_call_no_memory(call);
  }
  for (sg_row r; good && (r = sg_walk_next(&walk)) != SG_NO_ROW; n++) {
    good = !sg_cancel_every(&call->cancel, n) &&
           (see_origin(l, r) || sg_call_no_memory(call));
  }
  sg_walk_close(&walk);
  return good;
}

/* ---- features ----------------------------------------------------------- */

static bool
is_there(const leaf *l, sg_relation relation, int32_t id)
{
  return sg_version_find(l->version, relation,
                         (sg_value[SG_MAX_COLUMNS]){{.i = l->s}, {.i = id}}) !=
         SG_NO_ROW;
}

/* The edge that the leaf had before, of which `part` is a part; 0: it is none.
 * What a user wrote of origins may go round. */
static int32_t
whole_edge(const leaf *l, int32_t part)
{
  int32_t found = 0;
  uint32_t e = (uint32_t)part;

  for (size_t i = 0; i < l->whole.n; i++) {
    e = sg_key_table_get(&l->whole, &(uint32_t){e});
    if (e == SG_NO_KEY) {
      break;
    }
    if (is_there(l, SG_LEAF_E, (int32_t)e)) {
      found = (int32_t)e;
    }
  }
  return found;
}

/* The least edge that one at vertex v, which its `column` has, is a part of.
 * *least stays if it is less. */
static bool
least_edge(sg_call *call, const leaf *l, int32_t v, unsigned column,
           int32_t *least)
{
  sg_value at[SG_MAX_COLUMNS] = {[0].i = l->s};
  sg_walk walk;

  const uint16_t mask = (uint16_t)(1U << 0 | 1U << column);

  at[column].i = v;
  if (!sg_index_ready(l->version, SG_E, mask, &call->cancel)) {
    return false;
  }
  if (!sg_walk_open(&walk, l->version, SG_E, mask, at)) {
    return sg_call_no_memory(call);
  }
  for (sg_row r; (r = sg_walk_next(&walk)) != SG_NO_ROW;) {
    int32_t e = whole_edge(l, sg_version_value(l->version, SG_E, r, 1).i);

    if (e && (!*least || e < *least)) {
      *least = e;
    }
  }
  sg_walk_close(&walk);
  return true;
}

/* Sets what a vertex is on. *none: it is in no polygon. */
static bool
find_feature(sg_call *call, leaf *l, sg_contact_place *place, bool *none)
{
  sg_contact_places *out = l->out;
  int32_t edge = 0;

  *none = false;
  if (is_there(l, SG_LEAF_V, place->v)) {
    place->on = SG_ON_LEAF_VERTEX;
    place->id = place->v;
    return true;
  }
  l->polygons.n = 0;
  if (!sg_polygons_at(call, l->version, l->s, place->v, &l->polygons) ||
      !least_edge(call, l, place->v, 2, &edge) ||
      !least_edge(call, l, place->v, 3, &edge)) {
    return false;
  }
  *none = l->polygons.n == 0;
  place->on = edge ? SG_ON_LEAF_EDGE : SG_ON_LEAF_FACE;
  place->id = edge || *none ? edge : l->polygons.at[0];
  place->polygon = out->polygon.n;
  place->polygons = l->polygons.n;
  for (size_t i = 0; i < l->polygons.n; i++) {
    if (!SG_PUSH(out->polygon, l->polygons.at[i])) {
      return sg_call_no_memory(call);
    }
  }
  return true;
}

/* Of all vertices that origins tell of. */
static bool
find_features(sg_call *call, leaf *l)
{
  sg_contact_places *out = l->out;
  size_t n = 0;

  for (size_t i = 0; i < out->place.n; i++) {
    sg_contact_place place = out->place.item[i];
    bool none;

    if (sg_cancelled(&call->cancel) || /* it may look at many rows */
        !find_feature(call, l, &place, &none)) {
      return false;
    }
    if (none) {
      continue;
    }
    const uint32_t key = (uint32_t)place.v;
    uint32_t *number = sg_key_table_put(&out->number, &key);

    if (!number) {
      return sg_call_no_memory(call);
    }
    *number = (uint32_t)n;
    out->place.item[n++] = place;
  }
  out->place.n = n;
  return true;
}

/* ---- the doors ---------------------------------------------------------- */

static void
trim(sg_contact_places *places) /* kept long */
{
  sg_list_trim(&places->place.item, places->place.n, &places->place.room,
               sizeof *places->place.item);
  sg_list_trim(&places->polygon.item, places->polygon.n, &places->polygon.room,
               sizeof *places->polygon.item);
  sg_list_trim(&places->word.item, places->word.n, &places->word.room,
               sizeof *places->word.item);
}

bool
sg_door_contact_places(sg_call *call, int32_t s, sg_contact_places **places)
{
  leaf l = {.version = sg_call_version(call), .s = s};

  if (!l.version) {
    return false;
  }
  l.out = calloc(1, sizeof *l.out);
  if (!l.out) {
    return sg_call_no_memory(call);
  }
  sg_key_table_init(&l.whole, 1);
  sg_key_table_init(&l.out->number, 1);
  bool good =
      see_origins(call, &l) && find_features(call, &l) && l.out->place.n > 0;

  sg_key_table_clear(&l.whole);
  if (good) {
    trim(l.out);
    *places = l.out;
  } else {
    sg_contact_places_free(l.out);
  }
  return good;
}

/* What place_of/3 of the rule has. */
static bool
give_place(sg_call *call, const sg_contact_places *places,
           const sg_contact_place *place, sg_contact_fact_list *out)
{
  sg_contact_fact fact = {.v = place->v};

  fact.place.origin = sg_contact_origin(places, place);
  switch (place->on) {
  case SG_ON_LEAF_EDGE:
    fact.place.feature.is = SG_CONTACT_FEATURE_E;
    fact.place.feature.e.e = place->id;
    break;
  case SG_ON_LEAF_FACE:
    fact.place.feature.is = SG_CONTACT_FEATURE_P;
    fact.place.feature.p.p = place->id;
    break;
  case SG_ON_LEAF_VERTEX:
    fact.place.feature.is = SG_CONTACT_FEATURE_V;
    fact.place.feature.v.v = place->id;
    break;
  }
  for (size_t k = 0; k < place->polygons; k++) {
    if (!sg_int_list_add(call, &fact.place.polygons,
                         places->polygon.item[place->polygon + k])) {
      return false;
    }
  }
  return sg_contact_fact_list_add(call, out, fact);
}

bool
sg_door_contact_facts(sg_call *call, sg_contact_places *places,
                      sg_contact_fact_list *facts)
{
  for (size_t i = 0; i < places->place.n; i++) {
    if (!give_place(call, places, &places->place.item[i], facts)) {
      return false;
    }
  }
  return true;
}
