/* stroke.h -- drawn parts put end to end: the rule of rules/sheet/stroke.pl
 * fused.
 *
 * Layer: kernel. The order of everything is that of the rule, and a test holds
 * the two together. n log n time.
 *
 *   sg_strokes strokes;
 *   if (!sg_strokes_make(part, n, look, cancel, &strokes, &memory)) ...
 *   for (size_t i = 0; i < strokes.n; i++)
 *     draw(&strokes.item[i], &strokes.step[strokes.item[i].first]);
 *   sg_strokes_clear(&strokes);
 */
#ifndef SG_STROKE_H
#define SG_STROKE_H

#include "engine/cancel.h"

#include <stddef.h>
#include <stdint.h>

/* How parts of one visibility and role look. */
typedef struct sg_stroke_look {
  int rank; /* painted in this order */
  int role; /* equal for looks of equal role */
  bool hidden;
} sg_stroke_look;

/* A part of edge e of segment s, from a to b on the sheet (x, y). There may be
 * millions, so all that is kept of them is small. */
typedef struct sg_stroke_part {
  uint32_t look; /* place in the array of looks */
  int32_t rank;  /* of that look: sg_strokes_make() sets it */
  int32_t s, e;
  double from, to; /* where on the edge */
  int32_t a[2], b[2];
} sg_stroke_part;

typedef enum sg_stroke_end {
  SG_END_JOINT,
  SG_END_CUT,
  SG_END_RING
} sg_stroke_end;

typedef struct sg_stroke {
  uint32_t first, n;  /* its steps: step[first .. first + n - 1] */
  uint8_t start, end; /* sg_stroke_end */
} sg_stroke;

/* A step is the number of a part, counted from 1; below zero: from b to a. */
typedef struct sg_strokes {
  sg_stroke *item; /* [n], in painting order */
  int32_t *step;   /* [parts]: every part is in one stroke */
  sg_stroke_part *part;
  size_t n, parts;
} sg_strokes;

/* The strokes of the parts. Takes part[n], sorts it in place and leaves out
 * what is not drawn; look[] in the order of the names, so that equal ranks are
 * told apart by place. False: stopped by the cancellation, or no memory (then
 * *memory is false), or more than 2^30 parts, which is no memory. Owner: part
 * stays the caller's and must live as long; the rest is freed by
 * sg_strokes_clear(). */
bool sg_strokes_make(sg_stroke_part *part, size_t n, const sg_stroke_look *look,
                     const sg_cancel *cancel, sg_strokes *out, bool *memory);
void sg_strokes_clear(sg_strokes *strokes);

#endif
