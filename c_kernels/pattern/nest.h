/* nest.h -- pieces laid on as few sheets as possible, none on another.
 *
 * Layer: kernel. Pieces are drawn with squares of a raster: every square that
 * an outline touches or that lies inside. Where no square is taken twice no
 * piece lies on another. Each piece, in the order given, goes to the first
 * sheet that takes it, at the angle and the place where it reaches up least,
 * of these the leftmost. A sheet that refused eight pieces about as long and
 * about as large is passed over: so time grows with the number of pieces, not
 * with its square. The result depends on the input alone.
 */
#ifndef SG_NEST_H
#define SG_NEST_H

#include "engine/cancel.h"

#include <stddef.h>
#include <stdint.h>

/* The outline of a piece: closed loops of points, x right and y up, one after
 * another; what is inside an odd number of them is inside. */
typedef struct sg_nest_piece {
  const double (*at)[2]; /* [points] */
  size_t points;
  const size_t *loop_end; /* [loops]: after the last point of each */
  size_t loops;
  const double *degrees; /* [angles]: how it may be turned, counterclockwise */
  size_t angles;
  size_t number; /* in masks; not used without */
} sg_nest_piece;

/* Pieces as squares, which are made once for each angle and raster: many
 * nestings of the same pieces, one after another, may share them. Pieces of
 * one nesting with the same number have the same outline. */
typedef struct sg_nest_masks sg_nest_masks;

/* Of so many pieces, with numbers from 0. NULL: no memory. */
sg_nest_masks *sg_nest_masks_open(size_t pieces);
void sg_nest_masks_close(sg_nest_masks *masks);

/* Point p of the piece comes to p turned by degrees, plus by, on a sheet, from
 * 1, whose lower left corner is 0, 0. Sheet 0: too large for any. */
typedef struct sg_nest_place {
  uint32_t sheet;
  double degrees, by[2];
} sg_nest_place;

typedef struct sg_nest_paper {
  double width, height;
  double square; /* side of a square of the raster */
  unsigned gap;  /* so many squares, to 255, stay free between pieces */
  bool one;      /* a single sheet: what does not fit has no place */
} sg_nest_paper;

/* False: stopped by the cancellation, or no memory (then *memory is false).
 * *work, which may be NULL, grows by how many squares and runs of squares were
 * looked at: a measure of time that is the same on every machine, whether masks
 * were made already or not. `masks` may be NULL. */
bool sg_nest(const sg_nest_paper *paper, const sg_nest_piece *piece, size_t n,
             sg_nest_masks *masks, sg_nest_place *place, uint64_t *work,
             const sg_cancel *cancel, bool *memory);

/* True if the raster of a sheet has a sane number of squares. */
bool sg_nest_paper_is_valid(const sg_nest_paper *paper);

#endif
