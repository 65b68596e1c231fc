/* simplify_open.c -- see simplify_private.h */
#include "number/vector.h"

#include "engine/search.h"
#include "rows/sort.h"
#include "simplify_private.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A border holds as an area of so many squares of its edges, a crease of so
 * many; and this is the cosine of the bend of a crease. */
#define BORDER        10.0
#define CREASE        0.2
#define CREASE_COSINE 0.77

typedef struct edge_side {
  uint64_t pair; /* lower and upper vertex */
  uint32_t corner;
} edge_side;

/* In coordinates about the middle of the mesh, by its size. */
void
sg_simplify_local(const sg_simplify_work *w, const double p[3], double out[3])
{
  for (int k = 0; k < 3; k++) {
    out[k] = (p[k] - w->middle[k]) / w->size;
  }
}

/* Twice the area vector of triangle t, with vertex `moved` at `to`. */
void
sg_simplify_area(const sg_simplify_work *w, int32_t t, int32_t moved,
                 const double to[3], double n[3], double *squares)
{
  double p[3][3], u[3], v[3], o[3];

  for (int k = 0; k < 3; k++) {
    int32_t x = w->corner[3 * t + k];
    sg_simplify_local(w, x == moved ? to : w->at[x], p[k]);
  }
  sg_minus(p[1], p[0], u);
  sg_minus(p[2], p[0], v);
  sg_minus(p[2], p[1], o);
  sg_cross(u, v, n);
  *squares = sg_dot(u, u) + sg_dot(v, v) + sg_dot(o, o);
}

size_t
sg_simplify_corners(const sg_simplify_work *w, int32_t v)
{
  size_t n = 0;

  for (int32_t c = w->first[v]; c >= 0; c = w->next[c]) {
    n += w->corner[c] == v;
  }
  return n;
}

/* ---- the mesh ---- */

static double
weight_of(const sg_simplify_work *w, int32_t v)
{
  return w->weight ? w->weight[v] : 1;
}

static void
add_face_plane(sg_simplify_work *w, int32_t t)
{
  double n[3], squares, p[3];

  sg_simplify_area(w, t, -1, NULL, n, &squares);
  double twice = sqrt(sg_dot(n, n));
  if (!(twice > 0)) {
    return;
  }
  for (int k = 0; k < 3; k++) {
    n[k] /= twice;
  }
  for (int k = 0; k < 3; k++) {
    sg_quadric *q = &w->quadric[w->corner[3 * t + k]];

    sg_simplify_local(w, w->at[w->corner[3 * t + k]], p);
    double weight = twice / 2 * weight_of(w, w->corner[3 * t + k]);
    sg_quadric_add_plane(q, n, p, weight);
    q->area += weight;
  }
}

/* The plane through the edge that begins at corner c, across its triangle. */
static void
add_edge_plane(sg_simplify_work *w, uint32_t c, double share)
{
  double n[3], squares, p[3], q[3], u[3], across[3];
  int32_t a, b;

  sg_simplify_ends(w, c, &a, &b);
  sg_simplify_area(w, (int32_t)(c / 3), -1, NULL, n, &squares);
  sg_simplify_local(w, w->at[a], p);
  sg_simplify_local(w, w->at[b], q);
  sg_minus(q, p, u);
  sg_cross(u, n, across);
  double length = sqrt(sg_dot(across, across));
  if (!(length > 0)) {
    return;
  }
  for (int k = 0; k < 3; k++) {
    across[k] /= length;
  }
  share *= sg_dot(u, u);
  sg_quadric_add_plane(&w->quadric[a], across, p, share * weight_of(w, a));
  sg_quadric_add_plane(&w->quadric[b], across, p, share * weight_of(w, b));
}

static bool
is_crease(const sg_simplify_work *w, uint32_t c, uint32_t d)
{
  double n[3], m[3], squares;

  sg_simplify_area(w, (int32_t)(c / 3), -1, NULL, n, &squares);
  sg_simplify_area(w, (int32_t)(d / 3), -1, NULL, m, &squares);
  return sg_dot(n, m) < CREASE_COSINE * sqrt(sg_dot(n, n)) * sqrt(sg_dot(m, m));
}

static void
take_edge(sg_simplify_work *w, const edge_side *side, size_t n)
{
  uint32_t c = side[0].corner, d = side[n - 1].corner;
  int32_t a, b, from, to;

  sg_simplify_ends(w, c, &a, &b);
  sg_simplify_ends(w, d, &from, &to);
  if (n == 1) {
    w->flag[a] |= SG_ON_BORDER;
    w->flag[b] |= SG_ON_BORDER;
    add_edge_plane(w, c, BORDER);
  } else if (n == 2 && from == b) {
    w->across[c] = (int32_t)d;
    w->across[d] = (int32_t)c;
    if (is_crease(w, c, d)) {
      add_edge_plane(w, c, CREASE);
      add_edge_plane(w, d, CREASE);
    }
  } else {
    w->flag[a] |= SG_HELD;
    w->flag[b] |= SG_HELD;
  }
}

SG_ORDER(compare_sides, edge_side, SG_BY(pair) SG_BY(corner));

static bool
take_edges(sg_simplify_work *w)
{
  size_t n = 3 * w->triangles;
  edge_side *side = malloc((n + 1) * sizeof *side);
  bool good = side != NULL;

  for (uint32_t c = 0; good && c < n; c++) {
    int32_t a, b;

    sg_simplify_ends(w, c, &a, &b);
    side[c].corner = c;
    side[c].pair = a < b ? (uint64_t)(uint32_t)a << 32 | (uint32_t)b
                         : (uint64_t)(uint32_t)b << 32 | (uint32_t)a;
  }
  good = good &&
         sg_sort(side, n, sizeof *side, compare_sides, w->cancel) == SG_SORTED;
  for (size_t i = 0, k; good && i < n; i = k) {
    for (k = i + 1; k < n && side[k].pair == side[i].pair; k++) {
    }
    take_edge(w, &side[i], k - i);
  }
  free(side);
  return good;
}

/* How many triangles go round vertex v from corner c, both ways. */
static size_t
fan_size(const sg_simplify_work *w, uint32_t c)
{
  size_t n = 1;
  uint32_t x = c;

  for (;;) { /* over the edge that ends at v */
    int32_t y = w->across[x - x % 3 + (x + 2) % 3];

    if (y < 0) {
      break;
    }
    x = (uint32_t)y;
    if (x == c) {
      return n;
    }
    n++;
  }
  for (x = c; w->across[x] >= 0; n++) { /* over the one that begins there */
    uint32_t y = (uint32_t)w->across[x];

    x = y - y % 3 + (y + 1) % 3;
  }
  return n;
}

static void
hold_several_fans(sg_simplify_work *w)
{
  for (size_t v = 0; v < w->vertices; v++) {
    if (w->first[v] >= 0 && !(w->flag[v] & SG_HELD) &&
        fan_size(w, (uint32_t)w->first[v]) !=
            sg_simplify_corners(w, (int32_t)v)) {
      w->flag[v] |= SG_HELD;
    }
  }
}

/* ---- from and to ---- */

static void
measure(sg_simplify_work *w)
{
  double low[3] = {INFINITY, INFINITY, INFINITY};
  double high[3] = {-INFINITY, -INFINITY, -INFINITY};

  for (size_t v = 0; v < w->vertices; v++) {
    for (int k = 0; k < 3; k++) {
      low[k] = fmin(low[k], w->at[v][k]);
      high[k] = fmax(high[k], w->at[v][k]);
    }
  }
  for (int k = 0; k < 3 && w->vertices > 0; k++) {
    w->middle[k] = low[k] / 2 + high[k] / 2;
    w->size = fmax(w->size, high[k] - low[k]);
  }
  w->size = w->size > 0 ? w->size : 1;
}

static bool
make_room(sg_simplify_work *w, const sg_simplify_mesh *mesh)
{
  size_t v = w->vertices = mesh->vertices, n = 3 * mesh->triangles;

  w->triangles = w->left = mesh->triangles;
  w->weight = mesh->weight;
  w->at = malloc((v + 1) * sizeof *w->at);
  w->into = malloc((v + 1) * sizeof *w->into);
  w->first = malloc((v + 1) * sizeof *w->first);
  w->last = malloc((v + 1) * sizeof *w->last);
  w->quadric = calloc(v + 1, sizeof *w->quadric);
  w->stamp = calloc(v + 1, sizeof *w->stamp);
  w->seen = calloc(v + 1, sizeof *w->seen);
  w->flag = calloc(v + 1, 1);
  w->corner = malloc((n + 1) * sizeof *w->corner);
  w->next = malloc((n + 1) * sizeof *w->next);
  w->across = malloc((n + 1) * sizeof *w->across);
  return w->at && w->into && w->first && w->last && w->quadric && w->stamp &&
         w->seen && w->flag && w->corner && w->next && w->across;
}

static void
fill_work(sg_simplify_work *w, const sg_simplify_mesh *mesh)
{
  for (size_t v = 0; v < w->vertices; v++) {
    memcpy(w->at[v], mesh->at[v], sizeof w->at[v]);
    w->into[v] = (int32_t)v;
    w->first[v] = w->last[v] = -1;
  }
  measure(w);
  for (size_t c = 0; c < 3 * w->triangles; c++) {
    int32_t v = w->corner[c] = mesh->corner[c / 3][c % 3];

    w->next[c] = w->across[c] = -1;
    *(w->last[v] < 0 ? &w->first[v] : &w->next[w->last[v]]) = (int32_t)c;
    w->last[v] = (int32_t)c;
  }
  for (size_t t = 0; t < w->triangles; t++) {
    add_face_plane(w, (int32_t)t);
  }
}

/* The places and what went where are the result's; the rest is freed. */
void
sg_simplify_close(sg_simplify_work *w, sg_simplified *out)
{
  out->at = w->at;
  out->into = w->into;
  free(w->first);
  free(w->last);
  free(w->quadric);
  free(w->stamp);
  free(w->seen);
  free(w->flag);
  free(w->corner);
  free(w->next);
  free(w->across);
  free(w->heap.item);
}

bool
sg_simplify_result(const sg_simplify_work *w, sg_simplified *out)
{
  out->vertices = w->vertices;
  out->corner = malloc((w->left + 1) * sizeof *out->corner);
  out->triangle_of = malloc((w->left + 1) * sizeof *out->triangle_of);
  if (!out->corner || !out->triangle_of) {
    return false;
  }
  for (size_t t = 0; t < w->triangles; t++) {
    if (w->corner[3 * t] >= 0) {
      memcpy(out->corner[out->triangles], &w->corner[3 * t],
             sizeof *out->corner);
      out->triangle_of[out->triangles++] = (int32_t)t;
    }
  }
  for (size_t v = 0; v < w->vertices; v++) {
    int32_t x = (int32_t)v;

    while (w->into[x] != x) { /* halves the way of those that come after */
      x = w->into[x] = w->into[w->into[x]];
    }
    w->into[v] = x;
  }
  return true;
}

bool
sg_simplify_open(sg_simplify_work *w, const sg_simplify_mesh *mesh)
{
  if (!make_room(w, mesh)) {
    return false;
  }
  fill_work(w, mesh);
  if (!take_edges(w)) {
    return false;
  }
  hold_several_fans(w);
  return true;
}
