/* fan_test.c -- triangles round a vertex: what goes through each other is found
 * all the same, and what is asked grows with their number, not with its square.
 */
#include "join/bvh_join.h"
#include "join/fan.h"
#include "join/self_pair.h"
#include "tests/check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 1 << 14 };

static sg_fan_triangle triangle[MOST];
static sg_bvh *tree;
static long asked;

static void
fill(const void *data, size_t begin, size_t end, sg_box *out)
{
  (void)data;
  for (size_t i = begin; i < end; i++) {
    out[i - begin] = sg_box_none();
    for (int k = 0; k < 3; k++) {
      sg_box_add(&out[i - begin], triangle[i].at[k]);
    }
  }
}

static void
read_triangle(const void *data, size_t place, sg_fan_triangle *out)
{
  (void)data;
  *out = triangle[tree->item[place]];
}

/* Whether two go through each other, except for triangles of one polygon. */
static bool
goes_through(void *data, const sg_bvh_hit *hit)
{
  const sg_fan_triangle *a = &triangle[tree->item[hit->a]];
  const sg_fan_triangle *b = &triangle[tree->item[hit->b]];
  sg_self_two two;

  (void)data;
  asked++;
  memcpy(two.a, a->at, sizeof two.a);
  memcpy(two.b, b->at, sizeof two.b);
  memcpy(two.a_at, a->name, sizeof two.a_at);
  memcpy(two.b_at, b->name, sizeof two.b_at);
  return a->polygon != b->polygon && sg_self_may_meet(&two) &&
         sg_self_goes_through(&two, 0);
}

/* The pairs of the first n that do; *had: there were fans. */
static sg_bvh_hits
pairs(size_t n, bool use, bool by_place, bool *had)
{
  sg_box all = sg_box_none(), box;
  sg_bvh_hits hits = {0};
  sg_fans *fans = NULL;

  for (size_t i = 0; i < n; i++) {
    fill(NULL, i, i + 1, &box);
    sg_box_join(&all, &box);
  }
  tree = sg_bvh_grow(n, fill, NULL, NULL, &all, NULL, NULL);
  bool good = tree && (!use || sg_fans_open(tree, read_triangle, NULL, by_place,
                                            NULL, &fans));
  *had = fans != NULL;
  asked = 0;
  CHECK("joined", good && sg_bvh_join_itself(tree, 0, goes_through, NULL,
                                             fans ? sg_fans_apart : NULL, fans,
                                             NULL, NULL, &hits));
  sg_fans_close(fans);
  sg_bvh_close(tree);
  return hits;
}

/* ---- at random ---- */

static void
set_corner(sg_fan_triangle *t, int k, const int at[3])
{
  for (int l = 0; l < 3; l++) {
    t->at[k][l] = at[l] * 0.7;
  }
  t->name[k] = (uint32_t)(at[0] + 32 * at[1] + 1024 * at[2]);
}

/* Triangles on one of two hubs of a grid, and some on none. */
static void
make_fans(size_t n, int size)
{
  int hub[2][3];

  for (int i = 0; i < 6; i++) {
    hub[i / 3][i % 3] = rand() % 16;
  }
  for (size_t i = 0; i < n; i++) {
    int at[3], first = rand() % 3, on = rand() % 20 == 0 ? 2 : rand() % 2;
    int from[3] = {rand() % 16, rand() % 16, rand() % 16};
    for (int k = 0; k < 3; k++) {
      for (int l = 0; l < 3; l++) {
        at[l] = on < 2 && k == first ? hub[on][l] : from[l] + rand() % size;
      }
      set_corner(&triangle[i], k, at);
    }
    triangle[i].polygon = (int32_t)(rand() % 4 ? i : i / 40);
  }
}

static void
test_same(void)
{
  int with = 0;
  size_t found = 0;

  for (int i = 0; i < 150; i++) {
    bool had;
    size_t n = 20 + (size_t)rand() % 400;
    make_fans(n, 2 + i % 6);
    sg_bvh_hits plain = pairs(n, false, false, &had);
    sg_bvh_hits named = pairs(n, true, false, &had);
    sg_bvh_hits placed = pairs(n, true, true, &had);
    with += had;
    found += plain.n;
    CHECK("the same pairs by names",
          plain.n == named.n &&
              memcmp(plain.hit, named.hit, plain.n * sizeof *plain.hit) == 0);
    CHECK("and by places",
          plain.n == placed.n &&
              memcmp(plain.hit, placed.hit, plain.n * sizeof *plain.hit) == 0);
    free(plain.hit);
    free(named.hit);
    free(placed.hit);
  }
  CHECK("often there are fans", with > 50);
  CHECK("many go through each other", found > 10000);
}

/* ---- how much is asked ---- */

/* Cones on n corners, both with their apexes in the origin, and no other vertex
 * in common; `far` makes the one a needle fan. */
static void
make_cones(size_t n, double far)
{
  for (size_t i = 0; i < n; i++) {
    double sign = i % 2 ? 1 : -1;
    memset(&triangle[i], 0, sizeof triangle[i]);
    for (int k = 1; k < 3; k++) {
      double angle = 2 * 3.14159265358979 * (double)(i / 2 + (size_t)k - 1) /
                     ((double)n / 2);
      triangle[i].at[k][0] = far * cos(angle);
      triangle[i].at[k][1] = far * sin(angle);
      triangle[i].at[k][2] = sign;
      triangle[i].name[k] =
          (uint32_t)(2 * ((i / 2 + (size_t)k - 1) % (n / 2)) + i % 2 + 2);
    }
    triangle[i].name[0] = i % 2;
    triangle[i].polygon = (int32_t)i;
  }
}

static long
asked_of(size_t n, bool use, double far)
{
  bool had;

  make_cones(n, far);
  sg_bvh_hits hits = pairs(n, use, true, &had);
  CHECK("nothing goes through", hits.n == 0);
  CHECK("fans where they are wanted", had == use);
  free(hits.hit);
  return asked;
}

static void
test_growth(void)
{
  CHECK("each with each, without", asked_of(1024, false, 1) > 200000);
  for (int i = 0; i < 3; i++) {
    double far = i == 0 ? 1 : i == 1 ? 0.01 : 100;
    long few = asked_of(1024, true, far), more = asked_of(MOST, true, far);
    CHECK("some of each", few < 40 * 1024);
    CHECK("in proportion", more < 24 * few);
  }
}

/* A polygon of many triangles asks nothing of itself. */
static void
test_polygon(void)
{
  bool had;

  make_fans(4096, 3);
  for (size_t i = 0; i < 4096; i++) {
    triangle[i].polygon = 7;
  }
  free(pairs(4096, true, false, &had).hit);
  CHECK("of one polygon nothing is asked", had && asked == 0);
}

int
main(void)
{
  srand(1988);
  test_same();
  test_growth();
  test_polygon();
  return check_report();
}
