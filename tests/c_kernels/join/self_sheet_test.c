/* self_sheet_test.c -- many triangles on one edge and at one vertex, each with
 * vertices of its own: pairs are few, connect all, and are pairs of the join.
 */
#include "join/self_sheet.h"
#include "rows/disjoint.h"
#include "rows/places.h"
#include "tests/check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 4096 };

static sg_fan_triangle triangle[MOST];
static uint32_t place[3 * MOST];
static size_t n;

static void
add(int32_t polygon, uint32_t name, const double at[3][3])
{
  sg_fan_triangle *t = &triangle[n++];

  t->polygon = polygon;
  for (uint32_t k = 0; k < 3; k++) {
    t->name[k] = name + k;
    memcpy(t->at[k], at[k], sizeof t->at[k]);
  }
}

static void
set_places(void)
{
  static double at[3 * MOST][3];
  uint32_t *of;

  for (size_t i = 0; i < 3 * n; i++) {
    memcpy(at[i], triangle[i / 3].at[i % 3], sizeof at[i]);
  }
  of = sg_places_of((const double(*)[3])at, 3 * n, NULL);
  memcpy(place, of, 3 * n * sizeof *place);
  free(of);
}

static bool
may_meet(void *data, const sg_fan_triangle *a, const sg_fan_triangle *b)
{
  sg_self_two two;

  (void)data;
  sg_self_two_of(a, b, &two);
  return a->polygon != b->polygon && sg_self_may_meet(&two);
}

static sg_bvh_hits
added(void)
{
  sg_bvh_hits hits = {0};

  set_places();
  CHECK("added",
        sg_self_sheets_add(triangle, n, place, may_meet, NULL, NULL, &hits));
  return hits;
}

static bool
are_many(void)
{
  bool many = false;

  set_places();
  CHECK("counted", sg_self_sheets_are_many(triangle, n, place, NULL, &many));
  return many;
}

/* Whether each pair is wanted and comes once, and how many things it leaves. */
static size_t
parts(const sg_bvh_hits *hits)
{
  static uint32_t of[MOST];
  size_t left = 0;

  for (uint32_t i = 0; i < n; i++) {
    of[i] = i;
  }
  for (size_t i = 0; i < hits->n; i++) {
    const sg_bvh_hit *hit = &hits->hit[i];

    if (hit->a >= hit->b ||
        !may_meet(NULL, &triangle[hit->a], &triangle[hit->b]) ||
        (i > 0 && hit[-1].a == hit->a && hit[-1].b == hit->b)) {
      return SIZE_MAX;
    }
    sg_disjoint_join(of, hit->a, hit->b);
  }
  for (uint32_t i = 0; i < n; i++) {
    left += of[i] == i;
  }
  return left;
}

/* Sheets of one triangle, each on the z axis, all round. */
static void
axis(size_t sheets)
{
  n = 0;
  for (size_t i = 0; i < sheets; i++) {
    double a = 6.28 * (double)i / (double)sheets;

    add((int32_t)i + 1, (uint32_t)(3 * i),
        (const double[3][3]){{0, 0, 0}, {0, 0, 1}, {cos(a), sin(a), 0.5}});
  }
}

static void
on_an_edge(void)
{
  axis(SG_SELF_SHEETS);
  CHECK("a few", !are_many());
  sg_bvh_hits hits = added();
  CHECK("of a few each two",
        hits.n == SG_SELF_SHEETS * (SG_SELF_SHEETS - 1) / 2);
  free(hits.hit);
  axis(1000);
  CHECK("many", are_many());
  hits = added();
  CHECK("some of many", hits.n < 1000 * SG_SELF_SHEETS);
  CHECK("that connect all", parts(&hits) == 1);
  free(hits.hit);
}

/* Chords, as in polygons of two triangles, are asked with others only after
 * what is an edge. There are so many that their vertices alone do not bring
 * each two together. */
static void
chords(void)
{
  enum { POLYGONS = 40 };

  n = 0;
  for (uint32_t i = 0; i < POLYGONS; i++) {
    double a = 0.15 * i, x = cos(a), y = sin(a);

    add((int32_t)i + 1, 4 * i,
        (const double[3][3]){{0, 0, 0}, {0, 0, 1}, {x, y, 0.5}});
    add((int32_t)i + 1, 4 * i,
        (const double[3][3]){{0, 0, 1}, {0, 0, 0}, {-x, -y, 0.5}});
    triangle[n - 1].name[0] = 4 * i + 1;
    triangle[n - 1].name[1] = 4 * i;
    triangle[n - 1].name[2] = 4 * i + 3;
  }
  add(1000, 1000, (const double[3][3]){{0, 0, 0}, {0, 0, 1}, {0.1, 0.7, 0.2}});
  sg_bvh_hits hits = added();
  bool seen[2 * POLYGONS + 1] = {false};

  for (size_t i = 0; i < hits.n; i++) {
    seen[hits.hit[i].a] = seen[hits.hit[i].a] || hits.hit[i].b == 2 * POLYGONS;
  }
  bool all = true;

  for (size_t i = 0; i < 2 * POLYGONS; i++) {
    all = all && seen[i];
  }
  CHECK("each chord with the edge", all);
  free(hits.hit);
}

/* Needles that have a point alone in one place. */
static void
at_a_vertex(void)
{
  n = 0;
  for (size_t i = 0; i < 500; i++) {
    double a = 6.28 * (double)i / 500;

    add((int32_t)i + 1, (uint32_t)(3 * i),
        (const double[3][3]){
            {0, 0, 0}, {cos(a), sin(a), 0.25}, {cos(a), sin(a), -0.25}});
  }
  CHECK("many at a vertex", are_many());
  sg_bvh_hits hits = added();

  CHECK("as many pairs, or fewer", hits.n < 500);
  free(hits.hit);
}

int
main(void)
{
  on_an_edge();
  chords();
  at_a_vertex();
  return check_report();
}
