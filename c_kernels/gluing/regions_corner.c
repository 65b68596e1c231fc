/* regions_corner.c -- the corners of polygons, which follows which, and the
 * triangles there (regions_private.h).
 *
 * Where a polygon has a vertex several times, as at the end of a seam or where
 * a hole touches its border, the triangles between two edges say which of them
 * bound the same corner.
 */
#include "regions_private.h"

#include "engine/list.h"
#include "engine/search.h"
#include "rows/disjoint.h"

#include <stdlib.h>

enum { FEW = 8 }; /* triangles that are looked through one after another */

/* A side of a triangle, or an entry of a list, by its ends. */
typedef struct ends {
  int32_t from, to;
  int32_t what;
} ends;

/* A polygon at work. */
typedef struct bench {
  sg_regions_maker *m;
  size_t p, begin, end;
  ends *side; /* of its triangles, if there are many */
  size_t sides, side_room;
  ends *into; /* its entries by where they end */
  size_t room;
  uint32_t *set; /* of entries, for connected borders */
  size_t set_room;
} bench;

SG_ORDER(compare_ends, ends, SG_BY(from) SG_BY(to) SG_BY(what));

static void
sort_ends(ends *item, size_t n)
{
  if (n > 2 * FEW) {
    qsort(item, n, sizeof *item, compare_ends);
  } else {
    SG_SORT_FEW(ends, item, n, compare_ends(x, y) > 0);
  }
}

/* The first with these ends, or with this start if `to` is -1. */
static const ends *
find_ends(const ends *item, size_t n, int32_t from, int32_t to)
{
  size_t at;

  SG_SEARCH(at, 0, n,
            item[at].from < from ||
                (item[at].from == from && item[at].to < to));
  return at < n && item[at].from == from && (to < 0 || item[at].to == to)
             ? &item[at]
             : NULL;
}

/* ---- triangles ---- */

int32_t
sg_regions_third(const sg_regions_maker *m, size_t p, int32_t from, int32_t to)
{
  for (uint32_t i = m->triangle_begin[p]; i < m->triangle_begin[p + 1]; i++) {
    const int32_t *v = m->d->corner[m->triangle[i]];

    for (int k = 0; k < 3; k++) {
      if (v[k] == from && v[(k + 1) % 3] == to) {
        return v[(k + 2) % 3];
      }
    }
  }
  return -1;
}

static bool
list_sides(bench *b)
{
  const sg_regions_maker *m = b->m;
  uint32_t first = m->triangle_begin[b->p], end = m->triangle_begin[b->p + 1];

  b->sides = 0;
  if (end - first <= FEW) {
    return true;
  }
  if (!sg_list_need(&b->side, 3 * (size_t)(end - first), &b->side_room,
                    sizeof *b->side)) {
    return sg_regions_no_memory(b->m);
  }
  for (uint32_t i = first; i < end; i++) {
    const int32_t *v = m->d->corner[m->triangle[i]];

    for (int k = 0; k < 3; k++) {
      b->side[b->sides++] = (ends){v[k], v[(k + 1) % 3], v[(k + 2) % 3]};
    }
  }
  sort_ends(b->side, b->sides);
  return true;
}

static int32_t
third(const bench *b, int32_t from, int32_t to)
{
  if (b->sides == 0) {
    return sg_regions_third(b->m, b->p, from, to);
  }
  const ends *found = find_ends(b->side, b->sides, from, to);
  return found ? found->what : -1;
}

/* ---- what comes before ---- */

/* The entry before entry i: over the triangles from i on, to the first edge
 * that ends at the vertex. SG_NOWHERE: there is none. */
static uint32_t
turn_to_before(const bench *b, size_t i)
{
  const sg_dense *d = b->m->d;
  size_t n = b->end - b->begin;
  uint32_t first = b->m->triangle_begin[b->p];
  int32_t v = d->from[d->list[i]], x = d->to[d->list[i]];

  for (uint32_t k = first; k < b->m->triangle_begin[b->p + 1]; k++) {
    x = third(b, v, x);
    if (x < 0) {
      return SG_NOWHERE;
    }
    const ends *entry = find_ends(b->into, n, v, x);
    if (entry) {
      return (uint32_t)entry->what;
    }
  }
  return SG_NOWHERE;
}

static bool
fail(bench *b, sg_regions_end end)
{
  b->m->end = end;
  b->m->bad = b->p;
  return false;
}

static bool
link_entries(bench *b)
{
  sg_regions_maker *m = b->m;
  const sg_dense *d = m->d;
  size_t n = b->end - b->begin;

  for (size_t i = b->begin; i < b->end; i++) {
    b->into[i - b->begin] =
        (ends){d->to[d->list[i]], d->from[d->list[i]], (int32_t)i};
    m->next[i] = SG_NOWHERE;
  }
  sort_ends(b->into, n);
  for (size_t i = b->begin; i < b->end; i++) {
    const ends *in = find_ends(b->into, n, d->from[d->list[i]], -1);
    bool several = in && in + 1 < b->into + n && in[1].from == in->from;
    uint32_t before = !in       ? SG_NOWHERE
                      : several ? turn_to_before(b, i)
                                : (uint32_t)in->what;

    if (before == SG_NOWHERE || m->next[before] != SG_NOWHERE) {
      return fail(b, in ? SG_REGIONS_TRIANGLES : SG_REGIONS_OPEN);
    }
    m->before[i] = before;
    m->next[before] = (uint32_t)i;
  }
  return true;
}

/* ---- one polygon ---- */

/* Connected parts of the border; those that touch in a vertex are one. */
static bool
count_loops(bench *b)
{
  sg_regions_maker *m = b->m;
  size_t n = b->end - b->begin;

  if (!sg_list_need(&b->set, n, &b->set_room, sizeof *b->set)) {
    return sg_regions_no_memory(m);
  }
  for (uint32_t i = 0; i < n; i++) {
    b->set[i] = i;
  }
  for (uint32_t i = 0; i < n; i++) {
    sg_disjoint_join(b->set, i, m->next[b->begin + i] - (uint32_t)b->begin);
    if (i > 0 && b->into[i].from == b->into[i - 1].from) {
      sg_disjoint_join(b->set, (uint32_t)b->into[i].what - (uint32_t)b->begin,
                       (uint32_t)b->into[i - 1].what - (uint32_t)b->begin);
    }
  }
  for (uint32_t i = 0; i < n; i++) {
    m->loops[b->p] += b->set[i] == i;
  }
  return true;
}

static int
compare_places(const sg_dense *d, int32_t a, int32_t b)
{
  for (int k = 0; k < 3; k++) {
    if (d->at[a][k] != d->at[b][k]) {
      return d->at[a][k] < d->at[b][k] ? -1 : 1;
    }
  }
  return 0;
}

/* The lower of two vertices, by place; a may be -1, none. */
static int32_t
lower_of(const sg_dense *d, int32_t a, int32_t b)
{
  return a < 0 || compare_places(d, b, a) < 0 ? b : a;
}

/* Which way round it is, as polygons in the same place see it too: some of
 * their vertices may be others. */
static signed char
way_of(const bench *b)
{
  const sg_dense *d = b->m->d;
  int32_t v = -1, next = -1, before = -1;

  for (size_t i = b->begin; i < b->end; i++) {
    v = lower_of(d, v, d->from[d->list[i]]);
  }
  for (size_t i = b->begin; i < b->end; i++) {
    int32_t from = d->from[d->list[i]], to = d->to[d->list[i]];

    next = compare_places(d, from, v) == 0 ? lower_of(d, next, to) : next;
    before = compare_places(d, to, v) == 0 ? lower_of(d, before, from) : before;
  }
  return compare_places(d, next, before) < 0 ? 1 : -1;
}

static bool
see_polygon(bench *b)
{
  sg_regions_maker *m = b->m;
  const sg_dense *d = m->d;

  b->begin = d->list_begin[b->p];
  b->end = d->list_begin[b->p + 1];
  m->is_face[b->p] = b->begin < b->end &&
                     m->triangle_begin[b->p] < m->triangle_begin[b->p + 1];
  for (size_t i = b->begin; i < b->end; i++) {
    m->polygon[i] = (uint32_t)b->p;
  }
  if (!m->is_face[b->p]) {
    m->out->dropped++;
    return true;
  }
  if (!sg_list_need(&b->into, b->end - b->begin, &b->room, sizeof *b->into)) {
    return sg_regions_no_memory(m);
  }
  if (!list_sides(b) || !link_entries(b) || !count_loops(b)) {
    return false;
  }
  m->way[b->p] = way_of(b);
  for (size_t i = b->begin; i < b->end; i++) {
    m->third[i] = third(b, d->from[d->list[i]], d->to[d->list[i]]);
    if (m->third[i] < 0) {
      return fail(b, SG_REGIONS_TRIANGLES);
    }
  }
  return true;
}

/* ---- all ---- */

static bool
make_room(sg_regions_maker *m)
{
  const sg_dense *d = m->d;
  size_t n = m->entries + 1;

  m->polygon = malloc((m->corners + 1) * sizeof *m->polygon);
  m->next = malloc(n * sizeof *m->next);
  m->before = malloc(n * sizeof *m->before);
  m->third = malloc(n * sizeof *m->third);
  m->way = calloc(d->polygons + 1, 1);
  m->loops = calloc(d->polygons + 1, sizeof *m->loops);
  m->is_face = calloc(d->polygons + 1, sizeof *m->is_face);
  return (m->polygon && m->next && m->before && m->third && m->way &&
          m->loops && m->is_face) ||
         sg_regions_no_memory(m);
}

bool
sg_regions_corners(sg_regions_maker *m)
{
  bench b = {.m = m};
  bool good;

  m->entries = m->d->list_begin[m->d->polygons];
  m->corners = m->entries + m->point_loops;
  good = make_room(m) &&
         (sg_dense_by_polygon(m->d, &m->triangle_begin, &m->triangle) ||
          sg_regions_no_memory(m));
  for (b.p = 0; good && b.p < m->d->polygons; b.p++) {
    good = see_polygon(&b) && (b.p % 4096 != 0 || sg_regions_asked(m));
  }
  for (size_t i = 0; good && i < m->point_loops; i++) {
    m->polygon[m->entries + i] = m->point_loop[i].p;
    m->loops[m->point_loop[i].p]++;
  }
  free(b.side);
  free(b.into);
  free(b.set);
  return good;
}
