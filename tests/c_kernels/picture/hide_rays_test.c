/* hide_rays_test.c -- PL-13: what is drawn and what is hidden, against rays
 * cast in the model. */
#include "rays.h"

/* Every line is drawn from end to end, when none lies on another. */
static bool
complete(const picture *p)
{
  size_t i = 0;

  for (size_t k = 0; k < p->scene->lines; k++) {
    double at = 0;
    for (; i < p->parts && p->part[i].line == k; i++) {
      if (p->part[i].from != at) {
        return false;
      }
      at = p->part[i].to;
    }
    if (at != 1.0) {
      return false;
    }
  }
  return i == p->parts;
}

static double
uniform(double low, double high)
{
  return low + (high - low) * rand() / RAND_MAX;
}

static void
random_hexahedron(model *m)
{
  double c[8][3], shift[3], side[3][3];

  for (int k = 0; k < 3; k++) {
    shift[k] = uniform(-1, 1);
    for (int j = 0; j < 3; j++) {
      side[j][k] = uniform(-0.2, 0.2) + (j == k ? uniform(0.2, 1) : 0);
    }
  }
  for (int i = 0; i < 8; i++) {
    for (int k = 0; k < 3; k++) {
      c[i][k] = shift[k] + (i & 1) * side[0][k] + (i >> 1 & 1) * side[1][k] +
                (i >> 2 & 1) * side[2][k];
    }
  }
  model_segment(m, true);
  model_hexahedron(m, c);
}

static void
random_sheet(model *m)
{
  int32_t v[3];

  model_segment(m, false);
  for (int i = 0; i < 3; i++) {
    v[i] = model_vertex(m, uniform(-1, 2), uniform(-1, 2), uniform(-1, 2));
  }
  model_polygon(m, 3, v);
}

static void
random_curve(model *m)
{
  int32_t a, b;

  model_segment(m, false);
  a = model_vertex(m, uniform(-1, 2), uniform(-1, 2), uniform(-1, 2));
  for (int i = 0; i < 3; i++) {
    b = model_vertex(m, uniform(-1, 2), uniform(-1, 2), uniform(-1, 2));
    model_edge(m, a, b);
    a = b;
  }
}

/* Solids, sheets and curves that pass through one another; seeds 1 to 300. */
static void
random_scenes(void)
{
  size_t wrong = 0, sure = 0, samples = 0, partial = 0;

  for (unsigned seed = 1; seed <= 300; seed++) {
    model *m = model_new();
    double theta, phi;
    bool is_central = seed % 2;
    picture p;
    eye e;
    srand(seed);
    theta = uniform(-180, 180);
    phi = uniform(1, 179);
    for (int i = 0; i < 3; i++) {
      random_hexahedron(m);
      random_sheet(m);
      random_curve(m);
    }
    model_project(m, theta, phi, 8, is_central);
    picture_open(&p, m, SG_LINES_ALL);
    e = eye_of(theta, phi, 8, is_central);
    wrong += wrong_samples(m, &p, &e, &sure);
    samples += 3 * p.parts;
    partial += !complete(&p);
    picture_close(&p);
    free(m);
  }
  CHECK("no ray contradicts", wrong == 0);
  CHECK("nearly all samples are judged", sure > samples / 100 * 97);
  CHECK("no part of a line is lost", partial == 0);
  CHECK("there was something to do", samples > 50000);
}

/* Boxes on a small grid, that touch, overlap and hide behind borders; seen
 * along axes, along diagonals and askew. */
static void
grid_scenes(void)
{
  static const double view[][2] = {{270, 90},
                                   {0, 90},
                                   {270, 0},
                                   {315, 90},
                                   {315, 45},
                                   {300, 60},
                                   {315, 54.735610317245346}};
  size_t wrong = 0, sure = 0;

  for (unsigned seed = 1; seed <= 140; seed++) {
    const double *from = view[seed % 7];
    bool is_central = seed % 2;
    model *m = model_new();
    eye e = eye_of(from[0], from[1], 12, is_central);
    picture p;
    srand(seed);
    for (int i = 0; i < 5; i++) {
      model_box(m, rand() % 4 - 2, rand() % 4 - 2, rand() % 4 - 2,
                1 + rand() % 2, 1 + rand() % 2, 1 + rand() % 2);
    }
    model_project(m, from[0], from[1], 12, is_central);
    picture_open(&p, m, SG_LINES_ALL);
    wrong += wrong_samples(m, &p, &e, &sure);
    picture_close(&p);
    free(m);
  }
  CHECK("aligned boxes: no ray contradicts", wrong == 0);
  CHECK("and many can judge", sure > 5000);
}

int
main(void)
{
  random_scenes();
  grid_scenes();
  return check_report();
}
