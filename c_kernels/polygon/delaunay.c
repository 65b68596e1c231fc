/* delaunay.c -- better triangles: see delaunay.h. */
#include "delaunay.h"

#include "engine/list.h"
#include "rows/key_table.h"

#include <math.h>
#include <stdlib.h>

enum { ASKED = 1 << 12 }; /* triangles between questions */

/* Thinner than this for its length: too thin. */
#define THIN 0x1p-30

/* ---- one more corner ---- */

static bool
push(sg_triangles *out, int32_t a, int32_t b, int32_t c)
{
  if (!sg_list_grow(&out->item, out->n, &out->room, sizeof *out->item)) {
    return false;
  }
  out->item[out->n++] = (sg_triangle){{a, b, c}};
  return true;
}

/* Divides the triangle at v, which lies inside (flat < 0) or on the side that
 * begins at corner `flat`. */
static bool
divide(sg_triangles *triangles, size_t i, int32_t v, int flat)
{
  sg_triangle t = triangles->item[i];
  bool first = true;

  triangles->settled = false;

  for (int k = 0; k < 3; k++) {
    int32_t a = t.v[k], b = t.v[(k + 1) % 3];
    if (k == flat) {
      continue;
    }
    if (first) {
      triangles->item[i] = (sg_triangle){{a, b, v}};
      first = false;
    } else if (!push(triangles, a, b, v)) {
      return false;
    }
  }
  return true;
}

/* Where v lies in a triangle. */
typedef struct whereabouts {
  bool outside; /* or where a corner is: then no triangle changes */
  int flat;     /* the side that v is on begins at this corner; -1: inside */
  int second;   /* of a triangle without area, another side; -1: none */
} whereabouts;

/* v is on the line that all three corners are on: it is on two sides of the
 * triangle, or on one and where the third corner is. */
static whereabouts
along_line(const sg_work *work, const sg_triangle *t, int32_t v)
{
  whereabouts out = {.flat = -1, .second = -1};

  for (int k = 0; k < 3; k++) {
    if (sg_work_between(work, t->v[k], t->v[(k + 1) % 3], v)) {
      *(out.flat < 0 ? &out.flat : &out.second) = k;
    }
  }
  out.outside = out.flat < 0;
  return out;
}

static whereabouts
whereabouts_of(const sg_work *work, const sg_triangle *t, int32_t v)
{
  whereabouts out = {.flat = -1, .second = -1};
  int on = 0;

  for (int k = 0; k < 3 && !out.outside; k++) {
    int turn = sg_work_turn(work, t->v[k], t->v[(k + 1) % 3], v);
    out.outside = turn < 0;
    out.flat = turn == 0 ? k : out.flat;
    on += turn == 0;
  }
  if (on == 3) {
    return along_line(work, t, v);
  }
  out.outside = out.outside || on == 2; /* where two sides meet */
  return out;
}

bool
sg_triangles_insert(const sg_work *work, sg_triangles *triangles, int32_t v)
{
  size_t n = triangles->n; /* those added have v as a corner already */

  for (size_t i = 0; i < n; i++) {
    sg_triangle *t = &triangles->item[i];
    whereabouts at = whereabouts_of(work, t, v);

    if (at.outside) {
      continue;
    }
    if (at.second >= 0) {
      /* The corner that the two sides share gives way: what is left of them
       * beside it lies on itself. */
      t->v[at.second == at.flat + 1 ? at.second : at.flat] = v;
      triangles->settled = false;
    } else if (!divide(triangles, i, v, at.flat)) {
      return false;
    }
    if (at.flat < 0) {
      break;
    }
  }
  return true;
}

/* ---- turning chords ---- */

typedef struct turner {
  const sg_work *work;
  sg_triangles *triangles;
  sg_key_table side; /* a, b of a triangle a, b, c -> 3 i + place of a */
  bool (*is_fixed)(void *data, int32_t a, int32_t b);
  void *data;
  bool *fresh, *asked; /* [triangles] turned in this round; to be looked at */
  bool twice;          /* a side may be there twice, the same way round */
} turner;

/* Whether the side noted at `place` is another one of the same ends, the same
 * way round, as side k of triangle i. */
static bool
is_other(const turner *t, uint32_t place, size_t i, uint32_t k)
{
  if (place == SG_NO_KEY || place == 3 * (uint32_t)i + k) {
    return false;
  }
  const int32_t *v = t->triangles->item[i].v;
  const int32_t *w = t->triangles->item[place / 3].v;

  return w[place % 3] == v[k] && w[(place % 3 + 1) % 3] == v[(k + 1) % 3];
}

/* Of triangle i; sides that were turned away stay known, and nobody asks. */
static bool
note_sides(turner *t, size_t i)
{
  for (uint32_t k = 0; k < 3; k++) {
    const int32_t *v = t->triangles->item[i].v;
    uint32_t *place = sg_key_table_put(
        &t->side, (uint32_t[2]){(uint32_t)v[k], (uint32_t)v[(k + 1) % 3]});
    if (!place) {
      return false;
    }
    t->twice = t->twice || is_other(t, *place, i, k);
    *place = 3 * (uint32_t)i + k;
  }
  return true;
}

/* Sine and cosine, times the same number, of the angle at `at`. */
static void
angle(const turner *t, int32_t at, int32_t a, int32_t b, double out[2])
{
  const double *p = sg_work_point(t->work, at)->p;
  const double *q = sg_work_point(t->work, a)->p;
  const double *r = sg_work_point(t->work, b)->p;
  double u[3], w[3], dot = 0, square = 0;

  for (int k = 0; k < 3; k++) {
    u[k] = q[k] - p[k];
    w[k] = r[k] - p[k];
    dot += u[k] * w[k];
  }
  for (int k = 0; k < 3; k++) {
    double c =
        u[(k + 1) % 3] * w[(k + 2) % 3] - u[(k + 2) % 3] * w[(k + 1) % 3];
    square += c * c;
  }
  out[0] = sqrt(square);
  out[1] = dot;
}

/* Whether the angles at c and d, opposite to a-b, add up to more than two
 * right ones, by more than rounding. */
static bool
is_better(const turner *t, int32_t a, int32_t b, int32_t c, int32_t d)
{
  double x[2], y[2];

  angle(t, c, a, b, x);
  angle(t, d, a, b, y);
  double sine = x[0] * y[1] + x[1] * y[0];
  bool both_flat = x[1] < 0 && y[1] < 0 && x[1] * y[1] > x[0] * y[0];

  return both_flat || sine < -1e-9 * hypot(x[0], x[1]) * hypot(y[0], y[1]);
}

/* Turns side k of triangle i if that is better. Both triangles are new then,
 * and the sides noted of them no longer right. */
static void
turn_side(turner *t, size_t i, int k)
{
  sg_triangle *one = &t->triangles->item[i];
  int32_t a = one->v[k], b = one->v[(k + 1) % 3], c = one->v[(k + 2) % 3];
  uint32_t place =
      sg_key_table_get(&t->side, (uint32_t[2]){(uint32_t)b, (uint32_t)a});

  if (place == SG_NO_KEY || t->fresh[place / 3] || t->is_fixed(t->data, a, b)) {
    return;
  }
  sg_triangle *other = &t->triangles->item[place / 3];
  int32_t d = other->v[(place % 3 + 2) % 3];

  if (sg_work_turn(t->work, c, a, d) <= 0 ||
      sg_work_turn(t->work, d, b, c) <= 0 || !is_better(t, a, b, c, d)) {
    return;
  }
  *one = (sg_triangle){{c, a, d}};
  *other = (sg_triangle){{d, b, c}};
  t->fresh[i] = t->fresh[place / 3] = true;
}

/* Turns what is better turned, once over all that may be. */
static sg_outcome
turn_sides(turner *t, const sg_cancel *cancel)
{
  for (size_t i = 0; i < t->triangles->n; i++) {
    t->fresh[i] = false;
  }
  for (size_t i = 0; i < t->triangles->n; i++) {
    if (i % ASKED == ASKED - 1 && sg_cancelled(cancel)) {
      return SG_STOPPED;
    }
    for (int k = 0; k < 3 && t->asked[i] && !t->fresh[i]; k++) {
      turn_side(t, i, k);
    }
  }
  return SG_DONE;
}

/* What was turned, and what is beside it, is looked at in the next round; what
 * was there before has been. False: no memory. *turned: something was. */
static bool
note_turned(turner *t, bool *turned)
{
  *turned = false;
  for (size_t i = 0; i < t->triangles->n; i++) {
    t->asked[i] = t->fresh[i];
    *turned = *turned || t->fresh[i];
    if (t->fresh[i] && !note_sides(t, i)) {
      return false;
    }
  }
  for (size_t i = 0; i < t->triangles->n; i++) {
    const int32_t *v = t->triangles->item[i].v;

    for (int k = 0; k < 3 && t->fresh[i]; k++) {
      uint32_t beside = sg_key_table_get(
          &t->side, (uint32_t[2]){(uint32_t)v[(k + 1) % 3], (uint32_t)v[k]});

      if (beside != SG_NO_KEY) {
        t->asked[beside / 3] = true;
      }
    }
  }
  return true;
}

sg_outcome
sg_triangles_delaunay(const sg_work *work, sg_triangles *triangles,
                      bool (*is_fixed)(void *data, int32_t a, int32_t b),
                      void *data, const sg_cancel *cancel)
{
  enum {
    ROUNDS = 64
  }; /* each better than the one before; rounding might
        make two of them go round */
  turner t = {.work = work,
              .triangles = triangles,
              .is_fixed = is_fixed,
              .data = data,
              .fresh = malloc(triangles->n + 1),
              .asked = malloc(triangles->n + 1)};
  sg_outcome end = t.fresh && t.asked ? SG_DONE : SG_NO_SPACE;
  bool turned = true;

  sg_key_table_init(&t.side, 2);
  for (size_t i = 0; i < triangles->n && end == SG_DONE; i++) {
    t.asked[i] = true;
    end = note_sides(&t, i) ? SG_DONE : SG_NO_SPACE;
  }
  for (int round = 0; round < ROUNDS && end == SG_DONE && turned; round++) {
    end = turn_sides(&t, cancel);
    if (end == SG_DONE && !note_turned(&t, &turned)) {
      end = SG_NO_SPACE;
    }
  }
  triangles->settled = end == SG_DONE && !turned && !t.twice;
  sg_key_table_clear(&t.side);
  free(t.fresh);
  free(t.asked);
  return end;
}

/* ---- thin triangles ---- */

bool
sg_triangle_is_thin(const double a[3], const double b[3], const double c[3],
                    double moved)
{
  double u[3], w[3], x = 0, y = 0, z = 0, square = 0;

  for (int k = 0; k < 3; k++) {
    u[k] = b[k] - a[k];
    w[k] = c[k] - a[k];
    x += u[k] * u[k];
    y += w[k] * w[k];
    z += (w[k] - u[k]) * (w[k] - u[k]);
  }
  for (int k = 0; k < 3; k++) {
    double area =
        u[(k + 1) % 3] * w[(k + 2) % 3] - u[(k + 2) % 3] * w[(k + 1) % 3];
    square += area * area;
  }
  double longest = fmax(x, fmax(y, z));
  double narrow = fmax(THIN * THIN * longest, 4 * moved * moved);

  return square < narrow * longest;
}

static bool
is_thin(const sg_work *work, const sg_triangle *t, double moved)
{
  return sg_triangle_is_thin(sg_work_point(work, t->v[0])->p,
                             sg_work_point(work, t->v[1])->p,
                             sg_work_point(work, t->v[2])->p, moved);
}

static bool
is_edge(void *data, int32_t a, int32_t b)
{
  uint32_t key[2] = {(uint32_t)(a < b ? a : b), (uint32_t)(a < b ? b : a)};

  return sg_key_table_get(data, key) != SG_NO_KEY;
}

static sg_outcome
turn_all(const sg_work *work, const int32_t (*edge)[2], size_t edges,
         sg_triangles *triangles, const sg_cancel *cancel)
{
  sg_key_table fixed;
  sg_outcome outcome = SG_DONE;

  sg_key_table_init(&fixed, 2);
  for (size_t i = 0; i < edges && outcome == SG_DONE; i++) {
    int32_t a = edge[i][0], b = edge[i][1];
    uint32_t key[2] = {(uint32_t)(a < b ? a : b), (uint32_t)(a < b ? b : a)};
    uint32_t *known = sg_key_table_put(&fixed, key);

    if (known) {
      *known = 1;
    } else {
      outcome = SG_NO_SPACE;
    }
  }
  if (outcome == SG_DONE) {
    outcome = sg_triangles_delaunay(work, triangles, is_edge, &fixed, cancel);
  }
  sg_key_table_clear(&fixed);
  return outcome;
}

sg_outcome
sg_triangles_thicken(const sg_work *work, const int32_t (*edge)[2],
                     size_t edges, double moved, sg_triangles *triangles,
                     const sg_cancel *cancel)
{
  for (size_t i = 0; i < triangles->n && triangles->n > 1; i++) {
    if (is_thin(work, &triangles->item[i], moved)) {
      return turn_all(work, edge, edges, triangles, cancel);
    }
  }
  return SG_DONE;
}
