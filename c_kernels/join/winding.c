/* winding.c -- how often triangles go round a point: see winding.h. */
#include "winding.h"

#include "bvh_join.h"

#include <math.h>
#include <stdlib.h>

/* The turn a, b, p seen from +x, p shifted: never 0 unless a and b are seen
 * in one place. */
static int
shifted_turn(const sg_point *a, const sg_point *b, const sg_point *p)
{
  int turn = sg_point_turn(0, a, b, p);

  if (turn == 0) { /* by the shift in y, to the right of an edge that rises */
    turn = sg_point_compare(2, a, b);
  }
  return turn != 0 ? turn : -sg_point_compare(1, a, b);
}

int
sg_winding_of(const sg_point *a, const sg_point *b, const sg_point *c,
              const sg_point *p)
{
  if (sg_point_turn(0, a, b, c) == 0) {
    return 0;
  }
  int turn = shifted_turn(a, b, p);

  if (shifted_turn(b, c, p) != turn || shifted_turn(c, a, p) != turn) {
    return 0;
  }
  /* Counter-clockwise from +x, p is before it where p is below. */
  return sg_point_orient3d(a, b, c, p) == turn ? turn : 0;
}

/* Where y, z is across the edge from u along e, and how far that may be off:
 * by what is rounded here, and in y, z. */
static double
across(const double e[2], const double u[3], const double at[3], double *off)
{
  double r = e[0] * (at[2] - u[2]), s = e[1] * (at[1] - u[1]);

  *off += 0x1p-44 * (fabs(r) + fabs(s)) +
          0x1p-50 * (fabs(e[0] * at[2]) + fabs(e[1] * at[1])) + 0x1p-1000;
  return r - s;
}

bool
sg_winding_misses(const double t[3][3], const double p[3])
{
  for (int i = 0; i < 3; i++) {
    const double *u = t[i], *w = t[(i + 1) % 3];
    double e[2] = {w[1] - u[1], w[2] - u[2]}, off = 0;
    double third = across(e, u, t[(i + 2) % 3], &off);
    double at = across(e, u, p, &off);

    if (at < (third < 0 ? third : 0) - off ||
        at > (third > 0 ? third : 0) + off) {
      return true;
    }
  }
  return false;
}

/* Whether p is between a and b, all three on one line. */
static bool
is_between(const sg_point *a, const sg_point *b, const sg_point *p)
{
  for (int axis = 0; axis < 3; axis++) {
    if (sg_point_compare(axis, a, p) * sg_point_compare(axis, p, b) < 0) {
      return false;
    }
  }
  return true;
}

static bool
is_on_segment(const sg_point *a, const sg_point *b, const sg_point *p)
{
  for (int axis = 0; axis < 3; axis++) {
    if (sg_point_turn(axis, a, b, p) != 0) {
      return false;
    }
  }
  return is_between(a, b, p);
}

bool
sg_is_on_triangle(const sg_point *a, const sg_point *b, const sg_point *c,
                  const sg_point *p)
{
  if (sg_point_orient3d(a, b, c, p) != 0) {
    return false;
  }
  for (int axis = 0; axis < 3; axis++) {
    int area = sg_point_turn(axis, a, b, c);
    if (area != 0) {
      return sg_point_turn(axis, a, b, p) * area >= 0 &&
             sg_point_turn(axis, b, c, p) * area >= 0 &&
             sg_point_turn(axis, c, a, p) * area >= 0;
    }
  }
  return is_on_segment(a, b, p) || is_on_segment(b, c, p) ||
         is_on_segment(c, a, p);
}

/* ---- how far a ray goes ---- */

typedef struct shortening {
  const sg_box *body, *begin;
  sg_box *ray;
  const sg_bvh *bodies, *begins;
} shortening;

/* Wants nothing: it notes where a ray ends. One thread alone asks it. */
static bool
note_end(void *data, const sg_bvh_hit *hit)
{
  shortening *s = data;
  const sg_box *body = &s->body[s->bodies->item[hit->a]];
  uint32_t i = s->begins->item[hit->b];

  if (sg_box_overlap(body, &s->begin[i], 0)) {
    s->ray[i].hi[0] = fmax(s->ray[i].hi[0], body->hi[0]);
  }
  return false;
}

bool
sg_winding_shorten(const sg_box *body, size_t bodies, sg_box *ray, size_t n,
                   const sg_poll *poll)
{
  sg_box *begin = malloc((n + 1) * sizeof *begin);
  sg_bvh_hits none = {0};
  sg_bvh *a = NULL, *b = NULL;

  for (size_t i = 0; begin && i < n; i++) {
    begin[i] = ray[i];
  }
  if (begin) {
    a = sg_bvh_open(body, bodies, poll);
    b = sg_bvh_open(begin, n, poll);
  }
  shortening s = {body, begin, ray, a, b};
  bool good = a && b &&
              sg_bvh_join_wanted(&(sg_bvh_pair){a, b}, 1, 0, note_end, &s, NULL,
                                 poll, &none);

  free(none.hit);
  free(begin);
  sg_bvh_close(a);
  sg_bvh_close(b);
  return good;
}
