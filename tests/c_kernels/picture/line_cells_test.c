/* line_cells_test.c -- a scene of the lines of a drawing alone, and of the
 * triangles near them, shows what one of all lines and triangles shows.
 *
 * covers: line_role
 */
#include "picture.h"
#include "picture/line_cells.h"

static double
uniform(double low, double high)
{
  return low + (high - low) * rand() / RAND_MAX;
}

static double
waves(double x, double y)
{
  return 0.4 * sin(3 * x) * cos(2 * y);
}

/* Wavy sheets of many triangles, whose lines are mostly not drawn, and boxes
 * and needles before, behind and in them. */
static void
random_model(model *m, unsigned seed)
{
  bool even = seed % 3 == 0; /* sides lie on one another in the picture */

  srand(seed);
  model_sheet(m, 50, waves);
  for (int i = 0; i < 4; i++) {
    double x = even ? rand() % 5 - 2 : uniform(-2, 2);
    double y = even ? rand() % 5 - 2 : uniform(-2, 2);
    model_box(m, x, y, even ? rand() % 3 - 1 : uniform(-2, 2), 1, 1, 0.5);
  }
  model_segment(m, false);
  for (int i = 0; i < 5; i++) {
    int32_t v[3] = {model_vertex(m, uniform(-3, 3), uniform(-3, 3), 1),
                    model_vertex(m, uniform(-3, 3), uniform(-3, 3), -1),
                    model_vertex(m, uniform(-3, 3), uniform(-3, 3), 0)};
    model_polygon(m, 3, v);
  }
  if (even) {
    model_project(m, 90 * (rand() % 4), 90 * (rand() % 3), 9, false);
  } else {
    model_project(m, uniform(0, 360), uniform(0, 180), 9, seed % 2);
  }
}

static bool
same_part(const picture *p, const picture *q, size_t i)
{
  const sg_drawn_part *a = &p->part[i], *b = &q->part[i];
  const sg_scene_line *l = &p->scene->line[a->line];
  const sg_scene_line *k = &q->scene->line[b->line];

  return l->s == k->s && l->e == k->e && a->from == b->from && a->to == b->to &&
         a->hidden == b->hidden && a->role == b->role;
}

static bool
same_picture(const picture *p, const picture *q)
{
  for (size_t i = 0; i < p->parts; i++) {
    if (i >= q->parts || !same_part(p, q, i)) {
      return false;
    }
  }
  return p->parts == q->parts;
}

static size_t masks, left, lines, drawn, hidden;

/* Whether both scenes of a model show the same. */
static bool
shows_the_same(unsigned seed)
{
  const sg_lines_drawn only = {SG_LINES_FEATURE, 30.0};
  model *m = model_new();
  picture all, some;

  random_model(m, seed);
  picture_open(&all, m, SG_LINES_FEATURE);
  picture_open_of(&some, m, &only, SG_LINES_FEATURE);
  bool same = same_picture(&all, &some);

  masks += all.scene->masks;
  left += some.scene->masks;
  lines += all.scene->lines;
  drawn += some.scene->lines;
  hidden += drawn_count(&some, true);
  picture_close(&all);
  picture_close(&some);
  free(m);
  return same;
}

static void
random_models(void)
{
  unsigned wrong = 0;

  for (unsigned seed = 1; seed <= 60; seed++) {
    if (!shows_the_same(seed)) {
      fprintf(stderr, "model %u\n", seed);
      wrong++;
    }
  }
  CHECK("the same is drawn", wrong == 0);
  CHECK("many parts are hidden", hidden > 1000);
  CHECK("lines that are not drawn are not there", 4 * drawn < lines);
  CHECK("nor are triangles that no line is near", 3 * left < 2 * masks);
}

/* Whether something that large is near the one line of a picture. */
static bool
is_near(const sg_line_cells *cells, double x, double y, double half)
{
  const sg_grid_box box = {{x - half, y - half}, {x + half, y + half}};

  return sg_line_cells_near(cells, &box);
}

static void
one_line(void)
{
  double at[2][3] = {{-1, -1, 0}, {1, 1, 0}};
  sg_scene_line line = {.a = 0, .b = 1};
  sg_scene scene = {.at = at, .line = &line, .lines = 1, .close = 1e-9};
  sg_line_cells cells;

  sg_line_cells_init(&cells, &scene);
  CHECK("on the line", is_near(&cells, 0.3, 0.3, 1e-3));
  CHECK("across it", is_near(&cells, 0.4, -0.4, 0.5));
  CHECK("close to it", is_near(&cells, 0.5, 0.5 + 1e-3 + 1e-9, 1e-3));
  CHECK("far from it", !is_near(&cells, 0.3, -0.3, 0.2));
  CHECK("beyond the picture", is_near(&cells, 1.5, 1.5, 0.1));
  scene.lines = 0;
  sg_line_cells_init(&cells, &scene);
  CHECK("no line", !is_near(&cells, 0.3, 0.3, 0.1));
}

int
main(void)
{
  one_line();
  random_models();
  return check_report();
}
