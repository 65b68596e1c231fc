/* nest_mask.c -- a piece at an angle: see nest_mask.h. */
#include "nest_mask.h"
#include "engine/list.h"

#include <math.h>
#include <stdlib.h>

static void
turn(const double p[2], const double axis[2], double out[2])
{
  out[0] = p[0] * axis[0] - p[1] * axis[1];
  out[1] = p[0] * axis[1] + p[1] * axis[0];
}

static void
axis_of(double degrees, double axis[2])
{
  double angle = degrees * (3.14159265358979323846 / 180.0);

  axis[0] = cos(angle);
  axis[1] = sin(angle);
}

/* The turned points, in squares from the lower left corner of the piece. */
static double (*turned_points(const sg_nest_piece *piece, double degrees,
                              double square, double low[2], double high[2]))[2]
{
  double(*at)[2] = malloc((piece->points + 1) * sizeof *at);
  double axis[2];

  axis_of(degrees, axis);
  low[0] = low[1] = INFINITY;
  high[0] = high[1] = -INFINITY;
  for (size_t i = 0; at && i < piece->points; i++) {
    turn(piece->at[i], axis, at[i]);
    for (int k = 0; k < 2; k++) {
      low[k] = fmin(low[k], at[i][k]);
      high[k] = fmax(high[k], at[i][k]);
    }
  }
  for (size_t i = 0; at && i < piece->points; i++) {
    for (int k = 0; k < 2; k++) {
      at[i][k] = (at[i][k] - low[k]) / square;
    }
  }
  return at;
}

static void
cover(sg_nest_mask *m, unsigned gap, double y, double x0, double x1)
{
  double low = floor(x0), high = floor(x1);
  unsigned row = (unsigned)fmax(y, 0.0) + gap;
  unsigned from = (unsigned)fmax(low, 0.0) + gap;
  unsigned to = (unsigned)fmax(high, 0.0) + gap;

  if (row >= m->h - gap) {
    row = m->h - gap - 1;
  }
  if (to >= m->w - gap) {
    to = m->w - gap - 1;
  }
  for (unsigned x = from < to ? from : to; x <= to; x++) {
    m->square[(size_t)row * m->w + x] = 1;
  }
}

/* The squares that the side from p to q touches, and a little more. */
static void
cover_side(sg_nest_mask *m, unsigned gap, const double p[2], const double q[2])
{
  const double slack = 1e-6;
  const double *a = p[1] < q[1] ? p : q, *b = p[1] < q[1] ? q : p;

  for (double y = floor(a[1] - slack); y <= floor(b[1] + slack); y += 1.0) {
    double y0 = fmax(a[1], y - slack), y1 = fmin(b[1], y + 1.0 + slack);
    double x0 = a[0], x1 = b[0];

    if (b[1] - a[1] > slack) {
      x0 = a[0] + (b[0] - a[0]) * ((y0 - a[1]) / (b[1] - a[1]));
      x1 = a[0] + (b[0] - a[0]) * ((y1 - a[1]) / (b[1] - a[1]));
    }
    cover(m, gap, y, fmin(x0, x1) - slack, fmax(x0, x1) + slack);
  }
}

static int
by_size(const void *a, const void *b)
{
  double x = *(const double *)a, y = *(const double *)b;

  return (x > y) - (x < y);
}

/* Where the middle line of row y crosses the outline; returns how often. */
static size_t
crossings(const sg_nest_piece *piece, const double (*at)[2], double y,
          double *x)
{
  size_t n = 0, first = 0;

  for (size_t loop = 0; loop < piece->loops; first = piece->loop_end[loop++]) {
    for (size_t i = first; i < piece->loop_end[loop]; i++) {
      const double *p = at[i];
      const double *q = at[i + 1 < piece->loop_end[loop] ? i + 1 : first];

      if ((p[1] <= y) != (q[1] <= y)) {
        x[n++] = p[0] + (q[0] - p[0]) * ((y - p[1]) / (q[1] - p[1]));
      }
    }
  }
  qsort(x, n, sizeof *x, by_size);
  return n;
}

static bool
cover_piece(sg_nest_mask *m, unsigned gap, const sg_nest_piece *piece,
            const double (*at)[2])
{
  double *x = malloc((piece->points + 1) * sizeof *x);
  size_t first = 0;

  for (size_t loop = 0; loop < piece->loops; first = piece->loop_end[loop++]) {
    for (size_t i = first; i < piece->loop_end[loop]; i++) {
      cover_side(m, gap, at[i],
                 at[i + 1 < piece->loop_end[loop] ? i + 1 : first]);
    }
  }
  for (unsigned row = 0; x && row < m->h - 2 * gap; row++) {
    size_t n = crossings(piece, at, row + 0.5, x);

    for (size_t i = 0; i + 1 < n; i += 2) {
      cover(m, gap, row, x[i], x[i + 1]);
    }
  }
  free(x);
  return x != NULL;
}

/* Squares nearer than the gap to a covered one become 2. */
static void
widen_row(sg_nest_mask *m, unsigned gap, unsigned y)
{
  uint8_t *row = m->square + (size_t)y * m->w;

  for (unsigned x = 0; x < m->w; x++) {
    if (row[x] == 1) {
      unsigned from = x - gap, to = x + gap;

      for (unsigned i = from; i <= to; i++) {
        row[i] = row[i] ? row[i] : 2;
      }
    }
  }
}

/* The same up and down column x; what is new is 3. */
static void
widen_column(sg_nest_mask *m, unsigned gap, unsigned x)
{
  size_t w = m->w;
  unsigned last = 0; /* row with something in it, from 1 */

  for (unsigned y = 1; y <= m->h; y++) {
    uint8_t *square = &m->square[(y - 1) * w + x];

    if (*square == 1 || *square == 2) {
      last = y;
    } else if (last && y - last <= gap) {
      *square = 3;
    }
  }
  last = 0;
  for (unsigned y = m->h; y > 0; y--) {
    uint8_t *square = &m->square[(y - 1) * w + x];

    if (*square == 1 || *square == 2) {
      last = y;
    } else if (last && last - y <= gap) {
      *square = 3;
    }
  }
}

static void
widen(sg_nest_mask *m, unsigned gap)
{
  for (unsigned y = 0; y < m->h; y++) {
    widen_row(m, gap, y);
  }
  for (unsigned x = 0; x < m->w; x++) {
    widen_column(m, gap, x);
  }
}

bool
sg_nest_mask_make(const sg_nest_paper *paper, unsigned most_w, unsigned most_h,
                  const sg_nest_piece *piece, double degrees, sg_nest_mask *m)
{
  unsigned gap = paper->gap;
  double high[2], square = paper->square;
  double(*at)[2] = turned_points(piece, degrees, square, m->low, high);

  m->square = NULL;
  if (!at) {
    return false;
  }
  double w = floor((high[0] - m->low[0]) / square + 1e-6) + 1.0;
  double h = floor((high[1] - m->low[1]) / square + 1e-6) + 1.0;
  bool ok = true;

  if (w + 2.0 * gap <= most_w && h + 2.0 * gap <= most_h) {
    m->w = (unsigned)w + 2 * gap;
    m->h = (unsigned)h + 2 * gap;
    m->square = calloc((size_t)m->w * m->h, 1);
    ok = m->square && cover_piece(m, gap, piece, (const double(*)[2])at);
    if (ok) {
      widen(m, gap);
    }
  }
  free(at);
  return ok;
}

static void
find_widest(sg_nest_runs *r)
{
  for (size_t i = 0; i < r->n; i++) {
    unsigned wide = r->at[i].to - r->at[i].from + 1u;

    if (wide > r->widest) {
      r->widest = wide;
      r->row = r->at[i].row;
    }
  }
}

bool
sg_nest_mask_runs(sg_nest_mask *m, bool covered, sg_nest_runs *out)
{
  size_t room = 0;

  *out = (sg_nest_runs){NULL, 0, 0, 0};
  m->covered = 0;
  for (unsigned y = 0; y < m->h; y++) {
    const uint8_t *row = m->square + (size_t)y * m->w;

    for (unsigned x = 0; x < m->w; x++) {
      m->covered += row[x] == 1;
      if (row[x] == 0 || (covered && row[x] != 1)) {
        continue;
      }
      if (x > 0 && out->n > 0 && out->at[out->n - 1].row == y &&
          out->at[out->n - 1].to == x - 1) {
        out->at[out->n - 1].to = (uint16_t)x;
        continue;
      }
      if (!sg_list_grow(&out->at, out->n, &room, sizeof *out->at)) {
        return false;
      }
      out->at[out->n++] = (sg_nest_run){(uint16_t)y, (uint16_t)x, (uint16_t)x};
    }
  }
  find_widest(out);
  return true;
}
