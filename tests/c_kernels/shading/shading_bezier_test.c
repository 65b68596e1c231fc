/* shading_bezier_test.c -- pictures of Bezier patches, against their points:
 * one patch and two that meet, of any size in the picture, in both projections.
 */
#include "shading/shading_scene.h"

#include "picture/bezier_patch.h"
#include "tests/check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 200, TIMES = 2000 };

static uint32_t seed = 5;

static double
uniform(double from, double to)
{
  return from + (to - from) * check_below(&seed, 10000) / 10000;
}

/* Over the square of side 3 whose corner is x, y; border points of neighbours
 * are the same. Heights of up to `high`, so it is never steep. */
static void
patch_init(sg_shading_patch *patch, int x, double high, int32_t face)
{
  patch->face = face;
  for (int i = 0; i < 16; i++) {
    double u = x + i % 4, v = i / 4;
    const double p[3] = {u, v, high * sin(1.7 * u + 0.4) * cos(1.3 * v)};
    memcpy(patch->control[i], p, sizeof p);
  }
}

/* The same patch, its rows the other way, u and v exchanged. */
static void
turn_patch(sg_shading_patch *patch)
{
  sg_shading_patch old = *patch;

  for (int i = 0; i < 16; i++) {
    memcpy(patch->control[i], old.control[4 * (3 - i % 4) + i / 4],
           sizeof old.control[i]);
  }
}

/* Seen along -z: the model point `at` is in the middle, `scale` dots a unit;
 * `away`: so far from the eye, 0: infinitely. */
static sg_shading_frame
frame_at(const double at[2], double scale, double away)
{
  sg_shading_frame f = {.width = SIDE, .height = SIDE, .tolerance = 1e-9};
  double m = SIDE / 2.0, w = away > 0 ? -1.0 / away : 0.0;
  const double matrix[4][4] = {{scale, 0, m * w, m - scale * at[0]},
                               {0, scale, m * w, m - scale * at[1]},
                               {0, 0, -scale, 0},
                               {0, 0, w, 1}};

  memcpy(f.matrix, matrix, sizeof matrix);
  return f;
}

static sg_shading *
scene_of(const sg_shading_frame *frame, const sg_shading_patch *patch, size_t n)
{
  sg_shading *s = sg_shading_open(frame);

  if (!s || sg_shading_add_leaf(s, 1) == UINT32_MAX ||
      sg_shading_add_net(s, patch, n) != SG_SHADING_GOOD ||
      !sg_shading_add_root(s, 1) ||
      sg_shading_add_node(s, 0, SG_LEAF, 0) == SIZE_MAX ||
      sg_shading_seal(s, NULL) != SG_SHADING_GOOD) {
    abort();
  }
  return s;
}

static void
point_at(const sg_shading_patch *patch, double u, double v, double out[3])
{
  const size_t n = 1 << 30;
  double weight[4], row[4][3];

  sg_bezier_weights((size_t)(v * (double)n), n, weight);
  sg_bezier_row(patch->control, weight, row);
  sg_bezier_weights((size_t)(u * (double)n), n, weight);
  sg_bezier_point((const double(*)[3])row, weight, out);
}

/* Where a model point is in the picture. False: not in it. */
static bool
seen_at(const sg_shading_frame *f, const double p[3], double out[3])
{
  double h[4];

  for (int i = 0; i < 4; i++) {
    const double *m = f->matrix[i];
    h[i] = m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3];
  }
  for (int k = 0; k < 3; k++) {
    out[k] = h[k] / h[3];
  }
  return out[0] > 1 && out[0] < SIDE - 1 && out[1] > 1 && out[1] < SIDE - 1;
}

/* How much farther than a point of the patch the picture is there, in dots;
 * infinite where nothing is seen, or another face. */
static double
off_at(const sg_shading *s, sg_shading_work *work, const double at[3],
       int32_t face)
{
  sg_spans spans = {0};
  double depth, normal[3], off = INFINITY;

  if (!sg_shading_line(s, work, at[1], &spans)) {
    abort();
  }
  for (size_t i = 0; i < spans.n; i++) {
    const sg_span *span = &spans.span[i];
    if (span->x1 <= at[0] * 256 && at[0] * 256 < span->x2 &&
        (face == 0 || span->face == face)) {
      sg_shading_point(s, span, at[0], at[1], &depth, normal);
      off = fabs(depth - at[2]);
    }
  }
  free(spans.span);
  return off;
}

/* The most that places of patches are off. */
static double
worst(const sg_shading_frame *frame, const sg_shading_patch *patch, size_t n)
{
  sg_shading *s = scene_of(frame, patch, n);
  sg_shading_work *work = sg_shading_work_open(s, NULL);
  double most = 0.0, p[3], at[3];
  int found = 0;

  for (int i = 0; work && i < 400 * TIMES && found < TIMES; i++) {
    size_t k = (size_t)check_below(&seed, (int)n);
    double u = uniform(0.001, 0.999), v = uniform(0.001, 0.999);
    point_at(&patch[k], u, v, p);
    if (seen_at(frame, p, at)) {
      most = fmax(most, off_at(s, work, at, patch[k].face));
      found++;
    }
  }
  sg_shading_work_close(work);
  sg_shading_close(s);
  return found > 40 ? most : INFINITY;
}

/* A facet is an eighth of a dot from the surface; in depth that is more, as it
 * is not seen from above. */
static void
test_sizes(void)
{
  sg_shading_patch patch;
  double flat;

  patch_init(&patch, 0, 0.5, 7);
  for (double scale = 1; scale < 1000; scale *= 3) {
    const sg_shading_frame all =
        frame_at((const double[2]){1.5, 1.5}, scale, 0);
    CHECK("parallel, of any size", worst(&all, &patch, 1) < 0.2);
    const sg_shading_frame near =
        frame_at((const double[2]){1.5, 1.5}, scale, 8);
    CHECK("central, of any size", worst(&near, &patch, 1) < 0.2);
  }
  patch_init(&patch, 0, 0.0, 7);
  const sg_shading_frame all = frame_at((const double[2]){1.5, 1.5}, 50, 0);
  flat = worst(&all, &patch, 1);
  CHECK("a flat one", flat < 1e-9);
}

/* The border of two patches, one of them turned, has no gaps. */
static void
test_border(void)
{
  sg_shading_patch patch[2];
  double p[3], at[3];
  int open = 0;

  patch_init(&patch[0], 0, 0.8, 1);
  patch_init(&patch[1], 3, 0.8, 2);
  turn_patch(&patch[1]);
  const sg_shading_frame f = frame_at((const double[2]){3, 1.5}, 60.3, 9);
  sg_shading *s = scene_of(&f, patch, 2);
  sg_shading_work *work = sg_shading_work_open(s, NULL);

  for (int i = 1; work && i < TIMES; i++) {
    point_at(&patch[0], 1, (double)i / TIMES, p);
    open += seen_at(&f, p, at) && isinf(off_at(s, work, at, 0));
  }
  CHECK("no gap between two patches", work && open == 0);
  CHECK("both are there", worst(&f, patch, 2) < 0.2);
  sg_shading_work_close(work);
  sg_shading_close(s);
}

/* The box reaches as far as the surface, and hardly farther. */
static void
test_box(void)
{
  sg_shading_patch patch;
  const sg_shading_frame seen = frame_at((const double[2]){0, 0}, 10, 0);
  sg_shading_frame f = seen;
  double low[3], high[3], at[3], p[3], in[3] = {0, 0, 0};

  f.box = true;
  patch_init(&patch, 0, 2.0, 1);
  sg_shading *s = scene_of(&f, &patch, 1);
  CHECK("a box", sg_shading_box(s, low, high));
  double least[3] = {INFINITY, INFINITY, INFINITY};
  double most[3] = {-INFINITY, -INFINITY, -INFINITY};
  for (int i = 0; i < 200 * 200; i++) {
    point_at(&patch, i % 200 / 199.0, i / 200 / 199.0, p);
    (void)seen_at(&seen, p, at);
    for (int k = 0; k < 3; k++) {
      least[k] = fmin(least[k], at[k]);
      most[k] = fmax(most[k], at[k]);
    }
  }
  for (int k = 0; k < 3; k++) {
    in[k] = fmin(least[k] - low[k], high[k] - most[k]);
    CHECK("it holds the surface", in[k] >= 0);
    CHECK("and is tight", most[k] - least[k] > high[k] - low[k] - 0.1);
  }
  sg_shading_close(s);
}

/* Points that are not before the eye. */
static void
test_eye(void)
{
  sg_shading_patch patch;
  const sg_shading_frame f = frame_at((const double[2]){1.5, 1.5}, 10, 0.3);
  sg_shading *s = sg_shading_open(&f);

  patch_init(&patch, 0, 2.0, 1);
  CHECK("behind the eye",
        sg_shading_add_leaf(s, 1) != UINT32_MAX &&
            sg_shading_add_net(s, &patch, 1) == SG_SHADING_BEHIND_EYE);
  sg_shading_close(s);
}

int
main(void)
{
  test_sizes();
  test_border();
  test_box();
  test_eye();
  return check_report();
}
