/* nonmanifold.c -- see nonmanifold.h: the corners of all triangles, by their
 * vertices. */
#include "nonmanifold.h"
#include "engine/list.h"
#include "engine/search.h"

#include <stdlib.h>

enum { ASKED = 1 << 15 }; /* vertices or triangles between questions */

/* A corner: its triangle goes on to `next` and comes from `last`, places. */
typedef struct corner {
  uint32_t next, last;
} corner;

typedef struct fans {
  const sg_leaf_tree *tree;
  const sg_leaf_views *views;
  size_t *begin;  /* [places + 2] */
  corner *corner; /* those of place v: begin[v] .. begin[v + 1] - 1 */
  sg_nonmanifold *out;
  size_t vertex_room, edge_room;
} fans;

static uint32_t
place_of(const sg_id_rows *table, int32_t id)
{
  if (!table->id) {
    return (uint32_t)(id - table->first);
  }
  return (uint32_t)sg_first_id(table->id, table->places, sizeof *table->id, id);
}

static int32_t
id_of(const sg_id_rows *table, uint32_t place)
{
  return table->id ? table->id[place] : table->first + (int32_t)place;
}

/* ---- corners by vertex ---- */

static bool
sort_corners(fans *f, const sg_cancel *cancel)
{
  const sg_id_rows *table = &f->tree->vertex;
  size_t n = f->tree->boxes->n, places = table->places;
  uint32_t(*v)[3] = malloc((n + 1) * sizeof *v);
  bool good = v != NULL;

  f->begin = calloc(places + 2, sizeof *f->begin);
  f->corner = malloc((3 * n + 1) * sizeof *f->corner);
  good = good && f->begin && f->corner;
  for (size_t i = 0; i < n && good; i++) {
    sg_leaf leaf = sg_leaf_at(f->tree, f->views, f->tree->boxes->item[i]);

    good = i % ASKED != ASKED - 1 || !sg_cancelled(cancel);
    for (int k = 0; k < 3; k++) {
      v[i][k] = place_of(table, leaf.v[k]);
      f->begin[v[i][k] + 2]++;
    }
  }
  for (size_t i = 2; i < places + 2 && good; i++) {
    f->begin[i] += f->begin[i - 1];
  }
  for (size_t i = 0; i < n && good; i++) {
    for (int k = 0; k < 3; k++) {
      f->corner[f->begin[v[i][k] + 1]++] =
          (corner){v[i][(k + 1) % 3], v[i][(k + 2) % 3]};
    }
  }
  free(v);
  return good;
}

SG_ORDER(by_next, corner, SG_BY(next));

/* ---- one vertex ---- */

/* The corner that goes on to `next`; null: none. Sorted. */
static const corner *
find_next(const corner *c, size_t n, uint32_t next)
{
  size_t at;

  SG_SEARCH(at, 0, n, c[at].next < next);
  return at < n && c[at].next == next ? &c[at] : NULL;
}

static void
sort_few(corner *c, size_t n)
{
  if (n > 16) {
    qsort(c, n, sizeof *c, by_next);
    return;
  }
  SG_SORT_FEW(corner, c, n, x->next > y->next);
}

/* Whether the triangles go round once: from each to the one that goes on to
 * where it comes from, through all of them. Sorted. */
static bool
is_plain(const corner *c, size_t n)
{
  const corner *at = c;

  for (size_t i = 0; i + 1 < n; i++) {
    if (c[i].next == c[i + 1].next) {
      return false;
    }
  }
  for (size_t i = 1; i < n; i++) {
    at = find_next(c, n, at->last);
    if (!at || at == c) {
      return false;
    }
  }
  return at->last == c->next;
}

/* Notes a knot, and its edges to vertices of higher places. */
static bool
note(fans *f, uint32_t place, const corner *c, size_t n)
{
  const sg_id_rows *table = &f->tree->vertex;
  sg_nonmanifold *out = f->out;

  if (!sg_list_grow(&out->vertex, out->vertices, &f->vertex_room,
                    sizeof *out->vertex)) {
    return false;
  }
  out->vertex[out->vertices++] = id_of(table, place);
  for (size_t i = 0; i + 1 < n; i++) {
    if (c[i].next != c[i + 1].next || (i > 0 && c[i].next == c[i - 1].next)) {
      continue;
    }
    if (!sg_list_grow(&out->edge, out->edges, &f->edge_room,
                      sizeof *out->edge)) {
      return false;
    }
    out->edge[out->edges][0] = id_of(table, place);
    out->edge[out->edges++][1] = id_of(table, c[i].next);
  }
  return true;
}

bool
sg_nonmanifold_find(const sg_leaf_tree *tree, const sg_leaf_views *views,
                    const sg_cancel *cancel, sg_nonmanifold *out)
{
  fans f = {.tree = tree, .views = views, .out = out};
  bool good;

  *out = (sg_nonmanifold){0};
  if (tree->curve || tree->boxes->n == 0) {
    return true;
  }
  good = sort_corners(&f, cancel);
  for (size_t v = 0; v < tree->vertex.places && good; v++) {
    corner *c = f.corner + f.begin[v];
    size_t n = f.begin[v + 1] - f.begin[v];

    sort_few(c, n);
    good = (v % ASKED != ASKED - 1 || !sg_cancelled(cancel)) &&
           (n == 0 || is_plain(c, n) || note(&f, (uint32_t)v, c, n));
  }
  free(f.begin);
  free(f.corner);
  return good;
}

void
sg_nonmanifold_clear(sg_nonmanifold *nonmanifold)
{
  free(nonmanifold->vertex);
  free(nonmanifold->edge);
  *nonmanifold = (sg_nonmanifold){0};
}
