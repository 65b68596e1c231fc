/* boundary.c -- see boundary.h. */
#include "boundary.h"
#include "sort.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POLL_EVERY = 65536 };

/* A vertex on its way to its number. */
typedef struct placed {
  double at[3];
  uint32_t v; /* from 0, in the segment */
  bool moved;
} placed;

static int
compare_places(const double a[3], const double b[3])
{
  for (int k = 0; k < 3; k++) {
    if (a[k] != b[k]) {
      return a[k] < b[k] ? -1 : 1;
    }
  }
  return 0;
}

static int
compare_placed(const void *x, const void *y)
{
  const placed *a = x, *b = y;
  int order = compare_places(a->at, b->at);

  return order ? order : (a->v > b->v) - (a->v < b->v);
}

/* ---- vertices ------------------------------------------------------------ */

static double
rounded(double x, const sg_rounding *rounding)
{
  if (rounding->grid > 0) {
    x = nearbyint(x / rounding->grid) * rounding->grid;
  }
  return (rounding->single ? (double)(float)x : x) + 0.0; /* no -0.0 */
}

/* False: out of range. */
static bool
place(const sg_boundary_source *source, size_t first, size_t n,
      const sg_rounding *rounding, placed *out)
{
  const sg_rounding fine = {0, rounding->single};

  for (size_t i = 0; i < n; i++) {
    size_t v = first + i;
    bool coarse = !source->coarse || source->coarse[v];

    out[i].v = (uint32_t)i;
    out[i].moved = source->made && source->made[v];
    for (int k = 0; k < 3; k++) {
      double x = source->dense->at[v][k];
      out[i].at[k] = rounded(x, coarse ? rounding : &fine);
      out[i].moved |= out[i].at[k] != x;
      if (!isfinite(out[i].at[k])) {
        return false;
      }
    }
  }
  return true;
}

/* Numbers the sorted vertices, which were at `was`; number[v] becomes that of
 * v.
 */
static void
number_vertices(const placed *sorted, size_t n, const double (*was)[3],
                uint32_t *number, sg_boundary *out)
{
  for (size_t i = 0; i < n; i++) {
    const double *at = was[sorted[i].v];
    if (i == 0 || compare_places(sorted[i - 1].at, sorted[i].at) != 0) {
      memcpy(out->was[out->vertices], at, sizeof *was);
      out->moved[out->vertices] = 0;
      memcpy(out->at[out->vertices++], sorted[i].at, sizeof sorted[i].at);
    }
    size_t last = out->vertices - 1;
    if (compare_places(at, out->was[last]) < 0) {
      memcpy(out->was[last], at, sizeof *was);
    }
    out->moved[last] |= sorted[i].moved;
    number[sorted[i].v] = (uint32_t)last;
  }
}

static sg_boundary_end
make_vertices(const sg_boundary_source *source, const sg_rounding *rounding,
              const sg_poll *poll, uint32_t *number, sg_boundary *out)
{
  const sg_dense *d = source->dense;
  size_t first = d->vertex_begin[source->s];
  size_t n = d->vertex_begin[source->s + 1] - first;
  placed *sorted = malloc((n + 1) * sizeof *sorted);

  out->at = malloc((n + 1) * sizeof *out->at);
  out->was = malloc((n + 1) * sizeof *out->was);
  out->moved = malloc(n + 1);
  if (!sorted || !out->at || !out->was || !out->moved) {
    free(sorted);
    return SG_BOUNDARY_NO_MEMORY;
  }
  if (!place(source, first, n, rounding, sorted)) {
    free(sorted);
    return SG_BOUNDARY_TOO_FAR;
  }
  sg_sort_end end = sg_sort(sorted, n, sizeof *sorted, compare_placed, poll);
  if (end == SG_SORTED) {
    number_vertices(sorted, n, (const double(*)[3])d->at + first, number, out);
  }
  free(sorted);
  return end == SG_SORTED         ? SG_BOUNDARY_DONE
         : end == SG_SORT_STOPPED ? SG_BOUNDARY_STOPPED
                                  : SG_BOUNDARY_NO_MEMORY;
}

/* ---- faces --------------------------------------------------------------- */

static int
low(const int32_t edge[2])
{
  return edge[0] < edge[1] ? edge[0] : edge[1];
}

/* By the two vertices, then the direction. */
static int
compare_edges(const void *x, const void *y)
{
  const int32_t *a = x, *b = y;
  int la = low(a), lb = low(b), ha = a[0] + a[1] - la, hb = b[0] + b[1] - lb;

  return la != lb   ? (la > lb) - (la < lb)
         : ha != hb ? (ha > hb) - (ha < hb)
                    : (a[0] > b[0]) - (a[0] < b[0]);
}

size_t
sg_edges_cancel(int32_t (*edge)[2], size_t n)
{
  size_t kept = 0;

  qsort(edge, n, sizeof *edge, compare_edges);
  /* Equal edges come together, those from the lower vertex first: the others
   * take them back from the end. */
  for (size_t i = 0; i < n; i++) {
    if (kept > 0 && edge[kept - 1][0] == edge[i][1] &&
        edge[kept - 1][1] == edge[i][0]) {
      kept--;
    } else {
      memmove(edge[kept++], edge[i], sizeof *edge);
    }
  }
  return kept;
}

enum { FEW = 8 };

/* True if there are few edges, and no two of them are opposite. */
static bool
is_plain(int32_t (*edge)[2], size_t n)
{
  for (size_t i = 0; i < n && n <= FEW; i++) {
    for (size_t j = 0; j < i; j++) {
      if (edge[i][0] == edge[j][1] && edge[i][1] == edge[j][0]) {
        return false;
      }
    }
  }
  return n <= FEW;
}

/* The vertex of polygon p (a place) with the lowest number. */
static size_t
lowest_vertex(const sg_dense *d, size_t p, size_t first, const uint32_t *number)
{
  size_t low = (size_t)d->from[d->list[d->list_begin[p]]];

  for (size_t k = d->list_begin[p]; k < d->list_begin[p + 1]; k++) {
    size_t v = (size_t)d->from[d->list[k]];
    low = number[v - first] < number[low - first] ? v : low;
  }
  return low;
}

/* Twice the area of polygon p as a vector: of its vertices where they were or,
 * if `at`, where they are now. From its lowest vertex, so that a triangle is
 * summed in one way only. */
static void
area_of(const sg_dense *d, size_t p, size_t first, const uint32_t *number,
        const double (*at)[3], double out[3])
{
  size_t low = lowest_vertex(d, p, first, number);
  const double *o = at ? at[number[low - first]] : d->at[low];

  out[0] = out[1] = out[2] = 0;
  for (size_t k = d->list_begin[p]; k < d->list_begin[p + 1]; k++) {
    size_t from = (size_t)d->from[d->list[k]], to = (size_t)d->to[d->list[k]];
    const double *a = at ? at[number[from - first]] : d->at[from];
    const double *b = at ? at[number[to - first]] : d->at[to];
    for (int i = 0; i < 3; i++) {
      int x = (i + 1) % 3, y = (i + 2) % 3;
      out[i] += (a[x] - o[x]) * (b[y] - o[y]) - (a[y] - o[y]) * (b[x] - o[x]);
    }
  }
}

static unsigned char
turn_of(const sg_boundary_source *source, size_t p, size_t first,
        const uint32_t *number, const sg_boundary *b)
{
  double was[3] = {0}, is[3];

  if (source->normal) {
    memcpy(was, source->normal[p], sizeof was);
  }
  if (was[0] == 0 && was[1] == 0 && was[2] == 0) {
    area_of(source->dense, p, first, number, NULL, was);
  }
  area_of(source->dense, p, first, number, (const double(*)[3])b->at, is);
  if (is[0] == 0 && is[1] == 0 && is[2] == 0) {
    return SG_NO_AREA;
  }
  return was[0] * is[0] + was[1] * is[1] + was[2] * is[2] < 0 ? SG_TURNED
                                                              : SG_UPRIGHT;
}

/* The edges of polygon p behind those that are there. */
static void
take_face(const sg_boundary_source *source, size_t p, const uint32_t *number,
          sg_boundary *out)
{
  const sg_dense *d = source->dense;
  size_t first = d->vertex_begin[source->s];
  uint32_t begin = out->begin[out->faces];
  int32_t(*edge)[2] = out->edge + begin;
  size_t all = d->list_begin[p + 1] - d->list_begin[p], n = 0;
  bool moved = false;

  for (size_t k = d->list_begin[p]; k < d->list_begin[p + 1]; k++) {
    int32_t e = d->list[k];
    edge[n][0] = (int32_t)number[(size_t)d->from[e] - first];
    edge[n][1] = (int32_t)number[(size_t)d->to[e] - first];
    moved |= out->moved[edge[n][0]] != 0;
    n += edge[n][0] != edge[n][1];
  }
  if (!is_plain(edge, n)) {
    n = sg_edges_cancel(edge, n);
  }
  if (n > 0) {
    out->turned[out->faces] =
        moved ? turn_of(source, p, first, number, out) : SG_UPRIGHT;
    out->changed[out->faces++] = moved || all != 3 || n != 3;
    out->begin[out->faces] = begin + (uint32_t)n;
  }
}

static sg_boundary_end
make_faces(const sg_boundary_source *source, const uint32_t *number,
           const sg_poll *poll, sg_boundary *out)
{
  const sg_dense *d = source->dense;
  size_t first = d->polygon_begin[source->s];
  size_t end = d->polygon_begin[source->s + 1];
  size_t edges = d->list_begin[end] - d->list_begin[first];

  out->begin = malloc((end - first + 1) * sizeof *out->begin);
  out->edge = malloc((edges + 1) * sizeof *out->edge);
  out->changed = malloc(end - first + 1);
  out->turned = malloc(end - first + 1);
  if (!out->begin || !out->edge || !out->changed || !out->turned) {
    return SG_BOUNDARY_NO_MEMORY;
  }
  out->begin[0] = 0;
  for (size_t p = first; p < end; p++) {
    if (p % POLL_EVERY == 0 && sg_poll_stop(poll)) {
      return SG_BOUNDARY_STOPPED;
    }
    take_face(source, p, number, out);
  }
  return SG_BOUNDARY_DONE;
}

sg_boundary_end
sg_boundary_make(const sg_boundary_source *source, const sg_rounding *rounding,
                 const sg_poll *poll, sg_boundary *out)
{
  const uint32_t *begin = source->dense->vertex_begin + source->s;
  uint32_t *number = malloc((begin[1] - begin[0] + 1u) * sizeof *number);

  *out = (sg_boundary){0};
  sg_boundary_end end = number
                            ? make_vertices(source, rounding, poll, number, out)
                            : SG_BOUNDARY_NO_MEMORY;
  if (end == SG_BOUNDARY_DONE) {
    end = make_faces(source, number, poll, out);
  }
  free(number);
  return end;
}

void
sg_boundary_clear(sg_boundary *boundary)
{
  free(boundary->at);
  free(boundary->was);
  free(boundary->moved);
  free(boundary->begin);
  free(boundary->edge);
  free(boundary->changed);
  free(boundary->turned);
  *boundary = (sg_boundary){0};
}
