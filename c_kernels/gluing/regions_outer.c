/* regions_outer.c -- which of the zones of a piece goes on without end
 * (regions_private.h).
 *
 * Its volume is minus that of all others, so it is the one that is negative.
 * Where doubles cannot tell, rationals do. A zone that has no volume at all is
 * a slit; so is what is between faces with the same corners, each two of which
 * lie on each other within what rounds, as rounding has bent them.
 */
#include "regions_private.h"

#include "number/vector.h"
#include "rows/disjoint.h"
#include "rows/edge_print.h"

#include <gmp.h>
#include <math.h>
#include <stdlib.h>

typedef struct measures {
  sg_regions_maker *m;
  double middle[3];
  double *volume, *error; /* [2 * polygons] six times, by class */
  uint32_t *count;        /* [2 * polygons] triangles; at the end: which of the
                             rationals */
  bool *unsure;           /* [polygons] by piece */
  mpq_t *exact;
  size_t exacts;
} measures;

/* ---- doubles ---- */

static void
find_middle(measures *x)
{
  const sg_dense *d = x->m->d;
  double low[3], high[3];

  for (size_t v = 0; v < d->vertices; v++) {
    for (int k = 0; k < 3; k++) {
      low[k] = v == 0 ? d->at[v][k] : fmin(low[k], d->at[v][k]);
      high[k] = v == 0 ? d->at[v][k] : fmax(high[k], d->at[v][k]);
      x->middle[k] = low[k] / 2 + high[k] / 2;
    }
  }
}

static void
add_triangle(measures *x, size_t t)
{
  const sg_dense *d = x->m->d;
  uint32_t p = (uint32_t)d->polygon_of[t];
  double r[3][3], sum = 0, size = 0;

  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      r[i][k] = d->at[d->corner[t][i]][k] - x->middle[k];
    }
  }
  for (int k = 0; k < 3; k++) {
    double a = r[1][(k + 1) % 3] * r[2][(k + 2) % 3];
    double b = r[1][(k + 2) % 3] * r[2][(k + 1) % 3];
    sum += r[0][k] * (a - b);
    size += fabs(r[0][k]) * (fabs(a) + fabs(b));
  }
  for (uint32_t side = 0; side < 2; side++) {
    uint32_t c = sg_disjoint_root(x->m->zone, 2 * p + side);
    x->volume[c] += side == 0 ? sum : -sum;
    x->error[c] += size;
    x->count[c]++;
  }
}

/* A zone whose volume doubles do not tell from none makes its piece unsure. */
static void
find_unsure(measures *x, const uint32_t *classes)
{
  sg_regions_maker *m = x->m;

  for (uint32_t c = 0; c < 2 * m->d->polygons; c++) {
    if (m->is_face[c / 2] && m->zone[c] == c) {
      uint32_t piece = sg_disjoint_root(m->piece, c / 2);
      double error = x->error[c] * (16 + (double)x->count[c]) * 0x1p-51;

      if (classes[piece] > 1 && !(fabs(x->volume[c]) > error)) {
        x->unsure[piece] = true;
      }
    }
  }
}

/* ---- rationals ---- */

static void
add_exactly(measures *x, size_t t)
{
  const sg_dense *d = x->m->d;
  uint32_t p = (uint32_t)d->polygon_of[t];
  mpq_t r[3][3], product, sum;

  mpq_inits(product, sum, NULL);
  for (int i = 0; i < 9; i++) {
    mpq_init(r[i / 3][i % 3]);
    mpq_set_d(r[i / 3][i % 3], d->at[d->corner[t][i / 3]][i % 3]);
  }
  for (int i = 0; i < 6; i++) {
    int k = i % 3, u = (k + (i < 3 ? 1 : 2)) % 3, w = (k + (i < 3 ? 2 : 1)) % 3;
    mpq_mul(product, r[0][k], r[1][u]);
    mpq_mul(product, product, r[2][w]);
    (i < 3 ? mpq_add : mpq_sub)(sum, sum, product);
  }
  for (uint32_t side = 0; side < 2; side++) {
    uint32_t c = sg_disjoint_root(x->m->zone, 2 * p + side);
    mpq_t *to = &x->exact[x->count[c]];
    (side == 0 ? mpq_add : mpq_sub)(*to, *to, sum);
  }
  for (int i = 0; i < 9; i++) {
    mpq_clear(r[i / 3][i % 3]);
  }
  mpq_clears(product, sum, NULL);
}

static bool
is_unsure(const measures *x, uint32_t p)
{
  return x->m->is_face[p] && x->unsure[sg_disjoint_root(x->m->piece, p)];
}

static bool
measure_exactly(measures *x)
{
  sg_regions_maker *m = x->m;
  const sg_dense *d = m->d;

  for (uint32_t c = 0; c < 2 * d->polygons; c++) {
    x->exacts += m->zone[c] == c && is_unsure(x, c / 2);
  }
  x->exact = malloc((x->exacts + 1) * sizeof *x->exact);
  if (!x->exact) {
    x->exacts = 0;
    return sg_regions_no_memory(m);
  }
  x->exacts = 0;
  for (uint32_t c = 0; c < 2 * d->polygons; c++) {
    if (m->zone[c] == c && is_unsure(x, c / 2)) {
      x->count[c] = (uint32_t)x->exacts;
      mpq_init(x->exact[x->exacts++]);
    }
  }
  for (size_t t = 0; t < d->triangles; t++) {
    if (is_unsure(x, (uint32_t)d->polygon_of[t])) {
      add_exactly(x, t);
      if (t % 1024 == 0 && !sg_regions_asked(m)) {
        return false;
      }
    }
  }
  return true;
}

/* ---- the least ---- */

static int
compare_volumes(const measures *x, uint32_t a, uint32_t b)
{
  if (is_unsure(x, a / 2)) {
    return mpq_cmp(x->exact[x->count[a]], x->exact[x->count[b]]);
  }
  return (x->volume[a] > x->volume[b]) - (x->volume[a] < x->volume[b]);
}

/* ---- slits ---- */

/* The same of all faces with the same corners. */
static uint64_t
print_of(const sg_regions_maker *m, uint32_t p)
{
  const sg_dense *d = m->d;
  uint64_t sum = 0;

  for (uint32_t i = d->list_begin[p]; i < d->list_begin[p + 1]; i++) {
    sum += sg_spread_bits((uint64_t)d->from[d->list[i]]);
  }
  return sum;
}

static double
area_of(const sg_dense *d, size_t t)
{
  const int32_t *c = d->corner[t];
  double u[3], w[3], normal[3];

  sg_minus(d->at[c[1]], d->at[c[0]], u);
  sg_minus(d->at[c[2]], d->at[c[0]], w);
  sg_cross(u, w, normal);
  return sg_any_length(normal) / 2;
}

/* Of the zones of unsure pieces: twins[c], what is left of the prints of faces
 * of which each has a twin; area[c]. */
static void
see_slits(const measures *x, uint64_t *twins, double *area)
{
  const sg_regions_maker *m = x->m;

  for (uint32_t p = 0; p < m->d->polygons; p++) {
    for (uint32_t side = 0; side < 2 && is_unsure(x, p); side++) {
      twins[sg_disjoint_root(m->zone, 2 * p + side)] ^= print_of(m, p);
    }
  }
  for (size_t t = 0; t < m->d->triangles; t++) {
    uint32_t p = (uint32_t)m->d->polygon_of[t];

    for (uint32_t side = 0; side < 2 && is_unsure(x, p); side++) {
      area[sg_disjoint_root(m->zone, 2 * p + side)] += area_of(m->d, t);
    }
  }
}

static bool
find_slits(measures *x)
{
  sg_regions_maker *m = x->m;
  size_t n = 2 * m->d->polygons;
  uint64_t *twins = calloc(n + 1, sizeof *twins);
  double *area = calloc(n + 1, sizeof *area);
  bool good = twins && area;

  if (good) {
    see_slits(x, twins, area);
  }
  for (uint32_t c = 0; good && c < n; c++) {
    if (m->zone[c] == c && is_unsure(x, c / 2) &&
        m->outer[sg_disjoint_root(m->piece, c / 2)] != c) {
      mpq_srcptr volume = x->exact[x->count[c]];

      m->slit[c] =
          mpq_sgn(volume) == 0 ||
          (twins[c] == 0 && fabs(mpq_get_d(volume)) / 6 <= m->near * area[c]);
    }
  }
  free(twins);
  free(area);
  return good || sg_regions_no_memory(m);
}

/* ---- the least, of each piece ---- */

static void
choose_outer(measures *x)
{
  sg_regions_maker *m = x->m;

  for (uint32_t c = 0; c < 2 * m->d->polygons; c++) {
    if (m->is_face[c / 2] && m->zone[c] == c) {
      uint32_t *outer = &m->outer[sg_disjoint_root(m->piece, c / 2)];

      *outer = *outer == SG_NOWHERE || compare_volumes(x, c, *outer) < 0
                   ? c
                   : *outer;
    }
  }
}

static bool
prepare(measures *x)
{
  sg_regions_maker *m = x->m;
  size_t n = m->d->polygons;

  x->volume = calloc(2 * n + 1, sizeof *x->volume);
  x->error = calloc(2 * n + 1, sizeof *x->error);
  x->count = calloc(2 * n + 1, sizeof *x->count);
  x->unsure = calloc(n + 1, sizeof *x->unsure);
  m->classes = calloc(n + 1, sizeof *m->classes);
  m->outer = malloc((n + 1) * sizeof *m->outer);
  m->slit = calloc(2 * n + 1, sizeof *m->slit);
  if (!x->volume || !x->error || !x->count || !x->unsure || !m->classes ||
      !m->outer || !m->slit) {
    return sg_regions_no_memory(m);
  }
  for (uint32_t p = 0; p < n; p++) {
    m->outer[p] = SG_NOWHERE;
  }
  for (uint32_t c = 0; c < 2 * n; c++) {
    if (m->is_face[c / 2] && sg_disjoint_root(m->zone, c) == c) {
      m->classes[sg_disjoint_root(m->piece, c / 2)]++;
    }
  }
  return true;
}

bool
sg_regions_outer(sg_regions_maker *m)
{
  measures x = {.m = m};
  bool good = prepare(&x);

  if (good) {
    find_middle(&x);
    for (size_t t = 0; t < m->d->triangles; t++) {
      if (m->is_face[m->d->polygon_of[t]]) {
        add_triangle(&x, t);
      }
    }
    find_unsure(&x, m->classes);
    good = measure_exactly(&x);
  }
  if (good) {
    choose_outer(&x);
    good = x.exacts == 0 || find_slits(&x);
  }
  for (size_t i = 0; i < x.exacts; i++) {
    mpq_clear(x.exact[i]);
  }
  free(x.exact);
  free(x.volume);
  free(x.error);
  free(x.count);
  free(x.unsure);
  return good;
}
