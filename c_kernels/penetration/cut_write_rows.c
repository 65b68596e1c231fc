/* cut_write_rows.c -- a polygon that was cut, back into the world.
 *
 * Layer: rows. The fused kernel of cut_rows.pl, write_polygon_by_rule/2: the
 * same rows in the same order with the same numbers; a test holds the two
 * together. The door is documented in rules/kernel/penetration.pl.
 */
#include "cut_rows.h"

#include "doors/penetration.h"
#include "polygon/triangulate.h"

#include <stdlib.h>
#include <string.h>

/* One edge of the work, by ids. */
typedef struct cut_edge {
  int32_t v1, v2, et, label;
  uint32_t line; /* of a cut's edge, or a fold's */
} cut_edge;

/* A fold is an edge of the polygon where a line runs along it. */
static bool
is_fold(const cut_edge *edge)
{
  return edge->et == 0 && edge->label == 0;
}

/* All that is read before anything is written. */
typedef struct cut_polygon {
  sg_cut_handle *handle;
  sg_world *world;
  sg_work *work;
  int32_t s, p;
  cut_edge *edge; /* [edges] */
  size_t edges;
  sg_key_table same; /* (label, v1, v2) of the edges */
  sg_row *triangle;  /* [triangles]: those that were */
  size_t triangles, triangle_room;
  sg_triangles found;
  bool stuck;
} cut_polygon;

static void
polygon_clear(cut_polygon *c)
{
  free(c->edge);
  free(c->triangle);
  free(c->found.item);
  sg_key_table_clear(&c->same);
}

/* ---- reading ---- */

static bool
copy_edges(cut_polygon *c)
{
  sg_key_table_init(&c->same, 3);
  c->edge = malloc((sg_work_edges(c->work) + 1) * sizeof *c->edge);
  for (int32_t e = 0; c->edge && (e = sg_work_next(c->work, e));) {
    const sg_work_edge *from = sg_work_get(c->work, e);
    cut_edge *to = &c->edge[c->edges++];

    *to = (cut_edge){sg_work_id(c->work, from->start),
                     sg_work_id(c->work, from->end), from->et,
                     (int32_t)from->label, SG_NO_KEY};
    uint32_t key[3] = {(uint32_t)to->label, (uint32_t)to->v1, (uint32_t)to->v2};
    uint32_t *known = sg_key_table_put(&c->same, key);

    if (!known) {
      return false;
    }
    *known = 1;
    if (to->label <= 0) {
      to->line = sg_cut_line_of(c->handle, c->s, to->v1, to->v2);
    }
  }
  return c->edge != NULL;
}

static bool
all_lines_known(const cut_polygon *c)
{
  for (size_t i = 0; i < c->edges; i++) {
    if (c->edge[i].label <= 0 && c->edge[i].line == SG_NO_KEY &&
        !is_fold(&c->edge[i])) {
      return false;
    }
  }
  return true;
}

static bool
find_triangles(cut_polygon *c, const sg_version *version)
{
  sg_value key[SG_MAX_COLUMNS] = {[0].i = c->s, [1].i = c->p};
  sg_walk walk;
  bool good = sg_walk_open(&walk, version, SG_T, 0x03, key);

  if (!good) {
    return false;
  }
  for (sg_row row; good && (row = sg_walk_next(&walk)) != SG_NO_ROW;) {
    if (c->triangles == c->triangle_room) {
      size_t room = 2 * c->triangle_room + 4;
      sg_row *grown = realloc(c->triangle, room * sizeof *grown);
      good = grown != NULL;
      c->triangle = good ? grown : c->triangle;
      c->triangle_room = good ? room : c->triangle_room;
    }
    if (good) {
      c->triangle[c->triangles++] = row;
    }
  }
  sg_walk_close(&walk);
  return good;
}

/* The work's edges as they were before it was triangulated in vain. */
static bool
restore_edges(cut_polygon *c)
{
  for (int32_t e; (e = sg_work_next(c->work, 0));) {
    sg_work_delete(c->work, e);
  }
  for (size_t i = 0; i < c->edges; i++) {
    const cut_edge *edge = &c->edge[i];

    if (!sg_work_add(c->work, sg_work_find(c->work, edge->v1),
                     sg_work_find(c->work, edge->v2), edge->et, edge->label)) {
      return false;
    }
  }
  return true;
}

/* A polygon that had triangles gets new ones. */
static bool
triangulate(sg_call *call, cut_polygon *c)
{
  int32_t edge;

  if (c->triangles == 0) {
    return true;
  }
  switch (sg_work_triangulate(c->work, &c->found, &edge, &call->poll)) {
  case SG_DONE:
    return true;
  case SG_STUCK:
    c->stuck = true;
    return restore_edges(c) || sg_call_no_memory(call);
  case SG_STOPPED:
    return false;
  case SG_NO_SPACE:
    break;
  }
  return sg_call_no_memory(call);
}

/* ---- writing ---- */

/* A version must not be held while rows are written: they would be copied.
 * So each of the following asks for one and drops it. */

static sg_row
find_row(const cut_polygon *c, sg_relation relation, int32_t id)
{
  sg_value key[SG_MAX_COLUMNS] = {[0].i = c->s, [1].i = id};
  const sg_version *version = sg_world_version(c->world);
  sg_row row = sg_version_find(version, relation, key);

  sg_version_drop(version);
  return row;
}

/* Whether row of e/5 runs from v1 to v2. */
static bool
runs(const cut_polygon *c, sg_row row, int32_t *v1, int32_t *v2)
{
  const sg_version *version = sg_world_version(c->world);

  *v1 = sg_version_value(version, SG_E, row, 2).i;
  *v2 = sg_version_value(version, SG_E, row, 3).i;
  sg_version_drop(version);
  return true;
}

/* Whether a polygon has edge `e`. */
static bool
is_used(const cut_polygon *c, int32_t e)
{
  if (!sg_cut_shares_edges(c->handle, c->s)) {
    return false;
  }
  const sg_version *version = sg_world_version(c->world);
  bool used = sg_version_has_member(version, SG_P, c->s, e);

  sg_version_drop(version);
  return used;
}

/* Retracts p/3, and the edges of it that are there no more as they were, and
 * that no other polygon has. */
static bool
drop_old(sg_call *call, cut_polygon *c)
{
  sg_row row = find_row(c, SG_P, c->p);

  if (row == SG_NO_ROW) {
    return false;
  }
  const sg_version *version = sg_world_version(c->world);
  const int32_t *list = sg_version_value(version, SG_P, row, 2).list;
  int32_t *es = malloc(((size_t)list[0] + 1) * sizeof *es);

  if (es) {
    memcpy(es, list, ((size_t)list[0] + 1) * sizeof *es);
  }
  sg_version_drop(version);
  if (!es) {
    return sg_call_no_memory(call);
  }
  bool good = sg_world_retract(c->world, SG_P, row);

  for (int32_t i = 1; i <= es[0] && good; i++) {
    int32_t v1 = 0, v2 = 0;
    sg_row edge = find_row(c, SG_E, es[i]);

    if (edge != SG_NO_ROW && runs(c, edge, &v1, &v2)) {
      uint32_t key[3] = {(uint32_t)es[i], (uint32_t)v1, (uint32_t)v2};

      if (sg_key_table_get(&c->same, key) == SG_NO_KEY && !is_used(c, es[i])) {
        good = sg_world_retract(c->world, SG_E, edge);
      }
    }
  }
  free(es);
  return good || sg_call_no_memory(call);
}

/* symbol(Id) as a term; null: no memory. Close the builder afterwards. */
static const uint32_t *
unary(sg_term_builder *b, int32_t symbol, int32_t id)
{
  sg_term_open(b);
  sg_term_unary(b, symbol, id);
  return sg_term_words(b);
}

/* Whether edge `e` has the origin e(label). 1, 0; -1: no memory. */
static int
is_part_of(const cut_polygon *c, const sg_version *version, int32_t e,
           int32_t label)
{
  sg_term_builder item, origin;
  const uint32_t *i = unary(&item, SG_SYMBOL_E, e),
                 *o = unary(&origin, SG_SYMBOL_E, label);
  int answer = i && o ? 0 : -1;

  if (answer == 0) {
    sg_value key[SG_MAX_COLUMNS] = {[0].i = c->s, [1].term = i};
    sg_row row = sg_version_find(version, SG_ORIGIN, key);
    answer =
        row != SG_NO_ROW &&
        sg_term_equal(sg_version_value(version, SG_ORIGIN, row, 2).term, o);
  }
  sg_term_close(&item);
  sg_term_close(&origin);
  return answer;
}

/* The number of an edge v1-v2 that is a part of edge `label`, written for
 * another polygon; 0: none. -1: no memory. */
static int32_t
known_part(const cut_polygon *c, const cut_edge *edge)
{
  sg_value key[SG_MAX_COLUMNS] = {
      [0].i = c->s, [2].i = edge->v1, [3].i = edge->v2};
  const sg_version *version = sg_world_version(c->world);
  int32_t found = 0;
  sg_walk walk;

  if (!sg_walk_open(&walk, version, SG_E, 0x0d, key)) {
    sg_version_drop(version);
    return -1;
  }
  for (sg_row row; found == 0 && (row = sg_walk_next(&walk)) != SG_NO_ROW;) {
    int32_t e = sg_version_value(version, SG_E, row, 1).i;
    int part = is_part_of(c, version, e, edge->label);
    found = part > 0 ? e : part;
  }
  sg_walk_close(&walk);
  sg_version_drop(version);
  return found;
}

/* Writes a new edge with its origin; its number, 0: an exception. */
static int32_t
new_edge(sg_call *call, const cut_polygon *c, const cut_edge *edge)
{
  int32_t e = sg_call_fresh(call, c->world, SG_E, c->s);
  sg_value row[SG_MAX_COLUMNS] = {[0].i = c->s,
                                  [1].i = e,
                                  [2].i = edge->v1,
                                  [3].i = edge->v2,
                                  [4].i = is_fold(edge) ? 1 : edge->et};
  sg_term_builder item, origin;
  bool good = false;

  if (e == 0) {
    return 0;
  }
  const uint32_t *i = unary(&item, SG_SYMBOL_E, e);
  const uint32_t *o = edge->label > 0
                          ? unary(&origin, SG_SYMBOL_E, edge->label)
                          : unary(&origin, SG_SYMBOL_LINE, (int32_t)edge->line);

  if (!i || !o) {
    sg_call_no_memory(call);
  } else if (sg_call_add_row(call, c->world, SG_E, row)) {
    sg_value said[SG_MAX_COLUMNS] = {[0].i = c->s, [1].term = i, [2].term = o};
    good = sg_call_add_row(call, c->world, SG_ORIGIN, said);
  }
  sg_term_close(&item);
  sg_term_close(&origin);
  return good ? e : 0;
}

/* The number of an edge in the world: as it was, as another polygon has it, or
 * new. 0: an exception. */
static int32_t
edge_number(sg_call *call, const cut_polygon *c, const cut_edge *edge)
{
  int32_t v1 = 0, v2 = 0;

  if (edge->label > 0) {
    sg_row old = find_row(c, SG_E, edge->label);

    if (old != SG_NO_ROW && runs(c, old, &v1, &v2) && v1 == edge->v1 &&
        v2 == edge->v2) {
      return edge->label;
    }
    int32_t part = known_part(c, edge);

    if (part != 0) {
      return part > 0 ? part : sg_call_no_memory(call);
    }
  }
  return new_edge(call, c, edge);
}

static bool
write_edges(sg_call *call, const cut_polygon *c)
{
  int32_t *list = malloc((c->edges + 1) * sizeof *list);
  int32_t n = 0;
  bool good = list ? true : sg_call_no_memory(call);

  for (size_t i = 0; i < c->edges && good; i++) {
    const cut_edge *edge = &c->edge[i];

    if (is_fold(edge) && edge->line == SG_NO_KEY) {
      continue;
    }
    list[++n] = edge_number(call, c, edge);
    good = list[n] != 0;
  }
  if (good) {
    list[0] = n;
    sg_value row[SG_MAX_COLUMNS] = {
        [0].i = c->s, [1].i = c->p, [2].list = list};
    good = sg_call_add_row(call, c->world, SG_P, row);
  }
  free(list);
  return good;
}

static bool
write_triangles(sg_call *call, const cut_polygon *c)
{
  for (size_t i = 0; i < c->triangles; i++) {
    if (!sg_world_retract(c->world, SG_T, c->triangle[i])) {
      return sg_call_no_memory(call);
    }
  }
  for (size_t i = 0; i < c->found.n; i++) {
    const int32_t *v = c->found.item[i].v;
    int32_t t = sg_call_fresh(call, c->world, SG_T, c->s);
    sg_value row[SG_MAX_COLUMNS] = {[0].i = c->s,
                                    [1].i = c->p,
                                    [2].i = t,
                                    [3].i = sg_work_id(c->work, v[0]),
                                    [4].i = sg_work_id(c->work, v[1]),
                                    [5].i = sg_work_id(c->work, v[2])};

    if (t == 0 || !sg_call_add_row(call, c->world, SG_T, row)) {
      return false;
    }
  }
  return true;
}

static bool
read_polygon(sg_call *call, cut_polygon *c)
{
  const sg_version *version = sg_world_version(c->world);
  bool good = copy_edges(c) && find_triangles(c, version);

  sg_version_drop(version);
  return (good || sg_call_no_memory(call)) && all_lines_known(c) &&
         triangulate(call, c) && !c->stuck;
}

bool
sg_door_cut_write(sg_call *call, sg_cut_handle *set, int32_t s, int32_t p,
                  sg_work *work)
{
  cut_polygon c = {.handle = set,
                   .world = sg_call_world(call),
                   .work = work,
                   .s = s,
                   .p = p};
  bool good = false;

  if (c.world && read_polygon(call, &c) && sg_call_claim(call)) {
    good = drop_old(call, &c) && write_edges(call, &c) &&
           write_triangles(call, &c);
    sg_world_release(c.world);
  }
  polygon_clear(&c);
  return good;
}
