/* work_near.c -- contacts that rounding has opened: the second half of
 * sg_work_resolve(), see work.h.
 *
 * Layer: kernel. Inexact on purpose: what is nearer than `reach` becomes one
 * vertex. Sorted along one axis of the picture, so that near ones are found
 * side by side.
 */
#include "engine/search.h"
#include "number/vector.h"
#include "work_private.h"

#include <math.h>
#include <stdlib.h>

/* The vertices that have edges, in order along the picture's first axis. */
typedef struct row {
  double along;
  int32_t vertex;
} row;

typedef struct rows {
  row *item;
  size_t n;
} rows;

SG_ORDER(by_along, row, SG_BY(along) SG_BY(vertex));

static bool
rows_open(rows *out, const sg_work *work)
{
  *out = (rows){malloc(((size_t)work->vertices + 1) * sizeof *out->item), 0};
  if (!out->item) {
    return false;
  }
  for (int32_t v = 0; v < work->vertices; v++) {
    if (sg_work_has_edges(work, v)) {
      out->item[out->n++] = (row){work->vertex[v].at[0], v};
    }
  }
  qsort(out->item, out->n, sizeof *out->item, by_along);
  return true;
}

/* The first row from `low` on. */
static size_t
first_from(const rows *in, double low)
{
  size_t at;

  SG_SEARCH(at, 0, in->n, in->item[at].along < low);
  return at;
}

/* Vertices within reach become the one of them that entered first. */
static bool
merge_near(sg_work *work, const rows *in, double reach)
{
  for (size_t i = 0; i < in->n; i++) {
    int32_t v = in->item[i].vertex;
    for (size_t j = i + 1;
         j < in->n && in->item[j].along - in->item[i].along <= reach &&
         sg_work_step(work, 1);
         j++) {
      int32_t w = in->item[j].vertex;
      if (!sg_work_has_edges(work, v) || !sg_work_has_edges(work, w) ||
          sg_distance(work->vertex[v].point.p, work->vertex[w].point.p) >
              reach) {
        continue;
      }
      if (!sg_work_move_edges(work, v < w ? w : v, v < w ? v : w)) {
        return false;
      }
    }
  }
  return true;
}

/* Where on a-b the vertex v is, strictly between 0 and 1; false: it is not
 * within reach, or beside an end. */
static bool
foot(const sg_work *work, int32_t a, int32_t b, int32_t v, double reach,
     double *out)
{
  const double *p = work->vertex[a].point.p, *q = work->vertex[b].point.p,
               *r = work->vertex[v].point.p;
  double square = 0, dot = 0, at[3];

  for (int k = 0; k < 3; k++) {
    square += (q[k] - p[k]) * (q[k] - p[k]);
    dot += (r[k] - p[k]) * (q[k] - p[k]);
  }
  *out = dot / square;
  if (!(*out > 0 && *out < 1)) {
    return false;
  }
  for (int k = 0; k < 3; k++) {
    at[k] = p[k] + *out * (q[k] - p[k]);
  }
  return sg_distance(at, r) <= reach;
}

/* Splits an edge at the vertices within reach of its inside. `found` has room
 * for all vertices. */
static bool
split_near(sg_work *work, const rows *in, int32_t edge, double reach,
           row *found)
{
  int32_t a = work->edge[edge].edge.start, b = work->edge[edge].edge.end;
  double low = fmin(work->vertex[a].at[0], work->vertex[b].at[0]) - reach;
  double high = fmax(work->vertex[a].at[0], work->vertex[b].at[0]) + reach;
  size_t n = 0;

  for (size_t i = first_from(in, low);
       i < in->n && in->item[i].along <= high && sg_work_step(work, 1); i++) {
    int32_t v = in->item[i].vertex;
    double at;
    if (v != a && v != b && sg_work_has_edges(work, v) &&
        foot(work, a, b, v, reach, &at)) {
      found[n++] = (row){at, v};
    }
  }
  qsort(found, n, sizeof *found, by_along);
  for (size_t i = 0; i < n; i++) {
    int32_t first = sg_work_split(work, edge, found[i].vertex);
    if (!first) {
      return false;
    }
    edge = first + 1;
  }
  return true;
}

bool
sg_work_join_near(sg_work *work, double reach)
{
  rows in;

  if (!rows_open(&in, work)) {
    return false;
  }
  row *found = malloc((in.n + 1) * sizeof *found);
  bool done = found && merge_near(work, &in, reach);
  int32_t last = work->youngest;
  for (int32_t e = work->oldest, next; done && e && e <= last; e = next) {
    next = work->edge[e].younger;
    done = split_near(work, &in, e, reach, found);
  }
  free(found);
  free(in.item);
  return done;
}
