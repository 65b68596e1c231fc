/* resolve_write_rows.c -- what was made to touch, into the world: see
 * resolve_rows.h.
 *
 * Layer: rows.
 */
#include "resolve_rows.h"

#include "doors/penetration.h"
#include "leaf_rows.h"
#include "polygon_rows.h"

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

/* What was there is kept first (leaf.pl). */
static bool
keep_vertex(sg_call *call, sg_world *world, const sg_resolve_place *place)
{
  sg_value row[SG_MAX_COLUMNS];

  return sg_row_now(world, SG_LEAF_V, place->s, place->name, NULL) !=
             SG_NO_ROW ||
         sg_row_now(world, SG_V, place->s, place->name, row) == SG_NO_ROW ||
         sg_call_add_row(call, world, SG_LEAF_V, row);
}

static bool
write_vertex(sg_call *call, const sg_resolving *job, sg_world *world,
             const sg_resolve_place *place)
{
  const sg_resolve_point *point = &job->r.point.item[place->point];
  sg_value row[SG_MAX_COLUMNS] = {[0].i = place->s, [1].i = place->name};
  sg_row old = sg_row_now(world, SG_V, place->s, place->name, NULL);

  if (old != SG_NO_ROW && !sg_world_retract(world, SG_V, old)) {
    return sg_call_no_memory(call);
  }
  for (unsigned c = 0; c < 3; c++) {
    row[c + 2].f = point->at[c] + 0.0;
  }
  return sg_call_add_row(call, world, SG_V, row) &&
         sg_origin_add(
             call, world, place->s, SG_SYMBOL_V, place->name,
             sg_resolving_origin(call, &job->r.node.item[point->node]));
}

/* ---- polygons ---- */

static bool
keep_polygons(sg_call *call, const sg_resolving *job, sg_world *world)
{
  sg_segment_polygon_list list = {0};

  for (size_t i = 0; i < job->polygon.n; i++) {
    const sg_resolved_polygon *polygon = &job->polygon.item[i];

    if (!sg_segment_polygon_list_add(
            call, &list, (sg_segment_polygon){polygon->s, polygon->p})) {
      return false;
    }
  }
  return sg_leaves_keep(call, world, &list);
}

/* A new edge is a part of one that was, or a seam. 0: refused. */
static int32_t
add_edge(sg_call *call, sg_world *world, int32_t s,
         const sg_resolved_edge *edge)
{
  sg_term_builder b;

  sg_term_open(&b);
  if (edge->label > 0) {
    sg_term_unary(&b, SG_SYMBOL_E, edge->label);
  } else {
    sg_term_atom(&b, "near", 4);
  }
  return sg_edge_add(call, world, s, edge->v[0], edge->v[1], edge->et,
                     sg_call_term(call, &b));
}

/* The numbers of the polygon's edges, as a list of p/3; those that are as they
 * were are also noted in `same`. */
static bool
number_edges(sg_call *call, sg_world *world, const sg_resolved_polygon *polygon,
             int32_t *list, sg_key_table *same)
{
  list[0] = (int32_t)polygon->edge.n;
  for (size_t i = 0; i < polygon->edge.n; i++) {
    const sg_resolved_edge *edge = &polygon->edge.item[i];
    int32_t e = edge->label;

    if (e <= 0 || !sg_edge_runs(world, polygon->s, e, edge->v[0], edge->v[1])) {
      e = add_edge(call, world, polygon->s, edge);
    } else if (!sg_edge_is_same(call, same, e, edge->v[0], edge->v[1])) {
      return false;
    }
    if ((list[i + 1] = e) == 0) {
      return false;
    }
  }
  return true;
}

/* The polygon keeps its number, and its edges that were not divided theirs. */
static bool
write_polygon(sg_call *call, sg_world *world,
              const sg_resolved_polygon *polygon)
{
  int32_t s = polygon->s, p = polygon->p;
  const int32_t *old = sg_polygon_retract(call, world, s, p);
  int32_t *list = sg_call_alloc(call, (polygon->edge.n + 1) * sizeof *list);
  sg_key_table same;

  sg_key_table_init(&same, 3);
  bool good = old && list && number_edges(call, world, polygon, list, &same) &&
              sg_edges_drop(call, world, s, old, &same, NULL) &&
              sg_call_add_row(call, world, SG_P,
                              (sg_value[SG_MAX_COLUMNS]){
                                  [0].i = s, [1].i = p, [2].list = list}) &&
              sg_triangles_replace(call, world, s, p, polygon->triangle.item,
                                   polygon->triangle.n);

  sg_key_table_clear(&same);
  return good;
}

/* ---- all ---- */

static bool
write_all(sg_call *call, const sg_resolving *job, sg_world *world)
{
  const sg_resolve_place *place = job->r.place.item;
  bool good = true;

  for (size_t i = 0; i < job->r.place.n && good; i++) {
    good = sg_resolving_goes_on(call, i) &&
           (!sg_resolving_changes(job, &place[i]) ||
            keep_vertex(call, world, &place[i]));
  }
  good = good && keep_polygons(call, job, world);
  for (size_t i = 0; i < job->r.place.n && good; i++) {
    good = sg_resolving_goes_on(call, i) &&
           (!sg_resolving_changes(job, &place[i]) ||
            write_vertex(call, job, world, &place[i]));
  }
  for (size_t i = 0; i < job->polygon.n && good; i++) {
    good = sg_resolving_goes_on(call, i) &&
           write_polygon(call, world, &job->polygon.item[i]);
  }
  return good;
}

bool
sg_resolving_write(sg_call *call, const sg_resolving *job)
{
  sg_world *world = job->handle->world;

  if (!sg_world_claim(world, &call->cancel)) {
    return false;
  }
  bool good = write_all(call, job, world);

  sg_world_release(world);
  return good;
}
