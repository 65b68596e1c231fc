/* sewing.c -- see sewing.h. */
#include "sewing.h"

#include "engine/search.h"
#include "join/cut.h"
#include "number/exact.h"
#include "number/vector.h"
#include "polygon/flatness.h"
#include "rows/edge_print.h"
#include "rows/places.h"
#include "rows/sort.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ASKED = 1 << 14 }; /* polygons between questions */

/* A half-edge, `last` is NO_CORNER; or a triangle, its lowest corner first. */
typedef struct part {
  uint32_t first, second, last;
} part;

static const uint32_t NO_CORNER = UINT32_MAX;
static const int32_t ANOTHER = INT32_MIN; /* as a weight: the same as another */

typedef struct sewer {
  const sg_dense *d;
  sg_sewing *out;
  uint32_t *begin;    /* [polygons + 1] in triangle[] */
  uint32_t *triangle; /* by polygon */
  uint64_t *key;      /* [polygons], ascending: print_of(), then the polygon */
  part *part[2];      /* room for those of any polygon */
  double near;        /* what a corner may be off the plane of a flat polygon */
} sewer;

/* ---- vertices ---- */

/* What was seen last where a vertex is. */
typedef struct seen {
  uint32_t polygon, vertex;
  bool twice; /* a polygon has two vertices there */
} seen;

static void
see(seen *all, const uint32_t *vertex, uint32_t polygon, int32_t v)
{
  seen *here = &all[vertex[v]];

  here->twice =
      here->twice || (here->polygon == polygon && here->vertex != (uint32_t)v);
  here->polygon = polygon;
  here->vertex = (uint32_t)v;
}

/* Corners of a polygon's triangles need not be on its edges. */
static void
see_all(const sewer *s, seen *all)
{
  const sg_dense *d = s->d;
  const uint32_t *vertex = s->out->vertex;

  for (uint32_t p = 0; p < d->polygons; p++) {
    for (uint32_t i = d->list_begin[p]; i < d->list_begin[p + 1]; i++) {
      see(all, vertex, p, d->from[d->list[i]]);
      see(all, vertex, p, d->to[d->list[i]]);
    }
    for (uint32_t i = s->begin[p]; i < s->begin[p + 1]; i++) {
      for (int k = 0; k < 3; k++) {
        see(all, vertex, p, d->corner[s->triangle[i]][k]);
      }
    }
  }
}

static bool
find_vertices(sewer *s, const sg_cancel *cancel)
{
  size_t n = s->d->vertices;
  uint32_t *vertex = sg_places_of((const double(*)[3])s->d->at, n, cancel);
  seen *all = malloc((n + 1) * sizeof *all);
  bool good = vertex && all;

  s->out->vertex = vertex;
  for (size_t v = 0; good && v < n; v++) {
    all[v] = (seen){UINT32_MAX, 0, false};
  }
  if (good) {
    see_all(s, all);
  }
  for (uint32_t v = 0; good && v < n; v++) {
    if (all[vertex[v]].twice) {
      vertex[v] = v; /* a first one comes before the others */
    }
    s->out->any = s->out->any || vertex[v] != v;
  }
  free(all);
  return good;
}

/* ---- polygons ---- */

static size_t
edges_of(const sewer *s, uint32_t p)
{
  return s->d->list_begin[p + 1] - s->d->list_begin[p];
}

static size_t
triangles_of(const sewer *s, uint32_t p)
{
  return s->begin[p + 1] - s->begin[p];
}

/* Half-edge i of a polygon. */
static part
edge_at(const sewer *s, uint32_t p, size_t i)
{
  int32_t e = s->d->list[s->d->list_begin[p] + i];
  const uint32_t *vertex = s->out->vertex;

  return (part){vertex[s->d->from[e]], vertex[s->d->to[e]], NO_CORNER};
}

static part
triangle_at(const sewer *s, uint32_t p, size_t i)
{
  const int32_t *corner = s->d->corner[s->triangle[s->begin[p] + i]];
  const uint32_t *vertex = s->out->vertex;
  uint32_t v[3] = {vertex[corner[0]], vertex[corner[1]], vertex[corner[2]]};
  int k = v[1] < v[0] ? 1 : 0;

  k = v[2] < v[k] ? 2 : k;
  return (part){v[k], v[(k + 1) % 3], v[(k + 2) % 3]};
}

static part
turned_round(part one)
{
  return one.last == NO_CORNER ? (part){one.second, one.first, NO_CORNER}
                               : (part){one.first, one.last, one.second};
}

/* What a polygon is made of, whichever way round: the same for all equal ones;
 * rarely for others. */
static uint32_t
print_of(const sewer *s, uint32_t p)
{
  size_t n = edges_of(s, p);
  uint64_t sum = sg_spread_bits(n);

  for (size_t i = 0; i < n; i++) {
    part one = edge_at(s, p, i);
    sum += sg_spread_bits((uint64_t)one.first << 32 | one.second) +
           sg_spread_bits((uint64_t)one.second << 32 | one.first);
  }
  return (uint32_t)(sum >> 32);
}

SG_ORDER(compare_parts, part, SG_BY(first) SG_BY(second) SG_BY(last));

typedef part part_at(const sewer *s, uint32_t p, size_t i);

static void
sort_parts(const sewer *s, uint32_t p, part_at *at, size_t n, bool turned,
           part *out)
{
  for (size_t i = 0; i < n; i++) {
    part one = at(s, p, i);
    out[i] = turned ? turned_round(one) : one;
  }
  if (n > 0) {
    qsort(out, n, sizeof *out, compare_parts);
  }
}

/* Whether polygons of n such parts each have the same; q may be turned round.
 */
static bool
have_same(const sewer *s, uint32_t p, uint32_t q, part_at *at, size_t n,
          bool turned)
{
  sort_parts(s, p, at, n, false, s->part[0]);
  sort_parts(s, q, at, n, turned, s->part[1]);
  return memcmp(s->part[0], s->part[1], n * sizeof(part)) == 0;
}

/* Whether x is off the plane of a triangle that has an area. */
static bool
is_off(const sewer *s, const double at[3][3], const double *x)
{
  double u[3], w[3], normal[3], from[3];

  if (sg_orient3d(at[0], at[1], at[2], x) == 0) {
    return false;
  }
  sg_minus(at[1], at[0], u);
  sg_minus(at[2], at[0], w);
  sg_cross(u, w, normal);
  sg_minus(x, at[0], from);
  return fabs(sg_dot(normal, from)) > s->near * sg_any_length(normal) ||
         s->near == 0;
}

/* In one plane: then it is the same however it is divided. */
static bool
is_flat(const sewer *s, uint32_t p)
{
  const sg_dense *d = s->d;
  size_t first = s->begin[p], end = s->begin[p + 1];
  double at[3][3];

  for (size_t i = first, axis = SIZE_MAX; axis > 2; i++) {
    if (i == end) {
      return true; /* no triangle has an area */
    }
    for (int k = 0; k < 3; k++) {
      memcpy(at[k], d->at[d->corner[s->triangle[i]][k]], sizeof at[k]);
    }
    axis = (size_t)sg_cut_axis((const double(*)[3])at);
  }
  for (size_t i = 3 * first; i < 3 * end; i++) {
    const double *x = d->at[d->corner[s->triangle[i / 3]][i % 3]];
    if (is_off(s, (const double(*)[3])at, x)) {
      return false;
    }
  }
  return true;
}

/* 1: q is p; -1: p turned round; 0: another one. */
static int
same_way(const sewer *s, uint32_t p, uint32_t q)
{
  size_t edges = edges_of(s, p), triangles = triangles_of(s, p);

  for (int turned = 0; edges == edges_of(s, q) && turned < 2; turned++) {
    if (have_same(s, p, q, edge_at, edges, turned)) {
      bool same = (triangles == triangles_of(s, q) &&
                   have_same(s, p, q, triangle_at, triangles, turned)) ||
                  is_flat(s, p);
      return !same ? 0 : turned ? -1 : 1;
    }
  }
  return 0;
}

/* Those of one print: each is added to the first that it is the same as. */
static void
weigh_run(const sewer *s, const uint64_t *run, size_t n)
{
  for (size_t i = 0; i < n; i++) {
    int32_t *weight = s->out->weight;
    int way = 0;

    for (size_t k = 0; k < i && way == 0; k++) {
      uint32_t first = (uint32_t)run[k];

      if (weight[first] != ANOTHER) {
        way = same_way(s, first, (uint32_t)run[i]);
        weight[first] += way;
      }
    }
    weight[(uint32_t)run[i]] = way == 0 ? 1 : ANOTHER;
  }
}

static bool
make_keys(sewer *s, const sg_cancel *cancel)
{
  size_t n = s->d->polygons, most = 0;

  s->key = malloc((n + 1) * sizeof *s->key);
  s->out->weight = calloc(n + 1, sizeof *s->out->weight);
  s->out->again = calloc(n + 1, sizeof *s->out->again);
  if (!s->key || !s->out->weight || !s->out->again) {
    return false;
  }
  for (uint32_t p = 0; p < n; p++) {
    size_t edges = edges_of(s, p), triangles = triangles_of(s, p);

    s->key[p] = (uint64_t)print_of(s, p) << 32 | p;
    most = edges > most ? edges : most;
    most = triangles > most ? triangles : most;
    if (p % ASKED == ASKED - 1 && sg_cancelled(cancel)) {
      return false;
    }
  }
  for (int k = 0; k < 2; k++) {
    s->part[k] = malloc((most + 1) * sizeof(part));
  }
  return s->part[0] && s->part[1] && sg_sort_upper(s->key, n);
}

static bool
weigh_polygons(sewer *s, const sg_cancel *cancel)
{
  size_t n = s->d->polygons;

  if (!make_keys(s, cancel)) {
    return false;
  }
  for (size_t i = 0, end; i < n; i = end) {
    for (end = i + 1; end < n && s->key[end] >> 32 == s->key[i] >> 32; end++) {
    }
    weigh_run(s, s->key + i, end - i);
  }
  for (size_t p = 0; p < n; p++) {
    int32_t *weight = &s->out->weight[p];
    s->out->again[p] = *weight == ANOTHER;
    s->out->doubles += s->out->again[p];
    *weight = s->out->again[p] ? 0 : *weight;
  }
  return true;
}

bool
sg_sewing_find(const sg_dense *dense, bool doubles, const sg_cancel *cancel,
               sg_sewing *out)
{
  sewer s = {
      .d = dense,
      .out = out,
      .near =
          doubles
              ? sg_flatness_touch_of(
                    (const double(*)[3])dense->at, dense->vertices,
                    dense->segments > 0 && dense->grain ? dense->grain[0] : 0)
              : 0};

  *out = (sg_sewing){0};
  bool good = sg_dense_by_polygon(s.d, &s.begin, &s.triangle) &&
              find_vertices(&s, cancel) &&
              ((!out->any && !doubles) || weigh_polygons(&s, cancel));

  free(s.begin);
  free(s.triangle);
  free(s.key);
  free(s.part[0]);
  free(s.part[1]);
  return good;
}

void
sg_sewing_clear(sg_sewing *sewing)
{
  free(sewing->vertex);
  free(sewing->weight);
  free(sewing->again);
  *sewing = (sg_sewing){0};
}
