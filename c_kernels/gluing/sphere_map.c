/* sphere_map.c -- see sphere_map.h.
 *
 * All is seen from a base, a direction that lies in no plane at hand. What a
 * disk has there is its own outside; it goes round another one if that is not
 * in its outside. Those that go round one are in each other: the innermost of
 * them has the zone that the one is in.
 *
 * Where an arc from the base ends is told by counting: each arc that is crossed
 * takes one off the cycle it leaves, and adds one to that it enters.
 */
#include "sphere_map.h"

#include "engine/list.h"
#include "number/exact.h"
#include "rows/disjoint.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define NONE UINT32_MAX

/* Disk `outer` goes round disk `inner`, which is at `cycle` of it. */
typedef struct nesting {
  uint32_t inner, outer, cycle;
} nesting;

typedef struct mapper {
  const sg_sphere_map *map;
  double base[3];
  signed char *side; /* [arcs] 1: the base is below it */
  int *count;        /* [cycles] */
  uint32_t *outside; /* [disks] the cycle at the base */
  uint32_t *depth;   /* [disks] how many go round it */
  nesting *round;
  size_t rounds, room;
} mapper;

/* 1: p is below the triangle of the apex, a and b; -1: above. */
static int
side_of(const sg_sphere_map *map, const double *a, const double *b,
        const sg_point *p)
{
  sg_point v = {{map->apex[0], map->apex[1], map->apex[2]}, NULL};
  sg_point x = {{a[0], a[1], a[2]}, NULL}, y = {{b[0], b[1], b[2]}, NULL};

  return sg_point_orient3d(&v, &x, &y, p);
}

/* The point half way from a to b, exactly. False: no memory. */
static bool
middle_of(const double *a, const double *b, sg_point *out)
{
  mpq_t q[3], other;
  bool made;

  mpq_init(other);
  for (int k = 0; k < 3; k++) {
    mpq_init(q[k]);
    mpq_set_d(q[k], a[k]);
    mpq_set_d(other, b[k]);
    mpq_add(q[k], q[k], other);
    mpq_div_2exp(q[k], q[k], 1);
  }
  made = sg_point_set_q(out, q[0], q[1], q[2]);
  for (int k = 0; k < 3; k++) {
    mpq_clear(q[k]);
  }
  mpq_clear(other);
  return made;
}

/* ---- the base ---- */

static double
reach_of(const sg_sphere_map *map)
{
  double reach = 0;

  for (size_t i = 0; i < map->disks; i++) {
    for (int k = 0; k < 3; k++) {
      reach = fmax(reach, fabs(map->point[i][k] - map->apex[k]));
    }
  }
  return reach;
}

/* Try number n: anything, always the same. */
static void
choose_base(mapper *m, unsigned n)
{
  double reach = reach_of(m->map);
  uint32_t bits = 2463534242u + 0x9e3779b9u * n;

  for (int k = 0; k < 3; k++) {
    bits ^= bits << 13;
    bits ^= bits >> 17;
    bits ^= bits << 5;
    m->base[k] = m->map->apex[k] + reach * ((double)bits / 0x1p31 - 1);
  }
}

/* False: the base is in a plane of an arc that divides something. */
static bool
find_sides(mapper *m)
{
  const sg_sphere_map *map = m->map;

  for (size_t i = 0; i < map->arcs; i++) {
    const sg_sphere_arc *arc = &map->arc[i];

    if (arc->below != arc->above) {
      m->side[i] = (signed char)sg_orient3d(map->apex, arc->a, arc->b, m->base);
      if (m->side[i] == 0) {
        return false;
      }
    }
  }
  return true;
}

/* ---- crossings ---- */

/* Counts where the arc from the base to p crosses arc i. False: it meets an
 * end of it, or p is opposite. */
static bool
cross(mapper *m, size_t i, const sg_point *p)
{
  const sg_sphere_map *map = m->map;
  const sg_sphere_arc *arc = &map->arc[i];

  if (arc->below == arc->above ||
      side_of(map, arc->a, arc->b, p) != -m->side[i]) {
    return true;
  }
  /* The turn of base, p and x is that of x, base and p. */
  int a = side_of(map, arc->a, m->base, p);
  int b = side_of(map, arc->b, m->base, p);
  if (a == 0 || b == 0) {
    return false;
  }
  if (a != b && a == -m->side[i]) {
    m->count[m->side[i] > 0 ? arc->below : arc->above]--;
    m->count[m->side[i] > 0 ? arc->above : arc->below]++;
  }
  return true;
}

/* The cycle of disk i with this count, or `none`. */
static uint32_t
counted(const mapper *m, size_t i, int count, uint32_t none)
{
  const sg_sphere_map *map = m->map;

  for (uint32_t k = map->first_arc[i]; k < map->first_arc[i + 1]; k++) {
    const sg_sphere_arc *arc = &map->arc[k];

    if (arc->below != arc->above && m->count[arc->below] == count) {
      return arc->below;
    }
    if (arc->below != arc->above && m->count[arc->above] == count) {
      return arc->above;
    }
  }
  return none;
}

static void
forget_counts(mapper *m)
{
  memset(m->count, 0, m->map->cycles * sizeof *m->count);
}

/* What disk i has at the base. It is asked along an arc to the middle of the
 * first of its arcs that divides something. */
static bool
find_outside(mapper *m, size_t i, bool *generic)
{
  const sg_sphere_map *map = m->map;
  size_t first = map->first_arc[i], end = map->first_arc[i + 1], at = first;
  sg_point p;

  m->outside[i] = map->any_cycle[i];
  while (at < end && map->arc[at].below == map->arc[at].above) {
    at++;
  }
  if (at == end) {
    return true;
  }
  const sg_sphere_arc *arc = &map->arc[at];
  uint32_t here = m->side[at] > 0 ? arc->below : arc->above;
  if (!middle_of(arc->a, arc->b, &p)) {
    return false;
  }
  forget_counts(m);
  for (size_t k = first; k < end && *generic; k++) {
    *generic = k == at || cross(m, k, &p);
  }
  m->outside[i] = counted(m, i, -1, here);
  sg_point_clear(&p);
  return true;
}

/* ---- which goes round which ---- */

static bool
look_from(mapper *m, size_t j, bool *generic)
{
  const sg_sphere_map *map = m->map;

  sg_point p;

  sg_point_set(&p, map->point[j]);
  forget_counts(m);
  for (size_t k = 0; k < map->arcs && *generic; k++) {
    *generic = map->arc[k].disk == j || cross(m, k, &p);
  }
  for (size_t i = 0; i < map->disks && *generic; i++) {
    uint32_t at = counted(m, i, 1, NONE);

    if (i != j && at != NONE) {
      if (!sg_list_grow(&m->round, m->rounds, &m->room, sizeof *m->round)) {
        return false;
      }
      m->round[m->rounds++] = (nesting){(uint32_t)j, (uint32_t)i, at};
      m->depth[j]++;
    }
  }
  return true;
}

/* *generic: false if another base is to be tried. */
static bool
look(mapper *m, bool *generic)
{
  size_t n = m->map->disks;

  memset(m->depth, 0, n * sizeof *m->depth);
  m->rounds = 0;
  *generic = find_sides(m);
  for (size_t i = 0; i < n && *generic; i++) {
    if (!find_outside(m, i, generic)) {
      return false;
    }
  }
  for (size_t j = 0; j < n && *generic; j++) {
    if (!look_from(m, j, generic)) {
      return false;
    }
  }
  return true;
}

static void
join_zones(const mapper *m, uint32_t *zone)
{
  const sg_sphere_map *map = m->map;
  uint32_t open = NONE;

  for (size_t i = 0; i < map->disks; i++) {
    if (m->depth[i] == 0) {
      open = open == NONE ? m->outside[i] : open;
      sg_disjoint_join(zone, open, m->outside[i]);
    }
  }
  for (size_t i = 0; i < m->rounds; i++) {
    const nesting *r = &m->round[i];

    if (m->depth[r->outer] + 1 == m->depth[r->inner]) {
      sg_disjoint_join(zone, r->cycle, m->outside[r->inner]);
    }
  }
  for (uint32_t c = 0; c < map->cycles; c++) {
    zone[c] = sg_disjoint_root(zone, c);
  }
}

bool
sg_sphere_map_zones(const sg_sphere_map *map, uint32_t *zone)
{
  mapper m = {.map = map};
  bool generic = false, done;

  for (uint32_t c = 0; c < map->cycles; c++) {
    zone[c] = c;
  }
  m.side = calloc(map->arcs + 1, 1);
  m.count = calloc(map->cycles + 1, sizeof *m.count);
  m.outside = calloc(map->disks + 1, sizeof *m.outside);
  m.depth = calloc(map->disks + 1, sizeof *m.depth);
  done = m.side && m.count && m.outside && m.depth;
  for (unsigned n = 0; n < 64 && done && !generic; n++) {
    choose_base(&m, n);
    done = look(&m, &generic);
  }
  if (done) {
    join_zones(&m, zone);
  }
  free(m.side);
  free(m.count);
  free(m.outside);
  free(m.depth);
  free(m.round);
  return done;
}
