/* shape_rows.c -- shape_write/4: the shape of a primitive into the world.
 *
 * Layer: rows. polygon_list.pl says what a vertex list is.
 */
#include "mesh_rows.h"

#include "doors/world.h"
#include "rows/key_table.h"

#include <limits.h>
#include <math.h>
#include <string.h>

typedef struct chains {
  sg_call *call;
  int32_t vertices;
  sg_int_list from, to; /* of the directed edges, vertices from 0 */
  sg_int_list start;    /* the first edge of each chain, and the end */
  int32_t *open;        /* [vertices]: edges that start less those that end */
  sg_key_table edge;    /* of the chain in hand: chain, from, to */
} chains;

static bool
add_edge(chains *c, int32_t from, int32_t to)
{
  return from >= 1 && from <= c->vertices && to >= 1 && to <= c->vertices &&
         sg_int_list_add(c->call, &c->from, from - 1) &&
         sg_int_list_add(c->call, &c->to, to - 1);
}

/* The edges of a vertex list, as vertex_list_edges/2 has them; of a curve, one
 * from each vertex to the next. */
static bool
add_chain(chains *c, const sg_int_list *chain, bool closed)
{
  int32_t from = chain->n > 0 ? chain->at[0] : 0;
  bool jumps = false, good = from > 0;

  for (size_t i = 1; i < chain->n && good; i++) {
    int32_t v = chain->at[i];

    if (v > 0) {
      good = add_edge(c, from, v);
      from = v;
    } else { /* a jump, to where an edge starts */
      jumps = true;
      good = closed && i + 1 < chain->n && chain->at[i + 1] > 0 && v > -INT_MAX;
      from = good ? -v : 0;
    }
  }
  return good && (!closed || jumps || from == chain->at[0] ||
                  add_edge(c, from, chain->at[0]));
}

/* Whether the edges from `first` on are the border of a polygon, as
 * polygon_fault/2 says. */
static bool
is_border(chains *c, size_t first, size_t chain)
{
  size_t end = c->from.n;
  bool good = end - first >= 3;

  for (size_t i = first; i < end && good; i++) {
    int32_t a = c->from.at[i], b = c->to.at[i];
    uint32_t *known = sg_key_table_put(
        &c->edge,
        (const uint32_t[3]){(uint32_t)chain, (uint32_t)a, (uint32_t)b});

    if (!known) {
      return sg_call_no_memory(c->call);
    }
    good = *known == SG_NO_KEY && a != b;
    *known = 1;
    c->open[a]++;
    c->open[b]--;
  }
  for (size_t i = first; i < end && good; i++) {
    good = c->open[c->from.at[i]] == 0;
  }
  return good;
}

static bool
add_chains(chains *c, const sg_list_int_list *lists, bool closed)
{
  for (size_t i = 0; i < lists->n; i++) {
    size_t first = c->from.n;

    if (!sg_int_list_add(c->call, &c->start, (int32_t)first) ||
        !add_chain(c, &lists->at[i], closed) ||
        (closed && !is_border(c, first, i)) || c->from.n > INT_MAX) {
      return false;
    }
  }
  return sg_int_list_add(c->call, &c->start, (int32_t)c->from.n);
}

static bool
is_in_bounds(sg_call *call, const sg_point_list *points)
{
  for (size_t i = 0; i < points->n; i++) {
    for (int k = 0; k < 3; k++) {
      if (fabs(points->at[i].at[k]) > sg_relation_table[SG_V].most[2 + k]) {
        sg_call_domain(call, "coordinate", 2);
        return sg_call_at(call, i + 1, k + 1);
      }
    }
  }
  return true;
}

static bool
write_shape(chains *c, sg_point_list *points, bool closed, int32_t s)
{
  sg_call *call = c->call;
  const sg_mesh mesh = {.vertices = points->n,
                        .vertex = (double(*)[3])points->at};
  sg_mesh_part part = {.vertices = points->n,
                       .faces = closed ? c->start.n - 1 : 0,
                       .start = (const uint32_t *)c->start.at,
                       .edges = c->from.n,
                       .from = c->from.at,
                       .to = c->to.at};
  int32_t *vertex = sg_call_alloc(call, points->n * sizeof *vertex);
  sg_world *world = vertex ? sg_call_claim(call) : NULL;

  if (!world) {
    return false;
  }
  for (size_t i = 0; i < points->n; i++) {
    vertex[i] = (int32_t)i;
  }
  part.vertex = vertex;
  bool good = sg_mesh_add_part(call, world, &mesh, &part, s);

  sg_world_release(world);
  return good;
}

bool
sg_door_shape_write(sg_call *call, int32_t s, const sg_point_list *points,
                    const sg_list_int_list *lists, bool closed)
{
  chains c = {.call = call, .vertices = (int32_t)points->n};
  size_t bytes = points->n * sizeof *c.open;
  sg_point_list at = {points->at, points->n, 0};

  sg_key_table_init(&c.edge, 3);
  c.open = sg_call_alloc(call, bytes);
  if (c.open) {
    memset(c.open, 0, bytes);
  }
  bool good = c.open && points->n <= INT_MAX && is_in_bounds(call, points) &&
              add_chains(&c, lists, closed) && write_shape(&c, &at, closed, s);

  sg_key_table_clear(&c.edge);
  return good;
}
