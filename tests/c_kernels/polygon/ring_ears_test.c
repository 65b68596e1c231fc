/* ring_ears_test.c -- the triangles of a ring end where it ends. */
#include "polygon/ring_ears.h"

#include "tests/check.h"

#include <stdlib.h>
#include <string.h>

enum { MOST = 40 };

static double at[MOST][3];
static sg_ring_edge edge[MOST];
static int32_t triangle[MOST][3];

/* Each side of the ring once, each chord once either way. */
static bool
ends_with_the_ring(size_t n)
{
  static int times[MOST][MOST];

  memset(times, 0, sizeof times);
  for (size_t i = 0; i < n - 2; i++) {
    for (int k = 0; k < 3; k++) {
      times[triangle[i][k]][triangle[i][(k + 1) % 3]]++;
    }
  }
  for (size_t a = 0; a < n; a++) {
    for (size_t b = 0; b < n; b++) {
      int wanted = (b == (a + 1) % n) - (a == (b + 1) % n);
      if (times[a][b] - times[b][a] != wanted) {
        return false;
      }
    }
  }
  return true;
}

/* Vertices 0 to n - 1 in order, their edges in another one. */
static void
make_ring(size_t n)
{
  for (size_t i = 0; i < n; i++) {
    size_t v = i * 7 % n;
    if (n % 7 == 0) {
      v = i;
    }
    edge[i] = (sg_ring_edge){(int32_t)v, (int32_t)((v + 1) % n), at[v]};
  }
}

static void
random_rings(void)
{
  bool all = true, is_ring;

  srand(7);
  for (int round = 0; round < 500; round++) {
    size_t n = 4 + (size_t)(rand() % (MOST - 4));
    for (size_t i = 0; i < n; i++) {
      for (int k = 0; k < 3; k++) {
        at[i][k] = rand() % 5;
      }
    }
    make_ring(n);
    all &= sg_ring_ears(edge, n, triangle, &is_ring) && is_ring &&
           ends_with_the_ring(n);
  }
  CHECK("500 rings on a small grid", all);
}

static void
small_ones(void)
{
  static const double quad[4][3] = {{0}, {1, 0, 0}, {9, 9, 1}, {0, 1, 0}};
  bool is_ring;

  memcpy(at, quad, sizeof quad);
  make_ring(4);
  CHECK("the shorter chord first",
        sg_ring_ears(edge, 4, triangle, &is_ring) && is_ring &&
            triangle[0][0] == 3 && triangle[0][1] == 0 && triangle[0][2] == 1);
  make_ring(4);
  edge[0].end = edge[0].start;
  CHECK("no ring", sg_ring_ears(edge, 4, triangle, &is_ring) && !is_ring);
  make_ring(3);
  for (int i = 0; i < 3; i++) {
    edge[3 + i] = edge[i];
    edge[3 + i].start += 3;
    edge[3 + i].end += 3;
  }
  CHECK("two rings", sg_ring_ears(edge, 6, triangle, &is_ring) && !is_ring);
}

int
main(void)
{
  random_rings();
  small_ones();
  return check_report();
}
