/* seam_bound.c -- see seam_bound.h. */
#include "seam_bound.h"

#include "engine/search.h"
#include "rows/disjoint.h"
#include "rows/sort.h"
#include "seam_moats.h"
#include "seam_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ASK_EVERY = 16384 };

/* What is known of the vertices of a development. */
typedef struct finder {
  const sg_flattening *fl;
  const sg_cancel *cancel;
  sg_bent_vertices of;
  uint32_t *class;   /* [vertices + 1] */
  sg_measured *edge; /* [edges] of the minimum spanning tree, shortest first */
  size_t edges;
  bool pointed, some_flat; /* every vertex; some alone is balanced */
  size_t inside;           /* vertices of joints that are not on a border */
} finder;

static bool
stops(const finder *x, size_t i, bool *stopped)
{
  *stopped = *stopped || (i % ASK_EVERY == 0 && sg_cancelled(x->cancel));
  return *stopped;
}

/* ---- vertices ----------------------------------------------------------- */

/* What is bent at a face without area is not known: it is as a border. */
static void
mark_no_areas(finder *x)
{
  const sg_flat_faces *f = x->fl->faces;

  for (uint32_t i = 0; i < f->faces; i++) {
    for (uint32_t c = f->corner_begin[i];
         f->triangle_begin[i] == f->triangle_begin[i + 1] &&
         c < f->corner_begin[i + 1];
         c++) {
      x->of.border[f->vertex[c]] = true;
    }
  }
}

static bool
mark_borders(finder *x, bool *stopped)
{
  const sg_flat_faces *f = x->fl->faces;

  mark_no_areas(x);

  for (uint32_t k = 0; k < f->sides && !stops(x, k, stopped); k++) {
    uint32_t e = f->side[k].edge;
    bool real = e >= x->fl->dense->edges || x->fl->dense->real[e];
    if (real && x->fl->joints->of_side[k] == SG_NO_JOINT) {
      x->of.border[sg_flat_side_from(f, k)] = true;
      x->of.border[sg_flat_side_to(f, k)] = true;
    }
  }
  return !*stopped;
}

/* The angle of a triangle at its corner k. */
static double
angle_at(const sg_flat_faces *f, const uint32_t corner[3], int k)
{
  const double *p = f->at[corner[k]];
  const double *q = f->at[corner[(k + 1) % 3]], *r = f->at[corner[(k + 2) % 3]];
  double ux = q[0] - p[0], uy = q[1] - p[1], wx = r[0] - p[0], wy = r[1] - p[1];

  return fabs(atan2(ux * wy - uy * wx, ux * wx + uy * wy));
}

/* A whole turn for each fan of faces round a vertex: corners that joints do not
 * connect are of different ones. */
static bool
count_fans(finder *x, uint32_t *fan, bool *stopped)
{
  const sg_flat_faces *f = x->fl->faces;
  const sg_joints *js = x->fl->joints;

  for (uint32_t c = 0; c < f->corners; c++) {
    fan[c] = c;
  }
  for (uint32_t j = 0; j < js->n && !stops(x, j, stopped); j++) {
    const uint32_t *a = js->joint[j].corner[0], *b = js->joint[j].corner[1];
    sg_disjoint_join(fan, a[0], b[1]);
    sg_disjoint_join(fan, a[1], b[0]);
  }
  for (uint32_t c = 0; c < f->corners && !stops(x, c, stopped); c++) {
    x->of.bent[f->vertex[c]] += fan[c] == c ? 2 * acos(-1.0) : 0;
  }
  return !*stopped;
}

static bool
measure_bends(finder *x, bool *stopped)
{
  const sg_flat_faces *f = x->fl->faces;
  uint32_t *fan = malloc((f->corners + 1) * sizeof *fan);
  bool good = fan && count_fans(x, fan, stopped);

  free(fan);
  for (size_t t = 0; good && t < f->triangles && !stops(x, t, stopped); t++) {
    for (int k = 0; k < 3; k++) {
      x->of.bent[f->vertex[f->triangle[t][k]]] -=
          angle_at(f, f->triangle[t], k);
    }
  }
  return good && !*stopped;
}

/* Vertices that no joint has are nobody's. */
static bool
look_over(finder *x, bool *stopped)
{
  const sg_joints *js = x->fl->joints;
  bool *seen = calloc(x->of.vertices + 1, sizeof *seen);

  x->pointed = true;
  for (uint32_t j = 0; seen && j < js->n && !stops(x, j, stopped); j++) {
    for (int end = 0; end < 2 && !js->joint[j].line; end++) {
      int32_t v = js->joint[j].vertex[end];
      if (!seen[v] && !x->of.border[v]) {
        x->pointed &= x->of.bent[v] > SG_BENT_LEAST;
        x->some_flat |= sg_bends_balance(x->of.bent[v]);
        x->inside++;
      }
      seen[v] = true;
    }
  }
  free(seen);
  return seen && !*stopped;
}

/* ---- shells ------------------------------------------------------------- */

/* Each vertex's shell, as far as joints hold it together. */
static bool
find_shells(finder *x, bool *stopped)
{
  const sg_joints *js = x->fl->joints;

  for (uint32_t v = 0; v <= x->of.vertices; v++) {
    x->class[v] = v;
  }
  for (uint32_t j = 0; j < js->n && !stops(x, j, stopped); j++) {
    const int32_t *v = js->joint[j].vertex;
    sg_disjoint_join(x->class, (uint32_t)v[0], (uint32_t)v[1]);
  }
  return !*stopped;
}

/* Whether pointed vertices of a shell with a border sum to two whole turns or
 * more, so that some of them may be balanced. */
static bool
some_balance(finder *x, bool *balance, bool *stopped)
{
  size_t n = x->of.vertices;
  double *sum = calloc(n + 1, sizeof *sum);
  bool *open = calloc(n + 1, sizeof *open);
  bool good = sum && open && find_shells(x, stopped);

  *balance = false;
  for (uint32_t v = 0; good && v < n; v++) {
    uint32_t shell = sg_disjoint_root(x->class, v);
    sum[shell] += x->of.border[v] ? 0 : x->of.bent[v];
    open[shell] |= x->of.border[v];
  }
  for (size_t v = 0; good && v < n; v++) {
    *balance |= open[v] && sum[v] > 4 * acos(-1.0) - 1e-6;
  }
  free(sum);
  free(open);
  return good;
}

/* ---- tree --------------------------------------------------------------- */

static void
begin_classes(finder *x)
{
  uint32_t root = (uint32_t)x->of.vertices;

  for (uint32_t v = 0; v <= root; v++) {
    x->class[v] = v < root && x->of.border[v] ? root : v;
  }
}

/* The joints as edges between vertices, shortest first, less those that would
 * go round. */
static bool
find_tree(finder *x, double *length, bool *stopped)
{
  const sg_joints *js = x->fl->joints;
  size_t n = 0;

  *length = 0;
  for (uint32_t j = 0; j < js->n; j++) {
    if (!js->joint[j].line) {
      x->edge[n++] = (sg_measured){js->joint[j].length, j};
    }
  }
  sg_sort_end sorted = sg_sort_measured(x->edge, n, x->cancel);

  *stopped = sorted == SG_SORT_STOPPED;
  begin_classes(x);
  for (size_t i = 0; sorted == SG_SORTED && i < n && !stops(x, i, stopped);
       i++) {
    const int32_t *v = js->joint[x->edge[i].of].vertex;
    uint32_t a = sg_disjoint_root(x->class, (uint32_t)v[0]);
    uint32_t b = sg_disjoint_root(x->class, (uint32_t)v[1]);
    if (a != b) {
      sg_disjoint_join(x->class, a, b);
      *length += x->edge[i].value;
      x->edge[x->edges++] = x->edge[i];
    }
  }
  return sorted == SG_SORTED && !*stopped;
}

/* ---- forest ------------------------------------------------------------- */

SG_ORDER(by_size, double, SG_BY_AT(0));

/* Bends of the vertices inside, sorted: x->inside of them. Null: no memory. */
static double *
sorted_bends(const finder *x)
{
  const sg_joints *js = x->fl->joints;
  double *bend = malloc((x->of.vertices + 1) * sizeof *bend);
  bool *seen = calloc(x->of.vertices + 1, sizeof *seen);
  size_t n = 0;

  for (uint32_t j = 0; bend && seen && j < js->n; j++) {
    for (int k = 0; k < 2 && !js->joint[j].line; k++) {
      int32_t v = js->joint[j].vertex[k];
      if (!seen[v] && !x->of.border[v]) {
        bend[n++] = x->of.bent[v];
      }
      seen[v] = true;
    }
  }
  if (bend && seen) {
    qsort(bend, n, sizeof *bend, by_size);
  } else {
    free(bend);
    bend = NULL;
  }
  free(seen);
  return bend;
}

/* The shortest edges of the tree, so many that there are no more parts. */
static bool
find_forest(const finder *x, double *length, bool *stopped)
{
  size_t parts;
  double *bend = sorted_bends(x);
  bool good =
      bend && sg_seam_parts_most(bend, x->inside, x->cancel, &parts, stopped);

  *length = 0;
  for (size_t i = 0; good && i < x->edges && i + parts < x->inside; i++) {
    *length += x->edge[i].value;
  }
  free(bend);
  return good;
}

/* ---- all ---------------------------------------------------------------- */

static void
take(sg_seam_bound *out, double bound, sg_bound_by by)
{
  const double rounded = 1 - 1e-9;

  if (by == SG_BOUND_TREE || bound * rounded > out->bound) {
    out->bound = by == SG_BOUND_TREE ? bound : bound * rounded;
    out->by = by;
  }
}

static bool
find_bounds(finder *x, sg_seam_bound *out, bool *stopped)
{
  double length;
  bool balance;

  if (!mark_borders(x, stopped) || !measure_bends(x, stopped) ||
      !look_over(x, stopped) || !some_balance(x, &balance, stopped) ||
      !find_tree(x, &out->tree, stopped)) {
    return false;
  }
  out->by = SG_BOUND_MOATS;
  if (x->pointed && !balance) {
    take(out, out->tree, SG_BOUND_TREE);
    return true;
  }
  if (!sg_moats_grow(&x->of, x->fl->joints, x->fl->joints->n <= SG_BOUND_JOINTS,
                     x->cancel, &length, stopped)) {
    return false;
  }
  take(out, length, SG_BOUND_MOATS);
  if (!x->some_flat && x->fl->joints->n <= SG_BOUND_JOINTS) {
    if (!find_forest(x, &length, stopped)) {
      return false;
    }
    take(out, length, SG_BOUND_FOREST);
  }
  return true;
}

bool
sg_seam_bound_find(const sg_flattening *fl, const sg_cancel *cancel,
                   sg_seam_bound *out, bool *stopped)
{
  size_t n = fl->dense->vertices;
  finder x = {.fl = fl,
              .cancel = cancel,
              .of = {.vertices = n,
                     .bent = calloc(n + 1, sizeof *x.of.bent),
                     .border = calloc(n + 1, sizeof *x.of.border)},
              .class = malloc((n + 1) * sizeof *x.class),
              .edge = malloc((fl->joints->n + 1) * sizeof *x.edge)};
  bool good = x.of.bent && x.of.border && x.class && x.edge;

  *out = (sg_seam_bound){0};
  *stopped = false;
  good = good && find_bounds(&x, out, stopped);
  free(x.of.bent);
  free(x.of.border);
  free(x.class);
  free(x.edge);
  return good;
}
