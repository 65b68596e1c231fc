/* regions_count.c -- regions, shells and what they have (regions_private.h). */
#include "regions_private.h"

#include "engine/search.h"
#include "number/vector.h"
#include "rows/disjoint.h"

#include <math.h>
#include <stdlib.h>

typedef struct counter {
  sg_regions_maker *m;
  uint32_t *name;   /* [elements] of a root: its region, or SG_NOWHERE */
  uint32_t *seen;   /* [regions] the last polygon */
  uint32_t outside; /* a root */
} counter;

static bool
is_there(const sg_regions_maker *m, uint32_t element)
{
  return element >= 2 * m->d->polygons || m->is_face[element / 2];
}

/* ---- regions ---- */

/* last[] of each bounded region becomes the side that it is numbered by: of
 * those where it is behind a face the last one; if there is none, of all.
 * Counts regions. */
static void
find_last_sides(const counter *c, uint32_t *last)
{
  sg_regions_maker *m = c->m;

  for (uint32_t i = 0; i < m->elements; i++) {
    last[i] = c->name[i] = SG_NOWHERE;
  }
  for (uint32_t above = 0; above < 2; above++) {
    for (size_t p = m->d->polygons; p-- > 0;) {
      uint32_t side = 2 * (uint32_t)p + above;
      uint32_t root = sg_disjoint_root(m->zone, side);

      if (m->is_face[p] && root != c->outside && last[root] == SG_NOWHERE) {
        last[root] = side;
        m->out->regions++;
      }
    }
  }
}

/* The bounded ones in the order of these sides, then the outside. */
static bool
name_regions(counter *c)
{
  sg_regions_maker *m = c->m;
  sg_regions *out = m->out;
  size_t sides = 2 * m->d->polygons;

  uint32_t *last = malloc((m->elements + 1) * sizeof *last);

  c->name = malloc((m->elements + 1) * sizeof *c->name);
  if (!c->name || !last) {
    free(last);
    return sg_regions_no_memory(m);
  }
  find_last_sides(c, last);
  size_t left = out->regions;

  for (size_t side = sides; side-- > 0 && left > 0;) {
    uint32_t root = sg_disjoint_root(m->zone, (uint32_t)side);

    if (last[root] == side) {
      c->name[root] = (uint32_t)--left;
    }
  }
  free(last);
  if (c->outside != SG_NOWHERE) {
    c->name[c->outside] = (uint32_t)out->regions;
  }
  out->regions++;
  out->region = calloc(out->regions, sizeof *out->region);
  c->seen = calloc(out->regions, sizeof *c->seen);
  if (!out->region || !c->seen) {
    return sg_regions_no_memory(m);
  }
  for (size_t i = 0; i + 1 < out->regions; i++) {
    out->region[i].role = SG_REGION_CELL;
  }
  return true;
}

static uint32_t
region_of(const counter *c, uint32_t element)
{
  return c->name[sg_disjoint_root(c->m->zone, element)];
}

static bool
list_sides(counter *c)
{
  sg_regions_maker *m = c->m;
  sg_regions *out = m->out;

  out->side = malloc((2 * m->d->polygons + 1) * sizeof *out->side);
  if (!out->side) {
    return sg_regions_no_memory(m);
  }
  for (uint32_t i = 0; i < 2 * m->d->polygons; i++) {
    out->side[i] = SG_NOWHERE;
    if (!is_there(m, i)) {
      continue;
    }
    uint32_t r = out->side[i] = region_of(c, i);
    sg_space_region *region = &out->region[r];

    region->faces += c->seen[r] != i / 2 + 1;
    region->behind += i % 2 == 0;
    c->seen[r] = i / 2 + 1;
    if (m->slit[i]) {
      region->role = SG_REGION_SLIT;
    }
    out->faces += i % 2;
    out->loops += i % 2 ? m->loops[i / 2] : 0;
  }
  return true;
}

static bool
list_wires(counter *c)
{
  sg_regions_maker *m = c->m;
  sg_regions *out = m->out;

  out->wire = malloc((m->wires + 1) * sizeof *out->wire);
  out->lone_vertex = malloc((m->lone + 1) * sizeof *out->lone_vertex);
  if (!out->wire || !out->lone_vertex) {
    return sg_regions_no_memory(m);
  }
  for (size_t i = 0; i < m->wires; i++) {
    uint32_t r = region_of(c, sg_element_of_wire(m, i));
    out->wire[out->wires++] = (sg_wire){m->wire_edge[i], r};
    out->region[r].wires++;
  }
  for (size_t i = 0; i < m->lone; i++) {
    uint32_t r = region_of(c, sg_element_of_lone(m, i));
    out->lone_vertex[out->lone++] = (sg_lone_vertex){m->lone_at[i], r};
    out->region[r].lone++;
  }
  return true;
}

/* ---- shells ---- */

static void
name_shell(const sg_regions_maker *m, uint32_t element, sg_region_shell *shell)
{
  size_t wires = 2 * m->d->polygons, lone = wires + m->wires;

  shell->polygon = element < wires ? (int32_t)(element / 2) : -1;
  shell->edge = element >= wires && element < lone
                    ? (int32_t)m->wire_edge[element - wires]
                    : -1;
}

SG_ORDER(compare_shells, sg_region_shell, SG_BY(region) SG_BY(first));

static void
add_genus(sg_regions *out)
{
  for (size_t i = 0; i < out->shells; i++) {
    const sg_region_shell *shell = &out->shell[i];
    int64_t twice = 2 - shell->euler;

    out->region[shell->region].shells++;
    out->twisted += twice < 0 || twice % 2 != 0;
    out->genus += twice / 2;
    out->region[shell->region].genus += twice / 2;
  }
}

static bool
list_shells(counter *c)
{
  sg_regions_maker *m = c->m;
  sg_regions *out = m->out;
  uint32_t *number = malloc((m->elements + 1) * sizeof *number);

  for (uint32_t i = 0; number && i < m->elements; i++) {
    out->shells += is_there(m, i) && sg_disjoint_root(m->shell, i) == i;
  }
  out->shell = calloc(out->shells + 1, sizeof *out->shell);
  if (!number || !out->shell) {
    free(number);
    return sg_regions_no_memory(m);
  }
  out->shells = 0;
  for (uint32_t i = 0; i < m->elements; i++) {
    uint32_t root = sg_disjoint_root(m->shell, i);

    if (!is_there(m, i)) {
      continue;
    }
    if (root == i) {
      number[i] = (uint32_t)out->shells;
      out->shell[out->shells].region = region_of(c, i);
      out->shell[out->shells].first = i;
      name_shell(m, i, &out->shell[out->shells++]);
    }
    out->twisted += region_of(c, i) != region_of(c, root);
    out->shell[number[root]].euler += m->euler[i];
  }
  free(number);
  if (out->shells > 1) {
    qsort(out->shell, out->shells, sizeof *out->shell, compare_shells);
  }
  add_genus(out);
  return true;
}

/* ---- measures ---- */

static void
measure(counter *c)
{
  sg_regions *out = c->m->out;
  const sg_dense *d = c->m->d;
  const double *o = d->vertices ? d->at[0] : NULL;

  for (size_t t = 0; t < d->triangles; t++) {
    uint32_t p = (uint32_t)d->polygon_of[t];
    double a[3], b[3], e[3], n[3];

    if (!c->m->is_face[p]) {
      continue;
    }
    sg_minus(d->at[d->corner[t][1]], d->at[d->corner[t][0]], a);
    sg_minus(d->at[d->corner[t][2]], d->at[d->corner[t][0]], b);
    sg_minus(d->at[d->corner[t][0]], o, e);
    sg_cross(a, b, n);
    for (int side = 0; side < 2; side++) {
      sg_space_region *region = &out->region[out->side[2 * p + (uint32_t)side]];
      region->volume += (side == 0 ? 1 : -1) * sg_dot(e, n);
      region->area += sg_any_length(n) / 2;
    }
  }
  for (size_t r = 0; r < out->regions; r++) {
    bool none = r + 1 == out->regions || out->region[r].role == SG_REGION_SLIT;
    out->region[r].volume = none ? 0 : out->region[r].volume / 6;
  }
}

/* Connected parts of all there is. */
static bool
count_parts(counter *c)
{
  sg_regions_maker *m = c->m;
  uint32_t *set = malloc((m->d->vertices + 1) * sizeof *set);

  if (!set) {
    return sg_regions_no_memory(m);
  }
  for (uint32_t v = 0; v < m->d->vertices; v++) {
    set[v] = v;
  }
  for (size_t i = 0; i < m->edges; i++) {
    sg_disjoint_join(set, m->low[i], m->high[i]);
  }
  for (uint32_t k = 0; k < m->corners; k++) {
    uint32_t p = m->polygon[k];
    if (m->is_face[p]) {
      sg_disjoint_join(set, sg_corner_vertex(m, k),
                       sg_corner_vertex(m, m->d->list_begin[p]));
    }
  }
  for (uint32_t v = 0; v < m->d->vertices; v++) {
    m->out->parts += set[v] == v;
  }
  free(set);
  return true;
}

bool
sg_regions_count(sg_regions_maker *m, uint32_t outside)
{
  counter c = {.m = m,
               .outside = outside == SG_NOWHERE
                              ? SG_NOWHERE
                              : sg_disjoint_root(m->zone, outside)};
  bool good = name_regions(&c) && list_sides(&c) && list_wires(&c) &&
              list_shells(&c) && count_parts(&c);

  m->out->vertices = m->d->vertices;
  m->out->edges = m->edges;
  if (good) {
    measure(&c);
  }
  free(c.name);
  free(c.seen);
  return good;
}
