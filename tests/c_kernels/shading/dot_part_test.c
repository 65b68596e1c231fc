/* dot_part_test.c -- a sphere's dots face by face, the strokes where it is
 * dark, and its depths: against closed forms.
 *
 * covers: tone_stroke, depth_buffer
 */
#include "shaded_sphere.h"

#include "shading/depth_buffer.h"
#include "shading/dot_part.h"
#include "shading/tone_stroke.h"

#include "tests/check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 64 };

static const uint32_t first[] = {0, 0, 1}, of[] = {0};

/* Lit from the eye; all light whatever the tone. */
static void
fill_look(sg_face_look *look)
{
  memset(look, 0, sizeof *look);
  look->tones.ways = 1;
  look->tones.way[0] = (sg_tone_way){{0, 0, 1}, 1, 0};
  for (int k = 0; k <= SG_RAMP + 1; k++) {
    for (int c = 0; c < 3; c++) {
      look->ramp.light[k][c] = 40000;
    }
  }
}

static void
parts(const sg_shading *scene, const sg_looks *looks)
{
  sg_shaded in = {.scene = scene, .lines = 4, .looks = *looks};
  sg_shading_work *work = sg_shading_work_open(scene, NULL);
  sg_spans spans = {0};
  sg_dot_parts row = {0};
  double area = 0;
  bool good = work != NULL;

  for (int32_t y = 0; good && y < SIDE; y++) {
    good = sg_dot_parts_of(&in, work, &spans, y, &row);
    for (size_t i = 0; i < row.n; i++) {
      const sg_dot_part *p = &row.item[i];
      good = good && p->leaf == 1 && p->face == 1 && p->light[1] == 40000 &&
             (i == 0 || p->x > row.item[i - 1].x);
      area += p->share / (256.0 * 4 * SG_OPAQUE);
    }
  }
  CHECK("each dot has one part of the ball", good);
  CHECK("together they are a disc", fabs(area - 3.14159265 * 625) < 1);
  free(row.item);
  free(spans.span);
  sg_shading_work_close(work);
}

/* Darker than t is a ring from r sqrt(1 - t^2) to r. */
static void
strokes(const sg_shading *scene, const sg_looks *looks)
{
  for (int k = 1; k < 4; k++) {
    sg_tone_strokes out = {0};
    double t = k / 4.0, length = 0, spacing = 0.0625;
    bool good =
        sg_tone_strokes_of(scene, looks, spacing, (uint32_t)(t * SG_TONE_MOST),
                           0.7, NULL, &out) == SG_SHADING_GOOD;

    for (size_t i = 0; i < out.n; i++) {
      const sg_tone_stroke *s = &out.item[i];
      double inner = 625 * (1 - t * t) - (s->y - 32) * (s->y - 32);
      length += s->x2 - s->x1;
      good = good && s->x1 < s->x2 &&
             (inner < 0 || fabs(fabs(s->x1 - 32) - sqrt(inner)) < 0.6 ||
              fabs(fabs(s->x2 - 32) - sqrt(inner)) < 0.6);
    }
    CHECK("strokes end where the tone is passed", good);
    CHECK("they are as many as the ring is large",
          fabs(length * spacing / (3.14159265 * 625 * t * t) - 1) < 0.01);
    free(out.item);
  }
}

static void
depths(const sg_shading *scene)
{
  static const double up[4] = {0, 0, 1, 5};
  sg_shading_work *work = sg_shading_work_open(scene, NULL);
  sg_spans spans = {0};
  float row[SIDE], normal[SIDE][3];
  bool good = work && sg_depth_row(scene, work, up, 31, &spans, row) &&
              sg_normal_row(scene, work, 31, &spans, normal);

  for (int x = 0; good && x < SIDE; x++) {
    double dx = x + 0.5 - 32, square = 625 - 0.25 - dx * dx;
    good = square < 0 ? isinf(row[x]) && normal[x][2] == 0
                      : fabs(row[x] - 5 - sqrt(square)) < 1e-4 &&
                            fabs(normal[x][0] - dx / 25) < 1e-5;
  }
  CHECK("depths and normals are those of a ball", good);
  free(spans.span);
  sg_shading_work_close(work);
}

int
main(void)
{
  sg_face_look look;
  const sg_looks looks = {&look, {first, of}};
  sg_shading *scene = sphere_scene(SIDE, SIDE, 32, 32, 25);

  fill_look(&look);
  CHECK("a scene", scene != NULL);
  if (scene) {
    parts(scene, &looks);
    strokes(scene, &looks);
    depths(scene);
  }
  sg_shading_close(scene);
  return check_report();
}
