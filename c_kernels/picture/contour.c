/* contour.c -- see contour.h */
#include "contour_private.h"

#include "engine/list.h"
#include "number/bounds.h"
#include "number/vector.h"

#include <math.h>
#include <stdlib.h>

/* What is nearer to zero than this is zero: views along a symmetry of the
 * model give the same outline on every machine. */
#define ZERO 1e-12

/* A triangle is edge-on when its normal leans less than this (as in scene.c).
 */
#define EDGE_ON 1e-9

/* Triangles between two cancellations; pieces, each with a walk. */
enum { ASK_EVERY = 4096, POLL_PIECES = 64 };

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

void
sg_contour_to_eye(const sg_contour_input *in, const double p[3], double out[3])
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

/* ----------------------------------------------------------- the corners */

/* False: stopped. */
static bool
find_g(sg_contour_finder *f, const sg_cancel *cancel)
{
  const sg_smooth *smooth = f->in->smooth;

  for (uint32_t i = 0; i < 3 * f->in->dense->triangles; i++) {
    uint32_t fan = smooth->fan[i];
    double eye[3];
    if (i % ASK_EVERY == 0 && sg_cancelled(cancel)) {
      return false;
    }
    if (smooth->curved[i / 3]) {
      sg_contour_to_eye(f->in, f->in->dense->at[sg_contour_vertex(f, i)], eye);
      f->g[fan] = sg_dot(smooth->normal[fan], eye);
      f->g[fan] = fabs(f->g[fan]) < ZERO ? 0.0 : f->g[fan];
    }
  }
  return true;
}

/* --------------------------------------------------------- the triangles */

/* 1: turned to the eye, -1: turned away, 0: edge-on. */
static int8_t
facing(const sg_contour_finder *f, uint32_t t)
{
  const double(*at)[3] = f->in->screen;
  const int32_t *v = f->in->dense->corner[t];
  double side[2][3], n[3], edge;

  sg_minus(at[v[1]], at[v[0]], side[0]);
  sg_minus(at[v[2]], at[v[0]], side[1]);
  shrink(side, 2);
  sg_cross(side[0], side[1], n);
  edge = EDGE_ON * sg_length(n);
  return (int8_t)((n[2] > edge) - (n[2] < -edge));
}

static sg_contour_kind
kind_of(const sg_contour_finder *f, uint32_t t)
{
  int face = f->face[t], towards = 0, away = 0;

  for (uint32_t i = 3 * t; i < 3 * t + 3; i++) {
    if (f->in->smooth->curved[t] && !sg_contour_is_apex(f, i)) {
      towards += sg_contour_is_towards(f, i);
      away += !sg_contour_is_towards(f, i);
    }
  }
  return face > 0 && away == 0      ? SG_CONTOUR_TOWARDS
         : face < 0 && towards == 0 ? SG_CONTOUR_AWAY
                                    : SG_CONTOUR_MIXED;
}

/* ------------------------------------------------------------ the pieces */

double
sg_contour_zero(const sg_contour_finder *f, uint32_t side)
{
  double(*at)[3] = f->in->dense->at;
  uint32_t a = side, b = sg_contour_next(side);
  uint32_t v = sg_contour_vertex(f, a), w = sg_contour_vertex(f, b);
  double zero, near_low, near_high;

  zero =
      v < w ? sg_contour_model_zero(f, a, b) : sg_contour_model_zero(f, b, a);
  near_low = (1.0 - zero) * sg_contour_distance(f->in, at[v < w ? v : w]);
  near_high = zero * sg_contour_distance(f->in, at[v < w ? w : v]);
  return near_high / (near_low + near_high);
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

bool
sg_contour_bulges(const sg_contour_finder *f, uint32_t t)
{
  const uint8_t *side = f->in->smooth->side + 3 * (size_t)t;

  return (side[0] | side[1] | side[2]) & SG_SIDE_BULGES;
}

/* End `end` of a piece is on a side whose corners differ: at its zero. Where
 * the sheet ends and a smooth surface would bulge, at the corner at which the
 * triangles turn from the eye: there the line is outermost in the picture. */
static void
end_on_side(const sg_contour_finder *f, sg_contour *piece, int end,
            uint32_t side)
{
  uint32_t next = sg_contour_next(side);
  bool away = f->face[side / 3] < 0;

  if ((f->in->smooth->side[side] & SG_SIDE_SMOOTH) ||
      !sg_contour_bulges(f, side / 3)) {
    piece->side[end] = (uint8_t)(side % 3);
    piece->at[end] = sg_contour_zero(f, side);
    sg_contour_rise(f, side, piece->rise[end]);
  } else {
    end_at_corner(f, piece, end,
                  sg_contour_is_towards(f, side) == away ? side : next);
  }
}

static bool
is_solid(const sg_contour_finder *f, uint32_t t)
{
  const sg_dense *d = f->in->dense;

  return f->in->solid[sg_dense_segment_of(d, d->triangle_begin, t)];
}

/* Which half of the surface beside a piece is nearer the eye: 1 that which is
 * turned to it, -1 the other. The piece has the half that is turned to the eye
 * on its left, seen from outside; the line of sight is a tangent, so the normal
 * is seen across the piece: on its right, if that half is the nearer one. */
static int8_t
sense_of(const sg_contour_finder *f, const sg_contour *piece)
{
  const sg_smooth *smooth = f->in->smooth;
  double a[3], b[3], x = 0.0, y = 0.0;

  for (uint32_t i = 3 * piece->t; i < 3 * piece->t + 3; i++) {
    x += sg_dot(smooth->normal[smooth->fan[i]], f->in->eye.row[0]);
    y += sg_dot(smooth->normal[smooth->fan[i]], f->in->eye.row[1]);
  }
  sg_contour_point(f, piece, 0, a);
  sg_contour_point(f, piece, 1, b);
  return (b[0] - a[0]) * y - (b[1] - a[1]) * x > 0.0 ? -1 : 1;
}

/* The piece across triangle t, with what is turned to the eye on its left, seen
 * from outside. False: there is none. */
static bool
run_across(const sg_contour_finder *f, uint32_t t, sg_contour *piece)
{
  int ends = 0, end = 0;
  uint32_t apex = SG_NO_SIDE;

  *piece = (sg_contour){.t = t};
  for (uint32_t i = 3 * t; i < 3 * t + 3; i++) {
    uint32_t next = sg_contour_next(i);
    if (sg_contour_is_apex(f, i)) {
      apex = i;
    } else if (!sg_contour_is_apex(f, next) &&
               sg_contour_is_towards(f, i) != sg_contour_is_towards(f, next)) {
      end = sg_contour_is_towards(f, i) ? 0 : 1;
      end_on_side(f, piece, end, i);
      ends++;
    }
  }
  if (ends == 1 && apex != SG_NO_SIDE) {
    end_at_corner(f, piece, 1 - end, apex);
    ends = 2;
  }
  piece->sense = f->sense[t] < 0 ? -1 : 1;
  piece->visibility = piece->sense > 0 || !is_solid(f, t) ? SG_CONTOUR_VISIBLE
                                                          : SG_CONTOUR_HIDDEN;
  return ends == 2;
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
    out[k] += k < 2 ? piece->rise[end][k] : 0.0;
  }
}

static bool
push_piece(sg_contours *out, const sg_contour *piece)
{
  if (!sg_list_grow(&out->piece, out->n, &out->room, sizeof *out->piece)) {
    return false;
  }
  out->piece[out->n++] = *piece;
  return true;
}

/* True if a triangle on one side of a side is turned to the eye, and that on
 * the other is not. */
static bool
turns(const sg_contour_finder *f, uint32_t side)
{
  uint32_t across = f->in->smooth->across[side];

  return across != SG_NO_SIDE &&
         (f->face[side / 3] > 0) != (f->face[across / 3] > 0);
}

/* Whether a side of a sheet that is drawn as smooth, at which triangles turn
 * from the eye, may be seen beside its outline: not if the sheet is never seen
 * there from the side it bends to. */
static bool
substitute_outline(const sg_contour_finder *f, uint32_t side)
{
  uint8_t flags = f->in->smooth->side[side];
  uint32_t t = side / 3, u = f->in->smooth->across[side] / 3;

  return (flags & SG_SIDE_SMOOTH) &&
         ((flags & SG_SIDE_CONVEX) || !is_solid(f, t)) &&
         (sg_contour_bulges(f, t) || sg_contour_bulges(f, u));
}

/* Whether a side at which triangles turn from the eye is an outline: of a
 * coarse sheet always, of a smooth one if it is a substitute outline, of any
 * other if a polygon is folded. */
static bool
is_outline(const sg_contour_finder *f, uint32_t side)
{
  const sg_smooth *smooth = f->in->smooth;
  uint8_t flags = smooth->side[side];

  return !smooth->curved[side / 3]  ? flags & SG_SIDE_FOLD
         : smooth->coarse[side / 3] ? flags & SG_SIDE_SMOOTH
                                    : substitute_outline(f, side);
}

/* False: no memory. */
static bool
push_long(const sg_contour_finder *f, const sg_contour *piece)
{
  return !has_length(f, piece) || push_piece(f->out, piece);
}

/* The k-th side of a triangle, from end to end. False: no memory. */
static bool
push_side(const sg_contour_finder *f, uint32_t t, uint8_t k)
{
  const sg_smooth *smooth = f->in->smooth;
  bool drawn_smooth = smooth->curved[t] && !smooth->coarse[t];
  const sg_contour piece = {.t = t,
                            .side = {k, k},
                            .at = {0.0, 1.0},
                            .visibility = drawn_smooth ? SG_CONTOUR_SUBSTITUTE
                                                       : SG_CONTOUR_VISIBLE,
                            .along = true};

  return push_long(f, &piece);
}

/* The sides of a triangle that are outlines, each told of one of its two.
 * False: no memory. */
static bool
push_sides(const sg_contour_finder *f, uint32_t t)
{
  for (uint8_t k = 0; k < 3; k++) {
    uint32_t side = 3 * t + k;
    if (side < f->in->smooth->across[side] && turns(f, side) &&
        is_outline(f, side) && !push_side(f, t, k)) {
      return false;
    }
  }
  return true;
}

/* A piece as it is, or, if it leaves a corner outside, by way of that. False:
 * no memory. */
static bool
push_outermost(const sg_contour_finder *f, const sg_contour *piece)
{
  sg_contour half[2];

  if (!sg_contour_outermost(f, piece, half)) {
    return push_long(f, piece);
  }
  return push_long(f, &half[0]) && push_long(f, &half[1]);
}

/* False: no memory. */
static bool
push_across(sg_contour_finder *f, uint32_t t)
{
  sg_contour piece;

  return !f->sense[t] || !run_across(f, t, &piece) || push_outermost(f, &piece);
}

static bool
push_facing(sg_contours *out, const sg_facing *facing)
{
  if (!sg_list_grow(&out->facing, out->facings, &out->facing_room,
                    sizeof *out->facing)) {
    return false;
  }
  out->facing[out->facings++] = *facing;
  return true;
}

/* False: no memory. */
static bool
push_facings(sg_contour_finder *f, uint32_t t)
{
  sg_facing facing;

  for (uint32_t side = 3 * t; side < 3 * t + 3; side++) {
    if (sg_contour_facing(f, side, &facing) && !push_facing(f->out, &facing)) {
      return false;
    }
  }
  return true;
}

/* How triangles lie to the eye, and the senses of their pieces. False: stopped.
 */
static bool
find_senses(sg_contour_finder *f, const sg_cancel *cancel)
{
  const sg_smooth *smooth = f->in->smooth;
  sg_contour piece;

  for (uint32_t t = 0; t < f->in->dense->triangles; t++) {
    if (t % ASK_EVERY == 0 && sg_cancelled(cancel)) {
      return false;
    }
    f->face[t] = facing(f, t);
    f->kind[t] = (uint8_t)kind_of(f, t);
    if (smooth->curved[t] && !smooth->coarse[t] &&
        f->kind[t] == SG_CONTOUR_MIXED && run_across(f, t, &piece)) {
      f->sense[t] = sense_of(f, &piece);
    }
  }
  return true;
}

/* False: stopped, or no memory. */
static bool
find_pieces(sg_contour_finder *f, const sg_cancel *cancel, bool *memory)
{
  for (uint32_t t = 0; t < f->in->dense->triangles; t++) {
    if (t % ASK_EVERY == 0 && sg_cancelled(cancel)) {
      return false;
    }
    if (!push_across(f, t) || !push_sides(f, t) || !push_facings(f, t)) {
      *memory = false;
      return false;
    }
  }
  return true;
}

/* False: no memory. */
static bool
find_adjacent(sg_contour_finder *f, sg_contour *piece)
{
  return piece->visibility == SG_CONTOUR_HIDDEN || !has_length(f, piece) ||
         sg_contour_find_adjacent(f, piece);
}

/* False: stopped, or no memory. */
static bool
find_adjacents(sg_contour_finder *f, const sg_cancel *cancel, bool *memory)
{
  sg_contours *out = f->out;

  for (size_t i = 0; i < out->n + out->facings; i++) {
    sg_contour *piece =
        i < out->n ? &out->piece[i] : &out->facing[i - out->n].seen;
    if (i % POLL_PIECES == 0 && sg_cancelled(cancel)) {
      return false;
    }
    if (!find_adjacent(f, piece)) {
      *memory = false;
      return false;
    }
  }
  return true;
}

static bool
find_all(sg_contour_finder *f, const sg_cancel *cancel, bool *memory)
{
  size_t triangles = f->in->dense->triangles, fans = f->in->smooth->fans;

  f->g = calloc(fans + 1, sizeof *f->g);
  f->face = calloc(triangles + 1, sizeof *f->face);
  f->kind = calloc(triangles + 1, sizeof *f->kind);
  f->sense = calloc(triangles + 1, sizeof *f->sense);
  f->seen = calloc(triangles + 1, sizeof *f->seen);
  *memory = f->g && f->face && f->kind && f->sense && f->seen;
  return *memory && find_g(f, cancel) && find_senses(f, cancel) &&
         find_pieces(f, cancel, memory) && find_adjacents(f, cancel, memory);
}

bool
sg_contours_find(const sg_contour_input *in, const sg_cancel *cancel,
                 sg_contours *out, bool *memory)
{
  sg_contour_finder f = {.in = in, .out = out};
  bool done;

  *out = (sg_contours){0};
  done = find_all(&f, cancel, memory);
  free(f.g);
  free(f.face);
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
  free(contours->facing);
  free(contours->adjacent);
  *contours = (sg_contours){0};
}
