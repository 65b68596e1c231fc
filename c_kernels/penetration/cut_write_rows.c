/* cut_write_rows.c -- polygons that were cut, back into the world.
 *
 * Layer: rows. The fused kernel of cut_rows.pl, write_polygon_by_rule/2: the
 * same rows in the same order with the same numbers; a test holds the two
 * together. The door is documented in rules/kernel/penetration.pl.
 */
#include "cut_rows.h"
#include "divided_rows.h"
#include "polygon_rows.h"

#include "doors/penetration.h"

#include <stdlib.h>

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

/* What is written for polygons in turn. */
typedef struct writer {
  sg_cut_handle *handle;
  sg_world *world;
  sg_divided waiting;
  sg_key_table parts; /* (s, label, v1, v2): the edge that is this part */
  bool edges_known;   /* edges had origins before */
} writer;

/* All that is read before anything is written. */
typedef struct cut_polygon {
  sg_cut_handle *handle;
  sg_world *world;
  sg_work *work;
  int32_t s, p;
  cut_edge *edge; /* [edges] */
  size_t edges;
  sg_key_table same; /* (label, v1, v2) of the edges */
  sg_triangles found;
} cut_polygon;

/* ---- reading ---- */

static bool
copy_edges(sg_call *call, cut_polygon *c)
{
  c->edge = sg_call_alloc(call, sg_work_edges(c->work) * sizeof *c->edge);
  for (int32_t e = 0; c->edge && (e = sg_work_next(c->work, e));) {
    const sg_work_edge *from = sg_work_get(c->work, e);
    cut_edge *to = &c->edge[c->edges++];

    *to = (cut_edge){sg_work_id(c->work, from->start),
                     sg_work_id(c->work, from->end), from->et,
                     (int32_t)from->label, SG_NO_KEY};
    if (!sg_edge_is_same(call, &c->same, to->label, to->v1, to->v2)) {
      return false;
    }
    if (to->label <= 0) {
      to->line = sg_cut_line_of(c->handle, c->s, to->v1, to->v2);
    }
  }
  return c->edge != NULL;
}

/* A piece or a fold along which a line runs, and every edge that is a part of
 * one of the polygon's, is written. */
static bool
is_written(const cut_edge *edge)
{
  return edge->label > 0 || edge->line != SG_NO_KEY;
}

static bool
all_lines_known(const cut_polygon *c)
{
  for (size_t i = 0; i < c->edges; i++) {
    if (!is_written(&c->edge[i]) && !is_fold(&c->edge[i])) {
      return false;
    }
  }
  return true;
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

/* Whether the polygon has triangles. -1: no memory. */
static int
has_triangles(const cut_polygon *c)
{
  const sg_value key[SG_MAX_COLUMNS] = {[0].i = c->s, [1].i = c->p};
  const sg_version *version = sg_world_version(c->world);
  sg_walk walk;
  int has = -1;

  if (sg_walk_open(&walk, version, SG_T, 0x03, key)) {
    has = sg_walk_next(&walk) != SG_NO_ROW;
    sg_walk_close(&walk);
  }
  sg_version_drop(version);
  return has;
}

/* A polygon that had triangles gets new ones, of ids. False without a refusal:
 * it cannot be triangulated. */
static bool
triangulate(sg_call *call, cut_polygon *c)
{
  int has = has_triangles(c);
  int32_t edge;
  sg_outcome end =
      has > 0 ? sg_work_triangulate(c->work, &c->found, &edge, &call->cancel)
              : SG_DONE;

  if (end == SG_STUCK) {
    return !restore_edges(c) && sg_call_no_memory(call);
  }
  for (size_t i = 0; i < 3 * c->found.n; i++) {
    int32_t *v = &c->found.item[i / 3].v[i % 3];

    *v = sg_work_id(c->work, *v);
  }
  return (has >= 0 && end == SG_DONE) || sg_call_ended(call);
}

/* ---- writing ---- */

/* Whether edges have origins: before the first cut none has, and nobody needs
 * to look for parts that are there. */
static bool
have_edges_origins(sg_world *world)
{
  const sg_value any[SG_MAX_COLUMNS] = {0};
  const sg_version *version = sg_world_version(world);
  bool have = true;
  sg_walk walk;

  if (sg_walk_open(&walk, version, SG_ORIGIN, 0, any)) {
    sg_row row;

    while ((row = sg_walk_next(&walk)) != SG_NO_ROW &&
           !sg_node_is(sg_version_value(version, SG_ORIGIN, row, 1).term + 1,
                       SG_SYMBOL_E, 1)) {
    }
    have = row != SG_NO_ROW;
    sg_walk_close(&walk);
  }
  sg_version_drop(version);
  return have;
}

/* The number of an edge in the world v1-v2 that is a part of edge `label`, as
 * its origin says. 0: none, or refused (*good false). */
static int32_t
old_part(sg_call *call, const cut_polygon *c, const cut_edge *edge,
         const uint32_t *origin, bool *good)
{
  const sg_value key[SG_MAX_COLUMNS] = {
      [0].i = c->s, [2].i = edge->v1, [3].i = edge->v2};
  const sg_version *version = sg_world_version(c->world);
  int32_t found = 0;
  sg_walk walk;

  *good =
      sg_walk_open(&walk, version, SG_E, 0x0d, key) || sg_call_no_memory(call);
  if (*good) {
    for (sg_row row;
         *good && found == 0 && (row = sg_walk_next(&walk)) != SG_NO_ROW;) {
      int32_t e = sg_version_value(version, SG_E, row, 1).i;
      const sg_value said[SG_MAX_COLUMNS] = {
          [0].i = c->s, [1].term = sg_unary_term(call, SG_SYMBOL_E, e)};
      sg_row at =
          said[1].term ? sg_version_find(version, SG_ORIGIN, said) : SG_NO_ROW;

      *good = said[1].term != NULL;
      if (at != SG_NO_ROW &&
          sg_term_equal(sg_version_value(version, SG_ORIGIN, at, 2).term,
                        origin)) {
        found = e;
      }
    }
    sg_walk_close(&walk);
  }
  sg_version_drop(version);
  return found;
}

/* A new edge with its origin, unless it has one already (*other); its number.
 * 0: refused. */
static int32_t
new_edge(sg_call *call, writer *w, const cut_polygon *c, const cut_edge *edge,
         const uint32_t *origin, bool *other)
{
  int32_t e = origin ? sg_call_fresh(call, w->world, SG_E, c->s) : 0;
  const uint32_t *item = e ? sg_unary_term(call, SG_SYMBOL_E, e) : NULL;
  const int32_t row[5] = {c->s, e, edge->v1, edge->v2,
                          is_fold(edge) ? 1 : edge->et};

  if (!item || !sg_divided_edge(call, &w->waiting, row)) {
    return 0;
  }
  *other = w->edges_known && sg_origin_is_there(w->world, c->s, item);
  return *other || sg_divided_origin(call, &w->waiting, c->s, item, origin) ? e
                                                                            : 0;
}

/* The number of a part of an edge: as another polygon has it, or new. */
static int32_t
part_number(sg_call *call, writer *w, const cut_polygon *c,
            const cut_edge *edge)
{
  const uint32_t *origin = sg_unary_term(call, SG_SYMBOL_E, edge->label);
  const uint32_t key[4] = {(uint32_t)c->s, (uint32_t)edge->label,
                           (uint32_t)edge->v1, (uint32_t)edge->v2};
  bool good = origin != NULL, other = false;
  uint32_t *known = good ? sg_key_table_put(&w->parts, key) : NULL;

  if (!known) {
    return good && sg_call_no_memory(call);
  }
  if (*known != SG_NO_KEY) {
    return (int32_t)*known;
  }
  int32_t e = w->edges_known ? old_part(call, c, edge, origin, &good) : 0;

  if (e == 0 && good) {
    e = new_edge(call, w, c, edge, origin, &other);
  }
  if (e != 0 && !other) {
    *known = (uint32_t)e;
  }
  return e;
}

/* The number of an edge: as it was, as another polygon has it, or new. 0:
 * refused. */
static int32_t
edge_number(sg_call *call, writer *w, const cut_polygon *c,
            const cut_edge *edge)
{
  if (edge->label <= 0) {
    bool other;

    return new_edge(call, w, c, edge,
                    sg_unary_term(call, SG_SYMBOL_LINE, (int32_t)edge->line),
                    &other);
  }
  return sg_edge_runs(c->world, c->s, edge->label, edge->v1, edge->v2)
             ? edge->label
             : part_number(call, w, c, edge);
}

static bool
write_edges(sg_call *call, writer *w, const cut_polygon *c)
{
  int32_t *list = sg_call_alloc(call, (c->edges + 1) * sizeof *list);
  int32_t n = 0;
  bool good = list != NULL;

  for (size_t i = 0; i < c->edges && good; i++) {
    if (is_written(&c->edge[i])) {
      list[++n] = edge_number(call, w, c, &c->edge[i]);
      good = list[n] != 0;
    }
  }
  if (!good) {
    return false;
  }
  list[0] = n;
  return sg_divided_polygon(call, &w->waiting, c->s, c->p, list);
}

static bool
write_triangles(sg_call *call, writer *w, const cut_polygon *c)
{
  bool good = sg_triangles_drop(call, w->world, c->s, c->p);

  for (size_t i = 0; good && i < c->found.n; i++) {
    const int32_t *v = c->found.item[i].v;
    int32_t t = sg_call_fresh(call, w->world, SG_T, c->s);

    good = t != 0 && sg_divided_triangle(
                         call, &w->waiting,
                         (const int32_t[6]){c->s, c->p, t, v[0], v[1], v[2]});
  }
  return good;
}

/* Edges that polygons share are looked for in what is written. */
static bool
write_polygon(sg_call *call, writer *w, const cut_polygon *c)
{
  if (sg_cut_shares_edges(w->handle, c->s) &&
      !sg_divided_write(call, &w->waiting, w->world)) {
    return false;
  }
  const int32_t *old = sg_polygon_retract(call, w->world, c->s, c->p);

  return old && sg_edges_drop(call, w->world, c->s, old, &c->same, w->handle) &&
         write_edges(call, w, c) && write_triangles(call, w, c);
}

/* False without a refusal: it cannot be triangulated, and nothing changed. */
static bool
take_polygon(sg_call *call, writer *w, const sg_entered *polygon)
{
  cut_polygon c = {.handle = w->handle,
                   .world = w->world,
                   .work = polygon->work,
                   .s = polygon->s,
                   .p = polygon->p};

  sg_key_table_init(&c.same, 3);
  bool good = copy_edges(call, &c) && all_lines_known(&c) &&
              triangulate(call, &c) && write_polygon(call, w, &c);

  free(c.found.item);
  sg_key_table_clear(&c.same);
  return good;
}

bool
sg_door_cut_write(sg_call *call, sg_cut_handle *set,
                  const sg_entered_polygon_list *works, size_t *written)
{
  writer w = {.handle = set, .world = sg_call_claim(call)};

  if (!w.world) {
    return false;
  }
  w.edges_known = have_edges_origins(w.world);
  sg_key_table_init(&w.parts, 4);
  for (*written = 0; *written < works->n; ++*written) {
    if (!take_polygon(call, &w, &works->at[*written])) {
      break;
    }
  }
  bool good = call->refusal.how == SG_REFUSED_NOTHING && !call->stopped &&
              sg_divided_write(call, &w.waiting, w.world);

  sg_key_table_clear(&w.parts);
  sg_world_release(w.world);
  return good;
}
