/* shading_ring.c -- a torus as facets made for the picture: none is farther
 * from it than an eighth of a dot, and each is seen with its true normals.
 */
#include "number/vector.h"
#include "shading_private.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Dots, of each of the two circles. */
#define FARTHEST 0.0625

/* Dots: where nothing is wanted but a box, each circle has as many facets as
 * one of this radius, in whatever unit, so a box is as exact at any scale. */
#define BOX_RADIUS 100.0

/* Facets round, at most. */
#define MOST 4096

/* What is near the eye is divided as if it were so many times as large as the
 * middle, at most. */
#define MOST_LARGER 16.0

#define TURN 6.283185307179586

/* The first quarters of polygons of 8, 12 and 20 sides, from which those of
 * more sides follow. */
enum { QUARTERS = 3, QUARTER_MOST = 5 };

typedef struct quarter {
  size_t n; /* corners */
  double at[QUARTER_MOST][2];
} quarter;

static void
fill_quarters(quarter q[QUARTERS])
{
  double h = sqrt(0.5), t = sqrt(0.75), f = sqrt(5.0);
  double c18 = sqrt(10.0 + 2.0 * f) / 4.0, s18 = (f - 1.0) / 4.0;
  double c36 = (f + 1.0) / 4.0, s36 = sqrt(10.0 - 2.0 * f) / 4.0;

  q[0] = (quarter){2, {{1, 0}, {h, h}}};
  q[1] = (quarter){3, {{1, 0}, {t, 0.5}, {0.5, t}}};
  q[2] = (quarter){5, {{1, 0}, {c18, s18}, {c36, s36}, {s36, c36}, {s18, c18}}};
}

/* Corners of a polygon of n sides, those of a quarter doubled a few times, that
 * has the area of the unit circle: each new one is half-way between two, so
 * square roots are enough. */
static void
fill_turn(double (*at)[2], size_t n, const quarter *q)
{
  size_t step = n / 4 / q->n;

  for (size_t i = 0; i < q->n; i++) {
    const double *p = q->at[i];
    const double turned[4][2] = {
        {p[0], p[1]}, {-p[1], p[0]}, {-p[0], -p[1]}, {p[1], -p[0]}};
    for (size_t k = 0; k < 4; k++) {
      memcpy(at[k * (n / 4) + i * step], turned[k], sizeof *at);
    }
  }
  for (; step > 1; step /= 2) {
    for (size_t i = 0; i < n; i += step) {
      const double *a = at[i], *b = at[(i + step) % n];
      double x = a[0] + b[0], y = a[1] + b[1], length = sqrt(x * x + y * y);
      at[i + step / 2][0] = x / length;
      at[i + step / 2][1] = y / length;
    }
  }
  double larger = sqrt(TURN / (double)n / at[1][1]);
  for (size_t i = 0; i < n; i++) {
    at[i][0] *= larger;
    at[i][1] *= larger;
  }
}

/* How far the corners of n sides, which are farther than the middles of the
 * sides, are from a circle of this radius, in dots. */
static double
away(double radius, size_t n)
{
  double angle = TURN / (double)n;

  return radius * angle * angle / 12.0;
}

/* The fewest parts of a circle of this radius, in dots, that are near enough,
 * and the quarter from which they follow. */
static size_t
parts_for(double radius, const quarter q[QUARTERS], const quarter **from)
{
  size_t best = 2 * MOST;

  for (size_t i = 0; i < QUARTERS; i++) {
    size_t n = 4 * q[i].n;
    while (n < MOST && away(radius, n) > FARTHEST) {
      n *= 2;
    }
    if (n < best) {
      best = n;
      *from = &q[i];
    }
  }
  return best;
}

/* Of a model vector at the torus, dots in the picture, at most. */
static double
dots(const sg_shading *s, const double v[3], double nearest)
{
  double out[3];

  for (int i = 0; i < 3; i++) {
    out[i] = sg_dot(s->frame.matrix[i], v);
  }
  return sg_length(out) / nearest;
}

typedef struct torus {
  const sg_shading_ring *ring;
  double (*round)[2], (*side)[2];
  size_t n, m;
} torus;

static void
point(const torus *t, size_t i, size_t j, double out[3])
{
  const double *a = t->round[i], *b = t->side[j];
  double r = 1.0 + t->ring->k * b[0];

  for (int c = 0; c < 3; c++) {
    out[c] = t->ring->frame[0][c] + r * a[0] * t->ring->frame[1][c] +
             r * a[1] * t->ring->frame[2][c] +
             t->ring->k * b[1] * t->ring->frame[3][c];
  }
}

static sg_shading_end
add_corners(sg_shading *s, const torus *t, uint32_t *corner)
{
  sg_shading_end end = SG_SHADING_GOOD;
  double p[3];

  for (size_t k = 0; end == SG_SHADING_GOOD && k < t->n * t->m; k++) {
    point(t, k / t->m, k % t->m, p);
    end = sg_shading_add_corner(s, p, &corner[k]);
  }
  return end;
}

/* Counter-clockwise seen from outside, of a frame that is right-handed. */
static sg_shading_end
add_facets(sg_shading *s, const torus *t, bool turned, const uint32_t *corner)
{
  sg_shading_end end = SG_SHADING_GOOD;
  const size_t four = 4;

  for (size_t k = 0; end == SG_SHADING_GOOD && k < t->n * t->m; k++) {
    size_t i = k / t->m, j = k % t->m;
    size_t here = i * t->m, next = (i + 1) % t->n * t->m, up = (j + 1) % t->m;
    uint32_t of[4] = {corner[here + j], corner[(turned ? here + up : next + j)],
                      corner[next + up],
                      corner[(turned ? next + j : here + up)]};

    end = sg_shading_add_polygon(s, t->ring->face, of, &four, 1);
  }
  return end;
}

sg_shading_end
sg_shading_add_ring(sg_shading *s, const sg_shading_ring *ring)
{
  const double(*f)[3] = ring->frame;
  torus t = {.ring = ring};
  double middle = sg_dot(s->frame.matrix[3], f[0]) + s->frame.matrix[3][3];
  double nearest = middle; /* at most as near as this */
  double across[3];

  for (int i = 1; i < 4; i++) {
    nearest -= fabs(sg_dot(s->frame.matrix[3], f[i])) * (1.0 + ring->k);
  }
  if (!(middle > 0)) {
    return SG_SHADING_BEHIND_EYE;
  }
  nearest = fmax(nearest, middle / MOST_LARGER);
  double u = dots(s, f[1], nearest), v = dots(s, f[2], nearest);
  quarter q[QUARTERS];
  const quarter *round = NULL, *side = NULL;

  fill_quarters(q);
  double wide[2] = {(1.0 + ring->k) * fmax(u, v),
                    ring->k * fmax(fmax(u, v), dots(s, f[3], nearest))};
  t.n = parts_for(s->frame.box ? BOX_RADIUS : wide[0], q, &round);
  t.m = parts_for(s->frame.box ? BOX_RADIUS : wide[1], q, &side);
  t.round = malloc(t.n * sizeof *t.round);
  t.side = malloc(t.m * sizeof *t.side);
  uint32_t *corner = malloc(t.n * t.m * sizeof *corner);
  sg_shading_end end = SG_SHADING_NO_MEMORY;
  uint32_t known = sg_shading_add_known(s, SG_KNOWN_TORUS, f, ring->k, 0.0);

  if (t.round && t.side && corner && known > 0) {
    fill_turn(t.round, t.n, round);
    fill_turn(t.side, t.m, side);
    sg_cross(f[1], f[2], across);
    end = add_corners(s, &t, corner);
    sg_shading_stand_for(s, known);
    end = end != SG_SHADING_GOOD || s->frame.box
              ? end
              : add_facets(s, &t, sg_dot(across, f[3]) < 0, corner);
    sg_shading_stand_for(s, 0);
  }
  free(corner);
  free(t.round);
  free(t.side);
  return end;
}
