/* cut_point_test.c -- points of a penetration: made in every way, found again,
 * named, and without memory at every single allocation. */
#include "join/cut.h"
#include "penetration/cut_point.h"
#include "tests/check.h"
#include "tests/memory/refusals.h"

#include <string.h>

/* ---- triangles through one point ---- */

/* Each triangle is a segment of its own; vertex numbers follow the order. All
 * but the last two hold (1, 1, 1): inside, or on the side of corners 0, 1. */
static const double triangle[][3][3] = {
    {{1, 0, 0}, {1, 4, 0}, {1, 0, 4}},  /* 0: x = 1 */
    {{0, 1, 0}, {0, 1, 4}, {4, 1, 0}},  /* 1: y = 1 */
    {{0, 0, 1}, {4, 0, 1}, {0, 4, 1}},  /* 2: z = 1 */
    {{0, 0, 0}, {2, 2, 2}, {5, 0, 0}},  /* 3: its side 0 is a diagonal */
    {{1, 1, -1}, {1, 1, 3}, {9, 9, 0}}, /* 4: side 0 along z */
    {{1, -1, 1}, {1, 3, 1}, {9, 9, 9}}, /* 5: side 0 along y */
    {{-1, 1, 1}, {3, 1, 1}, {7, 9, 9}}, /* 6: side 0 along x */
    {{1, 1, 1}, {8, 9, 7}, {7, 7, 9}},  /* 7: corner 0 is there */
    {{0, 0, 3}, {4, 0, 3}, {0, 4, 3}},  /* 8: z = 3 */
    {{2, 0, 3}, {2, 4, 3}, {2, 0, 7}},  /* 9: side 0 along y, elsewhere */
};

enum { TRIANGLES = sizeof triangle / sizeof triangle[0] };

static bool
load(sg_cut_model *model)
{
  bool good = true, known = true;

  sg_cut_model_init(model);
  for (int i = 0; i < TRIANGLES; i++) {
    int32_t s = i + 1;

    for (int k = 0; k < 3; k++) {
      good = good && sg_cut_model_vertex(model, s, k + 1, triangle[i][k]);
    }
    good = good &&
           sg_cut_model_triangle(model, s, 1, 1, (int32_t[]){1, 2, 3}, &known);
  }
  return good && known;
}

static sg_place
face_of(const sg_cut_model *model, uint32_t i)
{
  return sg_place_of(model, i, SG_FACE);
}

static sg_place
side_of(const sg_cut_model *model, uint32_t i)
{
  return sg_place_of(model, i, SG_EDGE_0);
}

static bool
is_at(const sg_cut_points *points, uint32_t point, double x, double y, double z)
{
  const double *p = point < points->n ? points->point[point].at.p : NULL;

  return p && p[0] == x && p[1] == y && p[2] == z;
}

static void
test_places(void)
{
  sg_cut_model model;
  sg_place place;

  CHECK("loaded", load(&model));
  for (int f = SG_CORNER_0; f <= SG_CORNER_2; f++) {
    place = sg_place_of(&model, 4, f);
    CHECK("a corner", place.kind == SG_AT_VERTEX &&
                          model.vertex[place.a].v == f + 1 &&
                          sg_place_segment(&model, &place) == 5);
  }
  for (int f = SG_EDGE_0; f <= SG_EDGE_2; f++) {
    place = sg_place_of(&model, 4, f);
    int32_t v = model.vertex[place.a].v, w = model.vertex[place.b].v;
    int opposite = (f - SG_EDGE_0 + 2) % 3 + 1;
    CHECK("a side, not its opposite corner",
          place.kind == SG_ON_EDGE && v + w == 6 - opposite);
    CHECK("its ends in order",
          place.a < place.b && sg_place_segment(&model, &place) == 5);
  }
  place = face_of(&model, 4);
  CHECK("the inside", place.kind == SG_ON_FACE && place.a == 4 &&
                          sg_place_segment(&model, &place) == 5);
  sg_cut_model_clear(&model);
}

/* Ways to make (1, 1, 1); how many there are is returned. */
static int
ways(const sg_cut_model *m, sg_made made[])
{
  sg_place x = face_of(m, 0), y = face_of(m, 1), z = face_of(m, 2),
           diagonal = side_of(m, 3), up = side_of(m, 4), back = side_of(m, 5),
           right = side_of(m, 6), corner = sg_place_of(m, 7, SG_CORNER_0);
  const sg_made all[] = {
      {3, {x, y, z}},      {3, {z, x, y}},
      {2, {diagonal, x}},  {2, {y, diagonal}},
      {2, {up, z}},        {2, {diagonal, up}},
      {2, {up, back}},     {2, {up, right}},
      {2, {back, right}},  {2, {right, diagonal}},
      {1, {corner}},       {2, {corner, x}},
      {2, {z, corner}},    {2, {up, corner}},
      {3, {x, y, corner}}, {2, {back, sg_place_of(m, 6, SG_EDGE_0)}},
      {2, {up, diagonal}},
  };

  memcpy(made, all, sizeof all);
  return sizeof all / sizeof all[0];
}

enum { MOST_WAYS = 32 };

/* Whichever way comes first: it is one point, known in each segment. */
static void
test_one_point(void)
{
  sg_cut_model model;
  sg_made made[MOST_WAYS];

  CHECK("loaded", load(&model));
  int n = ways(&model, made);
  for (int first = 0; first < n; first++) {
    sg_cut_points points;
    size_t bad = 0;
    sg_cut_points_init(&points, &model);
    for (int i = 0; i < 2 * n; i++) {
      bad += sg_cut_points_find(&points, &made[(first + i) % n]) != 0;
    }
    CHECK("one point", bad == 0 && points.n == 1 && is_at(&points, 0, 1, 1, 1));
    CHECK("a seat for each place, once",
          points.seats == 8 && points.point[0].seats == 8);
    CHECK("named where it is a corner", sg_cut_points_name(&points, 0, 8) == 1);
    CHECK("the name is its own", sg_cut_points_named(&points, 8, 1) == 0);
    CHECK("no name elsewhere", sg_cut_points_name(&points, 0, 4) == 0 &&
                                   sg_cut_points_name(&points, 0, 99) == 0);
    CHECK("nor of another vertex",
          sg_cut_points_named(&points, 8, 2) == SG_NO_KEY);
    sg_cut_points_clear(&points);
  }
  sg_cut_model_clear(&model);
}

/* What does not meet in one point gives none, and leaves nothing behind. */
static void
test_no_point(void)
{
  sg_cut_model model;
  sg_cut_points points;

  CHECK("loaded", load(&model));
  sg_place x = face_of(&model, 0), z = face_of(&model, 2),
           above = face_of(&model, 8), up = side_of(&model, 4),
           back = side_of(&model, 5), aside = side_of(&model, 9);
  const sg_made made[] = {
      {3, {x, z, above}}, /* two parallel planes */
      {3, {x, x, z}},     /* one plane twice */
      {2, {x, up}},       /* a side in the plane */
      {2, {back, z}},     /* the same, the other way round */
      {2, {aside, back}}, /* parallel sides */
      {2, {x, z}},        /* two planes: a line */
  };
  sg_cut_points_init(&points, &model);
  for (size_t i = 0; i < sizeof made / sizeof made[0]; i++) {
    CHECK("no single point",
          sg_cut_points_find(&points, &made[i]) == SG_NO_KEY);
  }
  CHECK("none is kept", points.n == 0 && points.seats == 0);
  sg_cut_points_clear(&points);
  sg_cut_model_clear(&model);
}

/* ---- points that look the same ---- */

static void
test_same_doubles(void)
{
  enum { POINTS = 100 };
  const sg_made none = {0};
  sg_cut_points points;
  size_t bad = 0;
  mpq_t q, step;

  mpq_inits(q, step, NULL);
  sg_cut_points_init(&points, NULL);
  mpq_set_ui(step, 1, 1);
  mpq_div_2exp(step, step, 200);
  for (uint32_t turn = 0; turn < 2; turn++) {
    mpq_set_ui(q, 1, 3);
    for (uint32_t i = 0; i < POINTS; i++) {
      sg_point at;
      bad += !sg_point_set_q(&at, q, step, q);
      bad += sg_cut_points_at(&points, &at, &none) != i;
      bad += points.point[i].at.p[0] != points.point[0].at.p[0];
      sg_point_clear(&at);
      mpq_add(q, q, step);
    }
  }
  CHECK("equal doubles, other rationals: other points",
        bad == 0 && points.n == POINTS);
  CHECK("without a segment", points.seats == 0 && points.point[0].seats == 0);
  sg_cut_points_clear(&points);
  CHECK("cleared: as new", points.n == 0 && !points.point && !points.seat);
  mpq_clears(q, step, NULL);
}

/* ---- names ---- */

static uint64_t seed = 20261122;

static uint32_t
below(uint32_t n)
{
  seed = seed * 6364136223846793005u + 1442695040888963407u;
  return (uint32_t)(seed >> 33) % n;
}

/* Two names of three are good, or none is: by `data`. */
static bool
is_good(const void *data, int32_t v)
{
  return v % 3 != *(const int *)data && *(const int *)data < 3;
}

enum { SEGMENTS = 3, NAMES = 12 };

/* The smallest of the names given so far in segment s, only good ones if
 * `rest` says so; 0: none. */
static int32_t
smallest(bool given[SEGMENTS + 1][NAMES + 1], int32_t s, const int *rest)
{
  for (int32_t v = 1; v <= NAMES; v++) {
    if (given[s][v] && (!rest || is_good(rest, v))) {
      return v;
    }
  }
  return 0;
}

/* How many answers differ from what a look through all names gives. */
static size_t
wrong_names(const sg_cut_points *points, bool given[SEGMENTS + 1][NAMES + 1])
{
  size_t bad = 0;

  for (int32_t s = 1; s <= SEGMENTS; s++) {
    int32_t least = smallest(given, s, NULL);
    bad += sg_cut_points_name(points, 0, s) != least;
    for (int rest = 0; rest <= 3; rest++) {
      int32_t good = smallest(given, s, &rest);
      bad += sg_cut_points_good_name(points, 0, s, is_good, &rest) !=
             (good ? good : least);
    }
    for (int32_t v = 1; v <= NAMES; v++) {
      bad += sg_cut_points_named(points, s, v) != (given[s][v] ? 0 : SG_NO_KEY);
    }
  }
  return bad;
}

/* One seat more of point 0, at random: a vertex there, a side through it, or a
 * name alone. */
static bool
seat_one(sg_cut_points *points, bool given[SEGMENTS + 1][NAMES + 1])
{
  const sg_cut_model *m = points->model;
  int32_t s = (int32_t)below(SEGMENTS) + 1, v = (int32_t)below(NAMES) + 1;
  uint32_t vertex = sg_cut_model_find(m, s, v),
           far = sg_cut_model_find(m, 9, 1 + (int32_t)below(2));
  sg_made made = {1, {{SG_AT_VERTEX, vertex, 0}}};

  if (below(4) == 0) {
    made.n = 2;
    made.place[1] = (sg_place){SG_ON_EDGE, vertex, far};
  } else if (below(4) == 0 && points->n > 0 && !given[s][v]) {
    given[s][v] = true;
    return sg_cut_points_set_name(points, 0, s, v);
  }
  given[s][v] = true;
  return sg_cut_points_find(points, &made) == 0;
}

/* Points with few seats and many: the same answers. */
static void
test_names(void)
{
  sg_cut_model model;
  size_t bad = 0;
  bool good = true;

  sg_cut_model_init(&model);
  for (int32_t s = 1; s <= SEGMENTS; s++) {
    for (int32_t v = 1; v <= NAMES; v++) {
      good = good && sg_cut_model_vertex(&model, s, v, (double[]){3, 1, 2});
    }
  }
  good = good && sg_cut_model_vertex(&model, 9, 1, (double[]){0, 0, 0}) &&
         sg_cut_model_vertex(&model, 9, 2, (double[]){0, 9, 0});
  CHECK("loaded", good);
  for (int round = 0; round < 200; round++) {
    bool given[SEGMENTS + 1][NAMES + 1] = {{false}};
    sg_cut_points points;
    sg_cut_points_init(&points, &model);
    for (int i = 0; i < 24; i++) {
      good = good && seat_one(&points, given);
      bad += wrong_names(&points, given);
    }
    good = good && points.n == 1;
    sg_cut_points_clear(&points);
  }
  CHECK("one point", good);
  CHECK("its names, however many seats", bad == 0);
  sg_cut_model_clear(&model);
}

/* ---- edges, segments by themselves ---- */

static bool
seat_is_on_edge(const sg_cut_points *points, const sg_place *place)
{
  for (size_t i = 0; i < points->seats; i++) {
    if (memcmp(&points->seat[i].place, place, sizeof *place) == 0) {
      return points->seat[i].edge;
    }
  }
  return false;
}

static void
test_edges(void)
{
  sg_cut_model model;
  sg_cut_points points;

  CHECK("loaded", load(&model));
  sg_place up = side_of(&model, 4), back = side_of(&model, 5),
           z = face_of(&model, 2), far = side_of(&model, 9),
           same_start = {SG_ON_EDGE, up.a, up.b + 1};
  sg_cut_points_init(&points, &model);
  CHECK("made",
        sg_cut_points_find(&points, &(sg_made){2, {up, z}}) == 0 &&
            sg_cut_points_find(&points, &(sg_made){2, {up, back}}) == 0);
  sg_cut_points_on_edge(&points, 0, &far);
  sg_cut_points_on_edge(&points, 0, &same_start);
  CHECK("a side that does not hold it",
        !seat_is_on_edge(&points, &up) && !seat_is_on_edge(&points, &back));
  sg_cut_points_on_edge(&points, 0, &up);
  CHECK("the side it divides, no other", seat_is_on_edge(&points, &up) &&
                                             !seat_is_on_edge(&points, &back) &&
                                             !seat_is_on_edge(&points, &z));
  CHECK("none by itself", !sg_cut_points_is_by_itself(&points, 5));
  CHECK("one is", sg_cut_points_set_by_itself(&points, 5) &&
                      sg_cut_points_is_by_itself(&points, 5) &&
                      !sg_cut_points_is_by_itself(&points, 4));
  sg_cut_points_clear(&points);
  CHECK("cleared: none", !sg_cut_points_is_by_itself(&points, 5));
  sg_cut_model_clear(&model);
}

/* ---- without memory ---- */

/* Points on a grid of exact numbers, and the point of all ways, with its many
 * names. False: something was refused. */
static bool
make_all(sg_cut_points *points, const sg_made made[], int n)
{
  const sg_made none = {0};

  if (!sg_cut_points_set_by_itself(points, 1)) {
    return false;
  }
  for (int i = 0; i < n; i++) {
    if (sg_cut_points_find(points, &made[i]) != 0) {
      return false;
    }
  }
  for (int32_t v = 1; v <= 150; v++) {
    sg_point at;
    sg_point_set(&at, (double[3]){v, 2, 3});
    if (!sg_cut_points_set_name(points, 0, 20 + v % 5, v) ||
        sg_cut_points_at(points, &at, &none) != (uint32_t)v) {
      return false;
    }
  }
  return true;
}

static void
test_no_memory(void)
{
  enum { MOST = 10000 };
  sg_cut_model model;
  sg_made made[MOST_WAYS];
  long n = 0, bad = 0;
  bool done = false;

  if (!is_counted()) {
    printf("skipped: allocations that fail: the checker has its own\n");
    return;
  }
  CHECK("loaded", load(&model));
  int of = ways(&model, made);
  for (; n < MOST && !done; n++) {
    sg_cut_points points;
    living = 0;
    left = n;
    counting = true;
    sg_cut_points_init(&points, &model);
    done = make_all(&points, made, of);
    bad += done != (left >= 0); /* refused exactly where it says so */
    left = -1;
    bad += done && sg_cut_points_name(&points, 0, 22) != 2;
    sg_cut_points_clear(&points);
    counting = false;
    bad += living != 0;
  }
  CHECK("a refused allocation is told and nothing leaks", bad == 0);
  CHECK("there were many", n > 15 && done);
  sg_cut_model_clear(&model);
}

/* Corners that were not added, of a model that fetches none. */
static void
test_unknown(void)
{
  const int32_t v[3] = {1, 2, 3};
  const double at[3] = {0, 0, 0};
  sg_cut_model model;
  bool face = true, line = true;

  sg_cut_model_init(&model);
  CHECK("unknown corners",
        sg_cut_model_vertex(&model, 1, 1, at) &&
            sg_cut_model_triangle(&model, 1, 1, 1, v, &face) && !face &&
            sg_cut_model_edge(&model, 1, 1, v, &line) && !line &&
            model.triangles == 0 && model.edges == 0);
  CHECK("unknown vertex", sg_cut_model_fetch(&model, 1, 1) == 0 &&
                              sg_cut_model_fetch(&model, 1, 2) == SG_NO_KEY);
  sg_cut_model_clear(&model);
}

int
main(void)
{
  spare_gmp();
  test_places();
  test_one_point();
  test_no_point();
  test_same_doubles();
  test_names();
  test_edges();
  test_unknown();
  test_no_memory();
  return check_report();
}
