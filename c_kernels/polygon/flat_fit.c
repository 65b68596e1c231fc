/* flat_fit.c -- see flat_fit.h: a hull, and callipers that turn round it. */
#include "flat_fit.h"

#include "convex.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* The points of a hull, counter-clockwise. */
typedef struct hull {
  double (*point)[2];
  size_t n;
} hull;

static double
turn(const double a[2], const double b[2], const double c[2])
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* How far the hull reaches along a direction. */
static double
reach(const hull *h, size_t i, double x, double y)
{
  return h->point[i % h->n][0] * x + h->point[i % h->n][1] * y;
}

/* Goes on from point *i as long as the hull reaches farther. */
static double
farthest(const hull *h, size_t *i, double x, double y)
{
  while (reach(h, *i + 1, x, y) > reach(h, *i, x, y)) {
    ++*i;
  }
  return reach(h, *i, x, y);
}

/* The smallest box round a hull of three points or more, by turning callipers;
 * the first of those that are equal up to rounding. */
static sg_flat_fit
find_fit(const hull *h)
{
  sg_flat_fit best = {1, 0};
  double least = INFINITY;
  size_t right = 1, top = 1, left = 1;

  for (size_t i = 0; i < h->n; i++) {
    const double *p = h->point[i], *q = h->point[(i + 1) % h->n];
    double x = q[0] - p[0], y = q[1] - p[1], size = hypot(x, y);
    if (size <= 0) {
      continue;
    }
    x /= size;
    y /= size;
    right = right > i ? right : i;
    double most = farthest(h, &right, x, y);
    top = top > right ? top : right;
    double high = farthest(h, &top, -y, x) - reach(h, i, -y, x);
    left = left > top ? left : top;
    double wide = most + farthest(h, &left, -x, -y);
    if (wide * high < least * (1 - 0x1p-30)) {
      least = wide * high;
      best = wide >= high ? (sg_flat_fit){x, y} : (sg_flat_fit){y, -x};
    }
  }
  return best;
}

enum {
  WAYS = 8,
  PART = 16384 /* points whose hull is found from one cancel to the next */
};

static const double way[WAYS][2] = {{1, 0},  {1, 1},   {0, 1},  {-1, 1},
                                    {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};

/* The points that are the farthest in eight directions: an octagon. */
static void
find_farthest(const double (*point)[2], size_t n, double far[WAYS][2],
              const sg_cancel *cancel, bool *stopped)
{
  double most[WAYS];

  for (int w = 0; w < WAYS; w++) {
    most[w] = -INFINITY;
  }
  for (size_t i = 0; i < n && !*stopped; i++) {
    *stopped = sg_cancel_every(cancel, i);
    for (int w = 0; w < WAYS; w++) {
      double reach = point[i][0] * way[w][0] + point[i][1] * way[w][1];
      if (reach > most[w]) {
        most[w] = reach;
        memcpy(far[w], point[i], sizeof far[w]);
      }
    }
  }
}

/* Drops the points inside of an octagon of points: they are not on the hull.
 * What is left comes first. */
static size_t
drop_inside(double (*point)[2], size_t n, const double far[WAYS][2],
            const sg_cancel *cancel, bool *stopped)
{
  size_t left = 0;

  for (size_t i = 0; i < n && !*stopped; i++) {
    bool inside = true;
    *stopped = sg_cancel_every(cancel, i);
    for (int w = 0; inside && w < WAYS; w++) {
      const double *p = far[w], *q = far[(w + 1) % WAYS];
      inside = (p[0] == q[0] && p[1] == q[1]) || turn(p, q, point[i]) > 0;
    }
    if (!inside) {
      memmove(point[left++], point[i], sizeof *point);
    }
  }
  return left;
}

/* Of very many points first the hulls of parts, whose points come first. */
static size_t
drop_by_parts(double (*point)[2], size_t n, double (*room)[2],
              const sg_cancel *cancel, bool *stopped)
{
  size_t left = 0;

  for (size_t i = 0; i < n && !*stopped; i += PART) {
    *stopped = sg_cancelled(cancel);
    size_t corners =
        sg_convex_hull(point + i, n - i < PART ? n - i : PART, room);
    memcpy(point + left, room, corners * sizeof *point);
    left += corners;
  }
  return left;
}

sg_flat_fit
sg_flat_fit_find(double (*point)[2], size_t n, double (*room)[2],
                 const sg_cancel *cancel, bool *stopped)
{
  hull h = {room, 0};
  double far[WAYS][2];

  *stopped = false;
  find_farthest((const double(*)[2])point, n, far, cancel, stopped);
  n = drop_inside(point, n, (const double(*)[2])far, cancel, stopped);
  if (n > PART) {
    n = drop_by_parts(point, n, room, cancel, stopped);
  }
  if (!*stopped && n >= 3) { /* none, if all are in one place */
    h.n = sg_convex_hull(point, n, room);
  }
  return h.n < 3 ? (sg_flat_fit){1, 0} : find_fit(&h);
}
