/* regions_vertex.c -- disks and zones at vertices, and shells
 * (regions_private.h).
 *
 * A vertex with one disk has a zone for each cycle. Where there are several,
 * the sphere map says which cycles bound a zone together.
 */
#include "regions_private.h"

#include "engine/list.h"
#include "engine/search.h"
#include "number/exact.h"
#include "number/vector.h"
#include "rows/disjoint.h"
#include "sphere_map.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* At one vertex: things by number, for a short time. */
typedef struct names {
  uint32_t *of; /* [n] ascending */
  size_t n, room;
} names;

typedef struct disks {
  sg_regions_maker *m;
  uint32_t *end;     /* [2 * edges] their ends, disjoint sets */
  uint32_t *count;   /* [vertices] disks */
  uint32_t *begin;   /* [crowded + 1] */
  uint32_t *item;    /* corners, then wires, of crowded vertices */
  uint32_t *crowded; /* [vertices] which it is, or SG_NOWHERE */
  uint32_t *vertex;  /* [crowded] */
  size_t crowds;
  names disk, cycle; /* cycles: sides of corners, then wires */
  sg_sphere_arc *arc, *sorted;
  size_t arcs, arc_room, sorted_room;
  uint32_t *first, *any, *zone, *size;
  const double **point;
  size_t disk_room, zone_room;
} disks;

static uint32_t
end_at(const sg_regions_maker *m, uint32_t edge, uint32_t v)
{
  return 2 * edge + (m->low[edge] != v);
}

/* The disk of a corner or a wire, by an end of an edge, or a number above. */
static uint32_t
disk_of(const disks *x, uint32_t item, uint32_t v)
{
  const sg_regions_maker *m = x->m;

  return item < m->entries
             ? sg_disjoint_root(x->end, end_at(m, m->edge_of[item], v))
         : item < m->corners ? (uint32_t)(2 * m->edges + (item - m->entries))
                             : end_at(m, m->wire[item - m->corners], v);
}

/* The element of a cycle. */
static uint32_t
element_of(const sg_regions_maker *m, uint32_t cycle)
{
  return cycle < 2 * m->corners ? 2 * m->polygon[cycle / 2] + cycle % 2
                                : sg_element_of_wire(m, cycle - 2 * m->corners);
}

static bool
is_corner(const sg_regions_maker *m, size_t k)
{
  return k >= m->entries || m->is_face[m->polygon[k]];
}

/* ---- which vertices have several ---- */

static bool
count_disks(disks *x)
{
  sg_regions_maker *m = x->m;

  x->end = malloc((2 * m->edges + 1) * sizeof *x->end);
  x->count = calloc(m->d->vertices + 1, sizeof *x->count);
  x->crowded = malloc((m->d->vertices + 1) * sizeof *x->crowded);
  if (!x->end || !x->count || !x->crowded) {
    return sg_regions_no_memory(m);
  }
  for (uint32_t i = 0; i < 2 * m->edges; i++) {
    x->end[i] = i;
  }
  for (uint32_t i = 0; i < m->entries; i++) {
    if (is_corner(m, i)) {
      uint32_t v = sg_corner_vertex(m, i);
      sg_disjoint_join(x->end, end_at(m, m->edge_of[i], v),
                       end_at(m, m->edge_of[m->before[i]], v));
    }
  }
  for (uint32_t i = 0; i < 2 * m->edges; i++) {
    if (x->end[i] == i) {
      x->count[i % 2 ? m->high[i / 2] : m->low[i / 2]]++;
    }
  }
  for (size_t i = 0; i < m->point_loops; i++) {
    x->count[m->point_loop[i].v]++;
  }
  return true;
}

static bool
list_lone(disks *x)
{
  sg_regions_maker *m = x->m;

  m->lone_at = malloc((m->d->vertices + 1) * sizeof *m->lone_at);
  if (!m->lone_at) {
    return sg_regions_no_memory(m);
  }
  for (uint32_t v = 0; v < m->d->vertices; v++) {
    if (x->count[v] == 0) {
      m->euler[sg_element_of_lone(m, m->lone)] = 2;
      m->lone_at[m->lone++] = v;
    }
  }
  m->elements = 2 * m->d->polygons + m->wires + m->lone;
  m->shell = malloc((m->elements + 1) * sizeof *m->shell);
  if (!m->shell) {
    return sg_regions_no_memory(m);
  }
  memcpy(m->shell, m->zone, m->elements * sizeof *m->shell);
  return true;
}

/* Calls `take` for each corner and each end of a wire. */
typedef void take_item(disks *x, uint32_t item, uint32_t v);

static void
each_item(disks *x, take_item *take)
{
  const sg_regions_maker *m = x->m;

  for (uint32_t k = 0; k < m->corners; k++) {
    if (is_corner(m, k)) {
      take(x, k, sg_corner_vertex(m, k));
    }
  }
  for (uint32_t i = 0; i < m->wires; i++) {
    take(x, (uint32_t)m->corners + i, m->low[m->wire[i]]);
    take(x, (uint32_t)m->corners + i, m->high[m->wire[i]]);
  }
}

/* Of a vertex with one disk each cycle is a zone. */
static void
count_item(disks *x, uint32_t item, uint32_t v)
{
  sg_regions_maker *m = x->m;

  if (x->count[v] > 1) {
    x->begin[x->crowded[v] + 1]++;
  } else if (item >= m->corners) {
    m->euler[sg_element_of_wire(m, item - m->corners)]++;
  } else {
    for (uint32_t c = 2 * item; c < 2 * item + 2; c++) {
      m->euler[element_of(m, c)] += m->cycle[c] == c;
    }
  }
}

static void
put_item(disks *x, uint32_t item, uint32_t v)
{
  if (x->count[v] > 1) {
    x->item[x->begin[x->crowded[v]]++] = item;
  }
}

static bool
list_crowded(disks *x)
{
  sg_regions_maker *m = x->m;

  for (uint32_t v = 0; v < m->d->vertices; v++) {
    x->crowded[v] = x->count[v] > 1 ? (uint32_t)x->crowds++ : SG_NOWHERE;
  }
  x->begin = calloc(x->crowds + 2, sizeof *x->begin);
  x->vertex = malloc((x->crowds + 1) * sizeof *x->vertex);
  if (!x->begin || !x->vertex) {
    return sg_regions_no_memory(m);
  }
  for (uint32_t v = 0; v < m->d->vertices; v++) {
    if (x->crowded[v] != SG_NOWHERE) {
      x->vertex[x->crowded[v]] = v;
    }
  }
  each_item(x, count_item);
  for (size_t i = 0; i < x->crowds; i++) {
    x->begin[i + 1] += x->begin[i];
  }
  x->item = malloc((x->begin[x->crowds] + 1) * sizeof *x->item);
  if (!x->item) {
    return sg_regions_no_memory(m);
  }
  each_item(x, put_item);
  for (size_t i = x->crowds; i > 0; i--) {
    x->begin[i] = x->begin[i - 1];
  }
  x->begin[0] = 0;
  return true;
}

/* ---- one vertex: names ---- */

static bool
add_name(disks *x, names *list, uint32_t of)
{
  if (!sg_list_grow(&list->of, list->n, &list->room, sizeof *list->of)) {
    return sg_regions_no_memory(x->m);
  }
  list->of[list->n++] = of;
  return true;
}

static void
settle(names *list)
{
  size_t n = 0;

  if (list->n > 0) {
    qsort(list->of, list->n, sizeof *list->of, sg_compare_numbers);
  }
  for (size_t i = 0; i < list->n; i++) {
    if (i == 0 || list->of[i] != list->of[i - 1]) {
      list->of[n++] = list->of[i];
    }
  }
  list->n = n;
}

static uint32_t
number_of(const names *list, uint32_t of)
{
  size_t at;

  SG_SEARCH(at, 0, list->n, list->of[at] < of);
  return (uint32_t)at;
}

static bool
name_all(disks *x, size_t i)
{
  sg_regions_maker *m = x->m;
  bool good = true;

  x->disk.n = x->cycle.n = 0;
  for (uint32_t k = x->begin[i]; k < x->begin[i + 1] && good; k++) {
    uint32_t item = x->item[k];

    good = add_name(x, &x->disk, disk_of(x, item, x->vertex[i]));
    if (item >= m->corners) {
      good = good && add_name(x, &x->cycle, (uint32_t)(m->corners + item));
    } else {
      good = good &&
             add_name(x, &x->cycle, sg_disjoint_root(m->cycle, 2 * item)) &&
             add_name(x, &x->cycle, sg_disjoint_root(m->cycle, 2 * item + 1));
    }
  }
  settle(&x->disk);
  settle(&x->cycle);
  return good;
}

/* ---- one vertex: arcs ---- */

static bool
add_arc(disks *x, uint32_t disk, uint32_t corner, int32_t a, int32_t b)
{
  sg_regions_maker *m = x->m;

  if (!sg_list_grow(&x->arc, x->arcs, &x->arc_room, sizeof *x->arc)) {
    return sg_regions_no_memory(m);
  }
  x->arc[x->arcs++] = (sg_sphere_arc){
      m->d->at[a], m->d->at[b], disk,
      number_of(&x->cycle, sg_disjoint_root(m->cycle, 2 * corner)),
      number_of(&x->cycle, sg_disjoint_root(m->cycle, 2 * corner + 1))};
  return true;
}

/* Over the triangles of a corner, from its edge to the one before. */
static bool
add_corner(disks *x, uint32_t disk, uint32_t k)
{
  sg_regions_maker *m = x->m;
  const sg_dense *d = m->d;
  uint32_t p = m->polygon[k];
  int32_t v = d->from[d->list[k]], a = d->to[d->list[k]];
  int32_t end = d->from[d->list[m->before[k]]];
  uint32_t most = m->triangle_begin[p + 1] - m->triangle_begin[p];

  do {
    int32_t b = most-- > 0 ? sg_regions_third(m, p, v, a) : -1;

    if (b < 0) {
      m->end = SG_REGIONS_TRIANGLES;
      m->bad = p;
      return false;
    }
    if (!add_arc(x, disk, k, a, b)) {
      return false;
    }
    a = b;
  } while (a != end);
  return true;
}

/* How p lies to the sides of triangle t, seen along the axis that shows most of
 * it: 1 inside of side k, 0 on it, -1. */
static void
see_sides(const sg_dense *d, uint32_t t, const double *p, int inside[3])
{
  const double *at[3];
  double normal[3], most = -1;
  int axis = 0;

  for (int k = 0; k < 3; k++) {
    at[k] = d->at[d->corner[t][k]];
  }
  for (int k = 0; k < 3; k++) {
    int u = (k + 1) % 3, w = (k + 2) % 3;
    normal[k] = (at[1][u] - at[0][u]) * (at[2][w] - at[0][w]) -
                (at[1][w] - at[0][w]) * (at[2][u] - at[0][u]);
    axis = fabs(normal[k]) > most ? k : axis;
    most = fmax(most, fabs(normal[k]));
  }
  int u = (axis + 1) % 3, w = (axis + 2) % 3;
  for (int k = 0; k < 3; k++) {
    const double *a = at[k], *b = at[(k + 1) % 3];
    int turn = sg_orient2d((double[2]){a[u], a[w]}, (double[2]){b[u], b[w]},
                           (double[2]){p[u], p[w]});
    inside[k] = normal[axis] > 0 ? turn : -turn;
  }
}

/* Whether p is so near the line through vertices a and b that rounding may have
 * put it on either side. The same from both sides. */
static bool
nearly_on(const sg_dense *d, int32_t a, int32_t b, const double *p)
{
  const double *from = d->at[a < b ? a : b], *to = d->at[a < b ? b : a];
  double way[3], at[3], across[3];

  sg_minus(to, from, way);
  sg_minus(p, from, at);
  sg_cross(way, at, across);
  return sg_dot(across, across) <= 1e-18 * sg_dot(way, way) * sg_dot(way, way);
}

/* As see_sides(); a diagonal, which another triangle of polygon q has too, also
 * has what is nearly on it: beside it, and a hair above the plane, the rest of
 * the polygon is not where the triangle ends. */
static void
see_triangle(const sg_regions_maker *m, uint32_t q, uint32_t t, const double *p,
             int inside[3])
{
  const int32_t *c = m->d->corner[t];

  see_sides(m->d, t, p, inside);
  for (int k = 0; k < 3; k++) {
    int32_t a = c[k], b = c[(k + 1) % 3];

    if (inside[k] != 0 && nearly_on(m->d, a, b, p) &&
        sg_regions_third(m, q, b, a) >= 0) {
      inside[k] = 0;
    }
  }
}

/* The triangles of the polygon that have the vertex: as a corner, or where it
 * is. */
static bool
add_point_loop(disks *x, uint32_t disk, uint32_t k)
{
  sg_regions_maker *m = x->m;
  const sg_dense *d = m->d;
  uint32_t p = m->polygon[k];
  int32_t v = (int32_t)sg_corner_vertex(m, k);
  size_t before = x->arcs;

  for (uint32_t i = m->triangle_begin[p]; i < m->triangle_begin[p + 1]; i++) {
    uint32_t t = m->triangle[i];
    const int32_t *c = d->corner[t];
    bool corner = c[0] == v || c[1] == v || c[2] == v;
    int inside[3];

    see_triangle(m, p, t, d->at[v], inside);
    bool has = corner || (inside[0] >= 0 && inside[1] >= 0 && inside[2] >= 0);
    for (int s = 0; has && s < 3; s++) {
      bool opposite = corner ? c[(s + 2) % 3] == v : inside[s] > 0;
      if (opposite && !add_arc(x, disk, k, c[s], c[(s + 1) % 3])) {
        return false;
      }
    }
  }
  if (x->arcs == before) { /* it is not inside the polygon */
    m->end = SG_REGIONS_TRIANGLES;
    m->bad = p;
  }
  return x->arcs > before;
}

/* Those of vertices that need no map: each is inside its polygon. */
static bool
check_point_loops(disks *x)
{
  const sg_regions_maker *m = x->m;
  bool good = true;

  for (size_t i = 0; i < m->point_loops && good; i++) {
    x->arcs = 0;
    good = x->count[m->point_loop[i].v] > 1 ||
           add_point_loop(x, 0, (uint32_t)(m->entries + i));
  }
  return good;
}

/* ---- one vertex: zones ---- */

static bool
need_rooms(disks *x)
{
  size_t n = x->disk.n + 2, room[] = {x->disk_room, x->disk_room};
  size_t zones = x->zone_room;

  bool good =
      sg_list_need(&x->first, n, &room[0], sizeof *x->first) &&
      sg_list_need(&x->any, n, &room[1], sizeof *x->any) &&
      sg_list_need(&x->point, n, &x->disk_room, sizeof *x->point) &&
      sg_list_need(&x->zone, x->cycle.n, &zones, sizeof *x->zone) &&
      sg_list_need(&x->size, x->cycle.n, &x->zone_room, sizeof *x->size) &&
      sg_list_need(&x->sorted, x->arcs + 1, &x->sorted_room, sizeof *x->sorted);

  return good || sg_regions_no_memory(x->m);
}

static bool
add_items(disks *x, size_t i)
{
  sg_regions_maker *m = x->m;
  bool good = true;

  x->arcs = 0;
  for (uint32_t k = x->begin[i]; k < x->begin[i + 1] && good; k++) {
    uint32_t item = x->item[k];
    uint32_t disk = number_of(&x->disk, disk_of(x, item, x->vertex[i]));

    if (item < m->corners) {
      good = item < m->entries ? add_corner(x, disk, item)
                               : add_point_loop(x, disk, item);
    }
  }
  return good;
}

/* A direction and a cycle of each disk; arcs by disk. */
static void
describe_disks(disks *x, size_t i)
{
  const sg_regions_maker *m = x->m;
  uint32_t v = x->vertex[i];

  memset(x->first, 0, (x->disk.n + 2) * sizeof *x->first);
  for (uint32_t k = x->begin[i]; k < x->begin[i + 1]; k++) {
    uint32_t item = x->item[k], disk = number_of(&x->disk, disk_of(x, item, v));

    if (item >= m->corners) {
      uint32_t edge = m->wire[item - m->corners];
      x->point[disk] =
          m->d->at[m->low[edge] == v ? m->high[edge] : m->low[edge]];
      x->any[disk] = number_of(&x->cycle, (uint32_t)(m->corners + item));
    }
  }
  for (size_t k = 0; k < x->arcs; k++) {
    const sg_sphere_arc *arc = &x->arc[k];
    x->point[arc->disk] = arc->a;
    x->any[arc->disk] = arc->below;
    x->first[arc->disk + 2]++;
  }
  for (size_t k = 2; k < x->disk.n + 2; k++) {
    x->first[k] += x->first[k - 1];
  }
  for (size_t k = 0; k < x->arcs; k++) {
    x->sorted[x->first[x->arc[k].disk + 1]++] = x->arc[k];
  }
}

/* What the cycles of a zone bound is connected there. */
static void
join_shells(disks *x)
{
  sg_regions_maker *m = x->m;

  memset(x->size, 0, x->cycle.n * sizeof *x->size);
  for (size_t c = 0; c < x->cycle.n; c++) {
    x->size[x->zone[c]]++;
    sg_disjoint_join(m->shell, element_of(m, x->cycle.of[c]),
                     element_of(m, x->cycle.of[x->zone[c]]));
  }
  for (size_t c = 0; c < x->cycle.n; c++) {
    if (x->zone[c] == c) {
      m->euler[element_of(m, x->cycle.of[c])] += 2 - (int32_t)x->size[c];
    }
  }
}

/* ---- one vertex: what is told ---- */

/* The number of the cycle of a side, or SG_NOWHERE. */
static uint32_t
cycle_of_side(const disks *x, size_t i, const sg_disk_side *side)
{
  sg_regions_maker *m = x->m;

  for (uint32_t k = x->begin[i]; k < x->begin[i + 1]; k++) {
    uint32_t item = x->item[k];

    if (item >= m->corners) {
      if (m->wire_edge[item - m->corners] == side->edge) {
        return number_of(&x->cycle, (uint32_t)(m->corners + item));
      }
    } else if (item < m->entries ? (uint32_t)m->d->list[item] == side->edge
                                 : side->edge == SG_NOWHERE &&
                                       m->polygon[item] == side->polygon) {
      return number_of(&x->cycle,
                       sg_disjoint_root(m->cycle, 2 * item + side->above));
    }
  }
  return SG_NOWHERE;
}

static void
told_zones(disks *x, size_t i)
{
  const sg_zones_told *told = x->m->told;
  size_t at;

  for (uint32_t c = 0; c < x->cycle.n; c++) {
    x->zone[c] = c;
  }
  SG_SEARCH(at, 0, told->n, told->meeting[at].v < x->vertex[i]);
  for (; at < told->n && told->meeting[at].v == x->vertex[i]; at++) {
    uint32_t a = cycle_of_side(x, i, &told->meeting[at].side[0]);
    uint32_t b = cycle_of_side(x, i, &told->meeting[at].side[1]);

    if (a != SG_NOWHERE && b != SG_NOWHERE) {
      sg_disjoint_join(x->zone, a, b);
    }
  }
  for (uint32_t c = 0; c < x->cycle.n; c++) {
    x->zone[c] = sg_disjoint_root(x->zone, c);
  }
}

static bool
map_vertex(disks *x, size_t i)
{
  sg_regions_maker *m = x->m;

  if (!name_all(x, i) || !add_items(x, i) || !need_rooms(x)) {
    return false;
  }
  if (m->told) {
    told_zones(x, i);
    join_shells(x);
    return sg_regions_asked(m);
  }
  describe_disks(x, i);
  sg_sphere_map map = {.apex = m->d->at[x->vertex[i]],
                       .disks = x->disk.n,
                       .cycles = x->cycle.n,
                       .arcs = x->arcs,
                       .arc = x->sorted,
                       .first_arc = x->first,
                       .point = x->point,
                       .any_cycle = x->any};
  if (!sg_sphere_map_zones(&map, x->zone)) {
    return sg_regions_no_memory(m);
  }
  join_shells(x);
  return sg_regions_asked(m);
}

static void
clear_disks(disks *x)
{
  free(x->end);
  free(x->count);
  free(x->begin);
  free(x->item);
  free(x->crowded);
  free(x->vertex);
  free(x->disk.of);
  free(x->cycle.of);
  free(x->arc);
  free(x->sorted);
  free(x->first);
  free(x->any);
  free(x->zone);
  free(x->size);
  free(x->point);
}

bool
sg_regions_vertices(sg_regions_maker *m)
{
  disks x = {.m = m};
  bool good = count_disks(&x) && list_lone(&x) && list_crowded(&x) &&
              check_point_loops(&x);

  for (size_t i = 0; good && i < x.crowds; i++) {
    good = map_vertex(&x, i);
  }
  clear_disks(&x);
  return good;
}
