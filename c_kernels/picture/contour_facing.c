/* contour_facing.c -- see contour.h: lines on smooth surfaces that are turned
 * to the eye otherwise than their triangles are.
 */
#include "contour_private.h"

#include "number/bounds.h"
#include "number/vector.h"

#include <math.h>

/* What cancels out to less than this part is noise. */
#define THIN 0.01

/* A part of a side, in the picture, from 0 at its smaller vertex to 1; empty if
 * from is not smaller than to. */
typedef struct part {
  double from, to;
} part;

static const part none = {0.0, 0.0}, all = {0.0, 1.0};

static bool
is_solid(const sg_contour_finder *f, uint32_t t)
{
  const sg_dense *d = f->in->dense;

  return f->in->solid[sg_dense_segment_of(d, d->triangle_begin, t)];
}

/* True if triangle t stands for a smooth surface along this side of it. */
static bool
stands_for_surface(const sg_contour_finder *f, uint32_t side)
{
  const sg_smooth *smooth = f->in->smooth;

  return smooth->curved[side / 3] && !smooth->coarse[side / 3] &&
         !sg_contour_bulges(f, side / 3) && !sg_contour_is_apex(f, side) &&
         !sg_contour_is_apex(f, sg_contour_next(side));
}

/* The part under whose surface the eye is; sense -1: over it. */
static part
under_surface(const sg_contour_finder *f, uint32_t side, int sense)
{
  uint32_t a = side, b = sg_contour_next(side);
  bool low_is_a = sg_contour_vertex(f, a) < sg_contour_vertex(f, b);
  bool low = sense * sg_contour_g(f, low_is_a ? a : b) < 0.0;
  bool high = sense * sg_contour_g(f, low_is_a ? b : a) < 0.0;

  if (low == high) {
    return low ? all : none;
  }
  return low ? (part){0.0, sg_contour_zero(f, side)}
             : (part){sg_contour_zero(f, side), 1.0};
}

/* The same of the flat triangle; edge-on, the eye is under it, too. */
static part
under_triangle(const sg_contour_finder *f, uint32_t t, int sense)
{
  return sense * f->face[t] > 0 ? none : all;
}

static part
under(const sg_contour_finder *f, uint32_t side, int sense)
{
  return stands_for_surface(f, side) ? under_surface(f, side, sense)
                                     : under_triangle(f, side / 3, sense);
}

static part
common(part x, part y)
{
  part both = {sg_larger(x.from, y.from), sg_smaller(x.to, y.to)};

  return both.from < both.to ? both : none;
}

/* The sense of a triangle without a piece: by how g grows across the picture,
 * times twice the area there, which is negative if the triangle is turned away;
 * against the way the surface looks. 1 at an apex, and where the triangle is
 * too thin to tell. */
static int
sense_of(const sg_contour_finder *f, uint32_t t)
{
  const sg_smooth *smooth = f->in->smooth;
  double x = 0.0, y = 0.0, sum = 0.0, size = 0.0;

  for (uint32_t i = 3 * t; i < 3 * t + 3; i++) {
    const double *n = smooth->normal[smooth->fan[i]];
    x += sg_dot(n, f->in->eye.row[0]);
    y += sg_dot(n, f->in->eye.row[1]);
    if (sg_contour_is_apex(f, i)) {
      return 1;
    }
  }

  for (uint32_t i = 3 * t; i < 3 * t + 3; i++) {
    uint32_t next = sg_contour_next(i), last = sg_contour_next(next);
    const double *p = f->in->screen[sg_contour_vertex(f, next)];
    const double *q = f->in->screen[sg_contour_vertex(f, last)];
    double term = sg_contour_g(f, i) * ((p[1] - q[1]) * x - (p[0] - q[0]) * y);
    sum += term;
    size += fabs(term);
  }
  return sum > THIN * size ? -1 : 1;
}

/* True if the triangle runs from its side towards the eye. */
static bool
runs_to_eye(const sg_contour_finder *f, uint32_t side)
{
  double(*at)[3] = f->in->dense->at;
  uint32_t next = sg_contour_next(side);
  const double *p = at[sg_contour_vertex(f, side)];
  const double *q = at[sg_contour_vertex(f, next)];
  const double *apex = at[sg_contour_vertex(f, sg_contour_next(next))];
  double along[3], in[3], middle[3], eye[3];

  sg_minus(q, p, along);
  sg_minus(apex, p, in);
  for (int k = 0; k < 3; k++) {
    middle[k] = p[k] + along[k] / 2.0;
  }
  sg_contour_to_eye(f->in, middle, eye);
  return sg_dot(in, eye) * sg_dot(along, along) >
         sg_dot(in, along) * sg_dot(along, eye);
}

/* What is hidden of a side of an open surface that the eye is under in a part:
 * that, if the surface comes between the line and the eye, and the other face,
 * if it goes down from the line, has the eye under it. */
static part
hidden_of_open(const sg_contour_finder *f, uint32_t side, int sense,
               part surface)
{
  uint32_t across = f->in->smooth->across[side];
  bool convex = f->in->smooth->side[side] & SG_SIDE_CONVEX;

  return !runs_to_eye(f, side) ? none
         : across != SG_NO_SIDE && convex == (sense > 0)
             ? common(surface, under(f, across, sense))
             : surface;
}

/* The same of a solid: where the eye is inside. If the other face goes up, that
 * is also where the eye is under that; unless its triangle is turned away, too,
 * all along the side, it has a facing of its own, or hides nothing. */
static part
hidden_of_solid(const sg_contour_finder *f, uint32_t side, part surface)
{
  uint32_t across = f->in->smooth->across[side];
  part other = under(f, across, 1);

  if (f->in->smooth->side[side] & SG_SIDE_CONVEX) {
    return common(surface, other);
  }
  return other.to - other.from == 1.0 && f->face[across / 3] < 0 ? all
                                                                 : surface;
}

static part
hidden_part(const sg_contour_finder *f, uint32_t side, int sense, part surface)
{
  return is_solid(f, side / 3) && f->in->smooth->across[side] != SG_NO_SIDE
             ? hidden_of_solid(f, side, surface)
             : hidden_of_open(f, side, sense, surface);
}

/* What is not hidden of a side, on one side of it. */
static sg_contour
seen_part(uint32_t side, part hidden, int sense)
{
  uint8_t k = (uint8_t)(side % 3);
  sg_contour seen = {
      .t = side / 3, .side = {k, k}, .at = {0.0, 1.0}, .sense = (int8_t)sense};

  seen.visibility = hidden.from > 0.0 || hidden.to < 1.0 ? SG_CONTOUR_VISIBLE
                                                         : SG_CONTOUR_HIDDEN;
  if (hidden.from == 0.0) {
    seen.at[0] = hidden.to;
  } else if (hidden.to == 1.0) {
    seen.at[1] = hidden.from;
  }
  return seen;
}

bool
sg_contour_facing(const sg_contour_finder *f, uint32_t side, sg_facing *out)
{
  uint8_t flags = f->in->smooth->side[side];
  uint32_t t = side / 3;
  part surface, triangle, hidden;
  int sense;

  if (f->kind[t] != SG_CONTOUR_MIXED ||
      ((flags & SG_SIDE_SMOOTH) && !(flags & SG_SIDE_CUT)) ||
      !stands_for_surface(f, side)) {
    return false;
  }
  sense = f->sense[t] ? f->sense[t] : sense_of(f, t);
  surface = under_surface(f, side, sense);
  triangle = under_triangle(f, t, sense);
  if ((surface.from == triangle.from && surface.to == triangle.to) ||
      (sense < 0 && is_solid(f, t))) {
    return false;
  }
  hidden = hidden_part(f, side, sense, surface);
  *out = (sg_facing){.seen = seen_part(side, hidden, sense),
                     .from = hidden.from,
                     .to = hidden.to};
  return true;
}
