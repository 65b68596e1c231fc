/* scene_test.c -- what a scene takes from its model, and lines that are added
 * to it.
 *
 * covers: scene_facing, scene_standard
 */
#include "model.h"
#include "picture/parts.h"
#include "tests/check.h"

/* The scene of a model with added lines, and a facing or null, from its
 * projection. */
static sg_scene *
scene_turned(const sg_scene_model *seen, const model *m, const bool *shown,
             const sg_scene_added *added, size_t addeds,
             const sg_scene_facing *facing)
{
  double(*screen)[3] = malloc((m->vertices + 1) * sizeof *screen);
  sg_scene_input in = {.model = seen,
                       .screen = (const double(*)[3])screen,
                       .shown = shown,
                       .added = added,
                       .addeds = addeds,
                       .facing = facing,
                       .facings = facing ? 1 : 0,
                       .depth = m->depth,
                       .tolerance = 1e-9};
  bool memory;
  sg_scene *scene;

  for (size_t i = 0; i < m->vertices; i++) {
    memcpy(screen[i], m->vertex[i].screen, sizeof *screen);
  }
  scene = sg_scene_open(&in, NULL, &memory);
  free(screen);
  return scene;
}

static sg_scene *
scene_with(const sg_scene_model *seen, const model *m, const bool *shown,
           const sg_scene_added *added, size_t addeds)
{
  return scene_turned(seen, m, shown, added, addeds, NULL);
}

/* Whether that part of a line is drawn visible. */
static bool
is_part_visible(const sg_scene *scene, int32_t s, int32_t e, double from,
                double to)
{
  size_t line = sg_scene_find(scene, s, e), n;
  sg_drawn_part *part;
  sg_mask_grid masks;
  sg_drawing all_lines = {.which = SG_LINES_ALL, .crease = 30.0};
  bool memory, visible = false;

  if (!sg_mask_grid_init(&masks, scene, NULL, &memory) ||
      !sg_parts_of(&masks, &all_lines, NULL, NULL, &part, &n, &memory)) {
    abort();
  }
  for (size_t i = 0; i < n; i++) {
    visible |= part[i].line == line && !part[i].hidden &&
               part[i].from == from && part[i].to == to;
  }
  free(part);
  sg_mask_grid_clear(&masks);
  return visible;
}

static bool
is_visible(const sg_scene *scene, int32_t s, int32_t e)
{
  return is_part_visible(scene, s, e, 0.0, 1.0);
}

/* An edge below a triangle; it has a facing, on a surface beside which that
 * triangle is, and which hides a part of it. */
static void
turned_line(void)
{
  model *m = model_new();
  const int32_t above = 0;
  sg_scene_facing facing = {.s = 1,
                            .triangle = 1,
                            .v = {3, 4},
                            .from = 0.25,
                            .to = 0.5,
                            .lies_on = &above,
                            .triangles = 1};
  sg_scene_model *seen;
  sg_scene *scene;

  model_segment(m, false);
  model_vertex(m, -4, -4, 1);
  model_vertex(m, 8, -4, 1);
  model_vertex(m, -4, 8, 1);
  model_vertex(m, 0, 0, 0);
  model_vertex(m, 1, 0, 0);
  model_vertex(m, 0, 1, 0);
  model_polygon(m, 3, (int32_t[]){1, 2, 3});
  model_polygon(m, 3, (int32_t[]){4, 5, 6});
  model_project(m, 270, 0, 9, false);
  seen = model_scene_model(m, NULL);
  scene = scene_with(seen, m, NULL, NULL, 0);
  CHECK("without a facing it is hidden",
        !is_part_visible(scene, 1, 4, 0.0, 0.25) && !is_visible(scene, 1, 4));
  sg_scene_close(scene);
  scene = scene_turned(seen, m, NULL, NULL, 0, &facing);
  CHECK("with it the surface alone hides it",
        is_part_visible(scene, 1, 4, 0.0, 0.25) &&
            is_part_visible(scene, 1, 4, 0.5, 1.0));
  CHECK("other edges are as without", !is_visible(scene, 1, 5));
  sg_scene_close(scene);
  sg_scene_model_close(seen);
  free(m);
}

/* A triangle seen from above, and lines below it. */
static void
added_lines(void)
{
  model *m = model_new();
  sg_scene_added line[2] = {
      {.s = 1, .e = -2, .screen = {{0.2, 0.2, 0.5}, {0.4, 0.2, 0.5}}},
      {.s = 1, .e = -1, .screen = {{0.2, 0.3, 0.5}, {0.4, 0.3, 0.5}}}};
  const int32_t triangle = 0;
  sg_scene_model *seen;
  sg_scene *scene;

  model_segment(m, false);
  model_vertex(m, 0, 0, 0);
  model_vertex(m, 1, 0, 0);
  model_vertex(m, 0, 1, 0);
  model_polygon(m, 3, (int32_t[]){1, 2, 3});
  model_project(m, 270, 0, 9, false);
  seen = model_scene_model(m, NULL);
  line[1].lies_on = &triangle;
  line[1].triangles = 1;
  scene = scene_with(seen, m, NULL, line, 2);
  CHECK("added lines come first, by number",
        scene->lines == 5 && scene->line[0].e == -2 && scene->line[1].e == -1 &&
            scene->line[2].e > 0);
  CHECK("a triangle hides it", !is_visible(scene, 1, -2));
  CHECK("not one that it lies on", is_visible(scene, 1, -1));
  CHECK("edges are as without", is_visible(scene, 1, 1));
  sg_scene_close(scene);
  sg_scene_model_close(seen);
  free(m);
}

/* One model, two eyes, and a vertex that has no place in the picture. */
static void
views(void)
{
  model *m = model_new();
  bool shown[8] = {false, true, true, true, true, true, true, true};
  sg_scene_model *seen;
  sg_scene *scene;
  size_t masks;

  model_box(m, 0, 0, 0, 1, 1, 1);
  seen = model_scene_model(m, NULL);
  CHECK("a box has 12 lines", seen->lines == 12 && seen->solid[0]);
  model_project(m, 270, 90, 9, false);
  scene = scene_with(seen, m, NULL, NULL, 0);
  masks = scene->masks;
  sg_scene_close(scene);
  CHECK("seen squarely, one face hides", masks == 2);
  model_project(m, 300, 60, 9, false);
  scene = scene_with(seen, m, NULL, NULL, 0);
  masks = scene->masks;
  sg_scene_close(scene);
  CHECK("three faces hide", masks == 6);
  scene = scene_with(seen, m, shown, NULL, 0);
  CHECK("no line to a vertex without a place", scene->lines == 9);
  CHECK("and no triangle", scene->masks < 6);
  sg_scene_close(scene);
  sg_scene_model_close(seen);
  free(m);
}

/* Two triangles meet in a penetration line; the one whose copy is the first has
 * no place in the picture. */
static void
copies_without_place(void)
{
  model *m = model_new();
  const bool shown[6] = {false, false, false, true, true, true};
  sg_scene_model *seen;
  sg_scene *scene;
  bool inside = true;

  for (int s = 0; s < 2; s++) {
    model_segment(m, false);
    model_vertex(m, 0, 0, 0);
    model_vertex(m, 1, 0, 0);
    model_vertex(m, 0, s ? 1 : -1, 0);
    model_polygon(m, 3, s ? (int32_t[]){1, 2, 3} : (int32_t[]){2, 1, 3});
  }
  m->cut[0] = (sg_scene_cut){0, 1, -1, -1};
  m->cut[1] = (sg_scene_cut){3, 4, 0, 1};
  m->cuts = 2;
  model_project(m, 270, 0, 9, false);
  for (int i = 0; i < 3; i++) { /* whatever stands there */
    m->vertex[i].screen[0] = 1e6;
  }
  seen = model_scene_model(m, NULL);
  CHECK("both ends of the line are one vertex of both",
        seen->same[3] == seen->same[0] && seen->same[4] == seen->same[1]);
  CHECK("nothing else is",
        seen->same[0] != seen->same[1] && seen->same[2] != seen->same[5] &&
            seen->same[2] != seen->same[0] && seen->same[5] != seen->same[1]);
  scene = scene_with(seen, m, shown, NULL, 0);
  for (size_t i = 0; i < scene->lines; i++) {
    inside &= fabs(scene->at[scene->line[i].a][0]) <= 1.0 &&
              fabs(scene->at[scene->line[i].b][0]) <= 1.0;
  }
  CHECK("two lines and a triangle are left",
        scene->lines == 2 && scene->masks == 1);
  CHECK("they are where the second copy is", inside);
  sg_scene_close(scene);
  sg_scene_model_close(seen);
  free(m);
}

/* What never hides its own edges: a polygon in one plane, and nothing else. */
static void
flat_polygons(void)
{
  model *m = model_new();
  sg_scene_model *seen;

  model_segment(m, false);
  model_vertex(m, 0, 0, 0);
  model_vertex(m, 1, 0, 0);
  model_vertex(m, 1, 1, 1e-9);
  model_vertex(m, 0, 1, 0);
  model_vertex(m, 0, 1, 1e-3);
  model_polygon(m, 4, (int32_t[]){1, 2, 3, 4});
  model_polygon(m, 4, (int32_t[]){1, 2, 3, 5});
  model_polygon(m, 4, (int32_t[]){1, 2, 1, 2});
  seen = model_scene_model(m, NULL);
  CHECK("flat up to rounding", seen->flat[0]);
  CHECK("not flat", !seen->flat[1]);
  CHECK("without area", !seen->flat[2]);
  sg_scene_model_close(seen);
  free(m);
}

/* Nearest first, and in the order of the model where equally near. */
static void
order_of_masks(void)
{
  model *m = model_new();
  bool sorted = true;
  sg_scene_model *seen;
  sg_scene *scene;

  model_segment(m, false);
  srand(1);
  for (int i = 0; i < 500; i++) {
    double x = rand() % 50 - 25, y = rand() % 50, z = (rand() % 41 - 20) / 8.0;
    int32_t a = model_vertex(m, x, y, z);
    int32_t b = model_vertex(m, x + 1, y, z + 0.5);
    int32_t c = model_vertex(m, x, y + 1, z + 1);
    model_polygon(m, 3, (int32_t[]){a, b, c});
  }
  model_project(m, 270, 0, 9, false);
  scene = model_scene(m, NULL, &seen);
  for (size_t i = 1; i < scene->masks; i++) {
    const sg_scene_mask *x = &scene->mask[i - 1], *y = &scene->mask[i];
    sorted &= x->low[2] < y->low[2] ||
              (x->low[2] == y->low[2] && x->triangle < y->triangle);
  }
  CHECK("masks are sorted", sorted && scene->masks == 500);
  sg_scene_close(scene);
  sg_scene_model_close(seen);
  free(m);
}

int
main(void)
{
  added_lines();
  turned_line();
  flat_polygons();
  views();
  copies_without_place();
  order_of_masks();
  return check_report();
}
