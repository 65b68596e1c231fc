/* boundary.c -- see boundary.h. */
#include "boundary.h"
#include "boundary_touched.h"
#include "polygon/flatness.h"
#include "rows/sort.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ASK_EVERY = 65536 };

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
end_of(sg_sort_end end)
{
  return end == SG_SORTED         ? SG_BOUNDARY_DONE
         : end == SG_SORT_STOPPED ? SG_BOUNDARY_STOPPED
                                  : SG_BOUNDARY_NO_MEMORY;
}

/* By x, in which most vertices differ: `sorted` gets them from `from`. */
static sg_boundary_end
sort_along_x(const placed *from, size_t n, const sg_cancel *cancel,
             placed *sorted)
{
  sg_measured *x = malloc((n + 1) * sizeof *x);
  sg_sort_end end = SG_SORT_NO_MEMORY;

  for (size_t i = 0; x && i < n; i++) {
    x[i] = (sg_measured){from[i].at[0], (uint32_t)i};
  }
  if (x) {
    end = sg_sort_measured(x, n, cancel);
  }
  for (size_t i = 0; end == SG_SORTED && i < n; i++) {
    sorted[i] = from[x[i].of];
  }
  free(x);
  return end_of(end);
}

/* Those of one x among each other. */
static sg_boundary_end
sort_across(placed *sorted, size_t n, const sg_cancel *cancel)
{
  sg_sort_end how = SG_SORTED;

  for (size_t i = 0, end; how == SG_SORTED && i < n; i = end) {
    for (end = i + 1; end < n && sorted[end].at[0] == sorted[i].at[0]; end++) {
    }
    how = sg_sort(sorted + i, end - i, sizeof *sorted, compare_placed, cancel);
  }
  return end_of(how);
}

static sg_boundary_end
make_vertices(const sg_boundary_source *source, const sg_rounding *rounding,
              const sg_cancel *cancel, uint32_t *number, sg_boundary *out)
{
  const sg_dense *d = source->dense;
  size_t first = d->vertex_begin[source->s];
  size_t n = d->vertex_begin[source->s + 1] - first;
  placed *from = malloc((n + 1) * sizeof *from);
  placed *sorted = malloc((n + 1) * sizeof *sorted);
  sg_boundary_end end = SG_BOUNDARY_NO_MEMORY;

  out->at = malloc((n + 1) * sizeof *out->at);
  out->was = malloc((n + 1) * sizeof *out->was);
  out->moved = malloc(n + 1);
  if (from && sorted && out->at && out->was && out->moved) {
    end = place(source, first, n, rounding, from)
              ? sort_along_x(from, n, cancel, sorted)
              : SG_BOUNDARY_TOO_FAR;
  }
  free(from);
  if (end == SG_BOUNDARY_DONE) {
    end = sort_across(sorted, n, cancel);
  }
  if (end == SG_BOUNDARY_DONE) {
    number_vertices(sorted, n, (const double(*)[3])d->at + first, number, out);
  }
  free(sorted);
  return end;
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

/* A polygon, or one of its triangles, on its way to a face. */
typedef struct outline {
  size_t polygon;     /* a place */
  int32_t (*side)[2]; /* [n] from, to: places of vertices */
  size_t n;
} outline;

/* What faces are made with. */
typedef struct face_maker {
  const sg_boundary_source *source;
  size_t first;           /* vertex */
  const uint32_t *number; /* [vertices] */
  sg_boundary *out;
} face_maker;

/* The vertex of an outline with the lowest number. */
static size_t
lowest_vertex(const face_maker *m, const outline *o)
{
  size_t low = (size_t)o->side[0][0];

  for (size_t i = 0; i < o->n; i++) {
    size_t v = (size_t)o->side[i][0];
    low = m->number[v - m->first] < m->number[low - m->first] ? v : low;
  }
  return low;
}

/* Twice the area of an outline as a vector: of its vertices where they were or,
 * if `at`, where they are now. From its lowest vertex, so that a triangle is
 * summed in one way only. */
static void
area_of(const face_maker *m, const outline *o, const double (*at)[3],
        double out[3])
{
  const sg_dense *d = m->source->dense;
  size_t low = lowest_vertex(m, o);
  const double *c = at ? at[m->number[low - m->first]] : d->at[low];

  out[0] = out[1] = out[2] = 0;
  for (size_t i = 0; i < o->n; i++) {
    size_t from = (size_t)o->side[i][0], to = (size_t)o->side[i][1];
    const double *a = at ? at[m->number[from - m->first]] : d->at[from];
    const double *b = at ? at[m->number[to - m->first]] : d->at[to];
    for (int k = 0; k < 3; k++) {
      int x = (k + 1) % 3, y = (k + 2) % 3;
      out[k] += (a[x] - c[x]) * (b[y] - c[y]) - (a[y] - c[y]) * (b[x] - c[x]);
    }
  }
}

static unsigned char
turn_of(const face_maker *m, const outline *o)
{
  const double(*normal)[3] = m->source->normal;
  double was[3] = {0}, is[3];

  if (normal) {
    memcpy(was, normal[o->polygon], sizeof was);
  }
  if (was[0] == 0 && was[1] == 0 && was[2] == 0) {
    area_of(m, o, NULL, was);
  }
  area_of(m, o, (const double(*)[3])m->out->at, is);
  if (is[0] == 0 && is[1] == 0 && is[2] == 0) {
    return SG_NO_AREA;
  }
  return was[0] * is[0] + was[1] * is[1] + was[2] * is[2] < 0 ? SG_TURNED
                                                              : SG_UPRIGHT;
}

/* The edges of an outline behind those that are there. */
static void
take_face(const face_maker *m, const outline *o, bool part)
{
  sg_boundary *out = m->out;
  uint32_t begin = out->begin[out->faces];
  int32_t(*edge)[2] = out->edge + begin;
  size_t n = 0;
  bool moved = false;

  for (size_t i = 0; i < o->n; i++) {
    edge[n][0] = (int32_t)m->number[(size_t)o->side[i][0] - m->first];
    edge[n][1] = (int32_t)m->number[(size_t)o->side[i][1] - m->first];
    moved |= out->moved[edge[n][0]] != 0;
    n += edge[n][0] != edge[n][1];
  }
  if (!is_plain(edge, n)) {
    n = sg_edges_cancel(edge, n);
  }
  if (n > 0) {
    out->turned[out->faces] = moved ? turn_of(m, o) : SG_UPRIGHT;
    out->changed[out->faces++] = part || moved || o->n != 3 || n != 3;
    out->begin[out->faces] = begin + (uint32_t)n;
  }
}

static void
take_polygon(const face_maker *m, size_t p, outline *o)
{
  const sg_dense *d = m->source->dense;

  *o = (outline){p, o->side, 0};
  for (size_t k = d->list_begin[p]; k < d->list_begin[p + 1]; k++) {
    o->side[o->n][0] = d->from[d->list[k]];
    o->side[o->n++][1] = d->to[d->list[k]];
  }
  take_face(m, o, false);
}

static void
take_triangle(const face_maker *m, uint32_t t, outline *o)
{
  const sg_dense *d = m->source->dense;

  *o = (outline){(size_t)d->polygon_of[t], o->side, 3};
  for (int k = 0; k < 3; k++) {
    o->side[k][0] = d->corner[t][k];
    o->side[k][1] = d->corner[t][(k + 1) % 3];
  }
  take_face(m, o, true);
}

/* Room for all faces: those polygons that are touched inside become triangles.
 * Returns the most sides of any, or 0: no memory. */
static size_t
face_room(const sg_dense *d, size_t s, const sg_touched *touched,
          sg_boundary *out)
{
  size_t first = d->polygon_begin[s], end = d->polygon_begin[s + 1];
  size_t more = touched->begin ? touched->begin[end - first] : 0;
  size_t edges = d->list_begin[end] - d->list_begin[first] + 3 * more;
  size_t faces = end - first + more, most = 3;

  out->begin = malloc((faces + 1) * sizeof *out->begin);
  out->edge = malloc((edges + 1) * sizeof *out->edge);
  out->changed = malloc(faces + 1);
  out->turned = malloc(faces + 1);
  for (size_t p = first; p < end; p++) {
    size_t n = d->list_begin[p + 1] - d->list_begin[p];
    most = n > most ? n : most;
  }
  return out->begin && out->edge && out->changed && out->turned ? most : 0;
}

static sg_boundary_end
take_faces(const face_maker *m, const sg_touched *touched,
           const sg_cancel *cancel, outline *o)
{
  const sg_dense *d = m->source->dense;
  size_t first = d->polygon_begin[m->source->s];
  size_t end = d->polygon_begin[m->source->s + 1];

  m->out->begin[0] = 0;
  for (size_t p = first; p < end; p++) {
    const uint32_t *begin =
        touched->begin ? touched->begin + (p - first) : NULL;

    if (p % ASK_EVERY == 0 && sg_cancelled(cancel)) {
      return SG_BOUNDARY_STOPPED;
    }
    if (!begin || begin[0] == begin[1]) {
      take_polygon(m, p, o);
      continue;
    }
    for (uint32_t i = begin[0]; i < begin[1]; i++) {
      take_triangle(m, touched->triangle[i], o);
    }
  }
  return SG_BOUNDARY_DONE;
}

static sg_boundary_end
make_faces(const sg_boundary_source *source, const uint32_t *number,
           const sg_cancel *cancel, sg_boundary *out)
{
  const sg_dense *d = source->dense;
  const face_maker m = {source, d->vertex_begin[source->s], number, out};
  outline o = {0};
  sg_touched touched;
  bool stopped;

  if (!sg_touched_find(d, source->s, number, source->divided, cancel, &touched,
                       &stopped)) {
    return stopped ? SG_BOUNDARY_STOPPED : SG_BOUNDARY_NO_MEMORY;
  }
  size_t most = face_room(d, source->s, &touched, out);

  o.side = malloc((most + 1) * sizeof *o.side);
  sg_boundary_end end = most > 0 && o.side
                            ? take_faces(&m, &touched, cancel, &o)
                            : SG_BOUNDARY_NO_MEMORY;
  free(o.side);
  sg_touched_clear(&touched);
  return end;
}

/* The coarsest of what the source was, the grid and float32. */
static double
grain_of(const sg_boundary_source *source, const sg_rounding *rounding,
         const sg_boundary *boundary)
{
  double grain = fmax(source->dense->grain[source->s], rounding->grid);
  double largest = 0;

  for (size_t i = 0; i < boundary->vertices && rounding->single; i++) {
    for (int k = 0; k < 3; k++) {
      largest = fmax(largest, fabs(boundary->at[i][k]));
    }
  }
  return fmax(grain, sg_flatness_single(largest));
}

sg_boundary_end
sg_boundary_make(const sg_boundary_source *source, const sg_rounding *rounding,
                 const sg_cancel *cancel, sg_boundary *out)
{
  const uint32_t *begin = source->dense->vertex_begin + source->s;
  uint32_t *number = malloc((begin[1] - begin[0] + 1u) * sizeof *number);

  *out = (sg_boundary){0};
  sg_boundary_end end =
      number ? make_vertices(source, rounding, cancel, number, out)
             : SG_BOUNDARY_NO_MEMORY;
  if (end == SG_BOUNDARY_DONE) {
    out->grain = grain_of(source, rounding, out);
    end = make_faces(source, number, cancel, out);
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
