/* tour_test.c -- walks over points against boxes and needles of which it is
 * known, by comparing coordinates, what they go round.
 */
#include "join/tour.h"
#include "tests/check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BODIES = 12, SIDE = 6, POINTS = 40, TRIANGLES = 12 * BODIES };

/* A box, slanted: from the x and y of a corner of the grid something is taken
 * that grows with z. */
typedef struct body {
  double lo[3], hi[3], slant[2];
  int way; /* 1, or -1: inside out */
} body;

typedef struct scene {
  body body[BODIES];
  double corner[TRIANGLES][3][3];
  size_t bodies;
  sg_point point[POINTS];
  mpq_t q[POINTS][3];
  int here, turns[POINTS], arrived[POINTS];
  bool on[POINTS];
} scene;

static void
set_triangles(scene *s, size_t b)
{
  static const int face[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                 {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  const body *at = &s->body[b];

  for (int t = 0; t < 12; t++) {
    int way[3] = {0, t % 2 + 1, t % 2 + 2};

    for (int k = 0; k < 3; k++) {
      int to = at->way > 0 ? k : 2 - k, i = face[t / 2][way[k]];
      double *out = s->corner[12 * b + (size_t)t][to];

      for (int c = 0; c < 3; c++) {
        out[c] = i >> c & 1 ? at->hi[c] : at->lo[c];
      }
      out[0] -= at->slant[0] * out[2];
      out[1] -= at->slant[1] * out[2];
    }
  }
}

static body
random_body(bool needle)
{
  body out = {.way = rand() % 4 ? 1 : -1};

  for (int k = 0; k < 3; k++) {
    int a = rand() % SIDE, b = rand() % (SIDE - 1);

    b += b >= a;
    out.lo[k] = a < b ? a : b;
    out.hi[k] = a < b ? b : a;
  }
  if (needle) {
    out.slant[0] = rand() % 5 - 2;
    out.slant[1] = rand() % 5 - 2;
    out.hi[0] = out.lo[0] + 0.25;
    out.hi[1] = out.lo[1] + 0.25;
  }
  return out;
}

/* On quarters, or beside them by less than a double can say. */
static void
set_point(scene *s, size_t i)
{
  mpq_t beside;

  mpq_init(beside);
  mpq_set_ui(beside, 1, 1);
  mpq_div_2exp(beside, beside, 80);
  for (int k = 0; k < 3; k++) {
    mpq_set_d(s->q[i][k], rand() % (4 * SIDE) / 4.0);
    if (i % 3 == 1) {
      (rand() % 2 ? mpq_add : mpq_sub)(s->q[i][k], s->q[i][k], beside);
    } else if (i % 3 == 2 && rand() % 2) {
      mpq_set_ui(s->q[i][k], (unsigned)rand() % 30, 7);
      mpq_canonicalize(s->q[i][k]);
    }
  }
  sg_point_set_q(&s->point[i], s->q[i][0], s->q[i][1], s->q[i][2]);
  mpq_clear(beside);
}

static void
corners(const void *data, uint32_t t, double out[3][3])
{
  const scene *s = data;

  memcpy(out, s->corner[t], sizeof s->corner[t]);
}

static void
pass(void *data, uint32_t t, int turns)
{
  scene *s = data;

  (void)t;
  s->here += turns;
}

static void
on(void *data, size_t i, uint32_t t)
{
  scene *s = data;

  (void)t;
  s->on[i] = true;
}

static void
arrive(void *data, size_t i)
{
  scene *s = data;

  s->turns[i] = s->here;
  s->arrived[i]++;
}

/* 1 inside, 0 on the border, -1 outside: by the body's own coordinates. */
static int
where(const body *b, mpq_t at[3])
{
  mpq_t x, end;
  int out = 1;

  mpq_init(x);
  mpq_init(end);
  for (int k = 0; k < 3; k++) {
    mpq_set_d(x, k < 2 ? b->slant[k] : 0);
    mpq_mul(x, x, at[2]);
    mpq_add(x, x, at[k]);
    mpq_set_d(end, b->lo[k]);
    int low = mpq_cmp(x, end);
    mpq_set_d(end, b->hi[k]);
    int high = mpq_cmp(end, x);
    int least = low < high ? low : high;
    int sign = (least > 0) - (least < 0);
    out = sign < out ? sign : out;
  }
  mpq_clear(x);
  mpq_clear(end);
  return out;
}

/* Points outside of everything are left out. */
static size_t
choose(const scene *s, const sg_box *all, const sg_point *at[], size_t name[])
{
  size_t n = 0;

  for (size_t i = 0; i < POINTS; i++) {
    bool in = true;

    for (int k = 0; k < 3; k++) {
      in = in && s->point[i].p[k] >= all->lo[k] &&
           s->point[i].p[k] <= all->hi[k];
    }
    if (in) {
      name[n] = i;
      at[n++] = &s->point[i];
    }
  }
  return n;
}

static sg_bvh *
plant(const scene *s, sg_box *all)
{
  sg_box box[TRIANGLES];

  *all = sg_box_none();
  for (size_t t = 0; t < 12 * s->bodies; t++) {
    box[t] = sg_box_none();
    for (int k = 0; k < 3; k++) {
      sg_box_add(&box[t], s->corner[t][k]);
    }
    sg_box_join(all, &box[t]);
  }
  return sg_bvh_open(box, 12 * s->bodies, NULL);
}

static bool
stop(void *data)
{
  (void)data;
  return true;
}

/* How many points are wrong; *inside, *borders: how many there are. */
static int
wrong_points(scene *s, int *inside, int *borders)
{
  const sg_point *at[POINTS];
  size_t name[POINTS];
  sg_box all;
  sg_bvh *tree = plant(s, &all);
  size_t n = choose(s, &all, at, name);
  sg_tour tour = {tree, s, corners, pass, on, arrive};
  int wrong = !sg_tour_over(&tour, at, n, NULL);

  for (size_t i = 0; i < n; i++) {
    int turns = 0;
    bool border = false;

    for (size_t b = 0; b < s->bodies; b++) {
      int is = where(&s->body[b], s->q[name[i]]);

      turns += is > 0 ? s->body[b].way : 0;
      border = border || is == 0;
    }
    wrong += s->arrived[i] != 1 || s->on[i] != border ||
             (!border && s->turns[i] != turns);
    *inside += turns != 0;
    *borders += border;
  }
  sg_bvh_close(tree);
  return wrong;
}

static int
wrong_in_scene(int which, int *inside, int *borders)
{
  scene *s = calloc(1, sizeof *s);
  int wrong;

  s->bodies = 1 + (size_t)rand() % BODIES;
  for (size_t b = 0; b < s->bodies; b++) {
    s->body[b] = random_body(which % 3 == 2);
    set_triangles(s, b);
  }
  for (size_t i = 0; i < POINTS; i++) {
    for (int k = 0; k < 3; k++) {
      mpq_init(s->q[i][k]);
    }
    set_point(s, i);
  }
  wrong = wrong_points(s, inside, borders);
  for (size_t i = 0; i < POINTS; i++) {
    for (int k = 0; k < 3; k++) {
      mpq_clear(s->q[i][k]);
    }
    sg_point_clear(&s->point[i]);
  }
  free(s);
  return wrong;
}

/* Where the walk ends on a border, it is on the side that its shift says. */
static void
test_shift(void)
{
  static const double place[5][3] = {
      {1, 2, 2}, {3, 2, 2}, {2, 1, 2}, {2, 2, 1}, {2, 3, 2}};
  static const int inside[5] = {0, 1, 1, 1, 0};
  scene *s = calloc(1, sizeof *s);
  const sg_point *at[5];
  sg_box all;

  s->bodies = 1;
  s->body[0] = (body){{1, 1, 1}, {3, 3, 3}, {0, 0}, 1};
  set_triangles(s, 0);
  for (int i = 0; i < 5; i++) {
    sg_point_set(&s->point[i], place[i]);
    at[i] = &s->point[i];
  }
  sg_bvh *tree = plant(s, &all);
  sg_tour tour = {tree, s, corners, pass, on, arrive};
  bool right = sg_tour_over(&tour, at, 5, NULL);

  for (int i = 0; i < 5; i++) {
    right = right && s->on[i] && s->turns[i] == inside[i];
  }
  CHECK("shifted towards -x, +y, +z", right);
  CHECK("stopped", !sg_tour_over(&tour, at, 5, &(sg_cancel){stop, NULL}));
  CHECK("no points", sg_tour_over(&tour, at, 0, NULL));
  sg_bvh_close(tree);
  free(s);
}

int
main(void)
{
  int wrong = 0, inside = 0, borders = 0;

  srand(1988);
  for (int i = 0; i < 2000; i++) {
    wrong += wrong_in_scene(i, &inside, &borders);
  }
  CHECK("as coordinates say", wrong == 0);
  CHECK("many inside, many on borders", inside > 5000 && borders > 5000);
  test_shift();
  return check_report();
}
