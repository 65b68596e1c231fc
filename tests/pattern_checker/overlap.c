#include "overlap.h"

#include "../checker/boxes.h"
#include "convex.h"

#include <math.h>
#include <stdlib.h>

typedef struct search {
  const pattern *p;
  const parts *parts;
  real least;
  FILE *tell;
  overlap_faults *out;
  real (*inside)[2], (*spare)[2]; /* [2 * parts->most] */
} search;

/* How far the line from a to b has x on its left. */
static real
left_of(const real a[2], const real b[2], const real x[2])
{
  real u = b[0] - a[0], v = b[1] - a[1], l = hypotl(u, v);

  return l > 0 ? (u * (x[1] - a[1]) - v * (x[0] - a[0])) / l : 0;
}

/* True if a side of `a` has all of `b` on its right, or nearly so. */
static bool
parts_them(const part *a, const part *b, real least)
{
  for (size_t i = 0; i < a->count; i++) {
    const real *x = a->corner[i], *y = a->corner[(i + 1) % a->count];
    real most = -INFINITY;

    if (x[0] == y[0] && x[1] == y[1]) {
      continue;
    }
    for (size_t k = 0; k < b->count && most <= least; k++) {
      most = fmaxl(most, left_of(x, y, b->corner[k]));
    }
    if (most <= least) {
      return true;
    }
  }
  return false;
}

/* What of a convex polygon of n corners is left of the line from a to b. */
static size_t
clip(const real (*in)[2], size_t n, const real a[2], const real b[2],
     real (*out)[2])
{
  size_t m = 0;

  for (size_t i = 0; i < n; i++) {
    const real *x = in[i], *y = in[(i + 1) % n];
    real dx = left_of(a, b, x), dy = left_of(a, b, y);

    if (dx >= 0) {
      out[m][0] = x[0];
      out[m++][1] = x[1];
    }
    if ((dx > 0 && dy < 0) || (dx < 0 && dy > 0)) {
      real t = dx / (dx - dy);

      out[m][0] = x[0] + t * (y[0] - x[0]);
      out[m++][1] = x[1] + t * (y[1] - x[1]);
    }
  }
  return m;
}

/* What both have in common; the number of its corners, in s->inside. */
static size_t
common(search *s, const part *a, const part *b)
{
  size_t n = a->count;

  for (size_t i = 0; i < n; i++) {
    s->inside[i][0] = a->corner[i][0];
    s->inside[i][1] = a->corner[i][1];
  }
  for (size_t i = 0; i < b->count && n > 0; i++) {
    real(*swapped)[2] = s->spare;

    n = clip((const real(*)[2])s->inside, n, b->corner[i],
             b->corner[(i + 1) % b->count], s->spare);
    s->spare = s->inside;
    s->inside = swapped;
  }
  return n;
}

/* The narrowest width of a convex polygon: from a side to the corner farthest
 * from it, or along an axis. */
static real
width(const real (*corner)[2], size_t n)
{
  real least = INFINITY;

  for (int k = 0; k < 2; k++) {
    real low = INFINITY, high = -INFINITY;

    for (size_t i = 0; i < n; i++) {
      low = fminl(low, corner[i][k]);
      high = fmaxl(high, corner[i][k]);
    }
    least = fminl(least, high - low);
  }
  for (size_t i = 0; i < n; i++) {
    const real *a = corner[i], *b = corner[(i + 1) % n];
    real far = 0;

    if (a[0] == b[0] && a[1] == b[1]) {
      continue;
    }
    for (size_t k = 0; k < n; k++) {
      far = fmaxl(far, left_of(a, b, corner[k]));
    }
    least = fminl(least, far);
  }
  return n < 3 ? 0 : least;
}

static void
visit(void *data, int i, int k)
{
  search *s = data;
  const part *a = &s->parts->part[i], *b = &s->parts->part[k];
  bool is_tab = a->owner >= s->p->flats || b->owner >= s->p->flats;
  real deep;
  size_t n;

  if (a->owner == b->owner || parts_them(a, b, s->least / 1000) ||
      parts_them(b, a, s->least / 1000)) {
    return;
  }
  n = common(s, a, b);
  deep = width((const real(*)[2])s->inside, n);
  if (is_tab) {
    s->out->tab = fmaxl(s->out->tab, deep);
    s->out->tabs += deep > s->least;
  } else {
    s->out->face = fmaxl(s->out->face, deep);
    s->out->faces += deep > s->least;
  }
  if (s->tell && deep > s->least) {
    fprintf(s->tell, "  %s %zu and %zu lie on each other, %Lg deep\n",
            is_tab ? "tab: items" : "items", a->owner, b->owner, deep);
  }
}

/* The boxes of all parts, in the plane. */
static box *
boxes_of(const parts *all)
{
  box *boxes = calloc(all->n + 1, sizeof *boxes);

  for (size_t i = 0; boxes && i < all->n; i++) {
    const part *x = &all->part[i];

    boxes[i] = (box){.item = (int)i};
    for (int k = 0; k < 2; k++) {
      boxes[i].low[k] = INFINITY;
      boxes[i].high[k] = -INFINITY;
      for (size_t c = 0; c < x->count; c++) {
        boxes[i].low[k] = fmin(boxes[i].low[k], (double)x->corner[c][k]);
        boxes[i].high[k] = fmax(boxes[i].high[k], (double)x->corner[c][k]);
      }
    }
  }
  return boxes;
}

void
check_overlaps(const pattern *p, real least, FILE *tell, overlap_faults *out)
{
  parts all;
  search s = {p, &all, least, tell, out, NULL, NULL};
  box *boxes;

  *out = (overlap_faults){0};
  parts_of_pattern(p, &all);
  boxes = boxes_of(&all);
  s.inside = calloc(2 * all.most + 2, sizeof *s.inside);
  s.spare = calloc(2 * all.most + 2, sizeof *s.spare);
  if (!boxes || !s.inside || !s.spare) {
    abort();
  }
  boxes_meeting(boxes, all.n, visit, &s);
  free(boxes);
  free(s.inside);
  free(s.spare);
  parts_clear(&all);
}
