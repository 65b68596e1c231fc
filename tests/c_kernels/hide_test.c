/* hide_test.c -- PL-13: what is drawn and what is hidden, against rays cast in
 * the model, and where it is known beforehand.
 */
#include "../../c_kernels/parts.h"
#include "../check.h"
#include "model.h"

/* ---------------------------------------------------------------- pictures */

typedef struct picture {
  sg_scene_model *model;
  sg_scene *scene;
  sg_mask_grid masks;
  sg_part *part;
  size_t parts;
} picture;

static void
picture_open(picture *p, model *m, sg_which which)
{
  bool memory;

  p->scene = model_scene(m, NULL, &p->model);
  if (!p->scene || !sg_mask_grid_init(&p->masks, p->scene, NULL, &memory) ||
      !sg_parts_of(&p->masks, &(sg_drawing){.which = which, .crease = 30.0},
                   NULL, NULL, &p->part, &p->parts, &memory)) {
    abort();
  }
}

static void
picture_close(picture *p)
{
  free(p->part);
  sg_mask_grid_clear(&p->masks);
  sg_scene_close(p->scene);
  sg_scene_model_close(p->model);
}

/* The total length in model units of the parts that are (not) hidden. */
static double
drawn_length(const picture *p, bool hidden)
{
  double sum = 0;

  for (size_t i = 0; i < p->parts; i++) {
    const sg_part *part = &p->part[i];
    if (part->hidden == hidden) {
      sum += (part->to - part->from) * p->scene->scale *
             sg_line_length(p->scene, &p->scene->line[part->line]);
    }
  }
  return sum;
}

static size_t
drawn_count(const picture *p, bool hidden)
{
  size_t n = 0;

  for (size_t i = 0; i < p->parts; i++) {
    n += p->part[i].hidden == hidden;
  }
  return n;
}

static size_t
role_count(const picture *p, sg_role role)
{
  size_t n = 0;

  for (size_t i = 0; i < p->parts; i++) {
    n += p->part[i].role == role;
  }
  return n;
}

/* Length and number of visible and hidden parts are as wanted. */
static bool
draws(model *m, sg_which which, size_t visible, double visible_length,
      size_t hidden, double hidden_length)
{
  picture p;
  bool as_wanted;

  picture_open(&p, m, which);
  as_wanted = drawn_count(&p, false) == visible &&
              drawn_count(&p, true) == hidden &&
              fabs(drawn_length(&p, false) - visible_length) < 1e-9 &&
              fabs(drawn_length(&p, true) - hidden_length) < 1e-9;
  if (!as_wanted) {
    fprintf(stderr, "drawn: %zu visible %.12g, %zu hidden %.12g\n",
            drawn_count(&p, false), drawn_length(&p, false),
            drawn_count(&p, true), drawn_length(&p, true));
  }
  picture_close(&p);
  return as_wanted;
}

/* ------------------------------------------------------------- rays */

/* What a ray from the eye to a point of a line says. */
typedef enum verdict { CLEAR, BLOCKED, UNSURE } verdict;

typedef struct eye {
  long double at[3], forward[3];
  double rho;
  bool central;
} eye;

static eye
eye_of(double theta, double phi, double rho, bool is_central)
{
  long double d = acosl(-1.0L) / 180;
  eye e = {.rho = rho, .central = is_central};
  long double back[3] = {sinl(phi * d) * cosl(theta * d),
                         sinl(phi * d) * sinl(theta * d), cosl(phi * d)};

  for (int k = 0; k < 3; k++) {
    e.at[k] = back[k] * rho;
    e.forward[k] = -back[k];
  }
  return e;
}

static long double
det(const long double a[3], const long double b[3], const long double c[3])
{
  return a[0] * (b[1] * c[2] - b[2] * c[1]) -
         a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/* Does the ray from point p towards the eye meet the triangle? */
static verdict
ray_meets(const eye *e, const long double p[3], const model_corner *a,
          const model_corner *b, const model_corner *c)
{
  const long double close = 1e-6L;
  long double u[3], w[3], r[3], q[3], d, x, y, t;

  for (int k = 0; k < 3; k++) {
    u[k] = b->model[k] - a->model[k];
    w[k] = c->model[k] - a->model[k];
    r[k] = e->central ? p[k] - e->at[k] : e->forward[k];
    q[k] = p[k] - a->model[k];
  }
  d = det(u, w, r);
  if (fabsl(d) < 1e-9L) {
    return UNSURE; /* edge-on: only if it is near, which nobody asks here */
  }
  x = det(q, w, r) / d;
  y = det(u, q, r) / d;
  t = det(u, w, q) / d; /* > 0: between the eye and p */
  if (x < -close || y < -close || x + y > 1 + close || t < -close) {
    return CLEAR;
  }
  return x > close && y > close && x + y < 1 - close && t > close ? BLOCKED
                                                                  : UNSURE;
}

static const model_corner *
vertex_of(const model *m, int32_t s, int32_t v)
{
  for (size_t i = 0; i < m->vertices; i++) {
    if (m->vertex[i].s == s && m->vertex[i].v == v) {
      return &m->vertex[i];
    }
  }
  return NULL;
}

/* True if the line runs between two corners of the triangle. */
static bool
is_side(const model *m, const model_triangle *t, const sg_scene_line *line)
{
  int ends = 0;

  for (int k = 0; k < 3; k++) {
    ends += m->vertex[line->a].v == t->v[k];
    ends += m->vertex[line->b].v == t->v[k];
  }
  return t->s == line->s && ends == 2;
}

static verdict
cast(const model *m, const eye *e, const sg_scene_line *line,
     const long double p[3])
{
  verdict all = CLEAR;

  for (size_t i = 0; i < m->triangles && all != BLOCKED; i++) {
    const model_triangle *t = &m->triangle[i];
    verdict one = CLEAR;
    if (!is_side(m, t, line)) {
      one = ray_meets(e, p, vertex_of(m, t->s, t->v[0]),
                      vertex_of(m, t->s, t->v[1]), vertex_of(m, t->s, t->v[2]));
    }
    all = one == CLEAR ? all : one;
  }
  return all;
}

/* The model point of a line that is at t in the picture. */
static void
point_at(const model *m, const eye *e, const sg_scene_line *line, double t,
         long double out[3])
{
  const model_corner *a = &m->vertex[line->a], *b = &m->vertex[line->b];
  long double za = 0, zb = 0, u = t;

  for (int k = 0; k < 3 && e->central; k++) {
    za += (a->model[k] - e->at[k]) * e->forward[k];
    zb += (b->model[k] - e->at[k]) * e->forward[k];
  }
  if (e->central) {
    u = t * za / ((1 - t) * zb + t * za);
  }
  for (int k = 0; k < 3; k++) {
    out[k] = a->model[k] + u * (b->model[k] - a->model[k]);
  }
}

/* How many samples of the parts the rays call wrong; *sure: how many they
 * could judge. */
static size_t
wrong_samples(const model *m, const picture *p, const eye *e, size_t *sure)
{
  size_t wrong = 0;

  for (size_t i = 0; i < p->parts; i++) {
    const sg_part *part = &p->part[i];
    for (int k = 0; k < 3; k++) {
      double at = part->from + (part->to - part->from) * (0.12 + 0.38 * k);
      long double point[3];
      verdict v;
      point_at(m, e, &p->scene->line[part->line], at, point);
      v = cast(m, e, &p->scene->line[part->line], point);
      *sure += v != UNSURE;
      wrong += v == (part->hidden ? CLEAR : BLOCKED);
    }
  }
  return wrong;
}

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

/* ------------------------------------------------------------- boxes */

static void
one_box(void)
{
  model *m = model_new();
  double third = sqrt(2.0 / 3.0);
  picture p;

  model_box(m, -0.5, -0.5, -0.5, 1, 1, 1);
  model_project(m, 270, 90, 4, false);
  CHECK("a box seen squarely has no hidden line",
        draws(m, SG_LINES_FEATURE, 4, 4, 0, 0));
  CHECK("nor with all lines", draws(m, SG_LINES_ALL, 4, 4, 0, 0));
  model_project(m, 0, 0, 4, false);
  CHECK("from above too", draws(m, SG_LINES_FEATURE, 4, 4, 0, 0));
  model_project(m, 270, 90, 4, true);
  CHECK("seen squarely from near: the back is smaller and all hidden",
        draws(m, SG_LINES_FEATURE, 4, 4, 8,
              4 * 3.5 / 4.5 + 4 * sqrt(2) * (0.5 - 0.5 * 3.5 / 4.5)));
  model_project(m, 315, acos(1 / sqrt(3)) * 180 / acos(-1.0), 4, false);
  CHECK("along the diagonal: a hexagon and its spokes",
        draws(m, SG_LINES_FEATURE, 9, 9 * third, 3, 3 * third));
  model_project(m, 300, 60, 4, false);
  picture_open(&p, m, SG_LINES_ALL);
  CHECK("nine visible, three hidden",
        drawn_count(&p, false) == 9 && drawn_count(&p, true) == 3);
  CHECK("six of them in outline", role_count(&p, SG_OUTLINE) == 6);
  CHECK("six creases", role_count(&p, SG_CREASE) == 6);
  picture_close(&p);
  free(m);
}

/* The boxes of peers/hlr_unfold as they are, not cut: 11.400 of their edges
 * is visible. */
static void
cubes2(void)
{
  model *m = model_new();
  double pi = acos(-1.0);
  picture p;

  model_box(m, 0, 0, 0, 1, 1, 1);
  model_box(m, .5, .4, .3, 1, 1, 1);
  model_project(m, atan2(-2.0, 1.2) * 180 / pi,
                acos(1.1 / sqrt(1.2 * 1.2 + 4 + 1.1 * 1.1)) * 180 / pi, 9,
                false);
  picture_open(&p, m, SG_LINES_FEATURE);
  CHECK("cubes2 raw", fabs(drawn_length(&p, false) - 11.400) < 1e-3);
  picture_close(&p);
  free(m);
}

static void
touching(void)
{
  model *m = model_new(), *n = model_new();

  model_box(m, 0, 0, 0, 1, 1, 1);
  model_box(m, 1, 0, 0, 1, 1, 1);
  model_project(m, 270, 90, 9, false);
  CHECK("two boxes side by side share a line",
        draws(m, SG_LINES_FEATURE, 7, 7, 0, 0));
  model_project(m, 0, 90, 9, false);
  CHECK("one behind the other", draws(m, SG_LINES_FEATURE, 4, 4, 0, 0));
  model_box(n, 0, 0, 0, 2, 2, 1);
  model_box(n, 0.5, 0.5, 1, 1, 1, 1);
  model_project(n, 270, 90, 9, false);
  CHECK("a box on a box", draws(n, SG_LINES_FEATURE, 7, 9, 0, 0));
  model_project(n, 270, 0, 9, false);
  CHECK("seen from above", draws(n, SG_LINES_FEATURE, 8, 12, 0, 0));
  free(m);
  free(n);
}

/* -------------------------------------------------- surfaces and curves */

static double
flat(double x, double y)
{
  return 0 * x * y;
}

static double
wave(double x, double y)
{
  return 0.4 * sin(4 * x) + 0.2 * cos(3 * y);
}

static void
surfaces(void)
{
  model *m = model_new(), *n = model_new();
  picture p;
  size_t sure = 0;
  eye e = eye_of(20, 65, 5, false);

  model_sheet(m, 4, flat);
  model_segment(m, false);
  model_vertex(m, 0.3, 0.4, -1);
  model_vertex(m, 0.3, 0.4, 0);
  model_vertex(m, 0.3, 0.4, 1);
  model_edge(m, 1, 2);
  model_edge(m, 2, 3);
  model_project(m, 270, 30, 5, false);
  picture_open(&p, m, SG_LINES_FEATURE);
  CHECK("a line through a sheet is hidden beyond it",
        drawn_count(&p, true) == 1 &&
            fabs(drawn_length(&p, true) - 0.5) < 1e-9);
  picture_close(&p);
  model_project(m, 270, 150, 5, false);
  picture_open(&p, m, SG_LINES_FEATURE);
  CHECK("from below too", drawn_count(&p, true) == 1);
  CHECK("16 border edges and 2 of the curve",
        role_count(&p, SG_BORDER) == 16 && role_count(&p, SG_CURVE) == 3 - 1);
  picture_close(&p);
  model_project(m, 270, 90, 5, false);
  CHECK("a sheet seen edge-on is a line",
        draws(m, SG_LINES_FEATURE, 6, 4, 0, 0));
  model_sheet(n, 12, wave);
  model_project(n, 20, 65, 5, false);
  picture_open(&p, n, SG_LINES_ALL);
  CHECK("a wave: no ray contradicts", wrong_samples(n, &p, &e, &sure) == 0);
  CHECK("a wave hides itself", drawn_count(&p, true) > 20 && sure > 1000);

  picture_close(&p);
  free(m);
  free(n);
}

/* A curve's edge seen end-on is a point; one behind another is dropped. */
static void
lines_alone(void)
{
  model *m = model_new();

  model_segment(m, false);
  model_vertex(m, 0, 0, 0);
  model_vertex(m, 0, 1, 0);
  model_vertex(m, 1, 1, 0);
  model_vertex(m, 0.25, 3, 0);
  model_vertex(m, 1.5, 3, 0);
  model_edge(m, 1, 2);
  model_edge(m, 2, 3);
  model_edge(m, 4, 5);
  model_project(m, 270, 90, 9, false);
  CHECK("nothing is drawn twice", draws(m, SG_LINES_ALL, 2, 1.5, 0, 0));
  free(m);
}

/* Three sheets at one edge. */
static void
non_manifold(void)
{
  model *m = model_new();
  picture p;

  model_segment(m, false);
  model_vertex(m, 0, 0, 0);
  model_vertex(m, 0, 1, 0);
  model_vertex(m, 1, 0, 0);
  model_vertex(m, -1, 0, 0.1);
  model_vertex(m, -1, 0, -1);
  model_polygon(m, 3, (int32_t[]){1, 3, 2});
  model_polygon(m, 3, (int32_t[]){1, 2, 4});
  model_polygon(m, 3, (int32_t[]){1, 2, 5});
  model_project(m, 280, 20, 9, false);
  picture_open(&p, m, SG_LINES_FEATURE);
  CHECK("three faces at one line", p.scene->line[2].look.faces == 3);
  CHECK("it bends most from the third", p.scene->line[2].look.bend > 80);
  CHECK("one crease among borders",
        role_count(&p, SG_CREASE) == 1 && role_count(&p, SG_BORDER) >= 6);
  picture_close(&p);
  free(m);
}

/* A solid that is open or inside out is drawn from both sides. */
static void
no_solids(void)
{
  static const int32_t five[5][4] = {
      {1, 3, 4, 2}, {1, 2, 6, 5}, {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}};
  model *m = model_new(), *n = model_new();
  double c[8][3];
  picture p;

  model_segment(m, true);
  for (int i = 0; i < 8; i++) {
    model_vertex(m, i & 1, i >> 1 & 1, i >> 2 & 1);
    for (int k = 0; k < 3; k++) {
      c[i][k] = -(i >> k & 1);
    }
  }
  for (int i = 0; i < 5; i++) {
    model_polygon(m, 4, five[i]);
  }
  model_project(m, 300, 45, 9, false);
  picture_open(&p, m, SG_LINES_ALL);
  CHECK("an open box: one looks into it",
        drawn_count(&p, false) == 12 && drawn_count(&p, true) == 2 &&
            role_count(&p, SG_BORDER) == 4 && !p.scene->line[0].look.solid);
  picture_close(&p);
  model_segment(n, true);
  model_hexahedron(n, c);
  model_project(n, 300, 60, 9, false);
  picture_open(&p, n, SG_LINES_ALL);
  CHECK("a box inside out looks like any other",
        drawn_count(&p, false) == 9 && drawn_count(&p, true) == 3);
  picture_close(&p);
  free(m);
  free(n);
}

/* Second copies of a penetration line go; so do pairs without a real edge. */
static void
cuts(void)
{
  model *m = model_new();
  picture p;

  for (int s = 0; s < 2; s++) {
    model_segment(m, false);
    model_vertex(m, 0, 0, 0);
    model_vertex(m, 1, 0, 0);
    model_vertex(m, 0, s ? 1 : -1, 1);
    model_polygon(m, 3, (int32_t[]){1, 2, 3});
  }
  m->cut[0] = (sg_scene_cut){0, 1, -1, -1};
  m->cut[1] = (sg_scene_cut){3, 4, 0, 1};
  m->cuts = 2;
  m->edge[1].real = false;
  model_project(m, 280, 20, 9, false);
  picture_open(&p, m, SG_LINES_FEATURE);
  CHECK("one penetration line", role_count(&p, SG_PENETRATION) == 1);
  CHECK("three borders are real", p.scene->lines == 4);
  picture_close(&p);
  free(m);
}

/* A poll that says stop when it has been asked often enough. */
static bool
stop_at_zero(void *data)
{
  int *left = data;

  return (*left)-- <= 0;
}

/* True if the picture came out although the poll stops after some asks. */
static bool
finishes(model *m, int asks)
{
  sg_poll poll = {stop_at_zero, &asks};
  bool memory = true, done = false;
  sg_scene_model *seen;
  sg_scene *scene = model_scene(m, &poll, &seen);
  sg_mask_grid masks = {0};
  sg_part *part = NULL;
  size_t n;

  if (scene && sg_mask_grid_init(&masks, scene, &poll, &memory)) {
    done = sg_parts_of(&masks,
                       &(sg_drawing){.which = SG_LINES_ALL, .crease = 30.0},
                       NULL, &poll, &part, &n, &memory);
    free(part);
  }
  sg_mask_grid_clear(&masks);
  sg_scene_close(scene);
  sg_scene_model_close(seen);
  return done && memory;
}

/* Stopped at every place where it asks (the sanitizers watch the memory). */
static void
stopping(void)
{
  model *m = model_new();
  int asks = 0;

  model_sheet(m, 40, wave);
  model_project(m, 20, 65, 5, false);
  while (asks < 10000 && !finishes(m, asks)) {
    asks++;
  }
  CHECK("it asks now and then", asks > 20 && asks < 10000);
  free(m);
}

int
main(void)
{
  stopping();
  one_box();
  cubes2();
  touching();
  surfaces();
  lines_alone();
  non_manifold();
  cuts();
  no_solids();
  random_scenes();
  grid_scenes();
  return check_report();
}
