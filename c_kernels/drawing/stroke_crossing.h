/* stroke_crossing.h -- where strokes on a sheet cross each other.
 *
 * Layer: kernel. Hidden lines meet in dashes where they cross, as ISO 128 wants
 * it; rules/sheet/dash.pl fits the dashes to the places found here. Two pieces
 * of strokes cross if they have a point in common, or come within
 * SG_CROSSING_NEAR of it at an end, along x and along y too, and make an angle
 * of 10 degrees or more: lines at less run beside each other. Neighbours in one
 * stroke never cross. Lengths are in thousandths of a unit of the sheet,
 * rounded to doubles.
 */
#ifndef SG_STROKE_CROSSING_H
#define SG_STROKE_CROSSING_H

#include "engine/cancel.h"

#include <stddef.h>
#include <stdint.h>

/* How near an end counts as on a line; how far apart two marks are. */
enum { SG_CROSSING_NEAR = 20, SG_CROSSING_APART = 200 };

/* Points of a stroke, x and y below 2^52 from 0; not owned. */
typedef struct sg_crossing_stroke {
  const int64_t (*at)[2];
  size_t n;
} sg_crossing_stroke;

/* The stroke with this number, from 1, is crossed so far along it. */
typedef struct sg_stroke_mark {
  int32_t stroke;
  double way;
} sg_stroke_mark;

typedef struct sg_stroke_marks {
  sg_stroke_mark *item; /* [n], the caller frees it */
  size_t n, room;
} sg_stroke_marks;

/* The marks of n strokes, by stroke and way, those of one stroke at least
 * SG_CROSSING_APART from each other. Time: the pieces sorted by x, and those
 * pairs that overlap in x. False: stopped by the cancellation, or no memory;
 * `out` may hold some. */
bool sg_stroke_crossings(const sg_crossing_stroke *stroke, size_t n,
                         const sg_cancel *cancel, sg_stroke_marks *out);

#endif
