/* resolve_write_rows.c -- what was made to touch, into the world: see
 * resolve_rows.h.
 *
 * Layer: rows.
 */
#include "resolve_rows.h"

#include <stdlib.h>
#include <string.h>

/* ---- rows ---- */

/* A copy of the row with this key in the world as it is now; lists and terms
 * in it belong to the world. SG_NO_ROW: there is none. */
static sg_row
read_row(sg_world *world, sg_relation relation, int32_t s, int32_t id,
         sg_value out[SG_MAX_COLUMNS])
{
  sg_value key[SG_MAX_COLUMNS] = {[0].i = s, [1].i = id};
  const sg_version *version = sg_world_version(world);
  sg_row row = sg_version_find(version, relation, key);

  for (unsigned c = 0;
       row != SG_NO_ROW && c < sg_relation_table[relation].arity; c++) {
    out[c] = sg_version_value(version, relation, row, c);
  }
  sg_version_drop(version);
  return row;
}

/* A row of another relation with the same columns, unless its key is there. */
static bool
keep(sg_call *call, sg_world *world, sg_relation from, sg_relation to,
     int32_t s, int32_t id)
{
  sg_value row[SG_MAX_COLUMNS], known[SG_MAX_COLUMNS];

  return read_row(world, to, s, id, known) != SG_NO_ROW ||
         read_row(world, from, s, id, row) == SG_NO_ROW ||
         sg_call_add_row(call, world, to, row);
}

/* The list of p/3, to be freed; null: no such row, or an exception. *row: where
 * it is. */
static int32_t *
read_list(sg_call *call, sg_world *world, int32_t s, int32_t p, sg_row *row)
{
  sg_value value[SG_MAX_COLUMNS];
  int32_t *list = NULL;

  *row = read_row(world, SG_P, s, p, value);
  if (*row != SG_NO_ROW) {
    size_t size = ((size_t)value[2].list[0] + 1) * sizeof *list;
    list = malloc(size);
    if (list) {
      memcpy(list, value[2].list, size);
    } else {
      sg_call_no_memory(call);
    }
  }
  return list;
}

typedef bool use_triangle(sg_call *call, sg_world *world, sg_row row,
                          const sg_value value[SG_MAX_COLUMNS]);

/* Calls `use` with each triangle of a polygon, in order. */
static bool
each_triangle(sg_call *call, sg_world *world, int32_t s, int32_t p,
              use_triangle *use)
{
  sg_value key[SG_MAX_COLUMNS] = {[0].i = s, [1].i = p};
  const sg_version *version = sg_world_version(world);
  SG_LIST_OF(sg_row) rows = {0};
  sg_walk walk;
  bool good = sg_walk_open(&walk, version, SG_T, 0x03, key);

  if (good) {
    for (sg_row row; good && (row = sg_walk_next(&walk)) != SG_NO_ROW;) {
      good = SG_PUSH(rows, row);
    }
    sg_walk_close(&walk);
  }
  bool done = good || sg_call_no_memory(call);

  for (size_t i = 0; i < rows.n && done; i++) {
    sg_value value[SG_MAX_COLUMNS];
    for (unsigned c = 0; c < 6; c++) {
      value[c] = sg_version_value(version, SG_T, rows.item[i], c);
    }
    done = use(call, world, rows.item[i], value);
  }
  sg_version_drop(version);
  free(rows.item);
  return done;
}

/* ---- what was there before is kept (leaf.pl) ---- */

static bool
keep_triangle(sg_call *call, sg_world *world, sg_row row,
              const sg_value value[SG_MAX_COLUMNS])
{
  (void)row;
  return sg_call_add_row(call, world, SG_LEAF_T, value);
}

static bool
keep_leaf(sg_call *call, sg_world *world, int32_t s, int32_t p)
{
  sg_value known[SG_MAX_COLUMNS];
  sg_row row;

  if (read_row(world, SG_LEAF_P, s, p, known) != SG_NO_ROW) {
    return true;
  }
  int32_t *list = read_list(call, world, s, p, &row);
  bool good = list != NULL;

  for (int32_t i = 1; good && i <= list[0]; i++) {
    good = keep(call, world, SG_E, SG_LEAF_E, s, list[i]);
  }
  if (good) {
    sg_value leaf[SG_MAX_COLUMNS] = {[0].i = s, [1].i = p, [2].list = list};
    good = sg_call_add_row(call, world, SG_LEAF_P, leaf) &&
           each_triangle(call, world, s, p, keep_triangle);
  }
  free(list);
  return good || row == SG_NO_ROW;
}

/* ---- vertices ---- */

void
sg_resolving_build_origin(sg_term_builder *b, const sg_resolve_node *node)
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

/* Writes origin(S, Symbol(Id), Origin); one that is there stays. */
static bool
say_origin(sg_call *call, sg_world *world, int32_t s, int32_t symbol,
           int32_t id, sg_term_builder *origin)
{
  sg_term_builder item;

  sg_term_open(&item);
  sg_term_unary(&item, symbol, id);
  sg_value row[SG_MAX_COLUMNS] = {[0].i = s,
                                  [1].term = sg_term_words(&item),
                                  [2].term = sg_term_words(origin)};
  bool good = row[1].term && row[2].term ? true : sg_call_no_memory(call);

  if (good) {
    const sg_version *version = sg_world_version(world);
    bool known = sg_version_find(version, SG_ORIGIN, row) != SG_NO_ROW;
    sg_version_drop(version);
    good = known || sg_call_add_row(call, world, SG_ORIGIN, row);
  }
  sg_term_close(&item);
  return good;
}

static bool
write_vertex(sg_call *call, const sg_resolving *job, sg_world *world,
             const sg_resolve_place *place)
{
  const sg_resolve_point *point = &job->r.point.item[place->point];
  sg_value old[SG_MAX_COLUMNS],
      row[SG_MAX_COLUMNS] = {[0].i = place->s, [1].i = place->name};
  sg_row known = read_row(world, SG_V, place->s, place->name, old);

  if (known != SG_NO_ROW && !sg_world_retract(world, SG_V, known)) {
    return sg_call_no_memory(call);
  }
  for (unsigned c = 0; c < 3; c++) {
    row[c + 2].f = point->at[c] + 0.0;
  }
  if (!sg_call_add_row(call, world, SG_V, row)) {
    return false;
  }
  sg_term_builder origin;

  sg_term_open(&origin);
  sg_resolving_build_origin(&origin, &job->r.node.item[point->node]);
  bool good =
      say_origin(call, world, place->s, SG_SYMBOL_V, place->name, &origin);

  sg_term_close(&origin);
  return good;
}

/* ---- polygons ---- */

/* Writes a new edge with its origin; its number, 0: an exception. */
static int32_t
new_edge(sg_call *call, sg_world *world, int32_t s,
         const sg_resolved_edge *edge)
{
  int32_t e = sg_call_fresh(call, world, SG_E, s);
  sg_value row[SG_MAX_COLUMNS] = {[0].i = s,
                                  [1].i = e,
                                  [2].i = edge->v[0],
                                  [3].i = edge->v[1],
                                  [4].i = edge->et};
  sg_term_builder origin;

  if (e == 0 || !sg_call_add_row(call, world, SG_E, row)) {
    return 0;
  }
  sg_term_open(&origin);
  if (edge->label > 0) {
    sg_term_unary(&origin, SG_SYMBOL_E, edge->label);
  } else {
    sg_term_atom(&origin, "near", 4);
  }
  bool good = say_origin(call, world, s, SG_SYMBOL_E, e, &origin);

  sg_term_close(&origin);
  return good ? e : 0;
}

/* Whether edge `e` of segment s runs from v[0] to v[1]. */
static bool
runs(sg_world *world, int32_t s, int32_t e, const int32_t v[2])
{
  sg_value row[SG_MAX_COLUMNS];

  return read_row(world, SG_E, s, e, row) != SG_NO_ROW && row[2].i == v[0] &&
         row[3].i == v[1];
}

/* Whether a polygon has edge `e` of segment s. */
static bool
is_used(sg_world *world, int32_t s, int32_t e)
{
  const sg_version *version = sg_world_version(world);
  bool used = sg_version_has_member(version, SG_P, s, e);

  sg_version_drop(version);
  return used;
}

/* The edges of the list go, but those that are kept, and those that another
 * polygon has. `kept`, ascending. */
static bool
drop_gone(sg_call *call, sg_world *world, int32_t s, const int32_t *list,
          const sg_key_table *kept)
{
  sg_value old[SG_MAX_COLUMNS];

  for (int32_t i = 1; i <= list[0]; i++) {
    uint32_t key = (uint32_t)list[i];
    sg_row row = sg_key_table_get(kept, &key) == SG_NO_KEY
                     ? read_row(world, SG_E, s, list[i], old)
                     : SG_NO_ROW;

    if (row != SG_NO_ROW && !is_used(world, s, list[i]) &&
        !sg_world_retract(world, SG_E, row)) {
      return sg_call_no_memory(call);
    }
  }
  return true;
}

/* The numbers of the polygon's edges, as a list of p/3; those that are as they
 * were are also noted in `kept`. */
static bool
number_edges(sg_call *call, sg_world *world, const sg_resolved_polygon *polygon,
             int32_t *list, sg_key_table *kept)
{
  list[0] = (int32_t)polygon->edge.n;
  for (size_t i = 0; i < polygon->edge.n; i++) {
    const sg_resolved_edge *edge = &polygon->edge.item[i];
    uint32_t key = (uint32_t)edge->label;

    if (edge->label > 0 && runs(world, polygon->s, edge->label, edge->v)) {
      uint32_t *known = sg_key_table_put(kept, &key);
      if (!known) {
        return sg_call_no_memory(call);
      }
      *known = 0;
      list[i + 1] = edge->label;
    } else if ((list[i + 1] = new_edge(call, world, polygon->s, edge)) == 0) {
      return false;
    }
  }
  return true;
}

static bool
drop_triangle(sg_call *call, sg_world *world, sg_row row,
              const sg_value value[SG_MAX_COLUMNS])
{
  (void)value;
  return sg_world_retract(world, SG_T, row) || sg_call_no_memory(call);
}

static bool
write_triangles(sg_call *call, sg_world *world,
                const sg_resolved_polygon *polygon)
{
  int32_t s = polygon->s, p = polygon->p;

  if (!each_triangle(call, world, s, p, drop_triangle)) {
    return false;
  }
  for (size_t i = 0; i < polygon->triangle.n; i++) {
    const int32_t *v = polygon->triangle.item[i].v;
    int32_t t = sg_call_fresh(call, world, SG_T, s);
    sg_value row[SG_MAX_COLUMNS] = {[0].i = s,    [1].i = p,    [2].i = t,
                                    [3].i = v[0], [4].i = v[1], [5].i = v[2]};

    if (t == 0 || !sg_call_add_row(call, world, SG_T, row)) {
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
  sg_row row;
  int32_t *old = read_list(call, world, polygon->s, polygon->p, &row);
  int32_t *list = malloc((polygon->edge.n + 1) * sizeof *list);
  sg_key_table kept;
  bool good = old && (list || sg_call_no_memory(call));

  sg_key_table_init(&kept, 1);
  if (good) {
    good = (sg_world_retract(world, SG_P, row) || sg_call_no_memory(call)) &&
           number_edges(call, world, polygon, list, &kept);
  }
  if (good) {
    sg_value fresh[SG_MAX_COLUMNS] = {
        [0].i = polygon->s, [1].i = polygon->p, [2].list = list};
    good = drop_gone(call, world, polygon->s, old, &kept) &&
           sg_call_add_row(call, world, SG_P, fresh) &&
           write_triangles(call, world, polygon);
  }
  sg_key_table_clear(&kept);
  free(old);
  free(list);
  return good;
}

/* ---- all ---- */

/* What was there is kept first. */
static bool
write_all(sg_call *call, const sg_resolving *job, sg_world *world)
{
  const sg_resolve_place *place = job->r.place.item;
  bool good = true;

  for (size_t i = 0; i < job->r.place.n && good; i++) {
    good = sg_resolving_goes_on(call, i) &&
           (!sg_resolving_changes(job, &place[i]) ||
            keep(call, world, SG_V, SG_LEAF_V, place[i].s, place[i].name));
  }
  for (size_t i = 0; i < job->polygon.n && good; i++) {
    const sg_resolved_polygon *polygon = &job->polygon.item[i];
    good = sg_resolving_goes_on(call, i) &&
           keep_leaf(call, world, polygon->s, polygon->p);
  }
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

  if (!sg_world_claim(world, &call->poll)) {
    return false;
  }
  bool good = write_all(call, job, world);

  sg_world_release(world);
  return good;
}
