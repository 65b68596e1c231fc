/* self_join_test.c -- triangles on one edge, round flat polygons of many
 * triangles, and in rings in each other: what meets is found all the same, in
 * the same order, and what is asked grows with their number, not with its
 * square.
 *
 * covers: node_box, spine
 */
#include "join/self_join.h"
#include "tests/check.h"
#include "tests/stop_later.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 1 << 14 };

static sg_fan_triangle triangle[MOST];
static unsigned char changed[MOST];
static atomic_long asked;
static bool by_place, in_faces;

static void
read_triangle(const void *data, uint32_t i, sg_fan_triangle *out)
{
  (void)data;
  *out = triangle[i];
}

static bool
goes_through(void *data, const sg_fan_triangle *a, const sg_fan_triangle *b)
{
  sg_self_two two;

  (void)data;
  atomic_fetch_add(&asked, 1);
  sg_self_two_of(a, b, &two);
  return (in_faces || a->polygon != b->polygon) && sg_self_may_meet(&two) &&
         sg_self_goes_through(&two, 0);
}

static const sg_cancel *cancel;

static sg_bvh_hits
joined(size_t n, bool some)
{
  const sg_self_joining joining = {.n = n,
                                   .read = read_triangle,
                                   .wants = goes_through,
                                   .by_place = by_place,
                                   .in_polygons = in_faces,
                                   .in_faces = in_faces,
                                   .changed = some ? changed : NULL};
  sg_bvh_hits hits;

  atomic_store(&asked, 0);
  bool good = sg_self_join(&joining, NULL, cancel, &hits);

  CHECK("joined, or stopped with nothing", good || (cancel && !hits.hit));
  return hits;
}

static int
by_pair(const void *x, const void *y)
{
  const sg_bvh_hit *a = x, *b = y;

  return a->a != b->a ? (a->a > b->a) - (a->a < b->a)
                      : (a->b > b->b) - (a->b < b->b);
}

/* Whether the hits are the pairs that go through each other, each once. */
static bool
are_all(const sg_bvh_hits *hits, size_t n, bool some)
{
  size_t next = 0;

  if (hits->n > 0) {
    qsort(hits->hit, hits->n, sizeof *hits->hit, by_pair);
  }
  for (uint32_t i = 0; i < n; i++) {
    for (uint32_t k = i + 1; k < n; k++) {
      if ((!some || changed[i] || changed[k]) &&
          goes_through(NULL, &triangle[i], &triangle[k])) {
        if (next == hits->n || hits->hit[next].a != i ||
            hits->hit[next].b != k) {
          return false;
        }
        next++;
      }
    }
  }
  return next == hits->n;
}

/* ---- at random, on a grid ---- */

static void
set_corner(sg_fan_triangle *t, int k, int x, int y, int z)
{
  t->at[k][0] = x * 0.5;
  t->at[k][1] = y * 0.5;
  t->at[k][2] = z * 0.5 + x * 0.125; /* across z, exactly in one plane */
  t->name[k] = (uint32_t)(x + 64 * y + 4096 * z);
}

/* A flat polygon: a fan from one corner over the others of a staircase. */
static size_t
add_face(size_t n, int32_t p, int z)
{
  for (int i = 0; i < 40; i++) {
    sg_fan_triangle *t = &triangle[n++];

    set_corner(t, 0, 0, 40, z);
    set_corner(t, 1, i, i / 2, z);
    set_corner(t, 2, i + 1, (i + 1) / 2, z);
    t->polygon = p;
  }
  return n;
}

/* One of them on an edge of a face or on the spine, or anywhere. */
static void
random_triangle(sg_fan_triangle *t)
{
  int i = rand() % 40, z = rand() % 2 ? 3 : 9;

  for (int k = 0; k < 3; k++) {
    set_corner(t, k, rand() % 44, rand() % 44, rand() % 12);
  }
  switch (rand() % 5) {
  case 0: /* an edge of a face */
    set_corner(t, 1, i, i / 2, z);
    set_corner(t, 2, i + 1, (i + 1) / 2, z);
    break;
  case 1: /* a corner */
    set_corner(t, 0, i, i / 2, z);
    break;
  case 2: /* near a corner */
    for (int k = 0; k < 3; k++) {
      set_corner(t, k, i + rand() % 3, i / 2 + rand() % 3, z - rand() % 2);
    }
    break;
  case 3: /* the spine */
    set_corner(t, 0, 50, 20, 1);
    set_corner(t, 1, 50, 20, 11);
    set_corner(t, 2, 46 + rand() % 9, 16 + rand() % 9, rand() % 12);
    break;
  default: /* an end of it, or beside it */
    set_corner(t, rand() % 2, 50, 20, rand() % 2 ? 1 : rand() % 12);
    break;
  }
}

/* What is in one place is not taken for one. */
static void
part_names(size_t n)
{
  for (size_t i = 0; i < 3 * n; i++) {
    triangle[i / 3].name[i % 3] = (uint32_t)i;
  }
}

static void
test_same(void)
{
  size_t found = 0;

  for (int i = 0; i < 60; i++) {
    size_t n = add_face(0, 100000, 3), end = 100 + (size_t)rand() % 500;

    n = add_face(n, 100001, 9);
    for (; n < end; n++) {
      random_triangle(&triangle[n]);
      triangle[n].polygon = (int32_t)(rand() % 3 ? n : n / 2);
    }
    by_place = i % 3 == 2;
    if (by_place) {
      part_names(n);
    }
    for (size_t k = 0; k < n; k++) {
      changed[k] = rand() % (i % 2 ? 2 : 40) == 0;
    }
    sg_bvh_hits all = joined(n, false), some = joined(n, true);

    found += all.n;
    CHECK("what goes through", are_all(&all, n, false));
    CHECK("what does that is changed", are_all(&some, n, true));
    free(all.hit);
    free(some.hit);
  }
  CHECK("much does", found > 5000);
}

/* Triangles of a flat polygon that lie on each other are found, if that is
 * asked for. */
static void
test_in_faces(void)
{
  size_t found = 0;

  by_place = false;
  in_faces = true;
  for (int i = 0; i < 30; i++) {
    size_t n = add_face(0, 100000, 3), end = 300;

    for (int k = rand() % 30, more = 0; more < 4; more++, n++) {
      triangle[n] = triangle[k + more];
      set_corner(&triangle[n], 2, k + more + 3, (k + more + 3) / 2, 3);
    }
    for (; n < end; n++) {
      random_triangle(&triangle[n]);
      triangle[n].polygon = (int32_t)n;
    }
    for (size_t k = 0; k < n; k++) {
      changed[k] = rand() % 3 == 0;
    }
    sg_bvh_hits all = joined(n, false), some = joined(n, true);

    for (size_t k = 0; k < all.n; k++) {
      found += triangle[all.hit[k].a].polygon == triangle[all.hit[k].b].polygon;
    }
    CHECK("what lies in a face", are_all(&all, n, false));
    CHECK("what does that is changed, too", are_all(&some, n, true));
    free(all.hit);
    free(some.hit);
  }
  CHECK("some does", found > 100);
  in_faces = false;
}

/* ---- how much is asked ---- */

static void
place(sg_fan_triangle *t, int k, double x, double y, double z, uint32_t name)
{
  t->at[k][0] = x;
  t->at[k][1] = y;
  t->at[k][2] = z;
  t->name[k] = name;
}

/* Rectangles on one edge, each of two triangles. */
static void
make_book(size_t n)
{
  for (uint32_t i = 0; i < n; i++) {
    sg_fan_triangle *t = &triangle[i];
    uint32_t page = i / 2;
    double angle = 6.283185307179586 * page / ((double)n / 2);
    double x = cos(angle), y = sin(angle);

    place(t, 0, 0, 0, 0, 0);
    place(t, 1, x, y, i % 2, 2 + 2 * page + i % 2);
    place(t, 2, i % 2 ? 0 : x, i % 2 ? 0 : y, 1, i % 2 ? 1 : 3 + 2 * page);
    t->polygon = (int32_t)i;
  }
}

/* A face on many corners of a circle, and a triangle down from each edge. */
static void
make_brush(size_t n)
{
  uint32_t corners = (uint32_t)n / 2;

  for (uint32_t i = 0; i < n; i++) {
    sg_fan_triangle *t = &triangle[i];
    uint32_t k = i % corners, next = (k + 1) % corners;
    double a = 6.283185307179586 * k / corners;
    double b = 6.283185307179586 * next / corners;

    place(t, 0, cos(a), sin(a), 1, k);
    place(t, 1, cos(b), sin(b), 1, next);
    if (i < corners && k != 0 && next != 0) {
      place(t, 2, 1, 0, 1, 0);
      t->polygon = -2;
    } else if (i < corners) { /* two of them would have no area */
      for (int c = 0; c < 3; c++) {
        place(t, c, 9 + (c == 1), c == 2, k, 3 * i + (uint32_t)c + MOST);
      }
      t->polygon = (int32_t)i;
    } else {
      place(t, 2, cos(a), sin(a), 0, i);
      t->polygon = (int32_t)i;
    }
  }
}

/* Pyramids on one square, each in the next one: seen from a corner of the
 * square the sides lie in one another, and those across from each other have
 * boxes that meet. */
static void
make_tents(size_t n)
{
  static const double corner[4][2] = {
      {1, 0.25}, {-0.25, 1}, {-1, -0.25}, {0.25, -1}};

  for (uint32_t i = 0; i < n; i++) {
    sg_fan_triangle *t = &triangle[i];
    uint32_t k = i % 4, next = (k + 1) % 4, tent = i / 4;

    place(t, 0, corner[k][0], corner[k][1], 0, k);
    place(t, 1, corner[next][0], corner[next][1], 0, next);
    place(t, 2, 0, 0, 1 + 8.0 * tent / (double)n, 4 + tent);
    t->polygon = (int32_t)i;
  }
}

/* Pages on two edges across from each other: at its corners nothing goes
 * through, farther away much does. */
static void
test_two_books(void)
{
  enum { N = 1200 };

  by_place = false;
  for (uint32_t i = 0; i < N; i++) {
    sg_fan_triangle *t = &triangle[i];
    double side = i % 2, y = 1.5 * i / N;

    place(t, 0, 0, side, 0, 2 * (i % 2));
    place(t, 1, 1, side, 0, 2 * (i % 2) + 1);
    place(t, 2, 0.5 + 0.1 * sin(i), i % 2 ? 1 - y : y, 1 + 0.1 * cos(i), 4 + i);
    t->polygon = (int32_t)i;
  }
  memset(changed, 0, sizeof changed);
  sg_bvh_hits all = joined(N, false);

  CHECK("pages do", all.n > 1000 && all.n < (size_t)N * N / 4);
  CHECK("which pages do", are_all(&all, N, false));
  free(all.hit);
}

enum { SIDES = 12 };

/* Rings in each other, two triangles to a side; off their middle by up to
 * `off`. */
static void
make_rings(size_t n, double off)
{
  for (uint32_t i = 0; i < n; i++) {
    sg_fan_triangle *t = &triangle[i];
    uint32_t ring = i / (2 * SIDES), side = i / 2 % SIDES;
    double x = off * sin(ring * 7.0), y = off * cos(ring * 3.0);

    for (uint32_t k = 0; k < 3; k++) {
      uint32_t outer = i % 2 ? k > 0 : k == 1, next = i % 2 ? k == 2 : k > 0;
      uint32_t corner = (side + next) % SIDES;
      double angle = 0.1 + 6.283185307179586 * corner / SIDES;
      double r = ring + 1 + 0.5 * outer;

      place(t, (int)k, x + r * cos(angle), y + r * sin(angle),
            off * (ring % 3) * cos(angle), (2 * ring + outer) * SIDES + corner);
    }
    t->polygon = (int32_t)i;
  }
}

/* Of rings that are a little askew some go through each other. */
static void
test_rings(void)
{
  enum { N = 50 * 2 * SIDES };

  by_place = false;
  make_rings(N, 1.5);
  memset(changed, 0, sizeof changed);
  sg_bvh_hits all = joined(N, false);

  CHECK("some rings do", all.n > 100);
  CHECK("which rings do", are_all(&all, N, false));
  free(all.hit);
}

enum { BRUSH, BOOK, BOOK_BY_PLACE, TENTS, RINGS, MODELS };

static void
make_model(size_t n, int model)
{
  if (model == TENTS) {
    make_tents(n);
  } else if (model == RINGS) {
    make_rings(n, 0);
  } else if (model != BRUSH) {
    make_book(n);
  } else {
    make_brush(n);
  }
  if (by_place) {
    part_names(n);
  }
}

static long
asked_of(size_t n, int model)
{
  make_model(n, model);
  sg_bvh_hits hits = joined(n, false);

  CHECK("nothing goes through", by_place || hits.n == 0);
  free(hits.hit);
  return atomic_load(&asked);
}

static void
test_growth(void)
{
  for (int model = 0; model < MODELS; model++) {
    by_place = model == BOOK_BY_PLACE;
    long few = asked_of(1024, model), more = asked_of(MOST, model);

    CHECK("some of each", few < 40L * 1024);
    CHECK("of many no more", more < 40L * MOST);
  }
}

/* A cancel that says stop at its k-th question ends the join, with nothing left
 * behind (the leak check sees to that), until it is not asked so often. Kernels
 * that read all triangles ask in between. */
static void
test_stops(void)
{
  enum { N = MOST / 4096 };

  for (int model = 0; model < MODELS; model++) {
    int left = -1, k = 0;

    by_place = model == BOOK_BY_PLACE;
    make_model(MOST, model);
    for (; left < 0; k += 1 + k / 4) {
      const sg_cancel stop = {stop_later, &left};

      left = k;
      cancel = &stop;
      sg_bvh_hits hits = joined(MOST, false);

      free(hits.hit);
    }
    CHECK("asked by each of them", k > 5 * N);
  }
  cancel = NULL;
}

int
main(void)
{
  srand(1988);
  test_same();
  test_in_faces();
  test_two_books();
  test_rings();
  test_growth();
  test_stops();
  return check_report();
}
