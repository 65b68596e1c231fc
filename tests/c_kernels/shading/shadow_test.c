/* shadow_test.c -- how much of a light comes past a sphere; lines where faces
 * begin; spans that are kept; bands that are made again.
 *
 * covers: face_edge, scan
 */
#include "shaded_sphere.h"

#include "shading/buffer.h"
#include "shading/face_edge.h"
#include "shading/shadow.h"

#include "tests/check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 96 };

/* ---- shadows ---- */

/* A ball of 20 about (40, 50, 0), lit along -z: on the plane z = -30 its shadow
 * is a disc. */
static void
shadow_of_sphere(const sg_opacities *opacities, uint32_t dark)
{
  sg_shading *scene = sphere_scene(SIDE, SIDE, 40, SIDE - 50, 20);
  sg_shading_work *work = sg_shading_work_open(scene, opacities);
  sg_shadow shadow;
  bool good = true, above = true;
  uint32_t part;

  CHECK("opened", sg_shadow_open(scene, NULL, &shadow) == SG_SHADING_GOOD);
  CHECK("a dot is a unit", fabs(sg_shadow_scale(&shadow) - 1) < 1e-12);
  for (int k = 0; k < 4000; k++) {
    double x = 10 + (k % 64) * 0.9371, y = 20 + k / 64 * 0.9713;
    bool in = hypot(x - 40, y - 50) < 20;

    if (fabs(hypot(x - 40, y - 50) - 20) < 0.01) {
      continue; /* ends are rounded to 1/256 dot */
    }
    good = good &&
           sg_shadow_part(&shadow, work, (double[3]){x, y, -30}, &part) &&
           part == (in ? dark : SG_OPAQUE);
    above = above &&
            sg_shadow_part(&shadow, work, (double[3]){x, y, 30}, &part) &&
            part == SG_OPAQUE;
  }
  CHECK("a disc is dark", good);
  CHECK("what is before it is lit", above);
  CHECK("outside of all",
        sg_shadow_part(&shadow, work, (double[3]){-1e6, 1e6, -9}, &part) &&
            part == SG_OPAQUE);
  sg_shadow_close(&shadow);
  sg_shading_work_close(work);
  sg_shading_close(scene);
}

static void
no_shadow(void)
{
  const sg_shading_frame frame = {
      .matrix = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}},
      .width = 9,
      .height = 9};
  sg_shading *scene = sg_shading_open(&frame);
  sg_shadow shadow;
  uint32_t part = 0;

  CHECK("an empty scene", sg_shading_seal(scene, NULL) == SG_SHADING_GOOD);
  sg_shading_work *work = sg_shading_work_open(scene, NULL);
  CHECK("has no shadow",
        sg_shadow_open(scene, NULL, &shadow) == SG_SHADING_GOOD &&
            sg_shadow_part(&shadow, work, (double[3]){1, 1, 1}, &part) &&
            part == SG_OPAQUE);
  sg_shadow_close(&shadow);
  sg_shading_work_close(work);
  sg_shading_close(scene);
}

/* ---- lines where faces begin ---- */

/* All of the dots is white: what is missing is the line. */
static void
line_round(double x, double y, double r, unsigned lines)
{
  static sg_face_look look;
  const uint32_t first[] = {0, 0, 1}, of[] = {0};
  sg_shading *scene = sphere_scene(SIDE, SIDE, x, y, r);
  const sg_shaded in = {.scene = scene,
                        .lines = lines,
                        .looks = {&look, {first, of}},
                        .edges = true};
  sg_shading_work *work = sg_shading_work_open(scene, NULL);
  sg_spans spans = {0};
  sg_dot_row row;
  double line = 0, all = 256.0 * lines;
  bool good = sg_cover_open(&row, SIDE);

  look.tones.constant = 1;
  memset(look.ramp.light, 0xff, sizeof look.ramp.light);
  for (int32_t k = 0; good && k < SIDE; k++) {
    good = sg_cover_row(&row, &in, work, &spans, k);
    for (int32_t i = 0; i < SIDE; i++) {
      line += row.sum[i][3] / all / SG_OPAQUE - row.sum[i][0] / all / 65535;
    }
  }
  CHECK("rows", good);
  /* The strips are a dot wide along x or y, whichever is more: 8 r. */
  CHECK("a line round", fabs(line / (4 * sqrt(2) * r) - 1) < 0.08);
  sg_cover_close(&row);
  free(spans.span);
  sg_shading_work_close(work);
  sg_shading_close(scene);
}

/* ---- kept spans, bands again ---- */

static void
lit_from_eye(sg_face_look *look)
{
  memset(look, 0, sizeof *look);
  look->tones.ways = 1;
  look->tones.way[0] = (sg_tone_way){{0, 0, 1}, 1, 0};
  for (int k = 0; k <= SG_RAMP + 1; k++) {
    for (int c = 0; c < 3; c++) {
      look->ramp.light[k][c] = (uint16_t)((k < SG_RAMP ? k : SG_RAMP) * 63);
    }
  }
}

static void
kept(void)
{
  static sg_face_look look;
  const uint32_t first[] = {0, 0, 1}, of[] = {0};
  sg_shading *scene = sphere_scene(SIDE, SIDE, 40.3, 61.9, 23);
  sg_shading *other = sphere_scene(SIDE, SIDE, 40.3, 43.9, 23);
  sg_shaded in = {.scene = scene, .lines = 4, .looks = {&look, {first, of}}};
  sg_image *plain = NULL, *by_scan = NULL, *moved = NULL, *again = NULL;
  sg_pool *pool = sg_pool_open(2);
  sg_scan *scan = NULL;
  size_t bytes = (size_t)SIDE * SIDE * 3, changed[SIDE], n = 0;

  lit_from_eye(&look);
  CHECK("kept",
        sg_scan_open(scene, 4, NULL, pool, NULL, &scan) == SG_SHADING_GOOD &&
            scan->n == 4 * SIDE && sg_scan_is_of(scan, scene, 4));
  CHECK("of this scene alone",
        !sg_scan_is_of(scan, other, 4) && !sg_scan_is_of(scan, scene, 2));
  CHECK("plain", sg_shade(&in, pool, NULL, &plain) == SG_SHADING_GOOD);
  in.scan = scan;
  CHECK("the same bytes",
        sg_shade(&in, pool, NULL, &by_scan) == SG_SHADING_GOOD &&
            !memcmp(plain->dot, by_scan->dot, bytes));
  in.scan = NULL;
  in.scene = other;
  CHECK("moved", sg_shade(&in, pool, NULL, &moved) == SG_SHADING_GOOD);
  for (size_t i = 0; i < (SIDE + SG_IMAGE_BAND - 1) / SG_IMAGE_BAND; i++) {
    size_t row = (size_t)SIDE * 3, from = i * SG_IMAGE_BAND * row;
    if (memcmp(plain->dot + from, moved->dot + from, SG_IMAGE_BAND * row) !=
        0) {
      changed[n++] = i;
    }
  }
  CHECK("some bands again",
        n > 1 && n < SIDE / SG_IMAGE_BAND &&
            sg_shade_again(&in, plain, changed, n, pool, NULL, &again) ==
                SG_SHADING_GOOD &&
            !memcmp(moved->dot, again->dot, bytes));
  sg_image_close(again);
  CHECK("one band too few", sg_shade_again(&in, plain, changed, n - 1, pool,
                                           NULL, &again) == SG_SHADING_GOOD &&
                                memcmp(moved->dot, again->dot, bytes) != 0);
  sg_image_close(again);
  sg_image_close(moved);
  sg_image_close(by_scan);
  sg_image_close(plain);
  sg_scan_close(scan);
  sg_pool_close(pool);
  sg_shading_close(other);
  sg_shading_close(scene);
}

int
main(void)
{
  const uint32_t half = SG_OPAQUE / 2, first[] = {0, 0, 1}, of[] = {0};
  const sg_opacities glass = {&half, {first, of}};

  shadow_of_sphere(NULL, 0);
  shadow_of_sphere(&glass, SG_OPAQUE / 4);
  no_shadow();
  line_round(48.3, 47.1, 30, 4);
  line_round(48.3, 47.1, 20, 16);
  line_round(48.3, 47.1, 33, 2);
  kept();
  return check_report();
}
