/* cut_set_test.c -- the pieces of two boxes, and what happens to them. */
#include "tests/check.h"
#include "tests/stop_later.h"

#include "penetration/cut_set.h"

#include <string.h>

/* Every edge between consecutive corners of a polygon is real; the box's
 * polygons are quads of two triangles, whose chord is not. */
static const int32_t quad[6][4] = {{1, 4, 3, 2}, {5, 6, 7, 8}, {1, 2, 6, 5},
                                   {2, 3, 7, 6}, {3, 4, 8, 7}, {4, 1, 5, 8}};

static bool
is_side(const int32_t q[4], int32_t v1, int32_t v2)
{
  for (int i = 0; i < 4; i++) {
    int32_t a = q[i], b = q[(i + 1) % 4];
    if ((a == v1 && b == v2) || (a == v2 && b == v1)) {
      return true;
    }
  }
  return false;
}

/* The set under test: the callback is told of triangles by number. */
static const sg_cut_set *tested;

static int
is_real(void *data, uint32_t triangle, int edge)
{
  const uint32_t *v = tested->model.triangle[triangle].v;
  const sg_leaf_vertex *vertex = tested->model.vertex;

  (void)data;
  for (int i = 0; i < 6; i++) {
    if (is_side(quad[i], vertex[v[edge]].v, vertex[v[(edge + 1) % 3]].v)) {
      return true;
    }
  }
  return false;
}

static bool
add_box(sg_cut_set *set, int32_t s, const double at[3], double size)
{
  static const int corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                   {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  bool good = true, known = true;

  for (int i = 0; i < 8; i++) {
    double p[3];
    for (int c = 0; c < 3; c++) {
      p[c] = at[c] + size * corner[i][c];
    }
    good = good && sg_cut_model_vertex(&set->model, s, i + 1, p);
  }
  for (int32_t i = 0; i < 6; i++) {
    const int32_t *q = quad[i];
    int32_t t[2][3] = {{q[0], q[1], q[2]}, {q[2], q[3], q[0]}};
    for (int k = 0; k < 2; k++) {
      good = good && known &&
             sg_cut_model_triangle(&set->model, s, i + 1, 2 * i + k + 1, t[k],
                                   &known);
    }
  }
  return good && known;
}

/* Two boxes of size 2, the second at `at`, all their cuts entered. */
static bool
enter_boxes(sg_cut_set *set, const double at[3])
{
  sg_cut_set_init(set, is_real, NULL);
  tested = set;
  if (!add_box(set, 1, (double[3]){0, 0, 0}, 2) || !add_box(set, 2, at, 2)) {
    return false;
  }
  for (uint32_t i = 0; i < 12; i++) {
    for (uint32_t j = 12; j < 24; j++) {
      if (sg_cut_set_enter(set, i, j) < 0) {
        return false;
      }
    }
  }
  return true;
}

/* The same, and sealed. */
static bool
two_boxes(sg_cut_set *set, const double at[3])
{
  return enter_boxes(set, at) && sg_cut_set_seal(set, NULL) &&
         sg_cut_set_link(set, NULL);
}

/* Every end of a piece has an even number of pieces: the lines are closed. */
static bool
is_closed(const sg_cut_set *set)
{
  for (size_t i = 0; i < set->points.n; i++) {
    if (set->degree[i] % 2 != 0) {
      return false;
    }
  }
  return true;
}

static size_t
living(const sg_cut_set *set)
{
  size_t n = 0;

  for (size_t i = 0; i < set->pieces; i++) {
    n += set->piece[i].live;
  }
  return n;
}

/* Joins all joints; what is left. */
static size_t
joined(sg_cut_set *set)
{
  uint32_t k, l;

  for (uint32_t i = 0; i < set->points.n; i++) {
    if (sg_cut_set_joint(set, i, &k, &l)) {
      sg_cut_set_join(set, i);
    }
  }
  return living(set);
}

static void
corner_in(void)
{
  sg_cut_set set;

  CHECK("corner in", two_boxes(&set, (double[3]){1, 1, 1}));
  CHECK("corner in: closed", is_closed(&set));
  CHECK("corner in: a line of six", joined(&set) == 6);
  CHECK("corner in: polygons",
        sg_cut_set_group(&set, NULL) && set.polygons == 6);
  sg_cut_set_clear(&set);
}

/* The quads' chords leave points on lines and on edges; they are forgotten. */
static void
settled(void)
{
  sg_cut_set set;
  size_t on_edges = 0;

  CHECK("settled", two_boxes(&set, (double[3]){1, 0, 0}));
  CHECK("settled: twelve edges", joined(&set) == 12);
  CHECK("settled: done", sg_cut_set_settle(&set, NULL));
  CHECK("settled: only the living", set.pieces == 12 && living(&set) == 12);
  CHECK("settled: nothing to join", joined(&set) == 12);
  for (size_t i = 0; i < set.edges; i++) {
    on_edges += set.edge[i].n;
  }
  CHECK("settled: an end of a line on each edge that is split", on_edges == 8);
  sg_cut_set_clear(&set);
}

/* Each step asks; one that is stopped leaves what can be cleared. */
static void
stopped(void)
{
  int left = -1, k = 0;

  for (; left < 0 && k < 1000; k++) {
    sg_cancel cancel = {stop_later, &left};
    sg_cut_set set;

    left = k;
    CHECK("stopped: boxes", enter_boxes(&set, (double[3]){1, 1, 1}));
    bool good =
        sg_cut_set_seal(&set, &cancel) && sg_cut_set_link(&set, &cancel) &&
        sg_cut_set_settle(&set, &cancel) && sg_cut_set_agree(&set, &cancel) &&
        sg_cut_set_group(&set, &cancel);

    CHECK("stopped, or done", good == (left >= 0));
    CHECK("done as ever", !good || set.polygons == 6);
    sg_cut_set_clear(&set);
  }
  CHECK("stopped: each asks", k > 10 && k < 1000);
}

static void
face_on_face(void)
{
  sg_cut_set set;

  CHECK("same face", two_boxes(&set, (double[3]){2, 0, 0}));
  CHECK("same face: its four edges", joined(&set) == 4);
  CHECK("same face: nothing enters",
        sg_cut_set_group(&set, NULL) && set.polygons == 0);
  sg_cut_set_clear(&set);
}

static void
identical(void)
{
  sg_cut_set set;

  CHECK("identical", two_boxes(&set, (double[3]){0, 0, 0}));
  CHECK("identical: twelve edges", living(&set) == 12);
  sg_cut_set_clear(&set);
}

static void
only_a_corner(void)
{
  sg_cut_set set;

  CHECK("a corner", two_boxes(&set, (double[3]){2, 2, 2}));
  CHECK("a corner: no line", living(&set) == 0 && set.edges == 0);
  sg_cut_set_clear(&set);
}

static uint32_t
vertex_point(sg_cut_set *set, int32_t s, int32_t v)
{
  sg_made made = {1, {{SG_AT_VERTEX, sg_cut_model_find(&set->model, s, v), 0}}};

  return sg_cut_points_find(&set->points, &made);
}

/* Points noted in any order divide a piece at all of them. */
static bool
has_piece(const sg_cut_set *set, uint32_t a, uint32_t b)
{
  for (uint32_t i = 0; i < set->pieces; i++) {
    const sg_cut_piece *k = &set->piece[i];

    if (k->live && ((k->a == a && k->b == b) || (k->a == b && k->b == a))) {
      return true;
    }
  }
  return false;
}

static void
late_splits(void)
{
  sg_cut_set set;
  uint32_t a, b, x[3];
  size_t before, dead = 0;

  CHECK("splits", two_boxes(&set, (double[3]){1, 0, 2}));
  a = vertex_point(&set, 2, 1); /* (1,0,2) */
  b = vertex_point(&set, 1, 6); /* (2,0,2) */
  before = living(&set);
  for (int i = 0; i < 3; i++) {
    static const double where[3] = {1.5, 1.25, 1.75};
    sg_made none = {0};
    sg_point at;
    sg_point_set(&at, (double[3]){where[i], 0, 2});
    x[i] = sg_cut_points_at(&set.points, &at, &none);
    CHECK("noted", sg_cut_set_split(&set, a, b, x[i]));
  }
  CHECK("noted twice", sg_cut_set_split(&set, b, a, x[1]));
  CHECK("the first one stands", sg_cut_set_between(&set, b, a) == x[0]);
  CHECK("and the others in its halves",
        sg_cut_set_between(&set, a, x[0]) == x[1] &&
            sg_cut_set_between(&set, x[0], b) == x[2]);
  CHECK("agreed", sg_cut_set_agree(&set, NULL));
  for (size_t i = 0; i < set.pieces; i++) {
    dead += !set.piece[i].live;
  }
  CHECK("one piece became four", living(&set) == before + 3 && dead == 3);
  CHECK("found", has_piece(&set, x[1], a));
  sg_cut_set_clear(&set);
}

static bool
is_this(const void *data, int32_t v)
{
  return v == *(const int32_t *)data;
}

typedef struct asking {
  size_t asked;
  int32_t from;
} asking;

static bool
is_from(const void *data, int32_t v)
{
  asking *a = (asking *)data;

  a->asked++;
  return v >= a->from;
}

/* Many vertices in one place: no name is asked about twice. */
static void
many_names(void)
{
  enum { MANY = 20000 };
  sg_cut_set set;
  uint32_t p = SG_NO_KEY;
  asking a = {0, MANY - 1};
  int32_t none = MANY + 1;
  bool good = true;

  CHECK("points", two_boxes(&set, (double[3]){0, 0, 0}));
  for (int32_t v = MANY; v > 8 && good; v--) { /* the smallest comes last */
    double at[3] = {0, 0, 0};

    good = sg_cut_model_vertex(&set.model, 1, v, at);
    p = vertex_point(&set, 1, v);
  }
  CHECK("all are one point", good && p == vertex_point(&set, 2, 1));
  CHECK("the first name", sg_cut_points_name(&set.points, p, 1) == 1);
  CHECK("of another segment", sg_cut_points_name(&set.points, p, 2) == 1 &&
                                  sg_cut_points_name(&set.points, p, 3) == 0);
  CHECK("the first good name",
        sg_cut_points_good_name(&set.points, p, 1, is_from, &a) == MANY - 1);
  CHECK("each asked about once at most", a.asked < MANY);
  CHECK("no good name: the first one",
        sg_cut_points_good_name(&set.points, p, 1, is_this, &none) == 1);
  CHECK("a seat each", set.points.point[p].seats == MANY - 8 + 2);
  sg_cut_set_clear(&set);
}

/* A point made in two ways is one, and so are two vertices in one place. */
static void
points(void)
{
  sg_cut_set set;
  /* A lower edge of the first box, the bottom of the second. */
  const int32_t nine = 9;
  sg_made parallel = {2, {{SG_ON_EDGE, 0, 1}, {SG_ON_FACE, 12, 0}}};

  CHECK("apart", two_boxes(&set, (double[3]){1, 1, 1}));
  CHECK("parallel: no point",
        sg_cut_points_find(&set.points, &parallel) == SG_NO_KEY);
  sg_cut_set_clear(&set);
  CHECK("points", two_boxes(&set, (double[3]){0, 0, 0}));
  uint32_t p = vertex_point(&set, 1, 1), q = vertex_point(&set, 2, 1);
  CHECK("one place in two segments", p == q && p != SG_NO_KEY);
  CHECK("its names", sg_cut_points_name(&set.points, p, 1) == 1 &&
                         sg_cut_points_name(&set.points, p, 2) == 1 &&
                         sg_cut_points_name(&set.points, p, 3) == 0);
  CHECK("a new name", sg_cut_points_set_name(&set.points, p, 3, 77) &&
                          sg_cut_points_named(&set.points, 3, 77) == p);
  CHECK("a second vertex there",
        sg_cut_model_vertex(&set.model, 1, 9, (double[3]){0, 0, 0}));
  CHECK("the same point", vertex_point(&set, 1, 9) == p);
  CHECK("with both names",
        sg_cut_points_name(&set.points, p, 1) < 9 &&
            sg_cut_points_good_name(&set.points, p, 1, is_this, &nine) == 9);
  sg_cut_set_clear(&set);
}

int
main(void)
{
  corner_in();
  settled();
  stopped();
  face_on_face();
  identical();
  only_a_corner();
  late_splits();
  points();
  many_names();
  return check_report();
}
