/* contact_feature_rows.c -- see contact_feature_rows.h. */
#include "contact_feature_rows.h"

#include "contact_places.h"
#include "doors/boolean.h"
#include "vertex_polygons_rows.h"

#include "engine/symbol.h"

#include <string.h>

/* A name of an origin: S-V, S-(A,B) or S-(A,B,C). */
enum { MOST_NAMED = 8 };

typedef struct name {
  const sg_contact_places *places; /* of leaf s */
  int32_t s;
  int32_t v[MOST_NAMED];
  int n;
} name;

/* What is looked at. */
typedef struct naming {
  const sg_version *version;
  const sg_leaf_contacts_list *leaves;
} naming;

/* ---- reading names ------------------------------------------------------ */

static const sg_contact_places *
places_of(const naming *in, int32_t s)
{
  for (size_t i = 0; i < in->leaves->n; i++) {
    if (in->leaves->at[i].s == s) {
      return in->leaves->at[i].contacts;
    }
  }
  return NULL;
}

/* False: the argument is no name of vertices of a leaf that touches. */
static bool
read_name(const naming *in, const uint32_t *node, name *out)
{
  const uint32_t *s = sg_node_arguments(node);

  out->n = 0;
  if (!sg_node_is(node, SG_SYMBOL_MINUS, 2) || !sg_node_int(s, &out->s) ||
      !(out->places = places_of(in, out->s))) {
    return false;
  }
  node = sg_node_after(s);
  while (out->n < MOST_NAMED && sg_node_is(node, SG_SYMBOL_COMMA, 2)) {
    node = sg_node_arguments(node);
    if (!sg_node_int(node, &out->v[out->n++])) {
      return false;
    }
    node = sg_node_after(node);
  }
  return out->n < MOST_NAMED && sg_node_int(node, &out->v[out->n++]);
}

/* A vertex of a name that was made to touch, and not one that was only moved,
 * if that is told; null: there is none. */
static const sg_contact_place *
touched_of(const name *of, bool or_moved)
{
  for (int k = 0; k < of->n; k++) {
    const sg_contact_place *place =
        sg_contact_places_find(of->places, of->v[k]);

    if (place && (or_moved || place->on != SG_ON_LEAF_VERTEX)) {
      return place;
    }
  }
  return NULL;
}

/* ---- features ----------------------------------------------------------- */

static bool
is_on(const name *of, int32_t v, int32_t e, const int32_t end[2])
{
  const sg_contact_place *place = sg_contact_places_find(of->places, v);

  return v == end[0] || v == end[1] ||
         (place && place->on == SG_ON_LEAF_EDGE && place->id == e);
}

/* The ends of the edge of the leaf that the edge S-(A,B) is a part of. */
static bool
find_edge(const naming *in, const name *of, int32_t end[2])
{
  for (int k = 0; k < of->n && of->n == 2; k++) {
    const sg_contact_place *place =
        sg_contact_places_find(of->places, of->v[k]);
    sg_value value[SG_MAX_COLUMNS] = {[0].i = of->s};

    if (!place || place->on != SG_ON_LEAF_EDGE) {
      continue;
    }
    value[1].i = place->id;
    sg_row row = sg_version_find(in->version, SG_E, value);

    if (row == SG_NO_ROW) {
      continue;
    }
    sg_version_row(in->version, SG_E, row, 1 << 2 | 1 << 3, value);
    end[0] = value[2].i;
    end[1] = value[3].i;
    if (is_on(of, of->v[0], place->id, end) &&
        is_on(of, of->v[1], place->id, end)) {
      return true;
    }
  }
  return false;
}

/* Those polygons of a vertex that are in `common` stay there. */
static bool
keep_common(sg_call *call, const naming *in, const name *of, int32_t v,
            sg_int_list *common)
{
  const sg_contact_place *place = sg_contact_places_find(of->places, v);
  sg_int_list at = {0};

  if (place && place->polygons > 0) {
    at.at = of->places->polygon.item + place->polygon;
    at.n = place->polygons;
  } else if (!sg_polygons_at(call, in->version, of->s, v, &at)) {
    return false;
  }
  size_t n = 0;

  for (size_t i = 0, k = 0; i < common->n; i++) {
    while (k < at.n && at.at[k] < common->at[i]) {
      k++;
    }
    if (k < at.n && at.at[k] == common->at[i]) {
      common->at[n++] = common->at[i];
    }
  }
  common->n = n;
  return true;
}

/* The first polygon that has all vertices of a name; *p 0: none has. */
static bool
find_face(sg_call *call, const naming *in, const name *of, int32_t *p)
{
  const sg_contact_place *place = sg_contact_places_find(of->places, of->v[0]);
  sg_int_list common = {0};
  bool good = true;

  if (place && place->polygons > 0) {
    for (size_t i = 0; i < place->polygons && good; i++) {
      good = sg_int_list_add(call, &common,
                             of->places->polygon.item[place->polygon + i]);
    }
  } else {
    good = sg_polygons_at(call, in->version, of->s, of->v[0], &common);
  }
  for (int k = 1; k < of->n && good; k++) {
    good = keep_common(call, in, of, of->v[k], &common);
  }
  *p = good && common.n > 0 ? common.at[0] : 0;
  return good;
}

/* ---- terms -------------------------------------------------------------- */

/* Writes S-(V1,V2), S-p(P), or S-e(E): what stands for a name. */
static bool
write_name(sg_call *call, const naming *in, const name *of,
           const sg_contact_place *touched, sg_term_builder *b)
{
  int32_t end[2], p = 0;

  sg_term_compound(b, SG_SYMBOL_MINUS, 2);
  sg_term_int(b, of->s);
  if (find_edge(in, of, end)) {
    sg_term_compound(b, SG_SYMBOL_COMMA, 2);
    sg_term_int(b, end[0]);
    sg_term_int(b, end[1]);
    return true;
  }
  if (!find_face(call, in, of, &p)) {
    return false;
  }
  if (p) {
    sg_term_unary(b, SG_SYMBOL_P, p);
  } else {
    sg_term_unary(b, touched->on == SG_ON_LEAF_EDGE ? SG_SYMBOL_E : SG_SYMBOL_P,
                  touched->id);
  }
  return true;
}

/* Writes near(Name(Places)) with what stands for them. *any: one was made to
 * touch. */
static bool
write_names(sg_call *call, const naming *in, const uint32_t *made,
            sg_term_builder *b, bool *any)
{
  size_t arity = made[0] >> 4;
  const uint32_t *node = sg_node_arguments(made);

  sg_term_compound(b, SG_SYMBOL_NEAR, 1);
  sg_term_compound(b, (int32_t)made[1], arity);
  for (size_t k = 0; k < arity; k++, node = sg_node_after(node)) {
    name of;
    bool known = read_name(in, node, &of);
    const sg_contact_place *touched = known ? touched_of(&of, false) : NULL;

    *any = *any || touched || (known && touched_of(&of, true));
    if (!touched) {
      sg_term_node(b, node);
    } else if (!write_name(call, in, &of, touched, b)) {
      return false;
    }
  }
  return true;
}

/* Writes near(Origin) of a vertex v of leaf s that was made to touch. *any: it
 * was. */
static void
write_vertex(const naming *in, const uint32_t *made, int32_t s, int32_t v,
             sg_term_builder *b, bool *any)
{
  const sg_contact_places *places = places_of(in, s);
  const sg_contact_place *place =
      places ? sg_contact_places_find(places, v) : NULL;

  *any = place != NULL;
  if (!place) {
    return;
  }
  sg_term_compound(b, SG_SYMBOL_NEAR, 1);
  sg_term_node(b, place->on == SG_ON_LEAF_VERTEX
                      ? made
                      : sg_contact_origin(places, place) + 1);
}

bool
sg_contact_renamed(sg_call *call, const sg_version *version,
                   const sg_leaf_contacts_list *leaves, const uint32_t *origin,
                   const uint32_t **renamed)
{
  const naming in = {version, leaves};
  const uint32_t *made = origin + 1;
  bool any = false, good = true;
  int32_t s, v;
  sg_term_builder b;

  *renamed = NULL;
  if (sg_node_tag(made) != SG_TERM_COMPOUND) {
    return true;
  }
  sg_term_open(&b);
  const uint32_t *first = sg_node_arguments(made);

  if (sg_node_is(made, SG_SYMBOL_V, 2) && sg_node_int(first, &s) &&
      sg_node_int(sg_node_after(first), &v)) {
    write_vertex(&in, made, s, v, &b, &any);
  } else {
    good = write_names(call, &in, made, &b, &any);
  }
  if (good && any) {
    *renamed = sg_call_term(call, &b);
    return *renamed != NULL;
  }
  sg_term_close(&b);
  return good;
}
