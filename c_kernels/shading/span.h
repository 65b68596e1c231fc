/* span.h -- parts of a scan line where one face is seen.
 *
 * Layer: kernel.
 */
#ifndef SG_SPAN_H
#define SG_SPAN_H

#include <stddef.h>
#include <stdint.h>

/* All of the light of a place. */
#define SG_OPAQUE 65536

/* Ends are in 1/256 dot from the left border of the picture, x1 < x2. */
typedef struct sg_span {
  int32_t x1, x2;
  int32_t root;     /* the segment that is seen */
  int32_t leaf;     /* number of the leaf whose face it is, 1.. */
  int32_t face;     /* of that leaf */
  uint32_t surface; /* of the scene: private */
  int16_t sense;    /* 1: the line of sight enters the leaf; -1: it leaves;
                       more: which root of a torus, sg_quartic_root */
  uint16_t sheet;   /* of a torus on this line, 1 ..: what goes on has one
                       number, also where the root becomes another; else 0 */
  uint32_t part;    /* of the light there, 1 .. SG_OPAQUE: its own */
} sg_span;

/* The spans of one line. Where all is opaque, from left to right, and they do
 * not overlap; else those of one layer do not, and the parts of a place add up
 * to SG_OPAQUE at most. */
typedef struct sg_spans {
  sg_span *span; /* [n] */
  size_t n, room;
} sg_spans;

/* Whether q goes on where p ends, as the same sheet. */
static inline bool
sg_span_goes_on(const sg_span *p, const sg_span *q)
{
  return p->x2 == q->x1 && p->root == q->root && p->leaf == q->leaf &&
         p->face == q->face && p->surface == q->surface && p->part == q->part &&
         p->sheet == q->sheet;
}

/* sweep.c: what goes on becomes one span, of the sense that it begins with. */
void sg_spans_join(sg_spans *line);

/* The dots whose middles are in a span: from *x up to, not with, the result. */
static inline int32_t
sg_span_dots(const sg_span *span, int32_t *x)
{
  *x = (span->x1 + 127) / 256;
  return (span->x2 + 127) / 256;
}

#endif
