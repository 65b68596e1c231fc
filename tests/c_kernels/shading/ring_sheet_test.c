/* ring_sheet_test.c -- spans of a torus end where its outline is, and nowhere
 * else, also where it hides a part of itself; lines where faces begin are
 * there. The outline is known in closed form: where the normal is square to the
 * line of sight. Of a torus that is cut, rays say whether what is seen jumps.
 *
 * covers: face_edge
 */
#include "shading/cover.h"
#include "shading/srgb.h"

#include "number/vector.h"
#include "tests/check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 128, AROUND = 1500, MOST = 256, SCENES = 12 };

static const double pi = 3.14159265358979323846, half = SIDE / 2.0;

/* The eye is 12 above the picture, which is 8 units wide, or far away. */
static const double eye = 12.0, scale = SIDE / 8.0;

static uint32_t seed = 31;

static double
uniform(double from, double to)
{
  return from + (to - from) * (check_below(&seed, 10007) + 0.37) / 10008;
}

typedef struct ring {
  double at[3], axis[3][3], size, k; /* the tube's radius in parts of `size` */
  bool central;
} ring;

static ring
some_ring(int i)
{
  ring out = {
      .size = uniform(1.6, 2.2), .k = uniform(0.15, 0.75), .central = i % 2};
  double tilt = uniform(0.6, 1.5), turn = uniform(0, 2 * pi);
  const double axis[3] = {sin(tilt) * cos(turn), sin(tilt) * sin(turn),
                          cos(tilt)};

  memcpy(out.axis[2], axis, sizeof axis);
  sg_cross(axis, (const double[3]){0.36, 0.48, 0.8}, out.axis[0]);
  double length = sqrt(sg_dot(out.axis[0], out.axis[0]));
  for (int k = 0; k < 3; k++) {
    out.axis[0][k] /= length;
    out.at[k] = uniform(-0.3, 0.3);
  }
  sg_cross(out.axis[2], out.axis[0], out.axis[1]);
  return out;
}

/* Less than 0 inside. */
static double
depth_inside(const ring *r, const double p[3])
{
  double d[3], x[3];

  sg_minus(p, r->at, d);
  for (int i = 0; i < 3; i++) {
    x[i] = sg_dot(d, r->axis[i]) / r->size;
  }
  double off = sqrt(x[0] * x[0] + x[1] * x[1]) - 1;
  return off * off + x[2] * x[2] - r->k * r->k;
}

/* ---- scenes ---- */

static const double box_low[3] = {-0.7, -4, -4}, box_high[3] = {1.1, 0.4, 4};

static bool
add_box(sg_shading *s)
{
  static const int side[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                 {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  const size_t four = 4;
  bool good = true;

  for (int32_t f = 0; f < 6; f++) {
    uint32_t corner[4];
    for (int i = 0; i < 4; i++) {
      double p[3];
      for (int k = 0; k < 3; k++) {
        p[k] = (side[f][i] >> k & 1 ? box_high : box_low)[k];
      }
      good = good && sg_shading_add_corner(s, p, &corner[i]) == SG_SHADING_GOOD;
    }
    good = good && sg_shading_add_polygon(s, f + 1, corner, &four, 1) ==
                       SG_SHADING_GOOD;
  }
  return good;
}

/* kind 0: the torus; 1: less the box; 2: and the box; 3: the box less it. */
static sg_shading *
scene_of(const ring *r, int kind)
{
  sg_shading_frame f = {.matrix = {{scale, 0, 0, half},
                                   {0, -scale, 0, half},
                                   {0, 0, -scale, 0},
                                   {0, 0, 0, 1}},
                        .width = SIDE,
                        .height = SIDE,
                        .tolerance = 1e-9};
  sg_shading_ring piece = {.k = r->k, .face = 1};

  if (r->central) {
    f.matrix[3][2] = -1 / eye;
    f.matrix[0][2] = f.matrix[1][2] = -half / eye;
  }
  for (int k = 0; k < 3; k++) {
    piece.frame[0][k] = r->at[k];
    for (int i = 0; i < 3; i++) {
      piece.frame[i + 1][k] = r->axis[i][k] * r->size;
    }
  }
  sg_shading *s = sg_shading_open(&f);
  CHECK("leaves", s && sg_shading_add_leaf(s, 1) == 0 &&
                      sg_shading_add_ring(s, &piece) == SG_SHADING_GOOD &&
                      sg_shading_add_leaf(s, 2) == 1 && add_box(s) &&
                      sg_shading_add_root(s, 1));
  if (kind == 0) {
    sg_shading_add_node(s, 0, SG_LEAF, 0);
  } else {
    size_t top = sg_shading_add_node(
        s, 0, kind == 2 ? SG_INTERSECTION : SG_DIFFERENCE, 0);
    sg_shading_add_node(s, top, SG_LEAF, kind == 3);
    sg_shading_add_node(s, top, SG_LEAF, kind != 3);
  }
  CHECK("sealed", sg_shading_seal(s, NULL) == SG_SHADING_GOOD);
  return s;
}

static void
see(const ring *r, const double p[3], double out[2])
{
  double w = r->central ? (eye - p[2]) / eye : 1;

  out[0] = half + scale * p[0] / w;
  out[1] = half - scale * p[1] / w;
}

/* ---- the outline ---- */

/* Its point on the side `way` of the tube's circle at u. False: none. */
static bool
outline_at(const ring *r, int way, double u, double p[3])
{
  double c = cos(u), s = sin(u), v, to[3], e[3];

  for (int k = 0; k < 3; k++) {
    to[k] = c * r->axis[0][k] + s * r->axis[1][k];
    e[k] = ((k == 2 ? eye : 0) - r->at[k]) / r->size;
  }
  if (r->central) {
    double a = 1 - sg_dot(e, to), b = -sg_dot(e, r->axis[2]);
    double most = hypot(a, b);
    if (most <= r->k) {
      return false;
    }
    v = atan2(b, a) + way * acos(-r->k / most);
  } else {
    v = atan2(-to[2], r->axis[2][2]) + (way > 0 ? 0 : pi);
  }
  for (int k = 0; k < 3; k++) {
    p[k] = r->at[k] + r->size * ((1 + r->k * cos(v)) * to[k] +
                                 r->k * sin(v) * r->axis[2][k]);
  }
  return true;
}

typedef enum sight { HIDDEN, DOUBTFUL, SEEN } sight;

/* Where the line of sight is t behind p. */
static void
behind(const ring *r, const double p[3], double t, double out[3])
{
  double d[3] = {0, 0, -1};

  if (r->central) {
    sg_minus(p, (const double[3]){0, 0, eye}, d);
    double length = sqrt(sg_dot(d, d));
    for (int k = 0; k < 3; k++) {
      d[k] /= length;
    }
  }
  for (int k = 0; k < 3; k++) {
    out[k] = p[k] + t * d[k];
  }
}

/* In *gap how far behind it there is more of the torus; INFINITY: nowhere. */
static sight
sight_of(const ring *r, const double p[3], double *gap)
{
  double q[3], least = INFINITY;

  *gap = INFINITY;
  for (int i = 4; i < 800; i++) {
    behind(r, p, -i / 100.0, q);
    least = fmin(least, depth_inside(r, q));
  }
  for (int i = 2; i < 800 && isinf(*gap); i++) {
    behind(r, p, i / 100.0, q);
    *gap = depth_inside(r, q) < 0 ? i / 100.0 : INFINITY;
  }
  return least < -1e-4 ? HIDDEN : least < 1e-4 ? DOUBTFUL : SEEN;
}

typedef struct crossing {
  double x, gap;
  sight sight;
} crossing;

static double
height_at(const ring *r, int way, double u, double y)
{
  double p[3], at[2] = {0, NAN};

  if (outline_at(r, way, u, p)) {
    see(r, p, at);
  }
  return at[1] - y;
}

/* Where the outline crosses the line y. */
static size_t
crossings_of(const ring *r, double y, crossing out[MOST])
{
  size_t n = 0;

  for (int i = 0; i < 2 * AROUND; i++) {
    int way = i % 2 == 0 ? 1 : -1;
    double low = 2 * pi * (i / 2) / AROUND, high = low + 2 * pi / AROUND;
    double below = height_at(r, way, low, y), p[3], at[2];

    if (!(below * height_at(r, way, high, y) < 0) || n == MOST) {
      continue;
    }
    for (int k = 0; k < 50; k++) {
      double u = (low + high) / 2;
      *(below * height_at(r, way, u, y) > 0 ? &low : &high) = u;
    }
    outline_at(r, way, low, p);
    see(r, p, at);
    out[n].sight = sight_of(r, p, &out[n].gap);
    out[n++].x = at[0];
  }
  return n;
}

static bool
is_end(const sg_spans *spans, double x)
{
  for (size_t i = 0; i < spans->n; i++) {
    if (fabs(spans->span[i].x1 / 256.0 - x) < 0.01 ||
        fabs(spans->span[i].x2 / 256.0 - x) < 0.01) {
      return true;
    }
  }
  return false;
}

static bool
is_crossing(const crossing *all, size_t n, int32_t x)
{
  for (size_t i = 0; i < n; i++) {
    if (all[i].sight != HIDDEN && fabs(all[i].x - x / 256.0) < 0.01) {
      return true;
    }
  }
  return false;
}

/* ---- lines in the picture ---- */

static unsigned dark, bright, stray;

typedef struct picture {
  double dark[SIDE][SIDE]; /* how much of a dot has a line */
  double lit[SIDE][SIDE];
} picture;

/* All that may be seen of the outline is where there are lines, and the other
 * way round. */
static void
compare_lines(const ring *r, const picture *lines)
{
  static bool near[SIDE][SIDE];

  memset(near, 0, sizeof near);
  for (int i = 0; i < 2 * AROUND; i++) {
    double p[3], at[2], gap;
    if (!outline_at(r, i % 2 == 0 ? 1 : -1, pi * i / AROUND, p)) {
      continue;
    }
    sight is = sight_of(r, p, &gap);
    see(r, p, at);
    if (is == SEEN && gap * scale > 2) {
      bool drawn = lines->dark[(int)at[1]][(int)at[0]] > 0.1;
      dark += drawn ? 1U : 0U;
      bright += drawn ? 0U : 1U;
    }
    for (int k = 0; k < 9 && is != HIDDEN; k++) {
      near[(int)at[1] + k / 3 - 1][(int)at[0] + k % 3 - 1] = true;
    }
  }
  for (int i = 0; i < SIDE * SIDE; i++) {
    stray += lines->dark[i / SIDE][i % SIDE] > 0 && !near[i / SIDE][i % SIDE];
  }
}

/* The light comes from above; or, with lines, from everywhere. */
static void
draw(const sg_shading *s, sg_shading_work *work, bool edges, picture *out)
{
  static sg_face_look look;
  static const uint32_t first[] = {0, 0, 1, 2}, of[] = {0, 0};
  const sg_shaded in = {.scene = s,
                        .lines = 4,
                        .looks = {&look, {first, of}},
                        .clear = true,
                        .edges = edges};
  sg_dot_row row;
  sg_spans spans = {0};
  bool good = sg_cover_open(&row, SIDE);

  memset(&look, 0, sizeof look);
  look.tones.constant = edges ? 1 : 0;
  look.tones.ways = edges ? 0 : 1;
  look.tones.way[0] = (sg_tone_way){{0, 1, 0}, 1, 0};
  for (int k = 0; k <= SG_RAMP + 1; k++) {
    look.ramp.light[k][0] =
        (uint16_t)((k < SG_RAMP ? k : SG_RAMP) * (SG_LIGHT_MOST / 1024.0));
  }
  for (int32_t y = 0; good && y < SIDE; y++) {
    good = sg_cover_row(&row, &in, work, &spans, y);
    for (int x = 0; x < SIDE; x++) {
      double covered = row.sum[x][3] / (double)SG_OPAQUE;
      double lit = row.sum[x][0] / (double)SG_LIGHT_MOST;
      double lines = (covered - lit) / (256 * in.lines);
      out->lit[y][x] = lit / (256 * in.lines);
      out->dark[y][x] = lines > 1e-2 ? lines : 0;
    }
  }
  CHECK("rows", good);
  sg_cover_close(&row);
  free(spans.span);
}

/* ---- what jumps ---- */

static bool
holds(const ring *r, int kind, const double p[3])
{
  bool in = depth_inside(r, p) < 0, box = true;

  for (int k = 0; k < 3; k++) {
    box = box && p[k] > box_low[k] && p[k] < box_high[k];
  }
  return kind == 0   ? in
         : kind == 1 ? in && !box
         : kind == 2 ? in && box
                     : box && !in;
}

/* How deep below z = 5 something is seen; 20: nothing is. */
static double
depth_at(const ring *r, int kind, double x, double y)
{
  double far = 20, near = 0, w = r->central ? (eye - 5) / eye : 1, q[3];
  const double p[3] = {(x - half) / scale * w, (half - y) / scale * w, 5};

  for (int i = 0; i < 2000 && far > 19; i++) {
    behind(r, p, i / 180.0, q);
    far = holds(r, kind, q) ? i / 180.0 : far;
    near = far < 19 ? near : i / 180.0;
  }
  for (int i = 0; i < 30 && far < 19; i++) {
    double middle = (near + far) / 2;
    behind(r, p, middle, q);
    *(holds(r, kind, q) ? &far : &near) = middle;
  }
  return far;
}

/* How far it jumps in one place between two. */
static double
jump(const ring *r, int kind, const double x[2], double y)
{
  double low = x[0], high = x[1];
  double a = depth_at(r, kind, low, y), b = depth_at(r, kind, high, y);

  for (int i = 0; i < 26 && fabs(a - b) > 1e-3; i++) {
    double middle = (low + high) / 2, c = depth_at(r, kind, middle, y);
    if (fabs(a - c) > fabs(c - b)) {
      high = middle;
      b = c;
    } else {
      low = middle;
      a = c;
    }
  }
  return fabs(a - b);
}

/* How light it is there, from above. */
static double
light_at(const ring *r, double x, double y)
{
  double p[3] = {0}, n[3], depth = depth_at(r, 0, x, y);
  double w = r->central ? (eye - 5) / eye : 1;
  const double from[3] = {(x - half) / scale * w, (half - y) / scale * w, 5};

  behind(r, from, depth, p);
  for (int k = 0; k < 3; k++) {
    double q[3] = {p[0], p[1], p[2]};
    q[k] += 1e-5;
    n[k] = depth_inside(r, q) - depth_inside(r, p);
  }
  return depth > 19 ? 0 : fmax(0, n[1] / sqrt(sg_dot(n, n)));
}

static unsigned halves, uneven;

/* A dot in which the outline is, not at its end, has light of both sides. */
static void
compare_light(const ring *r, const picture *lit, const crossing *c, double y)
{
  int i = (int)c->x, k = (int)y;
  double sum = 0;

  for (int j = 0; j < 36; j++) {
    sum += light_at(r, i + (j % 6 + 0.5) / 6, k + (j / 6 + 0.5) / 6) / 36;
  }
  halves++;
  uneven += fabs(sum - lit->lit[k][i]) > 0.05 ? 1U : 0U;
}

static unsigned asked, inner, missing, surplus;

static void
compare_line(const ring *r, const picture *lit, const sg_spans *spans, double y)
{
  crossing all[MOST];
  size_t n = crossings_of(r, y, all);

  for (size_t i = 0; i < n; i++) {
    if (all[i].sight == SEEN) {
      asked++;
      inner += isfinite(all[i].gap) ? 1U : 0U;
      missing += is_end(spans, all[i].x) ? 0U : 1U;
      if (all[i].gap < INFINITY && all[i].gap * scale > 2) {
        compare_light(r, lit, &all[i], y);
      }
    }
  }
  for (size_t i = 0; i < spans->n; i++) {
    surplus += is_crossing(all, n, spans->span[i].x1) ? 0U : 1U;
    surplus += is_crossing(all, n, spans->span[i].x2) ? 0U : 1U;
  }
}

static unsigned rows, apart, touching, joined, kept, split;

/* Spans do not overlap; where one begins at the end of another one of the same
 * face it is behind or before it, and within a span nothing is. */
static void
check_rows(const ring *r, int kind, const sg_spans *spans, double y)
{
  for (size_t i = 0; i < spans->n; i++) {
    const sg_span *p = &spans->span[i], *q = p + 1;

    rows++;
    CHECK("a span is wide", p->x1 < p->x2);
    if (i + 1 < spans->n && p->x2 == q->x1 && p->leaf == 1 && q->leaf == 1) {
      const double at[2] = {(p->x2 - 2) / 256.0, (p->x2 + 2) / 256.0};
      bool jumps = jump(r, kind, at, y) > 1e-3;
      touching++;
      joined += jumps ? 0U : 1U;
    } else if (i + 1 < spans->n) {
      apart += p->x2 <= q->x1 ? 0U : 1U;
    }
    for (double x = p->x1 / 256.0 + 0.02; p->leaf == 1; x += 2) {
      const double at[2] = {x, fmin(x + 2, p->x2 / 256.0 - 0.02)};
      if (at[1] < at[0]) {
        break;
      }
      kept++;
      split += jump(r, kind, at, y) > 0.02 ? 1U : 0U;
    }
  }
}

static void
check_cut(const ring *r, int kind)
{
  sg_shading *s = scene_of(r, kind);
  sg_shading_work *work = sg_shading_work_open(s, NULL);
  sg_spans spans = {0};

  for (double y = 3.3; y < SIDE; y += 3) {
    CHECK("a line", sg_shading_line(s, work, y, &spans));
    sg_spans_join(&spans);
    check_rows(r, kind, &spans, y);
  }
  free(spans.span);
  sg_shading_work_close(work);
  sg_shading_close(s);
}

static void
check_whole(const ring *r)
{
  static picture lit, lines;
  sg_shading *s = scene_of(r, 0);
  sg_shading_work *work = sg_shading_work_open(s, NULL);
  sg_spans spans = {0};

  draw(s, work, false, &lit);
  for (double y = 1.3; y < SIDE; y += 1) {
    CHECK("a line", sg_shading_line(s, work, y, &spans));
    sg_spans_join(&spans);
    compare_line(r, &lit, &spans, y);
  }
  draw(s, work, true, &lines);
  compare_lines(r, &lines);
  free(spans.span);
  sg_shading_work_close(work);
  sg_shading_close(s);
}

int
main(void)
{
  for (int i = 0; i < SCENES; i++) {
    ring r = some_ring(i);

    check_whole(&r);
    check_cut(&r, 1 + i % 3);
  }
  printf("%u places of outlines, %u before the torus, %u missing, %u more\n",
         asked, inner, missing, surplus);
  printf("%u places with lines, %u without, %u lines elsewhere\n", dark, bright,
         stray);
  printf("%u dots of two lights, %u have another one\n", halves, uneven);
  printf(
      "%u rows, %u overlap; %u touch, %u of them go on; %u places within, %u "
      "jump\n",
      rows, apart, touching, joined, kept, split);
  CHECK("many outlines", asked > 1500 && inner > 100);
  CHECK("a span ends where the outline is", missing == 0);
  CHECK("and nowhere else", surplus == 0);
  CHECK("lines are where the outline is", dark > 20000 && bright == 0);
  CHECK("and nowhere else", stray == 0);
  CHECK("dots have light of both sides", halves > 80 && uneven == 0);
  CHECK("rows are in order", rows > 300 && apart == 0);
  CHECK("rows are as long as may be", touching > 10 && joined == 0);
  CHECK("rows end where something is behind", kept > 1000 && split == 0);
  return check_report();
}
