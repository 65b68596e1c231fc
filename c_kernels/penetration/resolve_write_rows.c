/* resolve_write_rows.c -- what was made to touch, into the world: see
 * resolve_rows.h.
 *
 * Layer: rows.
 */
#include "resolve_rows.h"

#include "doors/penetration.h"
#include "engine/search.h"
#include "leaf_rows.h"
#include "polygon_rows.h"
#include "rows/added_rows.h"

#include <string.h>

/* ---- vertices ---- */

/* near(v(S, V)), or near(ll(S1-(V1, V2), S2-(V3, V4))). */
static void
build_origin(sg_term_builder *b, const sg_resolve_node *node)
{
  sg_term_compound(b, SG_SYMBOL_NEAR, 1);
  if (node->v) {
    sg_term_compound(b, SG_SYMBOL_V, 2);
    sg_term_int(b, node->s);
    sg_term_int(b, node->v);
    return;
  }
  sg_term_compound(b, SG_SYMBOL_LL, 2);
  for (int k = 0; k < 2; k++) {
    sg_term_compound(b, SG_SYMBOL_MINUS, 2);
    sg_term_int(b, node->line[k][0]);
    sg_term_compound(b, SG_SYMBOL_COMMA, 2);
    sg_term_int(b, node->line[k][1]);
    sg_term_int(b, node->line[k][2]);
  }
}

const uint32_t *
sg_resolving_origin(sg_call *call, const sg_resolve_node *node)
{
  sg_term_builder b;

  sg_term_open(&b);
  build_origin(&b, node);
  return sg_call_term(call, &b);
}

/* Rows are gathered, and written a relation at once. */
typedef struct writer {
  sg_call *call;
  const sg_resolving *job;
  sg_world *world;
  sg_added_rows leaf_v, v, e, p, t, origin;
} writer;

/* What was there is kept first (leaf.pl). */
static bool
keep_vertex(writer *w, const sg_resolve_place *place)
{
  sg_value row[SG_MAX_COLUMNS];

  return sg_row_now(w->world, SG_LEAF_V, place->s, place->name, NULL) !=
             SG_NO_ROW ||
         sg_row_now(w->world, SG_V, place->s, place->name, row) == SG_NO_ROW ||
         sg_added_rows_put(w->call, &w->leaf_v, row);
}

/* origin(S, symbol(Id), Origin). */
static bool
put_origin(writer *w, int32_t s, int32_t symbol, int32_t id,
           const uint32_t *origin)
{
  const sg_value row[SG_MAX_COLUMNS] = {[0].i = s,
                                        [1].term =
                                            sg_unary_term(w->call, symbol, id),
                                        [2].term = origin};

  return row[1].term && origin && sg_added_rows_put(w->call, &w->origin, row);
}

static bool
write_vertex(writer *w, const sg_resolve_place *place)
{
  const sg_resolve_point *point = &w->job->r.point.item[place->point];
  const uint32_t *item = sg_unary_term(w->call, SG_SYMBOL_V, place->name);
  sg_value row[SG_MAX_COLUMNS] = {[0].i = place->s, [1].i = place->name};
  sg_row old = sg_row_now(w->world, SG_V, place->s, place->name, NULL);

  if (old != SG_NO_ROW && !sg_world_retract(w->world, SG_V, old)) {
    return sg_call_no_memory(w->call);
  }
  for (unsigned c = 0; c < 3; c++) {
    row[c + 2].f = point->at[c] + 0.0;
  }
  return item && sg_added_rows_put(w->call, &w->v, row) &&
         (sg_origin_is_there(w->world, place->s, item) ||
          put_origin(
              w, place->s, SG_SYMBOL_V, place->name,
              sg_resolving_origin(w->call, &w->job->r.node.item[point->node])));
}

/* ---- polygons ---- */

static bool
keep_polygons(writer *w)
{
  sg_segment_polygon_list list = {0};

  for (size_t i = 0; i < w->job->polygon.n; i++) {
    const sg_resolved_polygon *polygon = &w->job->polygon.item[i];

    if (!sg_segment_polygon_list_add(
            w->call, &list, (sg_segment_polygon){polygon->s, polygon->p})) {
      return false;
    }
  }
  return sg_leaves_keep(w->call, w->world, &list);
}

/* A new edge is a part of one that was, or a seam. 0: refused. */
static int32_t
put_edge(writer *w, int32_t s, const sg_resolved_edge *edge)
{
  int32_t e = sg_call_fresh(w->call, w->world, SG_E, s);
  const sg_value row[SG_MAX_COLUMNS] = {[0].i = s,
                                        [1].i = e,
                                        [2].i = edge->v[0],
                                        [3].i = edge->v[1],
                                        [4].i = edge->et};
  sg_term_builder b;

  sg_term_open(&b);
  if (edge->label > 0) {
    sg_term_unary(&b, SG_SYMBOL_E, edge->label);
  } else {
    sg_term_atom(&b, "near", 4);
  }
  const uint32_t *origin = sg_call_term(w->call, &b);

  return e != 0 && sg_added_rows_put(w->call, &w->e, row) &&
                 put_origin(w, s, SG_SYMBOL_E, e, origin)
             ? e
             : 0;
}

/* Whether an edge that was there runs so: no edges are written yet. */
static bool
is_as_was(const writer *w, int32_t s, const sg_resolved_edge *edge)
{
  sg_cut_handle *handle = w->job->handle;
  sg_row row = sg_cut_row_of(handle, SG_E, s, edge->label);

  return row != SG_NO_ROW &&
         sg_version_value(handle->version, SG_E, row, 2).i == edge->v[0] &&
         sg_version_value(handle->version, SG_E, row, 3).i == edge->v[1];
}

/* The numbers of the polygon's edges, as a list of p/3. */
static bool
number_edges(writer *w, const sg_resolved_polygon *polygon, int32_t *list)
{
  list[0] = (int32_t)polygon->edge.n;
  for (size_t i = 0; i < polygon->edge.n; i++) {
    const sg_resolved_edge *edge = &polygon->edge.item[i];
    int32_t e = edge->label;

    if (e <= 0 || !is_as_was(w, polygon->s, edge)) {
      e = put_edge(w, polygon->s, edge);
    }
    if ((list[i + 1] = e) == 0) {
      return false;
    }
  }
  return true;
}

static bool
put_triangles(writer *w, const sg_resolved_polygon *polygon)
{
  for (size_t i = 0; i < polygon->triangle.n; i++) {
    const int32_t *v = polygon->triangle.item[i].v;
    int32_t t = sg_call_fresh(w->call, w->world, SG_T, polygon->s);
    const sg_value row[SG_MAX_COLUMNS] = {
        [0].i = polygon->s, [1].i = polygon->p, [2].i = t,
        [3].i = v[0],       [4].i = v[1],       [5].i = v[2]};

    if (t == 0 || !sg_added_rows_put(w->call, &w->t, row)) {
      return false;
    }
  }
  return true;
}

/* Leaves those of a polygon's old edges that it has no more. False: refused. */
static bool
leave_gone(sg_call *call, const int32_t *list, int32_t *old)
{
  size_t n = (size_t)list[0], gone = 0;
  int32_t *id = sg_call_alloc(call, (n + 1) * sizeof *id);

  if (!id) {
    return false;
  }
  memcpy(id, list + 1, n * sizeof *id);
  n = n > 0 ? sg_sort_ids(id, n) : 0;
  for (int32_t i = 1; i <= old[0]; i++) {
    if (sg_find_id(id, n, old[i]) == SIZE_MAX) {
      old[++gone] = old[i];
    }
  }
  old[0] = (int32_t)gone;
  return true;
}

/* The polygon keeps its number, and its edges that were not divided theirs.
 * *gone: the edges that it had and has no more. */
static bool
write_polygon(writer *w, const sg_resolved_polygon *polygon, int32_t **gone)
{
  int32_t s = polygon->s, p = polygon->p;
  int32_t *list = sg_call_alloc(w->call, (polygon->edge.n + 1) * sizeof *list);

  *gone = sg_polygon_retract(w->call, w->world, s, p);
  return *gone && list && number_edges(w, polygon, list) &&
         leave_gone(w->call, list, *gone) &&
         sg_added_rows_put(w->call, &w->p,
                           (sg_value[SG_MAX_COLUMNS]){
                               [0].i = s, [1].i = p, [2].list = list}) &&
         sg_triangles_drop(w->call, w->world, s, p) &&
         put_triangles(w, polygon);
}

/* ---- all ---- */

static bool
write_vertices(writer *w)
{
  const sg_resolve_place *place = w->job->r.place.item;
  size_t n = w->job->r.place.n;
  bool good = true;

  for (size_t i = 0; i < n && good; i++) {
    good =
        sg_resolving_goes_on(w->call, i) &&
        (!sg_resolving_changes(w->job, &place[i]) || keep_vertex(w, &place[i]));
  }
  good = good && sg_added_rows_write(w->call, w->world, &w->leaf_v) &&
         keep_polygons(w);
  for (size_t i = 0; i < n && good; i++) {
    good = sg_resolving_goes_on(w->call, i) &&
           (!sg_resolving_changes(w->job, &place[i]) ||
            write_vertex(w, &place[i]));
  }
  return good && sg_added_rows_write(w->call, w->world, &w->v);
}

/* Edges go when all polygons have theirs: several may have one that goes from
 * this one. */
static bool
drop_edges(writer *w, int32_t *const *gone)
{
  sg_key_table none;
  bool good = true;

  sg_key_table_init(&none, 3);
  for (size_t i = 0; i < w->job->polygon.n && good; i++) {
    good = sg_resolving_goes_on(w->call, i) &&
           sg_edges_drop(w->call, w->world, w->job->polygon.item[i].s, gone[i],
                         &none, NULL);
  }
  sg_key_table_clear(&none);
  return good;
}

static bool
write_polygons(writer *w)
{
  size_t n = w->job->polygon.n;
  int32_t **gone = sg_call_alloc(w->call, (n + 1) * sizeof *gone);
  bool good = gone;

  for (size_t i = 0; i < n && good; i++) {
    good = sg_resolving_goes_on(w->call, i) &&
           write_polygon(w, &w->job->polygon.item[i], &gone[i]);
  }
  return good && sg_added_rows_write(w->call, w->world, &w->e) &&
         sg_added_rows_write(w->call, w->world, &w->p) &&
         sg_added_rows_write(w->call, w->world, &w->t) && drop_edges(w, gone);
}

bool
sg_resolving_write(sg_call *call, const sg_resolving *job)
{
  writer w = {.call = call,
              .job = job,
              .world = job->handle->world,
              .leaf_v.relation = SG_LEAF_V,
              .v.relation = SG_V,
              .e.relation = SG_E,
              .p.relation = SG_P,
              .t.relation = SG_T,
              .origin.relation = SG_ORIGIN};

  if (!sg_world_claim(w.world, &call->cancel)) {
    return false;
  }
  bool good = write_vertices(&w) && write_polygons(&w) &&
              sg_added_rows_write(call, w.world, &w.origin);

  sg_world_release(w.world);
  return good;
}
