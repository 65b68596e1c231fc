/* contour_adjacent.c -- see contour.h: the triangles adjacent to a piece.
 */
#include "contour_private.h"
#include "engine/search.h"

#include "engine/list.h"
#include "number/bounds.h"

#include <math.h>
#include <stdlib.h>

/* Equal, in lengths of the piece. */
#define SAME 1e-9

/* A walk ends after so many triangles: what is farther is not adjacent. */
enum { FARTHEST = 1024 };

/* The strip of the picture that the piece sweeps across its direction. */
typedef struct strip {
  double from[2];    /* where the piece starts */
  double along[2];   /* unit, to its end */
  double outward[2]; /* unit, the way the surface looks */
  double length;
  int sense; /* -1: what is turned away from the eye counts as turned to it */
} strip;

static void
strip_open(strip *out, const sg_contour_finder *f, const sg_contour *piece)
{
  const sg_smooth *smooth = f->in->smooth;
  double a[3], b[3], lean = 0.0;

  sg_contour_point(f, piece, 0, a);
  sg_contour_point(f, piece, 1, b);
  *out = (strip){.from = {a[0], a[1]}, .along = {b[0] - a[0], b[1] - a[1]}};
  out->length = hypot(out->along[0], out->along[1]);
  out->along[0] /= out->length;
  out->along[1] /= out->length;
  out->outward[0] = -out->along[1];
  out->outward[1] = out->along[0];
  for (uint32_t i = 3 * piece->t; i < 3 * piece->t + 3; i++) {
    const double *n = smooth->normal[smooth->fan[i]];
    for (int k = 0; k < 2; k++) {
      const double *axis = f->in->eye.row[k];
      lean +=
          out->outward[k] * (n[0] * axis[0] + n[1] * axis[1] + n[2] * axis[2]);
    }
  }
  out->sense = piece->sense;
  if ((lean < 0.0) != (out->sense < 0)) {
    out->outward[0] = -out->outward[0];
    out->outward[1] = -out->outward[1];
  }
}

/* How a triangle lies to the eye, seen from the strip's side of the surface. */
static sg_contour_kind
kind_in(const sg_contour_finder *f, const strip *s, uint32_t t)
{
  sg_contour_kind kind = f->kind[t];

  if (s->sense > 0 || kind == SG_CONTOUR_MIXED) {
    return kind;
  }
  return kind == SG_CONTOUR_AWAY ? SG_CONTOUR_TOWARDS : SG_CONTOUR_AWAY;
}

/* The coordinates of a corner in the strip: along the piece, and outward. */
static void
place_in(const sg_contour_finder *f, const strip *s, uint32_t corner,
         double out[2])
{
  const double *p = f->in->screen[sg_contour_vertex(f, corner)];
  double x = p[0] - s->from[0], y = p[1] - s->from[1];

  out[0] = x * s->along[0] + y * s->along[1];
  out[1] = x * s->outward[0] + y * s->outward[1];
}

/* True if a side goes through the strip; *outmost is how far out it comes
 * there. */
static bool
crosses(const sg_contour_finder *f, const strip *s, uint32_t side,
        double *outmost)
{
  double least = -SAME * s->length, most = (1.0 + SAME) * s->length;
  double a[2], b[2];

  place_in(f, s, side, a);
  place_in(f, s, sg_contour_next(side), b);
  if (sg_larger(a[0], b[0]) < least || sg_smaller(a[0], b[0]) > most) {
    return false;
  }
  *outmost = -INFINITY;
  for (int k = 0; k < 2; k++) {
    double *p = k ? b : a, *q = k ? a : b;
    double x = sg_smaller(sg_larger(p[0], least), most);
    double part = x == p[0] ? 0.0 : (x - p[0]) / (q[0] - p[0]);
    *outmost = sg_larger(*outmost, p[1] + part * (q[1] - p[1]));
  }
  return true;
}

/* True if the walk goes on from a triangle across its side to triangle u. */
static bool
goes_on(const sg_contour_finder *f, const strip *s, uint32_t side, uint32_t u)
{
  unsigned flags = f->in->smooth->side[side];
  bool below = ((flags & SG_SIDE_CONVEX) != 0) == (s->sense > 0);
  double outmost;

  return f->seen[u] != f->walk && ((flags & SG_SIDE_SMOOTH) || below) &&
         kind_in(f, s, u) != SG_CONTOUR_AWAY && f->sense[u] * s->sense >= 0 &&
         crosses(f, s, side, &outmost) &&
         (kind_in(f, s, side / 3) == SG_CONTOUR_MIXED ||
          outmost > -SAME * s->length);
}

static bool
enqueue(sg_contour_finder *f, uint32_t t)
{
  if (!sg_list_grow(&f->queue, f->queued, &f->queue_room, sizeof *f->queue)) {
    return false;
  }
  f->queue[f->queued++] = t;
  f->seen[t] = f->walk;
  return true;
}

static bool
walk(sg_contour_finder *f, const strip *s, uint32_t t)
{
  f->queued = 0;
  f->walk++;
  if (!enqueue(f, t)) {
    return false;
  }
  for (size_t i = 0; i < f->queued && f->queued < FARTHEST; i++) {
    for (uint32_t side = 3 * f->queue[i]; side < 3 * f->queue[i] + 3; side++) {
      uint32_t across = f->in->smooth->across[side];
      if (across != SG_NO_SIDE && goes_on(f, s, side, across / 3) &&
          !enqueue(f, across / 3)) {
        return false;
      }
    }
  }
  return true;
}

/* A side of a coarse sheet lies on the two triangles that have it. False: no
 * memory. */
static bool
take_both(sg_contour_finder *f, const sg_contour *piece)
{
  uint32_t side = 3 * piece->t + piece->side[0];

  f->queued = 0;
  f->walk++;
  return enqueue(f, piece->t) && enqueue(f, f->in->smooth->across[side] / 3);
}

static bool
find_adjacent(sg_contour_finder *f, const sg_contour *piece)
{
  strip s;

  if (piece->along) {
    return take_both(f, piece);
  }
  strip_open(&s, f, piece);
  return walk(f, &s, piece->t);
}

bool
sg_contour_find_adjacent(sg_contour_finder *f, sg_contour *piece)
{
  sg_contours *out = f->out;

  if (!find_adjacent(f, piece)) {
    return false;
  }
  qsort(f->queue, f->queued, sizeof *f->queue, sg_compare_numbers);
  if (!sg_list_need(&out->adjacent, out->adjacents + f->queued,
                    &out->adjacent_room, sizeof *out->adjacent)) {
    return false;
  }
  piece->adjacent = out->adjacents;
  piece->adjacents = f->queued;
  for (size_t i = 0; i < f->queued; i++) {
    out->adjacent[out->adjacents++] = f->queue[i];
  }
  return true;
}
