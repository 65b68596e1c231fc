/* hide_test.c -- PL-13: what is drawn and what is hidden, where it is known
 * beforehand.
 *
 * covers: bounds, grid, scene_model
 */
#include "rays.h"

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

/* A cancel that says stop when it has been asked often enough. */
static bool
stop_at_zero(void *data)
{
  int *left = data;

  return (*left)-- <= 0;
}

/* True if the picture came out although the cancellation stops after some asks.
 */
static bool
finishes(model *m, int asks)
{
  sg_cancel cancel = {stop_at_zero, &asks};
  bool memory = true, done = false;
  sg_scene_model *seen;
  sg_scene *scene = model_scene(m, &cancel, &seen);
  sg_mask_grid masks = {0};
  sg_drawn_part *part = NULL;
  size_t n;

  if (scene && sg_mask_grid_init(&masks, scene, &cancel, &memory)) {
    done = sg_parts_of(&masks,
                       &(sg_drawing){.which = SG_LINES_ALL, .crease = 30.0},
                       NULL, &cancel, &part, &n, &memory);
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
  return check_report();
}
