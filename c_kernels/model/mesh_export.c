/* mesh_export.c -- see mesh_export.h. */
#include "mesh_export.h"
#include "engine/list.h"
#include "engine/search.h"
#include "polygon/loops.h"

#include <math.h>
#include <stdlib.h>

typedef struct exporter {
  const sg_dense *d;
  sg_mesh *mesh;
  bool triangles;
  uint32_t *begin; /* [polygons + 1] triangles by polygon */
  uint32_t *triangle;
  unsigned char *used; /* [edges] in a polygon */
  uint32_t *seen;      /* [vertices] the stamp of who saw it last */
  uint32_t stamp;
  int32_t *from, *to; /* edges of the polygon at work */
  size_t room;
  sg_loops loops;
} exporter;

static bool
order_triangles(exporter *x)
{
  const sg_dense *d = x->d;

  x->used = calloc(d->edges + 1, 1);
  x->seen = calloc(d->vertices + 1, sizeof *x->seen);
  if (!sg_dense_by_polygon(d, &x->begin, &x->triangle) || !x->used ||
      !x->seen) {
    return false;
  }
  for (size_t i = 0; i < d->list_begin[d->polygons]; i++) {
    x->used[d->list[i]] = 1;
  }
  return true;
}

static bool
make_room(exporter *x, size_t n)
{
  size_t room = x->room; /* of both */

  return sg_list_need(&x->from, n, &room, sizeof *x->from) &&
         sg_list_need(&x->to, n, &x->room, sizeof *x->to);
}

/* An edge of the polygon at work, by its ends whatever its direction. */
typedef struct ends {
  uint64_t pair; /* lower and upper vertex */
  int32_t edge;
} ends;

SG_ORDER(compare_ends, ends, SG_BY(pair) SG_BY(edge));

/* Marks (from = -1) pairs of opposite edges. */
static void
mark_seams(exporter *x, const ends *end, size_t n)
{
  for (size_t i = 0; i + 1 < n; i++) {
    int32_t e = end[i].edge, f = end[i + 1].edge;
    if (end[i].pair == end[i + 1].pair && x->from[e] == x->to[f]) {
      x->from[e] = x->from[f] = -1;
      i++;
    }
  }
}

/* Takes the seams out of the n edges at work; *n of them stay, in order. */
static bool
drop_seams(exporter *x, size_t *n)
{
  ends *end = malloc(*n * sizeof *end);
  size_t kept = 0;

  if (!end) {
    return false;
  }
  for (size_t i = 0; i < *n; i++) {
    uint64_t a = (uint64_t)x->from[i], b = (uint64_t)x->to[i];
    end[i] = (ends){a < b ? a << 32 | b : b << 32 | a, (int32_t)i};
  }
  qsort(end, *n, sizeof *end, compare_ends);
  mark_seams(x, end, *n);
  free(end);
  for (size_t i = 0; i < *n; i++) {
    if (x->from[i] >= 0) {
      x->from[kept] = x->from[i];
      x->to[kept++] = x->to[i];
    }
  }
  *n = kept;
  return true;
}

/* True if the n edges at work, joined, are one loop that passes each of its
 * vertices once. */
static bool
is_simple(exporter *x, size_t n)
{
  if (n < 3 || x->loops.loops != 1 || x->loops.open) {
    return false;
  }
  x->stamp++;
  for (size_t i = 0; i < n; i++) {
    uint32_t *seen = &x->seen[x->from[i]];
    if (*seen == x->stamp) {
      return false;
    }
    *seen = x->stamp;
  }
  return true;
}

static bool
add_triangle(exporter *x, const int32_t *v, int32_t s)
{
  sg_mesh_lists *face = &x->mesh->face;

  return sg_mesh_add_corner(face, v[0]) && sg_mesh_add_corner(face, v[1]) &&
         sg_mesh_add_corner(face, v[2]) && sg_mesh_end_list(face, s);
}

static sg_export_status
add_triangles(exporter *x, size_t p, int32_t s)
{
  if (x->begin[p] == x->begin[p + 1]) {
    return SG_EXPORT_NO_TRIANGLES;
  }
  for (size_t i = x->begin[p]; i < x->begin[p + 1]; i++) {
    if (!add_triangle(x, x->d->corner[x->triangle[i]], s)) {
      return SG_EXPORT_NO_MEMORY;
    }
  }
  return SG_EXPORT_DONE;
}

static bool
add_loop(exporter *x, size_t n, int32_t s)
{
  sg_mesh_lists *face = &x->mesh->face;
  int32_t at = 0;

  for (size_t i = 0; i < n; i++) {
    if (!sg_mesh_add_corner(face, x->from[at])) {
      return false;
    }
    at = x->loops.next[at];
  }
  return sg_mesh_end_list(face, s);
}

static bool
join(exporter *x, size_t n)
{
  return sg_loops_make(&x->loops, n, x->from, x->to);
}

static sg_export_status
add_polygon(exporter *x, size_t p, int32_t s)
{
  const sg_dense *d = x->d;
  const int32_t *list = d->list + d->list_begin[p];
  size_t n = d->list_begin[p + 1] - d->list_begin[p];

  if (x->triangles && n != 3) {
    return add_triangles(x, p, s);
  }
  if (!make_room(x, n + 1)) {
    return SG_EXPORT_NO_MEMORY;
  }
  for (size_t k = 0; k < n; k++) {
    x->from[k] = d->from[list[k]];
    x->to[k] = d->to[list[k]];
  }
  if (!join(x, n)) {
    return SG_EXPORT_NO_MEMORY;
  }
  if (!is_simple(x, n) && n > 3 && (!drop_seams(x, &n) || !join(x, n))) {
    return SG_EXPORT_NO_MEMORY;
  }
  if (!is_simple(x, n)) {
    return add_triangles(x, p, s);
  }
  return add_loop(x, n, s) ? SG_EXPORT_DONE : SG_EXPORT_NO_MEMORY;
}

/* Real edges in no polygon, runs of them as one curve each. */
static bool
add_curves(exporter *x, size_t s)
{
  const sg_dense *d = x->d;
  sg_mesh_lists *curve = &x->mesh->curve;
  int32_t end = -1;

  for (size_t e = d->edge_begin[s]; e < d->edge_begin[s + 1]; e++) {
    if (x->used[e] || !d->real[e]) {
      continue;
    }
    if (d->from[e] != end) {
      if ((end >= 0 && !sg_mesh_end_list(curve, (int32_t)s)) ||
          !sg_mesh_add_corner(curve, d->from[e])) {
        return false;
      }
    }
    if (!sg_mesh_add_corner(curve, d->to[e])) {
      return false;
    }
    end = d->to[e];
  }
  return end < 0 || sg_mesh_end_list(curve, (int32_t)s);
}

static sg_export_status
export_all(exporter *x, size_t *polygon)
{
  const sg_dense *d = x->d;

  for (size_t v = 0; v < d->vertices; v++) {
    if (!sg_mesh_add_vertex(x->mesh, d->at[v])) {
      return SG_EXPORT_NO_MEMORY;
    }
  }
  for (size_t s = 0; s < d->segments; s++) {
    if (sg_mesh_add_segment(x->mesh, NULL, 0) < 0) {
      return SG_EXPORT_NO_MEMORY;
    }
    for (size_t p = d->polygon_begin[s]; p < d->polygon_begin[s + 1]; p++) {
      sg_export_status status = add_polygon(x, p, (int32_t)s);
      if (status != SG_EXPORT_DONE) {
        *polygon = p;
        return status;
      }
    }
    if (!x->triangles && !add_curves(x, s)) {
      return SG_EXPORT_NO_MEMORY;
    }
  }
  return SG_EXPORT_DONE;
}

sg_export_status
sg_mesh_export(const sg_dense *dense, bool triangles, sg_mesh *out,
               size_t *polygon)
{
  exporter x = {.d = dense, .mesh = out, .triangles = triangles};

  *out = (sg_mesh){0};
  sg_export_status status =
      order_triangles(&x) ? export_all(&x, polygon) : SG_EXPORT_NO_MEMORY;
  free(x.begin);
  free(x.triangle);
  free(x.used);
  free(x.seen);
  free(x.from);
  free(x.to);
  sg_loops_clear(&x.loops);
  for (size_t s = 0; s < dense->segments; s++) {
    out->grain = fmax(out->grain, dense->grain[s]);
  }
  if (status != SG_EXPORT_DONE) {
    sg_mesh_clear(out);
  }
  return status;
}
