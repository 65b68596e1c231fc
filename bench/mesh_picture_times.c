/* mesh_picture_times.c -- a mesh of a million triangles, one leaf, as a shaded
 * picture of 1920 x 1080 dots on one processor, beside a buffer of depths that
 * draws the same triangles, one dot at a time: processor seconds, least of
 * three. Both with one line to a dot, and with four (the buffer: four rows to
 * one).
 */
#include "shading/buffer.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#ifndef BANDS
#define BANDS 500
#endif

enum { HIGH = BANDS, ROUND = 2 * BANDS, WIDE = 1920, TALL = 1080 };

typedef struct mesh {
  double (*corner)[3];
  size_t (*triangle)[3];
  size_t triangles;
} mesh;

static void *
must(void *memory)
{
  if (!memory) {
    abort();
  }
  return memory;
}

static double
seconds(void)
{
  return (double)clock() / CLOCKS_PER_SEC;
}

/* A ball with bumps; poles as rows of corners. In dots. */
static mesh
bumpy_ball(void)
{
  const double pi = acos(-1.0);
  mesh m = {must(malloc((HIGH + 1) * ROUND * sizeof *m.corner)),
            must(malloc(2 * HIGH * ROUND * sizeof *m.triangle)), 0};

  for (size_t i = 0; i <= HIGH; i++) {
    for (size_t j = 0; j < ROUND; j++) {
      double u = pi * (double)i / HIGH, v = 2 * pi * (double)j / ROUND;
      double r = 500 * (1 + 0.03 * sin(17 * u) * cos(23 * v));
      double *p = m.corner[i * ROUND + j];
      p[0] = 960 + r * sin(u) * cos(v);
      p[1] = 540 + r * cos(u);
      p[2] = r * sin(u) * sin(v);
    }
  }
  for (size_t i = 0; i < HIGH; i++) {
    for (size_t j = 0; j < ROUND; j++) {
      size_t a = i * ROUND + j, b = i * ROUND + (j + 1) % ROUND;
      size_t t[2][3] = {{a, b, b + ROUND}, {a, b + ROUND, a + ROUND}};
      memcpy(m.triangle[m.triangles], t, sizeof t);
      m.triangles += 2;
    }
  }
  return m;
}

/* ---- the picture ---- */

static sg_shading *
scene_of(const mesh *m)
{
  const sg_shading_frame frame = {
      .matrix = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}},
      .width = WIDE,
      .height = TALL,
      .tolerance = 1e-9};
  const size_t three = 3;
  sg_shading *scene = must(sg_shading_open(&frame));
  size_t corners = (HIGH + 1) * ROUND;
  uint32_t *corner = must(malloc(corners * sizeof *corner));
  bool good = sg_shading_add_leaf(scene, 1) == 0;

  for (size_t i = 0; good && i < corners; i++) {
    good = sg_shading_add_corner(scene, m->corner[i], &corner[i]) ==
           SG_SHADING_GOOD;
  }
  for (size_t t = 0; good && t < m->triangles; t++) {
    const size_t *of = m->triangle[t];
    const uint32_t p[3] = {corner[of[0]], corner[of[1]], corner[of[2]]};
    good = sg_shading_add_polygon(scene, (int32_t)t + 1, p, &three, 1) ==
           SG_SHADING_GOOD;
  }
  free(corner);
  if (!good || !sg_shading_add_root(scene, 1) ||
      sg_shading_add_node(scene, 0, SG_LEAF, 0) == SIZE_MAX ||
      sg_shading_seal(scene, NULL) != SG_SHADING_GOOD) {
    abort();
  }
  return scene;
}

static void
lit(sg_face_look *look)
{
  look->tones.ways = 1;
  look->tones.way[0] = (sg_tone_way){{-0.5, -0.6, -0.62}, 1, 0};
  for (size_t k = 0; k < SG_RAMP + 2; k++) {
    for (int c = 0; c < 3; c++) {
      look->ramp.light[k][c] = (uint16_t)(k * 60);
    }
  }
}

static double
picture(const mesh *m, unsigned lines)
{
  static sg_face_look look;
  const uint32_t first[] = {0, 0, 1}, of[] = {0};
  double start = seconds();
  sg_shading *scene = scene_of(m);
  sg_shaded in = {
      .scene = scene, .lines = lines, .looks = {&look, {first, of}}};
  sg_image *image;

  lit(&look);
  if (sg_shade(&in, NULL, NULL, &image) != SG_SHADING_GOOD) {
    abort();
  }
  sg_image_close(image);
  sg_shading_close(scene);
  return seconds() - start;
}

/* ---- the buffer of depths ---- */

typedef struct buffer {
  double *depth;
  float *tone;
  int32_t rows;
} buffer;

static double
tone_of(double p[3][3])
{
  double u[3], v[3], n[3];

  for (int k = 0; k < 3; k++) {
    u[k] = p[1][k] - p[0][k];
    v[k] = p[2][k] - p[0][k];
  }
  n[0] = u[1] * v[2] - u[2] * v[1];
  n[1] = u[2] * v[0] - u[0] * v[2];
  n[2] = u[0] * v[1] - u[1] * v[0];
  double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  double tone = -(0.5 * n[0] + 0.6 * n[1] + 0.62 * n[2]);

  return length > 0 ? fabs(tone) / length : 0;
}

static void
draw(buffer *b, double p[3][3])
{
  double area = (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) -
                (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]);
  double x1 = fmin(p[0][0], fmin(p[1][0], p[2][0]));
  double x2 = fmax(p[0][0], fmax(p[1][0], p[2][0]));
  double y1 = fmin(p[0][1], fmin(p[1][1], p[2][1]));
  double y2 = fmax(p[0][1], fmax(p[1][1], p[2][1]));
  float tone = (float)tone_of(p);

  for (int32_t y = (int32_t)fmax(y1 - 0.5, 0); y < b->rows && y + 0.5 <= y2;
       y++) {
    for (int32_t x = (int32_t)fmax(x1 - 0.5, 0); x < WIDE && x + 0.5 <= x2;
         x++) {
      double w[3], px = x + 0.5, py = y + 0.5;
      for (int k = 0; k < 3; k++) {
        const double *a = p[(k + 1) % 3], *c = p[(k + 2) % 3];
        w[k] = ((a[0] - px) * (c[1] - py) - (c[0] - px) * (a[1] - py)) / area;
      }
      double z = w[0] * p[0][2] + w[1] * p[1][2] + w[2] * p[2][2];
      size_t at = (size_t)y * WIDE + (size_t)x;
      if (w[0] >= 0 && w[1] >= 0 && w[2] >= 0 && z < b->depth[at]) {
        b->depth[at] = z;
        b->tone[at] = tone;
      }
    }
  }
}

static double
buffered(const mesh *m, unsigned lines)
{
  double start = seconds();
  size_t n = (size_t)WIDE * TALL * lines;
  buffer b = {must(malloc(n * sizeof *b.depth)),
              must(malloc(n * sizeof *b.tone)), (int32_t)(TALL * lines)};

  for (size_t i = 0; i < n; i++) {
    b.depth[i] = INFINITY;
  }
  for (size_t t = 0; t < m->triangles; t++) {
    double p[3][3];
    for (int k = 0; k < 3; k++) {
      memcpy(p[k], m->corner[m->triangle[t][k]], sizeof p[k]);
      p[k][1] *= lines;
    }
    draw(&b, p);
  }
  free(b.depth);
  free(b.tone);
  return seconds() - start;
}

int
main(void)
{
  mesh m = bumpy_ball();

  printf("%zu triangles, one leaf, 1920x1080\n%-6s %8s %8s %8s\n", m.triangles,
         "lines", "picture", "buffer", "ratio");
  for (unsigned lines = 1; lines <= 4; lines *= 4) {
    double least[2] = {INFINITY, INFINITY};
    for (int i = 0; i < 3; i++) {
      least[0] = fmin(least[0], picture(&m, lines));
      least[1] = fmin(least[1], buffered(&m, lines));
    }
    printf("%-6u %8.2f %8.2f %8.2f\n", lines, least[0], least[1],
           least[0] / least[1]);
  }
  free(m.corner);
  free(m.triangle);
  return 0;
}
