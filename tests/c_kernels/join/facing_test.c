/* facing_test.c -- triangles at random on a grid and in shells in each other:
 * those of nodes that are said to be apart have nothing in common, and of
 * shells what is left grows with their number, not with its square.
 */
#include "join/bvh_join.h"
#include "join/cut.h"
#include "join/facing.h"
#include "tests/check.h"
#include "tests/stop_later.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 1 << 14 };

static double corner[MOST][3][3];
static atomic_long asked;

/* An sg_facing_read. */
static void
read_corners(const void *data, size_t i, double out[3][3])
{
  (void)data;
  memcpy(out, corner[i], sizeof corner[i]);
}

static void
boxes(const void *data, size_t begin, size_t end, sg_box *out)
{
  (void)data;
  for (size_t i = begin; i < end; i++) {
    out[i - begin] = sg_box_none();
    for (int k = 0; k < 3; k++) {
      sg_box_add(&out[i - begin], corner[i][k]);
    }
  }
}

static sg_bvh *
opened(size_t n, double reach, const sg_cancel *cancel, sg_facing *facing)
{
  sg_box all = sg_box_none();
  sg_bvh *tree = NULL;

  for (size_t i = 0; i < 3 * n; i++) {
    sg_box_add(&all, corner[i / 3][i % 3]);
  }
  if (sg_facing_find(n, read_corners, NULL, cancel, facing)) {
    tree = sg_bvh_grow_grouped(n, boxes, NULL, NULL, facing->group, &all, NULL,
                               NULL);
  }
  if (tree &&
      !sg_facing_measure(facing, tree, reach, read_corners, NULL, cancel)) {
    sg_bvh_close(tree);
    return NULL;
  }
  return tree;
}

/* ---- at random ---- */

static bool
have_in_common(uint32_t a, uint32_t b)
{
  sg_cut cut[SG_CUT_MAX];
  int n;

  sg_cut_triangles((const double(*)[3])corner[a], (const double(*)[3])corner[b],
                   cut, &n);
  return n > 0;
}

/* How many pairs of nodes are said to be apart; -1: one of them is not. */
static long
count_apart(const sg_bvh *tree, const sg_facing *facing)
{
  long apart = 0;

  for (unsigned level = 1; level < tree->levels; level++) {
    size_t width = (size_t)1 << (2 * level);

    for (size_t a = 0; a < tree->count[level]; a++) {
      for (size_t b = a; b < tree->count[level]; b++) {
        if (!sg_facing_apart(facing, level, a, b)) {
          continue;
        }
        apart++;
        for (size_t i = a * width; i < (a + 1) * width && i < tree->n; i++) {
          for (size_t k = b * width; k < (b + 1) * width && k < tree->n; k++) {
            if (have_in_common(tree->item[i], tree->item[k])) {
              return -1;
            }
          }
        }
      }
    }
  }
  return apart;
}

/* Many touch, some have no area, and some lie on each other. */
static void
at_random(uint32_t seed, int size, double scale)
{
  enum { N = 300 };
  sg_facing facing;

  for (size_t i = 0; i < N; i++) {
    for (int k = 0; k < 3; k++) {
      corner[i][0][k] = scale * check_below(&seed, size);
    }
    for (int k = 3; k < 9; k++) {
      corner[i][k / 3][k % 3] =
          corner[i][0][k % 3] +
          scale * (check_below(&seed, 3) - 1); /* small ones */
    }
  }
  sg_bvh *tree = opened(N, 0, NULL, &facing);
  long apart = tree ? count_apart(tree, &facing) : -1;

  CHECK("apart, and some are", apart > 0);
  sg_bvh_close(tree);
  sg_facing_clear(&facing);
}

/* ---- shells in each other ---- */

/* An octahedron with a turned and stretched frame. */
static size_t
add_shell(size_t n, double r)
{
  static const double frame[3][3] = {
      {0.8, 0.48, -0.36}, {-0.6, 0.64, -0.48}, {0, 0.6, 1.3}};

  for (int side = 0; side < 8; side++, n++) {
    for (int k = 0; k < 3; k++) {
      double sign = side >> k & 1 ? -r : r;

      for (int c = 0; c < 3; c++) {
        corner[n][k][c] = sign * frame[k][c] + 5;
      }
    }
  }
  return n;
}

static bool
ask(void *data, const sg_bvh_hit *hit)
{
  (void)data;
  (void)hit;
  atomic_fetch_add(&asked, 1);
  return false;
}

/* How many pairs of triangles are asked about. */
static long
asked_of_shells(int shells, double reach)
{
  size_t n = 0;
  sg_facing facing;
  sg_bvh_hits hits = {0};

  for (int i = 0; i < shells; i++) {
    n = add_shell(n, 1 + (double)i / shells);
  }
  sg_bvh *tree = opened(n, reach, NULL, &facing);

  atomic_store(&asked, 0);
  CHECK("joined",
        tree && sg_bvh_join_itself(tree, reach, ask, NULL, sg_facing_apart,
                                   &facing, NULL, NULL, &hits));
  free(hits.hit);
  sg_bvh_close(tree);
  sg_facing_clear(&facing);
  return atomic_load(&asked);
}

/* The reach is kept: with one as large as the distance of all, none is apart.
 */
static void
within_reach(void)
{
  CHECK("all within reach", asked_of_shells(20, 4) == 160L * 159 / 2);
}

/* What has no area, or is very large, is nowhere apart wrongly. */
static void
odd_ones(void)
{
  sg_facing facing;

  memset(corner, 0, 20 * sizeof corner[0]);
  for (size_t i = 10; i < 20; i++) {
    corner[i][1][0] = 1e300;
    corner[i][2][1] = -1e300;
  }
  sg_bvh *tree = opened(20, 0, NULL, &facing);

  CHECK("no node is apart from another",
        tree && count_apart(tree, &facing) == 0);
  sg_bvh_close(tree);
  sg_facing_clear(&facing);
  tree = opened(0, 0, NULL, &facing);
  CHECK("none", tree && tree->n == 0);
  sg_bvh_close(tree);
  sg_facing_clear(&facing);
}

static void
stops(void)
{
  for (int k = 0;; k++) {
    int left = k;
    sg_cancel cancel = {stop_later, &left};
    sg_facing facing;
    sg_bvh *tree = opened(MOST, 0, &cancel, &facing);

    CHECK("stopped, or not asked so often", !tree == (left < 0));
    sg_bvh_close(tree);
    sg_facing_clear(&facing);
    if (left >= 0) {
      CHECK("asked while ways are found and nodes filled", k > 5);
      break;
    }
  }
}

int
main(void)
{
  for (uint32_t seed = 0; seed < 20; seed++) {
    at_random(seed, 4 + (int)seed, seed % 2 ? 1 : 0.1);
  }
  long few = asked_of_shells(200, 0), many = asked_of_shells(1600, 0);

  CHECK("eight times as many shells, no more than twelve times as much",
        few > 0 && many < 12 * few);
  within_reach();
  odd_ones();
  stops();
  return check_report();
}
