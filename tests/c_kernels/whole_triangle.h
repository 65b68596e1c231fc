/* whole_triangle.h -- triangles with whole numbers for coordinates, small ones:
 * what is said of them is said in whole numbers.
 */
#ifndef SG_TEST_WHOLE_TRIANGLE_H
#define SG_TEST_WHOLE_TRIANGLE_H

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

typedef struct triangle {
  int32_t s;
  int at[3][3];
} triangle;

static inline int
volume(const int *a, const int *b, const int *c, const int *d)
{
  int u[3], v[3], w[3];

  for (int k = 0; k < 3; k++) {
    u[k] = b[k] - a[k];
    v[k] = c[k] - a[k];
    w[k] = d[k] - a[k];
  }
  return u[0] * (v[1] * w[2] - v[2] * w[1]) -
         u[1] * (v[0] * w[2] - v[2] * w[0]) +
         u[2] * (v[0] * w[1] - v[1] * w[0]);
}

/* Along z, x, y by turns. */
static inline int
area(const int *a, const int *b, const int *c, int axis)
{
  int x = (axis + 1) % 3, y = (axis + 2) % 3;

  return (b[x] - a[x]) * (c[y] - a[y]) - (b[y] - a[y]) * (c[x] - a[x]);
}

static inline bool
has_area(const triangle *t)
{
  return area(t->at[0], t->at[1], t->at[2], 0) ||
         area(t->at[0], t->at[1], t->at[2], 1) ||
         area(t->at[0], t->at[1], t->at[2], 2);
}

static inline bool
same_place(const int *a, const int *b)
{
  return memcmp(a, b, sizeof(int[3])) == 0;
}

static inline bool
one_side(int a, int b, int c)
{
  return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

/* Two stretches in one plane that is not along the axis. */
static inline bool
stretches_meet(const int *p, const int *q, const int *a, const int *b, int axis)
{
  int a1 = area(p, q, a, axis), b1 = area(p, q, b, axis);
  int p1 = area(a, b, p, axis), q1 = area(a, b, q, axis);

  if (a1 || b1 || p1 || q1) {
    return (a1 <= 0 || b1 <= 0) && (a1 >= 0 || b1 >= 0) &&
           (p1 <= 0 || q1 <= 0) && (p1 >= 0 || q1 >= 0);
  }
  for (int k = 0; k < 3; k++) { /* on one line */
    int low = p[k] < q[k] ? p[k] : q[k], high = p[k] < q[k] ? q[k] : p[k];
    if ((a[k] < low && b[k] < low) || (a[k] > high && b[k] > high)) {
      return false;
    }
  }
  return true;
}

static inline bool
meets(const int *p, const int *q, const triangle *t)
{
  const int *a = t->at[0], *b = t->at[1], *c = t->at[2];
  int at_p = volume(a, b, c, p), at_q = volume(a, b, c, q), axis = 0;

  if (at_p || at_q) {
    return (at_p <= 0 || at_q <= 0) && (at_p >= 0 || at_q >= 0) &&
           one_side(volume(p, q, a, b), volume(p, q, b, c), volume(p, q, c, a));
  }
  while (!area(a, b, c, axis)) {
    axis++;
  }
  return one_side(area(a, b, p, axis), area(b, c, p, axis),
                  area(c, a, p, axis)) ||
         stretches_meet(p, q, a, b, axis) || stretches_meet(p, q, b, c, axis) ||
         stretches_meet(p, q, c, a, axis);
}

/* A side of one meets the other. */
static inline bool
triangles_meet(const triangle *a, const triangle *b)
{
  for (int i = 0; i < 3; i++) {
    if (meets(a->at[i], a->at[(i + 1) % 3], b) ||
        meets(b->at[i], b->at[(i + 1) % 3], a)) {
      return true;
    }
  }
  return false;
}

#endif
