/* contact_origin_rows.c -- origins of a result that name what its leaves have:
 * see contact_places.h.
 *
 * Layer: rows. The door is documented in rules/kernel/boolean.pl.
 */
#include "contact_feature_rows.h"
#include "contact_places.h"
#include "doors/boolean.h"

#include "engine/search.h"
#include "engine/symbol.h"
#include "penetration/polygon_rows.h"
#include "rows/added_rows.h"
#include "rows/sort.h"

#include <stdlib.h>

/* A vertex of a leaf that was made to touch at a point. */
typedef struct touching {
  const uint32_t *origin; /* of the point */
  int32_t s, v;
  sg_contact_on on;
  int32_t id;
} touching;

/* A row of the result that is written anew. */
typedef struct source {
  int32_t v, s0, v0; /* s0 0: there is none now */
} source;

typedef struct made {
  int32_t v;
  const uint32_t *origin;
} made;

/* A result under way: what it has is in `version`, but for what is said of it
 * here. Of each vertex the last that is said counts. */
typedef struct result {
  const sg_version *version;
  int32_t s;
  const sg_leaf_contacts_list *leaves;
  SG_LIST_OF(touching) touching; /* by origin, segment and vertex */
  SG_LIST_OF(source) source;
  SG_LIST_OF(made) made;
  SG_LIST_OF(made) renamed;
  SG_LIST_OF(touching) place; /* of one point */
  sg_key_table source_of;     /* V: in `source` */
  sg_key_table made_of;       /* V: in `made` */
  sg_int_list found;          /* vertices of one point */
} result;

/* ---- points ------------------------------------------------------------- */

static int
by_point(const void *one, const void *other)
{
  const touching *x = one, *y = other;
  int by = sg_node_order(x->origin + 1, y->origin + 1);

  if (by) {
    return by;
  }
  SG_BY(s) SG_BY(v) SG_BY(on) SG_BY(id) return 0;
}

static bool
gather_points(sg_call *call, result *r)
{
  for (size_t k = 0; k < r->leaves->n; k++) {
    const sg_contact_places *places = r->leaves->at[k].contacts;

    for (size_t i = 0; i < places->place.n; i++) {
      const sg_contact_place *place = &places->place.item[i];
      const touching t = {sg_contact_origin(places, place), r->leaves->at[k].s,
                          place->v, place->on, place->id};

      if (!SG_PUSH(r->touching, t)) {
        return sg_call_no_memory(call);
      }
    }
  }
  switch (sg_sort(r->touching.item, r->touching.n, sizeof(touching), by_point,
                  &call->cancel)) {
  case SG_SORTED:
    return true;
  case SG_SORT_STOPPED:
    return false;
  case SG_SORT_NO_MEMORY:
    break;
  }
  return sg_call_no_memory(call);
}

/* ---- what is to be written ---------------------------------------------- */

/* The last of a list that tells of vertex v; null: no memory. */
static uint32_t *
last_of(sg_key_table *table, int32_t v)
{
  return sg_key_table_put(table, &(uint32_t){(uint32_t)v});
}

static bool
is_last(const sg_key_table *table, int32_t v, size_t i)
{
  return sg_key_table_get(table, &(uint32_t){(uint32_t)v}) == i;
}

/* s0 0: it came from none. */
static bool
set_source(sg_call *call, result *r, int32_t v, int32_t s0, int32_t v0)
{
  uint32_t *last = last_of(&r->source_of, v);

  if (!last || !SG_PUSH(r->source, (source){v, s0, v0})) {
    return sg_call_no_memory(call);
  }
  *last = (uint32_t)(r->source.n - 1);
  return true;
}

static bool
set_origin(sg_call *call, result *r, int32_t v, const uint32_t *origin)
{
  uint32_t *last = origin ? last_of(&r->made_of, v) : NULL;

  if (!origin) {
    return false;
  }
  if (!last || !SG_PUSH(r->made, (made){v, origin})) {
    return sg_call_no_memory(call);
  }
  *last = (uint32_t)(r->made.n - 1);
  return true;
}

/* Where a vertex of the result came from, as things stand. */
static source
source_now(const result *r, int32_t v)
{
  uint32_t last = sg_key_table_get(&r->source_of, &(uint32_t){(uint32_t)v});
  source found = {.v = v};

  if (last != SG_NO_KEY) {
    return r->source.item[last];
  }
  const sg_value key[SG_MAX_COLUMNS] = {[0].i = r->s, [1].i = v};
  sg_row row = sg_version_find(r->version, SG_FROM_V, key);

  if (row != SG_NO_ROW) {
    sg_value value[SG_MAX_COLUMNS];

    sg_version_row(r->version, SG_FROM_V, row, 1 << 2 | 1 << 3, value);
    found.s0 = value[2].i;
    found.v0 = value[3].i;
  }
  return found;
}

/* ---- vertices that leaves had ------------------------------------------- */

/* Adds the vertices that came from vertex v0 of s0. */
static bool
find_vertices(sg_call *call, result *r, int32_t s0, int32_t v0)
{
  const sg_value from[SG_MAX_COLUMNS] = {[0].i = r->s, [2].i = s0, [3].i = v0};
  sg_walk walk;
  bool good = true;

  if (!sg_walk_open(&walk, r->version, SG_FROM_V, 1 << 0 | 1 << 2 | 1 << 3,
                    from)) {
    return sg_call_no_memory(call);
  }
  for (sg_row row; good && (row = sg_walk_next(&walk)) != SG_NO_ROW;) {
    int32_t v = sg_version_value(r->version, SG_FROM_V, row, 1).i;
    source now = source_now(r, v);

    good = now.s0 != s0 || now.v0 != v0 || sg_int_list_add(call, &r->found, v);
  }
  sg_walk_close(&walk);
  return good;
}

/* The vertices at the point of touching[from .. to - 1]. */
static bool
find_point(sg_call *call, result *r, size_t from, size_t to, int32_t s1,
           int32_t v1)
{
  r->found.n = 0;
  if (s1 && !find_vertices(call, r, s1, v1)) {
    return false;
  }
  for (size_t i = from; i < to; i++) {
    const touching *t = &r->touching.item[i];

    if (!find_vertices(call, r, t->s, t->v)) {
      return false;
    }
  }
  if (r->found.n > 0) {
    r->found.n = sg_sort_ids(r->found.at, r->found.n);
  }
  return true;
}

SG_ORDER(by_place, touching, SG_BY(s) SG_BY(on) SG_BY(id));

/* r->place: the features of touching[from .. to - 1], each once. */
static bool
find_places(sg_call *call, result *r, size_t from, size_t to)
{
  r->place.n = 0;
  for (size_t i = from; i < to; i++) {
    if (!SG_PUSH(r->place, r->touching.item[i])) {
      return sg_call_no_memory(call);
    }
  }
  qsort(r->place.item, r->place.n, sizeof(touching), by_place);
  size_t n = 0;

  for (size_t i = 0; i < r->place.n; i++) {
    if (n == 0 || by_place(&r->place.item[n - 1], &r->place.item[i]) != 0) {
      r->place.item[n++] = r->place.item[i];
    }
  }
  r->place.n = n;
  return true;
}

/* near(on(S1-V1, Places)), as sg_call_term(). */
static const uint32_t *
on_term(sg_call *call, result *r, size_t from, size_t to, int32_t s1,
        int32_t v1)
{
  static const int32_t name[] = {[SG_ON_LEAF_EDGE] = SG_SYMBOL_E,
                                 [SG_ON_LEAF_FACE] = SG_SYMBOL_P,
                                 [SG_ON_LEAF_VERTEX] = SG_SYMBOL_V};
  sg_term_builder b;

  if (!find_places(call, r, from, to)) {
    return NULL;
  }
  sg_term_open(&b);
  sg_term_compound(&b, SG_SYMBOL_NEAR, 1);
  sg_term_compound(&b, SG_SYMBOL_ON, 2);
  sg_term_pair(&b, s1, v1);
  for (size_t i = 0; i < r->place.n; i++) {
    const touching *t = &r->place.item[i];

    sg_term_compound(&b, SG_SYMBOL_CONS, 2);
    sg_term_compound(&b, SG_SYMBOL_MINUS, 2);
    sg_term_int(&b, t->s);
    sg_term_unary(&b, name[t->on], t->id);
  }
  sg_term_nil(&b);
  return sg_call_term(call, &b);
}

static const uint32_t *
near_term(sg_call *call, const uint32_t *origin)
{
  sg_term_builder b;

  sg_term_open(&b);
  sg_term_compound(&b, SG_SYMBOL_NEAR, 1);
  sg_term_node(&b, origin + 1);
  return sg_call_term(call, &b);
}

/* Whether v is, of those that touch here, one that a leaf had. */
static bool
is_own(const result *r, size_t from, size_t to, int32_t v)
{
  source now = source_now(r, v);

  for (size_t i = from; i < to; i++) {
    const touching *t = &r->touching.item[i];

    if (t->on == SG_ON_LEAF_VERTEX && t->s == now.s0 && t->v == now.v0) {
      return true;
    }
  }
  return false;
}

/* S1 and V1 of v(S1, V1); false: it is another term. */
static bool
is_vertex(const uint32_t *origin, int32_t *s1, int32_t *v1)
{
  const uint32_t *s = sg_node_arguments(origin + 1);

  return sg_node_is(origin + 1, SG_SYMBOL_V, 2) && sg_node_int(s, s1) &&
         sg_node_int(sg_node_after(s), v1);
}

/* Names the vertices at the point of touching[from .. to - 1]. */
static bool
name_point(sg_call *call, result *r, size_t from, size_t to)
{
  const uint32_t *origin = r->touching.item[from].origin;
  int32_t s1 = 0, v1 = 0;
  bool vertex = is_vertex(origin, &s1, &v1);

  if (!find_point(call, r, from, to, vertex ? s1 : 0, v1)) {
    return false;
  }
  if (r->found.n == 0) {
    return true;
  }
  const uint32_t *named =
      vertex ? on_term(call, r, from, to, s1, v1) : near_term(call, origin);

  for (size_t i = 0; i < r->found.n; i++) {
    int32_t v = r->found.at[i];
    bool good = vertex ? set_source(call, r, v, s1, v1)
                       : is_own(r, from, to, v) || set_source(call, r, v, 0, 0);

    if (!good || !set_origin(call, r, v, named)) {
      return false;
    }
  }
  return true;
}

static bool
name_points(sg_call *call, result *r)
{
  for (size_t from = 0, to; from < r->touching.n; from = to) {
    const uint32_t *origin = r->touching.item[from].origin;

    for (to = from + 1; to < r->touching.n &&
                        sg_term_equal(origin, r->touching.item[to].origin);
         to++) {
    }
    if (sg_cancel_every(&call->cancel, from) ||
        !name_point(call, r, from, to)) {
      return false;
    }
  }
  return true;
}

/* ---- vertices that cuts made -------------------------------------------- */

static bool
rename_row(sg_call *call, result *r, sg_row row)
{
  sg_value value[SG_MAX_COLUMNS];

  sg_version_row(r->version, SG_ORIGIN, row, 1 << 1 | 1 << 2, value);
  int32_t v = sg_term_vertex(value[1].term);
  const uint32_t *origin = NULL;

  if (v == 0) {
    return true;
  }
  if (!sg_contact_renamed(call, r->version, r->leaves, value[2].term,
                          &origin)) {
    return false;
  }
  return !origin || SG_PUSH(r->renamed, (made){v, origin}) ||
         sg_call_no_memory(call);
}

static bool
rename_cuts(sg_call *call, result *r)
{
  const sg_value of[SG_MAX_COLUMNS] = {[0].i = r->s};
  sg_walk walk;
  size_t n = 0;

  if (!sg_walk_open(&walk, r->version, SG_ORIGIN, 1 << 0, of)) {
    return sg_call_no_memory(call);
  }
  bool good = true;

  for (sg_row row; good && (row = sg_walk_next(&walk)) != SG_NO_ROW; n++) {
    good = !sg_cancel_every(&call->cancel, n) && rename_row(call, r, row);
  }
  sg_walk_close(&walk);
  return good;
}

/* ---- writing ------------------------------------------------------------ */

/* Rows that go, and those that come. */
typedef struct change {
  SG_LIST_OF(sg_row) gone;
  sg_added_rows added;
} change;

static bool
note_gone(sg_call *call, change *c, sg_row row)
{
  return row == SG_NO_ROW || SG_PUSH(c->gone, row) || sg_call_no_memory(call);
}

static bool
change_sources(sg_call *call, const result *r, change *c)
{
  for (size_t i = 0; i < r->source.n; i++) {
    const source *at = &r->source.item[i];
    const sg_value row[SG_MAX_COLUMNS] = {
        [0].i = r->s, [1].i = at->v, [2].i = at->s0, [3].i = at->v0};

    if (is_last(&r->source_of, at->v, i) &&
        (!note_gone(call, c, sg_version_find(r->version, SG_FROM_V, row)) ||
         (at->s0 && !sg_added_rows_put(call, &c->added, row)))) {
      return false;
    }
  }
  return true;
}

static bool
change_origins(sg_call *call, const result *r, change *c)
{
  for (size_t i = 0; i < r->made.n; i++) {
    const made *at = &r->made.item[i];

    if (!is_last(&r->made_of, at->v, i)) {
      continue;
    }
    const sg_value row[SG_MAX_COLUMNS] = {
        [0].i = r->s,
        [1].term = sg_unary_term(call, SG_SYMBOL_V, at->v),
        [2].term = at->origin};

    if (!row[1].term ||
        !note_gone(call, c, sg_version_find(r->version, SG_ORIGIN, row)) ||
        !sg_added_rows_put(call, &c->added, row)) {
      return false;
    }
  }
  return true;
}

static bool
make_change(sg_call *call, sg_world *world, change *c)
{
  for (size_t i = 0; i < c->gone.n; i++) {
    if (!sg_world_retract(world, c->added.relation, c->gone.item[i])) {
      return sg_call_no_memory(call);
    }
  }
  return sg_added_rows_write(call, world, &c->added);
}

/* ---- the door ----------------------------------------------------------- */

/* What is to be written, from the world as it is. */
static bool
find_changes(sg_call *call, result *r, change *sources, change *origins)
{
  bool good =
      rename_cuts(call, r) && gather_points(call, r) && name_points(call, r);

  for (size_t i = 0; i < r->renamed.n && good; i++) {
    good = set_origin(call, r, r->renamed.item[i].v, r->renamed.item[i].origin);
  }
  return good && change_sources(call, r, sources) &&
         change_origins(call, r, origins);
}

static void
clear(result *r)
{
  free(r->touching.item);
  free(r->source.item);
  free(r->made.item);
  free(r->renamed.item);
  free(r->place.item);
  sg_key_table_clear(&r->source_of);
  sg_key_table_clear(&r->made_of);
}

bool
sg_door_contact_origins(sg_call *call, int32_t s,
                        const sg_leaf_contacts_list *contacts)
{
  sg_world *world = contacts->n > 0 ? sg_call_claim(call) : NULL;
  result r = {.s = s, .leaves = contacts};
  change sources = {.added.relation = SG_FROM_V};
  change origins = {.added.relation = SG_ORIGIN};

  if (!world) {
    return contacts->n == 0;
  }
  sg_key_table_init(&r.source_of, 1);
  sg_key_table_init(&r.made_of, 1);
  r.version = sg_world_version(world);
  bool good = find_changes(call, &r, &sources, &origins);

  sg_version_drop(r.version); /* not held while rows are written */
  good = good && make_change(call, world, &sources) &&
         make_change(call, world, &origins);
  free(sources.gone.item);
  free(origins.gone.item);
  clear(&r);
  sg_world_release(world);
  return good;
}
