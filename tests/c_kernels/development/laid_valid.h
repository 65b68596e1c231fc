/* laid_valid.h -- what lay.h says of where pieces lie, asked without its means.
 */
#ifndef SG_TEST_LAID_VALID_H
#define SG_TEST_LAID_VALID_H

#include "flat_model.h"

static inline double
laid_side(const sg_flat_box *box, int axis)
{
  return box->high[axis] - box->low[axis];
}

/* How much of a piece lies along a direction. */
static inline double
laid_width(const unfolded *u, uint32_t piece, double x, double y)
{
  double low = INFINITY, high = -INFINITY;

  for (uint32_t f = 0; f < u->faces.faces; f++) {
    if (u->layout.piece[f] != piece) {
      continue;
    }
    for (uint32_t c = u->faces.corner_begin[f];
         c < u->faces.corner_begin[f + 1]; c++) {
      const double *at = u->layout.at[u->layout.vertex[c]];

      low = fmin(low, at[0] * x + at[1] * y);
      high = fmax(high, at[0] * x + at[1] * y);
    }
  }
  return (high - low) / hypot(x, y);
}

/* Vertices are in the order of their first corners. */
static inline bool
laid_in_order(const unfolded *u)
{
  uint32_t next = 0;

  for (uint32_t c = 0; c < u->faces.corners; c++) {
    uint32_t v = u->layout.vertex[c];

    if (v > next || (v == next && u->layout.first[v] != c)) {
      return false;
    }
    next += v == next;
  }
  return next == u->layout.vertices;
}

/* The faces of each piece are as large as it is: the largest piece first, its
 * root the largest of its faces. */
static inline bool
laid_by_area(const unfolded *u)
{
  double before = INFINITY;
  bool good = true;

  for (uint32_t k = 0; k < u->layout.pieces; k++) {
    double area = 0, most = 0;

    for (uint32_t f = 0; f < u->faces.faces; f++) {
      bool in = u->layout.piece[f] == k;
      area += in ? u->faces.area[f] : 0;
      most = in ? fmax(most, u->faces.area[f]) : most;
    }
    good = good && area <= before * (1 + 1e-9) &&
           u->faces.area[u->layout.root[k]] == most &&
           u->layout.piece[u->layout.root[k]] == k;
    before = area;
  }
  return good;
}

/* Each box is that of its piece, no side of the piece has a smaller one along
 * it, and its longer side is along x. */
static inline bool
laid_in_boxes(const unfolded *u)
{
  const double close = 1e-9 * u->flattening.sheet;
  bool good = true;

  for (uint32_t k = 0; k < u->layout.pieces; k++) {
    const sg_flat_box *box = &u->layout.box[k];
    double w = laid_side(box, 0), h = laid_side(box, 1);

    good = good && w >= h - close &&
           fabs(w - laid_width(u, k, 1, 0)) <= close &&
           fabs(h - laid_width(u, k, 0, 1)) <= close;
    for (uint32_t s = 0; good && s < u->faces.sides; s++) {
      const sg_flat_side *side = &u->faces.side[s];
      const double *p = u->layout.at[u->layout.vertex[side->from]];
      const double *q = u->layout.at[u->layout.vertex[side->to]];
      double x = q[0] - p[0], y = q[1] - p[1];

      good = u->layout.piece[u->faces.face_of[s]] != k ||
             hypot(x, y) <= close ||
             laid_width(u, k, x, y) * laid_width(u, k, -y, x) >=
                 w * h * (1 - 1e-9);
    }
  }
  return good;
}

/* Boxes lie in rows from the origin, the first below; a gap is as wide as a
 * sixteenth of the shorter side of some box, and of none more. */
static inline bool
laid_in_rows(const unfolded *u)
{
  const double close = 1e-9 * u->flattening.sheet;
  double gap = 0, area = 0, most = 0, x = 0, y = 0, high = 0;
  bool good = true;

  for (uint32_t k = 0; k < u->layout.pieces; k++) {
    double w = laid_side(&u->layout.box[k], 0);
    double h = laid_side(&u->layout.box[k], 1);

    gap = fmax(gap, fmin(w, h) / 16);
    area += w * h;
    most = fmax(most, w);
  }
  most = fmax(most, 1.25 * sqrt(area));
  for (uint32_t k = 0; good && k < u->layout.pieces; k++) {
    const sg_flat_box *box = &u->layout.box[k];

    if (k > 0 && box->low[1] > y + close) { /* it had no room in the row */
      good = x + laid_side(box, 0) > most - close;
      y += high + gap;
      x = high = 0;
    }
    good = good && fabs(box->low[0] - x) <= close &&
           fabs(box->low[1] - y) <= close && box->high[0] <= most + close;
    x = box->high[0] + gap;
    high = fmax(high, laid_side(box, 1));
  }
  return good;
}

static inline void
check_laid(const unfolded *u)
{
  CHECK("vertices are in order", laid_in_order(u));
  CHECK("the largest piece comes first", laid_by_area(u));
  CHECK("pieces lie along their boxes", laid_in_boxes(u));
  CHECK("boxes lie in rows", laid_in_rows(u));
}

#endif
