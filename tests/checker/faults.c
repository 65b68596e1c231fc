#include "faults.h"

#include "boxes.h"
#include "meeting.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void *
room(size_t n, size_t size)
{
  void *memory = calloc(n ? n : 1, size);

  if (!memory) {
    fputs("no memory\n", stderr);
    exit(2);
  }
  return memory;
}

static const double *
corner_at(const soup *s, int triangle, int k)
{
  return s->point[s->corner[triangle][k]];
}

static void
corners_of(const double *out[3], const soup *s, int triangle)
{
  for (int k = 0; k < 3; k++) {
    out[k] = corner_at(s, triangle, k);
  }
}

/* - - - groups of things that are connected - - - */

static int
group_of(int *parent, int i)
{
  while (parent[i] != i) {
    i = parent[i] = parent[parent[i]];
  }
  return i;
}

static int *
groups(size_t n)
{
  int *parent = room(n, sizeof *parent);

  for (size_t i = 0; i < n; i++) {
    parent[i] = (int)i;
  }
  return parent;
}

/* - - - edges - - - */

/* A triangle's edge from its corner k, low < high; forth 1 or -1. */
typedef struct use {
  int low, high, forth, triangle, k;
} use;

static int
by_edge(const void *a, const void *b)
{
  const use *p = a, *q = b;

  if (p->low != q->low) {
    return p->low < q->low ? -1 : 1;
  }
  if (p->high != q->high) {
    return p->high < q->high ? -1 : 1;
  }
  return p->triangle < q->triangle ? -1 : p->triangle > q->triangle;
}

static size_t
sorted_uses(const soup *s, use *out)
{
  size_t n = 0;

  for (size_t t = 0; t < s->triangles; t++) {
    for (int k = 0; k < 3; k++) {
      int a = s->corner[t][k], b = s->corner[t][(k + 1) % 3];

      if (a != b) {
        out[n++] =
            a < b ? (use){a, b, 1, (int)t, k} : (use){b, a, -1, (int)t, k};
      }
    }
  }
  qsort(out, n, sizeof *out, by_edge);
  return n;
}

/* Joins the corners at both ends of an edge of two triangles. */
static void
join_corners(const soup *s, int *fan, const use *a, const use *b)
{
  for (int end = 0; end < 2; end++) {
    int ka = (a->k + end) % 3, kb = (b->k + end) % 3;

    if (s->corner[a->triangle][ka] != s->corner[b->triangle][kb]) {
      kb = (b->k + 1 - end) % 3;
    }
    fan[group_of(fan, 3 * a->triangle + ka)] =
        group_of(fan, 3 * b->triangle + kb);
  }
}

/* The uses of one edge, and what they make of its triangles. */
static void
count_edge(faults *f, const soup *s, const use *first, size_t n, int *component,
           int *fan)
{
  int balance = 0;

  for (size_t i = 0; i < n; i++) {
    balance += first[i].forth;
    component[group_of(component, first[i].triangle)] =
        group_of(component, first->triangle);
  }
  f->edges++;
  f->open += n % 2;
  f->unbalanced += balance != 0;
  f->shared += balance == 0 && n > 2;
  if (n == 2) {
    join_corners(s, fan, &first[0], &first[1]);
  }
}

/* Counts the vertices that are used and those with several fans. */
static void
count_vertices(faults *f, const soup *s, int *fan)
{
  int *owner = room(s->points, sizeof *owner);

  for (size_t i = 0; i < 3 * s->triangles; i++) {
    int v = s->corner[i / 3][i % 3], own = group_of(fan, (int)i) + 1;

    if (owner[v] == 0) {
      owner[v] = own;
      f->euler++;
    } else if (owner[v] > 0 && owner[v] != own) {
      owner[v] = -1;
      f->pinched++;
    }
  }
  free(owner);
}

static int *
joined(faults *f, const soup *s, int *fan)
{
  use *uses = room(3 * s->triangles, sizeof *uses);
  int *component = groups(s->triangles);
  size_t n = sorted_uses(s, uses), next;

  for (size_t i = 0; i < n; i = next) {
    for (next = i + 1; next < n && uses[next].low == uses[i].low &&
                       uses[next].high == uses[i].high;
         next++) {
    }
    count_edge(f, s, uses + i, next - i, component, fan);
  }
  free(uses);
  return component;
}

void
faults_of_edges(faults *f, const soup *s)
{
  int *fan = groups(3 * s->triangles);
  int *component = joined(f, s, fan);

  f->euler = (long)s->triangles - (long)f->edges;
  count_vertices(f, s, fan);
  for (size_t t = 0; t < s->triangles; t++) {
    f->components += component[t] == (int)t;
  }
  free(component);
  free(fan);
}

/* - - - pairs - - - */

typedef struct pairs {
  faults *faults;
  const soup *soup;
  FILE *out;
} pairs;

static void
print_pair(const pairs *p, int t1, int t2, meeting common)
{
  static const char *const NAME[] = {"apart", "in_point", "in_line", "crossing",
                                     "overlap"};

  fprintf(p->out, "  %s:", NAME[common]);
  for (int i = 0; i < 6; i++) {
    const double *at = corner_at(p->soup, i < 3 ? t1 : t2, i % 3);

    fprintf(p->out, "%s (%.17g %.17g %.17g)", i == 3 ? " and" : "", at[0],
            at[1], at[2]);
  }
  fputc('\n', p->out);
}

/* Puts the corners that both have first; returns how many. */
static int
shared_first(int a[3], int b[3])
{
  int shared = 0;

  for (int i = 0; i < 3; i++) {
    for (int j = shared; j < 3 && i >= shared; j++) {
      if (a[i] == b[j]) {
        int x = a[i], y = b[j];

        a[i] = a[shared];
        b[j] = b[shared];
        a[shared] = x;
        b[shared++] = y;
        break;
      }
    }
  }
  return shared;
}

static void
visit_pair(void *data, int t1, int t2)
{
  pairs *p = data;
  const soup *s = p->soup;
  const double *at1[3], *at2[3];
  int a[3], b[3], shared;
  meeting common;

  memcpy(a, s->corner[t1], sizeof a);
  memcpy(b, s->corner[t2], sizeof b);
  shared = shared_first(a, b);
  for (int k = 0; k < 3; k++) {
    at1[k] = s->point[a[k]];
    at2[k] = s->point[b[k]];
  }
  common = meeting_of(at1, at2, shared);
  p->faults->meeting[common]++;
  if (p->out && common != APART) {
    print_pair(p, t1, t2, common);
  }
}

static box
box_of(const soup *s, int t)
{
  box b = {
      {INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, t};

  for (int i = 0; i < 3; i++) {
    const double *at = corner_at(s, t, i);

    for (int k = 0; k < 3; k++) {
      b.low[k] = at[k] < b.low[k] ? at[k] : b.low[k];
      b.high[k] = at[k] > b.high[k] ? at[k] : b.high[k];
    }
  }
  return b;
}

void
faults_of_pairs(faults *f, const soup *s, FILE *out)
{
  box *boxes = room(s->triangles, sizeof *boxes);
  pairs data = {f, s, out};
  size_t n = 0;

  for (size_t t = 0; t < s->triangles; t++) {
    const double *at[3];

    corners_of(at, s, (int)t);
    if (has_no_area(at)) {
      f->zero_area++;
    } else {
      boxes[n++] = box_of(s, (int)t);
    }
  }
  boxes_meeting(boxes, n, visit_pair, &data);
  free(boxes);
}

/* - - - measures - - - */

/* Twice the area times the normal, from differences, which cancel least. */
static void
normal_of(long double out[3], const double *a, const double *b, const double *c)
{
  for (int k = 0; k < 3; k++) {
    int x = (k + 1) % 3, y = (k + 2) % 3;

    out[k] = ((long double)b[x] - a[x]) * ((long double)c[y] - a[y]) -
             ((long double)b[y] - a[y]) * ((long double)c[x] - a[x]);
  }
}

void
measures_of(faults *f, const soup *s)
{
  const double *origin = s->triangles ? corner_at(s, 0, 0) : NULL;
  long double volume = 0, area = 0;

  for (size_t t = 0; t < s->triangles; t++) {
    const double *at[3];
    long double n[3], square = 0;

    corners_of(at, s, (int)t);
    normal_of(n, at[0], at[1], at[2]);
    for (int k = 0; k < 3; k++) {
      square += n[k] * n[k];
      volume += n[k] * ((long double)at[0][k] - origin[k]);
    }
    area += sqrtl(square);
  }
  f->volume = (double)(volume / 6);
  f->area = (double)(area / 2);
}

/* - - - turning - - - */

/* The solid angle of a triangle seen from a point, as part of all round it. */
static long double
angle_of(const long double from[3], const double *at[3])
{
  long double r[3][3], length[3], dot[3], det;

  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      r[i][k] = at[i][k] - from[k];
    }
    length[i] =
        sqrtl(r[i][0] * r[i][0] + r[i][1] * r[i][1] + r[i][2] * r[i][2]);
  }
  for (int i = 0; i < 3; i++) {
    const long double *a = r[(i + 1) % 3], *b = r[(i + 2) % 3];

    dot[i] = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  det = r[0][0] * (r[1][1] * r[2][2] - r[1][2] * r[2][1]) +
        r[0][1] * (r[1][2] * r[2][0] - r[1][0] * r[2][2]) +
        r[0][2] * (r[1][0] * r[2][1] - r[1][1] * r[2][0]);
  return atan2l(det, length[0] * length[1] * length[2] + dot[0] * length[0] +
                         dot[1] * length[1] + dot[2] * length[2]) /
         (2 * acosl(-1));
}

/* How often all but triangle t go round its middle: the mean of both sides,
 * one half on the boundary of a solid. */
static bool
is_boundary(const soup *s, int t)
{
  const double *at[3];
  long double middle[3], sum = 0;

  corners_of(at, s, t);
  for (int k = 0; k < 3; k++) {
    middle[k] = ((long double)at[0][k] + at[1][k] + at[2][k]) / 3;
  }
  for (size_t u = 0; u < s->triangles; u++) {
    if ((int)u != t) {
      corners_of(at, s, (int)u);
      sum += angle_of(middle, at);
    }
  }
  return fabsl(sum - 0.5L) < 1e-4L;
}

static long double
square_of(const soup *s, int t)
{
  const double *at[3];
  long double n[3];

  corners_of(at, s, t);
  normal_of(n, at[0], at[1], at[2]);
  return n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
}

/* Of each component the largest triangle is asked. */
void
faults_of_turning(faults *f, const soup *s)
{
  faults unused = {0};
  int *fan = groups(3 * s->triangles), *largest;
  int *component = joined(&unused, s, fan);

  largest = room(s->triangles, sizeof *largest);
  for (size_t t = 0; t < s->triangles; t++) {
    int g = group_of(component, (int)t);

    if (largest[g] == 0 ||
        square_of(s, (int)t) > square_of(s, largest[g] - 1)) {
      largest[g] = (int)t + 1;
    }
  }
  for (size_t t = 0; t < s->triangles; t++) {
    f->misturned += largest[t] > 0 && !is_boundary(s, largest[t] - 1);
  }
  free(largest);
  free(component);
  free(fan);
}
