/* flush_test.c -- surfaces of two kinds in one scene, in all numbers: more
 * planes than quadrics, and the other way round. Each tile and each ball is
 * seen where it is, and of those that are there twice, but for rounding, the
 * first.
 */
#include "shading/shading_scene.h"

#include "tests/check.h"

#include <math.h>
#include <stdlib.h>

enum { ACROSS = 32, CELL = 4 };

typedef struct sizes {
  int tiles, balls;
  bool twice;
} sizes;

/* Where the thing i stands: from the left, row by row. */
static void
place_of(int i, double at[2])
{
  at[0] = CELL * (i % ACROSS) + CELL / 2.0;
  at[1] = CELL * (i / ACROSS) + CELL / 2.0;
}

/* A square seen from the front, and its back, 1 behind it. Each has a depth of
 * its own. */
static bool
add_tile(sg_shading *s, int i, double off)
{
  const size_t four = 4;
  double at[2];
  bool good = true;

  place_of(i, at);
  for (int32_t f = 0; f < 2; f++) {
    uint32_t corner[4];
    for (int k = 0; k < 4; k++) {
      double x = k == 1 || k == 2 ? 1.5 : -1.5, y = k > 1 ? 1.5 : -1.5;
      double p[3] = {at[0] + x, at[1] + y, 10.0 + 0.5 * i + f + off};
      good = good && sg_shading_add_corner(s, p, &corner[f ? k : 3 - k]) ==
                         SG_SHADING_GOOD;
    }
    good = good && sg_shading_add_polygon(s, f + 1, corner, &four, 1) ==
                       SG_SHADING_GOOD;
  }
  return good;
}

static bool
add_ball(sg_shading *s, int i, double off)
{
  sg_shading_piece piece = {
      .sphere = true, .low_face = -1, .high_face = -1, .high = 1, .face = 1};
  double at[2];

  place_of(i, at);
  piece.frame[0][0] = at[0];
  piece.frame[0][1] = at[1];
  piece.frame[0][2] = 10.0 + 0.5 * i + off;
  for (int k = 0; k < 3; k++) {
    piece.frame[k + 1][k] = 1.5;
  }
  return sg_shading_add_piece(s, &piece) == SG_SHADING_GOOD;
}

/* One after the other, tiles and balls in turn as long as there are both; if it
 * is so wanted each twice, the second a little in front. Leaf 1 is the first.
 */
static sg_shading *
scene_of(const sizes *of)
{
  int n = of->tiles + of->balls, tiles = 0, balls = 0, copies = of->twice + 1;
  const sg_shading_frame frame = {
      .matrix = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}},
      .width = CELL * ACROSS,
      .height = CELL * (n / ACROSS + 1),
      .tolerance = 1e-9};
  sg_shading *s = sg_shading_open(&frame);
  bool good = s != NULL;

  for (int i = 0; good && i < n; i++) {
    bool tile = balls == of->balls || (tiles < of->tiles && i % 2 == 0);
    tiles += tile;
    balls += !tile;
    for (int k = 0; good && k < copies; k++) {
      double off = k * -1e-12;
      good = sg_shading_add_leaf(s, i * copies + k + 1) != UINT32_MAX &&
             (tile ? add_tile(s, i, off) : add_ball(s, i, off));
    }
  }
  good = good && sg_shading_add_root(s, 1);
  size_t top = good ? sg_shading_add_node(s, 0, SG_UNION, 0) : SIZE_MAX;
  for (uint32_t i = 0; good && i < (uint32_t)(n * copies); i++) {
    good = sg_shading_add_node(s, top, SG_LEAF, i) != SIZE_MAX;
  }
  CHECK("a scene", good && sg_shading_seal(s, NULL) == SG_SHADING_GOOD);
  return s;
}

/* Whether the thing i, the span, is seen whole and alone. */
static bool
is_thing(const sizes *of, int i, const sg_span *span)
{
  bool tile = i >= 2 * of->balls || (i < 2 * of->tiles && i % 2 == 0);
  double at[2], middle = (span->x1 + span->x2) / 512.0;

  place_of(i, at);
  return span->leaf == i * (of->twice + 1) + 1 && span->face == 1 &&
         span->x2 - span->x1 == 3 * 256 && fabs(middle - at[0]) < 1.0 / 256 &&
         (span->sense == 1 || !tile);
}

static void
seen(int tiles, int balls, bool twice)
{
  const sizes of = {tiles, balls, twice};
  int n = tiles + balls, good = 0;
  sg_shading *s = scene_of(&of);
  sg_shading_work *work = sg_shading_work_open(s, NULL);
  sg_spans spans = {0};

  for (int row = 0; row * ACROSS < n; row++) {
    int from = row * ACROSS, to = from + ACROSS < n ? from + ACROSS : n;

    CHECK("a line", sg_shading_line(s, work, CELL * row + CELL / 2.0, &spans));
    for (int i = from; i < to && spans.n == (size_t)(to - from); i++) {
      good += is_thing(&of, i, &spans.span[i - from]);
    }
  }
  if (good != n) {
    printf("%d tiles, %d balls: %d of %d\n", tiles, balls, good, n);
  }
  CHECK("each is seen once", good == n);
  free(spans.span);
  sg_shading_work_close(work);
  sg_shading_close(s);
}

int
main(void)
{
  static const int size[] = {0, 1, 2, 3, 5, 8, 13, 40, 200, 700};
  enum { SIZES = sizeof size / sizeof *size };

  for (int i = 0; i < SIZES; i++) {
    for (int j = 0; j < SIZES; j++) {
      seen(size[i], size[j], false);
      seen(size[i], size[j], true);
    }
  }
  return check_report();
}
