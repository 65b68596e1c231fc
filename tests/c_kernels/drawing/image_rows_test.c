/* image_rows_test.c -- a sphere through the functions of the doors, without
 * Prolog: shaded, and as files, which a reader of its own reads again.
 *
 * covers: image_png, png_chunk
 */
#include "doors/image.h"
#include "doors/shading.h"
#include "shading/buffer.h"
#include "shading/extent.h"
#include "shading/srgb.h"

#include "tests/c_kernels/door_call.h"
#include "tests/c_kernels/shading/shaded_sphere.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

#include <stdlib.h>
#include <string.h>
#include <zlib.h>

/* What was written. */
typedef struct written {
  uint8_t *byte;
  size_t n;
  bool full;
} written;

static bool
write_bytes(void *data, const char *bytes, size_t n)
{
  written *to = data;
  uint8_t *more = /* refuse.c does not stand before this one */
      to->full ? NULL : reallocarray(to->byte, to->n + n, 1);

  if (!more) {
    return false;
  }
  memcpy(more + to->n, bytes, n);
  to->byte = more;
  to->n += n;
  return true;
}

/* ---- shading ---- */

static sg_shading_look_list
one_look(void)
{
  static sg_ramp_light light[1025];
  static sg_tone_way way = {{0.48, 0.64, 0.6}, 0.75, 0};
  static sg_shading_look look;

  for (int k = 0; k < 1025; k++) {
    light[k] = (sg_ramp_light){k * 60, k * 30, 65535 - k * 63};
  }
  look.tones = (sg_shading_tones){.is = SG_SHADING_TONES_SUM};
  look.tones.sum.constant = 0.25;
  look.tones.sum.ways = (sg_tone_way_list){&way, 1, 0};
  look.ramp = (sg_ramp_light_list){light, 1025, 0};
  look.opacity = 1;
  look.shine = (sg_shading_shine){.power = 1};
  look.stripes = (sg_stripes){0, 1};
  return (sg_shading_look_list){&look, 1, 0};
}

static sg_image *
shaded(sg_shading *scene, size_t lines, bool clear)
{
  static size_t zero[] = {0};
  static sg_count_list places = {zero, 1, 0};
  const sg_list_count_list leaves = {&places, 1, 0};
  const sg_shading_look_list looks = one_look();
  sg_image_background back = {.is = clear ? SG_IMAGE_BACKGROUND_NONE
                                          : SG_IMAGE_BACKGROUND_RGB};
  sg_image *image = NULL;

  back.rgb = (sg_rgb){255, 250, 240};
  const sg_image_how how = {.lines = lines, .background = back};

  return sg_door_image_shade(&call, scene, &how, &looks, &leaves, &image)
             ? image
             : NULL;
}

/* ---- PNG ---- */

static uint32_t
number(const uint8_t *at)
{
  return (uint32_t)at[0] << 24 | (uint32_t)at[1] << 16 | (uint32_t)at[2] << 8 |
         at[3];
}

/* All data of IDAT, and whether every check sum is right. */
static bool
png_data(const written *file, written *data, bool *metres)
{
  size_t at = 8;

  while (at + 12 <= file->n) {
    const uint8_t *chunk = file->byte + at;
    size_t n = number(chunk);

    if (at + 12 + n > file->n ||
        crc32(0, chunk + 4, (uInt)n + 4) != number(chunk + 8 + n)) {
      return false;
    }
    if (!memcmp(chunk + 4, "IDAT", 4)) {
      write_bytes(data, (const char *)chunk + 8, n);
    }
    *metres = *metres || !memcmp(chunk + 4, "pHYs", 4);
    at += 12 + n;
  }
  return at == file->n && !memcmp(file->byte + at - 8, "IEND", 4);
}

/* The dots of a file whose rows have the filters 0, 1 and 2. */
static bool
same_dots(const written *file, const sg_image *image)
{
  size_t row = (size_t)image->width * image->bytes;
  uLongf n = (uLongf)((row + 1) * (size_t)image->height);
  uint8_t *raw = malloc(n), *above = calloc(1, row);
  written data = {0};
  bool metres = false;
  bool same = raw && above && png_data(file, &data, &metres) && metres &&
              uncompress(raw, &n, data.byte, (uLong)data.n) == Z_OK;

  for (int32_t y = 0; same && y < image->height; y++) {
    uint8_t *line = raw + (size_t)y * (row + 1);
    for (size_t i = 0; i < row; i++) {
      uint8_t left = i < image->bytes ? 0 : line[1 + i - image->bytes];
      line[1 + i] = (uint8_t)(line[1 + i] + (line[0] == 1   ? left
                                             : line[0] == 2 ? above[i]
                                                            : 0));
    }
    memcpy(above, line + 1, row);
    same = line[0] <= 2 && !memcmp(above, image->dot + (size_t)y * row, row);
  }
  free(raw);
  free(above);
  free(data.byte);
  return same;
}

static bool
last_dot(sg_image *image)
{
  size_t x = (size_t)image->width - 1, y = (size_t)image->height - 1;
  const uint8_t *last = image->dot + (y * (x + 1) + x) * image->bytes;
  sg_count_list bytes = {0};
  bool same =
      sg_door_image_dot(&call, image, x, y, &bytes) && bytes.n == image->bytes;

  for (size_t c = 0; same && c < bytes.n; c++) {
    same = bytes.at[c] == last[c];
  }
  return same && !sg_door_image_dot(&call, image, x + 1, y, &bytes) &&
         is_domain("image_dot", 2) &&
         !sg_door_image_dot(&call, image, x, y + 1, &bytes) &&
         is_domain("image_dot", 3);
}

/* The dots of a row, and strokes, of a ball. */
static void
parts_and_strokes(void)
{
  static size_t zero[] = {0};
  static sg_count_list places = {zero, 1, 0};
  const sg_list_count_list leaves = {&places, 1, 0};
  const sg_shading_look_list looks = one_look();
  sg_shading *scene = sphere_scene(40, 30, 20, 15, 10);
  sg_image *image = scene ? shaded(scene, 1, false) : NULL;
  sg_image_part_list parts = {0};
  const sg_image_how how = {.lines = 1};
  sg_image_stroke_list strokes = {0};
  size_t width = 0, height = 0, byte = 0;

  CHECK("parts of a row", scene &&
                              sg_door_image_parts(&call, scene, &how, &looks,
                                                  &leaves, 15, &parts) &&
                              parts.n == 20 && parts.at[9].share == 1 &&
                              parts.at[9].leaf == 1);
  const sg_image_how middles = {.lines = 0};
  CHECK("a part of a dot is not its middle",
        !sg_door_image_parts(&call, scene, &middles, &looks, &leaves, 15,
                             &parts) &&
            is_domain("shading_lines", 2));
  CHECK("no such row",
        !sg_door_image_parts(&call, scene, &how, &looks, &leaves, 30, &parts) &&
            is_domain("image_dot", 5));
  CHECK_DOOR("strokes", sg_door_image_strokes(&call, scene, 1, &looks, &leaves,
                                              2, 1, &strokes) &&
                            strokes.n > 0 &&
                            strokes.at[0].x1 < strokes.at[0].x2);
  CHECK("no spacing", !sg_door_image_strokes(&call, scene, 1, &looks, &leaves,
                                             0, 1, &strokes) &&
                          is_domain("spacing", 5));
  CHECK("its size", image &&
                        sg_door_image_size(&call, image, &width, &height) &&
                        width == 40 && height == 30);
  CHECK_DOOR("the byte of light",
             sg_door_light_srgb(&call, SG_LIGHT_MOST, &byte) && byte == 255 &&
                 !sg_door_light_srgb(&call, SG_LIGHT_MOST + 1, &byte) &&
                 is_domain("light", 1));
  sg_image_close(image);
  sg_shading_close(scene);
}

/* Of kept spans, and in part again: the same dots. */
static void
again(void)
{
  static size_t zero[] = {0};
  static sg_count_list places = {zero, 1, 0};
  const sg_list_count_list leaves = {&places, 1, 0};
  const sg_shading_look_list looks = one_look();
  double opaque[] = {1};
  const sg_number_list opacities = {opaque, 1, 0};
  sg_image_how how = {.lines = 2,
                      .background = {.is = SG_IMAGE_BACKGROUND_RGB}};
  sg_shading *scene = sphere_scene(40, 50, 20, 25, 10);
  sg_shading *other = sphere_scene(40, 50, 20, 25, 10);
  sg_shading *light = sphere_scene(40, 50, 20, 25, 10);
  sg_image *image = NULL, *same = NULL;
  size_t bands[] = {1, 3}, far[] = {4}, bytes = 40 * 50 * 3;
  sg_scan *scan = NULL;
  written pgm = {0};
  const sg_output to_pgm = {write_bytes, &pgm};
  const sg_image_file file = {.format = SG_IMAGE_FORMAT_PGM};

  CHECK_DOOR("a picture",
             sg_door_image_shade(&call, scene, &how, &looks, &leaves, &image));
  CHECK_DOOR("a scan",
             sg_door_shading_scan(&call, scene, 2, &opacities, &leaves, &scan));
  CHECK_DOOR("of it", sg_door_image_scanned(&call, scan, scene, &how, &looks,
                                            &leaves, &same) &&
                          !memcmp(image->dot, same->dot, bytes));
  sg_image_close(same);
  CHECK("of another scene", !sg_door_image_scanned(&call, scan, other, &how,
                                                   &looks, &leaves, &same) &&
                                is_domain("shading_scan", 1));
  memset(image->dot + 16 * 120, 9, 16 * 120);
  CHECK_DOOR("two bands again",
             sg_door_image_again(&call, image, &(sg_count_list){bands, 2, 0}, 0,
                                 40, scene, &how, &looks, &leaves, &same) &&
                 memcmp(image->dot, same->dot, bytes) != 0 &&
                 !memcmp(image->dot, same->dot, 16 * 120));
  sg_image_close(same);
  CHECK("no such band",
        !sg_door_image_again(&call, image, &(sg_count_list){far, 1, 0}, 0, 40,
                             scene, &how, &looks, &leaves, &same) &&
            is_domain("image_band", 2));
  CHECK("no such columns",
        !sg_door_image_again(&call, image, &(sg_count_list){bands, 2, 0}, 3, 41,
                             scene, &how, &looks, &leaves, &same) &&
            is_domain("image_column", 4));
  memset(image->dot, 9, 3 * 40 * 50);
  CHECK_DOOR("columns alone are made again",
             sg_door_image_again(&call, image, &(sg_count_list){bands, 2, 0},
                                 10, 20, scene, &how, &looks, &leaves, &same));
  for (size_t x = 0; x < 40; x++) {
    CHECK("a dot", (same->dot[16 * 120 + 3 * x] == 9) == (x < 10 || x >= 20));
  }
  sg_image_close(same);
  CHECK_DOOR("a PGM", sg_door_image_written(&call, scene, &how, &looks, &leaves,
                                            &file, &to_pgm) &&
                          pgm.n == strlen("P5\n40 50\n255\n") + 2000);
  size_t before = pgm.n;
  CHECK_DOOR("packed, it is smaller",
             sg_door_image_lzw(&call, image, &to_pgm) && pgm.n > before &&
                 pgm.n - before < 3000);
  how.shadows = (sg_shading_list){&light, 1, 0};
  CHECK_DOOR("a ball has no shadow on itself where it is lit",
             sg_door_image_shade(&call, scene, &how, &looks, &leaves, &same));
  sg_image_close(same);
  free(pgm.byte);
  sg_scan_close(scan);
  sg_image_close(image);
  sg_shading_close(light);
  sg_shading_close(other);
  sg_shading_close(scene);
}

static void
files(int32_t width, int32_t height, bool clear)
{
  sg_shading *scene = sphere_scene(width, height, 0.4 * width, 0.5 * height,
                                   0.45 * (width < height ? width : height));
  sg_image *image = scene ? shaded(scene, 4, clear) : NULL;
  written png = {0}, ppm = {0};
  const sg_output to_png = {write_bytes, &png}, to_ppm = {write_bytes, &ppm};

  CHECK("shaded", image && image->width == width && image->height == height &&
                      image->bytes == (clear ? 4 : 3));
  CHECK_DOOR("a PNG", image && sg_door_image_png(&call, image, 3937, &to_png));
  CHECK("has its dots", image && same_dots(&png, image));
  CHECK("its colours", png.n > 26 && png.byte[25] == (clear ? 6 : 2));
  CHECK("its last dot", image && last_dot(image));
  if (clear) {
    CHECK("no PPM", image && !sg_door_image_ppm(&call, image, &to_ppm) &&
                        is_domain("image_without_alpha", 1) && ppm.n == 0);
  } else {
    size_t n = (size_t)width * (size_t)height * 3;
    CHECK_DOOR("a PPM", image && sg_door_image_ppm(&call, image, &to_ppm) &&
                            ppm.n > n && ppm.byte[0] == 'P' &&
                            !memcmp(ppm.byte + ppm.n - n, image->dot, n));
  }
  free(png.byte);
  free(ppm.byte);
  sg_image_close(image);
  if (scene) {
    sg_shading_close(scene);
  }
}

/* ---- what is refused ---- */

static void
refused(void)
{
  sg_shading *scene = sphere_scene(20, 10, 10, 5, 4);
  sg_shading *empty = sphere_scene(20, 10, 100, 50, 4);
  sg_shading_look_list looks = one_look();
  size_t one[] = {1}, light;
  sg_count_list places = {one, 1, 0};
  const sg_list_count_list leaves = {&places, 1, 0};
  const sg_image_how how = {.lines = 1,
                            .background = {.is = SG_IMAGE_BACKGROUND_NONE}};
  sg_shading_extent box;
  sg_vector_list normals = {0};
  sg_image *image = NULL;
  written full = {.full = true};
  const sg_output to = {write_bytes, &full};

  CHECK("lines", !shaded(scene, 3, true) && is_domain("shading_lines", 2));
  CHECK("most lines",
        !shaded(scene, 32, true) && is_domain("shading_lines", 2));
  CHECK("a look that is not there",
        !sg_door_image_shade(&call, scene, &how, &looks, &leaves, &image) &&
            is_domain("shading_look", 4));
  one[0] = 0;
  looks.at->opacity = 1.5;
  CHECK("more than opaque",
        !sg_door_image_shade(&call, scene, &how, &looks, &leaves, &image) &&
            is_domain("opacity", 3));
  looks = one_look();
  looks.at->shine.power = 0;
  CHECK("no power",
        !sg_door_image_shade(&call, scene, &how, &looks, &leaves, &image) &&
            is_domain("shading_shine", 3));
  looks = one_look();
  looks.at->stripes.step = 3;
  CHECK("narrow stripes",
        !sg_door_image_shade(&call, scene, &how, &looks, &leaves, &image) &&
            is_domain("shading_stripes", 3));
  looks = one_look();
  looks.at->ramp.n = 7;
  CHECK("a short ramp",
        !sg_door_image_shade(&call, scene, &how, &looks, &leaves, &image) &&
            is_domain("shading_ramp", 3));
  CHECK_DOOR("where it is", sg_door_image_extent(&call, scene, &box) &&
                                box.x1 > 5.9 && box.x2 < 14.1);
  CHECK("nowhere", !sg_door_image_extent(&call, empty, &box));
  CHECK_DOOR("normals", sg_door_image_normals(&call, &normals) &&
                            normals.n == SG_TONE_SIDE * SG_TONE_SIDE);
  CHECK_DOOR("light", sg_door_srgb_light(&call, 255, &light) && light == 65535);
  CHECK("no byte",
        !sg_door_srgb_light(&call, 256, &light) && is_domain("byte", 1));
  image = shaded(scene, 1, false);
  CHECK("a full disk", image && !sg_door_image_png(&call, image, 0, &to) &&
                           !sg_door_image_ppm(&call, image, &to));
  sg_image_close(image);
  sg_shading_close(scene);
  sg_shading_close(empty);
}

int
main(void)
{
  sg_world *world = sg_world_open();

  sg_call_open(&call, NULL, NULL);
  call.world = world;
  parts_and_strokes();
  again();
  files(1, 1, false);
  files(40, 30, true);
  files(17, 64, false);
  files(33, 65, true);
  files(300, 200, false);
  refused();
  sg_call_close(&call);
  sg_world_let_go(world);
  return check_report();
}
