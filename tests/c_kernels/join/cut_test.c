/* cut_test.c -- sg_cut_triangles() against exact clipping on a small grid.
 *
 * The oracle shares nothing with the kernel: points are homogeneous integers,
 * the common part is found by clipping with half-spaces, features by counting
 * the half-spaces on whose border a point lies. On a grid of 0..4 most pairs
 * are degenerate in some way; the classes met are counted and printed.
 */
#include "tests/check.h"

#include "join/cut.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

__extension__ typedef __int128 wide;

/* C does not turn double (*)[3] into const double (*)[3] by itself. */
#define FIXED(triangle) ((const double(*)[3])(triangle))

/* The point (x, y, z) / w, w > 0, no common factor. */
typedef struct homog {
  wide c[4];
} homog;

/* The half-space n . (x, y, z) + d * w >= 0. */
typedef struct half {
  wide c[4];
} half;

static uint64_t state = 20261121;

static unsigned
random_below(unsigned n)
{
  state = state * 6364136223846793005u + 1442695040888963407u;
  return (unsigned)(state >> 33) % n;
}

static wide
magnitude(wide x)
{
  return x < 0 ? -x : x;
}

static homog
reduced(homog p)
{
  wide g = p.c[3];

  for (int i = 0; i < 3; i++) {
    for (wide a = magnitude(p.c[i]); a != 0;) {
      wide rest = g % a;
      g = a;
      a = rest;
    }
  }
  for (int i = 0; i < 4; i++) {
    p.c[i] /= g;
  }
  return p;
}

static homog
from_double(const double p[3])
{
  return (homog){{(wide)p[0], (wide)p[1], (wide)p[2], 1}};
}

static bool
same(homog p, homog q)
{
  return memcmp(&p, &q, sizeof p) == 0;
}

static wide
value(const half *h, const homog *p)
{
  wide sum = 0;

  for (int i = 0; i < 4; i++) {
    sum += h->c[i] * p->c[i];
  }
  return sum;
}

static int
sign(wide x)
{
  return (x > 0) - (x < 0);
}

static void
cross(const wide a[3], const wide b[3], wide out[3])
{
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    out[i] = a[j] * b[k] - a[k] * b[j];
  }
}

/* h[0] and h[1]: both sides of the plane of t; h[2..4]: inside of its edges. */
static bool
half_spaces(const double t[3][3], half h[5])
{
  wide e[3][3], n[3];

  for (int i = 0; i < 3; i++) {
    for (int c = 0; c < 3; c++) {
      e[i][c] = (wide)t[(i + 1) % 3][c] - (wide)t[i][c];
    }
  }
  cross(e[0], e[1], n);
  for (int k = 0; k < 5; k++) {
    const double *on = t[k < 2 ? 0 : k - 2];
    wide m[3] = {n[0], n[1], n[2]};

    if (k >= 2) {
      cross(n, e[k - 2], m);
    }
    h[k].c[3] = 0;
    for (int c = 0; c < 3; c++) {
      h[k].c[c] = k == 1 ? -m[c] : m[c];
      h[k].c[3] -= h[k].c[c] * (wide)on[c];
    }
  }
  return n[0] != 0 || n[1] != 0 || n[2] != 0;
}

/* Clips the segment p-q (p = q allowed) by h; false: nothing left. */
static bool
clip(const half *h, homog *p, homog *q)
{
  wide a = value(h, p), b = value(h, q);

  if (a < 0 && b < 0) {
    return false;
  }
  if (a < 0 || b < 0) {
    homog at;
    for (int i = 0; i < 4; i++) {
      at.c[i] = magnitude(b) * p->c[i] + magnitude(a) * q->c[i];
    }
    *(a < 0 ? p : q) = reduced(at);
  }
  return true;
}

static bool
clip_all(const half h[5], homog *p, homog *q)
{
  for (int k = 0; k < 5; k++) {
    if (!clip(&h[k], p, q)) {
      return false;
    }
  }
  return true;
}

static sg_feature
feature(const half h[5], homog p)
{
  int zeros = 0, last = 0;

  for (int k = 0; k < 3; k++) {
    if (value(&h[k + 2], &p) == 0) {
      zeros++;
      last = k;
    }
  }
  if (zeros == 2) { /* edges k and k + 1 share corner k + 1 */
    bool first_two = value(&h[2], &p) == 0 && value(&h[3], &p) == 0;
    bool last_two = value(&h[3], &p) == 0 && value(&h[4], &p) == 0;
    return first_two ? SG_CORNER_1 : last_two ? SG_CORNER_2 : SG_CORNER_0;
  }
  return zeros == 1 ? (sg_feature)(SG_EDGE_0 + last) : SG_FACE;
}

typedef struct piece {
  homog p, q;
} piece;

/* The common part of two planes-apart triangles: the edges of a clipped to
 * the plane of b give the ends; the segment is then clipped by b. */
static bool
crossing(const double a[3][3], const half hb[5], piece *out)
{
  int n = 0;

  for (int i = 0; i < 3; i++) {
    homog p = from_double(a[i]), q = from_double(a[(i + 1) % 3]);

    if (clip(&hb[0], &p, &q) && clip(&hb[1], &p, &q)) {
      if (n++ == 0) {
        *out = (piece){p, p};
      }
      out->q = same(p, out->p) ? (same(q, out->p) ? out->q : q) : p;
    }
  }
  return n > 0 && clip_all(hb, &out->p, &out->q);
}

/* Edge i of a clipped by b. */
static bool
border(const double a[3][3], int i, const half hb[5], piece *out)
{
  out->p = from_double(a[i]);
  out->q = from_double(a[(i + 1) % 3]);
  return clip_all(hb, &out->p, &out->q);
}

static bool
lies_on_edge(const half h[5], const piece *s)
{
  for (int k = 2; k < 5; k++) {
    if (value(&h[k], &s->p) == 0 && value(&h[k], &s->q) == 0) {
      return true;
    }
  }
  return false;
}

/* All pieces of a coplanar pair, in the kernel's order. */
static int
borders(const double a[3][3], const double b[3][3], const half ha[5],
        const half hb[5], piece out[7])
{
  int n = 0;
  bool has_point = false;
  piece s, point = {0};

  for (int i = 0; i < 6; i++) {
    bool hit = i < 3 ? border(a, i, hb, &s) : border(b, i - 3, ha, &s);

    if (hit && same(s.p, s.q)) {
      point = s;
      has_point = true;
    } else if (hit && (i < 3 || !lies_on_edge(ha, &s))) {
      out[n++] = s;
    }
  }
  if (n == 0 && has_point) {
    out[n++] = point;
  }
  return n;
}

static bool
end_is(const sg_cut_end *end, const half ha[5], const half hb[5], homog p)
{
  return end->f[0] == feature(ha, p) && end->f[1] == feature(hb, p);
}

static bool
cut_is(const sg_cut *cut, const half ha[5], const half hb[5], const piece *s,
       bool directed)
{
  return (end_is(&cut->end[0], ha, hb, s->p) &&
          end_is(&cut->end[1], ha, hb, s->q)) ||
         (!directed && end_is(&cut->end[0], ha, hb, s->q) &&
          end_is(&cut->end[1], ha, hb, s->p));
}

/* The kernel gives a crossing in the direction normal(a) x normal(b). */
static bool
direction_is_right(const sg_cut *cut, const half ha[5], const half hb[5],
                   const piece *s)
{
  bool forward = end_is(&cut->end[0], ha, hb, s->p);
  wide d[3], along = 0;

  cross(ha[0].c, hb[0].c, d);
  for (int c = 0; c < 3; c++) {
    along += d[c] * (s->q.c[c] * s->p.c[3] - s->p.c[c] * s->q.c[3]);
  }
  return sign(along) == (sg_cut_is_point(cut) ? 0 : forward ? 1 : -1);
}

static unsigned counts[3][3]; /* by kind: pairs, points, segments */

static int
class_of(sg_feature f)
{
  return f <= SG_CORNER_2 ? 0 : f <= SG_EDGE_2 ? 1 : 2;
}

/* What the printed table counts: vertex-vertex .. face-edge, by first end. */
static unsigned classes[3][3];

static bool
pair_agrees(const double a[3][3], const double b[3][3])
{
  half ha[5], hb[5];
  piece s[7];
  sg_cut cut[SG_CUT_MAX];
  int n, expected;
  sg_cut_kind kind = sg_cut_triangles(a, b, cut, &n);
  bool solid_a = half_spaces(a, ha), solid_b = half_spaces(b, hb);
  bool flat = true;

  counts[kind][0]++;
  if (!solid_a || !solid_b) {
    return kind == SG_CUT_NONE && n == 0;
  }
  for (int i = 0; i < 3; i++) {
    homog p = from_double(a[i]);
    flat = flat && value(&hb[0], &p) == 0;
  }
  expected = flat ? borders(a, b, ha, hb, s) : crossing(a, hb, &s[0]);
  if (n != expected || (n > 0 && flat != (kind == SG_CUT_COPLANAR)) ||
      (n == 0) != (kind == SG_CUT_NONE)) {
    return false;
  }
  for (int i = 0; i < n; i++) {
    classes[class_of(cut[i].end[0].f[0])][class_of(cut[i].end[0].f[1])]++;
    counts[kind][sg_cut_is_point(&cut[i]) ? 1 : 2]++;
    if (!cut_is(&cut[i], ha, hb, &s[i], flat)) {
      return false;
    }
  }
  return n == 0 || flat || direction_is_right(&cut[0], ha, hb, &s[0]);
}

static void
random_triangle(unsigned size, double t[3][3])
{
  for (int i = 0; i < 9; i++) {
    t[i / 3][i % 3] = random_below(size);
  }
}

/* In plane: a triangle whose corners all have z = 1 (or x + y + z = 4). */
static void
flatten(double t[3][3], bool slanted)
{
  for (int i = 0; i < 3; i++) {
    t[i][2] = slanted ? 4 - t[i][0] - t[i][1] : 1;
  }
}

static bool
random_pairs(int n, unsigned size, int flat)
{
  for (int k = 0; k < n; k++) {
    double a[3][3], b[3][3];

    random_triangle(size, a);
    random_triangle(size, b);
    if (flat) {
      flatten(a, flat == 2);
      flatten(b, flat == 2);
    }
    if (!pair_agrees(FIXED(a), FIXED(b))) {
      printf("pair %d of grid %u, flat %d\n", k, size, flat);
      return false;
    }
  }
  return true;
}

/* The segment as the oracle sees it, against sg_cut_segment(). */
static bool
segment_agrees(const double u[3], const double w[3], const double b[3][3])
{
  half hb[5];
  homog p = from_double(u), q = from_double(w), from = p, to = q;
  sg_cut cut;
  sg_cut_kind kind = sg_cut_segment(u, w, b, &cut);

  if (!half_spaces(b, hb) || same(p, q) || !clip_all(hb, &p, &q)) {
    return kind == SG_CUT_NONE;
  }
  bool flat = value(&hb[0], &from) == 0 && value(&hb[0], &to) == 0;
  homog at[2] = {p, q};

  for (int k = 0; k < 2; k++) {
    sg_feature f = same(at[k], from) ? SG_CORNER_0
                   : same(at[k], to) ? SG_CORNER_1
                                     : SG_EDGE_0;
    if (cut.end[k].f[0] != f || cut.end[k].f[1] != feature(hb, at[k])) {
      return false;
    }
  }
  return kind == (flat ? SG_CUT_COPLANAR : SG_CUT_CROSSING);
}

static bool
random_segments(int n, unsigned size, bool flat)
{
  for (int k = 0; k < n; k++) {
    double a[3][3], b[3][3];

    random_triangle(size, a);
    random_triangle(size, b);
    if (flat) {
      flatten(a, k % 2);
      flatten(b, k % 2);
    }
    if (!segment_agrees(a[0], a[1], FIXED(b))) {
      printf("segment %d of grid %u\n", k, size);
      return false;
    }
  }
  return true;
}

/* Swapping the triangles swaps the features and turns the direction. */
static bool
swap_swaps(int n)
{
  for (int k = 0; k < n; k++) {
    double a[3][3], b[3][3];
    sg_cut ab[SG_CUT_MAX], ba[SG_CUT_MAX];
    int na, nb;

    random_triangle(4, a);
    random_triangle(4, b);
    sg_cut_kind kind = sg_cut_triangles(FIXED(a), FIXED(b), ab, &na);
    if (kind != sg_cut_triangles(FIXED(b), FIXED(a), ba, &nb)) {
      return false;
    }
    for (int e = 0; kind == SG_CUT_CROSSING && e < 2; e++) {
      for (int t = 0; t < 2; t++) {
        if (ab[0].end[e].f[t] != ba[0].end[!e].f[!t]) {
          return false;
        }
      }
    }
  }
  return true;
}

static void
feature_edges(void)
{
  CHECK("corner 0 and edge 0", sg_feature_edge(SG_CORNER_0, SG_EDGE_0) == 0);
  CHECK("corners 2 and 0", sg_feature_edge(SG_CORNER_2, SG_CORNER_0) == 2);
  CHECK("edge 0 and edge 1", sg_feature_edge(SG_EDGE_0, SG_EDGE_1) == -1);
  CHECK("face", sg_feature_edge(SG_FACE, SG_FACE) == -1);
}

int
main(void)
{
  feature_edges();
  CHECK("grid 3", random_pairs(60000, 3, 0));
  CHECK("grid 4", random_pairs(60000, 4, 0));
  CHECK("grid 9", random_pairs(20000, 9, 0));
  CHECK("plane z = 1", random_pairs(60000, 4, 1));
  CHECK("plane x + y + z = 4", random_pairs(60000, 5, 2));
  CHECK("segments", random_segments(60000, 4, false));
  CHECK("segments in the plane", random_segments(60000, 4, true));
  CHECK("swap", swap_swaps(20000));
  printf("cut: none %u, crossing %u (points %u, segments %u), coplanar %u "
         "(points %u, segments %u)\n",
         counts[0][0], counts[1][0], counts[1][1], counts[1][2], counts[2][0],
         counts[2][1], counts[2][2]);
  printf("cut: ends v-v %u v-e %u v-f %u e-v %u e-e %u e-f %u f-v %u f-e %u\n",
         classes[0][0], classes[0][1], classes[0][2], classes[1][0],
         classes[1][1], classes[1][2], classes[2][0], classes[2][1]);
  return check_report();
}
