/* stand_in_test.c -- a line that stands in is drawn where no other line is near
 * that it runs along, and nothing is near behind it.
 */
#include "model.h"
#include "picture/parts.h"
#include "tests/check.h"

enum { MOST = 8 };

/* The parts of line 1 of a scene in which it stands in. */
typedef struct drawn {
  sg_drawn_part part[MOST];
  size_t n;
} drawn;

static void
draw_first(model *m, drawn *out)
{
  sg_drawing drawing = {.which = SG_LINES_ALL, .crease = 30.0};
  sg_scene_model *seen;
  sg_scene *scene = model_scene(m, NULL, &seen);
  sg_mask_grid masks;
  sg_drawn_part *part;
  size_t n;
  bool memory;

  scene->line[0].look = (sg_look){.faces = 2,
                                  .towards = 1,
                                  .away = 1,
                                  .left = 2,
                                  .substitute_outline = true};
  if (!sg_mask_grid_init(&masks, scene, NULL, &memory) ||
      !sg_parts_of(&masks, &drawing, NULL, NULL, &part, &n, &memory)) {
    abort();
  }
  out->n = 0;
  for (size_t i = 0; i < n && out->n < MOST; i++) {
    if (part[i].line == 0) {
      out->part[out->n++] = part[i];
    }
  }
  free(part);
  sg_mask_grid_clear(&masks);
  sg_scene_close(scene);
  sg_scene_model_close(seen);
}

static bool
is_part(const drawn *d, size_t i, double from, double to)
{
  const sg_drawn_part *part = &d->part[i];

  return !part->hidden && fabs(part->from - from) < 1e-9 &&
         fabs(part->to - to) < 1e-9;
}

/* An edge in the picture, seen from the front: x right, z up. */
static void
line(model *m, double x1, double z1, double x2, double z2)
{
  int32_t a = model_vertex(m, x1, 0, z1), b = model_vertex(m, x2, 0, z2);

  model_edge(m, a, b);
}

/* The picture is 10 wide: what is nearer than 0.025 is near. */
static model *
one_line(void)
{
  model *m = model_new();

  model_segment(m, false);
  line(m, 0, 0, 10, 0);
  return m;
}

static void
beside_lines(void)
{
  model *m = one_line();
  drawn d;

  model_project(m, 270, 90, 99, false);
  draw_first(m, &d);
  CHECK("alone it is drawn", d.n == 1 && is_part(&d, 0, 0, 1));
  line(m, 2, 0.02, 4, 0.02);
  line(m, 5, 0.03, 6, 0.03);
  line(m, 8, -1, 8.5, 1);
  model_project(m, 270, 90, 99, false);
  draw_first(m, &d);
  CHECK("not beside a line that is near; one farther off, or across it, "
        "changes nothing",
        d.n == 2 && is_part(&d, 0, 0, 0.2) && is_part(&d, 1, 0.4, 1));
  line(m, 4.02, -0.02, 7, -0.02);
  model_project(m, 270, 90, 99, false);
  draw_first(m, &d);
  CHECK("what is left between two is too short",
        d.n == 2 && is_part(&d, 0, 0, 0.2) && is_part(&d, 1, 0.7, 1));
  free(m);
}

static void
before_a_face(double behind, size_t parts, const char *name)
{
  model *m = one_line();
  drawn d;

  model_segment(m, false);
  model_vertex(m, 3, behind, -2);
  model_vertex(m, 5, behind, -2);
  model_vertex(m, 5, behind, 2);
  model_vertex(m, 3, behind, 2);
  model_polygon(m, 4, (int32_t[]){1, 2, 3, 4});
  model_project(m, 270, 90, 99, false);
  draw_first(m, &d);
  CHECK(name, d.n == parts);
  if (parts == 2) {
    CHECK("and drawn elsewhere",
          is_part(&d, 0, 0, 0.3) && is_part(&d, 1, 0.5, 1));
  }
  free(m);
}

int
main(void)
{
  beside_lines();
  before_a_face(1.0, 1, "a face far behind it changes nothing");
  before_a_face(0.01, 2, "where one is near behind, the surface goes on");
  before_a_face(-1.0, 2, "what is hidden is not drawn at all");
  return check_report();
}
