/* nest_mask.h -- a piece as squares of the paper.
 *
 * Layer: kernel. Between nest.c and nest_mask.c.
 */
#ifndef SG_NEST_MASK_H
#define SG_NEST_MASK_H

#include "nest.h"

/* A run of squares, of row `row`: from <= x <= to. */
typedef struct sg_nest_run {
  uint16_t row, from, to;
} sg_nest_run;

typedef struct sg_nest_runs {
  sg_nest_run *at; /* row by row, from left to right */
  size_t n;
  unsigned widest; /* the longest of them, squares, */
  unsigned row;    /* and where it is */
} sg_nest_runs;

/* A piece at an angle, on a raster. */
typedef struct sg_nest_mask {
  double degrees, square;
  unsigned gap;
  unsigned w, h;        /* with the gap all round */
  double low[2];        /* lower left corner of the turned piece */
  size_t squares;       /* covered ones */
  sg_nest_runs covered; /* by the piece */
  sg_nest_runs needed;  /* the same with the gap round it */
} sg_nest_mask;

/* The mask of a piece turned by `degrees`; *out is NULL if it is larger than
 * most_w x most_h squares. Rounded: a square that an outline may touch is
 * covered. False: no memory. Owner: the masks, until they are cleared. */
bool sg_nest_masks_at(sg_nest_masks *masks, const sg_nest_paper *paper,
                      unsigned most_w, unsigned most_h,
                      const sg_nest_piece *piece, double degrees,
                      const sg_nest_mask **out);

/* Forgets all masks, if they take more than so many bytes. */
void sg_nest_masks_clear(sg_nest_masks *masks, size_t bytes);

#endif
