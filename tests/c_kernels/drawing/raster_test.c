/* raster_test.c -- lines as dots, and dots as a PNG file.
 *
 * Lines are held against the definition (the dots nearest to the true line),
 * the file against a reader written here from the specification.
 */
#include "tests/check.h"

#include "drawing/png.h"

#include <stdlib.h>
#include <string.h>
#include <zlib.h>

static const sg_pen solid = {1, 1, 0, NULL};
static uint64_t state = 19880101;

static int32_t
random_below(int32_t n)
{
  state = state * 6364136223846793005u + 1442695040888963407u;
  return (int32_t)((state >> 33) % (uint64_t)n);
}

static uint8_t
at(const sg_raster *r, int32_t x, int32_t y)
{
  return r->dot[y * r->width + x];
}

static unsigned
count(const sg_raster *r)
{
  unsigned n = 0;

  for (int32_t i = 0; i < r->width * r->height; i++) {
    n += r->dot[i] != 0;
  }
  return n;
}

/* One dot a column (or row, if steep), each within half a dot of the line. */
static bool
is_nearest(int32_t x0, int32_t y0, int32_t x1, int32_t y1)
{
  int32_t line[2][2] = {{x0, y0}, {x1, y1}};
  int32_t dx = x1 - x0, dy = y1 - y0;
  int32_t longest = abs(dx) > abs(dy) ? abs(dx) : abs(dy);
  sg_raster r;
  bool ok = sg_raster_open(&r, 64, 64) &&
            sg_raster_chain(&r, &solid, 2, (const int32_t(*)[2])line, NULL) &&
            count(&r) == (unsigned)longest + 1 && at(&r, x0, y0) &&
            at(&r, x1, y1);

  for (int32_t y = 0; y < 64 && ok; y++) {
    for (int32_t x = 0; x < 64 && ok; x++) {
      int32_t off = abs((x - x0) * dy - (y - y0) * dx);

      ok = !at(&r, x, y) || 2 * off <= longest;
    }
  }
  sg_raster_clear(&r);
  return ok;
}

static bool
random_lines(unsigned n)
{
  while (n-- > 0) {
    int32_t x0 = random_below(64), y0 = random_below(64);
    int32_t x1 = random_below(64), y1 = random_below(64);

    if (!is_nearest(x0, y0, x1, y1)) {
      fprintf(stderr, "line %d,%d %d,%d\n", x0, y0, x1, y1);
      return false;
    }
  }
  return true;
}

/* The dots of one row after drawing a chain along it, as text. */
static bool
row_is(const int32_t *run, size_t runs, size_t n, const int32_t (*point)[2],
       const char *want)
{
  sg_pen pen = {1, 1, runs, run};
  sg_raster r;
  int32_t width = (int32_t)strlen(want);
  bool ok =
      sg_raster_open(&r, width, 1) && sg_raster_chain(&r, &pen, n, point, NULL);

  for (int32_t x = 0; x < width && ok; x++) {
    ok = (at(&r, x, 0) != 0) == (want[x] == '#');
  }
  sg_raster_clear(&r);
  return ok;
}

static void
patterns(void)
{
  static const int32_t three[] = {3, 3}, dot_dash[] = {4, 1, 1, 1};
  static const int32_t line[][2] = {{0, 0}, {13, 0}};
  static const int32_t joints[][2] = {{0, 0}, {1, 0}, {2, 0},
                                      {2, 0}, {7, 0}, {13, 0}};
  static const int32_t from_outside[][2] = {{-4, 0}, {13, 0}};
  static const int32_t point[][2] = {{2, 0}};

  CHECK("solid", row_is(NULL, 0, 2, line, "##############"));
  CHECK("pattern 3", row_is(three, 2, 2, line, "###...###...##"));
  CHECK("phase over joints", row_is(three, 2, 6, joints, "###...###...##"));
  CHECK("dash and dot", row_is(dot_dash, 4, 2, line, "####.#.####.#."));
  CHECK("dots outside count",
        row_is(three, 2, 2, from_outside, "..###...###..."));
  CHECK("a point", row_is(three, 2, 1, point, "..#..."));
  CHECK("nothing", row_is(three, 2, 0, NULL, "......"));
}

static void
pens(void)
{
  static const int32_t point[][2] = {{8, 8}}, line[][2] = {{4, 8}, {12, 8}};
  static const int32_t odd[] = {3}, zero[] = {3, 0};
  static const unsigned disc[] = {1, 4, 9, 12, 21};
  sg_raster r;

  for (int32_t w = 1; w <= 5; w++) {
    sg_pen pen = {7, w, 0, NULL};

    CHECK("open", sg_raster_open(&r, 17, 17));
    CHECK("drawn", sg_raster_chain(&r, &pen, 1, point, NULL));
    CHECK("nib", count(&r) == disc[w - 1] && at(&r, 8, 8) == 7);
    sg_raster_clear(&r);
  }
  CHECK("open", sg_raster_open(&r, 17, 17));
  CHECK("first ink", sg_raster_chain(&r, &solid, 2, line, NULL));
  CHECK("later ink",
        sg_raster_chain(&r, &(sg_pen){2, 1, 0, NULL}, 1, point, NULL));
  CHECK("later wins", at(&r, 8, 8) == 2 && at(&r, 7, 8) == 1);
  sg_raster_clear(&r);
  CHECK("odd pattern", !sg_pen_is_valid(&(sg_pen){1, 1, 1, odd}));
  CHECK("empty run", !sg_pen_is_valid(&(sg_pen){1, 1, 2, zero}));
  CHECK("no nib", !sg_pen_is_valid(&(sg_pen){1, 0, 0, NULL}));
  CHECK("no size", !sg_raster_size_is_valid(0, 5));
  CHECK("too many dots", !sg_raster_size_is_valid(16384, 16384));
}

static bool
ask_stop(void *data)
{
  ++*(int *)data;
  return true;
}

static void
stops(void)
{
  static int32_t far[9][2];
  int asked = 0;
  sg_cancel cancel = {ask_stop, &asked};
  sg_raster r;

  for (int i = 0; i < 9; i++) {
    far[i][0] = i % 2 ? SG_RASTER_FAR : -SG_RASTER_FAR;
  }
  CHECK("open", sg_raster_open(&r, 8, 8));
  CHECK("stops",
        !sg_raster_chain(&r, &solid, 9, (const int32_t(*)[2])far, &cancel));
  CHECK("at once", asked == 1);
  sg_raster_clear(&r);
}

static size_t
number(const uint8_t *b)
{
  return (size_t)b[0] << 24 | (size_t)b[1] << 16 | (size_t)b[2] << 8 | b[3];
}

/* The next chunk at *file, of type `type`, its check sum tried; its length. */
static bool
chunk(const uint8_t **file, const uint8_t *end, const char *type,
      const uint8_t **data, size_t *n)
{
  const uint8_t *b = *file;

  if (end - b < 12 || memcmp(b + 4, type, 4) != 0) {
    return false;
  }
  *n = number(b);
  *data = b + 8;
  *file = b + 12 + *n;
  return *file <= end && number(b + 8 + *n) == crc32(0, b + 4, (uInt)(*n + 4));
}

/* Unpacks the file's dots and compares them with the raster's. */
static bool
dots_agree(const sg_raster *r, unsigned bits, const uint8_t *data, size_t n)
{
  size_t stride = 1 + ((size_t)r->width * bits + 7) / 8;
  uLongf length = stride * (size_t)r->height;
  uint8_t *lines = malloc(length);
  bool ok = lines && uncompress(lines, &length, data, n) == Z_OK &&
            length == stride * (size_t)r->height;

  for (int32_t y = 0; y < r->height && ok; y++) {
    const uint8_t *line = lines + (size_t)y * stride;

    ok = line[0] == 0;
    for (int32_t x = 0; x < r->width && ok; x++) {
      unsigned bit = (unsigned)x * bits;
      unsigned dot = (unsigned)line[1 + bit / 8] >> (8 - bits - bit % 8);

      ok = (dot & ((1u << bits) - 1)) == at(r, x, y);
    }
  }
  free(lines);
  return ok;
}

static bool
file_agrees(const sg_raster *r, size_t colours, unsigned bits,
            const uint8_t *file, size_t length)
{
  const uint8_t *end = file + length, *data;
  size_t n;

  if (length < 8 || memcmp(file, "\211PNG\r\n\032\n", 8) != 0) {
    return false;
  }
  file += 8;
  return chunk(&file, end, "IHDR", &data, &n) && n == 13 &&
         number(data) == (size_t)r->width &&
         number(data + 4) == (size_t)r->height && data[8] == bits &&
         data[9] == 3 && chunk(&file, end, "PLTE", &data, &n) &&
         n == 3 * colours && chunk(&file, end, "IDAT", &data, &n) &&
         dots_agree(r, bits, data, n) && chunk(&file, end, "IEND", &data, &n) &&
         n == 0 && file == end;
}

/* Random dots written, read back, written again. */
static bool
round_trip(int32_t width, int32_t height, size_t colours, unsigned bits)
{
  static sg_colour palette[256];
  sg_raster r;
  uint8_t *one = NULL, *two = NULL;
  size_t n, m;
  bool ok = sg_raster_open(&r, width, height);

  for (int32_t i = 0; i < width * height && ok; i++) {
    r.dot[i] = (uint8_t)random_below((int32_t)colours);
  }
  ok = ok &&
       sg_png_write(&r, colours, (const sg_colour *)palette, NULL, &one, &n) ==
           SG_PNG_OK &&
       sg_png_write(&r, colours, (const sg_colour *)palette, NULL, &two, &m) ==
           SG_PNG_OK &&
       n == m && memcmp(one, two, n) == 0 &&
       file_agrees(&r, colours, bits, one, n);
  free(one);
  free(two);
  sg_raster_clear(&r);
  return ok;
}

static void
files(void)
{
  static const sg_colour palette[2] = {{255, 255, 255}, {0, 0, 0}};
  int asked = 0;
  sg_cancel cancel = {ask_stop, &asked};
  sg_raster r;
  uint8_t *bytes;
  size_t n;

  CHECK("one dot", round_trip(1, 1, 1, 1));
  CHECK("two colours", round_trip(61, 13, 2, 1));
  CHECK("three colours", round_trip(61, 13, 3, 2));
  CHECK("five colours", round_trip(61, 13, 5, 4));
  CHECK("all colours", round_trip(61, 13, 256, 8));
  CHECK("the paper's size", round_trip(640, 400, 5, 4));
  CHECK("open", sg_raster_open(&r, 640, 400));
  CHECK("blank", sg_png_write(&r, 2, palette, NULL, &bytes, &n) == SG_PNG_OK);
  CHECK("is small", n < 200);
  free(bytes);
  CHECK("stopped",
        sg_png_write(&r, 2, palette, &cancel, &bytes, &n) == SG_PNG_STOPPED);
  CHECK("nothing left", !bytes && asked == 1);
  r.dot[5] = 2;
  CHECK("no colour",
        sg_png_write(&r, 2, palette, NULL, &bytes, &n) == SG_PNG_NO_COLOUR);
  sg_raster_clear(&r);
}

int
main(void)
{
  CHECK("nearest dots", random_lines(3000));
  patterns();
  pens();
  stops();
  files();
  return check_report();
}
