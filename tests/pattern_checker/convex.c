#include "convex.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A straight corner may bend in by this part of the polygon's size. */
static const real STRAIGHT = 1e-17L;

/* A polygon's sides as segments of the plane. */
typedef struct segment {
  real a[2], b[2];
} segment;

static void *
need(void *memory)
{
  if (!memory) {
    fputs("pattern_checker: no memory\n", stderr);
    exit(2);
  }
  return memory;
}

static void
add_part(parts *ps, const real (*corner)[2], size_t n, size_t owner)
{
  part *x;

  ps->part = room(ps->part, ps->n, sizeof *ps->part);
  x = &ps->part[ps->n++];
  *x = (part){need(malloc(n * sizeof *corner)), n, owner};
  memcpy(x->corner, corner, n * sizeof *corner);
  ps->most = 2 * n > ps->most ? 2 * n : ps->most;
}

/* ------------------------------------------------------- convex polygons */

static bool
same_place(const real a[2], const real b[2])
{
  return a[0] == b[0] && a[1] == b[1];
}

/* The corners in order, if the n segments are one loop. */
static bool
in_order(const segment *s, size_t n, real (*corner)[2])
{
  size_t at = 0;

  for (size_t i = 0; i < n; i++) {
    size_t next = 0;

    corner[i][0] = s[at].a[0];
    corner[i][1] = s[at].a[1];
    while (next < n && !same_place(s[next].a, s[at].b)) {
      next++;
    }
    if (next == n || (next == 0) != (i + 1 == n)) {
      return false;
    }
    at = next;
  }
  return true;
}

static bool
is_convex(const real (*corner)[2], size_t n)
{
  real size = 0;

  for (size_t i = 0; i < n; i++) {
    size = fmaxl(
        size, hypotl(corner[i][0] - corner[0][0], corner[i][1] - corner[0][1]));
  }
  for (size_t i = 0; i < n; i++) {
    const real *a = corner[i], *b = corner[(i + 1) % n],
               *c = corner[(i + 2) % n];

    if ((b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]) <
        -STRAIGHT * size * size) {
      return false;
    }
  }
  return n >= 3;
}

/* ------------------------------------------------------ other polygons */

/* A segment between two heights. */
typedef struct crossing {
  real low, high; /* where it is there */
  int turns;      /* 1: the polygon is right of it, -1: left */
} crossing;

static int
by_value(const void *a, const void *b)
{
  const real *x = a, *y = b;

  return *x < *y ? -1 : *x > *y;
}

/* Left ones first; of those in one place the ones that open. */
static int
by_place(const void *a, const void *b)
{
  const crossing *x = a, *y = b;
  real p = x->low + x->high, q = y->low + y->high;

  return p != q ? (p < q ? -1 : 1) : y->turns - x->turns;
}

static real
at_height(const segment *s, real y)
{
  return y == s->a[1]   ? s->a[0]
         : y == s->b[1] ? s->b[0]
                        : s->a[0] + (s->b[0] - s->a[0]) *
                                        ((y - s->a[1]) / (s->b[1] - s->a[1]));
}

/* The crossings between two heights, in order. */
static size_t
crossings(const segment *s, size_t n, real low, real high, crossing *out)
{
  size_t m = 0;

  for (size_t i = 0; i < n; i++) {
    if (fminl(s[i].a[1], s[i].b[1]) <= low &&
        fmaxl(s[i].a[1], s[i].b[1]) >= high) {
      out[m++] = (crossing){at_height(&s[i], low), at_height(&s[i], high),
                            s[i].b[1] < s[i].a[1] ? 1 : -1};
    }
  }
  qsort(out, m, sizeof *out, by_place);
  return m;
}

/* The trapezoids between two heights: where one is in the polygon. */
static void
add_trapezoids(parts *ps, const crossing *c, size_t m, real low, real high,
               size_t owner)
{
  int within = 0;
  size_t open = 0;

  for (size_t i = 0; i < m; i++) {
    open = within == 0 ? i : open;
    within += c[i].turns;
    if (within == 0) {
      real corner[4][2] = {{c[open].low, low},
                           {c[i].low, low},
                           {c[i].high, high},
                           {c[open].high, high}};

      add_part(ps, (const real(*)[2])corner, 4, owner);
    }
  }
}

static void
add_slabs(parts *ps, const segment *s, size_t n, size_t owner)
{
  real *height = need(malloc((n + 1) * sizeof *height));
  crossing *c = need(malloc((n + 1) * sizeof *c));

  for (size_t i = 0; i < n; i++) {
    height[i] = s[i].a[1];
  }
  qsort(height, n, sizeof *height, by_value);
  for (size_t i = 0; i + 1 < n; i++) {
    if (height[i] < height[i + 1]) {
      size_t m = crossings(s, n, height[i], height[i + 1], c);

      add_trapezoids(ps, c, m, height[i], height[i + 1], owner);
    }
  }
  free(c);
  free(height);
}

/* -------------------------------------------------------- the pattern */

static void
add_polygon(parts *ps, const segment *s, size_t n, size_t owner)
{
  real(*corner)[2] = need(malloc((n + 1) * sizeof *corner));

  if (in_order(s, n, corner) && is_convex((const real(*)[2])corner, n)) {
    add_part(ps, (const real(*)[2])corner, n, owner);
  } else {
    add_slabs(ps, s, n, owner);
  }
  free(corner);
}

static void
add_flat(parts *ps, const pattern *p, size_t i)
{
  const flat *f = &p->flat[i];
  segment *s = need(malloc((f->count + 1) * sizeof *s));

  memset(s, 0, (f->count + 1) * sizeof *s);
  for (size_t k = 0; k < f->count; k++) {
    const side *x = &p->side[p->list[f->first + k]];

    for (int c = 0; c < 2; c++) {
      s[k].a[c] = p->spot[x->from].at[c];
      s[k].b[c] = p->spot[x->to].at[c];
    }
  }
  add_polygon(ps, s, f->count, i);
  free(s);
}

/* Tabs may go round either way. */
static void
add_tab(parts *ps, const pattern *p, size_t i)
{
  const tab *t = &p->tab[i];
  segment *s = need(malloc((t->count + 1) * sizeof *s));
  real area = 0;

  memset(s, 0, (t->count + 1) * sizeof *s);
  for (size_t k = 0; k < t->count; k++) {
    const double *a = p->corner[t->first + k];
    const double *b = p->corner[t->first + (k + 1) % t->count];

    area += (real)a[0] * b[1] - (real)a[1] * b[0];
    for (int c = 0; c < 2; c++) {
      s[k].a[c] = a[c];
      s[k].b[c] = b[c];
    }
  }
  for (size_t k = 0; area < 0 && k < t->count; k++) {
    for (int c = 0; c < 2; c++) {
      real x = s[k].a[c];

      s[k].a[c] = s[k].b[c];
      s[k].b[c] = x;
    }
  }
  add_polygon(ps, s, t->count, p->flats + i);
  free(s);
}

void
parts_of_pattern(const pattern *p, parts *out)
{
  *out = (parts){0};
  for (size_t i = 0; i < p->flats; i++) {
    add_flat(out, p, i);
  }
  for (size_t i = 0; i < p->tabs; i++) {
    add_tab(out, p, i);
  }
}

void
parts_clear(parts *ps)
{
  for (size_t i = 0; i < ps->n; i++) {
    free(ps->part[i].corner);
  }
  free(ps->part);
}
