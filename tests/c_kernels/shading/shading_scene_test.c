/* shading_scene_test.c -- what is seen, against rays: random trees of boxes,
 * balls, cylinders, cones and tori, turned anyhow, in both projections. The
 * rays know solids by inequalities in the model, and share nothing with slices.
 *
 * covers: span
 */
#include "shading/shading_scene.h"

#include "number/vector.h"
#include "tests/check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LEAVES = 6, SIDE = 64 };

typedef enum shape { BOX, BALL, TAPERED, RING, SHAPES } shape;

/* Between h = 0 and 1, or -1 and 1 along the frame. */
typedef struct body {
  shape is;
  double frame[4][3], row[3][3], k;
} body;

static uint32_t seed = 7;

static double
uniform(double from, double to)
{
  return from + (to - from) * (check_below(&seed, 10007) + 0.37) / 10008;
}

static void
turn(double axis[3][3])
{
  double q[4];

  for (int i = 0; i < 4; i++) {
    q[i] = uniform(-1, 1);
  }
  double n = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  double w = q[0] / n, x = q[1] / n, y = q[2] / n, z = q[3] / n;
  const double r[3][3] = {
      {1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
      {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
      {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
  memcpy(axis, r, sizeof r);
}

static body
some_body(void)
{
  body b = {.is = (shape)check_below(&seed, SHAPES), .k = uniform(0, 2)};
  double axis[3][3];

  turn(axis);
  for (int k = 0; k < 3; k++) {
    b.frame[0][k] = uniform(-1, 1);
  }
  b.k = b.is == RING ? 0.05 + 0.45 * b.k : b.k;
  for (int i = 0; i < 3; i++) {
    double size = uniform(0.5, 2);
    for (int k = 0; k < 3; k++) {
      b.frame[i + 1][k] = axis[i][k] * size;
      b.row[i][k] = axis[i][k] / size;
    }
  }
  return b;
}

static bool
is_inside(const body *b, const double p[3])
{
  double d[3], x[3];

  sg_minus(p, b->frame[0], d);
  for (int i = 0; i < 3; i++) {
    x[i] = sg_dot(b->row[i], d);
  }
  double r = 1 - x[2] + x[2] * b->k, off = sqrt(x[0] * x[0] + x[1] * x[1]) - 1;

  if (b->is == RING) {
    return off * off + x[2] * x[2] < b->k * b->k;
  }
  return b->is == BOX ? fabs(x[0]) < 1 && fabs(x[1]) < 1 && fabs(x[2]) < 1
         : b->is == BALL
             ? sg_dot(x, x) < 1
             : x[2] > 0 && x[2] < 1 && x[0] * x[0] + x[1] * x[1] < r * r;
}

static bool
add_body(sg_shading *s, const body *b)
{
  static const int side[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                 {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  sg_shading_piece piece = {.sphere = b->is == BALL,
                            .k = b->k,
                            .high = 1,
                            .low_face = b->is == BALL ? -1 : 1,
                            .high_face = b->is == BALL ? -1 : 2,
                            .face = 3};
  const size_t four = 4;
  bool good = true;

  memcpy(piece.frame, b->frame, sizeof piece.frame);
  if (b->is == RING) {
    sg_shading_ring ring = {.k = b->k, .face = 3};
    memcpy(ring.frame, b->frame, sizeof ring.frame);
    return sg_shading_add_ring(s, &ring) == SG_SHADING_GOOD;
  }
  if (b->is != BOX) {
    return sg_shading_add_piece(s, &piece) == SG_SHADING_GOOD;
  }
  for (int32_t f = 0; f < 6; f++) {
    uint32_t corner[4];
    for (int i = 0; i < 4; i++) {
      double p[3];
      for (int k = 0; k < 3; k++) {
        p[k] = b->frame[0][k];
        for (int a = 0; a < 3; a++) {
          p[k] += (side[f][i] >> a & 1 ? 1 : -1) * b->frame[a + 1][k];
        }
      }
      good = good && sg_shading_add_corner(s, p, &corner[i]) == SG_SHADING_GOOD;
    }
    good = good && sg_shading_add_polygon(s, f + 1, corner, &four, 1) ==
                       SG_SHADING_GOOD;
  }
  return good;
}

/* The tree: (0 and 1) or (2 less 3 less 4) or 5; or the like. */
static bool
holds(int kind, const bool in[LEAVES])
{
  return kind == 0 ? (in[0] && in[1]) || (in[2] && !in[3] && !in[4]) || in[5]
         : kind == 1
             ? in[0] && !(in[1] && !in[2]) && !in[3] && !(in[4] || in[5])
             : (in[0] || in[1] || in[2]) && (in[3] || in[4] || in[5]);
}

static void
add_leaves(sg_shading *s, size_t at, sg_operation operation, uint32_t from,
           uint32_t to)
{
  size_t node = sg_shading_add_node(s, at, operation, 0);

  for (; from <= to; from++) {
    sg_shading_add_node(s, node, SG_LEAF, from);
  }
}

static void
add_tree(sg_shading *s, int kind)
{
  sg_shading_add_root(s, 1);
  size_t top = sg_shading_add_node(s, 0,
                                   kind == 0   ? SG_UNION
                                   : kind == 1 ? SG_DIFFERENCE
                                               : SG_INTERSECTION,
                                   0);

  if (kind == 0) {
    add_leaves(s, top, SG_INTERSECTION, 0, 1);
    add_leaves(s, top, SG_DIFFERENCE, 2, 4);
    sg_shading_add_node(s, top, SG_LEAF, 5);
  } else if (kind == 1) {
    sg_shading_add_node(s, top, SG_LEAF, 0);
    add_leaves(s, top, SG_DIFFERENCE, 1, 2);
    sg_shading_add_node(s, top, SG_LEAF, 3);
    add_leaves(s, top, SG_UNION, 4, 5);
  } else {
    add_leaves(s, top, SG_UNION, 0, 2);
    add_leaves(s, top, SG_UNION, 3, 5);
  }
}

/* The eye looks along -z from 12, or in parallel: where a point of the ray
 * through (x, y) is. Dots: 16 a unit, at z = 0. */
static void
on_ray(bool central, double x, double y, double t, double out[3])
{
  double z = 6 - t, w = central ? (12 - z) / 12 : 1;

  out[0] = (x - SIDE / 2.0) / 8 * w;
  out[1] = -(y - SIDE / 2.0) / 8 * w;
  out[2] = z;
}

static sg_shading *
open_scene(bool central)
{
  const double half = SIDE / 2.0;
  sg_shading_frame f = {.matrix = {{8, 0, 0, half},
                                   {0, -8, 0, half},
                                   {0, 0, -8, 0},
                                   {0, 0, 0, 1}},
                        .width = SIDE,
                        .height = SIDE,
                        .tolerance = 1e-9};
  if (central) {
    f.matrix[3][2] = -1.0 / 12;
    f.matrix[0][2] = f.matrix[1][2] = -half / 12;
  }
  return sg_shading_open(&f);
}

/* How far along the ray the tree begins to hold, by steps and then by halves;
 * NAN: it does not. */
static double
first_inside(const body b[LEAVES], int kind, bool central, double x, double y)
{
  enum { STEPS = 3000 };
  double p[3], low = 0, high = 12;
  bool in[LEAVES], found = false;

  for (int i = 0; i < STEPS && !found; i++) {
    high = 12.0 * i / STEPS;
    on_ray(central, x, y, high, p);
    for (int k = 0; k < LEAVES; k++) {
      in[k] = is_inside(&b[k], p);
    }
    found = holds(kind, in);
    low = found ? low : high;
  }
  for (int i = 0; i < 40 && found; i++) {
    double t = (low + high) / 2;
    on_ray(central, x, y, t, p);
    for (int k = 0; k < LEAVES; k++) {
      in[k] = is_inside(&b[k], p);
    }
    *(holds(kind, in) ? &high : &low) = t;
  }
  return found ? high : NAN;
}

/* Where the spans say that it is seen; NAN: it is not; INFINITY: near an end,
 * where it may be either. */
static double
seen_at(const sg_shading *s, const sg_spans *spans, bool central, double x,
        double y)
{
  double depth, normal[3];

  for (size_t i = 0; i < spans->n; i++) {
    const sg_span *span = &spans->span[i];
    if (fabs(span->x1 - x * 256) < 3 || fabs(span->x2 - x * 256) < 3) {
      return INFINITY;
    }
    if (span->x1 < x * 256 && x * 256 < span->x2) {
      sg_shading_point(s, span, x, y, &depth, normal);
      /* -8 z / w = depth, w = 1 - z / 12 */
      return central ? 6 - depth / (depth / 12 - 8) : 6 + depth / 8;
    }
  }
  return NAN;
}

static unsigned asked, wrong, seen;

static void
compare_line(const sg_shading *s, sg_shading_work *work, const body b[LEAVES],
             int kind, bool central, double y)
{
  static sg_spans spans;

  CHECK("a line", sg_shading_line(s, work, y, &spans));
  for (int i = 0; i < SIDE; i += 3) {
    double x = i + 0.43, t = seen_at(s, &spans, central, x, y);
    double ray = first_inside(b, kind, central, x, y);
    if (isinf(t)) {
      continue;
    }
    asked++;
    seen += isnan(t) ? 0U : 1U;
    wrong += isnan(t) != isnan(ray) || fabs(t - ray) > 1e-6 ? 1U : 0U;
  }
}

int
main(void)
{
  for (int i = 0; i < 60; i++) {
    bool central = i % 2 == 1;
    int kind = i / 2 % 3;
    sg_shading *s = open_scene(central);
    body b[LEAVES];

    for (int k = 0; k < LEAVES; k++) {
      b[k] = some_body();
      CHECK("a leaf",
            sg_shading_add_leaf(s, k + 1) == (uint32_t)k && add_body(s, &b[k]));
    }
    add_tree(s, kind);
    CHECK("sealed", sg_shading_seal(s, NULL) == SG_SHADING_GOOD);
    sg_shading_work *work = sg_shading_work_open(s, NULL);
    for (double y = 8.3; y < SIDE; y += 9) {
      compare_line(s, work, b, kind, central, y);
    }
    sg_shading_work_close(work);
    sg_shading_close(s);
  }
  printf("%u places, %u seen, %u wrong\n", asked, seen, wrong);
  CHECK("many places are asked, many are seen", asked > 5000 && seen > 800);
  CHECK("rays see the same, but for slivers between their steps",
        wrong <= asked / 500);
  return check_report();
}
