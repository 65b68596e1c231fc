#include "folding.h"

#include "edges.h"

#include <math.h>
#include <stdlib.h>

/* Where a polygon of the pattern is in space: its point x is at
 * there + turn (x - here). */
typedef struct placing {
  real here[2], there[3], turn[3][3];
  bool known;
} placing;

static void
placed(const placing *t, const real x[2], real out[3])
{
  for (int k = 0; k < 3; k++) {
    out[k] = t->there[k] + t->turn[k][0] * (x[0] - t->here[0]) +
             t->turn[k][1] * (x[1] - t->here[1]);
  }
}

static void
take_spot(const spot *s, real out[2])
{
  out[0] = s->at[0];
  out[1] = s->at[1];
}

/* What lies beyond the fold at `s` of a polygon placed as `t`: bent back by
 * `angle` about the line of s, that is from right of it to below. */
static void
fold_at(const pattern *p, const placing *t, const side *s, real angle,
        placing *out)
{
  real a[2], b[2], l, u, v, cosine = cosl(angle), sine = sinl(angle);

  take_spot(&p->spot[s->from], a);
  take_spot(&p->spot[s->to], b);
  l = hypotl(b[0] - a[0], b[1] - a[1]);
  u = l > 0 ? (b[0] - a[0]) / l : 1;
  v = l > 0 ? (b[1] - a[1]) / l : 0;
  for (int k = 0; k < 3; k++) {
    const real *m = t->turn[k];
    real along = m[0] * u + m[1] * v, right = m[0] * v - m[1] * u;
    real folded = right * cosine - m[2] * sine;

    out->turn[k][0] = along * u + folded * v;
    out->turn[k][1] = along * v - folded * u;
    out->turn[k][2] = m[2] * cosine + right * sine;
  }
  placed(t, a, out->there);
  out->here[0] = a[0];
  out->here[1] = a[1];
  out->known = true;
}

/* ------------------------------------------------------------- the first */

/* An exact place for a polygon: its longest side where it was, and its area's
 * direction. */
static void
place_first(const pattern *p, const flat *f, placing *out)
{
  const side *best = &p->side[p->list[f->first]];
  real longest = -1, n[3], u[3], w[3], x[2], y[2], l;

  for (size_t i = 0; i < f->count; i++) {
    const side *s = &p->side[p->list[f->first + i]];

    take_spot(&p->spot[s->from], x);
    take_spot(&p->spot[s->to], y);
    l = hypotl(y[0] - x[0], y[1] - x[1]);
    if (l > longest) {
      longest = l;
      best = s;
    }
  }
  take_spot(&p->spot[best->from], x);
  take_spot(&p->spot[best->to], y);
  solid_area(p, f, n);
  for (int k = 0; k < 3; k++) {
    out->there[k] = p->point[p->spot[best->from].point][k];
    u[k] = (p->point[p->spot[best->to].point][k] - out->there[k]) / longest;
  }
  l = length(u);
  for (int k = 0; k < 3; k++) {
    u[k] /= l;
  }
  cross(n, u, w);
  l = length(w);
  for (int k = 0; k < 3; k++) { /* u is y - x in the pattern, w left of it */
    real c = (y[0] - x[0]) / longest, s = (y[1] - x[1]) / longest;

    w[k] /= l;
    out->turn[k][0] = u[k] * c - w[k] * s;
    out->turn[k][1] = u[k] * s + w[k] * c;
  }
  cross(u, w, n);
  for (int k = 0; k < 3; k++) {
    out->turn[k][2] = n[k];
  }
  out->here[0] = x[0];
  out->here[1] = x[1];
  out->known = true;
}

/* The largest polygon of each piece, or NONE. */
static int *
largest_of_pieces(const pattern *p)
{
  size_t n = (size_t)p->pieces + 1;
  int *largest = malloc(n * sizeof *largest);
  real *area = calloc(n, sizeof *area);

  if (!largest || !area) {
    abort();
  }
  for (size_t k = 0; k < n; k++) {
    largest[k] = NONE;
  }
  for (size_t i = 0; i < p->flats; i++) {
    int k = p->flat[i].piece;
    real a = flat_area(p, &p->flat[i]);

    if (k <= p->pieces && p->flat[i].count > 0 &&
        (largest[k] == NONE || a > area[k])) {
      largest[k] = (int)i;
      area[k] = a;
    }
  }
  free(area);
  return largest;
}

/* ---------------------------------------------------------- the others */

typedef struct fold {
  real length;
  int joint;
} fold;

static int
longest_first(const void *a, const void *b)
{
  const fold *x = a, *y = b;

  return x->length != y->length ? (x->length > y->length ? -1 : 1)
                                : x->joint - y->joint;
}

/* Folds enough to place all: of those that go round in a ring the longest, for
 * a short line says little of where it points. [joints] */
static bool *
folds_to_use(const pattern *p)
{
  fold *all = calloc(p->joints + 1, sizeof *all);
  bool *used = calloc(p->joints + 1, sizeof *used);
  int *sets = sets_of(p->flats);
  size_t n = 0;

  if (!all || !used) {
    abort();
  }
  for (size_t i = 0; i < p->joints; i++) {
    const side *s = &p->side[p->joint[i].side[0]];
    real a[2], b[2];

    take_spot(&p->spot[s->from], a);
    take_spot(&p->spot[s->to], b);
    if (p->joint[i].kind == FOLD && s->flat != NONE &&
        p->side[p->joint[i].side[1]].flat != NONE) {
      all[n++] = (fold){hypotl(b[0] - a[0], b[1] - a[1]), (int)i};
    }
  }
  qsort(all, n, sizeof *all, longest_first);
  for (size_t i = 0; i < n; i++) {
    const joint *j = &p->joint[all[i].joint];

    used[all[i].joint] =
        join_sets(sets, p->side[j->side[0]].flat, p->side[j->side[1]].flat);
  }
  free(sets);
  free(all);
  return used;
}

/* Places those that hang on the placed polygon `i` by a fold to use, and puts
 * them behind the n that wait. */
static size_t
place_neighbours(const pattern *p, const bool *used, int i, placing *at,
                 int *waiting, size_t n)
{
  const flat *f = &p->flat[i];

  for (size_t k = 0; k < f->count; k++) {
    int number = p->list[f->first + k], other;
    const side *s = &p->side[number];
    const joint *j = s->joint == NONE ? NULL : &p->joint[s->joint];

    if (!j || !used[s->joint]) {
      continue;
    }
    other = p->side[j->side[j->side[0] == number]].flat;
    if (!at[other].known) {
      fold_at(p, &at[i], s, (real)j->angle * (acosl(-1) / 180), &at[other]);
      waiting[n++] = other;
    }
  }
  return n;
}

static real
off_by(const pattern *p, const flat *f, const placing *t)
{
  real off = t->known ? 0 : INFINITY;

  for (size_t i = 0; i < f->count; i++) {
    const spot *s = &p->spot[p->side[p->list[f->first + i]].from];
    real x[2], at[3], d[3];

    take_spot(s, x);
    placed(t, x, at);
    for (int k = 0; k < 3; k++) {
      d[k] = at[k] - p->point[s->point][k];
    }
    off = fmaxl(off, length(d));
  }
  return off;
}

real
fold_back(const pattern *p)
{
  int *first = largest_of_pieces(p);
  int *waiting = malloc((p->flats + 1) * sizeof *waiting);
  placing *at = calloc(p->flats + 1, sizeof *at);
  bool *used = folds_to_use(p);
  size_t done = 0, n = 0;
  real off = 0;

  if (!waiting || !at) {
    abort();
  }
  for (int k = 0; k <= p->pieces; k++) {
    if (first[k] != NONE) {
      place_first(p, &p->flat[first[k]], &at[first[k]]);
      waiting[n++] = first[k];
    }
  }
  while (done < n) {
    n = place_neighbours(p, used, waiting[done], at, waiting, n);
    done++;
  }
  for (size_t i = 0; i < p->flats; i++) {
    off = fmaxl(off, off_by(p, &p->flat[i], &at[i]));
  }
  free(used);
  free(at);
  free(waiting);
  free(first);
  return off / size_of_solid(p);
}
