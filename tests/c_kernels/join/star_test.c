/* star_test.c -- arcs on a sphere that cross: what is not crossed has nothing
 * in common, by a rule that looks at each two; and few are crossed if few
 * cross.
 *
 * covers: self_star
 */
#include "join/star.h"
#include "number/exact.h"
#include "tests/check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 4096 };

static sg_star_arc arc[MOST];
static bool crossed[MOST];
static const double hub[3] = {1, 2, 3};

/* End i is in direction (x, y, z) of whole numbers, anywhere on its ray. */
static void
set_end(sg_star_arc *a, int k, const int at[3], uint32_t name)
{
  for (int c = 0; c < 3; c++) {
    a->at[k][c] = hub[c] + at[c];
  }
  a->end[k] = name;
}

/* Two arcs have a point in common that is no end of both: rule. */
static int
side(const double a[3], const double b[3], const double c[3])
{
  return sg_orient3d(hub, a, b, c);
}

/* Whether p, in the plane of an arc, is in it (its ends are). */
static bool
is_in(const sg_star_arc *a, const double p[3])
{
  double u[3], w[3], d[3], n[3];

  for (int k = 0; k < 3; k++) {
    u[k] = a->at[0][k] - hub[k];
    w[k] = a->at[1][k] - hub[k];
    d[k] = p[k] - hub[k];
  }
  for (int k = 0; k < 3; k++) {
    int g = (k + 1) % 3, h = (k + 2) % 3;
    n[k] = u[g] * w[h] - u[h] * w[g];
  }
  double before = 0, behind = 0; /* whole numbers: exact */

  for (int k = 0; k < 3; k++) {
    int g = (k + 1) % 3, h = (k + 2) % 3;
    before += n[k] * (u[g] * d[h] - u[h] * d[g]);
    behind += n[k] * (d[g] * w[h] - d[h] * w[g]);
  }
  return before >= 0 && behind >= 0;
}

static bool
have_more(const sg_star_arc *a, const sg_star_arc *b)
{
  int c = side(a->at[0], a->at[1], b->at[0]);
  int d = side(a->at[0], a->at[1], b->at[1]);
  int e = side(b->at[0], b->at[1], a->at[0]);
  int f = side(b->at[0], b->at[1], a->at[1]);

  for (int k = 0; k < 2; k++) {
    bool shared_b = b->end[k] == a->end[0] || b->end[k] == a->end[1];
    bool shared_a = a->end[k] == b->end[0] || a->end[k] == b->end[1];

    if ((!shared_b && (k ? d : c) == 0 && is_in(a, b->at[k])) ||
        (!shared_a && (k ? f : e) == 0 && is_in(b, a->at[k]))) {
      return true;
    }
  }
  return c * d < 0 && e * f < 0 && c != e;
}

static bool
is_flat(const sg_star_arc *a)
{
  double way[3] = {hub[0] + 0.3, hub[1] + 0.7, hub[2] + 0.9};
  double other[3] = {hub[0] + 0.9, hub[1] - 0.7, hub[2] + 0.2};

  return side(a->at[0], a->at[1], way) == 0 &&
         side(a->at[0], a->at[1], other) == 0;
}

static bool
are_equal(const sg_star_arc *a, const sg_star_arc *b)
{
  return (a->end[0] == b->end[0] && a->end[1] == b->end[1]) ||
         (a->end[0] == b->end[1] && a->end[1] == b->end[0]);
}

static void
check_all(size_t n, bool equal, size_t *clean)
{
  bool good = true;

  for (size_t i = 0; i < n; i++) {
    *clean += !crossed[i];
    for (size_t k = i + 1; k < n && good; k++) {
      good =
          crossed[i] || crossed[k] ||
          (are_equal(&arc[i], &arc[k]) ? equal : !have_more(&arc[i], &arc[k]));
    }
    good = good && (crossed[i] || !is_flat(&arc[i]));
  }
  CHECK("what is left has ends in common only", good);
}

/* Arcs between directions of small whole numbers, of which many are equal, in
 * one plane or opposite. */
static void
test_random(void)
{
  size_t clean = 0, all = 0;

  for (int round = 0; round < 3000; round++) {
    size_t n = 2 + (size_t)rand() % 30;
    int size = 1 + rand() % 8;
    uint32_t names = (uint32_t)(2 * size + 1);

    for (size_t i = 0; i < n; i++) {
      int at[3], near[3];
      bool close = rand() % 2;

      for (int k = 0; k < 3; k++) {
        at[k] = rand() % (2 * size + 1) - size;
        near[k] =
            close ? at[k] + rand() % 3 - 1 : rand() % (2 * size + 1) - size;
        near[k] = near[k] > size ? size : near[k] < -size ? -size : near[k];
      }
      for (int k = 0; k < 2; k++) {
        const int *p = k ? near : at;
        uint32_t name = 0;

        for (int c = 0; c < 3; c++) {
          name = name * names + (uint32_t)(p[c] + size);
        }
        set_end(&arc[i], k, p, name);
      }
    }
    bool equal = rand() % 2;

    CHECK("swept", sg_star_cross(hub, arc, n, names * names * names, equal,
                                 NULL, crossed));
    check_all(n, equal, &clean);
    all += n;
  }
  CHECK("many are left", clean > all / 5 && clean < all);
}

/* Arcs from two points that meet on a line between them, nested: those to the
 * same points have these in common, others nothing; and some that lie across.
 */
static void
test_few(void)
{
  size_t n = 3000, across = 7, left = 0;

  for (size_t i = 0; i < n; i++) {
    uint32_t name = (uint32_t)(i / 2);
    int top[3] = {0, 2000, (int)name - 700};

    set_end(&arc[i], 0, (int[3]){i % 2 ? 9000 : -9000, 2000, -900},
            1600 + i % 2);
    set_end(&arc[i], 1, top, name);
  }
  for (size_t i = n; i < n + across; i++) {
    int from[3] = {-4000 + (int)i, 2000, 3000}, to[3] = {-4001, 2000, -4000};

    set_end(&arc[i], 0, from, (uint32_t)(1602 + 2 * (i - n)));
    set_end(&arc[i], 1, to, (uint32_t)(1603 + 2 * (i - n)));
    arc[i].at[1][0] -= 0.5 * (double)i;
  }
  CHECK("swept", sg_star_cross(hub, arc, n + across, 1602 + 2 * across, false,
                               NULL, crossed));
  for (size_t i = 0; i < n; i++) {
    left += !crossed[i];
  }
  CHECK("few are crossed", left >= n - 2 * across);
  for (size_t i = n; i < n + across; i++) {
    CHECK("what lies across is", crossed[i]);
  }
}

int
main(void)
{
  srand(1976);
  test_random();
  test_few();
  return check_report();
}
