#include "shapes.h"

#include <math.h>
#include <stdlib.h>

/* An area is all there if what is missing is less than this part of it, or of
 * the square of the model's size. */
static const real MISSING = 1e-9L;

real
dot(const real a[3], const real b[3])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void
cross(const real a[3], const real b[3], real out[3])
{
  for (int k = 0; k < 3; k++) {
    int i = (k + 1) % 3, j = (k + 2) % 3;

    out[k] = a[i] * b[j] - a[j] * b[i];
  }
}

real
length(const real a[3])
{
  return sqrtl(dot(a, a));
}

/* b - a of the solid's points. */
static void
between(const pattern *p, int a, int b, real out[3])
{
  for (int k = 0; k < 3; k++) {
    out[k] = (real)p->point[b][k] - (real)p->point[a][k];
  }
}

real
size_of_solid(const pattern *p)
{
  double size = 0;

  for (int k = 0; k < 3; k++) {
    double low = INFINITY, high = -INFINITY;

    for (size_t i = 0; i < p->points; i++) {
      low = fmin(low, p->point[i][k]);
      high = fmax(high, p->point[i][k]);
    }
    size = fmax(size, high - low);
  }
  return size;
}

/* Differences from the first side's start, since what is far away is coarse. */
real
flat_area(const pattern *p, const flat *f)
{
  const double *o =
      f->count ? p->spot[p->side[p->list[f->first]].from].at : NULL;
  real sum = 0;

  for (size_t i = 0; i < f->count; i++) {
    const side *s = &p->side[p->list[f->first + i]];
    const double *a = p->spot[s->from].at, *b = p->spot[s->to].at;

    sum += ((real)a[0] - o[0]) * ((real)b[1] - o[1]) -
           ((real)a[1] - o[1]) * ((real)b[0] - o[0]);
  }
  return sum;
}

real
sheet_of(const pattern *p)
{
  real area = 0;

  for (size_t i = 0; i < p->flats; i++) {
    area += fabsl(flat_area(p, &p->flat[i])) / 2;
  }
  return sqrtl(area);
}

void
solid_area(const pattern *p, const flat *f, real out[3])
{
  int o = f->count ? p->spot[p->side[p->list[f->first]].from].point : 0;

  out[0] = out[1] = out[2] = 0;
  for (size_t i = 0; i < f->count; i++) {
    const side *s = &p->side[p->list[f->first + i]];
    real a[3], b[3], c[3];

    between(p, o, p->spot[s->from].point, a);
    between(p, o, p->spot[s->to].point, b);
    cross(a, b, c);
    for (int k = 0; k < 3; k++) {
      out[k] += c[k];
    }
  }
}

/* ----------------------------------------------------------- congruence */

/* An origin and two directions at right angles, of corners a, b, c: the same
 * three in the solid and in the pattern. */
typedef struct frame {
  int a, b, c; /* sides, for their starts */
  real u[3], w[3], n[3], u2[2], w2[2];
  real wide; /* of c from the line from a to b */
} frame;

/* The start of side s from that of side a: in the solid, in the pattern. */
static void
from_start(const pattern *p, int a, int s, real out[3], real out2[2])
{
  const spot *x = &p->spot[p->side[a].from], *y = &p->spot[p->side[s].from];

  between(p, x->point, y->point, out);
  for (int k = 0; k < 2; k++) {
    out2[k] = (real)y->at[k] - (real)x->at[k];
  }
}

static void
take_direction(frame *r, const real d[3], const real d2[2])
{
  real l = length(d), l2 = hypotl(d2[0], d2[1]);

  for (int k = 0; k < 3; k++) {
    r->u[k] = l > 0 ? d[k] / l : 0;
  }
  for (int k = 0; k < 2; k++) {
    r->u2[k] = l2 > 0 ? d2[k] / l2 : 0;
  }
}

/* The direction from a to b, the corner farthest from a. */
static void
take_line(const pattern *p, const flat *f, frame *r)
{
  real far = -1, d[3], d2[2];

  r->a = p->list[f->first];
  for (size_t i = 0; i < f->count; i++) {
    from_start(p, r->a, p->list[f->first + i], d, d2);
    if (length(d) > far) {
      far = length(d);
      r->b = p->list[f->first + i];
    }
  }
  from_start(p, r->a, r->b, d, d2);
  take_direction(r, d, d2);
}

/* What of d is square with u. */
static void
square_part(const real u[3], const real d[3], real out[3])
{
  real along = dot(u, d);

  for (int k = 0; k < 3; k++) {
    out[k] = d[k] - along * u[k];
  }
}

/* The direction square with it to c, the corner farthest from the line. */
static void
take_width(const pattern *p, const flat *f, frame *r)
{
  real d[3], d2[2], w[3], left;

  r->wide = -1;
  for (size_t i = 0; i < f->count; i++) {
    from_start(p, r->a, p->list[f->first + i], d, d2);
    square_part(r->u, d, w);
    if (length(w) > r->wide) {
      r->wide = length(w);
      r->c = p->list[f->first + i];
      for (int k = 0; k < 3; k++) {
        r->w[k] = r->wide > 0 ? w[k] / r->wide : 0;
      }
    }
  }
  cross(r->u, r->w, r->n);
  from_start(p, r->a, r->c, d, d2);
  left = r->u2[0] * d2[1] - r->u2[1] * d2[0] < 0 ? -1 : 1;
  r->w2[0] = -left * r->u2[1];
  r->w2[1] = left * r->u2[0];
}

static void
check_shape(const pattern *p, const flat *f, shape_faults *out)
{
  frame r;
  real d[3], d2[2];

  take_line(p, f, &r);
  take_width(p, f, &r);
  for (size_t i = 0; i < f->count; i++) {
    from_start(p, r.a, p->list[f->first + i], d, d2);
    out->shape = fmaxl(out->shape,
                       fabsl(dot(d, r.u) - d2[0] * r.u2[0] - d2[1] * r.u2[1]));
    out->shape = fmaxl(out->shape,
                       fabsl(dot(d, r.w) - d2[0] * r.w2[0] - d2[1] * r.w2[1]));
    out->bend = fmaxl(out->bend, fabsl(dot(d, r.n)));
  }
}

/* --------------------------------------------------------------- areas */

/* Twice the area of each face of the solid, by its triangles. */
static real *
face_areas(const pattern *p)
{
  real *area = calloc(p->faces + 1, sizeof *area);

  if (!area) {
    abort();
  }
  for (size_t i = 0; i < p->triangles; i++) {
    const int *t = p->triangle[i];
    real a[3], b[3], c[3];

    between(p, t[1], t[2], a);
    between(p, t[1], t[3], b);
    cross(a, b, c);
    area[t[0]] += length(c);
  }
  return area;
}

/* Takes the pattern's areas away from those of the solid. */
static void
check_areas(const pattern *p, real size, shape_faults *out)
{
  real *left = face_areas(p), whole = 0, difference = 0;
  bool *there = calloc(p->faces + 1, sizeof *there);

  if (!there) {
    abort();
  }
  for (size_t i = 0; i < p->flats; i++) {
    const flat *f = &p->flat[i];
    real area = flat_area(p, f), was[3];

    solid_area(p, f, was);
    out->area = fmaxl(out->area, fabsl(fabsl(area) - length(was)));
    out->turned += area <= 0 && length(was) > MISSING * size * size;
    left[f->face] -= area;
    difference += area - length(was);
    whole += length(was);
    there[f->face] = true;
  }
  for (size_t i = 0; i < p->faces; i++) {
    out->missing += p->face[i].removed
                        ? there[i]
                        : !there[i] || fabsl(left[i]) > MISSING * size * size;
  }
  out->area /= size * size;
  out->total = whole > 0 ? fabsl(difference) / whole : 0;
  free(there);
  free(left);
}

void
check_shapes(const pattern *p, shape_faults *out)
{
  real size = size_of_solid(p);

  *out = (shape_faults){0};
  for (size_t i = 0; i < p->flats; i++) {
    if (p->flat[i].count > 0) {
      check_shape(p, &p->flat[i], out);
    }
  }
  out->shape /= size;
  out->bend /= size;
  check_areas(p, size, out);
}
