/* buffer_test.c -- a sphere in dots: how much it covers, where its middle is,
 * how light it is, and the same bytes by any number of threads.
 *
 * covers: cover, tone, srgb, extent
 */
#include "shaded_sphere.h"

#include "shading/buffer.h"
#include "shading/extent.h"
#include "shading/srgb.h"

#include "tests/check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 128 };

static const double pi = 3.14159265358979323846;

/* ---- srgb ---- */

static void
bytes_and_light(void)
{
  static uint8_t byte[SG_LIGHT_MOST + 1];
  bool back = true, rises = true;

  sg_srgb_bytes(byte);
  for (unsigned b = 0; b < 256; b++) {
    double v = b / 255.0;
    double light = v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);

    back = back && byte[sg_srgb_light((uint8_t)b)] == b &&
           fabs(sg_srgb_light((uint8_t)b) - 65535 * light) < 0.51;
  }
  for (unsigned k = 1; k <= SG_LIGHT_MOST; k++) {
    rises = rises && byte[k] >= byte[k - 1];
  }
  CHECK("bytes are light and bytes again", back);
  CHECK("more light is no darker",
        rises && byte[0] == 0 && byte[SG_LIGHT_MOST] == 255);
}

/* ---- tones ---- */

/* Lit from the eye; light is the tone. */
static void
lit_from_eye(sg_face_look *look)
{
  memset(look, 0, sizeof *look);
  look->tones.ways = 1;
  look->tones.way[0] = (sg_tone_way){{0, 0, 1}, 1, 0};
  for (int k = 0; k <= SG_RAMP + 1; k++) {
    for (int c = 0; c < 3; c++) {
      look->ramp.light[k][c] =
          (uint16_t)((k < SG_RAMP ? k : SG_RAMP) * (SG_LIGHT_MOST / 1024.0));
    }
  }
}

/* A table that has the same tones as the sum, nearly. */
static void
table_of_tones(void)
{
  static float table[SG_TONE_SIDE * SG_TONE_SIDE];
  const double to[3] = {-0.36, 0.48, 0.8};
  sg_tones sum = {.constant = 0.25, .ways = 1};
  sg_tones by = {.table = table, .axis = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  double most = 0;

  sum.way[0] = (sg_tone_way){{to[0], to[1], to[2]}, 0.7, 0};
  for (unsigned i = 0; i < SG_TONE_SIDE; i++) {
    for (unsigned j = 0; j < SG_TONE_SIDE; j++) {
      double n[3];
      sg_tone_normal(i, j, n);
      double along = to[0] * n[0] + to[1] * n[1] + to[2] * n[2];
      table[i * SG_TONE_SIDE + j] =
          (float)(0.25 + (along > 0 ? 0.7 * along : 0));
    }
  }
  for (int k = 0; k < 1000; k++) {
    double z = (k + 0.5) / 1000, r = sqrt(1 - z * z), a = k * 2.399963;
    const double n[3] = {r * cos(a), r * sin(a), z};
    most = fmax(most,
                fabs((double)sg_tone(&sum, n, NULL) - sg_tone(&by, n, NULL)));
  }
  CHECK("a table is as the sum", most < 0.005 * SG_TONE_MOST);
  CHECK("what looks away is seen edge-on",
        sg_tone(&by, (double[3]){0.6, 0, -0.8}, NULL) ==
            sg_tone(&by, (double[3]){1, 0, 0}, NULL));
}

/* ---- closed forms ---- */

typedef struct sums {
  double area, x, y, tone;
} sums;

static sums
sums_of(const sg_shaded *in)
{
  sg_dot_row row;
  sg_spans spans = {0};
  sums out = {0};
  sg_shading_work *work = sg_shading_work_open(in->scene, in->opacities);
  bool good = work && sg_cover_open(&row, SIDE);

  for (int32_t y = 0; good && y < SIDE; y++) {
    good = sg_cover_row(&row, in, work, &spans, y);
    for (int32_t x = 0; good && x < SIDE; x++) {
      double part = row.sum[x][3] / (256.0 * in->lines * SG_OPAQUE);
      out.area += part;
      out.x += part * (x + 0.5);
      out.y += part * (y + 0.5);
      out.tone += row.sum[x][0] / (256.0 * in->lines * SG_LIGHT_MOST);
    }
  }
  CHECK("sums", good);
  sg_cover_close(&row);
  free(spans.span);
  sg_shading_work_close(work);
  return out;
}

static void
sphere_of(double x, double y, double r, unsigned lines)
{
  static sg_face_look look;
  const uint32_t first[] = {0, 0, 1}, of[] = {0};
  sg_shading *scene = sphere_scene(SIDE, SIDE, x, y, r);
  sg_shaded in = {.scene = scene,
                  .lines = lines,
                  .looks = {&look, {first, of}},
                  .clear = true};

  lit_from_eye(&look);
  if (!CHECK("a scene", scene)) {
    return;
  }
  sums sum = sums_of(&in);
  double area = pi * r * r;

  double wrong = pow(r * lines, -1.5);

  CHECK("area of a disc", fabs(sum.area / area - 1) < 0.4 * wrong);
  CHECK("middle of a disc", fabs(sum.x / sum.area - x) < 0.3 * r * wrong &&
                                fabs(sum.y / sum.area - y) < 0.3 * r * wrong);
  CHECK("within 1/100 dot", lines < 4 || (fabs(sum.x / sum.area - x) < 0.01 &&
                                          fabs(sum.y / sum.area - y) < 0.01));
  CHECK("a sphere lit from the eye",
        fabs(sum.tone / sum.area - 2.0 / 3) < 2 / (r * r) + 0.002);
  sg_shading_close(scene);
}

/* A ball of glass: as much as both its sides stop. */
static void
see_through(double opacity)
{
  static sg_face_look look;
  const uint32_t first[] = {0, 0, 1}, of[] = {0};
  const uint32_t part = (uint32_t)(opacity * SG_OPAQUE);
  const sg_opacities opacities = {&part, {first, of}};
  sg_shading *scene = sphere_scene(SIDE, SIDE, 64, 64, 50);
  sg_shaded in = {.scene = scene,
                  .lines = 4,
                  .looks = {&look, {first, of}},
                  .opacities = &opacities,
                  .clear = true};

  lit_from_eye(&look);
  sums sum = sums_of(&in);
  double stops = opacity + (1 - opacity) * opacity;

  CHECK("two sides stop light",
        fabs(sum.area / (pi * 2500) - stops) < 0.001 * stops);
  CHECK("both are lit from the eye",
        fabs(sum.tone / sum.area - 2.0 / 3) < 0.003);
  sg_shading_close(scene);
}

/* Light thrown back to the eye: the mean of cos^n over a disc is 2 / (n + 2).
 */
static void
shine(unsigned power)
{
  static sg_face_look look;
  const uint32_t first[] = {0, 0, 1}, of[] = {0};
  sg_shading *scene = sphere_scene(SIDE, SIDE, 64, 64, 60);
  sg_shaded in = {
      .scene = scene, .lines = 4, .looks = {&look, {first, of}}, .clear = true};

  memset(&look, 0, sizeof look);
  look.shine = (sg_shine){.power = power, .ways = 1};
  look.shine.way[0] = (sg_tone_way){{0, 0, 1}, 1, 0};
  sums sum = sums_of(&in);

  CHECK("the mean of a shine",
        fabs(sum.tone / sum.area * (power + 2) / 2 - 1) < 0.01);
  sg_shading_close(scene);
}

/* ---- threads ---- */

static sg_image *
image_by(unsigned threads, const sg_shaded *in)
{
  sg_image *image = NULL;
  sg_pool *pool = sg_pool_open(threads);

  CHECK("shaded", sg_shade(in, pool, NULL, &image) == SG_SHADING_GOOD);
  sg_pool_close(pool);
  return image;
}

static bool
says_stop(void *data)
{
  (void)data;
  return true;
}

static void
threads(void)
{
  static sg_face_look look;
  const uint32_t first[] = {0, 0, 1}, of[] = {0};
  const sg_cancel stop = {says_stop, NULL};
  sg_shading *scene = sphere_scene(SIDE, SIDE, 60.3, 71.9, 50);
  sg_shaded in = {.scene = scene,
                  .lines = 4,
                  .looks = {&look, {first, of}},
                  .background = {SG_LIGHT_MOST, SG_LIGHT_MOST, SG_LIGHT_MOST}};
  sg_shading_extent box;

  lit_from_eye(&look);
  sg_image *one = image_by(1, &in), *two = image_by(2, &in),
           *seven = image_by(7, &in), *none = NULL;

  CHECK("bytes by two threads",
        one && two && !memcmp(one->dot, two->dot, SIDE * SIDE * 3));
  CHECK("bytes by seven",
        one && seven && !memcmp(one->dot, seven->dot, SIDE * SIDE * 3));
  CHECK("the background", one && one->dot[0] == 255 && one->bytes == 3);
  CHECK("stopped",
        sg_shade(&in, NULL, &stop, &none) == SG_SHADING_STOPPED && !none);
  CHECK("where it is seen",
        sg_shading_extent_of(scene, NULL, NULL, &box) == SG_SHADING_GOOD &&
            fabs(box.x1 - 10.3) < 0.01 && fabs(box.x2 - 110.3) < 0.01 &&
            fabs(box.y1 - 21.9) < 0.01 && fabs(box.y2 - 121.9) < 0.01);
  sg_image_close(one);
  sg_image_close(two);
  sg_image_close(seven);
  sg_shading_close(scene);
}

/* Of a sphere whose middle is so far below the frame, or above it, only what is
 * in the frame is seen, whatever the height. */
static void
cut_by_frame(int32_t height, double beyond)
{
  const double r = 10, half = sqrt(r * r - beyond * beyond);

  for (int below = 0; below < 2; below++) {
    double y = below ? height + beyond : -beyond;
    sg_shading *scene = sphere_scene(SIDE, height, 60.3, y, r);
    sg_shading_extent box;

    CHECK("cut by the frame",
          sg_shading_extent_of(scene, NULL, NULL, &box) == SG_SHADING_GOOD &&
              fabs(box.x1 - 60.3 + half) < 0.02 &&
              fabs(box.x2 - 60.3 - half) < 0.02 &&
              fabs(box.y1 - (below ? y - r : 0)) < 0.02 &&
              fabs(box.y2 - (below ? height : y + r)) < 0.02);
    sg_shading_close(scene);
  }
}

int
main(void)
{
  uint32_t seed = 7;

  bytes_and_light();
  table_of_tones();
  for (int k = 0; k < 60; k++) {
    double r = 8 + check_below(&seed, 40) + check_below(&seed, 256) / 256.0;
    double x = 64 + check_below(&seed, 1000) / 100.0 - 5;
    double y = 64 + check_below(&seed, 1000) / 100.0 - 5;
    sphere_of(x, y, r, 1u << (k % 5));
  }
  see_through(0.5);
  see_through(0.3);
  see_through(1);
  shine(1);
  shine(2);
  shine(13);
  shine(40);
  threads();
  for (int32_t height = 33; height <= 64; height++) {
    cut_by_frame(height, 1 + height % 7);
  }
  return check_report();
}
