/* nest_mask.h -- a piece as squares of the paper.
 *
 * Layer: kernel. Between nest.c and nest_mask.c.
 */
#ifndef SG_NEST_MASK_H
#define SG_NEST_MASK_H

#include "nest.h"

/* A piece at an angle: the squares that it needs, with the gap round it. */
typedef struct sg_nest_mask {
  unsigned w, h;
  uint8_t *square; /* [h][w]: 1: covered, 2: in the gap */
  double low[2];   /* lower left corner of the turned piece */
  size_t covered;
} sg_nest_mask;

/* A run of squares that are needed, of row `row`: from <= x <= to. */
typedef struct sg_nest_run {
  uint16_t row, from, to;
} sg_nest_run;

typedef struct sg_nest_runs {
  sg_nest_run *at;
  size_t n;
  unsigned widest; /* the longest of them, squares, */
  unsigned row;    /* and where it is */
} sg_nest_runs;

/* The mask of a piece turned by `degrees`; a piece that is larger than most_w x
 * most_h squares has none. Rounded: a square that an outline may touch is
 * covered. False: no memory. Owner: the caller, free(m->square), in any case.
 */
bool sg_nest_mask_make(const sg_nest_paper *paper, unsigned most_w,
                       unsigned most_h, const sg_nest_piece *piece,
                       double degrees, sg_nest_mask *m);

/* The runs of a mask that are not 0, row by row; those that are 1, if only
 * `covered`. Sets m->covered. False: no memory. Owner: the caller,
 * free(out->at), in any case. */
bool sg_nest_mask_runs(sg_nest_mask *m, bool covered, sg_nest_runs *out);

#endif
