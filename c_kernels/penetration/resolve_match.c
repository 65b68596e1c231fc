/* resolve_match.c -- the same triangles where polygons of different segments
 * lie on each other: see resolve_polygon.h.
 *
 * A polygon's edges and seams divide it into CELLS. Two polygons that have a
 * part in common have cells with the same border, once round and, if they
 * face each other, the other way round.
 */
#include "resolve_polygon.h"

#include "engine/search.h"
#include "rows/disjoint.h"
#include "rows/sort.h"

#include <stdlib.h>
#include <string.h>

enum { ASKED = 1 << 10 }; /* polygons between questions */

typedef struct side {
  uint32_t a, b; /* points */
} side;

typedef struct cell {
  size_t polygon;
  size_t first_side, sides; /* of the border, sorted */
  const side *border;       /* the same, when all cells are there */
  size_t first_triangle, triangles;
  bool turned; /* the border is that of the other way round */
} cell;

typedef struct matcher {
  const sg_resolve *r;
  sg_resolved_polygon *polygon;
  size_t polygons;
  sg_key_table point; /* S, vertex id -> point */
  SG_LIST_OF(side) side;
  SG_LIST_OF(size_t) triangle; /* of cells */
  SG_LIST_OF(cell) cell;
  const sg_cancel *cancel;
  bool stopped;
} matcher;

/* False: no memory, or stopped. */
static bool
sort(matcher *m, void *item, size_t n, size_t size, sg_sort_compare *compare)
{
  sg_sort_end end = sg_sort(item, n, size, compare, m->cancel);

  m->stopped = m->stopped || end == SG_SORT_STOPPED;
  return end == SG_SORTED;
}

static uint32_t
point_of(const matcher *m, int32_t s, int32_t v)
{
  return sg_key_table_get(&m->point, (uint32_t[2]){(uint32_t)s, (uint32_t)v});
}

static bool
note_points(matcher *m)
{
  for (size_t i = 0; i < m->r->place.n; i++) {
    const sg_resolve_place *place = &m->r->place.item[i];
    uint32_t *known = sg_key_table_put(
        &m->point, (uint32_t[2]){(uint32_t)place->s, (uint32_t)place->name});
    if (!known) {
      return false;
    }
    *known = place->point;
  }
  return true;
}

/* ---- cells ---- */

/* The triangles of one polygon, joined across chords. */
typedef struct joiner {
  const sg_resolved_polygon *polygon;
  sg_key_table edge; /* vertex ids, smaller first: an edge or seam */
  sg_key_table side; /* vertex ids in order -> triangle */
  uint32_t *root;    /* [triangles] disjoint sets */
  size_t *next;      /* [triangles]: in the same cell, ascending; 0: none */
} joiner;

/* Chains the triangles of each cell from the root on, which is the first. */
static void
chain_cells(joiner *j)
{
  for (size_t i = j->polygon->triangle.n; i-- > 0;) {
    size_t first = sg_disjoint_root(j->root, (uint32_t)i);
    if (first != i) {
      j->next[i] = j->next[first];
      j->next[first] = i;
    }
  }
}

static bool
is_border(const joiner *j, int32_t a, int32_t b)
{
  uint32_t key[2] = {(uint32_t)(a < b ? a : b), (uint32_t)(a < b ? b : a)};

  return sg_key_table_get(&j->edge, key) != SG_NO_KEY;
}

static bool
note(sg_key_table *table, int32_t a, int32_t b, size_t value)
{
  uint32_t *known =
      sg_key_table_put(table, (uint32_t[2]){(uint32_t)a, (uint32_t)b});

  if (known) {
    *known = (uint32_t)value;
  }
  return known != NULL;
}

static bool
join_triangles(joiner *j)
{
  const sg_resolved_polygon *polygon = j->polygon;

  for (size_t i = 0; i < polygon->edge.n; i++) {
    const int32_t *v = polygon->edge.item[i].v;
    if (!note(&j->edge, v[0] < v[1] ? v[0] : v[1], v[0] < v[1] ? v[1] : v[0],
              0)) {
      return false;
    }
  }
  for (size_t i = 0; i < polygon->triangle.n; i++) {
    const int32_t *v = polygon->triangle.item[i].v;
    j->root[i] = (uint32_t)i;
    for (int k = 0; k < 3; k++) {
      if (!note(&j->side, v[k], v[(k + 1) % 3], i)) {
        return false;
      }
    }
  }
  for (size_t i = 0; i < polygon->triangle.n; i++) {
    const int32_t *v = polygon->triangle.item[i].v;
    for (int k = 0; k < 3; k++) {
      int32_t a = v[k], b = v[(k + 1) % 3];
      uint32_t other =
          sg_key_table_get(&j->side, (uint32_t[2]){(uint32_t)b, (uint32_t)a});
      if (other != SG_NO_KEY && !is_border(j, a, b)) {
        sg_disjoint_join(j->root, (uint32_t)i, (uint32_t)other);
      }
    }
  }
  return true;
}

SG_ORDER(by_side, side, SG_BY(a) SG_BY(b));

/* Sorts the border of a new cell, in the direction that is first of the two. */
static bool
settle_border(matcher *m, cell *c)
{
  side *one = m->side.item + c->first_side;
  side *other = malloc((c->sides + 1) * sizeof *other);

  if (!other) {
    return false;
  }
  for (size_t i = 0; i < c->sides; i++) {
    other[i] = (side){one[i].b, one[i].a};
  }
  if (!sort(m, one, c->sides, sizeof *one, by_side) ||
      !sort(m, other, c->sides, sizeof *other, by_side)) {
    free(other);
    return false;
  }
  for (size_t i = 0; i < c->sides; i++) {
    int order = by_side(&one[i], &other[i]);
    if (order != 0) {
      c->turned = order > 0;
      break;
    }
  }
  if (c->turned) {
    memcpy(one, other, c->sides * sizeof *one);
  }
  free(other);
  return true;
}

/* Adds the cell of triangle `first`, the first one in it, unless one of its
 * corners is no shared point. */
static bool
add_cell(matcher *m, const joiner *j, size_t polygon, size_t first)
{
  const sg_resolved_polygon *of = j->polygon;
  cell c = {.polygon = polygon,
            .first_side = m->side.n,
            .first_triangle = m->triangle.n};
  bool shared = true;
  size_t i = first;

  do {
    const int32_t *v = of->triangle.item[i].v;
    if (!SG_PUSH(m->triangle, i)) {
      return false;
    }
    c.triangles++;
    for (int k = 0; k < 3; k++) {
      int32_t a = v[k], b = v[(k + 1) % 3];
      side s = {point_of(m, of->s, a), point_of(m, of->s, b)};
      shared = shared && s.a != SG_NO_KEY;
      if (is_border(j, a, b)) {
        if (!SG_PUSH(m->side, s)) {
          return false;
        }
        c.sides++;
      }
    }
    i = j->next[i];
  } while (i != 0);
  if (!shared) {
    m->side.n = c.first_side;
    m->triangle.n = c.first_triangle;
    return true;
  }
  return settle_border(m, &c) && SG_PUSH(m->cell, c);
}

static bool
add_cells(matcher *m, size_t polygon)
{
  joiner j = {.polygon = &m->polygon[polygon]};
  size_t n = j.polygon->triangle.n;

  sg_key_table_init(&j.edge, 2);
  sg_key_table_init(&j.side, 2);
  j.root = malloc((n + 1) * sizeof *j.root);
  j.next = calloc(n + 1, sizeof *j.next);
  bool done = j.root && j.next && join_triangles(&j);

  if (done) {
    chain_cells(&j);
  }
  for (size_t i = 0; i < n && done; i++) {
    if (j.root[i] == i) {
      done = add_cell(m, &j, polygon, i);
    }
  }
  sg_key_table_clear(&j.edge);
  sg_key_table_clear(&j.side);
  free(j.root);
  free(j.next);
  return done;
}

/* ---- matching ---- */

static int
compare_cells(const cell *x, const cell *y)
{
  if (x->sides != y->sides) {
    return x->sides < y->sides ? -1 : 1;
  }
  for (size_t i = 0; i < x->sides; i++) {
    int order = by_side(&x->border[i], &y->border[i]);
    if (order != 0) {
      return order;
    }
  }
  return 0;
}

static int
by_border(const void *a, const void *b)
{
  const cell *x = a, *y = b;
  int order = compare_cells(x, y);

  return order ? order : (x->polygon > y->polygon) - (x->polygon < y->polygon);
}

/* Gives the cell `to` the triangles of `from`, in the names of its segment. */
static void
copy_triangles(matcher *m, const cell *from, const cell *to)
{
  const sg_resolved_polygon *source = &m->polygon[from->polygon];
  sg_resolved_polygon *target = &m->polygon[to->polygon];
  bool turn = from->turned != to->turned;

  for (int pass = 0; pass < 2; pass++) { /* look first whether all are there */
    for (size_t i = 0; i < from->triangles; i++) {
      const int32_t *v =
          source->triangle.item[m->triangle.item[from->first_triangle + i]].v;
      sg_triangle corners;
      for (int k = 0; k < 3; k++) {
        const sg_resolve_place *place = sg_resolve_place_of(
            m->r, point_of(m, source->s, v[turn ? 2 - k : k]), target->s);
        if (!place) {
          return;
        }
        corners.v[k] = place->name;
      }
      if (pass == 1) {
        target->triangle.item[m->triangle.item[to->first_triangle + i]] =
            corners;
      }
    }
  }
}

/* All cells, with their borders. */
static bool
find_cells(matcher *m)
{
  for (size_t i = 0; i < m->polygons; i++) {
    if (i % ASKED == ASKED - 1 && sg_cancelled(m->cancel)) {
      m->stopped = true;
      return false;
    }
    if (!add_cells(m, i)) {
      return false;
    }
  }
  for (size_t i = 0; i < m->cell.n; i++) {
    m->cell.item[i].border = m->side.item + m->cell.item[i].first_side;
  }
  return true;
}

static void
match_cells(matcher *m)
{
  for (size_t i = 1, first = 0; i < m->cell.n; i++) {
    const cell *from = &m->cell.item[first], *to = &m->cell.item[i];

    if (compare_cells(from, to) != 0) {
      first = i;
    } else if (from->triangles == to->triangles &&
               m->polygon[from->polygon].s != m->polygon[to->polygon].s) {
      copy_triangles(m, from, to);
    }
  }
}

sg_resolved
sg_resolve_match(const sg_resolve *r, sg_resolved_polygon *polygon,
                 size_t polygons, const sg_cancel *cancel)
{
  matcher m = {
      .r = r, .polygon = polygon, .polygons = polygons, .cancel = cancel};

  sg_key_table_init(&m.point, 2);
  bool done = note_points(&m) && find_cells(&m) &&
              sort(&m, m.cell.item, m.cell.n, sizeof *m.cell.item, by_border);

  if (done) {
    match_cells(&m);
  }
  sg_key_table_clear(&m.point);
  free(m.side.item);
  free(m.triangle.item);
  free(m.cell.item);
  return done        ? SG_RESOLVED
         : m.stopped ? SG_RESOLVE_STOPPED
                     : SG_RESOLVE_NO_MEMORY;
}
