/* self_sheet.c -- many sheets on one edge, for the join of a leaf tree with
 * itself: see self_leaf.h.
 *
 * Where many sheets hang on one edge, each two of them have it in common. All
 * of these pairs say the same, so a few sheets are taken with all others.
 */
#include "self_sheet.h"

#include "engine/list.h"
#include "engine/search.h"
#include "rows/sort.h"

#include <stdlib.h>
#include <string.h>

/* Of more triangles at a vertex not each two are taken that touch there. */
enum { FULL = 64 };

/* A side of a triangle: where it is, and what its ends are called. */
typedef struct side {
  uint32_t place[2], name[2]; /* as of the lower and the upper place */
  uint32_t triangle;
  bool chord; /* of the polygons there its own alone has it, twice */
} side;

/* A corner of a triangle. */
typedef struct corner {
  uint32_t place, name, triangle;
} corner;

typedef struct sheets {
  const sg_fan_triangle *triangle;
  size_t n;
  const uint32_t *place; /* [3 * n] */
  side *side;            /* [3 * n] by place, by name, by triangle */
  corner *corner;        /* [3 * n] the same */
  sg_self_wants *wants;
  void *data;
  sg_bvh_hits *out;
  size_t room;
} sheets;

/* ---- in order ---- */

static int
compare(uint32_t a, uint32_t b)
{
  return (a > b) - (a < b);
}

static int
compare_edges(const side *a, const side *b)
{
  int order = compare(a->place[0], b->place[0]);

  return order != 0 ? order : compare(a->place[1], b->place[1]);
}

static int
compare_names(const side *a, const side *b)
{
  int order = compare(a->name[0], b->name[0]);

  return order != 0 ? order : compare(a->name[1], b->name[1]);
}

static int
by_edge(const void *x, const void *y)
{
  const side *a = x, *b = y;
  int order = compare_edges(a, b);

  order = order != 0 ? order : compare_names(a, b);
  return order != 0 ? order : compare(a->triangle, b->triangle);
}

SG_ORDER(by_vertex, corner, SG_BY(place) SG_BY(name) SG_BY(triangle));

static bool
file_all(sheets *s, const sg_cancel *cancel)
{
  s->side = malloc((3 * s->n + 1) * sizeof *s->side);
  s->corner = malloc((3 * s->n + 1) * sizeof *s->corner);
  if (!s->side || !s->corner) {
    return false;
  }
  for (size_t i = 0; i < 3 * s->n; i++) {
    uint32_t t = (uint32_t)(i / 3), k = (uint32_t)(i % 3), next = (k + 1) % 3;
    uint32_t at[2] = {s->place[i], s->place[3 * t + next]};
    uint32_t name[2] = {s->triangle[t].name[k], s->triangle[t].name[next]};
    int low = at[1] < at[0];

    s->side[i] = (side){{at[low], at[!low]}, {name[low], name[!low]}, t, false};
    s->corner[i] = (corner){at[0], name[0], t};
  }
  return sg_sort(s->side, 3 * s->n, sizeof *s->side, by_edge, cancel) ==
             SG_SORTED &&
         sg_sort(s->corner, 3 * s->n, sizeof *s->corner, by_vertex, cancel) ==
             SG_SORTED;
}

/* ---- pairs ---- */

/* Adds a pair, if it is of the join. False: no memory. */
static bool
take(sheets *s, uint32_t i, uint32_t k)
{
  uint32_t a = i < k ? i : k, b = i < k ? k : i;

  if (a == b || !s->wants(s->data, &s->triangle[a], &s->triangle[b])) {
    return true;
  }
  if (!sg_list_grow(&s->out->hit, s->out->n, &s->room, sizeof *s->out->hit)) {
    return false;
  }
  s->out->hit[s->out->n++] = (sg_bvh_hit){0, a, b};
  return true;
}

/* Where the sheet ends that begins at `from`; notes whether it is a chord. */
static size_t
end_of_sheet(sheets *s, size_t from, size_t end)
{
  side *of = s->side;
  size_t to = from + 1;

  while (to < end && compare_names(&of[from], &of[to]) == 0) {
    to++;
  }
  of[from].chord =
      to - from == 2 && s->triangle[of[from].triangle].polygon ==
                            s->triangle[of[from + 1].triangle].polygon;
  return to;
}

static bool
take_sheets(sheets *s, const size_t x[2], const size_t y[2])
{
  for (size_t i = x[0]; i < x[1]; i++) {
    for (size_t k = y[0]; k < y[1]; k++) {
      if (!take(s, s->side[i].triangle, s->side[k].triangle)) {
        return false;
      }
    }
  }
  return true;
}

/* The first sheets at an edge, from `from` to end - 1, those that are no chords
 * before the others: each as from where to where. Returns how many. */
static int
find_hubs(sheets *s, size_t from, size_t end, size_t hub[][2])
{
  int n = 0;

  for (int chords = 0; chords < 2; chords++) {
    for (size_t i = from, to; i < end && n < SG_SELF_SHEETS; i = to) {
      to = end_of_sheet(s, i, end);
      if (s->side[i].chord == (chords == 1)) {
        hub[n][0] = i;
        hub[n++][1] = to;
      }
    }
  }
  return n;
}

/* The sheets at an edge: each with the first ones. */
static bool
take_edge(sheets *s, size_t from, size_t end)
{
  size_t hub[SG_SELF_SHEETS][2];
  int hubs = find_hubs(s, from, end, hub);

  for (size_t i = from, to; i < end; i = to) {
    to = end_of_sheet(s, i, end);
    for (int h = 0; h < hubs; h++) {
      if (hub[h][0] != i && !take_sheets(s, hub[h], (size_t[2]){i, to})) {
        return false;
      }
    }
  }
  return true;
}

/* The triangles at a place, if several vertices are there: a few with all, or
 * the first of the first vertex with the first of each other one. */
static bool
take_vertex(sheets *s, size_t from, size_t end)
{
  const corner *of = s->corner;
  bool all = end - from <= FULL;

  for (size_t i = from + 1; i < end; i++) {
    bool first = of[i].name != of[i - 1].name;

    for (size_t k = from; k < i && (all || (first && k == from)); k++) {
      if (of[i].name != of[k].name &&
          !take(s, of[i].triangle, of[k].triangle)) {
        return false;
      }
    }
  }
  return true;
}

static bool
take_all(sheets *s)
{
  for (size_t i = 0, end; i < 3 * s->n; i = end) {
    for (end = i + 1;
         end < 3 * s->n && compare_edges(&s->side[i], &s->side[end]) == 0;
         end++) {
    }
    if (!take_edge(s, i, end)) {
      return false;
    }
  }
  for (size_t i = 0, end; i < 3 * s->n; i = end) {
    for (end = i + 1;
         end < 3 * s->n && s->corner[end].place == s->corner[i].place; end++) {
    }
    if (!take_vertex(s, i, end)) {
      return false;
    }
  }
  return true;
}

/* ---- how many ---- */

bool
sg_self_sheets_are_many(const sg_fan_triangle *triangle, size_t n,
                        const uint32_t *place, const sg_cancel *cancel,
                        bool *many)
{
  sheets s = {.triangle = triangle, .n = n, .place = place};
  bool good = file_all(&s, cancel);
  size_t sheets_here = 0, names_here = 0, corners_here = 0;

  *many = false;
  for (size_t i = 0; good && i < 3 * n && !*many; i++) {
    bool same_edge = i > 0 && compare_edges(&s.side[i - 1], &s.side[i]) == 0;
    bool same_place = i > 0 && s.corner[i - 1].place == s.corner[i].place;

    sheets_here =
        !same_edge
            ? 1
            : sheets_here + (compare_names(&s.side[i - 1], &s.side[i]) != 0);
    names_here = !same_place
                     ? 1
                     : names_here + (s.corner[i - 1].name != s.corner[i].name);
    corners_here = same_place ? corners_here + 1 : 1;
    *many =
        sheets_here > SG_SELF_SHEETS || (names_here > 1 && corners_here > FULL);
  }
  free(s.side);
  free(s.corner);
  return good;
}

SG_ORDER(by_pair, sg_bvh_hit, SG_BY(a) SG_BY(b));

bool
sg_self_sheets_add(const sg_fan_triangle *triangle, size_t n,
                   const uint32_t *place, sg_self_wants *wants, void *data,
                   const sg_cancel *cancel, sg_bvh_hits *hits)
{
  sheets s = {.triangle = triangle,
              .n = n,
              .place = place,
              .wants = wants,
              .data = data,
              .out = hits,
              .room = hits->n};
  bool good = file_all(&s, cancel) && take_all(&s) &&
              sg_sort(hits->hit, hits->n, sizeof *hits->hit, by_pair, cancel) ==
                  SG_SORTED;
  size_t kept = 0;

  for (size_t i = 0; good && i < hits->n; i++) {
    if (kept == 0 || by_pair(&hits->hit[kept - 1], &hits->hit[i]) != 0) {
      hits->hit[kept++] = hits->hit[i];
    }
  }
  hits->n = good ? kept : hits->n;
  free(s.side);
  free(s.corner);
  return good;
}
