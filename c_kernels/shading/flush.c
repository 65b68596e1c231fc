/* flush.c -- surfaces that lie in one another become one. Then slices of them
 * have the same depth to the last bit, and are always one group. */
#include "number/vector.h"
#include "rows/sort.h"
#include "shading_private.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Dots: what rounding leaves between equal surfaces. */
#define ROUNDED 1e-8

/* Of a key that only near surfaces have nearly alike. */
#define SPREAD_X 0.37
#define SPREAD_Y 0.59

typedef struct merging {
  sg_shading *scene;
  double tolerance, reach; /* dots; from the middle to the farthest */
  uint32_t *to;            /* [surfaces]: the one that stays */
  uint64_t *key; /* rounded, in order; the surface in the lower half */
  size_t n;
} merging;

/* The quadric from another point, in its own scale. */
static void
move_quadric(const sg_shading_quadric *s, const double at[3], double q[10])
{
  const double *a = s->q;
  double p[3];

  sg_minus(at, s->at, p);
  memcpy(q, a, 10 * sizeof *q);
  q[6] += 2 * a[0] * p[0] + a[3] * p[1] + a[4] * p[2];
  q[7] += 2 * a[1] * p[1] + a[3] * p[0] + a[5] * p[2];
  q[8] += 2 * a[2] * p[2] + a[4] * p[0] + a[5] * p[1];
  q[9] += (a[0] * p[0] + a[3] * p[1] + a[4] * p[2] + a[6]) * p[0] +
          (a[1] * p[1] + a[5] * p[2] + a[7]) * p[1] +
          (a[2] * p[2] + a[8]) * p[2];
}

static double
key_of(const merging *m, const sg_shading_surface *s)
{
  double q[10];

  if (s->kind == SG_IS_PLANE) {
    return s->q[3] + m->reach * (SPREAD_X * s->q[0] + SPREAD_Y * s->q[1]);
  }
  if (s->kind == SG_IS_RING) {
    const double *at = m->scene->torus.item[s->of].at;
    return at[0] + SPREAD_X * at[1] + SPREAD_Y * at[2];
  }
  move_quadric(&m->scene->quadric.item[s->of], m->scene->middle, q);
  return q[9];
}

static bool
same_plane(const merging *m, const double p[4], const double q[4])
{
  double turn = sg_distance(p, q);

  return turn * m->reach + fabs(p[3] - q[3]) <= m->tolerance;
}

/* Near both centres; `reach` there is a few radii. */
static bool
same_quadric(const merging *m, const sg_shading_quadric *a,
             const sg_shading_quadric *b)
{
  double q[10], squares = 0.0, linear = 0.0;
  double size = sg_distance(a->at, b->at), radius = sqrt(fabs(b->q[9]));
  double far = 4.0 * fmax(size, radius);

  move_quadric(a, b->at, q);
  for (int k = 0; k < 6; k++) {
    squares += fabs(q[k] - b->q[k]);
  }
  for (int k = 6; k < 9; k++) {
    linear += fabs(q[k] - b->q[k]);
  }
  return (squares * far + linear) * far + fabs(q[9] - b->q[9]) <=
         m->tolerance * radius;
}

/* A tube is thinner than the whole: what changes forms by so much moves the
 * surface by more. */
static bool
same_torus(const merging *m, const sg_shading_torus *a,
           const sg_shading_torus *b)
{
  double off = 0.0;

  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 10; k++) {
      off += fabs(a->form[i][k] - b->form[i][k]);
    }
  }
  double thin = 1.0 - a->form[0][9]; /* k^2 */
  return off * a->size <= m->tolerance * thin &&
         fabs(a->size - b->size) <= m->tolerance * thin &&
         sg_distance(a->at, b->at) <= m->tolerance;
}

/* Facets of one plane that are seen bent are so each in its own way. */
static bool
may_merge(const sg_shading *s, const sg_shading_surface *a,
          const sg_shading_surface *b)
{
  const sg_known_surface *known = s->known.item;

  return a->of == b->of ||
         (a->of > 0 && b->of > 0 && known[a->of - 1].kind != SG_KNOWN_BENT &&
          known[b->of - 1].kind != SG_KNOWN_BENT);
}

static bool
same_surface(const merging *m, uint32_t i, uint32_t j)
{
  const sg_shading_surface *a = &m->scene->surface.item[i];
  const sg_shading_surface *b = &m->scene->surface.item[j];

  const sg_shading_quadric *quadric = m->scene->quadric.item;
  const sg_shading_torus *torus = m->scene->torus.item;

  switch (a->kind) {
  case SG_IS_QUADRIC:
    return same_quadric(m, &quadric[a->of], &quadric[b->of]);
  case SG_IS_RING:
    return same_torus(m, &torus[a->of], &torus[b->of]);
  case SG_IS_PLANE:
    break;
  }
  return may_merge(m->scene, a, b) && same_plane(m, a->q, b->q);
}

/* Unsigned integers in the order of numbers, which are rounded to floats. */
static uint32_t
rounded_key(double value)
{
  const uint32_t sign = UINT32_C(1) << 31;
  float rounded = (float)value;
  uint32_t bits;

  memcpy(&bits, &rounded, sizeof bits);
  return bits & sign ? ~bits : bits | sign;
}

/* The least key of what may be one surface with what has this key. */
static uint32_t
least_key(const merging *m, sg_surface_kind kind, uint32_t key)
{
  const uint32_t sign = UINT32_C(1) << 31;
  uint32_t bits = key & sign ? key & ~sign : ~key;
  float rounded;

  memcpy(&rounded, &bits, sizeof rounded);
  double value = rounded, off = fabs(value) * 0x1p-23;
  return rounded_key(value - off -
                     (kind == SG_IS_QUADRIC ? 1e-9 * (1.0 + fabs(value))
                                            : 2.0 * m->tolerance));
}

/* Those of a kind, in order of their keys: each goes to that of the nearest
 * before it to which it may: of many in one plane the first that is asked. */
static sg_shading_end
merge_kind(merging *m, sg_surface_kind kind, const sg_cancel *cancel)
{
  const sg_shading *s = m->scene;

  m->n = 0;
  for (uint32_t i = 0; i < s->surface.n; i++) {
    if (s->surface.item[i].kind == kind) {
      m->key[m->n++] =
          (uint64_t)rounded_key(key_of(m, &s->surface.item[i])) << 32 | i;
    }
  }
  if (!sg_sort_upper(m->key, m->n)) {
    return SG_SHADING_NO_MEMORY;
  }
  for (size_t i = 0; i < m->n; i++) {
    uint32_t of = (uint32_t)m->key[i];
    uint32_t least = least_key(m, kind, (uint32_t)(m->key[i] >> 32));

    if (sg_cancel_every(cancel, i)) {
      return SG_SHADING_STOPPED;
    }
    for (size_t k = i; k > 0 && m->key[k - 1] >> 32 >= least; k--) {
      uint32_t other = m->to[(uint32_t)m->key[k - 1]];
      if (same_surface(m, of, other)) {
        m->to[of] = other;
        break;
      }
    }
  }
  return SG_SHADING_GOOD;
}

static void
use_merged(sg_shading *s, const uint32_t *to)
{
  for (size_t i = 0; i < s->polygon.n; i++) {
    s->polygon.item[i].surface = to[s->polygon.item[i].surface];
  }
  for (size_t i = 0; i < s->body.n; i++) {
    sg_shading_body *b = &s->body.item[i];

    b->surface = to[b->surface];
    for (uint32_t k = 0; k < b->bounds; k++) {
      b->bound[k].surface = to[b->bound[k].surface];
    }
  }
}

sg_shading_end
sg_shading_merge(sg_shading *s, const sg_cancel *cancel)
{
  size_t n = s->surface.n;
  merging m = {.scene = s,
               .tolerance = fmax(s->frame.tolerance, ROUNDED),
               .reach = s->frame.width + s->frame.height,
               .to = malloc((n + 1) * sizeof *m.to),
               .key = malloc((n + 1) * sizeof *m.key)};
  sg_shading_end end = m.to && m.key ? SG_SHADING_GOOD : SG_SHADING_NO_MEMORY;

  for (uint32_t i = 0; m.to && i < n; i++) {
    m.to[i] = i;
  }
  for (int kind = SG_IS_PLANE; kind <= SG_IS_RING && end == SG_SHADING_GOOD;
       kind++) {
    end = merge_kind(&m, (sg_surface_kind)kind, cancel);
  }
  if (end == SG_SHADING_GOOD) {
    use_merged(s, m.to);
  }
  free(m.to);
  free(m.key);
  return end;
}
