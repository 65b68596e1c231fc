/* nest.c -- see nest.h */
#include "nest.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_SQUARES_A_SIDE = 32000, MOST_SQUARES = 1 << 27 };

/* A page that refused so many pieces of one kind is not asked for that kind
 * again, so a piece of many takes no longer than one of few. With twice as many
 * refusals sheets are used about as well, and it takes nearly twice as long. */
enum { PATIENCE = 8, KINDS = 64 * 64 };

/* A piece at an angle: the squares that it needs, with the gap round it. */
typedef struct mask {
  unsigned w, h;
  uint8_t *square; /* [h][w]: 1: covered, 2: in the gap */
  double low[2];   /* lower left corner of the turned piece */
  size_t covered;
} mask;

/* A run of squares that are needed, of row `row`: from <= x <= to. */
typedef struct run {
  uint16_t row, from, to;
} run;

typedef struct runs {
  run *at;
  size_t n;
  unsigned widest; /* the longest of them, squares, */
  unsigned row;    /* and where it is */
} runs;

/* A sheet, with a border of `gap` squares all round. */
typedef struct page {
  uint16_t *next;   /* [h][w + 1]: the first taken square from here on, or w */
  uint16_t *open;   /* [h]: the longest free run of each row */
  size_t left;      /* squares that are not taken */
  uint8_t *refused; /* [KINDS]: so many pieces of each, up to PATIENCE */
} page;

typedef struct nesting {
  const sg_nest_paper *paper;
  unsigned w, h; /* of a page */
  page *page;
  size_t pages, room;
  size_t first[KINDS]; /* pages before this one refuse all of the kind */
  uint64_t work;
  const sg_poll *poll;
  bool *memory;
} nesting;

static unsigned
squares(double length, double square)
{
  return (unsigned)floor(length / square + 1e-9);
}

bool
sg_nest_paper_is_valid(const sg_nest_paper *paper)
{
  double w = paper->width / paper->square + 2.0 * paper->gap;
  double h = paper->height / paper->square + 2.0 * paper->gap;

  return paper->square > 0.0 && w >= 1.0 && h >= 1.0 &&
         w <= MOST_SQUARES_A_SIDE && h <= MOST_SQUARES_A_SIDE &&
         w * h <= MOST_SQUARES;
}

/* ---- a piece at an angle ---- */

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
cover(mask *m, unsigned gap, double y, double x0, double x1)
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
cover_side(mask *m, unsigned gap, const double p[2], const double q[2])
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
cover_piece(mask *m, unsigned gap, const sg_nest_piece *piece,
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
widen_row(mask *m, unsigned gap, unsigned y)
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
widen_column(mask *m, unsigned gap, unsigned x)
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
widen(mask *m, unsigned gap)
{
  for (unsigned y = 0; y < m->h; y++) {
    widen_row(m, gap, y);
  }
  for (unsigned x = 0; x < m->w; x++) {
    widen_column(m, gap, x);
  }
}

/* False: no memory. A piece that is larger than a page has no squares. */
static bool
make_mask(nesting *n, const sg_nest_piece *piece, double degrees, mask *m)
{
  unsigned gap = n->paper->gap;
  double high[2], square = n->paper->square;
  double(*at)[2] = turned_points(piece, degrees, square, m->low, high);

  m->square = NULL;
  if (!at) {
    return false;
  }
  double w = floor((high[0] - m->low[0]) / square + 1e-6) + 1.0;
  double h = floor((high[1] - m->low[1]) / square + 1e-6) + 1.0;
  bool ok = true;

  if (w + 2.0 * gap <= n->w && h + 2.0 * gap <= n->h) {
    m->w = (unsigned)w + 2 * gap;
    m->h = (unsigned)h + 2 * gap;
    m->square = calloc((size_t)m->w * m->h, 1);
    n->work += (uint64_t)m->w * m->h;
    ok = m->square && cover_piece(m, gap, piece, (const double(*)[2])at);
    if (ok) {
      widen(m, gap);
    }
  }
  free(at);
  return ok;
}

static void
find_widest(runs *r)
{
  for (size_t i = 0; i < r->n; i++) {
    unsigned wide = r->at[i].to - r->at[i].from + 1u;

    if (wide > r->widest) {
      r->widest = wide;
      r->row = r->at[i].row;
    }
  }
}

/* The runs of a mask that are not 0, row by row; those that are 1, if only
 * `covered`. */
static bool
mask_runs(mask *m, bool covered, runs *out)
{
  size_t room = 0;

  *out = (runs){NULL, 0, 0, 0};
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
      if (out->n == room) {
        room = room ? 2 * room : 64;
        run *more = realloc(out->at, room * sizeof *more);

        if (!more) {
          return false;
        }
        out->at = more;
      }
      out->at[out->n++] = (run){(uint16_t)y, (uint16_t)x, (uint16_t)x};
    }
  }
  find_widest(out);
  return true;
}

/* ---- a page ---- */

static bool
add_page(nesting *n)
{
  size_t wide = (size_t)n->w + 1;

  if (n->pages == n->room) {
    size_t room = n->room ? 2 * n->room : 4;
    page *more = realloc(n->page, room * sizeof *more);

    if (!more) {
      return false;
    }
    n->page = more;
    n->room = room;
  }
  page *p = &n->page[n->pages];

  n->work += wide * n->h;
  p->next = malloc(wide * n->h * sizeof *p->next);
  p->open = malloc(n->h * sizeof *p->open);
  p->refused = calloc(KINDS, 1);
  p->left = (size_t)n->w * n->h;
  n->pages++;
  if (!p->next || !p->open || !p->refused) {
    return false;
  }
  for (unsigned y = 0; y < n->h; y++) {
    p->open[y] = (uint16_t)n->w;
  }
  for (size_t i = 0; i < wide * n->h; i++) {
    p->next[i] = (uint16_t)n->w;
  }
  return true;
}

/* How far right the runs have to go, at least, to be free in column x, row y:
 * 0, if they are. The run *first, which was in the way before, is asked first,
 * and becomes the one that is now. */
static unsigned
hindrance(nesting *n, const page *p, const runs *r, unsigned x, unsigned y,
          size_t *first)
{
  size_t wide = (size_t)n->w + 1, i = *first;

  for (size_t left = r->n; left > 0; left--) {
    const run *one = &r->at[i];
    unsigned taken = p->next[(y + one->row) * wide + x + one->from];

    n->work++;
    if (taken <= x + one->to && taken < n->w) {
      *first = i;
      return taken - one->from + 1 - x;
    }
    i = i + 1 < r->n ? i + 1 : 0;
  }
  return 0;
}

/* The lowest, then leftmost, place where the runs are free and reach up less
 * than `top` rows. False also when stopped: *n->memory is true then. */
static bool
find_place(nesting *n, const page *p, const mask *m, const runs *r,
           unsigned top, unsigned *x_out, unsigned *y_out)
{
  size_t first = 0;

  for (unsigned y = 0; y + m->h <= n->h && y + m->h < top; y++) {
    if (sg_poll_stop(n->poll)) {
      *n->memory = true;
      return false;
    }
    if (p->open[y + r->row] < r->widest) {
      continue;
    }
    for (unsigned x = 0; x + m->w <= n->w;) {
      unsigned step = hindrance(n, p, r, x, y, &first);

      if (step == 0) {
        *x_out = x;
        *y_out = y;
        return true;
      }
      x += step;
    }
  }
  return false;
}

static void
measure_open(const nesting *n, page *p, unsigned y)
{
  const uint16_t *next = p->next + (size_t)y * (n->w + 1u);
  unsigned longest = 0;

  for (unsigned x = 0; x < n->w; x = next[x] + 1u) {
    unsigned free_run = next[x] - x;

    longest = free_run > longest ? free_run : longest;
  }
  p->open[y] = (uint16_t)longest;
}

static void
take_squares(nesting *n, page *p, const runs *r, unsigned x, unsigned y)
{
  size_t wide = (size_t)n->w + 1;

  for (size_t i = 0; i < r->n; i++) {
    uint16_t *next = p->next + (size_t)(y + r->at[i].row) * wide;
    unsigned from = x + r->at[i].from, to = x + r->at[i].to;

    for (unsigned k = from; k <= to; k++) {
      p->left -= next[k] != k;
      next[k] = (uint16_t)k;
    }
    for (unsigned k = from; k > 0 && next[k - 1] > from; k--) {
      next[k - 1] = (uint16_t)from;
    }
  }
  for (size_t i = 0; i < r->n; i++) {
    if (i == 0 || r->at[i].row != r->at[i - 1].row) {
      measure_open(n, p, y + r->at[i].row);
    }
  }
}

/* ---- pieces one by one ---- */

/* Where a piece goes on a page: at which angle, and how high it reaches. */
typedef struct choice {
  size_t angle;
  unsigned x, y, top;
} choice;

static void
clear_masks(mask *m, runs *r, size_t n)
{
  for (size_t i = 0; i < n; i++) {
    free(m[i].square);
    free(r[i].at);
  }
  free(m);
  free(r);
}

/* The highest bit of a number that is not 0, and `more` of those below it. */
static unsigned
magnitude(size_t number, unsigned more)
{
  unsigned bit = 0;

  while (number >> bit > 1) {
    bit++;
  }
  return (bit << more) +
         (unsigned)((number << more >> bit) & ((1u << more) - 1));
}

/* Pieces of one kind are about as long, and about as large: to a fifth of
 * their length, and two fifths of their area. Less than KINDS. */
static size_t
kind_of(const mask *m, size_t angles)
{
  while (angles > 1 && !m->square) {
    m++;
    angles--;
  }
  return 64 * magnitude(m->w > m->h ? m->w : m->h, 2) +
         magnitude(m->covered, 1);
}

static bool
has_refused(const nesting *n, size_t at, size_t kind)
{
  return !n->paper->one && n->page[at].refused[kind] >= PATIENCE;
}

static void
note_refusal(nesting *n, size_t at, size_t kind)
{
  uint8_t *refused = &n->page[at].refused[kind];

  *refused = (uint8_t)(*refused + (*refused < PATIENCE));
  while (n->first[kind] < n->pages && has_refused(n, n->first[kind], kind)) {
    n->first[kind]++;
  }
}

static bool
best_choice(nesting *n, const page *p, const mask *m, const runs *r,
            size_t angles, choice *best)
{
  unsigned x, y;

  best->top = UINT32_MAX;
  for (size_t i = 0; i < angles; i++) {
    if (m[i].square && m[i].covered <= p->left &&
        find_place(n, p, &m[i], &r[i], best->top, &x, &y)) {
      *best = (choice){i, x, y, y + m[i].h};
    }
  }
  return best->top < UINT32_MAX;
}

static bool
settle(nesting *n, page *p, const sg_nest_piece *piece, mask *m,
       const choice *best, sg_nest_place *place)
{
  runs covered;
  double square = n->paper->square;
  bool ok = mask_runs(&m[best->angle], true, &covered);

  if (ok) {
    take_squares(n, p, &covered, best->x, best->y);
    place->sheet = (uint32_t)(p - n->page) + 1;
    place->degrees = piece->degrees[best->angle];
    place->by[0] = best->x * square - m[best->angle].low[0];
    place->by[1] = best->y * square - m[best->angle].low[1];
  }
  free(covered.at);
  return ok;
}

static bool
place_masks(nesting *n, const sg_nest_piece *piece, mask *m, runs *r,
            sg_nest_place *place)
{
  bool fits = false;
  choice best;

  for (size_t i = 0; i < piece->angles; i++) {
    if (!make_mask(n, piece, piece->degrees[i], &m[i]) ||
        (m[i].square && !mask_runs(&m[i], false, &r[i]))) {
      return false;
    }
    fits = fits || m[i].square;
  }
  size_t kind = fits ? kind_of(m, piece->angles) : 0;

  for (size_t i = n->first[kind]; fits; i++) {
    if (sg_poll_stop(n->poll)) {
      *n->memory = true;
      return false;
    }
    if (i == n->pages && ((n->paper->one && i > 0) || !add_page(n))) {
      return n->paper->one && i > 0;
    }
    if (has_refused(n, i, kind)) {
      continue;
    }
    bool found = best_choice(n, &n->page[i], m, r, piece->angles, &best);
    if (*n->memory) {
      return false;
    }
    if (found) {
      return settle(n, &n->page[i], piece, m, &best, place);
    }
    note_refusal(n, i, kind);
  }
  return true;
}

static bool
place_piece(nesting *n, const sg_nest_piece *piece, sg_nest_place *place)
{
  mask *m = calloc(piece->angles + 1, sizeof *m);
  runs *r = calloc(piece->angles + 1, sizeof *r);
  bool ok = m && r;

  *place = (sg_nest_place){0, 0.0, {0.0, 0.0}};
  ok = ok && place_masks(n, piece, m, r, place);
  clear_masks(m, r, m && r ? piece->angles : 0);
  return ok;
}

bool
sg_nest(const sg_nest_paper *paper, const sg_nest_piece *piece, size_t n,
        sg_nest_place *place, uint64_t *work, const sg_poll *poll, bool *memory)
{
  nesting all = {.paper = paper, .poll = poll, .memory = memory};
  bool ok = true;

  *memory = false;
  all.w = squares(paper->width, paper->square) + 2 * paper->gap;
  all.h = squares(paper->height, paper->square) + 2 * paper->gap;
  for (size_t i = 0; i < n && ok; i++) {
    ok = place_piece(&all, &piece[i], &place[i]);
  }
  for (size_t i = 0; i < all.pages; i++) {
    free(all.page[i].next);
    free(all.page[i].open);
    free(all.page[i].refused);
  }
  free(all.page);
  if (work) {
    *work += all.work;
  }
  *memory = ok || *memory;
  return ok;
}
