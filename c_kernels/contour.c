/* contour.c -- see contour.h */
#include "contour_private.h"

#include "bounds.h"
#include "vector.h"

#include <math.h>
#include <stdlib.h>

/* What is nearer to zero than this is zero: views along a symmetry of the
 * model give the same outline on every machine. */
#define ZERO 1e-12

/* A triangle is edge-on when its normal leans less than this (as in scene.c).
 */
#define EDGE_ON 1e-9

/* A piece is unsure if its direction is off the line of sight by less than this
 * part of what the normals of its triangle turn: g is linear in a triangle, so
 * the direction found is that of its middle, and the true one is off that by up
 * to half of what the normals turn. A little more, since the sides of a piece
 * that is nearly sure show as hooks: of 16 tori seen from 5 sides 0.5 leaves 9,
 * 0.6 four, and 0.8 only one, but outlines that end too early. */
#define UNSURE 0.6

/* Triangles between two polls; pieces, each with a walk. */
enum { POLL_EVERY = 4096, POLL_PIECES = 64 };

static void
difference(const double a[3], const double b[3], double out[3])
{
  for (int k = 0; k < 3; k++) {
    out[k] = a[k] - b[k];
  }
}

/* Halves or doubles n vectors until the largest coordinate is between 1/2 and
 * 1, so that products of areas stay in the doubles: exact. Gives the power of 2
 * that was taken out. */
static int
shrink(double (*u)[3], size_t n)
{
  double most = 0.0;
  int exponent;

  for (size_t i = 0; i < n; i++) {
    for (int k = 0; k < 3; k++) {
      most = sg_larger(most, fabs(u[i][k]));
    }
  }
  frexp(most, &exponent);
  for (size_t i = 0; i < n; i++) {
    for (int k = 0; k < 3; k++) {
      u[i][k] = ldexp(u[i][k], -exponent);
    }
  }
  return exponent;
}

/* -------------------------------------------------------------- the eye */

/* The direction from a point to the eye, unit. */
static void
to_eye(const sg_contour_input *in, const double p[3], double out[3])
{
  const double *away = in->eye.row[2];
  double size;

  for (int k = 0; k < 3; k++) {
    out[k] = in->central ? -in->eye.rho * away[k] - p[k] : -away[k];
  }
  size = sg_length(out);
  for (int k = 0; k < 3 && size > 0.0; k++) {
    out[k] /= size;
  }
}

/* How far from the eye a point is, along the line of sight; the same for all
 * in a parallel picture. */
static double
distance(const sg_contour_input *in, const double p[3])
{
  return in->central ? sg_dot(p, in->eye.row[2]) + in->eye.rho : 1.0;
}

/* ----------------------------------------------------------- the corners */

/* False: stopped. */
static bool
find_g(sg_contour_finder *f, const sg_poll *poll)
{
  const sg_smooth *smooth = f->in->smooth;

  for (uint32_t i = 0; i < 3 * f->in->dense->triangles; i++) {
    uint32_t fan = smooth->fan[i];
    double eye[3];
    if (i % POLL_EVERY == 0 && sg_poll_stop(poll)) {
      return false;
    }
    if (smooth->curved[i / 3]) {
      to_eye(f->in, f->in->dense->at[sg_contour_vertex(f, i)], eye);
      f->g[fan] = sg_dot(smooth->normal[fan], eye);
      f->g[fan] = fabs(f->g[fan]) < ZERO ? 0.0 : f->g[fan];
    }
  }
  return true;
}

static bool
is_towards(const sg_contour_finder *f, uint32_t corner)
{
  return sg_contour_g(f, corner) >= 0.0;
}

/* The gradient of g in triangle t, in which g is linear, times twice the area
 * of t; gives that. */
static double
gradient(const sg_contour_finder *f, uint32_t t, double out[3])
{
  double(*at)[3] = f->in->dense->at;
  const double *p[3];
  double side[3][3], normal[3], across[3], size;
  int exponent;

  for (uint32_t k = 0; k < 3; k++) {
    p[k] = at[sg_contour_vertex(f, 3 * t + k)];
    out[k] = 0.0;
  }
  for (int k = 0; k < 3; k++) {
    difference(p[(k + 2) % 3], p[(k + 1) % 3], side[k]); /* opposite corner k */
  }
  exponent = shrink(side, 3);
  sg_cross(side[0], side[1], normal);
  size = sg_length(normal);
  for (uint32_t k = 0; k < 3 && size > 0.0; k++) {
    sg_cross(normal, side[k], across);
    for (int i = 0; i < 3; i++) {
      out[i] += sg_contour_g(f, 3 * t + k) * across[i] / size;
    }
  }
  for (int i = 0; i < 3; i++) {
    out[i] = ldexp(out[i], exponent);
  }
  return ldexp(size, 2 * exponent);
}

/* How g grows in triangle t on the way to the eye, times *area, twice that of
 * t. */
static double
growth(const sg_contour_finder *f, uint32_t t, double *area)
{
  double grad[3], eye[3];

  *area = gradient(f, t, grad);
  to_eye(f->in, f->in->dense->at[sg_contour_vertex(f, 3 * t)], eye);
  return sg_dot(grad, eye);
}

static bool
has_apex(const sg_contour_finder *f, uint32_t t)
{
  return sg_contour_is_apex(f, 3 * t) || sg_contour_is_apex(f, 3 * t + 1) ||
         sg_contour_is_apex(f, 3 * t + 2);
}

/* Of each fan: the mean of its triangles. Only its sign and its zeros between
 * fans are asked for. False: stopped, or no memory. */
static bool
find_radials(sg_contour_finder *f, const sg_poll *poll, bool *memory)
{
  const sg_smooth *smooth = f->in->smooth;
  double *area = calloc(smooth->fans + 1, sizeof *area);

  *memory = area != NULL;
  for (uint32_t t = 0; area && t < f->in->dense->triangles; t++) {
    double sum, twice;
    if (t % POLL_EVERY == 0 && sg_poll_stop(poll)) {
      free(area);
      return false;
    }
    if (!smooth->curved[t] || has_apex(f, t)) {
      continue;
    }
    sum = growth(f, t, &twice);
    for (uint32_t k = 0; k < 3; k++) {
      f->radial[smooth->fan[3 * t + k]] += sum;
      area[smooth->fan[3 * t + k]] += twice;
    }
  }
  for (size_t i = 0; area && i < smooth->fans; i++) {
    f->radial[i] = area[i] > 0.0 ? f->radial[i] / area[i] : 0.0;
  }
  free(area);
  return *memory;
}

/* --------------------------------------------------------- the triangles */

/* 1: turned to the eye, -1: turned away, 0: edge-on. */
static int
facing(const sg_contour_finder *f, uint32_t t)
{
  const double(*at)[3] = f->in->screen;
  const int32_t *v = f->in->dense->corner[t];
  double side[2][3], n[3], edge;

  difference(at[v[1]], at[v[0]], side[0]);
  difference(at[v[2]], at[v[0]], side[1]);
  shrink(side, 2);
  sg_cross(side[0], side[1], n);
  edge = EDGE_ON * sg_length(n);
  return (n[2] > edge) - (n[2] < -edge);
}

static sg_contour_kind
kind_of(const sg_contour_finder *f, uint32_t t)
{
  int face = facing(f, t), towards = 0, away = 0;

  for (uint32_t i = 3 * t; i < 3 * t + 3; i++) {
    if (f->in->smooth->curved[t] && !sg_contour_is_apex(f, i)) {
      towards += is_towards(f, i);
      away += !is_towards(f, i);
    }
  }
  return face > 0 && away == 0      ? SG_CONTOUR_TOWARDS
         : face < 0 && towards == 0 ? SG_CONTOUR_AWAY
                                    : SG_CONTOUR_MIXED;
}

/* ------------------------------------------------------------ the pieces */

/* Where g is zero on a side of the model, counted from its corner a. */
static double
zero_of(const sg_contour_finder *f, uint32_t a, uint32_t b)
{
  return sg_contour_g(f, a) / (sg_contour_g(f, a) - sg_contour_g(f, b));
}

/* The same in the picture, counted from the smaller vertex. */
static double
zero_in_picture(const sg_contour_finder *f, uint32_t a, uint32_t b)
{
  double(*at)[3] = f->in->dense->at;
  uint32_t v = sg_contour_vertex(f, a), w = sg_contour_vertex(f, b);
  double zero, near_v, near_w;

  if (v > w) {
    return zero_in_picture(f, b, a);
  }
  zero = zero_of(f, a, b);
  near_v = (1.0 - zero) * distance(f->in, at[v]);
  near_w = zero * distance(f->in, at[w]);
  return near_w / (near_v + near_w);
}

/* End `end` of a piece is at corner `corner` of its triangle. */
static void
end_at_corner(const sg_contour_finder *f, sg_contour *piece, int end,
              uint32_t corner)
{
  uint32_t next = sg_contour_next(corner);

  piece->side[end] = (uint8_t)(corner % 3);
  piece->at[end] =
      sg_contour_vertex(f, corner) < sg_contour_vertex(f, next) ? 0.0 : 1.0;
}

/* End `end` of a piece is on a side whose corners differ, or, where the sheet
 * ends there, at one of them. Gives the radial of that place. */
static double
end_on_side(const sg_contour_finder *f, sg_contour *piece, int end,
            uint32_t side)
{
  const uint32_t *fan = f->in->smooth->fan;
  uint32_t next = sg_contour_next(side);
  double zero = zero_of(f, side, next);

  if (f->in->smooth->side[side] & SG_SIDE_SMOOTH) {
    piece->side[end] = (uint8_t)(side % 3);
    piece->at[end] = zero_in_picture(f, side, next);
  } else {
    bool away = facing(f, side / 3) < 0;
    end_at_corner(f, piece, end, is_towards(f, side) == away ? side : next);
  }
  return (1.0 - zero) * f->radial[fan[side]] + zero * f->radial[fan[next]];
}

static bool
is_solid(const sg_contour_finder *f, uint32_t t)
{
  const sg_dense *d = f->in->dense;

  return f->in->solid[sg_dense_segment_of(d, d->triangle_begin, t)];
}

/* What the radials at its ends, r and s, say: where it is divided. It is
 * turned round so that the part that is not hidden comes first. */
static void
divide_piece(sg_contour_finder *f, sg_contour *piece, double r, double s)
{
  if (r < s) {
    sg_contour turned = *piece;
    for (int k = 0; k < 2; k++) {
      piece->side[k] = turned.side[1 - k];
      piece->at[k] = turned.at[1 - k];
    }
    divide_piece(f, piece, s, r);
    return;
  }
  f->sense[piece->t] = s >= 0.0 ? 1 : r < 0.0 ? -1 : 0;
  piece->to = s >= 0.0 || !is_solid(f, piece->t) ? 1.0
              : r < 0.0                          ? 0.0
                                                 : r / (r - s);
}

/* True where the surface bends up one way and down the other: the normals of
 * the corners of t go round the other way than they. */
static bool
is_saddle(const sg_contour_finder *f, uint32_t t)
{
  const sg_smooth *smooth = f->in->smooth;
  double(*at)[3] = f->in->dense->at;
  double u[3], w[3], n[3], turned[3];

  difference(smooth->normal[smooth->fan[3 * t + 1]],
             smooth->normal[smooth->fan[3 * t]], u);
  difference(smooth->normal[smooth->fan[3 * t + 2]],
             smooth->normal[smooth->fan[3 * t]], w);
  sg_cross(u, w, turned);
  difference(at[sg_contour_vertex(f, 3 * t + 1)],
             at[sg_contour_vertex(f, 3 * t)], u);
  difference(at[sg_contour_vertex(f, 3 * t + 2)],
             at[sg_contour_vertex(f, 3 * t)], w);
  sg_cross(u, w, n);
  return sg_dot(n, turned) < 0.0;
}

/* True if the piece across triangle t, with the radial r in its middle, runs so
 * nearly along the line of sight that its place in the picture is no more than
 * what the triangle is off the smooth surface. */
static bool
is_unsure(const sg_contour_finder *f, uint32_t t, double r)
{
  double a = sg_contour_g(f, 3 * t), b = sg_contour_g(f, 3 * t + 1),
         c = sg_contour_g(f, 3 * t + 2), grad[3], area;
  double most = sg_larger(a, sg_larger(b, c));
  double least = sg_smaller(a, sg_smaller(b, c));

  if (has_apex(f, t) || !is_saddle(f, t)) {
    return false;
  }
  area = gradient(f, t, grad);
  return fabs(r) * area < UNSURE * (most - least) * sg_length(grad);
}

/* The piece across triangle t, if there is one to be drawn. */
static bool
find_piece(sg_contour_finder *f, uint32_t t, sg_contour *piece)
{
  double radial[2] = {0.0, 0.0};
  int ends = 0;
  uint32_t apex = SG_NO_SIDE;

  *piece = (sg_contour){.t = t};
  for (uint32_t i = 3 * t; i < 3 * t + 3; i++) {
    uint32_t next = sg_contour_next(i);
    if (sg_contour_is_apex(f, i)) {
      apex = i;
    } else if (!sg_contour_is_apex(f, next) &&
               is_towards(f, i) != is_towards(f, next)) {
      radial[ends] = end_on_side(f, piece, ends, i);
      ends++;
    }
  }
  if (ends == 1 && apex != SG_NO_SIDE) {
    end_at_corner(f, piece, 1, apex);
    radial[1] = radial[0];
    ends = 2;
  }
  if (ends < 2) {
    return false;
  }
  divide_piece(f, piece, radial[0], radial[1]);
  return !is_unsure(f, t, (radial[0] + radial[1]) / 2.0);
}

static bool
has_length(const sg_contour_finder *f, const sg_contour *piece)
{
  double a[3], b[3];

  sg_contour_point(f, piece, 0, a);
  sg_contour_point(f, piece, 1, b);
  return a[0] != b[0] || a[1] != b[1];
}

void
sg_contour_point(const sg_contour_finder *f, const sg_contour *piece, int end,
                 double out[3])
{
  uint32_t side = 3 * piece->t + piece->side[end];
  uint32_t v = sg_contour_vertex(f, side);
  uint32_t w = sg_contour_vertex(f, sg_contour_next(side));
  const double *a = f->in->screen[v < w ? v : w];
  const double *b = f->in->screen[v < w ? w : v];

  for (int k = 0; k < 3; k++) {
    out[k] =
        piece->at[end] == 1.0 ? b[k] : a[k] + piece->at[end] * (b[k] - a[k]);
  }
}

static bool
push_piece(sg_contours *out, const sg_contour *piece)
{
  if (out->n == out->room) {
    size_t more = out->room ? 2 * out->room : 64;
    sg_contour *wider = realloc(out->piece, more * sizeof *wider);
    if (!wider) {
      return false;
    }
    out->piece = wider;
    out->room = more;
  }
  out->piece[out->n++] = *piece;
  return true;
}

/* Whether a side of a coarse sheet, or a fold, is an outline. Told of one of
 * the two. */
static bool
is_outline(const sg_contour_finder *f, uint32_t side)
{
  uint32_t across = f->in->smooth->across[side];
  unsigned wanted =
      f->in->smooth->coarse[side / 3] ? SG_SIDE_SMOOTH : SG_SIDE_FOLD;

  return across != SG_NO_SIDE && across > side &&
         (f->in->smooth->side[side] & wanted) &&
         (facing(f, side / 3) > 0) != (facing(f, across / 3) > 0);
}

/* The sides of a coarse triangle that are outlines. False: no memory. */
static bool
push_sides(sg_contour_finder *f, uint32_t t)
{
  for (uint8_t k = 0; k < 3; k++) {
    sg_contour piece = {
        .t = t, .side = {k, k}, .at = {0.0, 1.0}, .to = 1.0, .along = true};
    if (is_outline(f, 3 * t + k) && has_length(f, &piece) &&
        !push_piece(f->out, &piece)) {
      return false;
    }
  }
  return true;
}

/* The piece across a triangle that is not coarse. False: no memory. */
static bool
push_across(sg_contour_finder *f, uint32_t t)
{
  sg_contour piece;

  return f->kind[t] != SG_CONTOUR_MIXED || !find_piece(f, t, &piece) ||
         !has_length(f, &piece) || push_piece(f->out, &piece);
}

/* False: stopped, or no memory. */
static bool
find_pieces(sg_contour_finder *f, const sg_poll *poll, bool *memory)
{
  const sg_smooth *smooth = f->in->smooth;

  for (uint32_t t = 0; t < f->in->dense->triangles; t++) {
    if (t % POLL_EVERY == 0 && sg_poll_stop(poll)) {
      return false;
    }
    f->kind[t] = (uint8_t)kind_of(f, t);
    if (!(smooth->curved[t] && !smooth->coarse[t] ? push_across(f, t)
                                                  : push_sides(f, t))) {
      *memory = false;
      return false;
    }
  }
  return true;
}

/* False: stopped, or no memory. */
static bool
find_besides(sg_contour_finder *f, const sg_poll *poll, bool *memory)
{
  for (size_t i = 0; i < f->out->n; i++) {
    if (i % POLL_PIECES == 0 && sg_poll_stop(poll)) {
      return false;
    }
    if (f->out->piece[i].to > 0.0 &&
        !sg_contour_find_beside(f, &f->out->piece[i])) {
      *memory = false;
      return false;
    }
  }
  return true;
}

static bool
find_all(sg_contour_finder *f, const sg_poll *poll, bool *memory)
{
  size_t triangles = f->in->dense->triangles, fans = f->in->smooth->fans;

  f->g = calloc(fans + 1, sizeof *f->g);
  f->radial = calloc(fans + 1, sizeof *f->radial);
  f->kind = calloc(triangles + 1, sizeof *f->kind);
  f->sense = calloc(triangles + 1, sizeof *f->sense);
  f->seen = calloc(triangles + 1, sizeof *f->seen);
  *memory = f->g && f->radial && f->kind && f->sense && f->seen;
  return *memory && find_g(f, poll) && find_radials(f, poll, memory) &&
         find_pieces(f, poll, memory) && find_besides(f, poll, memory);
}

bool
sg_contours_find(const sg_contour_input *in, const sg_poll *poll,
                 sg_contours *out, bool *memory)
{
  sg_contour_finder f = {.in = in, .out = out};
  bool done;

  *out = (sg_contours){0};
  done = find_all(&f, poll, memory);
  free(f.g);
  free(f.radial);
  free(f.kind);
  free(f.sense);
  free(f.seen);
  free(f.queue);
  return done;
}

void
sg_contours_clear(sg_contours *contours)
{
  free(contours->piece);
  free(contours->beside);
  *contours = (sg_contours){0};
}
