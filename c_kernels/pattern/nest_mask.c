/* nest_mask.c -- a piece at an angle: see nest_mask.h. */
#include "nest_mask.h"
#include "engine/list.h"
#include "engine/search.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The squares of a piece: 1: covered, 2 and 3: in the gap. */
typedef struct raster {
  unsigned w, h, gap;
  uint8_t *square; /* [h][w] */
} raster;

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
cover(raster *m, double y, double x0, double x1)
{
  unsigned gap = m->gap;
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
  if (from > to) {
    from = to;
  }
  memset(m->square + (size_t)row * m->w + from, 1, to - from + 1u);
}

/* The squares that the side from p to q touches, and a little more. */
static void
cover_side(raster *m, const double p[2], const double q[2])
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
    cover(m, y, fmin(x0, x1) - slack, fmax(x0, x1) + slack);
  }
}

SG_ORDER(by_size, double, SG_BY_AT(0));

/* Where the outline crosses the middle lines of rows. */
typedef struct crossings {
  size_t *end; /* [rows]: after the last one of each */
  double *x;
} crossings;

/* The first and the last row whose middle line the side from p to q may cross.
 */
static void
rows_of_side(const double p[2], const double q[2], unsigned rows,
             unsigned *first, unsigned *last)
{
  double low = floor(fmin(p[1], q[1])) - 1, high = ceil(fmax(p[1], q[1]));

  *first = (unsigned)fmin(fmax(low, 0.0), rows);
  *last = (unsigned)fmin(fmax(high, 0.0), rows - 1.0);
}

/* Counts the crossings of the rows, or enters them if there is room. */
static void
cross_side(const double p[2], const double q[2], unsigned rows, size_t *count,
           double *x)
{
  unsigned first, last;

  rows_of_side(p, q, rows, &first, &last);
  for (unsigned row = first; row <= last; row++) {
    double y = row + 0.5;

    if ((p[1] <= y) == (q[1] <= y)) {
      continue;
    }
    if (x) {
      x[count[row]] = p[0] + (q[0] - p[0]) * ((y - p[1]) / (q[1] - p[1]));
    }
    count[row]++;
  }
}

static void
cross_sides(const sg_nest_piece *piece, const double (*at)[2], unsigned rows,
            size_t *count, double *x)
{
  size_t first = 0;

  for (size_t loop = 0; loop < piece->loops; first = piece->loop_end[loop++]) {
    for (size_t i = first; i < piece->loop_end[loop]; i++) {
      const double *q = at[i + 1 < piece->loop_end[loop] ? i + 1 : first];
      cross_side(at[i], q, rows, count, x);
    }
  }
}

static bool
find_crossings(const sg_nest_piece *piece, const double (*at)[2], unsigned rows,
               crossings *out)
{
  size_t all = 0;

  *out = (crossings){.end = calloc(rows, sizeof *out->end)};
  if (!out->end) {
    return false;
  }
  cross_sides(piece, at, rows, out->end, NULL);
  for (unsigned row = 0; row < rows; row++) {
    size_t n = out->end[row];
    out->end[row] = all;
    all += n;
  }
  if (!(out->x = malloc((all + 1) * sizeof *out->x))) {
    return false;
  }
  cross_sides(piece, at, rows, out->end, out->x);
  return true;
}

static bool
cover_piece(raster *m, const sg_nest_piece *piece, const double (*at)[2])
{
  unsigned rows = m->h - 2 * m->gap;
  crossings found;
  size_t first = 0;

  for (size_t loop = 0; loop < piece->loops; first = piece->loop_end[loop++]) {
    for (size_t i = first; i < piece->loop_end[loop]; i++) {
      cover_side(m, at[i], at[i + 1 < piece->loop_end[loop] ? i + 1 : first]);
    }
  }
  bool ok = find_crossings(piece, at, rows, &found);

  first = 0;
  for (unsigned row = 0; ok && row < rows; first = found.end[row++]) {
    size_t n = found.end[row] - first;

    qsort(found.x + first, n, sizeof *found.x, by_size);
    for (size_t i = 0; i + 1 < n; i += 2) {
      cover(m, row, found.x[first + i], found.x[first + i + 1]);
    }
  }
  free(found.end);
  free(found.x);
  return ok;
}

/* Squares of a row nearer than the gap to a covered one become 2. */
static void
widen_row(raster *m, unsigned y)
{
  uint8_t *row = m->square + (size_t)y * m->w;
  unsigned left = 0; /* so many more are near one that was covered */

  for (unsigned x = 0; x < m->w; x++) {
    if (row[x] == 1) {
      left = m->gap;
    } else if (left > 0) {
      row[x] = 2;
      left--;
    }
  }
  left = 0;
  for (unsigned x = m->w; x-- > 0;) {
    if (row[x] == 1) {
      left = m->gap;
    } else if (left > 0) {
      row[x] = 2;
      left--;
    }
  }
}

/* The same of a row and the one before it, up or down: `left` has how many more
 * of each column are near one of those. What is new is 3. */
static void
widen_columns(uint8_t *row, uint8_t *left, unsigned w, unsigned gap)
{
  for (unsigned x = 0; x < w; x++) {
    bool has = row[x] == 1 || row[x] == 2;
    uint8_t near = left[x] > 0;

    row[x] = (uint8_t)(!has && near ? 3 : row[x]);
    left[x] = (uint8_t)(has ? gap : (unsigned)left[x] - near);
  }
}

static bool
widen(raster *m)
{
  uint8_t *left = calloc(m->w, 1);

  if (!left) {
    return false;
  }
  for (unsigned y = 0; y < m->h; y++) {
    widen_row(m, y);
    widen_columns(m->square + (size_t)y * m->w, left, m->w, m->gap);
  }
  memset(left, 0, m->w);
  for (unsigned y = m->h; y-- > 0;) {
    widen_columns(m->square + (size_t)y * m->w, left, m->w, m->gap);
  }
  free(left);
  return true;
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

/* The first square of a row after x that is another than x, or w. */
static unsigned
end_of_same(const uint8_t *row, unsigned x, unsigned w)
{
  uint8_t first = row[x];
  uint64_t all = first * UINT64_C(0x0101010101010101), eight;

  for (; x + sizeof eight <= w; x += (unsigned)sizeof eight) {
    memcpy(&eight, row + x, sizeof eight);
    if (eight != all) {
      break;
    }
  }
  while (x < w && row[x] == first) {
    x++;
  }
  return x;
}

/* The runs of squares up to `most`: 1: of what is covered. */
static bool
find_runs(const raster *m, uint8_t most, sg_nest_runs *out)
{
  size_t room = 0;

  for (unsigned y = 0; y < m->h; y++) {
    const uint8_t *row = m->square + (size_t)y * m->w;

    for (unsigned x = 0; x < m->w;) {
      unsigned from = x;

      while (x < m->w && row[x] > 0 && row[x] <= most) {
        x = end_of_same(row, x, m->w);
      }
      if (x == from) {
        x = end_of_same(row, x, m->w);
        continue;
      }
      if (!sg_list_grow(&out->at, out->n, &room, sizeof *out->at)) {
        return false;
      }
      out->at[out->n++] =
          (sg_nest_run){(uint16_t)y, (uint16_t)from, (uint16_t)(x - 1)};
    }
  }
  find_widest(out);
  return true;
}

static bool
make_runs(const sg_nest_piece *piece, const double (*at)[2], sg_nest_mask *m)
{
  raster r = {m->w, m->h, m->gap, calloc((size_t)m->w * m->h, 1)};
  bool ok = r.square && cover_piece(&r, piece, at) && widen(&r) &&
            find_runs(&r, 1, &m->covered) && find_runs(&r, 3, &m->needed);

  for (size_t i = 0; ok && i < m->covered.n; i++) {
    m->squares += m->covered.at[i].to - m->covered.at[i].from + 1u;
  }
  free(r.square);
  return ok;
}

static void
free_mask(sg_nest_mask *m)
{
  free(m->covered.at);
  free(m->needed.at);
  free(m);
}

/* NULL: it is too large, or, if not *memory, there is no memory. */
static sg_nest_mask *
make_mask(const sg_nest_paper *paper, unsigned most_w, unsigned most_h,
          const sg_nest_piece *piece, double degrees, bool *memory)
{
  sg_nest_mask *m = calloc(1, sizeof *m);
  double high[2], square = paper->square;
  double(*at)[2] =
      m ? turned_points(piece, degrees, square, m->low, high) : NULL;
  bool fits = false, ok = at != NULL;

  if (ok) {
    double w = floor((high[0] - m->low[0]) / square + 1e-6) + 1.0;
    double h = floor((high[1] - m->low[1]) / square + 1e-6) + 1.0;

    m->degrees = degrees;
    m->square = square;
    m->gap = paper->gap;
    fits = w + 2.0 * m->gap <= most_w && h + 2.0 * m->gap <= most_h;
    if (fits) {
      m->w = (unsigned)w + 2 * m->gap;
      m->h = (unsigned)h + 2 * m->gap;
      ok = make_runs(piece, (const double(*)[2])at, m);
    }
  }
  free(at);
  *memory = ok;
  if (m && !(fits && ok)) {
    free_mask(m);
    m = NULL;
  }
  return m;
}

/* ---- masks of all pieces ---- */

typedef struct piece_masks {
  sg_nest_mask **at;
  size_t n, room;
} piece_masks;

struct sg_nest_masks {
  piece_masks *of; /* [pieces] */
  size_t pieces, bytes;
};

sg_nest_masks *
sg_nest_masks_open(size_t pieces)
{
  sg_nest_masks *masks = calloc(1, sizeof *masks);

  if (masks) {
    masks->pieces = pieces;
    masks->of = calloc(pieces + 1, sizeof *masks->of);
  }
  if (masks && !masks->of) {
    free(masks);
    masks = NULL;
  }
  return masks;
}

void
sg_nest_masks_clear(sg_nest_masks *masks, size_t bytes)
{
  if (masks->bytes <= bytes) {
    return;
  }
  for (size_t i = 0; i < masks->pieces; i++) {
    for (size_t k = 0; k < masks->of[i].n; k++) {
      free_mask(masks->of[i].at[k]);
    }
    masks->of[i].n = 0;
  }
  masks->bytes = 0;
}

void
sg_nest_masks_close(sg_nest_masks *masks)
{
  if (!masks) {
    return;
  }
  for (size_t i = 0; i < masks->pieces; i++) {
    for (size_t k = 0; k < masks->of[i].n; k++) {
      free_mask(masks->of[i].at[k]);
    }
    free(masks->of[i].at);
  }
  free(masks->of);
  free(masks);
}

bool
sg_nest_masks_at(sg_nest_masks *masks, const sg_nest_paper *paper,
                 unsigned most_w, unsigned most_h, const sg_nest_piece *piece,
                 double degrees, const sg_nest_mask **out)
{
  piece_masks *of = &masks->of[piece->number];
  bool memory;

  *out = NULL;
  for (size_t i = 0; i < of->n; i++) {
    sg_nest_mask *m = of->at[i];

    if (m->degrees == degrees && m->square == paper->square &&
        m->gap == paper->gap) {
      *out = m->w <= most_w && m->h <= most_h ? m : NULL;
      return true;
    }
  }
  if (!sg_list_grow(&of->at, of->n, &of->room, sizeof *of->at)) {
    return false;
  }
  sg_nest_mask *m = make_mask(paper, most_w, most_h, piece, degrees, &memory);

  if (m) {
    of->at[of->n++] = m;
    masks->bytes +=
        sizeof *m + (m->covered.n + m->needed.n) * sizeof(sg_nest_run);
  }
  *out = m;
  return memory;
}
