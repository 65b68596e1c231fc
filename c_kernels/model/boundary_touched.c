/* boundary_touched.c -- see boundary_touched.h. */
#include "boundary_touched.h"

#include "engine/list.h"
#include "engine/search.h"
#include "rows/key_table.h"

#include <stdlib.h>
#include <string.h>

enum { ASK_EVERY = 65536 };

/* A side of two triangles of one polygon. */
typedef struct chord {
  uint32_t polygon;
  uint32_t next; /* 1 + the next one between the same ends, or 0 */
} chord;

/* A search under way. Polygons and triangles are counted from the first of the
 * segment. */
typedef struct finder {
  const sg_dense *d;
  const uint32_t *number;
  const sg_cancel *cancel;
  bool stopped;
  size_t vertex, polygon, polygons; /* the first vertex and polygon */
  size_t triangle, triangles;
  uint32_t *begin;  /* [polygons + 1] into sorted */
  uint32_t *sorted; /* [triangles] by their polygons */
  uint32_t *seen;   /* [vertices] 1 + the polygon that has it last */
  uint64_t *side;   /* [3 * triangles of a polygon] the ends of its sides */
  size_t room;
  chord *chord; /* [n] */
  size_t n, chord_room;
  sg_key_table ends;     /* of chords: the first between these ends */
  unsigned char *at_end; /* [vertices] it is an end of a chord */
  unsigned char *is;     /* [polygons] touched inside */
} finder;

static bool
stops(finder *f)
{
  return f->stopped = sg_cancelled(f->cancel);
}

static uint32_t
corner_of(const finder *f, uint32_t triangle, int k)
{
  size_t v = (size_t)f->d->corner[triangle][k % 3];

  return f->number[v - f->vertex];
}

static uint64_t
ends_of(uint32_t u, uint32_t w)
{
  return u < w ? (uint64_t)u << 32 | w : (uint64_t)w << 32 | u;
}

/* ---- triangles by their polygons ----------------------------------------- */

static bool
open_finder(finder *f, size_t vertices)
{
  f->begin = calloc(f->polygons + 2, sizeof *f->begin);
  f->sorted = malloc((f->triangles + 1) * sizeof *f->sorted);
  f->seen = calloc(vertices + 1, sizeof *f->seen);
  f->is = calloc(f->polygons + 1, 1);
  f->at_end = calloc(vertices + 1, 1);
  sg_key_table_init(&f->ends, 2);
  return f->begin && f->sorted && f->seen && f->is && f->at_end;
}

static void
close_finder(finder *f)
{
  free(f->begin);
  free(f->sorted);
  free(f->seen);
  free(f->chord);
  free(f->side);
  free(f->is);
  free(f->at_end);
  sg_key_table_clear(&f->ends);
}

static void
sort_triangles(finder *f)
{
  uint32_t *end = f->begin + 1;

  for (size_t t = f->triangle; t < f->triangle + f->triangles; t++) {
    end[(size_t)f->d->polygon_of[t] - f->polygon + 1]++;
  }
  for (size_t p = 0; p < f->polygons; p++) {
    end[p + 1] += end[p];
  }
  for (size_t t = f->triangle; t < f->triangle + f->triangles; t++) {
    f->sorted[end[(size_t)f->d->polygon_of[t] - f->polygon]++] = (uint32_t)t;
  }
}

/* ---- vertices and chords inside ------------------------------------------ */

/* Marks the vertices of polygon p; true if its triangles have another one. */
static bool
has_vertex_inside(finder *f, size_t p)
{
  const sg_dense *d = f->d;
  size_t place = f->polygon + p;

  for (size_t k = d->list_begin[place]; k < d->list_begin[place + 1]; k++) {
    f->seen[f->number[(size_t)d->from[d->list[k]] - f->vertex]] =
        (uint32_t)p + 1;
  }
  for (size_t i = f->begin[p]; i < f->begin[p + 1]; i++) {
    for (int k = 0; k < 3; k++) {
      if (f->seen[corner_of(f, f->sorted[i], k)] != p + 1) {
        return true;
      }
    }
  }
  return false;
}

static bool
put_chord(finder *f, size_t p, uint64_t ends)
{
  const uint32_t end[2] = {(uint32_t)(ends >> 32), (uint32_t)ends};
  uint32_t *first = sg_key_table_put(&f->ends, end);

  f->at_end[end[0]] = f->at_end[end[1]] = 1;
  if (!sg_list_grow(&f->chord, f->n, &f->chord_room, sizeof *f->chord)) {
    return false;
  }
  if (!first) {
    return false;
  }
  f->chord[f->n] = (chord){(uint32_t)p, *first == SG_NO_KEY ? 0 : *first + 1};
  *first = (uint32_t)f->n++;
  return true;
}

static bool
side_room(finder *f, size_t n)
{
  if (n > f->room) {
    free(f->side);
    f->side = malloc(2 * n * sizeof *f->side);
    f->room = f->side ? 2 * n : 0;
  }
  return f->side != NULL;
}

/* Two triangles of p have a chord, one an edge of p. */
static bool
put_chords(finder *f, size_t p)
{
  size_t n = 0;

  if (!side_room(f, 3 * (f->begin[p + 1] - f->begin[p]))) {
    return false;
  }
  for (size_t i = f->begin[p]; i < f->begin[p + 1]; i++) {
    for (int k = 0; k < 3; k++) {
      uint32_t u = corner_of(f, f->sorted[i], k);
      uint32_t w = corner_of(f, f->sorted[i], k + 1);
      f->side[n] = ends_of(u, w);
      n += u != w;
    }
  }
  qsort(f->side, n, sizeof *f->side, sg_compare_keys);
  for (size_t i = 1; i < n; i++) {
    if (f->side[i] == f->side[i - 1] && !put_chord(f, p, f->side[i])) {
      return false;
    }
  }
  return true;
}

static bool
find_inside(finder *f)
{
  for (size_t p = 0; p < f->polygons; p++) {
    if (p % ASK_EVERY == 0 && stops(f)) {
      return false;
    }
    if (f->begin[p + 1] - f->begin[p] < 2) {
      continue;
    }
    f->is[p] = has_vertex_inside(f, p);
    if (!f->is[p] && !put_chords(f, p)) {
      return false;
    }
  }
  return true;
}

/* ---- edges on chords ------------------------------------------------------
 */

static void
mark_chords(finder *f, size_t of, uint32_t u, uint32_t w)
{
  uint64_t ends = ends_of(u, w);

  if (!f->at_end[u] || !f->at_end[w]) { /* as of most edges of a large mesh */
    return;
  }
  uint32_t first = sg_key_table_get(
      &f->ends, (uint32_t[2]){(uint32_t)(ends >> 32), (uint32_t)ends});

  for (uint32_t i = first == SG_NO_KEY ? 0 : first + 1; i;
       i = f->chord[i - 1].next) {
    f->is[f->chord[i - 1].polygon] |= f->chord[i - 1].polygon != of;
  }
}

static bool
find_edges_inside(finder *f)
{
  const sg_dense *d = f->d;

  for (size_t p = 0; f->n > 0 && p < f->polygons; p++) {
    size_t place = f->polygon + p;

    if (p % ASK_EVERY == 0 && stops(f)) {
      return false;
    }
    for (size_t k = d->list_begin[place]; k < d->list_begin[place + 1]; k++) {
      size_t e = (size_t)d->list[k];
      mark_chords(f, p, f->number[(size_t)d->from[e] - f->vertex],
                  f->number[(size_t)d->to[e] - f->vertex]);
    }
  }
  return true;
}

/* ---- together -------------------------------------------------------------
 */

/* Keeps the triangles of those that are touched inside. */
static void
keep_touched(finder *f)
{
  uint32_t n = 0;

  for (size_t p = 0; p < f->polygons; p++) {
    uint32_t i = f->begin[p], end = f->begin[p + 1];

    f->begin[p] = n;
    for (; f->is[p] && i < end; i++) {
      f->sorted[n++] = f->sorted[i];
    }
  }
  f->begin[f->polygons] = n;
}

bool
sg_touched_find(const sg_dense *dense, size_t s, const uint32_t *number,
                bool all, const sg_cancel *cancel, sg_touched *out,
                bool *stopped)
{
  finder f = {
      .d = dense,
      .number = number,
      .cancel = cancel,
      .vertex = dense->vertex_begin[s],
      .polygon = dense->polygon_begin[s],
      .polygons = dense->polygon_begin[s + 1] - dense->polygon_begin[s],
  };

  *out = (sg_touched){0};
  *stopped = false;
  if (!dense->triangle_begin) {
    return true;
  }
  f.triangle = dense->triangle_begin[s];
  f.triangles = dense->triangle_begin[s + 1] - dense->triangle_begin[s];
  bool done = open_finder(&f, dense->vertex_begin[s + 1] - f.vertex);

  if (done) {
    sort_triangles(&f);
    if (all) {
      memset(f.is, 1, f.polygons);
    } else {
      done = find_inside(&f) && find_edges_inside(&f);
    }
  }
  if (done) {
    keep_touched(&f);
    *out = (sg_touched){f.begin, f.sorted};
    f.begin = f.sorted = NULL;
  }
  *stopped = f.stopped;
  close_finder(&f);
  return done;
}

void
sg_touched_clear(sg_touched *touched)
{
  free(touched->begin);
  free(touched->triangle);
  *touched = (sg_touched){0};
}
